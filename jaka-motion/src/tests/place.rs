//! A place compared with limits.

use crate::{Checker, Frames, Limits, Model};

/// A place is not a motion that leads back from where it starts.
#[test]
fn a_place_beyond_a_joints_range_is_refused() {
    let checker = Checker::new(Limits::of(&Model::default()), Frames::new());
    let at = |joint_3: f64| checker.check_place([0.0, 90.0, joint_3, 90.0, -90.0, 0.0].into());
    assert!(at(175.0).is_ok() && at(-175.0).is_ok());
    for (joint_3, text) in [
        (175.1, "joint 3 would be at 175.1 deg; limit 175 (Zu 5)"),
        (-180.0, "joint 3 would be at -180 deg; limit -175 (Zu 5)"),
    ] {
        assert_eq!(at(joint_3).map_err(|beyond| beyond.to_string()), Err(text.to_owned()));
    }
}

//! Places at rest.

use jaka_proto::messages::types::Pose;

use super::{ELBOW_UP, bare, refused, with_region, zu5};
use crate::{Checker, Frames, Limits, Model, Point, Region, RegionFrame};

#[test]
fn joints_beyond_their_ranges_are_refused() {
    let checker = bare(zu5());
    assert_eq!(checker.check_place(ELBOW_UP.into()), Ok(()));
    assert_eq!(checker.check_place([360.0, 265.0, 175.0, 265.0, 360.0, -360.0].into()), Ok(()));
    refused(
        &checker.check_place([0.0, 0.0, -175.004, 0.0, 0.0, 0.0].into()),
        "joint 3 would be at -175.004 deg; limit -175 (Zu 5)",
    );
    // The error is for the joint that is furthest beyond.
    refused(
        &checker.check_place([0.0, -90.0, 181.25, 0.0, 0.0, 361.0].into()),
        "joint 3 would be at 181.3 deg; limit 175 (Zu 5)",
    );
}

/// The border is a little on this side of each point, or on the other, in each frame.
#[test]
fn each_point_is_compared_where_the_region_is_seen_from() {
    let model = Model::default();
    let tool = Pose::from_millimetres_degrees([30.0, -40.0, 120.0], [10.0, 20.0, 30.0]);
    let user = Pose::from_millimetres_degrees([200.0, 300.0, -50.0], [0.0, 0.0, 90.0]);
    let mounting = Pose::from_millimetres_degrees([0.0, 0.0, 2500.0], [180.0, 0.0, 0.0]);
    let frames = Frames::new().with_tool(tool).with_user_frame(user).with_mounting(mounting);
    let joint_frames = model.joint_frames(ELBOW_UP);
    for (point, name, at) in [
        (Point::Tcp, "tool centre point", joint_frames[5] * frames.tool()),
        (Point::Elbow, "elbow", joint_frames[2]),
        (Point::Wrist, "wrist", joint_frames[4]),
    ] {
        for (frame, seen) in [(RegionFrame::ArmBase, at), (RegionFrame::User, frames.base() * at)] {
            let [x, y, z] = seen.position_mm();
            for (by, allowed) in [(0.5, true), (-2.0, false)] {
                let regions = [
                    Region::half_space("table", [0.0, 0.0, z - by], [0.0, 0.0, 1.0]),
                    Region::inside_box("table", [x - 9.0, y - by, z - 9.0], [x + 9.0, y + 9.0, z + 9.0]),
                    Region::outside_box("table", [x + by, y - 9.0, z - 9.0], [x + 18.0, y + 9.0, z + 9.0]),
                ];
                for region in regions {
                    let region = region.expect("a region").of(point).seen_from(frame);
                    let limits = zu5().with_region(region).expect("the only one");
                    let found = Checker::new(limits, frames).check_place(ELBOW_UP.into());
                    if allowed {
                        assert_eq!(found, Ok(()));
                    } else {
                        refused(&found, &format!("the {name} would be 2 mm beyond `table` (Zu 5)"));
                    }
                }
            }
        }
    }
}

#[test]
fn a_singular_place_is_allowed() {
    assert_eq!(bare(zu5()).check_place([0.0; 6].into()), Ok(()));
}

#[test]
fn a_name_cannot_spoil_the_message() {
    let checker = bare(with_region(Region::half_space("a\n\u{1b}[2J", [0.0, 0.0, 5000.0], [0.0, 0.0, 1.0])));
    let words = checker.check_place(ELBOW_UP.into()).unwrap_err().to_string();
    assert!(!words.contains(char::is_control), "{words:?}");
}

/// A place is not a motion that returns from its start.
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

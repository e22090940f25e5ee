//! Arcs.

use super::{ELBOW_UP, SLOW, bare, moved, refused, with_region, zu5};
use crate::{Exceeded, Model, Region};

/// Returns poses on a circle to the right of the start, with angles from the start.
fn on_circle(radius: f64, deg: f64) -> jaka_proto::messages::types::Pose {
    let angle = deg.to_radians();
    moved(ELBOW_UP, [radius * (angle.cos() - 1.0), radius * angle.sin(), 0.0])
}

#[test]
fn the_joints_at_the_end_reach_the_pose() {
    let checker = bare(zu5());
    for end in [90.0, 180.0, 359.0] {
        let found = checker.check_arc(ELBOW_UP.into(), on_circle(80.0, 0.5 * end), on_circle(80.0, end), SLOW);
        let joints = found.expect("within all limits");
        assert!(Model::default().forward(joints).distance_mm(&on_circle(80.0, end).into()) < 1e-6);
    }
}

/// The ends are within, the arc is not.
#[test]
fn what_the_arc_passes_is_checked() {
    let y = on_circle(80.0, 90.0).y;
    let wall = Region::half_space("wall", [0.0, y - 5.0, 0.0], [0.0, -1.0, 0.0]);
    let checker = bare(with_region(wall));
    let arc = |mid: f64, end: f64| checker.check_arc(ELBOW_UP.into(), on_circle(80.0, mid), on_circle(80.0, end), SLOW);
    assert!(arc(20.0, 60.0).is_ok());
    let found = arc(20.0, 160.0).unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::Region { .. }) && found.share > 0.35 && found.share < 0.6, "{found}");
    // The arc in the opposite direction is allowed.
    assert!(arc(-100.0, -200.0).is_ok());
    let plate = Region::outside_box("plate", [-2e3, y - 40.0, -2e3], [2e3, y - 39.0, 2e3]);
    let checker = bare(with_region(plate));
    let found = checker.check_arc(ELBOW_UP.into(), on_circle(80.0, 175.0), on_circle(80.0, 350.0), SLOW).unwrap_err();
    assert!(found.to_string().contains("beyond `plate` at 9 % of its path"), "{found}");
}

#[test]
fn three_poses_on_a_line_are_no_arc() {
    let checker = bare(zu5());
    let words = "the positions of the three poses lie on a line: there is no arc (Zu 5)";
    let [here, near, far] = [0.0, 10.0, 50.0].map(|x: f64| moved(ELBOW_UP, [-x, 0.0, 0.0]));
    for (mid, end) in [(near, far), (near, here), (here, here), (near, near), (far, near)] {
        refused(&checker.check_arc(ELBOW_UP.into(), mid, end, SLOW), words);
    }
}

/// The arm is nearly stretched from the start, and stays so while joint 1 turns it.
#[test]
fn an_arc_that_stays_as_near_to_a_singularity_as_it_starts_is_allowed() {
    let at = |first: f64| [first, 40.0, -0.3, 130.0, -90.0, 5.0];
    let pose = |first: f64| Model::default().forward(at(first)).into();
    for turn in [2.0, 45.0, 170.0] {
        let found = bare(zu5()).check_arc(at(0.0).into(), pose(0.5 * turn), pose(turn), SLOW);
        let end = found.unwrap_or_else(|beyond| panic!("{beyond}"));
        assert!(end.max_distance(&at(turn).into()) < 1e-3, "{end:?}");
    }
}

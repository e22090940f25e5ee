//! A pose whose parts are known by heart, to and from each type.

use super::{assert_near, turned};
use crate::geometry::{NotARotation, Quaternion};
use crate::messages::types::Pose;

const POSITION: mint::Point3<f64> = mint::Point3 { x: 100.0, y: -200.0, z: 300.0 };

/// x goes to y, y to z, z to x: a third of a turn about the diagonal.
fn pose() -> Pose {
    Pose::from([100.0, -200.0, 300.0, 90.0, 0.0, 90.0])
}

#[test]
fn positions_are_millimetres() {
    assert_eq!(mint::Point3::from(pose()), POSITION);
    assert_eq!(mint::Vector3::from(pose()), POSITION.into());
}

#[test]
fn quaternion() {
    let mint::Quaternion { s, v } = mint::Quaternion::from(pose());
    assert!((s - 0.5).abs() < 1e-15);
    assert_near(v.into(), [0.5; 3]);
    // The scalar last, as mint has it.
    let unlike = mint::Quaternion::from([1.0, 2.0, 3.0, 4.0]);
    assert_eq!(Quaternion::from(unlike), Quaternion { w: 4.0, x: 1.0, y: 2.0, z: 3.0 });
    assert_eq!(mint::Quaternion::from(Quaternion::from(unlike)), unlike);

    let back = Pose::try_from((POSITION, mint::Quaternion { s, v })).expect("a unit quaternion");
    assert_near(back.position_mm(), pose().position_mm());
    assert_near(back.rotation_deg(), pose().rotation_deg());
    assert_eq!(Pose::try_from((POSITION, unlike)), Err(NotARotation::Quaternion));
    assert_eq!(turned([0.0; 3]).with_quaternion(unlike), Err(NotARotation::Quaternion));
}

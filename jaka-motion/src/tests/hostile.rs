//! Targets out of reach, and invalid inputs.

use super::{from_pose, to_pose};
use crate::closed_form::Wrist;
use crate::{Model, NoSolution};

const ODD: [f64; 10] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, f64::MAX, f64::MIN_POSITIVE, -0.0, 1e9, 360.0];

#[test]
fn too_far_is_out_of_reach() {
    for model in Model::published() {
        for x in [1e3 * 2.5, 1e4, -1e5] {
            let found = model.inverse(from_pose([x, 0.0, 300.0, 180.0, 0.0, 0.0]), [0.0; 6]);
            assert!(
                matches!(found, Err(NoSolution::OutOfReach { by_mm }) if by_mm > 0.0),
                "{}: {found:?}",
                model.name()
            );
        }
    }
}

/// The wrist cannot come nearer to the base axis than its distance from the arm's plane, except on the A12.
#[test]
fn too_near_the_base_axis_is_out_of_reach() {
    for model in Model::published().iter().filter(|model| model.closed_form.wrist != Wrist::Offset) {
        let nearer = 0.9
            * (model.d()[1]
                + model.d()[2]
                + if model.closed_form.wrist == Wrist::Parallel { model.d()[3] } else { 0.0 })
            .abs();
        for z in [0.0, 200.0, 400.0] {
            let target = from_pose([nearer, 0.0, z, 180.0, 0.0, 0.0]);
            let found = model.inverse(target, [0.0; 6]);
            assert!(matches!(found, Err(NoSolution::OutOfReach { .. })), "{}: {found:?}", model.name());
        }
    }
}

/// The wrist's centre is beside the shoulder, beyond the lengths of upper arm and forearm by some mm.
#[test]
fn out_of_reach_says_by_how_much() {
    let arm = Model::named("MiniCobo").expect("published");
    let (height, aside, flange) = (arm.d()[0], arm.d()[1], arm.d()[5]);
    for by in [0.01, 1.0, 43.0, 150.0, 2e3, 5e4] {
        let away = (arm.a()[2] + arm.d()[3] + by).hypot(aside);
        let found = arm.inverse(from_pose([away, 0.0, height - flange, 180.0, 0.0, 0.0]), [0.0; 6]);
        assert!(matches!(found, Err(NoSolution::OutOfReach { by_mm }) if (by_mm - by).abs() < 1e-6), "{by} {found:?}");
    }
}

/// Every solution for this pose has joint 5 beyond its 120 degrees.
#[test]
fn a_pose_that_needs_a_joint_beyond_its_limit_is_refused() {
    let arm = Model::named("MiniCobo").expect("published");
    let beyond = [96.0, 66.0, -3.0, -35.0, 175.0, 314.0];
    assert!(!arm.is_within_range(beyond));
    let found = arm.inverse(arm.forward(beyond), beyond);
    assert!(matches!(found, Err(NoSolution::BeyondRange { joint: 5, limit_deg: 120.0, .. })), "{found:?}");
}

#[test]
fn odd_numbers_anywhere_give_none_or_a_true_solution() {
    for model in Model::published() {
        let joints = [10.0, 60.0, 80.0, 30.0, -90.0, 5.0];
        let pose = to_pose(model.forward(joints));
        for odd in ODD {
            for index in 0..6 {
                let (mut pose, mut reference) = (pose, joints);
                pose[index] = odd;
                check(model, pose, joints);
                pose = to_pose(model.forward(joints));
                reference[index] = odd;
                check(model, pose, reference);
                check(model, to_pose(model.forward(reference)), joints);
            }
            check(model, [odd; 6], [odd; 6]);
        }
    }
}

fn check(model: &Model, pose: [f64; 6], reference: [f64; 6]) {
    let Ok(found) = model.inverse(from_pose(pose), reference) else { return };
    assert!(model.is_within_range(found), "{found:?}");
    let (moved, turned) = super::apart(&model.forward(found), &from_pose(pose));
    assert!(moved < 0.01 && turned < 0.01, "{pose:?} {found:?}");
}

#[test]
fn a_finite_reference_however_large_still_solves() {
    let arm = Model::default();
    let target = arm.forward([10.0, 60.0, 80.0, 30.0, -90.0, 5.0]);
    assert!(arm.inverse(target, [1e300; 6]).is_ok());
    assert_eq!(arm.inverse(target, [f64::NAN; 6]), Err(NoSolution::NotFinite));
}

#[test]
fn names_are_found_however_they_are_spelt() {
    for name in ["Zu 5", "zu5", "JAKA Zu5", "jaka_zu5", "ZU-5"] {
        assert_eq!(Model::named(name), Some(&Model::default()), "{name}");
    }
    assert_eq!(Model::named("Zu 6"), None);
    for model in Model::published() {
        assert_eq!(Model::named(model.name()), Some(model));
    }
}

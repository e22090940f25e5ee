//! Inverse of poses of random joints of every model.

use super::{Random, apart, assert_close, from_pose, to_pose};
use crate::Model;
use crate::closed_form::Wrist;
use crate::newton::USUAL;

const POSES: usize = 10_000;
/// Tolerance that is looser than the sum of rounding, and tighter than required.
const CLOSE: (f64, f64) = (0.001, 0.0001);

/// Whether two solutions meet at these joints, so that rounding decides which one is nearest.
fn singular(model: &Model, joints: &[f64; 6]) -> bool {
    if model.closed_form.wrist == Wrist::Offset {
        return model.singularity_distance(*joints).wrist < 0.05;
    }
    let parallel = model.closed_form.wrist == Wrist::Parallel;
    let bars = if parallel { joints[2] } else { joints[2] + model.joint_home_offset()[2] + 90.0 };
    let aside = (model.d()[1] + model.d()[2] + if parallel { model.d()[3] } else { 0.0 }).abs();
    let flange = model.forward(*joints);
    let wrist = flange.0 * nalgebra::Point3::new(0.0, 0.0, -model.d()[5]);
    let flat = |degrees: f64| degrees.to_radians().sin().abs() < 0.05;
    flat(joints[4]) || flat(bars) || wrist.x.hypot(wrist.y) < 1.05 * aside + 5.0
}

#[test]
fn a_close_reference_gives_the_joints_back() {
    for (seed, model) in (1..).zip(Model::published()) {
        let (mut random, mut tried) = (Random::new(seed), 0);
        while tried < POSES {
            let joints = random.joints(model);
            if singular(model, &joints) {
                continue;
            }
            tried += 1;
            let reference = joints.map(|joint| joint + random.between(-0.5, 0.5));
            // The target goes through the pose's numbers, as for a client.
            let target = from_pose(to_pose(model.forward(joints)));
            let found = model
                .inverse(target, reference)
                .unwrap_or_else(|error| panic!("{} {joints:?}: {error}", model.name()))
                .0;
            assert_close(&model.forward(found), &target, CLOSE, model.name());
            let same = found.iter().zip(joints).all(|(found, joint)| (found - joint).abs() < 0.01);
            assert!(same, "{} {joints:?} {found:?}", model.name());
        }
    }
}

#[test]
fn a_far_reference_gives_a_solution_too() {
    for (seed, model) in (101..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..POSES / 5 {
            let (joints, reference) = (random.joints(model), random.joints(model));
            let target = model.forward(joints);
            let found = model
                .inverse(target, reference)
                .unwrap_or_else(|error| panic!("{} {joints:?}: {error}", model.name()))
                .0;
            assert_close(&model.forward(found), &target, CLOSE, model.name());
            assert!(model.is_within_range(found), "{} {found:?}", model.name());
        }
    }
}

/// The joints of the pose are one solution, so no result may be further from the reference.
#[test]
fn nothing_nearer_to_the_reference_is_missed() {
    let distance = |one: &[f64; 6], other: &[f64; 6]| one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    for (seed, model) in (201..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..1_000 {
            let (joints, reference) = (random.joints(model), random.joints(model));
            let found = model.inverse(model.forward(joints), reference).expect("reachable").0;
            assert!(
                distance(&found, &reference) <= distance(&joints, &reference) + 1e-3,
                "{} {joints:?}",
                model.name()
            );
        }
    }
}

/// With a singular wrist the free joint keeps its position, at every multiple of a half turn and near it.
#[test]
fn a_singular_wrist_keeps_the_reference() {
    for (seed, model) in (301..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for sine in [0.0, 1e-12, 1e-9, 5e-8, 1.1e-7, 1e-6, 1e-4] {
            for round in 0..200 {
                let mut joints = random.joints(model);
                let half_turn = if round % 2 == 1 && model.joint_max()[4] > 180.0 { 180.0 } else { 0.0 };
                joints[4] = half_turn + f64::to_degrees(sine);
                let target = model.forward(joints);
                let found = model
                    .inverse(target, joints)
                    .unwrap_or_else(|error| panic!("{} {joints:?}: {error}", model.name()))
                    .0;
                assert_close(&model.forward(found), &target, CLOSE, model.name());
                let free = if model.closed_form.wrist == Wrist::Parallel { 5 } else { 3 };
                assert!(
                    sine > 1e-8 || (found[free] - joints[free]).abs() < 0.01,
                    "{} {joints:?} {found:?}",
                    model.name()
                );
            }
        }
    }
}

#[test]
fn a_stretched_or_upright_arm_solves() {
    for model in Model::published() {
        for joints in [
            [0.0; 6],
            [0.0, 90.0, 0.0, 90.0, 0.0, 0.0],
            [180.0, 90.0, 0.0, 0.0, 90.0, -180.0],
            [0.0, 0.0, 90.0, 0.0, 0.0, 360.0],
        ] {
            let target = model.forward(joints);
            let found =
                model.inverse(target, joints).unwrap_or_else(|error| panic!("{} {joints:?}: {error}", model.name())).0;
            assert_close(&model.forward(found), &target, (0.01, 0.01), model.name());
        }
    }
}

#[test]
fn turns_follow_the_reference() {
    let arm = Model::default();
    for turn in [-360.0, 0.0, 360.0] {
        let joints = [f64::midpoint(turn, 0.0), 60.0, 80.0, 30.0, -90.0, turn];
        let found = arm.inverse(arm.forward(joints), joints).expect("reachable").0;
        assert!(found.iter().zip(joints).all(|(found, joint)| (found - joint).abs() < 0.001), "{joints:?} {found:?}");
    }
}

#[test]
fn joints_at_their_limits_solve() {
    for (seed, model) in (401..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..500 {
            let mut joints = random.joints(model);
            for (joint, (min, max)) in joints.iter_mut().zip(model.joint_min().iter().zip(model.joint_max())) {
                match random.between(-1.0, 1.0) {
                    ..-0.3 => *joint = *min,
                    0.3.. => *joint = *max,
                    _ => {}
                }
            }
            let target = model.forward(joints);
            let found =
                model.inverse(target, joints).unwrap_or_else(|error| panic!("{} {joints:?}: {error}", model.name())).0;
            assert_close(&model.forward(found), &target, CLOSE, model.name());
            assert!(model.is_within_range(found), "{} {found:?}", model.name());
        }
    }
}

/// Every branch brings the flange to the pose and is found from a reference near it; the joints of the pose are one of
/// them.
#[test]
fn the_inverse_returns_each_branch() {
    for (seed, model) in (1001..).zip(Model::published()) {
        let (mut random, mut most) = (Random::new(seed), 0);
        for _ in 0..500 {
            let joints = random.joints(model);
            if singular(model, &joints) {
                continue;
            }
            let target = model.forward(joints);
            let branches = model.inverse_all(target, joints).expect("reachable");
            assert!(branches[0].max_distance(&joints.into()) < 1e-6, "{} {joints:?} {branches:?}", model.name());
            for branch in branches.iter() {
                assert_close(&model.forward(*branch), &target, CLOSE, model.name());
                let found = model.inverse(target, *branch).expect("reachable");
                assert!(found.max_distance(branch) < 1e-6, "{} {joints:?} {branches:?}", model.name());
            }
            most = most.max(branches.len());
        }
        let expected = if model.closed_form.wrist == Wrist::Offset { 12..=16 } else { 8..=8 };
        assert!(expected.contains(&most), "{}: {most}", model.name());
    }
}

#[test]
fn a_step_takes_off_a_small_error() {
    for model in Model::published() {
        let joints = [10.0, 60.0, 80.0, 30.0, -90.0, 5.0];
        let target = model.forward(joints);
        let polished =
            model.links.newton(&joints.map(|joint| joint + 1e-4), &target.0, USUAL.damping).expect("not singular");
        assert!(apart(&model.forward(polished), &target).0 < 1e-5, "{}", model.name());
        assert!(
            polished.iter().zip(joints).all(|(polished, joint)| (polished - joint).abs() < 1e-5),
            "{}",
            model.name()
        );
    }
}

/// A joint that does not move the flange keeps its position, even if every joint is singular at once.
#[test]
fn a_step_does_not_run_away() {
    let mut random = Random::new(17);
    for model in Model::published() {
        for joints in [[0.0; 6], [0.0, 90.0, 0.0, 90.0, 0.0, 0.0], [0.0, 0.0, 90.0, 0.0, 0.0, 360.0]] {
            let off = joints.map(|joint| joint + random.between(-1e-9, 1e-9));
            let polished =
                model.links.newton(&off, &model.forward(joints).0, USUAL.damping).expect("damping keeps it solvable");
            assert!(
                polished.iter().zip(joints).all(|(polished, joint)| (polished - joint).abs() < 1e-6),
                "{}",
                model.name()
            );
        }
    }
}

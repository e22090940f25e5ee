//! The Jacobian against differences of poses, and the distances from singularities against the Jacobian.

use nalgebra::Matrix6;

use super::{Random, from_pose};
use crate::closed_form::Wrist;
use crate::{Model, Transform};

/// Difference of a joint, in degrees.
const STEP: f64 = 1e-3;

/// Returns the motion of the tool with one joint, in mm and degrees for a degree.
fn difference(model: &Model, joints: [f64; 6], joint: usize, tool: Transform) -> [f64; 6] {
    let at = |sign: f64| {
        let mut moved = joints;
        moved[joint] += sign * 0.5 * STEP;
        (model.forward(moved) * tool).0
    };
    let (before, after) = (at(-1.0), at(1.0));
    let moved = (after.translation.vector - before.translation.vector) / STEP;
    let turned = (after.rotation * before.rotation.inverse()).scaled_axis() / STEP;
    [moved.x, moved.y, moved.z, turned.x.to_degrees(), turned.y.to_degrees(), turned.z.to_degrees()]
}

/// Returns the arms with separate singularities of shoulder, elbow and wrist.
fn with_three_distances() -> impl Iterator<Item = &'static Model> {
    Model::published().iter().filter(|model| model.closed_form.wrist != Wrist::Offset)
}

#[test]
fn the_jacobian_is_how_the_tool_moves() {
    let tool = from_pose([30.0, -20.0, 150.0, 10.0, 20.0, 30.0]);
    for (seed, model) in (501..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..200 {
            let joints = random.joints(model);
            let jacobian = model.jacobian(joints, &tool);
            for joint in 0..6 {
                for (row, expected) in jacobian.iter().zip(difference(model, joints, joint, tool)) {
                    let found = row[joint];
                    assert!((found - expected).abs() < 1e-5, "{} {joints:?} {found} {expected}", model.name());
                }
            }
        }
    }
}

/// The Jacobian's determinant is the product of the three distances and of lengths. (On the A12 it is the distance.)
#[test]
fn the_distances_are_those_of_the_jacobian() {
    for (seed, model) in (601..).zip(with_three_distances()) {
        let mut random = Random::new(seed);
        let forearm = if model.name() == "MiniCobo" { model.d()[3] } else { model.a()[3] };
        for _ in 0..500 {
            let joints = random.joints(model);
            let rows = model.jacobian(joints, &Transform::identity());
            let mut jacobian = Matrix6::from_row_slice(rows.as_flattened());
            jacobian.fixed_rows_mut::<3>(0).scale_mut(1_f64.to_degrees() / model.reach_mm());
            let distance = model.singularity_distance(joints);
            let lengths = model.a()[2] * forearm / model.reach_mm().powi(2);
            let product = lengths * distance.shoulder * distance.elbow * distance.wrist;
            assert!((jacobian.determinant().abs() - product).abs() < 1e-9, "{} {joints:?}", model.name());
            let values = jacobian.singular_values();
            assert!((distance.smallest_singular_value - values.min()).abs() < 1e-9, "{} {joints:?}", model.name());
        }
    }
}

#[test]
fn each_singularity_is_told_apart() {
    let arm = Model::default();
    let elbow = arm.singularity_distance([10.0, 40.0, 0.0, 70.0, 80.0, 30.0]);
    assert!(elbow.elbow < 1e-12 && elbow.shoulder > 0.1 && elbow.wrist > 0.1, "{elbow:?}");
    let wrist = arm.singularity_distance([10.0, 40.0, 60.0, 70.0, 180.0, 30.0]);
    assert!(wrist.wrist < 1e-12 && wrist.shoulder > 0.1 && wrist.elbow > 0.1, "{wrist:?}");
    // Upper arm and forearm have different lengths, and lean so that the wrist is above the shoulder.
    let (upper, fore) = (arm.a()[2], arm.a()[3]);
    let second = 60_f64;
    let lean = (-upper * second.to_radians().cos() / fore).acos().to_degrees();
    let shoulder = arm.singularity_distance([10.0, second, lean - second, 90.0 - lean, 90.0, 0.0]);
    assert!(shoulder.elbow > 0.1 && shoulder.wrist > 0.1, "{shoulder:?}");
    let off_axis = arm.d()[4] * 90_f64.to_radians().sin() / arm.reach_mm();
    assert!((shoulder.shoulder - off_axis).abs() < 1e-9, "{shoulder:?}");
    for distance in [elbow, wrist] {
        assert!(distance.smallest_singular_value < 1e-9, "{distance:?}");
    }
}

#[test]
fn at_a_singularity_the_smallest_singular_value_is_zero() {
    for (seed, model) in (701..).zip(with_three_distances()) {
        let mut random = Random::new(seed);
        for _ in 0..100 {
            let mut joints = random.joints(model);
            joints[4] = 0.0;
            let distance = model.singularity_distance(joints);
            assert!(distance.wrist < 1e-9 && distance.smallest_singular_value < 1e-9, "{distance:?}");
        }
    }
}

#[test]
fn odd_joints_give_no_number() {
    for odd in [f64::NAN, f64::INFINITY] {
        let distance = Model::default().singularity_distance([0.0, odd, 0.0, 0.0, 0.0, 0.0]);
        assert!(distance.smallest_singular_value.is_nan(), "{distance:?}");
    }
}

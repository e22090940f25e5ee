//! Joint positions at which the arm loses a direction.

use super::Random;
use crate::Model;

#[test]
fn each_singularity_is_told_apart() {
    let arm = Model::default();
    let elbow = arm.singularity_distance([10.0, 40.0, 0.0, 70.0, 80.0, 30.0]);
    assert!(elbow.elbow < 1e-12 && elbow.shoulder > 0.1 && elbow.wrist > 0.1, "{elbow:?}");
    let wrist = arm.singularity_distance([10.0, 40.0, 60.0, 70.0, 180.0, 30.0]);
    assert!(wrist.wrist < 1e-12 && wrist.shoulder > 0.1 && wrist.elbow > 0.1, "{wrist:?}");
    // Upper arm and forearm of different lengths, leaning so that the wrist is above the shoulder.
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
    for (seed, model) in (701..).zip(Model::published()) {
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

//! The Newton step that removes the error of rounding.

use super::{Random, apart};
use crate::Model;
use crate::model::DAMPING;

#[test]
fn a_step_takes_off_a_small_error() {
    for model in Model::published() {
        let joints = [10.0, 60.0, 80.0, 30.0, -90.0, 5.0];
        let target = model.forward(joints);
        let polished = model.newton(&joints.map(|joint| joint + 1e-4), &target.0, DAMPING).expect("not singular");
        assert!(apart(&model.forward(polished), &target).0 < 1e-5, "{}", model.name());
        assert!(
            polished.iter().zip(joints).all(|(polished, joint)| (polished - joint).abs() < 1e-5),
            "{}",
            model.name()
        );
    }
}

/// A joint that does not move the flange stays, even where every joint is singular at once.
#[test]
fn a_step_does_not_run_away() {
    let mut random = Random::new(17);
    for model in Model::published() {
        for joints in [[0.0; 6], [0.0, 90.0, 0.0, 90.0, 0.0, 0.0], [0.0, 0.0, 90.0, 0.0, 0.0, 360.0]] {
            let off = joints.map(|joint| joint + random.between(-1e-9, 1e-9));
            let polished = model.newton(&off, &model.forward(joints).0, DAMPING).expect("damping keeps it solvable");
            assert!(
                polished.iter().zip(joints).all(|(polished, joint)| (polished - joint).abs() < 1e-6),
                "{}",
                model.name()
            );
        }
    }
}

//! Kinematics of a Zu 5.

use std::hint::black_box;

use jaka_motion::{Model, Transform};

use crate::limit::forward;
use crate::measure::{Contender, Target, Work};

/// Its lengths, as the work by hand takes them.
pub const LENGTHS: [f64; 6] = [120.15, 430.0, 368.5, 114.0, 113.5, 107.0];

/// Joint positions away from singularities.
pub const JOINTS: [f64; 6] = [10.0, 60.0, 80.0, 30.0, -75.0, 15.0];

/// Forward, inverse, Jacobian and distance from singularities, compared with forward kinematics written by hand.
///
/// # Panics
/// There is no Zu 5.
pub fn works() -> Vec<Work<'static>> {
    let arm = Model::named("Zu 5").expect("a published arm");
    let flange = arm.forward(JOINTS);
    let near = JOINTS.map(|joint| joint + 0.5);
    vec![Work {
        name: "kinematics of a Zu 5",
        contenders: vec![
            Contender::new("forward by hand", || forward::forward(&LENGTHS, black_box(&JOINTS))),
            Contender::new("forward", || arm.forward(black_box(JOINTS))),
            Contender::new("inverse", move || arm.inverse(black_box(flange), near)),
            Contender::new("inverse, all branches", move || arm.inverse_all(black_box(flange), near)),
            Contender::new("Jacobian", || arm.jacobian(black_box(JOINTS), &Transform::identity())),
            Contender::new("distance from singular", || arm.singularity_distance(black_box(JOINTS))),
        ],
        targets: vec![Target::AtMost("forward", 4.0, "forward by hand")],
    }]
}

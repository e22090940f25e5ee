//! Kinematics of a Zu 5, and its motions compared with limits.

use std::hint::black_box;

use jaka_motion::proto::messages::types::{JointPosition, Pose};
use jaka_motion::{Checker, Frames, JointSpeed, Limits, Model, Point, Region, TcpSpeed, Transform};

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
    vec![
        set_point_checks(),
        way_checks(),
        Work {
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
        },
    ]
}

/// The period of set-points, in seconds.
pub const PERIOD: f64 = 0.008;

/// Joint position at the start of the line of one metre, in degrees.
pub const BESIDE: [f64; 6] = [-55.0, 40.0, -70.0, 200.0, -90.0, 5.0];

/// Limits of every kind, with a region of each shape for each point.
///
/// # Panics
/// There is no Zu 5, or a limit makes no sense.
pub fn checker() -> Checker {
    let arm = Model::named("Zu 5").expect("a published arm");
    let mut limits = Limits::of(arm).with_tcp_speed(500.0).expect("a speed");
    for point in [Point::Tcp, Point::Elbow, Point::Wrist] {
        for region in [
            Region::inside_box(format!("cell, {point}"), [-1500.0; 3], [1500.0; 3]),
            Region::outside_box(format!("post, {point}"), [900.0; 3], [1000.0; 3]),
            Region::half_space(format!("table, {point}"), [0.0, 0.0, -100.0], [0.0, 0.0, 1.0]),
        ] {
            limits = limits.with_region(region.expect("a region").of(point)).expect("another name");
        }
    }
    Checker::new(limits, Frames::new())
}

/// The last two set-points, and the next.
pub fn set_points() -> [JointPosition; 3] {
    [0.0, 0.1, 0.2].map(|by| JOINTS.map(|joint| joint + by).into())
}

/// Joint position at the end of the joint motion from [`BESIDE`], in degrees.
pub const ACROSS: [f64; 6] = [35.0, 60.0, -90.0, 160.0, -70.0, 40.0];

/// A metre aside of [`BESIDE`].
///
/// # Panics
/// There is no Zu 5.
pub fn a_metre_aside() -> Pose {
    let arm = Model::named("Zu 5").expect("a published arm");
    let pose = Pose::from(arm.forward(BESIDE));
    Pose { y: pose.y + 1000.0, ..pose }
}

/// Speed of the line.
pub const PACE: TcpSpeed = TcpSpeed { speed_mm_s: 100.0, tolerance_mm: 0.0 };

/// Speed and acceleration of the joint motion.
pub const JOINT_PACE: JointSpeed = JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2: Some(60.0) };

fn set_point_checks() -> Work<'static> {
    let [before, last, next] = set_points();
    let pose = Pose::from(Model::default().forward(next));
    let [one, two] = [(); 2].map(|()| checker());
    Work {
        name: "set-points of a Zu 5 compared with limits",
        contenders: vec![
            Contender::new("forward and a box by hand", || {
                let flange = forward::forward(&LENGTHS, black_box(&JOINTS));
                flange.place.iter().all(|at| (-1500.0..=1500.0).contains(at))
            }),
            Contender::new("joints", move || one.check_set_point([before, last], black_box(next), PERIOD)),
            Contender::new("a pose", move || two.check_pose_set_point([before, last], black_box(pose), PERIOD)),
        ],
        targets: vec![Target::Within("joints", 20.0), Target::Within("a pose", 20.0)],
    }
}

fn way_checks() -> Work<'static> {
    let (to, [one, two]) = (a_metre_aside(), [(); 2].map(|()| checker()));
    Work {
        name: "ways of a Zu 5 compared with limits",
        contenders: vec![
            Contender::new("line of 1 m", move || one.check_line(BESIDE.into(), black_box(to), PACE)),
            Contender::new("joint way of 90 deg", move || {
                two.check_joint_way(black_box(BESIDE.into()), ACROSS.into(), JOINT_PACE)
            }),
        ],
        targets: vec![Target::Within("line of 1 m", 2000.0)],
    }
}

//! Motions compared with limits.

mod arcs;
mod dense;
mod hostile;
mod joint_ways;
mod lines;
mod places;
mod set_points;

use jaka_proto::messages::types::Pose;

use super::Random;
use crate::{Beyond, Checker, Frames, InvalidLimit, JointPace, Limits, Model, Region, TcpPace};

const PACE: JointPace = JointPace { speed_deg_s: 20.0, acceleration_deg_s2: Some(30.0) };
const SLOW: TcpPace = TcpPace { speed_mm_s: 50.0, acceleration_mm_s2: None, tolerance_mm: 0.0 };
/// Away from singularities.
const ELBOW_UP: [f64; 6] = [10.0, 60.0, -80.0, 190.0, -90.0, 5.0];

fn zu5() -> Limits {
    Limits::of(&Model::default())
}

fn with_region(region: Result<Region, InvalidLimit>) -> Limits {
    zu5().with_region(region.expect("a region")).expect("the only one")
}

/// Without tool, user frame and mounting.
fn bare(limits: Limits) -> Checker {
    Checker::new(limits, Frames::new())
}

/// Where the flange is, moved along the axes of the base.
fn moved(from: [f64; 6], [x, y, z]: [f64; 3]) -> Pose {
    let pose = Pose::from(Model::default().forward(from));
    Pose { x: pose.x + x, y: pose.y + y, z: pose.z + z, ..pose }
}

#[track_caller]
fn refused<T: std::fmt::Debug>(found: &Result<T, Beyond>, words: &str) {
    assert_eq!(found.as_ref().expect_err(words).to_string(), words);
}

/// Joint positions at which the arm is not near a singularity.
fn away_from_singularities(random: &mut Random, model: &Model) -> [f64; 6] {
    loop {
        let joints = random.joints(model);
        let distance = model.singularity_distance(joints);
        let far = joints.iter().any(|joint| joint.abs() > 250.0);
        if !far && distance.shoulder > 0.15 && distance.elbow.min(distance.wrist) > 0.3 {
            return joints;
        }
    }
}

/// Some tool, user frame and mounting.
fn some_frames(random: &mut Random) -> Frames {
    let mut pose = |most_mm: f64, most_deg: f64| -> Pose {
        let mm: [f64; 3] = std::array::from_fn(|_| random.between(-most_mm, most_mm));
        Pose::from_millimetres_degrees(mm, std::array::from_fn(|_| random.between(-most_deg, most_deg)))
    };
    Frames::new().with_tool(pose(200.0, 180.0)).with_user_frame(pose(500.0, 180.0)).with_mounting(pose(300.0, 180.0))
}

/// A region of any shape near a place in its frame, in mm, as often around it as aside of it.
fn some_region(random: &mut Random, name: &str, near: [f64; 3], most_mm: f64) -> Result<Region, InvalidLimit> {
    let aside: [f64; 3] = std::array::from_fn(|index| near[index] + random.between(-most_mm, most_mm));
    let sides: [f64; 3] = std::array::from_fn(|_| 0.5 * random.between(-1.0, 1.0).powi(4).mul_add(most_mm, 1.001));
    let corner = |sign: f64| std::array::from_fn(|index| aside[index] + sign * sides[index]);
    let wide = |sign: f64| std::array::from_fn(|index| near[index] + sign * (2.0 * sides[index] + 0.3 * most_mm));
    let direction: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
    match random.between(0.0, 3.0) {
        ..1.0 => Region::half_space(name, aside, direction),
        ..1.5 => Region::inside_box(name, wide(-1.0), wide(1.0)),
        _ => Region::outside_box(name, corner(-1.0), corner(1.0)),
    }
}

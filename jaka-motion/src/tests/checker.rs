//! Checks of motions against limits.

mod arcs;
mod hostile;
mod joint_ways;
mod lines;
mod places;
mod rounding;
mod set_points;

use jaka_proto::messages::types::Pose;

use super::Random;
use crate::{Beyond, Checker, Frames, InvalidLimit, JointSpeed, Limits, Model, Region, TcpSpeed};

const PACE: JointSpeed = JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2: Some(30.0) };
const SLOW: TcpSpeed = TcpSpeed { speed_mm_s: 50.0, tolerance_mm: 0.0 };
/// Joint positions away from singularities.
const ELBOW_UP: [f64; 6] = [10.0, 60.0, -80.0, 190.0, -90.0, 5.0];

fn zu5() -> Limits {
    Limits::of(&Model::default())
}

fn with_region(region: Result<Region, InvalidLimit>) -> Limits {
    zu5().with_region(region.expect("a region")).expect("the only one")
}

/// Returns a checker without tool, user frame and mounting.
fn bare(limits: Limits) -> Checker {
    Checker::new(limits, Frames::new())
}

/// Returns the pose of the flange, moved along the axes of the base.
fn moved(from: [f64; 6], [x, y, z]: [f64; 3]) -> Pose {
    let pose = Pose::from(Model::default().forward(from));
    Pose { x: pose.x + x, y: pose.y + y, z: pose.z + z, ..pose }
}

#[track_caller]
fn refused<T: std::fmt::Debug>(found: &Result<T, Beyond>, words: &str) {
    assert_eq!(found.as_ref().expect_err(words).to_string(), words);
}

/// Returns joint positions at which the arm is near neither a singularity nor the end of a joint's range.
fn amidst(random: &mut Random, limits: &Limits) -> [f64; 6] {
    loop {
        let joints = random.joints(limits.model());
        let distance = limits.model().singularity_distance(joints);
        let ranges = limits.joint_min().iter().zip(limits.joint_max());
        let within = joints.iter().zip(ranges).all(|(joint, (min, max))| min + 30.0 < *joint && *joint < max - 30.0);
        if within && distance.shoulder > 0.15 && distance.elbow.min(distance.wrist) > 0.5 {
            return joints;
        }
    }
}

/// Returns some tool, user frame and mounting.
fn some_frames(random: &mut Random) -> Frames {
    let mut pose = |most_mm: f64, most_deg: f64| -> Pose {
        let mm: [f64; 3] = std::array::from_fn(|_| random.between(-most_mm, most_mm));
        Pose::from_millimetres_degrees(mm, std::array::from_fn(|_| random.between(-most_deg, most_deg)))
    };
    Frames::new().with_tool(pose(200.0, 180.0)).with_user_frame(pose(500.0, 180.0)).with_mounting(pose(300.0, 180.0))
}

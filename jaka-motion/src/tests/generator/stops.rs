//! Stops, measured on the set-points.

use super::{CYCLE, ELBOW_UP, Random, Watched};
use crate::{Goal, Limits, Model, StopBound};

/// Joint positions with upper arm and forearm level with the shoulder: the flange is 0.96 m from the first axis.
const STRETCHED: [f64; 6] = [10.0, 180.0, 0.0, 50.0, -90.0, 5.0];

fn place(of: [f64; 6]) -> [f64; 3] {
    Model::default().forward(of).position_mm()
}

/// Returns the deceleration of the tool along its path that comes from the joints' change of speed between two periods,
/// in mm/s². It differentiates the tool's place for the joint speeds before and after.
fn slowed_by_joints(three: &[[f64; 6]]) -> f64 {
    let by =
        |share: f64, of: [f64; 6]| -> [f64; 6] { std::array::from_fn(|joint| three[1][joint] + share * of[joint]) };
    let rate = |of: [f64; 6]| -> [f64; 3] {
        let ends = [place(by(-1e-3, of)), place(by(1e-3, of))];
        std::array::from_fn(|axis| (ends[1][axis] - ends[0][axis]) / 2e-3)
    };
    let [before, after] =
        [(0, 1), (1, 2)].map(|(from, to)| std::array::from_fn(|joint| three[to][joint] - three[from][joint]));
    let change = rate(std::array::from_fn(|joint| before[joint] - after[joint]));
    let way = rate(before);
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt().max(1e-9);
    way.iter().zip(change).map(|(way, change)| way * change).sum::<f64>() / length / CYCLE / CYCLE
}

fn set_points_to_rest(arm: &mut Watched) -> Vec<[f64; 6]> {
    let mut all = vec![arm.last[1], arm.last[2]];
    arm.next(&Goal::Rest);
    all.push(arm.last[2]);
    while !arm.generator.is_at_rest() {
        arm.next(&Goal::Rest);
        all.push(arm.last[2]);
    }
    all
}

#[test]
fn from_steady_speeds_a_stop_is_straight_in_joint_space_and_keeps_the_bound_of_the_tool() {
    let mut random = Random::new(33);
    let (mut hardest, mut by_tool) = (0.0, 0);
    for round in 0..200 {
        let start = std::array::from_fn(|joint| ELBOW_UP[joint] + random.between(-40.0, 40.0));
        let speeds: [f64; 6] = std::array::from_fn(|_| random.between(-90.0, 90.0));
        let limits = Limits::of(&Model::default()).with_joint_accelerations([100.0; 6]).expect("above 0");
        let mut arm = Watched::new(limits.with_stop_tcp_acceleration(4000.0).expect("above 0"), start);
        let bound = (0..200).find_map(|_| {
            arm.next(&Goal::Velocity(speeds));
            let off =
                arm.generator.velocity().iter().zip(speeds).map(|(is, speed)| (is - speed).abs()).fold(0.0, f64::max);
            let is_steady = arm.generator.acceleration().iter().all(|acceleration| acceleration.abs() < 1e-9);
            (is_steady && off < 1e-6).then(|| arm.generator.landing())
        });
        let Some(landing) = bound else { continue };
        by_tool += u32::from(landing.bound == StopBound::Tool);
        let (from, velocity) = (arm.last[2], arm.generator.velocity());
        let all = set_points_to_rest(&mut arm);
        let fastest =
            (0..6).fold(0, |one, other| if velocity[other].abs() > velocity[one].abs() { other } else { one });
        for three in all.windows(3) {
            let slowed = slowed_by_joints(three);
            hardest = f64::max(hardest, slowed);
            assert!(slowed < 4000.0, "round {round}: {slowed} mm/s² ({:?})", landing.bound);
            let share = (three[2][fastest] - from[fastest]) / velocity[fastest];
            let off = (0..6).map(|joint| (from[joint] + share * velocity[joint] - three[2][joint]).abs());
            assert!(off.fold(0.0, f64::max) < 0.02, "round {round}: {three:?}");
        }
        assert!(landing.joints.max_distance(&arm.generator.joints()) < 1e-6);
    }
    assert!(hardest > 3800.0 && by_tool > 50, "{hardest} mm/s², {by_tool} of 200");
}

#[test]
fn the_acceleration_of_motions_wins_over_the_bound_of_the_tool_and_that_is_told() {
    for (acceleration, told, most) in [(72.0, StopBound::Tool, 8000.0), (720.0, StopBound::Motion, 12_100.0)] {
        let limits = Limits::of(&Model::default()).with_joint_accelerations([acceleration; 6]).expect("above 0");
        let mut arm = Watched::new(limits, STRETCHED);
        for _ in 0..300 {
            arm.next(&Goal::Velocity([100.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
        }
        assert_eq!(arm.generator.landing().bound, told);
        let hardest = set_points_to_rest(&mut arm).windows(3).map(slowed_by_joints).fold(0.0, f64::max);
        assert!(hardest < most && hardest > 0.95 * most, "{hardest} mm/s²");
    }
}

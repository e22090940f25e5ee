//! The joints that a simulated arm passes through in motions that a robot with limits has sent, judged by the witness.

use jaka_motion::Transform;
use jaka_robot::motion::{JointMove, MoveC, MoveL};
use jaka_robot::{Error, Robot, RobotConfig};
use jaka_tests::rig::{AMOUNTS, Random, Rig};
use jaka_tests::witness::way::Excess;
use jaka_tests::{Arm, CYCLE, Configured as _};

/// A simulated arm with the rig's tool and frames, at a place, and a robot with its limits.
fn cell(rig: &Rig, at: [f64; 6]) -> (Arm, Robot) {
    let model = rig.limits.model();
    let arm = Arm::simulated().at(at).controller(|controller| controller.model(model.clone())).start();
    arm.set_state(|state| {
        (state.tool_frame_id, state.user_frame_id) = (1, 1);
        state.tool_frames[1].offset = rig.tool;
        state.user_frames[1].offset = Transform::from(rig.base).inverse().into();
    });
    let robot = arm.robot().configured(&RobotConfig::new().limits(rig.limits.clone())).expect("it is this arm");
    (arm, robot)
}

fn start(robot: &mut Robot, rig: &Rig, random: &mut Random, at: [f64; 6]) -> Result<(), Error> {
    let most = random.mostly_small(60.0);
    let mut near = || -> [f64; 6] {
        let by = random.offsets::<6>(most);
        std::array::from_fn(|joint| at[joint] + by[joint])
    };
    let (one, other) = (near(), near());
    let speed = random.between(40.0, 300.0);
    let acceleration = rig.bounds.accelerations[0] * random.between(0.2, 1.0);
    match random.below(4) {
        0 => robot.start(&JointMove::absolute(one, speed).acceleration(acceleration)),
        1 => robot.start(&MoveC::absolute(rig.pose(one), rig.pose(other), speed, 500.0, 0.0)),
        _ => robot.start(&MoveL::absolute(rig.pose(one), speed).acceleration(500.0)),
    }
}

#[test]
fn a_simulated_arm_stays_within_limits() {
    let (mut sent, mut cycles) = (0, 0);
    for seed in 20_000_000..20_000_010 {
        let mut random = Random::new(seed);
        let rig = Rig::new(&mut random);
        let Some(mut at) = rig.place(&mut random) else { continue };
        let (arm, mut robot) = cell(&rig, at);
        for _ in 0..4 {
            if start(&mut robot, &rig, &mut random, at).is_err() {
                continue;
            }
            sent += 1;
            while !arm.state().at_rest {
                arm.clock().sleep(CYCLE);
                let joints = arm.state().joint_position.0;
                let excess = passed(&rig, at, joints);
                assert!(
                    !excess.is_beyond(AMOUNTS),
                    "seed {seed}: at {joints:?}: {excess:?}\n{:?}",
                    arm.requests().last()
                );
                (at, cycles) = (joints, cycles + 1);
            }
            // It is seen to be at rest here: no need to wait for packets.
            robot.acknowledge();
        }
    }
    assert!(sent > 5 && cycles > 500, "{sent} motions, {cycles} cycles");
}

/// A cycle of the simulated arm: where it is, and how fast it went there. How it speeds up is the controller's.
fn passed(rig: &Rig, before: [f64; 6], joints: [f64; 6]) -> Excess {
    let mut excess = rig.bounds.place(joints);
    for joint in 0..6 {
        let speed = (joints[joint] - before[joint]).abs() / CYCLE.as_secs_f64();
        excess.speed = excess.speed.max(speed / rig.bounds.speeds[joint] - 1.0);
    }
    let place = |joints| rig.bounds.tcp(joints).map(|row| row[3]);
    let (from, to) = (place(before), place(joints));
    let moved = from.iter().zip(to).map(|(from, to)| (from - to).powi(2)).sum::<f64>().sqrt();
    excess.speed = excess.speed.max(moved / CYCLE.as_secs_f64() / rig.bounds.tcp_speed - 1.0);
    excess
}

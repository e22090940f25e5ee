//! Goals at random.

use jaka_motion::{Goal, TcpVelocity, VelocityFrame};
use jaka_sync::types::JointPosition;

use jaka_tests::rig::{Random, Rig};

/// Mostly one that leads somewhere; now and then one that no arm can have.
pub(crate) fn some_goal(random: &mut Random, rig: &Rig, here: [f64; 6]) -> Goal {
    let bounds = &rig.bounds;
    match random.below(12) {
        0 | 1 => Goal::Joints(JointPosition(std::array::from_fn(|joint| {
            random.between(bounds.joint_min[joint], bounds.joint_max[joint])
        }))),
        2 | 3 => near(random, here),
        4 => ends(random, rig, here),
        5 | 6 => Goal::Velocity(bounds.speeds.map(|speed| 1.2 * random.between(-speed, speed))),
        7 => one_joint(random, rig),
        8 | 9 => Goal::TcpVelocity(tool(random)),
        10 => odd(random, here),
        _ => Goal::Rest,
    }
}

fn near(random: &mut Random, here: [f64; 6]) -> Goal {
    let most = 10_f64.powf(random.between(-7.0, 1.3));
    let by = random.offsets::<6>(most);
    Goal::Joints(JointPosition(std::array::from_fn(|joint| here[joint] + by[joint])))
}

/// A joint at the very end of its range.
fn ends(random: &mut Random, rig: &Rig, mut to: [f64; 6]) -> Goal {
    let joint = random.below(6) as usize;
    to[joint] = if random.one_in(2) { rig.bounds.joint_min[joint] } else { rig.bounds.joint_max[joint] };
    Goal::Joints(JointPosition(to))
}

fn one_joint(random: &mut Random, rig: &Rig) -> Goal {
    let (joint, mut speeds) = (random.below(6) as usize, [0.0; 6]);
    speeds[joint] = rig.bounds.speeds[joint] * random.between(-1.0, 1.0);
    Goal::Velocity(speeds)
}

fn tool(random: &mut Random) -> TcpVelocity {
    let (linear, angular) = (10_f64.powf(random.between(-1.0, 3.2)), 10_f64.powf(random.between(-1.0, 2.5)));
    let frames = [VelocityFrame::ArmBase, VelocityFrame::User, VelocityFrame::Tool];
    let linear = if random.one_in(6) { [0.0; 3] } else { random.offsets(linear) };
    let angular = if random.one_in(2) { [0.0; 3] } else { random.offsets(angular) };
    TcpVelocity::new(frames[random.below(3) as usize]).with_linear(linear).with_angular(angular)
}

/// Beyond all ranges, or no number at all.
fn odd(random: &mut Random, mut numbers: [f64; 6]) -> Goal {
    let values = [f64::NAN, f64::INFINITY, -1e300, 1e16, 1e4, -720.0, 1e-300];
    numbers[random.below(6) as usize] = values[random.below(7) as usize];
    match random.below(3) {
        0 => Goal::Joints(JointPosition(numbers)),
        1 => Goal::Velocity(numbers),
        _ => Goal::TcpVelocity(tool(random).with_linear([numbers[0], numbers[1], numbers[2]])),
    }
}

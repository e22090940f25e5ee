//! Checks before the first set-point: the trajectory is within the limits, and the arm is at its start.

use jaka_motion::{Checker, Follower, JointSpeed, Trajectory};
use jaka_proto::Command;
use jaka_proto::messages::servo::SetServoMode;
use jaka_proto::messages::types::JointPosition;

use super::FollowConfig;
use super::approach::Approach;
use crate::arm::Arm;
use crate::guard::SetPointGuard;
use crate::limits::LimitChecks;
use crate::servo_session::{beyond_limit, check_shows_joints, no_limits};
use crate::{Error, ErrorKind};

/// Tolerance between the joints and the start of the trajectory, in degrees: controllers round off. Ours.
const AT_START_DEG: f64 = 0.01;

/// Checks all that can be checked without servo mode, and returns the checker that was used.
pub(super) fn check(
    (arm, limits): (&mut Arm, &mut LimitChecks),
    trajectory: &Trajectory,
    config: &FollowConfig,
    guard: Option<&SetPointGuard>,
) -> Result<Checker, Error> {
    if limits.checker().is_none() {
        return Err(no_limits());
    }
    let timeout = config.servo.enter_timeout;
    check_shows_joints(arm, timeout)?;
    let at = arm.queries().get_joint_pos()?.joint_position;
    let pose = arm.position.tcp_pose(timeout)?;
    limits.prepare_set_points(arm, (at, pose), SetServoMode::INFO.name, timeout)?;
    let checker = limits.checker().ok_or_else(no_limits)?;
    check_limits(checker, trajectory, config, guard)?;
    check_start(checker, at, trajectory, (config, guard))?;
    guard.map_or(Ok(()), SetPointGuard::check_before_start)?;
    Ok(checker.clone())
}

/// Checks the trajectory.
pub(super) fn check_limits(
    checker: &Checker,
    trajectory: &Trajectory,
    config: &FollowConfig,
    guard: Option<&SetPointGuard>,
) -> Result<(), Error> {
    trajectory.check(checker).map_err(|source| ErrorKind::Trajectory { source })?;
    let Some(guard) = guard else { return Ok(()) };
    guard.check_trajectory(&follower(trajectory, checker, config)?, checker)
}

/// Returns the follower of a trajectory with the period of the configuration.
pub(super) fn follower(trajectory: &Trajectory, checker: &Checker, config: &FollowConfig) -> Result<Follower, Error> {
    let follower = Follower::new(trajectory.clone(), checker, config.servo.period().as_secs_f64());
    follower.map_err(|source| ErrorKind::Trajectory { source }.into())
}

/// Checks the position of the arm, and plans the path from there to the start of the trajectory.
pub(super) fn check_start(
    checker: &Checker,
    at: JointPosition,
    trajectory: &Trajectory,
    (config, guard): (&FollowConfig, Option<&SetPointGuard>),
) -> Result<Approach, Error> {
    let start = trajectory.start();
    match config.approach_deg_s {
        _ if at.max_distance(&start) <= AT_START_DEG => {}
        None => return Err(not_at_start(at, start)),
        Some(speed_deg_s) => {
            let accelerations = checker.limits().joint_accelerations();
            let least = accelerations.iter().copied().fold(f64::INFINITY, f64::min);
            let asked = JointSpeed { speed_deg_s: slowest(checker).min(speed_deg_s), acceleration_deg_s2: Some(least) };
            checker.check_joint_way(at, start, asked).map_err(beyond_limit)?;
        }
    }
    Approach::new(checker, [at, start], config.approach_deg_s, config.servo.period().as_secs_f64(), guard)
}

/// Names the joint with the greatest distance from the start.
fn not_at_start(at: JointPosition, start: JointPosition) -> Error {
    let off = |joint: usize| (start.0[joint] - at.0[joint]).abs();
    let worst = (0..6).fold(0, |worst, joint| if off(joint) > off(worst) { joint } else { worst });
    let (at_deg, start_deg) = (at.0[worst], start.0[worst]);
    ErrorKind::NotAtStart { joint: worst + 1, at_deg, start_deg }.into()
}

/// The speed that each joint may have, in deg/s.
fn slowest(checker: &Checker) -> f64 {
    checker.limits().joint_speeds().iter().copied().fold(f64::INFINITY, f64::min)
}

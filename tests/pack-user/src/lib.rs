//! A program that uses commands of newer firmware, which a pack describes.

use jaka_robot::jaka_sync::Error;
use jaka_robot::status::RobotStatus;
use jaka_robot::{Call, Client, MotionStatus};

jaka_robot::pack!("newer.toml");
jaka_robot::pack!("changed.toml");
jaka_robot::pack!("strange.toml");
jaka_robot::pack!("halt.toml");
jaka_robot::pack!("mapped.toml" on "halt.toml");
jaka_robot::pack!("radians.toml");
jaka_robot::pack!("later.toml" on "newer.toml", "changed.toml");

use changed::ChangedCommands as _;
use newer::NewerCommands as _;

/// Number of queued motions, queried through a client.
pub fn queued(robot: &mut Client) -> Result<i64, Error> {
    Ok(robot.demo_motion_state()?.queue)
}

/// Whether the emergency stop is pressed, asked through whatever takes commands.
pub fn is_stopped(robot: &mut impl Call) -> Result<bool, Error> {
    Ok(robot.demo_stop_state()?.emergency_stop)
}

/// Moves the joints, with the field that newer firmware has.
pub fn move_with_zone(robot: &mut Client, joints: [f64; 6], zone: f64) -> Result<(), Error> {
    robot.joint_move_changed(&changed::JointMove::absolute(joints, 20.0).zone(zone))
}

impl MotionStatus for radians::RobotStatus {
    fn robot_status(&self) -> RobotStatus {
        let mut status = self.as_built_in();
        status.joint_actual_position = self.joint_actual_position.map(|joints| joints.map(f64::to_degrees).into());
        status
    }
}

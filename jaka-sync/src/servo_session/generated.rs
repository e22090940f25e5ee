//! Set-points that are generated within limits, for a stream.

use std::time::Duration;

use jaka_motion::Checker;
use jaka_proto::messages::types::JointPosition;

use super::ServoSession;
use super::set_point::SetPoint;
use crate::clock::Clock;
use crate::{Error, MotionStatus};

/// A cycle that has begun, and how late it is.
#[derive(Debug)]
pub(crate) struct Cycle {
    pub(crate) late: Duration,
    /// The arm is taken to stand: it had no set-points for so long.
    pub(crate) follows_gap: bool,
}

impl<S: MotionStatus> ServoSession<'_, S> {
    /// What set-points are compared with, and where the joints are to be at the start; none where the robot has no limits.
    pub(crate) fn checker_and_start(&self) -> Option<(&Checker, JointPosition)> {
        let [_, start] = self.course.last_joints()?;
        Some((self.robot.limits()?, start))
    }

    pub(crate) fn clock(&self) -> &Clock {
        self.robot.clock()
    }

    /// The joints of the newest packet, and its number, unless it is this one.
    pub(crate) fn actual_joints_after(&self, number: u64) -> Option<(u64, JointPosition)> {
        let packet = self.robot.monitor().last_known_packet().filter(|packet| packet.number != number)?;
        S::snapshot(&packet).status.joint_actual_position.map(|joints| (packet.number, joints))
    }

    /// Waits for the next cycle.
    pub(crate) fn begin_cycle(&mut self) -> Cycle {
        let late = self.wait_for_cycle();
        Cycle { late, follows_gap: late >= self.config.gap() }
    }

    /// Sends a set-point in this cycle. After an error the session is to be ended.
    pub(crate) fn send_generated(&mut self, joints: JointPosition, cycle: &Cycle) -> Result<(), Error> {
        self.send_checked(SetPoint::Joints(joints), Some(joints))?;
        self.report.late(cycle.late, self.config.period());
        Ok(())
    }
}

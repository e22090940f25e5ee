//! Where to, or how fast.

use jaka_proto::messages::types::JointPosition;

use crate::beyond::Beyond;
use crate::velocity::TcpVelocity;

/// What a [`Generator`](crate::Generator) is on the way to.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Joint positions, which all joints reach at the same time. From rest the way is straight in joint space; it is not straight for the tool.
    Joints(JointPosition),
    /// A speed of each joint in deg/s, which each reaches as soon as it can. A joint stops at the end of its range, the others go on.
    Velocity([f64; 6]),
    /// A velocity of the tool.
    TcpVelocity(TcpVelocity),
    /// Standstill, as soon as each joint can.
    Rest,
}

/// One set-point, and what kept it from being nearer to the goal.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// The set-point.
    pub joints: JointPosition,
    /// What it was slowed or held by, beyond the speeds, accelerations and jerks of the joints.
    pub bound: Option<Bound>,
}

/// What slows or holds a motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Bound {
    /// A limit that is near.
    Limit(Beyond),
    /// What was computed for the goal did not pass the generator's own check. [`Generator::rejections`](crate::Generator::rejections) counts them.
    Rejected,
}

/// Where an arm would come to rest if it stopped now.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Landing {
    /// Its joint positions there.
    pub joints: JointPosition,
    /// In how many seconds, 0 for an arm at rest.
    pub time_s: f64,
}

//! Motions that can be waited for.

mod target;

use jaka_proto::Command;
use jaka_proto::messages::force::StartTorqSensorPayloadIdentify;
use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_proto::messages::types::{MoveMode, Pose};

pub use self::target::Target;
use crate::Guard;

/// A planned motion: one whose reply says that it was accepted, and whose end is waited for.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a motion whose end a robot waits for",
    note = "any other command goes out by `Robot::client`: `robot.client().call(&request)`",
    note = "a motion of a pack implements `Motion`, which says where it ends"
)]
pub trait Motion: Command<Reply = ()> {
    /// Where it ends, as far as the request determines it. The controller's own answer says whether the arm is there.
    fn target(&self) -> Target;

    /// The way on which it goes there. A robot with limits refuses a motion whose way is not known, as it is by
    /// default.
    fn path(&self) -> Path {
        Path::Unknown
    }

    /// How far from its target it may end, in mm, since the controller may blend it into the next motion. 0 for none.
    fn tolerance(&self) -> f64 {
        0.0
    }

    /// The same motion under a guard, for [`Robot::run`](crate::Robot::run), which waits until it has ended or the
    /// guard has tripped, upon which the arm is stopped. [`Guard`] tells what can be expected of that, and what not: it
    /// is **not a safety function**.
    ///
    /// A guard that has tripped before the motion goes out, such as by an input that has the level already, sends
    /// nothing ([`GuardTrip::is_before_start`](crate::GuardTrip::is_before_start)). The stop is written by the thread
    /// that reads the packet, or, where it would have to wait, by one of its own, also while the reply to the motion is
    /// waited for. If the guard tripped, the arm is then waited for until it rests, for 2 s at most.
    ///
    /// Motions that were started before are ended by the stop, too, but not by a guard that trips before this motion
    /// has gone out: wait for them first.
    ///
    /// Since nobody judges the guard after the run, the arm is stopped in each way out in which it may still move: at
    /// the deadline, when the command connection is lost, which no stop passes any more, when the status is lost or
    /// stale ([`Config::stale_after`](crate::Config::stale_after)), after an error of the controller.
    /// [`End::stop`](crate::End::stop) tells whether the stop was accepted.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_robot::motion::MoveL;
    /// use jaka_robot::{Motion, Numbering, Robot};
    ///
    /// const IO: Numbering = Numbering::FromOne;
    /// let mut robot = Robot::connect("10.5.5.100")?;
    /// let down = MoveL::relative([0.0, 0.0, -50.0, 0.0, 0.0, 0.0], 20.0).acceleration(200.0);
    /// let trip = robot.run(&down.guard(IO.tool(1).rises()), Duration::from_secs(10))?.guarded()?;
    /// println!("{trip}; the stop was written after {:?}", trip.reaction);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors of the run
    /// Where the motion may have run, the arm was stopped, and [`ErrorKind::NotStopped`](crate::ErrorKind::NotStopped)
    /// says if the controller has not accepted that. Nothing was sent after
    /// [`ErrorKind::NotShown`](crate::ErrorKind::NotShown) (packets do not show what the guard needs),
    /// [`ErrorKind::NotGuarded`](crate::ErrorKind::NotGuarded) (a [`ForceLimit`](crate::ForceLimit) permits less
    /// speed), [`ErrorKind::StatusUnknown`](crate::ErrorKind::StatusUnknown), also with
    /// [`allow_motion_without_status`](crate::RobotConfig::allow_motion_without_status),
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) (a condition has a value that it does not take),
    /// and [`ErrorKind::Thread`](crate::ErrorKind::Thread).
    fn guard(self, guard: impl Into<Guard>) -> Guarded<Self> {
        Guarded { motion: self, guard: guard.into() }
    }
}

/// A motion under a guard, from [`Motion::guard`].
#[derive(Debug, Clone)]
#[must_use = "a guarded motion does nothing until a robot runs it"]
pub struct Guarded<M> {
    pub(crate) motion: M,
    pub(crate) guard: Guard,
}

/// What a robot runs to its end: a [`Motion`], or a motion [under a guard](Motion::guard).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a motion whose end a robot waits for",
    note = "any other command goes out by `Robot::client`: `robot.client().call(&request)`",
    note = "a motion of a pack implements `Motion`, which says where it ends"
)]
pub trait Run {
    /// Type of the motion.
    type Motion: Motion;

    /// The motion, and its guard if it has one.
    fn motion_and_guard(&self) -> (&Self::Motion, Option<&Guard>);
}

impl<M: Motion> Run for M {
    type Motion = M;

    fn motion_and_guard(&self) -> (&M, Option<&Guard>) {
        (self, None)
    }
}

impl<M: Motion> Run for Guarded<M> {
    type Motion = M;

    fn motion_and_guard(&self) -> (&M, Option<&Guard>) {
        (&self.motion, Some(&self.guard))
    }
}

/// The way of a [`Motion`] to its target, and how fast it goes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Path {
    /// All joints at once, from beginning to end together.
    Joints {
        /// The speed of the joint with the longest way, in deg/s.
        speed: f64,
        /// Its acceleration in deg/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on a straight line.
    Line {
        /// Its speed in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on an arc.
    Arc {
        /// The pose between its ends, in the frames that are selected when it is sent; mm and degrees.
        through: Pose,
        /// The speed of the tool centre point in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The request does not determine it.
    Unknown,
}

impl Motion for JointMove {
    fn target(&self) -> Target {
        match self.mode {
            MoveMode::Absolute => Target::Joints(self.joint_position),
            MoveMode::Relative => Target::JointOffset(self.joint_position),
            _ => Target::Unknown,
        }
    }

    /// No source says which joint has the speed that is given; taken is the one with the longest way, as controllers of
    /// such arms do.
    fn path(&self) -> Path {
        Path::Joints { speed: self.speed, acceleration: self.acceleration }
    }
}

/// Its way to the position is the controller's choice.
impl Motion for StartTorqSensorPayloadIdentify {
    fn target(&self) -> Target {
        Target::Joints(self.joint_position)
    }
}

impl Motion for EndMove {
    fn target(&self) -> Target {
        Target::Pose(self.pose)
    }

    fn path(&self) -> Path {
        Path::Joints { speed: self.speed, acceleration: self.acceleration }
    }
}

impl Motion for MoveL {
    /// An offset is one along the axes of the selected user frame; the document does not say how an offset of the
    /// orientation counts.
    fn target(&self) -> Target {
        let pose = self.pose;
        let turns = [pose.rx, pose.ry, pose.rz].iter().any(|angle| *angle != 0.0);
        match self.mode {
            LineMode::Absolute => Target::Pose(pose),
            LineMode::Relative if !turns => Target::Offset([pose.x, pose.y, pose.z]),
            _ => Target::Unknown,
        }
    }

    fn path(&self) -> Path {
        Path::Line { speed: self.speed, acceleration: self.acceleration }
    }

    fn tolerance(&self) -> f64 {
        self.tolerance.unwrap_or(0.0)
    }
}

impl Motion for MoveC {
    /// The document does not say from where the offsets of an arc count.
    fn target(&self) -> Target {
        match self.mode {
            MoveMode::Absolute => Target::Pose(self.end_pose),
            _ => Target::Unknown,
        }
    }

    fn path(&self) -> Path {
        Path::Arc { through: self.mid_pose, speed: self.speed, acceleration: Some(self.acceleration) }
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }
}

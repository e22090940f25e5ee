//! Motions as a robot runs them: by themselves, under a guard, or as text.

use jaka_proto::check::{NotSent, Rules};
use jaka_proto::wire::Writer;
use jaka_proto::{CommandInfo, Motion, Path, Target};
use jaka_sync::layer::Written;

use crate::Guard;

/// Methods of each [`Motion`].
pub trait MotionExt: Motion {
    /// Puts the motion under a guard, for [`Robot::run`](crate::Robot::run). The run waits until the motion has ended
    /// or the guard has tripped; a guard that trips stops the arm. [`Guard`] describes its reach and its limits: it is
    /// **not a safety function**.
    ///
    /// A guard that has tripped before the motion is sent, for example by an input that already has the level, sends
    /// nothing ([`GuardTrip::is_before_start`](crate::GuardTrip::is_before_start)). The thread that reads the packet
    /// writes the stop, or, if it would have to wait, a separate one, also during the wait for the reply to the motion.
    /// After a trip, the call waits until the arm rests, for 2 s at most.
    ///
    /// Motions that were started before are ended by the stop, too, but not by a guard that trips before this motion
    /// has gone out: wait for them first.
    ///
    /// Since nothing evaluates the guard after the run, the arm is stopped at each end of the run at which it may still
    /// move: at the deadline, after the loss of the command connection (which no stop can pass), after a lost or stale
    /// status ([`Config::stale_after`](crate::Config::stale_after)), and after an error of the controller.
    /// [`End::stop`](crate::End::stop) says whether the stop was accepted.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_robot::motion::MoveL;
    /// use jaka_robot::{MotionExt as _, Numbering, Robot};
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
    /// If the motion may have run, the arm was stopped, and [`ErrorKind::NotStopped`](crate::ErrorKind::NotStopped)
    /// says that the controller has not accepted the stop. Nothing was sent after
    /// [`ErrorKind::NotShown`](crate::ErrorKind::NotShown) (packets lack the values of the guard),
    /// [`ErrorKind::NotGuarded`](crate::ErrorKind::NotGuarded) (a [`ForceLimit`](crate::ForceLimit) permits less
    /// speed), [`ErrorKind::StatusUnknown`](crate::ErrorKind::StatusUnknown), also with
    /// [`allow_motion_without_status`](crate::RobotConfig::allow_motion_without_status),
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) (an invalid value of a condition), and
    /// [`ErrorKind::Thread`](crate::ErrorKind::Thread).
    fn guard(self, guard: impl Into<Guard>) -> Guarded<Self>
    where
        Self: Sized,
    {
        Guarded { motion: self, guard: guard.into() }
    }
}

impl<M: Motion> MotionExt for M {}

/// Motion under a guard, from [`MotionExt::guard`].
#[derive(Debug, Clone)]
#[must_use = "a guarded motion does nothing until a robot runs it"]
pub struct Guarded<M> {
    motion: M,
    guard: Guard,
}

/// Motion whose request is text, for programs that learn its command at run time, such as a command line with packs.
///
/// The text is sent unchanged, byte for byte, and unchecked: check it first, as `jaka-dynamic` does.
#[derive(Debug, Clone)]
#[must_use = "a motion does nothing until a robot runs it"]
pub struct MotionText {
    info: &'static CommandInfo,
    text: String,
    target: Target,
    path: Path,
    tolerance_mm: f64,
}

impl MotionText {
    /// Motion of the command with these facts, by the text of its request, to a target of which nothing is known.
    pub fn new(info: &'static CommandInfo, text: impl Into<String>) -> Self {
        Self { info, text: text.into(), target: Target::Unknown, path: Path::Unknown, tolerance_mm: 0.0 }
    }

    /// Target of the motion. Default: unknown.
    pub fn target(self, target: Target) -> Self {
        Self { target, ..self }
    }

    /// Path to the target. Default: unknown.
    pub fn path(self, path: Path) -> Self {
        Self { path, ..self }
    }

    /// Distance from the target at which the controller may blend into the next motion, in mm. Default: 0.
    pub fn tolerance_mm(self, tolerance_mm: f64) -> Self {
        Self { tolerance_mm, ..self }
    }
}

/// Motion that a robot runs to its end: a [`Motion`], one [under a guard](MotionExt::guard), or a [`MotionText`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a motion whose end a robot waits for",
    note = "any other command goes out by `Robot::client`: `robot.client().call(&request)`",
    note = "a command of a pack is a motion by a table `[command.motion]` in the pack"
)]
pub trait Run {
    /// The motion as it is sent.
    fn motion(&self) -> PlannedMotion<'_>;
}

/// Motion as it is sent: command, request, target, path, and guard if it has one.
#[derive(Clone, Copy)]
pub struct PlannedMotion<'m> {
    pub(crate) info: &'static CommandInfo,
    pub(crate) request: &'m dyn Written,
    pub(crate) target: Target,
    pub(crate) path: Path,
    /// Distance from the target at which the controller may blend into the next motion, in mm.
    pub(crate) tolerance_mm: f64,
    pub(crate) guard: Option<&'m Guard>,
}

impl<'m> PlannedMotion<'m> {
    pub(crate) fn of<M: Motion>(motion: &'m M) -> Self {
        Self {
            info: M::INFO,
            request: motion,
            target: motion.target(),
            path: motion.path(),
            tolerance_mm: motion.tolerance(),
            guard: None,
        }
    }

    /// True unless it is known that it depends on no frame: a motion of the joints to joint positions, and its guard.
    pub(crate) fn depends_on_frames(&self) -> bool {
        let to_joints = matches!(self.target, Target::Joints(_) | Target::JointOffset(_));
        let is_of_joints = to_joints && matches!(self.path, Path::Joints { .. });
        !is_of_joints || self.guard.is_some_and(Guard::depends_on_frames)
    }
}

impl std::fmt::Debug for PlannedMotion<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PlannedMotion")
            .field("command", &self.info.name)
            .field("target", &self.target)
            .finish_non_exhaustive()
    }
}

impl<M: Motion> Run for M {
    fn motion(&self) -> PlannedMotion<'_> {
        PlannedMotion::of(self)
    }
}

impl<M: Motion> Run for Guarded<M> {
    fn motion(&self) -> PlannedMotion<'_> {
        PlannedMotion { guard: Some(&self.guard), ..PlannedMotion::of(&self.motion) }
    }
}

impl Run for MotionText {
    fn motion(&self) -> PlannedMotion<'_> {
        let Self { info, text: _, target, path, tolerance_mm } = *self;
        PlannedMotion { info, request: self, target, path, tolerance_mm, guard: None }
    }
}

impl Written for MotionText {
    fn check(&self, _rules: Rules) -> Result<(), NotSent> {
        Ok(())
    }

    fn write(&self, out: &mut Writer) {
        out.raw(&self.text);
    }
}

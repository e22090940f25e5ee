//! Limits: what is checked before a motion or a set-point is sent.

mod motion;
mod set_points;

use std::time::Duration;

use jaka_motion::{Checker, Frames, Limits, Model, Tolerance};
use jaka_proto::Command;
use jaka_proto::messages::kinematics::KineForward;
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_sync::layer::ClientParts as _;

use super::{MotionStatus, Robot};
use crate::error::Attach as _;
use crate::{Error, ErrorKind, Explanation, Unchecked};

/// What happens to a motion or a set-point that is beyond a limit, or that cannot be checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum LimitPolicy {
    /// It is not sent, and the call fails.
    #[default]
    Refuse,
    /// It is sent, and a warning is logged: see [`Robot::limit_warning`].
    Warn,
}

/// The limits of a robot, if it has any, and what is known for checking them.
#[derive(Debug, Default)]
pub(super) struct Checks(Option<Box<Limited>>);

#[derive(Debug)]
struct Limited {
    checker: Checker,
    policy: LimitPolicy,
    warning: Option<Error>,
    /// Where the last motion that was accepted ends, by its check.
    planned: Option<JointPosition>,
    /// How many stops had gone out by then: after another one the arm ends elsewhere.
    stops: u64,
    /// Motions were given up that the arm may not have begun yet.
    is_unsettled: bool,
    /// How often this program had changed frames when the frames of the checker were compared with the controller's.
    frame_changes: u64,
}

/// How far the controller's pose may be from the model's at the same joint positions. The poses of a real arm are within 0.42 mm and
/// 0.00001 deg; beyond that, a frame was changed.
const AGREES: Tolerance = Tolerance { position_mm: 1.0, angle_deg: 0.1 };

impl Checks {
    /// The same for another thread.
    #[cfg(feature = "stream")]
    pub(super) fn lent(&self) -> Self {
        let lent = |limited: &Limited| {
            let checker = limited.checker.clone();
            let (planned, warning) = (None, None);
            Box::new(Limited { checker, warning, planned, ..*limited })
        };
        Self(self.0.as_deref().map(lent))
    }

    /// Where the arm is when it has done the last motion is no longer known.
    pub(super) fn forget_plan(&mut self) {
        if let Some(limited) = &mut self.0 {
            limited.planned = None;
        }
    }

    /// Motions are given up that the arm may not have begun yet.
    pub(super) fn unsettle(&mut self) {
        if let Some(limited) = &mut self.0 {
            limited.is_unsettled = true;
        }
    }
}

/// Limits need the feature `motion`.
impl<S: MotionStatus> Robot<S> {
    /// The same robot with limits, which each motion and each set-point is checked against before it is sent.
    ///
    /// A motion that is beyond a limit anywhere on its way is refused with [`ErrorKind::BeyondLimit`], one whose way is not known with
    /// [`ErrorKind::NotChecked`]; nothing is sent then. [`Checker`] tells what is checked, and how finely. Checked are
    /// [`run`](Self::run), [`start`](Self::start) and servo sessions, not what is sent through [`client`](Self::client), such as a jog.
    ///
    /// An offset of a motion in a queue is taken to count from where the one before it ends, which the document does not say.
    /// A motion in a queue is checked from where the one before it will end. Where somebody else stops the queue, and this program does not
    /// know it yet, the arm goes to the target of the next motion from elsewhere: [`wait`](Self::wait) for the end of a motion to know.
    ///
    /// Limits are not a safety function and no fence: they keep a program from asking for what it should not. They know nothing of
    /// collisions, not even of the arm with itself, and do not see motions of other clients.
    ///
    /// The controller is asked for the poses of twelve joint positions (`kine_forward`, 4.46, which moves nothing), from which its
    /// tool, user frame and mounting follow. Before a motion it is asked where the arm is (4.49 and 4.50); where both answers do not
    /// fit together a frame has changed, and the poses are asked for again.
    ///
    /// ```no_run
    /// use jaka_robot::Robot;
    /// use jaka_robot::jaka_motion::{Limits, Model};
    /// use jaka_robot::motion::JointMove;
    ///
    /// let arm = Model::named("Zu 5").expect("a published arm");
    /// let mut robot = Robot::connect("10.5.5.100")?.with_limits(Limits::of(arm).with_tcp_speed(250.0)?)?;
    /// let error = robot.start(&JointMove::absolute([0.0, 0.0, 181.0, 0.0, 0.0, 0.0], 20.0).acceleration(50.0)).unwrap_err();
    /// assert_eq!(error.to_string(), "`joint_move` was not sent: joint 3 would be at 181 deg; limit 175 (Zu 5)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::ModelMismatch`] if the controller computes other poses than the limits' model, and as [`Client::call`](crate::Client::call).
    pub fn with_limits(mut self, limits: Limits) -> Result<Self, Error> {
        let (frames, frame_changes) = self.fitted_frames(limits.model(), None)?;
        let checker = Checker::new(limits, frames);
        let limited = Limited {
            checker,
            policy: LimitPolicy::default(),
            warning: None,
            planned: None,
            stops: 0,
            is_unsettled: false,
            frame_changes,
        };
        self.checks = Checks(Some(Box::new(limited)));
        Ok(self)
    }

    /// Sets what happens to a motion that is beyond a limit, or cannot be checked. It is refused by default. Without limits this does nothing.
    ///
    /// A controller that has come to compute other poses than the limits' model is an error all the same ([`ErrorKind::ModelMismatch`]).
    pub fn with_limit_policy(mut self, policy: LimitPolicy) -> Self {
        if let Some(limited) = &mut self.checks.0 {
            limited.policy = policy;
        }
        self
    }

    /// The same robot without limits.
    pub fn without_limits(mut self) -> Self {
        self.checks = Checks::default();
        self
    }

    /// The limits, with the frames that the controller was found to have.
    pub fn limits(&self) -> Option<&Checker> {
        self.checks.0.as_ref().map(|limited| &limited.checker)
    }

    /// Why the last motion, or the first such set-point of the last session, should not have been sent, where it was sent all the same
    /// ([`LimitPolicy::Warn`]).
    pub fn limit_warning(&self) -> Option<String> {
        self.checks.0.as_ref().and_then(|limited| limited.warning.as_ref()).map(warning)
    }

    /// The controller's frames, and how often this program had changed any before they were asked for.
    fn fitted_frames(&mut self, model: &Model, timeout: Option<Duration>) -> Result<(Frames, u64), Error> {
        let since = self.clock().stopwatch();
        let frame_changes = self.client.link().frame_changes();
        let mut pairs = Vec::new();
        for joints in model.positions_to_compare() {
            let usual = self.client.timeout_of(KineForward::INFO);
            let left = timeout.map_or(usual, |timeout| since.left_of(timeout).min(usual));
            pairs.push((joints, self.client.call_within(&KineForward::new(joints), left)?.pose));
        }
        let fit = model.fit(&pairs, Tolerance::default());
        let frames =
            fit.map_err(|source| self.client.link().attach(ErrorKind::ModelMismatch { source }.into()))?.frames;
        Ok((frames, frame_changes))
    }

    /// Makes the checker's frames those of the controller, which has this pose at these joint positions.
    fn follow_frames(
        &mut self,
        joints: JointPosition,
        pose: Pose,
        command: &str,
        timeout: Duration,
    ) -> Result<(), Error> {
        if self.is_framed(joints, pose) {
            return Ok(());
        }
        let Some(model) = self.limits().map(|checker| checker.limits().model().clone()) else { return Ok(()) };
        let (frames, frame_changes) = self.fitted_frames(&model, Some(timeout))?;
        if let Some(limited) = &mut self.checks.0 {
            limited.checker = limited.checker.clone().with_frames(frames);
            limited.frame_changes = frame_changes;
        }
        if self.is_framed(joints, pose) { Ok(()) } else { Err(self.not_checked(command, Unchecked::Frames)) }
    }

    fn is_framed(&self, joints: JointPosition, pose: Pose) -> bool {
        let Some(limited) = &self.checks.0 else { return true };
        limited.agrees(joints, pose) && limited.frame_changes == self.client.link().frame_changes()
    }

    /// The last motion that was accepted ends there.
    pub(super) fn plan(&mut self, end: Option<JointPosition>) {
        let stops = self.client.link().stop_count();
        if let Some(limited) = &mut self.checks.0 {
            (limited.planned, limited.stops, limited.is_unsettled) = (end, stops, false);
        }
    }

    fn not_checked(&self, command: &str, reason: Unchecked) -> Error {
        self.client.link().attach(ErrorKind::NotChecked { command: command.to_owned(), reason }.into())
    }

    /// What to do about a check that failed: no error where it is sent all the same.
    fn judged(&mut self, error: Error) -> Result<(), Error> {
        let is_limit = matches!(error.kind(), ErrorKind::BeyondLimit { .. } | ErrorKind::NotChecked { .. });
        match &mut self.checks.0 {
            Some(limited) if is_limit && limited.policy == LimitPolicy::Warn => {
                if limited.warning.is_none() {
                    log::warn!(target: "jaka_robot", "{}", warning(&error));
                    limited.warning = Some(error);
                }
                Ok(())
            }
            _ => Err(error),
        }
    }

    /// Why the controller may have refused a motion that was sent although it is beyond a limit.
    pub(super) fn limit_explanation(&self) -> Option<Explanation> {
        match self.checks.0.as_ref()?.warning.as_ref()?.kind() {
            ErrorKind::BeyondLimit { beyond, .. } => Some(Explanation::BeyondLimit(Box::new(beyond.clone()))),
            _ => None,
        }
    }
}

impl Limited {
    /// Whether the controller's pose is the model's, in the frames that are known.
    fn agrees(&self, joints: JointPosition, pose: Pose) -> bool {
        let ours = self.checker.frames().pose(self.checker.limits().model().forward(joints));
        ours.distance_mm(&pose) <= AGREES.position_mm && ours.angle_deg(&pose) <= AGREES.angle_deg
    }
}

/// What was sent all the same, and why it should not have been.
fn warning(error: &Error) -> String {
    match error.kind() {
        ErrorKind::BeyondLimit { command, beyond } => {
            format!("`{command}` was sent although it is beyond a limit: {beyond}")
        }
        ErrorKind::NotChecked { command, reason } => {
            format!("`{command}` was sent without a check against limits: {reason}")
        }
        _ => error.to_string(),
    }
}

//! Limits: checks before a motion or a set-point is sent.

mod motion;
mod waived;

use std::time::Duration;

use jaka_motion::{Beyond, Checker, Frames, Limits, Model, Point, Region, RegionFrame, Tolerance};
use jaka_proto::Command;
use jaka_proto::messages::kinematics::KineForward;
use jaka_proto::messages::servo::{ServoJ, ServoP};
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_sync::layer::ClientParts as _;

pub(crate) use self::motion::Beginning;
pub(crate) use self::waived::Waived;
use crate::arm::Arm;
use crate::{Error, ErrorKind, Unchecked};

/// The limits of a robot, if it has any, and the facts for checking them.
#[derive(Debug, Default)]
pub(crate) struct LimitChecks(Option<Box<Limited>>);

#[derive(Debug)]
struct Limited {
    checker: Checker,
    /// End of the last motion that was accepted, by its check.
    planned: Option<JointPosition>,
    /// Number of stops that had gone out by then, and of commands of other handles that may have changed something:
    /// after another one the arm ends elsewhere.
    stops: u64,
    changes_by_others: u64,
    /// Motions were given up that the arm may not have begun yet.
    is_unsettled: bool,
    /// Number of this program's frame changes when the frames of the checker were compared with the controller's.
    frame_changes: u64,
}

/// Tolerance between the controller's pose and the model's at the same joint positions. The poses of a real arm are
/// within 0.42 mm and 0.00001 deg; beyond that, a frame was changed.
const AGREES: Tolerance = Tolerance { position_mm: 1.0, angle_deg: 0.1 };

impl LimitChecks {
    /// Checks against these limits, with the tool and the frames that the controller is found to have.
    pub(crate) fn new(arm: &mut Arm, limits: Limits) -> Result<Self, Error> {
        let (frames, frame_changes) = fitted_frames(arm, limits.model(), None)?;
        let checker = Checker::new(limits, frames);
        let (planned, stops, changes_by_others, is_unsettled) = (None, 0, 0, false);
        Ok(Self(Some(Box::new(Limited { checker, planned, stops, changes_by_others, is_unsettled, frame_changes }))))
    }

    /// Returns checks of the same limits for another thread.
    pub(crate) fn lent(&self) -> Self {
        let lent = |limited: &Limited| {
            let checker = limited.checker.clone();
            Box::new(Limited { checker, planned: None, ..*limited })
        };
        Self(self.0.as_deref().map(lent))
    }

    /// Forgets the end of the last motion.
    pub(crate) fn forget_plan(&mut self) {
        if let Some(limited) = &mut self.0 {
            limited.planned = None;
        }
    }

    /// Motions are given up that the arm may not have begun yet.
    pub(crate) fn unsettle(&mut self) {
        if let Some(limited) = &mut self.0 {
            limited.is_unsettled = true;
        }
    }

    /// The limits, with the frames that the controller was found to have.
    pub(crate) fn checker(&self) -> Option<&Checker> {
        self.0.as_ref().map(|limited| &limited.checker)
    }

    /// The last motion that was accepted ends there.
    pub(crate) fn plan(&mut self, arm: &Arm, end: Option<JointPosition>) {
        if let Some(limited) = &mut self.0 {
            (limited.planned, limited.stops, limited.is_unsettled) = (end, arm.stops().begun(), false);
            limited.changes_by_others = arm.changes_by_others();
        }
    }

    /// Before `command`, which enters servo mode or uses it: the checker's frames are the controller's.
    pub(crate) fn prepare_set_points(
        &mut self,
        arm: &mut Arm,
        (start, pose): (JointPosition, Option<Pose>),
        command: &str,
        timeout: Duration,
    ) -> Result<(), Error> {
        let Some(limited) = &mut self.0 else { return Ok(()) };
        match pose {
            Some(pose) => limited.follow_frames(arm, (start, pose), command, timeout),
            None => Err(not_checked(arm, command, Unchecked::Start)),
        }
    }

    /// True if a limit is for the tool centre point, or seen from the user frame.
    pub(crate) fn depend_on_frames(&self) -> bool {
        let is_of_arm = |region: &Region| {
            matches!((region.point(), region.frame()), (Point::Elbow | Point::Wrist, RegionFrame::ArmBase))
        };
        self.checker()
            .map(Checker::limits)
            .is_some_and(|limits| limits.tcp_speed().is_some() || !limits.regions().iter().all(is_of_arm))
    }

    /// Checks a set-point of the joints, after the last two.
    pub(crate) fn check_joints(
        &self,
        arm: &Arm,
        before: Option<[JointPosition; 2]>,
        target: Option<JointPosition>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.checker() else { return Ok(target) };
        let (Some(before), Some(joints)) = (before, target) else {
            return Err(not_checked(arm, ServoJ::INFO.name, Unchecked::Start));
        };
        let result = checker.check_set_point(before, joints, period.as_secs_f64());
        result.map(|()| target).map_err(|beyond| beyond_limit(arm, ServoJ::INFO.name, beyond))
    }

    /// Checks a set-point of the tool centre point, and returns its joint positions if they are known.
    pub(crate) fn check_pose(
        &self,
        arm: &Arm,
        before: Option<[JointPosition; 2]>,
        target: Option<Pose>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.checker() else { return Ok(None) };
        match (before, target) {
            (Some(before), Some(pose)) => {
                let result = checker.check_pose_set_point(before, pose, period.as_secs_f64());
                result.map(Some).map_err(|beyond| beyond_limit(arm, ServoP::INFO.name, beyond))
            }
            (None, _) => Err(not_checked(arm, ServoP::INFO.name, Unchecked::Start)),
            (_, None) => Err(not_checked(arm, ServoP::INFO.name, Unchecked::Target)),
        }
    }
}

impl Limited {
    /// Sets the checker's frames to the controller's, which has this pose at these joint positions.
    fn follow_frames(
        &mut self,
        arm: &mut Arm,
        (joints, pose): (JointPosition, Pose),
        command: &str,
        timeout: Duration,
    ) -> Result<(), Error> {
        if self.is_framed(arm, joints, pose) {
            return Ok(());
        }
        let (frames, frame_changes) = fitted_frames(arm, self.checker.limits().model(), Some(timeout))?;
        self.checker = self.checker.clone().with_frames(frames);
        self.frame_changes = frame_changes;
        if self.is_framed(arm, joints, pose) { Ok(()) } else { Err(not_checked(arm, command, Unchecked::Frames)) }
    }

    fn is_framed(&self, arm: &Arm, joints: JointPosition, pose: Pose) -> bool {
        self.agrees(joints, pose) && self.frame_changes == arm.link().frame_changes()
    }

    /// True if the controller's pose is the model's, in the frames that are known.
    fn agrees(&self, joints: JointPosition, pose: Pose) -> bool {
        let ours = self.checker.frames().pose(self.checker.limits().model().forward(joints));
        ours.distance_mm(&pose) <= AGREES.position_mm && ours.angle_deg(&pose) <= AGREES.angle_deg
    }
}

/// The controller's frames, and the number of this program's frame changes before they were asked for.
fn fitted_frames(arm: &mut Arm, model: &Model, timeout: Option<Duration>) -> Result<(Frames, u64), Error> {
    let since = arm.clock().stopwatch();
    let frame_changes = arm.link().frame_changes();
    let mut pairs = Vec::new();
    for joints in model.positions_to_compare() {
        let usual = arm.queries().timeout_of(KineForward::INFO);
        let left = timeout.map_or(usual, |timeout| since.left_of(timeout).min(usual));
        pairs.push((joints, arm.queries().call_within(&KineForward::new(joints), left)?.pose));
    }
    let fit = model.fit(&pairs, Tolerance::default());
    let frames = fit.map_err(|source| arm.attach(ErrorKind::ModelMismatch { source }))?.frames;
    Ok((frames, frame_changes))
}

fn not_checked(arm: &Arm, command: &str, reason: Unchecked) -> Error {
    arm.attach(ErrorKind::NotChecked { command: command.to_owned(), reason })
}

fn beyond_limit(arm: &Arm, command: &str, beyond: Beyond) -> Error {
    arm.attach(ErrorKind::BeyondLimit { command: command.to_owned(), beyond })
}

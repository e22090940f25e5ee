//! A motion, checked on its whole way.

use std::time::Duration;

use jaka_motion::{Beyond, JointPace, TcpPace};
use jaka_proto::CommandInfo;
use jaka_proto::messages::kinematics::KineInverse;
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_sync::layer::ClientParts as _;

use crate::error::Attach as _;
use crate::robot::batch::Begin;
use crate::robot::target::{Place, Quantity};
use crate::{Error, ErrorKind, Motion, MotionStatus, Path, Robot, Target, Unchecked};

impl<S: MotionStatus> Robot<S> {
    /// The joint positions at which a motion will end, where it has limits and is within them.
    pub(in crate::robot) fn check_limits<M: Motion>(
        &mut self,
        motion: &M,
        begin: &Begin,
        timeout: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        if let Some(limited) = &mut self.checks.0 {
            limited.warning = None;
        } else {
            return Ok(None);
        }
        let way = (motion.target(), motion.path(), motion.tolerance());
        match self.end_within_limits(M::INFO, way, begin, timeout) {
            Ok(end) => Ok(end),
            Err(error) => self.judged(error).map(|()| None),
        }
    }

    fn end_within_limits(
        &mut self,
        info: &'static CommandInfo,
        (target, path, tolerance_mm): (Target, Path, f64),
        begin: &Begin,
        timeout: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let since = self.clock().stopwatch();
        let from = self.start_of_motion(info, begin, timeout)?;
        let Some(checker) = self.limits() else { return Ok(None) };
        if path == Path::Unknown {
            return Err(self.not_checked(info.name, Unchecked::Path));
        }
        let start = match target.start_quantity() {
            Some(Quantity::Pose) => Place::Pose(checker.frames().pose(checker.limits().model().forward(from))),
            _ => Place::Joints(from),
        };
        let Some(end) = target.from(Some(start)) else {
            return Err(self.not_checked(info.name, Unchecked::Target));
        };
        let tcp_pace = |speed_mm_s| TcpPace { speed_mm_s, tolerance_mm };
        let within = match (end, path) {
            (Place::Joints(to), Path::Joints { speed, acceleration }) => {
                let pace = JointPace { speed_deg_s: speed, acceleration_deg_s2: acceleration };
                checker.check_joint_way(from, to, pace).map(|()| Some(to))
            }
            (Place::Pose(to), Path::Joints { speed, acceleration }) => {
                let pace = JointPace { speed_deg_s: speed, acceleration_deg_s2: acceleration };
                return self.check_end_move(info, from, to, pace, since.left_of(timeout));
            }
            (Place::Pose(to), Path::Line { speed, .. }) => checker.check_line(from, to, tcp_pace(speed)).map(Some),
            (Place::Pose(to), Path::Arc { through, speed, .. }) => {
                checker.check_arc(from, through, to, tcp_pace(speed)).map(Some)
            }
            _ => return Err(self.not_checked(info.name, Unchecked::Path)),
        };
        within.map_err(|beyond| self.beyond_limit(info.name, beyond))
    }

    /// A pose that is reached by a motion of the joints: on the branch that the controller says, or, where it says none, on each.
    fn check_end_move(
        &mut self,
        info: &'static CommandInfo,
        from: JointPosition,
        to: Pose,
        pace: JointPace,
        timeout: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let chosen = self.client.call_within(&KineInverse::new(from, to), timeout);
        let Some(limited) = &self.checks.0 else { return Ok(None) };
        let checker = &limited.checker;
        let within = match chosen {
            Ok(chosen) if limited.agrees(chosen.joint_position, to) => {
                let end = chosen.joint_position;
                checker.check_joint_way(from, end, pace).map(|()| Some(end))
            }
            Err(error) if !error.is_refused() => return Err(error.into()),
            // It says none, or one that is elsewhere.
            _ => checker.check_end_move(from, to, pace).map(|()| None),
        };
        within.map_err(|beyond| self.beyond_limit(info.name, beyond))
    }

    /// Where the arm is when the motion begins.
    fn start_of_motion(
        &mut self,
        info: &'static CommandInfo,
        begin: &Begin,
        timeout: Duration,
    ) -> Result<JointPosition, Error> {
        if self.has_motions() {
            let (changes, stops) = (self.client.link().frame_changes(), self.client.link().stop_count());
            let Some(limited) = &self.checks.0 else { return Err(self.not_checked(info.name, Unchecked::Start)) };
            return match limited.planned {
                _ if limited.frame_changes != changes => Err(self.not_checked(info.name, Unchecked::FramesInQueue)),
                Some(planned) if limited.stops == stops => Ok(planned),
                _ => Err(self.not_checked(info.name, Unchecked::Start)),
            };
        }
        let since = self.clock().stopwatch();
        let left = || since.left_of(timeout);
        self.settle(info, timeout)?;
        let joints = match begin.start {
            Some(Place::Joints(joints)) => Some(Place::Joints(joints)),
            // It was found to be at rest.
            Some(Place::Pose(_)) => self.place(Quantity::Joints, left())?,
            None => self.place_at_rest(Quantity::Joints, left())?,
        };
        let pose = self.place(Quantity::Pose, left())?;
        let (Some(Place::Joints(joints)), Some(Place::Pose(pose))) = (joints, pose) else {
            return Err(self.not_checked(info.name, Unchecked::Start));
        };
        self.follow_frames(joints, pose, info.name, left())?;
        Ok(joints)
    }

    /// After motions that were given up, which the arm may begin only now: it has to rest for as long as a motion may take to begin.
    fn settle(&mut self, info: &'static CommandInfo, timeout: Duration) -> Result<(), Error> {
        if !self.checks.0.as_ref().is_some_and(|limited| limited.is_unsettled) {
            return Ok(());
        }
        let rests = self.place_still_for(Quantity::Joints, self.grace.time, timeout)?.is_some();
        if !rests {
            return Err(self.not_checked(info.name, Unchecked::Start));
        }
        if let Some(limited) = &mut self.checks.0 {
            limited.is_unsettled = false;
        }
        Ok(())
    }

    pub(super) fn beyond_limit(&self, command: &str, beyond: Beyond) -> Error {
        self.client.link().attach(ErrorKind::BeyondLimit { command: command.to_owned(), beyond }.into())
    }
}

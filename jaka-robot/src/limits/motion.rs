//! A motion, checked on its whole path.

use std::time::Duration;

use jaka_clock::Stopwatch;
use jaka_motion::{JointSpeed, TcpSpeed};
use jaka_proto::messages::kinematics::KineInverse;
use jaka_proto::messages::types::{JointPosition, Pose};

use super::{LimitChecks, Limited, beyond_limit, not_checked};
use crate::arm::Arm;
use crate::motions::PlannedMotion;
use crate::place::{Place, Quantity};
use crate::{Error, Path, Unchecked};

/// Start of a motion, as far as it is known.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Beginning {
    /// End of the motions that have not been waited for.
    InQueue,
    /// Present place of the arm: by a query that has found it at rest, if there was one.
    AtRest(Option<Place>),
}

/// Check of one motion.
struct Check<'a> {
    arm: &'a mut Arm,
    limited: &'a mut Limited,
    /// `cmdName` of the motion.
    command: &'static str,
    since: Stopwatch,
    timeout: Duration,
}

impl LimitChecks {
    /// The joint positions at which a motion will end, where the robot has limits and it is within them. After motions
    /// that were given up the arm must rest for the time of `settling`.
    pub(crate) fn check_motion(
        &mut self,
        arm: &mut Arm,
        motion: PlannedMotion<'_>,
        beginning: Beginning,
        (settling, timeout): (Duration, Duration),
    ) -> Result<Option<JointPosition>, Error> {
        let Some(limited) = &mut self.0 else { return Ok(None) };
        let since = arm.clock().stopwatch();
        let mut check = Check { arm, limited, command: motion.info.name, since, timeout };
        check.start(beginning, settling).and_then(|from| check.end(motion, from))
    }
}

impl Check<'_> {
    fn left(&self) -> Duration {
        self.since.left_of(self.timeout)
    }

    fn not_checked(&self, reason: Unchecked) -> Error {
        not_checked(self.arm, self.command, reason)
    }

    /// The joint positions at which a motion ends that begins at these.
    fn end(&mut self, motion: PlannedMotion<'_>, from: JointPosition) -> Result<Option<JointPosition>, Error> {
        let PlannedMotion { target, path, tolerance_mm, .. } = motion;
        if path == Path::Unknown {
            return Err(self.not_checked(Unchecked::Path));
        }
        let checker = &self.limited.checker;
        let start = match Quantity::of_start(target) {
            Some(Quantity::Pose) => Place::Pose(checker.frames().pose(checker.limits().model().forward(from))),
            _ => Place::Joints(from),
        };
        let Some(end) = Place::of(target, Some(start)) else {
            return Err(self.not_checked(Unchecked::Target));
        };
        let tcp_pace = |speed_mm_s| TcpSpeed { speed_mm_s, tolerance_mm };
        let within = match (end, path) {
            (Place::Joints(to), Path::Joints { speed, acceleration }) => {
                let asked = JointSpeed { speed_deg_s: speed, acceleration_deg_s2: acceleration };
                checker.check_joint_way(from, to, asked).map(|()| Some(to))
            }
            (Place::Pose(to), Path::Joints { speed, acceleration }) => {
                let asked = JointSpeed { speed_deg_s: speed, acceleration_deg_s2: acceleration };
                return self.end_at_pose(from, to, asked);
            }
            (Place::Pose(to), Path::Line { speed, .. }) => checker.check_line(from, to, tcp_pace(speed)).map(Some),
            (Place::Pose(to), Path::Arc { through, speed, .. }) => {
                checker.check_arc(from, through, to, tcp_pace(speed)).map(Some)
            }
            _ => return Err(self.not_checked(Unchecked::Path)),
        };
        within.map_err(|beyond| beyond_limit(self.arm, self.command, beyond))
    }

    /// A pose as the target of a joint motion: on the branch that the controller reports, or on each branch without a
    /// report.
    fn end_at_pose(
        &mut self,
        from: JointPosition,
        to: Pose,
        asked: JointSpeed,
    ) -> Result<Option<JointPosition>, Error> {
        let timeout = self.left();
        let chosen = self.arm.queries().call_within(&KineInverse::new(from, to), timeout);
        let checker = &self.limited.checker;
        let within = match chosen {
            Ok(chosen) if self.limited.agrees(chosen.joint_position, to) => {
                let end = chosen.joint_position;
                checker.check_joint_way(from, end, asked).map(|()| Some(end))
            }
            Err(error) if !error.is_refused() => return Err(error.into()),
            // It says none, or one that is elsewhere.
            _ => checker.check_end_move(from, to, asked).map(|()| None),
        };
        within.map_err(|beyond| beyond_limit(self.arm, self.command, beyond))
    }

    /// Joint positions of the arm at the start of the motion.
    fn start(&mut self, beginning: Beginning, settling: Duration) -> Result<JointPosition, Error> {
        let found = match beginning {
            Beginning::InQueue => return self.start_in_queue(),
            Beginning::AtRest(found) => found,
        };
        self.settle(settling)?;
        let left = self.left();
        let position = &mut self.arm.position;
        let joints = match found {
            Some(Place::Joints(joints)) => Some(Place::Joints(joints)),
            // It was found to be at rest.
            Some(Place::Pose(_)) => position.place(Quantity::Joints, left)?,
            None => position.place_at_rest(Quantity::Joints, left)?,
        };
        let left = self.left();
        let pose = self.arm.position.place(Quantity::Pose, left)?;
        let (Some(Place::Joints(joints)), Some(Place::Pose(pose))) = (joints, pose) else {
            return Err(self.not_checked(Unchecked::Start));
        };
        let left = self.left();
        self.limited.follow_frames(self.arm, (joints, pose), self.command, left)?;
        Ok(joints)
    }

    fn start_in_queue(&self) -> Result<JointPosition, Error> {
        let (limited, link) = (&self.limited, self.arm.link());
        let is_as_planned =
            limited.stops == link.stops.begun() && limited.changes_by_others == self.arm.changes_by_others();
        match limited.planned {
            _ if limited.frame_changes != link.frame_changes() => Err(self.not_checked(Unchecked::FramesInQueue)),
            Some(planned) if is_as_planned => Ok(planned),
            _ => Err(self.not_checked(Unchecked::Start)),
        }
    }

    /// After motions that were given up, which the arm may begin only now: it has to rest for as long as a motion may
    /// take to begin.
    fn settle(&mut self, settling: Duration) -> Result<(), Error> {
        if !self.limited.is_unsettled {
            return Ok(());
        }
        let left = self.left();
        if self.arm.position.place_still_for(settling, left)?.is_none() {
            return Err(self.not_checked(Unchecked::Start));
        }
        self.limited.is_unsettled = false;
        Ok(())
    }
}

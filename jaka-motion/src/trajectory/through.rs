//! Trajectories through points without times.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::curve_path::{Begin, CurvePath, Lost};
use super::leg::{Leg, LegPath, SpeedSettings, Tolerances};
use super::line::{Direction, LEAST, LONGEST, Line};
use super::path::Path;
use super::timing::{Timed, timed};
use super::via::{Via, ViaTarget};
use super::{Trajectory, TrajectoryError};
use crate::arc::Arc;
use crate::beyond::{Beyond, Exceeded};
use crate::checker::{Checker, Solved};
use crate::speed::TcpSpeed;
use crate::transform::Transform;

/// A trajectory through points, to be built within an arm's limits. Made by [`Trajectory::through`].
///
/// It starts at the first point, which is joint positions unless [`near`](Self::near) says more, and ends at the last
/// one, at rest. At the points between it goes on, rounding each corner within the tolerances that are named for it:
/// that of joints between ways in joints, that of the tool between lines, and both where a line meets a way in joints.
/// It stops where one of these is not named, and where the way turns back (by more than 177 degrees). Points nearer to
/// each other than a millionth of a degree or millimetre count as one.
///
/// # Timing
/// One speed is planned over the whole way from stop to stop: the quickest, within some percent, with the speeds,
/// accelerations and jerks of the joints and the speed of the tool. Where the way bends, 20 % of each joint's
/// acceleration are left for those who follow it at a rate that changes; elsewhere nothing is, so that a pause that is
/// asked for while the arm brakes begins after that. Of the highest speed of the tool centre point 98 % are planned.
///
/// # Lines
/// The tool centre point is within 0.005 mm of its line, and the tool within 0.001 degrees of its turn, outside of
/// corners. A line takes a piece for each 50 mm or less. On an arc the tool centre point is within 0.01 mm of its
/// circle, and the tool within 0.01 degrees of its turn, which is smoothed where its rate steps at the middle pose.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "nothing is planned before it is built"]
pub struct Through {
    points: Vec<Via>,
    near: Option<JointPosition>,
    tolerances: Tolerances,
    speeds: SpeedSettings,
}

/// Points nearer to each other than this are one, in degrees or mm.
const SAME: f64 = 1e-6;
/// A speed in mm/s that is beyond no joint's: lines are checked for all but it.
const CREEPING: f64 = 1e-6;
/// Joint positions that are further from others than this, in degrees, are of another branch.
const ONE_BRANCH: f64 = 1e-2;

/// Greatest turn of the tool away from its path at the corners of lines, in degrees, if nothing else is said.
const TURN_DEG: f64 = 1.0;

impl Through {
    /// For these points: see [`Trajectory::through`].
    pub(super) fn new(points: Vec<Via>) -> Self {
        Self {
            points,
            near: None,
            tolerances: Tolerances { mm: 0.0, turn_deg: TURN_DEG, joint_deg: 0.0 },
            speeds: SpeedSettings::default(),
        }
    }

    /// With a first point that is a pose: the joint positions of all branches that are nearest to these, such as those
    /// of the arm, reach it. They are the start of the trajectory.
    pub fn near(mut self, joints: impl Into<JointPosition>) -> Self {
        self.near = Some(joints.into());
        self
    }

    /// With the corners of lines rounded within so many millimetres; 0, as if nothing is said, to stop there.
    pub fn corner_mm(mut self, tolerance: f64) -> Self {
        self.tolerances.mm = tolerance;
        self
    }

    /// With the tool within so many degrees of its turn at corners of lines that are rounded; 1 if nothing is said.
    pub fn corner_turn_deg(mut self, tolerance: f64) -> Self {
        self.tolerances.turn_deg = tolerance;
        self
    }

    /// With the corners of ways in joints rounded within so many degrees of each joint; 0, as if nothing is said, to
    /// stop there.
    pub fn corner_deg(mut self, tolerance: f64) -> Self {
        self.tolerances.joint_deg = tolerance;
        self
    }

    /// With this highest speed of the tool centre point, in mm/s, if that of the limits is not lower. If nothing is
    /// said, the limits alone decide, and without one of the tool centre point those of the joints.
    pub fn tcp_speed(mut self, mm_s: f64) -> Self {
        self.speeds.speeds.tcp_speed = mm_s;
        self
    }

    /// With these highest speeds of joints 1 to 6, in deg/s, where those of the limits are not lower.
    pub fn joint_speeds(mut self, deg_s: [f64; 6]) -> Self {
        self.speeds.speeds.joint_speeds = deg_s;
        self
    }

    /// With these highest jerks of joints 1 to 6, in deg/s³, in place of those of the limits.
    pub fn jerks(mut self, deg_s3: [f64; 6]) -> Self {
        self.speeds.jerks = Some(deg_s3);
        self
    }

    /// With this share of each joint's acceleration left where the way bends, from 0 to 0.9, for a pause or another
    /// rate that is asked for there; 0.2 if nothing is said.
    pub fn reserve(mut self, share: f64) -> Self {
        self.speeds.reserve = share;
        self
    }

    /// Plans the trajectory, and compares it with an arm's limits.
    ///
    /// # Errors
    /// What is wrong with the points or settings, or the first place that is beyond a limit. Lines are compared with
    /// joint ranges, regions, the arm's reach and the least distance from singularities before all else.
    pub fn build(&self, checker: &Checker) -> Result<Trajectory, TrajectoryError> {
        self.tolerances.check(["corner_mm", "corner_turn_deg", "corner_deg"])?;
        self.speeds.check()?;
        self.points.iter().try_for_each(Via::check)?;
        let (legs, places) = self.legs(checker)?;
        if legs.is_empty() {
            return Err(TrajectoryError::NoWay);
        }
        let path = Path::of_legs(&legs, checker)?;
        let Timed { pieces, passages, slow } = timed(&path, &self.speeds.budget(checker), checker)?;
        let way_points = places.into_iter().map(|place| passages[place]).collect();
        Trajectory::checked((pieces, way_points, slow), checker)
    }

    /// The legs, and for each point at which of their ends it is.
    fn legs(&self, checker: &Checker) -> Result<(Vec<Leg>, Vec<usize>), TrajectoryError> {
        let (start, rest) = start(&self.points, self.near, checker)?;
        let (mut legs, mut places, mut here) = (Vec::with_capacity(rest.len()), vec![0], Here::of(start));
        for (after, via) in (1..).zip(rest) {
            let leg = match via.target {
                ViaTarget::Joints(there) => here.go(after, there, checker)?,
                ViaTarget::Line(pose) => here.lead(after, pose, checker)?,
                ViaTarget::Arc { middle, end } => Some(here.bend(after, [middle, end], checker)?),
            };
            let corner = via.corner(&self.tolerances);
            legs.extend(leg.map(|leg| Leg { corner, speeds: via.speeds, ..leg }));
            places.push(legs.len());
        }
        Ok((legs, places))
    }
}

/// End of the legs so far.
struct Here {
    joints: [f64; 6],
    /// Joints with the data that a line from there needs; none if no line has led there.
    solved: Option<Solved>,
}

impl Here {
    fn of(joints: JointPosition) -> Self {
        Self { joints: joints.0, solved: None }
    }

    /// The way straight in joint space, if it is one.
    fn go(&mut self, after: usize, there: JointPosition, checker: &Checker) -> Result<Option<Leg>, TrajectoryError> {
        checker.check_place(there).map_err(|beyond| at_point(after + 1, beyond))?;
        let leg = Leg::joints(after, self.joints, there.0);
        Ok((leg.length > SAME).then(|| {
            *self = Self::of(there);
            leg
        }))
    }

    /// The way on a line, if it is one.
    fn lead(&mut self, after: usize, pose: Pose, checker: &Checker) -> Result<Option<Leg>, TrajectoryError> {
        let Some(start) = self.solved.take().or_else(|| checker.arm().at_joints(&self.joints)) else {
            return self.checked_line(after, pose, checker).and_then(|_| Err(TrajectoryError::lost(after, checker)));
        };
        let (direction, length) = Direction::between(&start.tool, &checker.in_base(pose));
        let is_way = length > SAME;
        let is_short = is_way && length <= LONGEST;
        let mut found = if is_short { Line::new(checker, &start, direction, length, length) } else { None };
        if !found.as_ref().is_some_and(|(line, _)| line.is_clear) {
            let end = self.checked_line(after, pose, checker)?;
            if !is_way {
                self.solved = Some(start);
                return Ok(None);
            }
            let is_same = |there: &Solved| end.max_distance(&there.joints.into()) <= ONE_BRANCH;
            let in_parts = || Line::new(checker, &start, direction, length, LEAST * length);
            found = found.or_else(in_parts).filter(|(_, there)| is_same(there));
        }
        let (line, there) = found.ok_or_else(|| TrajectoryError::lost(after, checker))?;
        let leg = Leg::new(after, length, self.joints, LegPath::Tool(line));
        *self = Self { joints: there.joints, solved: Some(there) };
        Ok(Some(leg))
    }

    /// The way on an arc.
    fn bend(&mut self, after: usize, poses: [Pose; 2], checker: &Checker) -> Result<Leg, TrajectoryError> {
        let asked = TcpSpeed { speed_mm_s: CREEPING, tolerance_mm: 0.0 };
        let arrival = checker.check_arc(self.joints.into(), poses[0], poses[1], asked);
        let expected =
            arrival.map_err(|beyond| TrajectoryError::Beyond { after, time_s: None, beyond: Box::new(beyond) })?;
        let lost = || TrajectoryError::lost(after, checker);
        let start = self.solved.take().or_else(|| checker.arm().at_joints(&self.joints)).ok_or_else(lost)?;
        let [middle, end] = poses.map(|pose| Transform(checker.in_base(pose)));
        let arc = Arc::through(Transform(start.tool), middle, end).ok_or_else(lost)?;
        let distances = checker.signed_distances(&start.joints);
        let begin = Begin { checker, start, distances };
        let (path, there) = CurvePath::of_arc(&arc, &begin).map_err(|Lost { exceeded, .. }| {
            TrajectoryError::between(after, checker, exceeded.unwrap_or(Exceeded::NotConfirmed))
        })?;
        if expected.max_distance(&there.joints.into()) > ONE_BRANCH {
            return Err(lost());
        }
        let leg = Leg::new(after, path.length(), self.joints, LegPath::Curve(path));
        *self = Self { joints: there.joints, solved: Some(there) };
        Ok(leg)
    }

    /// The joints at the end of a line, after it was compared with all that it can meet.
    fn checked_line(&self, after: usize, pose: Pose, checker: &Checker) -> Result<JointPosition, TrajectoryError> {
        let asked = TcpSpeed { speed_mm_s: CREEPING, tolerance_mm: 0.0 };
        let there = checker.check_line(self.joints.into(), pose, asked);
        there.map_err(|beyond| TrajectoryError::Beyond { after, time_s: None, beyond: Box::new(beyond) })
    }
}

/// Joint positions at which a trajectory starts, and the points after them.
pub(super) fn start<'p>(
    points: &'p [Via],
    near: Option<JointPosition>,
    checker: &Checker,
) -> Result<(JointPosition, &'p [Via]), TrajectoryError> {
    let [first, rest @ ..] = points else { return Err(TrajectoryError::TooFew { given: 0 }) };
    let start = match (first.target, near) {
        (ViaTarget::Joints(joints), _) => joints,
        (ViaTarget::Line(pose), Some(near)) => checker.joints_at(pose, near).map_err(|beyond| at_point(1, beyond))?,
        (ViaTarget::Line(_), None) | (ViaTarget::Arc { .. }, _) => return Err(TrajectoryError::StartsWithPose),
    };
    if rest.is_empty() {
        return Err(TrajectoryError::TooFew { given: 1 });
    }
    checker.check_place(start).map_err(|beyond| at_point(1, beyond))?;
    Ok((start, rest))
}

pub(super) fn at_point(way_point: usize, beyond: Beyond) -> TrajectoryError {
    TrajectoryError::Place { way_point, beyond: Box::new(beyond) }
}

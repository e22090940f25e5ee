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

/// Trajectory through points, to be built within an arm's limits. Made by [`Trajectory::through`].
///
/// It starts at the first point, which is joint positions unless [`near`](Self::near) is set, and ends at the last one,
/// at rest. At the points between it continues, and rounds each corner within the tolerances set for it: the joints'
/// tolerance between paths in joint space, the tool's tolerance between lines, and both between a line and a path in
/// joint space. It stops at a corner without a tolerance, and at one where the path turns back (by more than 177
/// degrees). Points nearer to each other than a millionth of a degree or millimetre count as one.
///
/// # Timing
/// One speed is planned over the whole path from stop to stop: the quickest, within some percent, with the speeds,
/// accelerations and jerks of the joints and the speed of the tool. On bends of the path, 20 % of each joint's
/// acceleration are left for changes of the rate. Elsewhere nothing is left, so a pause that is requested while the arm
/// brakes begins after the braking. 98 % of the highest speed of the tool centre point are planned.
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

/// Distance below which two points are one, in degrees or mm.
const SAME: f64 = 1e-6;
/// Speed in mm/s that exceeds no joint's speed: lines are checked against all other limits.
const CREEPING: f64 = 1e-6;
/// Distance between joint positions, in degrees, above which they are of different branches.
const ONE_BRANCH: f64 = 1e-2;

/// Default turn of the tool away from its path at the corners of lines, in degrees.
const TURN_DEG: f64 = 1.0;

impl Through {
    /// Creates a trajectory through these points: see [`Trajectory::through`].
    pub(super) fn new(points: Vec<Via>) -> Self {
        Self {
            points,
            near: None,
            tolerances: Tolerances { mm: 0.0, turn_deg: TURN_DEG, joint_deg: 0.0 },
            speeds: SpeedSettings::default(),
        }
    }

    /// Sets joint positions near the start, such as those of the arm, for a first point that is a pose. The trajectory
    /// starts at the joint positions for this pose that are, of all branches, nearest to these.
    pub fn near(mut self, joints: impl Into<JointPosition>) -> Self {
        self.near = Some(joints.into());
        self
    }

    /// Sets the tolerance for rounded corners of lines, in millimetres; 0, the default, for a stop there.
    pub fn corner_mm(mut self, tolerance: f64) -> Self {
        self.tolerances.mm = tolerance;
        self
    }

    /// Sets the tolerance for the tool's turn at rounded corners of lines, in degrees; 1 by default.
    pub fn corner_turn_deg(mut self, tolerance: f64) -> Self {
        self.tolerances.turn_deg = tolerance;
        self
    }

    /// Sets the tolerance for rounded corners of paths in joint space, in degrees of each joint; 0, the default, for a
    /// stop there.
    pub fn corner_deg(mut self, tolerance: f64) -> Self {
        self.tolerances.joint_deg = tolerance;
        self
    }

    /// Sets the highest speed of the tool centre point, in mm/s. A lower speed of the limits takes precedence. By
    /// default only the limits apply, and without one for the tool centre point only those of the joints.
    pub fn tcp_speed(mut self, mm_s: f64) -> Self {
        self.speeds.speeds.tcp_speed = mm_s;
        self
    }

    /// Sets the highest speeds of joints 1 to 6, in deg/s. Lower speeds of the limits take precedence.
    pub fn joint_speeds(mut self, deg_s: [f64; 6]) -> Self {
        self.speeds.speeds.joint_speeds = deg_s;
        self
    }

    /// Sets the highest jerks of joints 1 to 6, in deg/s³ from 0.001 to 1e9; they replace those of the limits.
    pub fn jerks(mut self, deg_s3: [f64; 6]) -> Self {
        self.speeds.jerks = Some(deg_s3);
        self
    }

    /// Sets the share of each joint's acceleration, from 0 to 0.9, that bends of the path leave for a pause or another
    /// rate; 0.2 by default.
    pub fn reserve(mut self, share: f64) -> Self {
        self.speeds.reserve = share;
        self
    }

    /// Plans the trajectory, and compares it with an arm's limits.
    ///
    /// # Errors
    /// Invalid points or settings, or the first place that is beyond a limit. Lines are compared with joint ranges,
    /// regions, the arm's reach and the least distance from singularities before everything else.
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

    /// Returns the legs, and for each point the number of legs before it.
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
    /// Solution for these joints, if it is known already; the next line starts from it.
    solved: Option<Solved>,
}

impl Here {
    fn of(joints: JointPosition) -> Self {
        Self { joints: joints.0, solved: None }
    }

    /// Returns the straight path in joint space, unless it has no length.
    fn go(&mut self, after: usize, there: JointPosition, checker: &Checker) -> Result<Option<Leg>, TrajectoryError> {
        checker.check_place(there).map_err(|beyond| at_point(after + 1, beyond))?;
        let leg = Leg::joints(after, self.joints, there.0);
        Ok((leg.length > SAME).then(|| {
            *self = Self::of(there);
            leg
        }))
    }

    /// Returns the path on a line, unless it has no length.
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

    /// Returns the path on an arc.
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

    /// Returns the joints at the end of a line, after a check against all limits except the joints' speeds.
    fn checked_line(&self, after: usize, pose: Pose, checker: &Checker) -> Result<JointPosition, TrajectoryError> {
        let asked = TcpSpeed { speed_mm_s: CREEPING, tolerance_mm: 0.0 };
        let there = checker.check_line(self.joints.into(), pose, asked);
        there.map_err(|beyond| TrajectoryError::Beyond { after, time_s: None, beyond: Box::new(beyond) })
    }
}

/// Returns the joint positions at which a trajectory starts, and the points after them.
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

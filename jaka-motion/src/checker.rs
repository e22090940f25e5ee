//! Motions compared with limits.

mod amounts;
#[cfg(feature = "generator")]
mod branch;
mod clear;
mod end_move;
mod follow;
mod joint_way;
mod landing;
mod led;
mod pace;
mod path;
mod piece_end;
mod pieces;
mod points;
mod set_point;
mod singularities;
mod solve;
#[cfg(feature = "generator")]
mod stops;
#[cfg(feature = "generator")]
mod tool_rates;

use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::Isometry3;

pub(crate) use self::led::Led;
pub use self::pace::{JointPace, TcpPace};
use self::points::{POINTS, radii};
pub(crate) use self::solve::Solved;
#[cfg(feature = "generator")]
pub(crate) use self::stops::longest;
use crate::beyond::{Beyond, Exceeded, Found, Way};
use crate::frames::Frames;
use crate::limits::Limits;
use crate::transform::Transform;

/// Compares motions with the limits of an arm, before they are sent.
///
/// # What is promised
/// What is beyond a limit by more than the stated amount ([`AMOUNT_MM`](Self::AMOUNT_MM), [`AMOUNT_DEG`](Self::AMOUNT_DEG),
/// [`AMOUNT_SPEED`](Self::AMOUNT_SPEED), [`AMOUNT_SINGULARITY`](Self::AMOUNT_SINGULARITY)) anywhere on the way is refused, however short the time for
/// which it is. What is within all limits is not refused, unless it comes nearer to a singularity than the least distance and
/// [`AMOUNT_SINGULARITY`](Self::AMOUNT_SINGULARITY) more: there the joints may turn so fast that they are not found.
/// The speeds of a set-point are means over its period.
///
/// # A start beyond a limit
/// A motion that starts beyond a joint's range or a region, or too near to a singularity, may lead back but not further out: for
/// that motion the limit is where the start is. Speeds, accelerations and a tolerance have no such exception: a line or an arc is refused that
/// starts nearer to the border of a region than its tolerance.
///
/// # What is assumed of the controller
/// - `joint_move` and `end_move` are straight in joint space. The joint with the longest way has the speed and the acceleration that are
///   requested, the others less in proportion.
/// - On a line or an arc the tool centre point has the speed that is requested, in mm/s along its way, and the tool turns evenly.
/// - Joint positions change continuously on a line or an arc, from those at its start.
/// - The model, the tool, the user frame and the mounting are those that the controller has; [`Model::fit`](crate::Model::fit) compares them.
///
/// No source shows that each controller does so. Accelerations along lines and arcs are not compared with those of the joints.
///
/// # What it is not
/// It is no fence and no safety function, and has no model of collisions of the arm with itself or the cell.
///
/// Nothing here allocates, and no input makes it panic.
#[derive(Debug, Clone, PartialEq)]
pub struct Checker {
    limits: Limits,
    frames: Frames,
    /// The arm's base, seen from the user frame.
    base: Isometry3<f64>,
    /// The tool, seen from the flange.
    tool: Isometry3<f64>,
    /// The most that each of [`POINTS`] can be away from the axis of each joint, in mm; 0 for a joint that does not move it.
    radii: [[f64; 6]; 3],
}

impl Checker {
    /// For an arm with these limits, and this tool, user frame and mounting.
    pub fn new(limits: Limits, frames: Frames) -> Self {
        let tool = frames.tool().0;
        let radii = POINTS.map(|point| radii(&limits.model().links, point, &tool.translation.vector));
        Self { limits, frames, base: frames.base().0, tool, radii }
    }

    /// With another tool, user frame or mounting.
    #[must_use]
    pub fn with_frames(self, frames: Frames) -> Self {
        Self::new(self.limits, frames)
    }

    /// The limits.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Tool, user frame and mounting.
    pub fn frames(&self) -> &Frames {
        &self.frames
    }

    /// Checks joint ranges and regions at one place.
    pub fn check_place(&self, joints: JointPosition) -> Result<(), Beyond> {
        self.checked(Way::Place, &[joints], &[], || self.place(&joints.0).map_err(|exceeded| (exceeded, 1.0)))
    }

    /// Checks a way straight in joint space, as that of `joint_move` (section 4.7): joint ranges, joint speeds and accelerations, the speed of the tool
    /// centre point, and regions.
    pub fn check_joint_way(&self, from: JointPosition, to: JointPosition, pace: JointPace) -> Result<(), Beyond> {
        self.checked(Way::JointWay, &[from, to], &[], || self.joint_way(&from.0, &to.0, pace))
    }

    /// Checks a straight line of the tool centre point, as that of `moveL` (section 4.9), and returns the joint positions at its end.
    ///
    /// Joint ranges, joint speeds at the requested speed, the speed of the tool centre point, regions, and the distance from
    /// singularities. The tool turns evenly about one axis. A line shorter than 0.1 mm only turns: how a controller means its speed then is not
    /// known, so joint speeds are not checked on it, and all the rest is.
    pub fn check_line(&self, from: JointPosition, to: Pose, pace: TcpPace) -> Result<JointPosition, Beyond> {
        self.checked(Way::Line, &[from], &[to], || self.line(&from.0, self.in_base(to), pace)).map(JointPosition)
    }

    /// Checks an arc of the tool centre point, as that of `movc` (section 4.10), as [`check_line`](Self::check_line) checks a line.
    ///
    /// The tool turns evenly from the start to the middle pose, and from there to the end.
    pub fn check_arc(&self, from: JointPosition, mid: Pose, end: Pose, pace: TcpPace) -> Result<JointPosition, Beyond> {
        let check = || self.arc(&from.0, [self.in_base(mid), self.in_base(end)], pace);
        self.checked(Way::Arc, &[from], &[mid, end], check).map(JointPosition)
    }

    /// Checks each way that the controller may choose for `end_move` (section 4.8).
    ///
    /// The controller does not know these limits. So each branch within the arm's published ranges must be within them; where the controller's
    /// `kine_inverse` (section 4.45) says which it takes, [`check_joint_way`](Self::check_joint_way) checks that one. A joint that can turn more
    /// than once is taken to go to the nearest of the positions that reach the pose.
    pub fn check_end_move(&self, from: JointPosition, to: Pose, pace: JointPace) -> Result<(), Beyond> {
        self.checked(Way::EndMove, &[from], &[to], || self.end_move(&from.0, to, pace))
    }

    /// Checks a set-point of joint positions, after the last two and a period in seconds later.
    ///
    /// `before` are the last but one and the last; both are where the arm is when a session starts. Joint ranges, the joints' mean speed over the
    /// period and the change of it, the mean speed of the tool centre point over the period, and regions, also on the way from the last one.
    /// Within the period the tool centre point can be faster than in the mean: it goes on a bend, of which the straight way is shorter.
    ///
    /// And there must be room to stop. After the set-point the arm could land straight on in joint space, all joints in proportion, in the N
    /// periods in which the joint that takes the longest slows down as much as it may: by steps of the set-point's own times 1 - k/N. Joint ranges and
    /// regions hold on that way too. For example, 175 deg/s at 300 deg/s² take 51 degrees.
    pub fn check_set_point(
        &self,
        before: [JointPosition; 2],
        target: JointPosition,
        period_s: f64,
    ) -> Result<(), Beyond> {
        let check = || self.set_point([&before[0].0, &before[1].0], &target.0, period_s);
        self.checked(Way::SetPoint, &[before[0], before[1], target], &[], check)
    }

    /// Checks a set-point that is a pose, as [`check_set_point`](Self::check_set_point), with the distance from singularities, and returns the
    /// joint positions nearest to the last ones that reach it. One on the other side of a singularity is refused, unless the least distance
    /// is 0.
    pub fn check_pose_set_point(
        &self,
        before: [JointPosition; 2],
        target: Pose,
        period_s: f64,
    ) -> Result<JointPosition, Beyond> {
        let check = || self.pose_set_point([&before[0].0, &before[1].0], &self.in_base(target), period_s);
        self.checked(Way::SetPoint, &before, &[target], check).map(JointPosition)
    }

    /// A pose of the tool, seen from the arm's base.
    pub(crate) fn in_base(&self, pose: Pose) -> Isometry3<f64> {
        self.base.inverse() * Transform::from(pose).0
    }

    /// The tool in the arm's base.
    pub(crate) fn tcp(&self, joints: &[f64; 6]) -> Isometry3<f64> {
        self.limits.model().links.flange(joints) * self.tool
    }

    /// What a check of a way finds, if all of its numbers are finite.
    fn checked<T>(
        &self,
        way: Way,
        joints: &[JointPosition],
        poses: &[Pose],
        check: impl FnOnce() -> Result<T, Found>,
    ) -> Result<T, Beyond> {
        let found = if self.all_finite(joints, poses) { check() } else { Err((Exceeded::NotFinite, 0.0)) };
        found.map_err(|(exceeded, share)| Beyond { share, ..self.beyond_of(way, exceeded) })
    }

    fn all_finite(&self, joints: &[JointPosition], poses: &[Pose]) -> bool {
        let frame = |frame: &Isometry3<f64>| {
            frame.translation.vector.iter().chain(frame.rotation.coords.iter()).all(|number| number.is_finite())
        };
        joints.iter().all(|joints| joints.0.iter().all(|joint| joint.is_finite()))
            && poses.iter().all(|pose| frame(&self.in_base(*pose)))
            && frame(&self.base)
            && frame(&self.tool)
    }

    /// What is exceeded at the end of a way.
    pub(crate) fn beyond_of(&self, way: Way, exceeded: Exceeded) -> Beyond {
        Beyond { exceeded, way, share: 1.0, model: self.limits.model().name() }
    }
}

/// A limit, and what rounding adds to a number that is at it.
fn rounded_up(limit: f64) -> f64 {
    limit * (1.0 + 1e-9)
}

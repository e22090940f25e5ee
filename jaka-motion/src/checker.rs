//! Checks of motions against limits.

mod arm;
mod follow;
mod limited_points;
mod path;
mod placed_regions;
mod radii;
mod solved;
mod tcp_speed;

use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::Isometry3;
#[cfg(feature = "generator")]
use nalgebra::{UnitQuaternion, Vector3, Vector6};

pub(crate) use self::arm::Arm;
use self::follow::Following;
use self::limited_points::LimitedPoints;
use self::limited_points::RoomToStop;
use self::path::ToolPath;
use self::placed_regions::PlacedRegions;
use self::radii::PieceEnd;
pub(crate) use self::solved::Solved;
use self::tcp_speed::TcpSpeedLimit;
use crate::arc::Arc;
use crate::beyond::{Beyond, Exceeded, Found, Way};
#[cfg(feature = "generator")]
use crate::braking::Stop;
use crate::braking::{StopRates, StraightStop};
use crate::frames::Frames;
use crate::limits::Limits;
#[cfg(feature = "generator")]
use crate::limits::SingularityClearance;
use crate::model::Point;
use crate::piece::Piece;
use crate::speed::{JointSpeed, TcpSpeed, above_zero, longest};
#[cfg(feature = "generator")]
use crate::speed::{TcpVelocity, VelocityFrame};
use crate::transform::Transform;

/// Compares motions with the limits of an arm before they are sent.
///
/// # What is promised
/// Refuses a motion that is beyond a limit by more than the stated amount ([`AMOUNT_MM`](Self::AMOUNT_MM),
/// [`AMOUNT_DEG`](Self::AMOUNT_DEG), [`AMOUNT_SPEED`](Self::AMOUNT_SPEED),
/// [`AMOUNT_SINGULARITY`](Self::AMOUNT_SINGULARITY)) anywhere on its path, for however short a time. Accepts a motion
/// that is within all limits, unless it comes nearer to a singularity than the least distance and
/// [`AMOUNT_SINGULARITY`](Self::AMOUNT_SINGULARITY) more: there the joints may turn so fast that the checker does not
/// find them. The speeds of a set-point are means over its period.
///
/// # A start beyond a limit
/// A motion that starts beyond a joint's range or a region, or too near to a singularity, may return but not go further
/// out: for this motion the start is the limit. Speeds, accelerations and a tolerance have no such exception. A line or
/// an arc is refused if it starts nearer to the border of a region than its tolerance.
///
/// # Assumptions about the controller
/// - `joint_move` and `end_move` are straight in joint space. The joint with the longest path has the requested speed
///   and acceleration, the others less in proportion.
/// - On a line or an arc the tool centre point has the requested speed, in mm/s along its path, and the tool turns
///   evenly.
/// - Joint positions change continuously on a line or an arc, from those at its start.
/// - The controller has this model, tool, user frame and mounting; [`Model::fit`](crate::Model::fit) compares them.
///
/// No source shows that every controller does so. Accelerations along lines and arcs are not compared with those of the
/// joints.
///
/// # Limitations
/// The checker is no fence and no safety function, and has no model of collisions of the arm with itself or the cell.
///
/// It does not allocate, and no input makes it panic.
#[derive(Debug, Clone, PartialEq)]
pub struct Checker {
    limits: Limits,
    frames: Frames,
    /// Base of the arm, seen from the user frame.
    base: Isometry3<f64>,
    /// Model of the limits with the tool of the frames.
    arm: Arm,
}

/// Planned share of the permitted acceleration of the tool centre point in a stop. The rest covers changes of the
/// tool's speed between the sampled places.
const TOOL_USED: f64 = 0.98;
/// Shares of the path to rest at which the speed of the tool is sampled.
const PLACES_TO_REST: [f64; 3] = [0.25, 0.55, 0.9];

/// Amounts by which a motion may exceed a limit without notice, somewhere between the computed places on its path.
impl Checker {
    /// Greatest distance beyond a region that may go unnoticed, in mm; the checker refuses a greater one.
    pub const AMOUNT_MM: f64 = 1.0;

    /// Greatest angle beyond a joint's range that may go unnoticed, in degrees; the checker refuses a greater one.
    pub const AMOUNT_DEG: f64 = 0.1;

    /// Greatest excess over a speed limit that may go unnoticed, as a share of the limit; the checker refuses a greater
    /// one. The speeds of set-points are means over the period.
    pub const AMOUNT_SPEED: f64 = 0.02;

    /// Greatest amount by which the distance from a singularity may be below the least distance without notice; the
    /// checker refuses a greater one. It has no unit.
    pub const AMOUNT_SINGULARITY: f64 = 0.002;
}

impl Checker {
    /// Creates a checker for an arm with these limits, and this tool, user frame and mounting.
    pub fn new(limits: Limits, frames: Frames) -> Self {
        let arm = Arm::new(limits.model(), frames.tool().0);
        Self { limits, frames, base: frames.base().0, arm }
    }

    /// Replaces the tool, the user frame and the mounting.
    #[must_use]
    pub fn with_frames(self, frames: Frames) -> Self {
        Self::new(self.limits, frames)
    }

    /// Returns the limits.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Returns the tool, the user frame and the mounting.
    pub fn frames(&self) -> &Frames {
        &self.frames
    }

    /// Checks joint ranges and regions at one place.
    pub fn check_place(&self, joints: JointPosition) -> Result<(), Beyond> {
        self.checked(Way::Place, &[joints], &[], || self.place(&joints.0).map_err(|exceeded| (exceeded, 1.0)))
    }

    /// Checks a straight path in joint space, such as that of `joint_move` (section 4.7): joint ranges, joint speeds
    /// and accelerations, the speed of the tool centre point, and regions.
    pub fn check_joint_way(&self, from: JointPosition, to: JointPosition, asked: JointSpeed) -> Result<(), Beyond> {
        self.checked(Way::JointWay, &[from, to], &[], || self.joint_way(&from.0, &to.0, asked))
    }

    /// Checks a straight line of the tool centre point, such as that of `moveL` (section 4.9), and returns the joint
    /// positions at its end.
    ///
    /// It checks joint ranges, joint speeds at the requested speed, the speed of the tool centre point, regions, and
    /// the distance from singularities. The tool turns evenly about one axis. A line shorter than 0.1 mm only turns the
    /// tool. The controller's meaning of its speed is then not known, so joint speeds are not checked on such a line;
    /// all the rest is.
    pub fn check_line(&self, from: JointPosition, to: Pose, asked: TcpSpeed) -> Result<JointPosition, Beyond> {
        let path = || ToolPath::Line { from: Transform(self.arm.tcp(&from.0)), to: Transform(self.in_base(to)) };
        self.checked(Way::Line, &[from], &[to], || self.follow(&from.0, path(), asked)).map(JointPosition)
    }

    /// Checks an arc of the tool centre point, such as that of `movc` (section 4.10), as
    /// [`check_line`](Self::check_line) checks a line.
    ///
    /// The tool turns evenly from the start to the middle pose, and from there to the end.
    pub fn check_arc(
        &self,
        from: JointPosition,
        mid: Pose,
        end: Pose,
        asked: TcpSpeed,
    ) -> Result<JointPosition, Beyond> {
        let check = || {
            let [mid, end] = [mid, end].map(|pose| Transform(self.in_base(pose)));
            let arc = Arc::through(Transform(self.arm.tcp(&from.0)), mid, end);
            self.follow(&from.0, ToolPath::Arc(arc.ok_or((Exceeded::NoArc, 0.0))?), asked)
        };
        self.checked(Way::Arc, &[from], &[mid, end], check).map(JointPosition)
    }

    /// Checks each path that the controller may choose for `end_move` (section 4.8).
    ///
    /// The controller does not know these limits. So each branch within the arm's published ranges must be within them.
    /// If the controller's `kine_inverse` (section 4.45) names its branch, [`check_joint_way`](Self::check_joint_way)
    /// checks that branch alone. For a joint that can turn more than once, the check assumes the nearest of the
    /// positions that reach the pose.
    pub fn check_end_move(&self, from: JointPosition, to: Pose, asked: JointSpeed) -> Result<(), Beyond> {
        self.checked(Way::EndMove, &[from], &[to], || {
            let branches = self.limits.model().inverse_all(self.arm.flange(&self.in_base(to)), from);
            let branches = branches.map_err(|reason| (reason.into(), 1.0))?;
            branches.iter().try_for_each(|joints| self.joint_way(&from.0, &joints.0, asked))
        })
    }

    /// Checks a set-point of joint positions that follows the last two by a period, in seconds.
    ///
    /// `before` has the last but one and the last set-point; at the start of a session both are the arm's position. It
    /// checks joint ranges, the joints' mean speed over the period and its change, the mean speed of the tool centre
    /// point over the period, and regions, also on the path from the last set-point. Within the period the tool centre
    /// point can be faster than the mean, since its path is a curve, longer than the straight line.
    ///
    /// A joint that slows down may do so with the acceleration of stops ([`Limits::stop_accelerations`]).
    ///
    /// The arm must also have room to stop, straight on in joint space by [`straight_stop`](Self::straight_stop). Joint
    /// ranges and regions hold on that path too. For example, a stop from 175 deg/s at 570 deg/s² takes 36 degrees.
    pub fn check_set_point(
        &self,
        before: [JointPosition; 2],
        target: JointPosition,
        period_s: f64,
    ) -> Result<(), Beyond> {
        let check = || self.set_point([&before[0].0, &before[1].0], &target.0, period_s);
        self.checked(Way::SetPoint, &[before[0], before[1], target], &[], check)
    }

    /// Returns the stop straight on in joint space after two set-points, with all joints in proportion. Its steps
    /// become smaller within the accelerations and jerks of stops ([`Limits::stop_accelerations`]), or evenly within
    /// the accelerations of motions if that is shorter.
    pub fn straight_stop(&self, before: [JointPosition; 2], period_s: f64) -> StraightStop {
        let velocity = std::array::from_fn(|index| (before[1].0[index] - before[0].0[index]) / period_s);
        let smooth = self.stop_rates(&before[1].0, &velocity, self.limits.stop_jerks());
        StraightStop::new(smooth, self.limits.axes().motion_share(&velocity), period_s)
    }

    /// Checks a set-point that is a pose, as [`check_set_point`](Self::check_set_point) does, and the distance from
    /// singularities. Returns the joint positions for it that are nearest to the last ones. A pose on the other side of
    /// a singularity is refused, unless the least distance is 0.
    pub fn check_pose_set_point(
        &self,
        before: [JointPosition; 2],
        target: Pose,
        period_s: f64,
    ) -> Result<JointPosition, Beyond> {
        self.checked(Way::SetPoint, &before, &[target], || {
            let (clearance, at_end) = (self.limits.clearance(), |exceeded| (exceeded, 1.0));
            let joints = self.arm.nearest(&self.in_base(target), &before[1].0).map_err(at_end)?;
            self.set_point([&before[0].0, &before[1].0], &joints, period_s)?;
            let [last, here] = [&before[1].0, &joints].map(|joints| self.arm.signed_distances(joints));
            clearance.check(&last.map(f64::abs), &here.map(f64::abs)).map_err(at_end)?;
            clearance.check_sides(&last, &here).map_err(at_end)?;
            Ok(JointPosition(joints))
        })
    }

    /// Finds the joint positions that bring the tool to a pose, nearest to others and on the same sides of the
    /// singularities as these.
    ///
    /// # Errors
    /// The pose is out of reach, no joint positions on this branch reach it, or the joint positions are beyond a
    /// joint's range or a region.
    #[cfg(feature = "generator")]
    pub fn joints_on_branch(&self, near: JointPosition, pose: Pose) -> Result<JointPosition, Beyond> {
        let sides = |joints: &JointPosition| self.arm.signed_distances(&joints.0);
        self.checked(Way::Place, &[near], &[pose], || {
            let (here, at_end) = (sides(&near), |exceeded| (exceeded, 1.0));
            let passed = |joints: &JointPosition| SingularityClearance::passed(&here, &sides(joints));
            let branches = self.limits.model().inverse_all(self.arm.flange(&self.in_base(pose)), near);
            let branches = branches.map_err(|reason| at_end(reason.into()))?;
            let Some(joints) = branches.iter().find(|joints| passed(joints).is_none()) else {
                let which = branches.first().and_then(passed);
                let too_near = which.map(|which| self.limits.clearance().too_near(which, 0.0));
                return Err(at_end(too_near.unwrap_or(Exceeded::NotConfirmed)));
            };
            self.place(&joints.0).map(|()| *joints).map_err(at_end)
        })
    }

    /// Returns the arm with its tool.
    pub(crate) fn arm(&self) -> &Arm {
        &self.arm
    }

    /// Returns the deceleration of a stop along a velocity of the joints in deg/s, reached within these jerks.
    ///
    /// The speed of the tool for this velocity is sampled at some places on the path to rest.
    pub(crate) fn stop_rates(&self, joints: &[f64; 6], velocity: &[f64; 6], jerks: &[f64; 6]) -> StopRates {
        let axes = self.limits.axes();
        let of_joints = axes.stop_rates(velocity, jerks, f64::INFINITY);
        let Some(most) = self.limits.stop_tcp_acceleration().map(|most| TOOL_USED * most) else { return of_joints };
        if self.arm.radii().tcp_rate_at_most(velocity) * of_joints.share <= most {
            return of_joints;
        }
        let rate_at = |length_s: f64| {
            let place = std::array::from_fn(|index| joints[index] + length_s * velocity[index]);
            self.arm.tcp_rate(&place, velocity)
        };
        let here = rate_at(0.0);
        let length_s = axes.stop_rates(velocity, jerks, most / here).length_s();
        let fastest = PLACES_TO_REST.iter().map(|share| rate_at(share * length_s)).fold(here, f64::max);
        axes.stop_rates(velocity, jerks, most / fastest)
    }

    /// Returns a pose of the tool, seen from the arm's base.
    pub(crate) fn in_base(&self, pose: Pose) -> Isometry3<f64> {
        self.base.inverse() * Transform::from(pose).0
    }

    /// Returns a velocity seen from the arm's base, in mm/s and radians a second.
    #[cfg(feature = "generator")]
    pub(crate) fn twist_in_base(&self, velocity: &TcpVelocity, joints: &[f64; 6]) -> Vector6<f64> {
        let turn = match velocity.frame {
            VelocityFrame::ArmBase => UnitQuaternion::identity(),
            VelocityFrame::User => self.base.rotation.inverse(),
            VelocityFrame::Tool => self.arm.tcp(joints).rotation,
        };
        let linear = turn * velocity.linear();
        let angular = turn * Vector3::from(velocity.angular_deg_s.map(f64::to_radians));
        Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
    }

    /// Compares a piece of a trajectory with all limits; the share in an error is of the piece's time. `end` is the end
    /// of the piece before, if known; the call replaces it with the end of this piece.
    pub(crate) fn check_piece(&self, piece: &Piece, end: &mut Option<PieceEnd>) -> Result<(), Found> {
        let (hull, axes, points, stop) = (piece.hull(), self.limits.axes(), self.points(), self.room_to_stop());
        axes.check_piece(piece, &hull)?;
        let (has_regions, stop_s) = (!self.limits.regions().is_empty(), stop.seconds(&hull));
        let mut is_near = false;
        if has_regions || self.limits.tcp_speed().is_some() {
            let [from, to] = piece.ends();
            let ends = [end.take().unwrap_or_else(|| self.arm.piece_end(&from)), self.arm.piece_end(&to)];
            self.tcp_speed().check_piece(piece, &hull, &ends)?;
            is_near = has_regions && !points.are_far(&ends[0], &hull.turned(piece.seconds + stop_s));
            if is_near {
                points.check_piece(piece, &hull)?;
            }
            let [_, last] = ends;
            *end = Some(last);
        }
        if is_near || !axes.contain_for(&hull, stop_s) { stop.check_piece(piece) } else { Ok(()) }
    }

    /// Checks the path from one set-point to the next and from there to rest: joint ranges, regions, and the speed of
    /// the tool centre point as mean over each period. The tool centre point may travel no more than `stopping_mm`. The
    /// position at which the arm has rested, if any, counts as within regions.
    #[cfg(feature = "generator")]
    pub(crate) fn check_stops(
        &self,
        rested: Option<&[f64; 6]>,
        last: &[f64; 6],
        stops: &[Stop; 6],
        (period_s, stopping_mm): (f64, f64),
    ) -> Result<(), Exceeded> {
        self.limits.axes().check_stops(stops)?;
        if !self.limits.regions().is_empty() {
            let next = stops.map(|stop| stop.at(0.0).position);
            self.points().check_joint_way(last, &next).map_err(|(exceeded, _)| exceeded)?;
            self.points().check_stops(rested, stops).map_err(|(exceeded, _)| exceeded.at_stop())?;
        }
        self.tcp_speed().check_stops(last, stops, period_s, stopping_mm)
    }

    /// Whether bounds of the joints show that joint ranges, singularities and regions are clear all along a line with
    /// these ends. If not, [`check_line`](Self::check_line) decides.
    pub(crate) fn is_clear_line(&self, joints: &Piece, ends: [&Solved; 2], distances: &[f64; 3]) -> bool {
        let hull = joints.hull();
        let turned = hull.turned(joints.seconds);
        let at_end = self.arm.distances(&ends[1].frames);
        let between = std::array::from_fn(|index| f64::midpoint(distances[index], at_end[index]));
        self.limits.axes().contain(&hull)
            && self.keeps_apart(&between, &turned.map(|turned| 0.5 * turned))
            && self.points().are_clear_on_line(ends, &turned)
    }

    /// Whether the distances from singularities stay sufficient while the joints turn by at most these radians.
    pub(crate) fn keeps_apart(&self, distances: &[f64; 3], turned: &[f64; 6]) -> bool {
        self.limits.clearance().is_kept(distances, &self.arm.radii().distances_change(turned))
    }

    /// Returns the joint positions for a pose that are, of all branches, nearest to others.
    pub(crate) fn joints_at(&self, pose: Pose, near: JointPosition) -> Result<JointPosition, Beyond> {
        self.checked(Way::Place, &[near], &[pose], || {
            self.arm.nearest(&self.in_base(pose), &near.0).map(JointPosition).map_err(|exceeded| (exceeded, 1.0))
        })
    }

    /// Returns the distances from singularities, with opposite signs on the two sides of one.
    pub(crate) fn signed_distances(&self, joints: &[f64; 6]) -> [f64; 3] {
        self.arm.signed_distances(joints)
    }

    /// Checks that a path of the tool comes no nearer to a singularity than the least distance or the distance at its
    /// start, and that it has passed none since the place before. The distances have signs.
    pub(crate) fn check_apart(&self, start: &[f64; 3], before: &[f64; 3], here: &[f64; 3]) -> Result<(), Exceeded> {
        let clearance = self.limits.clearance();
        clearance.check(&start.map(f64::abs), &here.map(f64::abs))?;
        clearance.check_sides(before, here)
    }

    /// Checks that joint positions between two others are not nearer to a singularity than both of these and the least
    /// distance, up to the stated amount.
    pub(crate) fn no_nearer_to_singularities(&self, ends: [&[f64; 6]; 2], here: &[f64; 6]) -> Result<(), Exceeded> {
        let [one, other, here] = [ends[0], ends[1], here].map(|joints| self.arm.distances(&self.arm.frames(joints)));
        let least = std::array::from_fn(|index| one[index].min(other[index]) - Self::AMOUNT_SINGULARITY);
        self.limits.clearance().check(&least, &here)
    }

    /// Returns the seconds for which the joints can continue at these rates until they meet a limit, and that limit, if
    /// they are fewer than `length`.
    #[cfg(feature = "generator")]
    pub(crate) fn room_along(&self, from: &[f64; 6], rates: &[f64; 6], length: f64) -> Option<(f64, Exceeded)> {
        let (axes, clearance) = (self.limits.axes(), self.limits.clearance());
        let at = |share: f64| std::array::from_fn(|index| from[index] + share * length * rates[index]);
        let regions = self.points().check_joint_way(from, &at(1.0)).err();
        let ranges = (0..6).filter_map(|index| axes.room(index, from[index], rates[index]));
        let start = self.arm.signed_distances(from);
        let singularities = clearance.room(start, |share| self.arm.signed_distances(&at(share)));
        let in_seconds = singularities.map(|(share, exceeded)| (share * length, exceeded));
        let regions = regions.map(|(exceeded, share)| (share * length, exceeded));
        let all = ranges.chain(regions).chain(in_seconds).filter(|(room, _)| *room < length);
        all.min_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// Returns the violation of a limit at the end of a path.
    pub(crate) fn beyond_of(&self, way: Way, exceeded: Exceeded) -> Beyond {
        Beyond { exceeded, way, share: 1.0, model: self.limits.model().name() }
    }

    /// Checks joint ranges and regions.
    fn place(&self, joints: &[f64; 6]) -> Result<(), Exceeded> {
        // No start is beyond the ranges: a place is not a motion that returns into them.
        self.limits.axes().check_positions(joints, self.limits.joint_min())?;
        self.points().check_place(joints)
    }

    fn joint_way(&self, from: &[f64; 6], to: &[f64; 6], asked: JointSpeed) -> Result<(), Found> {
        let (axes, at_end) = (self.limits.axes(), |exceeded| (exceeded, 1.0));
        asked.check().map_err(at_end)?;
        // Each joint turns in one direction, so its range holds between the ends if it holds at both.
        axes.check_positions(to, from).map_err(at_end)?;
        let moved: [f64; 6] = std::array::from_fn(|index| to[index] - from[index]);
        if longest(&moved) > 0.0 {
            axes.check_pace(&moved, asked).map_err(at_end)?;
            self.tcp_speed().check_joint_way(from, &moved, asked)?;
        }
        self.points().check_joint_way(from, to)
    }

    /// Checks a path of the tool, and returns the joint positions at its end.
    fn follow(&self, from: &[f64; 6], path: ToolPath, asked: TcpSpeed) -> Result<[f64; 6], Found> {
        let at_end = |exceeded| (exceeded, 1.0);
        asked.check(self.arm.reach_mm()).map_err(at_end)?;
        self.tcp_speed().check(asked.speed_mm_s).map_err(at_end)?;
        if let Err(unreached @ (Exceeded::OutOfReach { .. } | Exceeded::Orientation)) =
            self.arm.any_branch(&path.at(1.0), from)
        {
            return Err(at_end(unreached));
        }
        let tcp = |share| path.at(share).translation.vector.into();
        self.regions().check_way(Point::Tcp, asked.tolerance_mm, path.motion(), tcp)?;
        Following::new(&self.arm, &self.limits, self.regions(), from, path, asked).follow()
    }

    fn set_point(&self, [before, last]: [&[f64; 6]; 2], target: &[f64; 6], period_s: f64) -> Result<(), Found> {
        let (axes, at_end) = (self.limits.axes(), |exceeded| (exceeded, 1.0));
        above_zero("period", period_s).map_err(at_end)?;
        axes.check_positions(target, last).map_err(at_end)?;
        let moved: [f64; 6] = std::array::from_fn(|index| target[index] - last[index]);
        let moved_before: [f64; 6] = std::array::from_fn(|index| last[index] - before[index]);
        axes.check_step(&moved, &moved_before, period_s).map_err(at_end)?;
        self.tcp_speed().check_step(last, target, period_s).map_err(at_end)?;
        self.points().check_joint_way(last, target)?;
        self.room_to_stop().check_step(last, target, period_s).map_err(at_end)
    }

    fn regions(&self) -> PlacedRegions<'_> {
        PlacedRegions { regions: self.limits.regions(), base: &self.base }
    }

    fn points(&self) -> LimitedPoints<'_> {
        LimitedPoints { arm: &self.arm, regions: self.regions() }
    }

    fn tcp_speed(&self) -> TcpSpeedLimit<'_> {
        TcpSpeedLimit { arm: &self.arm, limit_mm_s: self.limits.tcp_speed() }
    }

    fn room_to_stop(&self) -> RoomToStop<'_> {
        RoomToStop { checker: self, points: self.points() }
    }

    /// Runs a check if all numbers of the motion are finite; otherwise refuses the motion.
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
            && frame(&self.frames.tool().0)
    }
}

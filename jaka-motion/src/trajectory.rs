//! Motions that are known from start to end.

mod curve;
mod curve_path;
mod error;
#[cfg(feature = "trajectory-files")]
mod file;
mod leg;
mod line;
mod path;
mod slow;
mod smoothing;
mod speed;
pub(crate) mod through;
mod timed;
mod timing;
mod via;

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::messages::types::JointPosition;

pub use self::curve::Curve;
use self::error::LONGEST_S;
pub use self::error::TrajectoryError;
pub use self::slow::{SlowPlace, SlowedBy};
pub use self::through::Through;
pub use self::timed::TimedPoint;
pub use self::via::{Via, ViaTarget};
use crate::beyond::Way;
use crate::checker::Checker;
use crate::piece::bernstein::{highest, part, peak};
use crate::piece::{Piece, Sample};

/// Motion of the joints that is known, and was compared with an arm's limits, from start to end.
///
/// Each joint moves by polynomials of time of at most the fifth degree, one after the other; its speed is continuous.
/// It starts and ends at rest.
///
/// # Checks
/// [`timed`](Self::timed) and the other constructors compare the whole motion, not samples. Joint ranges, speeds and
/// accelerations are compared by bounds of the polynomials. The speed of the tool centre point and regions are compared
/// in steps that leave out no more than the amounts of a [`Checker`]. The arm also has room to stop: as for a set-point
/// ([`Checker::check_set_point`]) it could stop straight on in joint space, checked each 8 ms.
///
/// # Reserve
/// A change of the rate, for a pause, a slower motion or a stop along the path, accelerates the joints in addition.
/// [`rate_change`](Self::rate_change) returns the change that is within the limits.
///
/// # Cost
/// Everything is computed and checked beforehand. With optimisation, 10,000 points with times take some 5 ms. A plan
/// without times takes time in proportion to the duration of the motion: some 0.7 ms for a second, 60 ms for a curve of
/// 80 s near 10,000 points. A piece has some 300 bytes: there is one between two points with times, and some 50 for
/// each second of a plan. Clones share them. [`at`](Self::at) takes about a tenth of a microsecond, and allocates
/// nothing.
///
/// # serde
/// With the feature `serde` a trajectory is described: `model`, `duration_s`, `start_deg`, `end_deg`, `way_points` and
/// `slow_places`. Joint positions in between are not written: [`at`](Self::at) gives them, as a [`Sample`] that can be.
#[derive(Clone, PartialEq)]
pub struct Trajectory(Arc<Shared>);

/// Data that clones share.
#[derive(PartialEq)]
struct Shared {
    pieces: Vec<Piece>,
    way_points: Vec<WayPoint>,
    slow: Vec<SlowPlace>,
    checker: Checker,
}

/// Time at which a trajectory reaches one of its points, and the manner of passing it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct WayPoint {
    /// Time at which the arm is at the point, or nearest to it, in seconds from the start.
    pub time_s: f64,
    /// Manner in which the arm passes the point.
    pub passing: Passing,
}

/// Manner in which the arm passes a way-point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Passing {
    /// The arm stops at the point.
    Stops,
    /// The arm moves through the point.
    Through,
    /// The arm rounds the corner, within the requested tolerance.
    Rounded,
}

/// Greatest change of a trajectory's rate in a second, with all joints within their accelerations; infinite if no joint
/// moves.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RateChange {
    /// Greatest fall, in 1/s.
    pub fall: f64,
    /// Greatest rise, in 1/s.
    pub rise: f64,
}

impl Trajectory {
    /// Returns the trajectory through points at their times, compared with an arm's limits.
    ///
    /// - With velocities and accelerations each piece is the polynomial of the fifth degree that has those of both
    ///   ends.
    /// - With velocities alone a point has the mean of the accelerations that polynomials of the third degree have
    ///   before and after it.
    /// - With neither, pieces of the third degree, and of the fourth at both ends, have the velocities for which
    ///   accelerations do not step.
    ///
    /// It begins and ends at rest and without acceleration, accelerations step nowhere, and jerks are within
    /// [`Limits::joint_jerks`](crate::Limits::joint_jerks). It follows the points exactly, within limits, and leaves a
    /// reserve for other rates only if they do: see [`rate_change`](Self::rate_change).
    ///
    /// ```
    /// use jaka_motion::{Checker, Frames, Limits, Model, TimedPoint, Trajectory};
    ///
    /// let checker = Checker::new(Limits::of(Model::named("Zu 5").expect("a published arm")), Frames::new());
    /// let points = [
    ///     TimedPoint::new(0.0, [0.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
    ///     TimedPoint::new(1.0, [10.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
    ///     TimedPoint::new(2.0, [20.0, 60.0, -85.0, 190.0, -90.0, 0.0]),
    /// ];
    /// let trajectory = Trajectory::timed(&points, &checker)?;
    /// assert_eq!(trajectory.at(1.0).joints, points[1].joints);
    ///
    /// let faster = points.map(|point| TimedPoint::new(point.time_s / 4.0, point.joints));
    /// let sudden = Trajectory::timed(&faster, &checker);
    /// let error = sudden.unwrap_err().to_string();
    /// assert_eq!(error, "after way-point 1, at 0.125 s: joint 1 would accelerate by 480 deg/s²; limit 72 (Zu 5)");
    /// # Ok::<(), jaka_motion::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// Invalid points, or the first place that is beyond a limit.
    pub fn timed(points: &[TimedPoint], checker: &Checker) -> Result<Self, TrajectoryError> {
        let (pieces, way_points) = timed::parts(points)?;
        let trajectory = Self::checked((pieces, way_points, Vec::new()), checker)?;
        timed::check_jerks(&trajectory.0.pieces, checker.limits().joint_jerks())?;
        Ok(trajectory)
    }

    /// Plans a trajectory through points, straight from one to the next, in joint space or on lines of the tool centre
    /// point, with rounded corners.
    ///
    /// ```
    /// use jaka_motion::proto::messages::types::Pose;
    /// use jaka_motion::{Checker, Frames, Limits, Model, Trajectory, Via};
    ///
    /// let arm = Model::named("Zu 5").expect("a published arm");
    /// let checker = Checker::new(Limits::of(arm).with_tcp_speed(250.0)?, Frames::new());
    /// let start = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    /// let above = Pose::from(arm.forward(start));
    /// let aside = Pose { y: above.y + 100.0, ..above };
    /// let down = Pose { z: above.z - 50.0, ..aside };
    ///
    /// let points = [Via::from(start), Via::from(aside), Via::from(down), Via::from(aside)];
    /// let trajectory = Trajectory::through(points).corner_mm(2.0).build(&checker)?;
    /// assert_eq!(trajectory.way_points().len(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn through<P: Into<Via>>(points: impl IntoIterator<Item = P>) -> Through {
        Through::new(points.into_iter().map(Into::into).collect())
    }

    /// Plans a curve near dense points, such as those of a taught or a sampled path.
    ///
    /// ```
    /// use jaka_motion::proto::messages::types::Pose;
    /// use jaka_motion::{Checker, Frames, Limits, Model, Trajectory, Via};
    ///
    /// let arm = Model::named("Zu 5").expect("a published arm");
    /// let checker = Checker::new(Limits::of(arm), Frames::new());
    /// let start = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    /// let first = Pose::from(arm.forward(start));
    ///
    /// // Half of a circle with a radius of 80 mm, each millimetre.
    /// let on_circle = (1..=250).map(|step| f64::from(step) / 80.0).map(|angle| {
    ///     Pose { x: first.x + 80.0 * (angle.cos() - 1.0), y: first.y + 80.0 * angle.sin(), ..first }
    /// });
    /// let points = std::iter::once(Via::from(start)).chain(on_circle.map(Via::from));
    /// let trajectory = Trajectory::curve(points).within_mm(0.1).tcp_speed(80.0).build(&checker)?;
    /// assert!(trajectory.duration_s() < 250.0 / 80.0 + 0.6);
    /// # Ok::<(), jaka_motion::TrajectoryError>(())
    /// ```
    pub fn curve<P: Into<Via>>(points: impl IntoIterator<Item = P>) -> Curve {
        Curve::new(points.into_iter().map(Into::into).collect())
    }

    /// Returns the places at which the tool is slower by 3 % or more than the speed set by [`Through::tcp_speed`] or
    /// [`Curve::tcp_speed`]: the slowest first, 20 at most. Each is a minimum of the speed other than a stop. Between
    /// two stops without such a minimum it is the fastest place, if that is slow, too.
    pub fn slow_places(&self) -> &[SlowPlace] {
        &self.0.slow
    }

    /// Returns the duration.
    pub fn duration(&self) -> Duration {
        Duration::try_from_secs_f64(self.duration_s()).unwrap_or(Duration::MAX)
    }

    /// Returns the duration, in seconds.
    pub fn duration_s(&self) -> f64 {
        self.0.pieces.last().map_or(0.0, Piece::end_s)
    }

    /// Returns the joint position at the start.
    pub fn start(&self) -> JointPosition {
        self.at(0.0).joints
    }

    /// Returns the joint position at the end.
    pub fn end(&self) -> JointPosition {
        self.at(f64::INFINITY).joints
    }

    /// Returns the joint positions at a time in seconds from the start, with their speeds and accelerations. A time
    /// before the start counts as the start, and a time after the end as the end.
    ///
    /// Speeds and accelerations are with respect to the trajectory's own time. At a step of an acceleration, the value
    /// after the step counts.
    pub fn at(&self, time_s: f64) -> Sample {
        // Not-a-number counts as the start.
        let time_s = time_s.max(0.0);
        let piece = &self.0.pieces[self.piece_at(time_s)];
        piece.at(((time_s - piece.start_s) / piece.seconds).clamp(0.0, 1.0))
    }

    /// Returns the way-points in their order.
    pub fn way_points(&self) -> &[WayPoint] {
        &self.0.way_points
    }

    /// Compares it with the limits of an arm, as its constructor did. With the same limits and frames it returns
    /// success without a new check.
    ///
    /// # Errors
    /// The first place, in time, that is beyond a limit.
    pub fn check(&self, checker: &Checker) -> Result<(), TrajectoryError> {
        if *checker == self.0.checker { Ok(()) } else { self.0.check(checker) }
    }

    /// Returns the room for changes of the rate that holds throughout between two times, or at one: at most the least
    /// room in between, and rarely less.
    ///
    /// The rate is the trajectory's time that passes in a second: 1 as planned, 0 at a pause. At rate r that changes by
    /// r' the joints' accelerations are `a r² + v r'`, with speeds v and accelerations a of [`at`](Self::at). So a
    /// joint that gains speed leaves more for a fall than for a rise, and one that loses speed less. At a step of an
    /// acceleration, the worse value counts.
    ///
    /// A trajectory can leave nothing for a fall at rate 1, if it loses speed as fast as a joint can. A follower then
    /// keeps this rate until something is left: a pause or a stop along the path begins that much later.
    pub fn rate_change(&self, from_s: f64, to_s: f64, rate: f64) -> RateChange {
        // Not-a-number counts as the start.
        let (from_s, to_s) = (from_s.max(0.0), to_s.max(0.0));
        // A step of acceleration at the time itself counts with both sides.
        let last = self.piece_at(to_s.max(from_s));
        let pieces = &self.0.pieces[..=last];
        let first = pieces.partition_point(|piece| piece.end_s() < from_s).min(last);
        let changes = pieces[first..].iter().map(|piece| self.rate_change_on(piece, from_s, to_s, rate));
        changes.fold(RateChange::ANY, RateChange::least)
    }

    /// Returns the joint accelerations for that, in deg/s².
    pub(crate) fn joint_accelerations(&self) -> &[f64; 6] {
        self.0.checker.limits().joint_accelerations()
    }

    /// Creates a trajectory from pieces, at least one, after a check against the limits.
    fn checked(
        (mut pieces, mut way_points, slow): (Vec<Piece>, Vec<WayPoint>, Vec<SlowPlace>),
        checker: &Checker,
    ) -> Result<Self, TrajectoryError> {
        let duration_s = pieces.last().map_or(0.0, |piece| piece.start_s + piece.seconds);
        if duration_s > LONGEST_S {
            return Err(TrajectoryError::TooLong { duration_s });
        }
        pieces.shrink_to_fit();
        way_points.shrink_to_fit();
        let made = Shared { pieces, way_points, slow, checker: checker.clone() };
        made.check(checker).map(|()| Self(Arc::new(made)))
    }

    /// Returns the index of the piece at a time.
    fn piece_at(&self, time_s: f64) -> usize {
        self.0.pieces.partition_point(|piece| piece.start_s <= time_s).saturating_sub(1)
    }

    fn rate_change_on(&self, piece: &Piece, from_s: f64, to_s: f64, rate: f64) -> RateChange {
        let share = |time_s: f64| ((time_s - piece.start_s) / piece.seconds).clamp(0.0, 1.0);
        let (from, to) = (share(from_s), share(to_s.max(from_s)));
        let changes = self.joint_accelerations().iter().enumerate().map(|(joint, limit)| {
            let (speeds, accelerations) =
                (part(&piece.speeds(joint), from, to), part(&piece.accelerations(joint), from, to));
            let speed = peak(&speeds);
            if speed <= 0.0 {
                return RateChange::ANY;
            }
            // For a joint that turns round, each acceleration counts in both directions.
            let [losing, gaining] = if speeds.iter().all(|speed| *speed >= 0.0) {
                [highest(&accelerations.map(|each| -each)), highest(&accelerations)]
            } else if speeds.iter().all(|speed| *speed <= 0.0) {
                [highest(&accelerations), highest(&accelerations.map(|each| -each))]
            } else {
                [peak(&accelerations); 2]
            };
            let left = |used: f64| ((limit - used * rate * rate) / speed).max(0.0);
            RateChange { fall: left(losing), rise: left(gaining) }
        });
        changes.fold(RateChange::ANY, RateChange::least)
    }
}

impl RateChange {
    const ANY: Self = Self { fall: f64::INFINITY, rise: f64::INFINITY };

    fn least(self, other: Self) -> Self {
        Self { fall: self.fall.min(other.fall), rise: self.rise.min(other.rise) }
    }
}

impl Shared {
    fn check(&self, checker: &Checker) -> Result<(), TrajectoryError> {
        let mut end = None;
        self.pieces.iter().try_for_each(|piece| {
            checker.check_piece(piece, &mut end).map_err(|(exceeded, share)| {
                let time_s = piece.start_s + share * piece.seconds;
                let after = self.way_points.partition_point(|way_point| way_point.time_s <= time_s);
                let beyond = Box::new(checker.beyond_of(Way::Trajectory, exceeded));
                TrajectoryError::Beyond { after, time_s: Some(time_s), beyond }
            })
        })
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Trajectory {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Form<'t> {
            model: &'static str,
            duration_s: f64,
            start_deg: [f64; 6],
            end_deg: [f64; 6],
            way_points: &'t [WayPoint],
            slow_places: &'t [SlowPlace],
        }
        let form = Form {
            model: self.0.checker.limits().model().name(),
            duration_s: self.duration_s(),
            start_deg: self.start().0,
            end_deg: self.end().0,
            way_points: self.way_points(),
            slow_places: self.slow_places(),
        };
        form.serialize(serializer)
    }
}

/// Shows the duration and the numbers of parts, which can be thousands.
impl fmt::Debug for Trajectory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = f.debug_struct("Trajectory");
        parts.field("duration_s", &self.duration_s()).field("way_points", &self.0.way_points.len());
        parts.field("pieces", &self.0.pieces.len()).finish_non_exhaustive()
    }
}

//! Limits of an arm.

mod axes;
mod clearance;
#[cfg(feature = "serde")]
mod form;
mod region;

use std::ops::RangeInclusive;
use std::sync::Arc;

pub(crate) use self::axes::AxisLimits;
pub(crate) use self::clearance::SingularityClearance;
pub use self::region::{Region, RegionFrame};
use crate::model::Model;

/// Limits of an arm: joint ranges, joint speeds and accelerations, the speed of the tool, regions, and the distance
/// from singularities.
///
/// A [`Checker`](crate::Checker) compares motions with them before they are sent. They are not a fence and not a safety
/// function: they do not apply to motions that another program, a person at the pendant or the controller itself
/// starts.
///
/// ```
/// use jaka_motion::{Limits, Model, Point, Region};
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let limits = Limits::of(arm)
///     .with_joint_range(1, -90.0, 90.0)?
///     .with_tcp_speed(250.0)?
///     .with_region(Region::half_space("table", [0.0, 0.0, 20.0], [0.0, 0.0, 1.0])?)?
///     .with_region(Region::outside_box("camera", [300.0, -100.0, 0.0], [500.0, 100.0, 900.0])?.of(Point::Elbow))?;
/// assert_eq!(limits.joint_max()[0], 90.0);
///
/// let wider = limits.with_joint_range(3, -180.0, 180.0).unwrap_err();
/// assert_eq!(wider.to_string(), "joint 3: -180 deg is beyond the -175 deg of the Zu 5; a limit can only be tighter");
/// # Ok::<(), jaka_motion::InvalidLimit>(())
/// ```
///
/// # serde
/// With the feature `serde` limits are written and read in the tables and keys of `Limits::from_toml`, with the same
/// checks and defaults. Boxes are read before half-spaces. Two more values are written:
/// - `tcp_acceleration_mm_s2` of `stop` is `null` [without](Self::without_stop_tcp_acceleration) that bound. TOML has
///   no `null`: such limits come back from it with the default bound.
/// - `dh` has the parameters of a model [with other ones](Model::with_dh) than the published ones: `alpha_deg`, `a_mm`,
///   `d_mm` and `joint_home_offset_deg`.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    model: Model,
    axes: AxisLimits,
    tcp_speed: Option<f64>,
    /// Acceleration along the path in trajectories.
    tcp_acceleration: Option<f64>,
    stop_tcp_acceleration: Option<f64>,
    preset: Preset,
    clearance: SingularityClearance,
    regions: Vec<Region>,
}

/// Accelerations of motions: see [`Limits::with_preset`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Preset {
    /// A joint's highest speed in 2.5 s. The default.
    #[default]
    Gentle,
    /// A joint's highest speed in 0.75 s, and 2 m/s² for the tool centre point along its path.
    Usual,
    /// A joint's highest speed in 0.4 s, and 5 m/s² for the tool centre point along its path.
    Quick,
}

jaka_proto::worded! {
    /// Error for a value that cannot be a limit.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum InvalidLimit {
        /// A number is not finite.
        NotFinite {
            /// Name of the quantity, for example `joint range`.
            what: &'static str,
            /// Number that was given.
            given: f64,
        } => "{what}: {given} is not finite",
        /// A speed, an acceleration, a jerk or a distance is zero or negative, or so small or large that nothing can be
        /// computed with it.
        OutOfRange {
            /// Name of the quantity, for example `joint speed`.
            what: &'static str,
            /// Number that was given.
            given: f64,
        } => (format!("{what}: {given} is not from {} to {:e}", RATES.start(), RATES.end())),
        /// No joint has this number.
        NoSuchJoint {
            /// Number that was given.
            joint: usize,
        } => "there is no joint {joint}; joints are numbered from 1 to 6",
        /// The lower end of a range is above the upper one.
        EmptyRange {
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Lower end, in degrees.
            min_deg: f64,
            /// Upper end, in degrees.
            max_deg: f64,
        } => "joint {joint}: the range from {min_deg} to {max_deg} deg is empty",
        /// A limit allows more than the arm's published figure.
        Wider {
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Requested limit.
            given: f64,
            /// Published figure of the arm.
            published: f64,
            /// Unit of both, `deg` or `deg/s`.
            unit: &'static str,
            /// Name of the arm.
            model: &'static str,
        } =>
            "joint {joint}: {given} {unit} is beyond the {published} {unit} of the {model}; a limit can \
             only be tighter",
        /// A distance from a singularity is not from 0 to below 1.
        NotADistance {
            /// Number that was given.
            given: f64,
        } => "distance from a singularity: {given} is not from 0 to below 1",
        /// A region has no name.
        NoName => "a region has no name",
        /// Two regions have the same name.
        NameTaken {
            /// Name that both regions have.
            name: Arc<str>,
        } => (format!("two regions are called `{}`", name.escape_debug())),
        /// A box has a side below 0 mm, or below 1 mm if it is to be kept outside of.
        ThinBox {
            /// Name of the region.
            name: Arc<str>,
            /// Smallest side of the box, in mm.
            side_mm: f64,
        } => (format!(
            "box `{}`: a side of {side_mm} mm; a side is at least 0 mm, and at least 1 mm if the arm stays outside",
            name.escape_debug()
        )),
        /// The direction of a half-space has no length.
        NoDirection {
            /// Name of the region.
            name: Arc<str>,
        } => (format!("half-space `{}`: the inward direction has no length", name.escape_debug())),
    }
}

/// Range of speeds, accelerations and jerks, in deg or mm and seconds. A slower joint takes hours for a turn; the
/// largest number is far beyond any arm, and its powers can be computed with.
pub(crate) const RATES: RangeInclusive<f64> = 1e-3..=1e9;
/// Default time in which a joint reaches its acceleration, in a motion and in a stop, in seconds. A choice of this
/// library: no source has jerks of these arms.
const ACCELERATION_REACHED_S: f64 = 0.1;
/// Default acceleration of a stop, in deg/s². A choice of this library: no source has any. It is below the 720 deg/s²
/// that the document advises for motions of joints (4.7).
const STOP_ACCELERATION: f64 = 570.0;
/// Default acceleration of the tool centre point in a stop, in mm/s²: the most that the document advises for lines
/// (4.9).
const STOP_TCP_ACCELERATION: f64 = 8000.0;
/// Default least distance from a singularity. A choice of this library: 0.6 degrees of joint 5, at which the wrist
/// turns about a hundred times as fast as the tool.
const SINGULARITY_DISTANCE: SingularityClearance = SingularityClearance(0.01);
/// Rounding error that is allowed in an angle in degrees, a length in mm or a distance from a singularity: far below
/// the stated amounts, and far above the error of joint positions that are computed for a pose.
pub(crate) const ROUNDING: f64 = 1e-5;
/// Rounding error that is allowed in the position of a start beyond a limit; too small to add up over a queue or a
/// session.
pub(crate) const START_ROUNDING: f64 = 1e-9;

impl Limits {
    /// Returns the published limits of an arm, and careful defaults of this library for the rest.
    ///
    /// - Joint ranges and speeds are the published ones.
    /// - Joint accelerations are **not published** for these arms. The default is a choice of this library:
    ///   [`Preset::Gentle`], for example 72 deg/s² for a speed of 180 deg/s.
    /// - A stop may be harder: 570 deg/s², reached in 0.1 s, and 8 m/s² for the tool centre point along its path. The
    ///   first is a choice of this library, the second is the most that the document advises for lines (4.9). No source
    ///   shows an arm that follows set-points that brake so hard.
    /// - The least distance from a singularity, 0.01, is a choice of this library, too.
    /// - The speed of the tool is not limited, and there are no regions.
    pub fn of(model: &Model) -> Self {
        let (min, max, speeds) = (*model.joint_min(), *model.joint_max(), *model.joint_speed());
        let accelerations = speeds.map(|speed| speed / Preset::Gentle.seconds());
        Self {
            axes: AxisLimits {
                min,
                max,
                speeds,
                accelerations,
                jerks: accelerations.map(reached_in_time),
                stop_accelerations: [STOP_ACCELERATION; 6],
                stop_jerks: [reached_in_time(STOP_ACCELERATION); 6],
            },
            tcp_speed: None,
            tcp_acceleration: None,
            stop_tcp_acceleration: Some(STOP_TCP_ACCELERATION),
            preset: Preset::Gentle,
            clearance: SINGULARITY_DISTANCE,
            regions: Vec::new(),
            model: model.clone(),
        }
    }

    /// Reads limits from a TOML text; keys that it leaves out are as in [`of`](Self::of). Errors show `file_name`.
    ///
    /// Units are part of the keys. All keys but `model` may be left out, and a number in place of a list applies to all
    /// six joints.
    ///
    /// ```
    /// use jaka_motion::Limits;
    ///
    /// let text = r#"
    /// model = "Zu 5"
    /// preset = "usual" # or "gentle", the default, or "quick"; figures below win over it
    ///
    /// [joints]
    /// min_deg = [-170, -80, -150, -80, -175, -360]
    /// max_deg = [170, 260, 150, 260, 175, 360]
    /// speed_deg_s = 90
    /// acceleration_deg_s2 = [60, 60, 90, 90, 120, 120] # not published for these arms
    /// jerk_deg_s3 = 1200             # by default so that the acceleration is reached in 0.1 s
    ///
    /// [tcp]
    /// speed_mm_s = 250
    /// acceleration_mm_s2 = 1500
    ///
    /// [stop]
    /// joint_acceleration_deg_s2 = 400 # not published for these arms
    /// joint_jerk_deg_s3 = 8000        # by default so that the acceleration is reached in 0.1 s
    /// tcp_acceleration_mm_s2 = 5000
    ///
    /// [singularity]
    /// least_distance = 0.05
    ///
    /// [[half_space]]
    /// name = "table"
    /// of = "tcp"           # or "elbow", "wrist"
    /// frame = "user"       # or "base": the arm's own base, however it is mounted
    /// point_mm = [0, 0, 20]
    /// inward = [0, 0, 1]   # a direction, of any length
    ///
    /// [[box]]
    /// name = "camera"
    /// of = "elbow"
    /// frame = "base"
    /// keep = "outside"     # or "inside"
    /// min_mm = [300, -100, 0]
    /// max_mm = [500, 100, 900]
    /// "#;
    /// let limits = Limits::from_toml(text, "limits.toml")?;
    /// assert_eq!((limits.joint_speeds()[5], limits.regions().len()), (90.0, 2));
    ///
    /// let errors = Limits::from_toml("model = \"Zu 5\"\n[tcp]\nspeed_mms = 250", "limits.toml").unwrap_err();
    /// let expected = "expected `speed_mm_s` or `acceleration_mm_s2` in `tcp`";
    /// assert_eq!(errors.to_string(), format!("limits.toml:3:1: unknown field `speed_mms`, {expected}"));
    /// # Ok::<(), jaka_motion::LimitsFileError>(())
    /// ```
    ///
    /// # Errors
    /// Errors in the text, each at its line and column: all errors of TOML; or else the first key or type that is
    /// wrong; or else all values that cannot be limits.
    #[cfg(feature = "toml")]
    pub fn from_toml(text: &str, file_name: &str) -> Result<Self, crate::LimitsFileError> {
        form::from_toml(text, file_name)
    }

    /// Sets the range of a joint, 1 to 6, in degrees.
    ///
    /// # Errors
    /// There is no such joint, the range is empty, or it is wider than the range of the [`model`](Self::model).
    pub fn with_joint_range(mut self, joint: usize, min_deg: f64, max_deg: f64) -> Result<Self, InvalidLimit> {
        let index = index_of(joint)?;
        finite("joint range", &[min_deg, max_deg])?;
        if min_deg > max_deg {
            return Err(InvalidLimit::EmptyRange { joint, min_deg, max_deg });
        }
        let (least, most) = (self.model.joint_min()[index], self.model.joint_max()[index]);
        for given in [min_deg, max_deg] {
            if !(least..=most).contains(&given) {
                let (published, model) = (given.clamp(least, most), self.model.name());
                return Err(InvalidLimit::Wider { joint, given, published, unit: "deg", model });
            }
        }
        (self.axes.min[index], self.axes.max[index]) = (min_deg, max_deg);
        Ok(self)
    }

    /// Sets the highest speeds of joints 1 to 6, in deg/s.
    ///
    /// # Errors
    /// A speed is below 0.001, or is higher than the speed of the [`model`](Self::model).
    pub fn with_joint_speeds(mut self, deg_s: [f64; 6]) -> Result<Self, InvalidLimit> {
        in_range("joint speed", &deg_s)?;
        for ((joint, given), published) in (1..).zip(deg_s).zip(*self.model.joint_speed()) {
            if given > published {
                return Err(InvalidLimit::Wider { joint, given, published, unit: "deg/s", model: self.model.name() });
            }
        }
        self.axes.speeds = deg_s;
        Ok(self)
    }

    /// Sets the highest accelerations of joints 1 to 6, in deg/s², each reached in 0.1 s.
    ///
    /// # Errors
    /// An acceleration is not from 0.001 to 1e9.
    pub fn with_joint_accelerations(mut self, deg_s2: [f64; 6]) -> Result<Self, InvalidLimit> {
        in_range("joint acceleration", &deg_s2)?;
        self.axes.accelerations = deg_s2;
        self.axes.jerks = deg_s2.map(reached_in_time);
        Ok(self)
    }

    /// Sets the highest jerks of joints 1 to 6, in deg/s³. They apply to the planning of trajectories and streams,
    /// unless these have their own, and to the check of [`Trajectory::timed`](crate::Trajectory::timed); to nothing
    /// else.
    ///
    /// # Errors
    /// A jerk is not from 0.001 to 1e9.
    pub fn with_joint_jerks(mut self, deg_s3: [f64; 6]) -> Result<Self, InvalidLimit> {
        in_range("joint jerk", &deg_s3)?;
        self.axes.jerks = deg_s3;
        Ok(self)
    }

    /// Sets the joint accelerations of a preset, and its acceleration of the tool centre point.
    ///
    /// None of these figures is published for the arms, and nobody has tried them on one. With [`Preset::Usual`] and
    /// [`Preset::Quick`] a robot requires a known payload and collision detection.
    ///
    /// ```
    /// use jaka_motion::{Limits, Model, Preset};
    ///
    /// let limits = Limits::of(Model::named("Zu 5").expect("a published arm")).with_preset(Preset::Usual);
    /// assert_eq!((limits.joint_accelerations()[0], limits.tcp_acceleration()), (240.0, Some(2000.0)));
    /// ```
    #[must_use]
    pub fn with_preset(mut self, preset: Preset) -> Self {
        self.axes.accelerations = self.model.joint_speed().map(|speed| speed / preset.seconds());
        self.axes.jerks = self.axes.accelerations.map(reached_in_time);
        self.tcp_acceleration = preset.tcp_acceleration();
        self.preset = preset;
        self
    }

    /// Sets the highest acceleration of the tool centre point along its path, in mm/s². It applies to the planning of
    /// trajectories ([`Trajectory::through`](crate::Trajectory::through), [`curve`](crate::Trajectory::curve)) and to
    /// nothing else.
    ///
    /// # Errors
    /// The acceleration is not from 0.001 to 1e9.
    pub fn with_tcp_acceleration(mut self, mm_s2: f64) -> Result<Self, InvalidLimit> {
        in_range("acceleration of the tool centre point", &[mm_s2])?;
        self.tcp_acceleration = Some(mm_s2);
        Ok(self)
    }

    /// Sets the accelerations of joints 1 to 6 in a stop, in deg/s², each reached in 0.1 s.
    ///
    /// A stop is never gentler than a motion: a number below that of [`joint_accelerations`](Self::joint_accelerations)
    /// counts as that number.
    ///
    /// # Errors
    /// An acceleration is not from 0.001 to 1e9.
    pub fn with_stop_accelerations(mut self, deg_s2: [f64; 6]) -> Result<Self, InvalidLimit> {
        in_range("joint acceleration of a stop", &deg_s2)?;
        self.axes.stop_accelerations = deg_s2;
        self.axes.stop_jerks = deg_s2.map(reached_in_time);
        Ok(self)
    }

    /// Sets the jerks of joints 1 to 6 in a stop, in deg/s³.
    ///
    /// # Errors
    /// A jerk is not from 0.001 to 1e9.
    pub fn with_stop_jerks(mut self, deg_s3: [f64; 6]) -> Result<Self, InvalidLimit> {
        in_range("joint jerk of a stop", &deg_s3)?;
        self.axes.stop_jerks = deg_s3;
        Ok(self)
    }

    /// Sets the acceleration of the tool centre point along its path in a stop, in mm/s².
    ///
    /// It applies to the deceleration by braking only, not to a loss of the tool's speed on a curve on which the joints
    /// keep their speeds. The [`joint_accelerations`](Self::joint_accelerations) of motions take precedence.
    ///
    /// # Errors
    /// The acceleration is not from 0.001 to 1e9.
    pub fn with_stop_tcp_acceleration(mut self, mm_s2: f64) -> Result<Self, InvalidLimit> {
        in_range("acceleration of the tool centre point in a stop", &[mm_s2])?;
        self.stop_tcp_acceleration = Some(mm_s2);
        Ok(self)
    }

    /// Removes the acceleration of the tool centre point in a stop: the joints alone bound stops.
    #[must_use]
    pub fn without_stop_tcp_acceleration(mut self) -> Self {
        self.stop_tcp_acceleration = None;
        self
    }

    /// Sets the highest speed of the tool centre point, in mm/s.
    ///
    /// # Errors
    /// The speed is not from 0.001 to 1e9.
    pub fn with_tcp_speed(mut self, mm_s: f64) -> Result<Self, InvalidLimit> {
        in_range("speed of the tool centre point", &[mm_s])?;
        self.tcp_speed = Some(mm_s);
        Ok(self)
    }

    /// Sets the least distance from each of the three singularities, as defined by
    /// [`SingularityDistance`](crate::SingularityDistance) for shoulder, elbow and wrist; 0 for none.
    ///
    /// It applies to motions of the tool: lines, arcs and set-points that are poses. A singularity does no harm on a
    /// straight path in joint space.
    ///
    /// # Errors
    /// The distance is not from 0 to below 1.
    pub fn with_singularity_distance(mut self, least: f64) -> Result<Self, InvalidLimit> {
        if !(0.0..1.0).contains(&least) {
            return Err(InvalidLimit::NotADistance { given: least });
        }
        self.clearance = SingularityClearance(least);
        Ok(self)
    }

    /// Adds a region.
    ///
    /// # Errors
    /// Another region has the same name.
    pub fn with_region(mut self, region: Region) -> Result<Self, InvalidLimit> {
        if self.regions.iter().any(|other| other.name() == region.name()) {
            return Err(InvalidLimit::NameTaken { name: region.name().clone() });
        }
        self.regions.push(region);
        Ok(self)
    }

    /// Returns the arm's model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns the lower end of each joint's range in degrees.
    pub fn joint_min(&self) -> &[f64; 6] {
        &self.axes.min
    }

    /// Returns the upper end of each joint's range in degrees.
    pub fn joint_max(&self) -> &[f64; 6] {
        &self.axes.max
    }

    /// Returns the highest speed of each joint in deg/s.
    pub fn joint_speeds(&self) -> &[f64; 6] {
        &self.axes.speeds
    }

    /// Returns the highest acceleration of each joint in deg/s².
    pub fn joint_accelerations(&self) -> &[f64; 6] {
        &self.axes.accelerations
    }

    /// Returns the highest jerk of each joint in deg/s³.
    pub fn joint_jerks(&self) -> &[f64; 6] {
        &self.axes.jerks
    }

    /// Returns the highest acceleration of the tool centre point along its path in mm/s², if it is limited.
    pub fn tcp_acceleration(&self) -> Option<f64> {
        self.tcp_acceleration
    }

    /// Returns the last preset that was set.
    pub fn preset(&self) -> Preset {
        self.preset
    }

    /// Returns the acceleration of each joint in a stop, in deg/s².
    pub fn stop_accelerations(&self) -> &[f64; 6] {
        &self.axes.stop_accelerations
    }

    /// Returns the jerk of each joint in a stop, in deg/s³.
    pub fn stop_jerks(&self) -> &[f64; 6] {
        &self.axes.stop_jerks
    }

    /// Returns the acceleration of the tool centre point along its path in a stop, in mm/s², if it is limited.
    pub fn stop_tcp_acceleration(&self) -> Option<f64> {
        self.stop_tcp_acceleration
    }

    /// Returns the highest speed of the tool centre point in mm/s, if it is limited.
    pub fn tcp_speed(&self) -> Option<f64> {
        self.tcp_speed
    }

    /// Returns the least distance from a singularity; 0 for none.
    pub fn singularity_distance(&self) -> f64 {
        self.clearance.0
    }

    /// Returns the regions, in the order of their addition.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// Returns the limits of the joints.
    pub(crate) fn axes(&self) -> &AxisLimits {
        &self.axes
    }

    /// Returns the least distance from singularities.
    pub(crate) fn clearance(&self) -> SingularityClearance {
        self.clearance
    }
}

impl Preset {
    /// Returns the name in a file of limits.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gentle => "gentle",
            Self::Usual => "usual",
            Self::Quick => "quick",
        }
    }

    /// Returns the time in which a joint reaches its highest speed, in seconds, without the 0.1 s in which it reaches
    /// its acceleration. A choice of this library: no source has accelerations of these arms.
    fn seconds(self) -> f64 {
        match self {
            Self::Gentle => 2.5,
            Self::Usual => 0.75,
            Self::Quick => 0.4,
        }
    }

    /// Returns the acceleration of the tool centre point, in mm/s². A choice of this library; the document advises at
    /// most 8000 for lines (4.9).
    fn tcp_acceleration(self) -> Option<f64> {
        match self {
            Self::Gentle => None,
            Self::Usual => Some(2000.0),
            Self::Quick => Some(5000.0),
        }
    }
}

impl std::error::Error for InvalidLimit {}

/// Returns a limit with the rounding error that is allowed for a number at it.
pub(crate) fn rounded_up(limit: f64) -> f64 {
    limit * (1.0 + 1e-9)
}

fn reached_in_time(acceleration: f64) -> f64 {
    (acceleration / ACCELERATION_REACHED_S).min(*RATES.end())
}

fn index_of(joint: usize) -> Result<usize, InvalidLimit> {
    if (1..=6).contains(&joint) { Ok(joint - 1) } else { Err(InvalidLimit::NoSuchJoint { joint }) }
}

fn finite(what: &'static str, numbers: &[f64]) -> Result<(), InvalidLimit> {
    let other = numbers.iter().find(|number| !number.is_finite());
    other.map_or(Ok(()), |given| Err(InvalidLimit::NotFinite { what, given: *given }))
}

/// Checks that speeds, accelerations, jerks or distances are in the range for computations.
pub(crate) fn in_range(what: &'static str, numbers: &[f64]) -> Result<(), InvalidLimit> {
    let other = numbers.iter().find(|number| !RATES.contains(number));
    other.map_or(Ok(()), |given| Err(InvalidLimit::OutOfRange { what, given: *given }))
}

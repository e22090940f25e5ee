//! Figures of one arm.

mod fit;
pub(crate) mod inverse;
mod published;
mod singularity;

pub use self::fit::{Fit, FitError, Tolerance};
pub use self::inverse::{Branches, NoSolution};
use self::published::PUBLISHED;
use self::singularity::smallest_singular_value;
pub use self::singularity::{Singularity, SingularityDistance};
use crate::closed_form::{AngleSets, ClosedForm, Precision, Wrist};
use crate::links::{Links, jacobian};
use crate::newton::{ACCEPTED, USUAL};
use crate::transform::Transform;
use jaka_proto::messages::kinematics::GetDhParamReply;
use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::{Isometry3, Vector3};
use std::fmt;

/// Figures of one arm: Denavit-Hartenberg parameters, joint ranges and joint speeds, in millimetres and degrees.
///
/// ```
/// use jaka_motion::Model;
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let joints = [10.0, 60.0, 80.0, 30.0, -90.0, 0.0];
/// let flange = arm.forward(joints);
/// let found = arm.inverse(flange, joints)?;
/// assert!(found.max_distance(&joints.into()) < 1e-6);
/// # Ok::<(), jaka_motion::NoSolution>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(crate) name: &'static str,
    pub(crate) links: Links,
    /// Closed form of the links, or of the nearest links that have one.
    pub(crate) closed_form: ClosedForm,
    pub(crate) joint_min: [f64; 6],
    pub(crate) joint_max: [f64; 6],
    pub(crate) joint_speed: [f64; 6],
}

jaka_proto::worded! {
    /// Point of the arm.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum Point {
        /// Tool centre point.
        Tcp => "tool centre point",
        /// End of the upper arm, on the axis of joint 3: the third of
        /// [`Model::joint_frames`](crate::Model::joint_frames).
        Elbow => "elbow",
        /// Point at which the axes of joints 5 and 6 meet: the fifth of
        /// [`Model::joint_frames`](crate::Model::joint_frames).
        Wrist => "wrist",
    }
}

/// Error for Denavit-Hartenberg parameters that do not match the published arm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct DhMismatch {
    /// Name of the published arm.
    pub model: &'static str,
    /// Name of the parameter that differs: `alpha`, `a`, `d` or `joint_home_offset`.
    pub parameter: &'static str,
    /// Number of the joint, 1 to 6.
    pub joint: usize,
    /// Value of the controller, in mm or degrees.
    pub found: f64,
    /// Value of the published arm, in mm or degrees.
    pub published: f64,
}

/// Greatest difference of a controller's length from the published one, in mm.
const LENGTH: f64 = 5.0;
/// Greatest difference of a controller's angle from the published one, in degrees.
const ANGLE: f64 = 1.0;
/// Distance of a target, in mm, beyond which the closed form's numbers could overflow.
const FAR: f64 = 1e9;
/// Greatest distance of a joint beyond its limit, in degrees, that counts as rounding; the joint is set to the limit.
const ON_LIMIT: f64 = 1e-6;

impl Model {
    /// Returns every published arm, the default first.
    ///
    /// Lengths, ranges and speeds are those of the vendor's URDF files; a controller's own lengths can differ by some
    /// tenths of a millimetre.
    pub fn published() -> &'static [Self] {
        &PUBLISHED
    }

    /// Returns the published arm of this name. Case, blanks, punctuation and a leading "JAKA" do not matter: `Zu 5`,
    /// `jaka_zu5`, `ZU-5`.
    pub fn named(name: &str) -> Option<&'static Self> {
        let wanted = plain(name);
        PUBLISHED.iter().find(|model| plain(model.name) == wanted)
    }

    /// Returns the vendor's name of the arm, without "JAKA".
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the link twists in degrees, as in the reply of `get_dh_param` (section 4.82).
    pub fn alpha(&self) -> &[f64; 6] {
        &self.links.alpha
    }

    /// Returns the link lengths in mm, as in the reply of `get_dh_param`.
    pub fn a(&self) -> &[f64; 6] {
        &self.links.a
    }

    /// Returns the link offsets in mm, as in the reply of `get_dh_param`.
    pub fn d(&self) -> &[f64; 6] {
        &self.links.d
    }

    /// Returns the offset from each joint position to the link's angle, in degrees, as in the reply of `get_dh_param`.
    pub fn joint_home_offset(&self) -> &[f64; 6] {
        &self.links.joint_home_offset
    }

    /// Returns the lower end of each joint's range in degrees.
    pub fn joint_min(&self) -> &[f64; 6] {
        &self.joint_min
    }

    /// Returns the upper end of each joint's range in degrees.
    pub fn joint_max(&self) -> &[f64; 6] {
        &self.joint_max
    }

    /// Returns the highest speed of each joint in deg/s.
    pub fn joint_speed(&self) -> &[f64; 6] {
        &self.joint_speed
    }

    /// Returns the sum of all lengths in mm: no point of the flange is further from the base.
    pub fn reach_mm(&self) -> f64 {
        self.links.length()
    }

    /// Whether every joint position is a number within the joint's range.
    pub fn is_within_range(&self, joints: impl Into<JointPosition>) -> bool {
        let ranges = self.joint_min.iter().zip(&self.joint_max);
        joints.into().0.iter().zip(ranges).all(|(joint, (min, max))| min <= joint && joint <= max)
    }

    /// Returns the flange in the arm's base for these joint positions; the joints' ranges are not checked.
    ///
    /// Joint positions that are not finite give a transform that is not finite either. For the pose of a tool in a user
    /// frame see [`Frames::pose`](crate::Frames::pose).
    pub fn forward(&self, joints: impl Into<JointPosition>) -> Transform {
        Transform(self.links.flange(&joints.into().0))
    }

    /// Returns the frames of the six joints in the arm's base; the last one is the flange.
    ///
    /// The axis of each joint is the z axis of its frame. The third frame is at the elbow, the fifth at the wrist,
    /// where the axes of joints 5 and 6 meet.
    pub fn joint_frames(&self, joints: impl Into<JointPosition>) -> [Transform; 6] {
        self.links.frames(&joints.into().0).map(Transform)
    }

    /// Returns the motion of the tool with each joint. The rows are the velocity of the tool along x, y, z of the arm's
    /// base in mm/s and its turning about these directions in deg/s; the columns are the joints, each for 1 deg/s.
    ///
    /// `tool` is seen from the flange; only its position counts.
    pub fn jacobian(&self, joints: impl Into<JointPosition>, tool: &Transform) -> [[f64; 6]; 6] {
        let frames = self.links.frames(&joints.into().0);
        let tool: Isometry3<f64> = frames[5] * tool.0;
        let jacobian = jacobian(&frames, &tool.translation.vector);
        std::array::from_fn(|row| {
            std::array::from_fn(|joint| {
                let entry = jacobian[(row, joint)];
                // mm per radian become mm per degree; a turn has the same unit above and below.
                if row < 3 { entry.to_radians() } else { entry }
            })
        })
    }

    /// Returns this arm with the parameters of its controller, from the reply of `get_dh_param` (section 4.82).
    ///
    /// Joint ranges and speeds stay the published ones. No source defines the meaning of a controller's parameters, or
    /// shows that its own kinematics follow them: [`fit`](Self::fit) compares. The axes of a calibrated arm are not
    /// quite parallel or at right angles, so there is no closed form. The inverse then starts from the closed form of
    /// the nearest arm that has one, and continues by Newton steps. It takes longer, and near a singularity it can miss
    /// a branch, or find nothing.
    ///
    /// # Errors
    /// A length differs from the published one by more than 5 mm, or an angle by more than 1 degree: it is another arm,
    /// or the parameters have another meaning.
    pub fn with_dh(&self, reply: &GetDhParamReply) -> Result<Self, DhMismatch> {
        let GetDhParamReply { alpha, a, d, joint_home_offset, .. } = *reply;
        self.with_links(Links { alpha, a, d, joint_home_offset })
    }

    /// Returns this arm with these parameters, if they are near its own.
    pub(crate) fn with_links(&self, links: Links) -> Result<Self, DhMismatch> {
        let published = &self.links;
        self.compare("alpha", &links.alpha, &published.alpha, ANGLE)?;
        self.compare("a", &links.a, &published.a, LENGTH)?;
        self.compare("d", &links.d, &published.d, LENGTH)?;
        self.compare("joint_home_offset", &links.joint_home_offset, &published.joint_home_offset, ANGLE)?;
        let mut model = Self { links, ..self.clone() };
        model.closed_form.links = self.closed_form.nearest_to(&links);
        if model.closed_form.links != links {
            model.closed_form.precision = Precision::FirstGuess;
        }
        Ok(model)
    }

    /// Returns the distances of these joint positions from the singularities of shoulder, elbow and wrist, or of the
    /// whole A12; NaN for joint positions that are not finite.
    ///
    /// ```
    /// use jaka_motion::Model;
    ///
    /// let arm = Model::named("Zu 5").expect("a published arm");
    /// let stretched = arm.singularity_distance([0.0, 60.0, 0.0, 30.0, -90.0, 0.0]);
    /// assert!(stretched.elbow < 1e-9 && stretched.wrist > 0.9 && stretched.smallest_singular_value < 1e-9);
    /// ```
    pub fn singularity_distance(&self, joints: impl Into<JointPosition>) -> SingularityDistance {
        let frames = self.links.frames(&joints.into().0);
        let [shoulder, elbow, wrist] = self.distances(&frames);
        let mut unitless = jacobian(&frames, &frames[5].translation.vector);
        unitless.fixed_rows_mut::<3>(0).unscale_mut(self.reach_mm());
        SingularityDistance { shoulder, elbow, wrist, smallest_singular_value: smallest_singular_value(&unitless) }
    }

    /// Returns the joint positions that bring the flange to a pose in the arm's base, on the branch nearest to
    /// `reference`.
    ///
    /// Nearest is the least sum of squares over the six joints. A joint that may turn more than once takes the turn
    /// nearest to the reference. If the wrist is singular, joint 6 (joint 4 on a spherical wrist) keeps the reference's
    /// position; so does joint 6 of the A12 if it is on the axis of joint 1 and any position of it would do. The flange
    /// is within 0.001 mm and 0.0001 degrees of the pose. For a pose of the tool in a user frame see
    /// [`Frames::flange`](crate::Frames::flange).
    pub fn inverse(
        &self,
        flange: impl Into<Transform>,
        reference: impl Into<JointPosition>,
    ) -> Result<JointPosition, NoSolution> {
        let target = flange.into().0;
        let candidates = self.candidates(&target, &reference.into().0)?;
        let mut confirmed = candidates.iter().filter_map(|joints| self.confirmed(joints, &target));
        confirmed.next().ok_or(NoSolution::NotConfirmed)
    }

    /// Returns the joint positions of every branch that bring the flange to a pose in the arm's base, as
    /// [`inverse`](Self::inverse) finds them, the nearest to `reference` first.
    ///
    /// If the wrist is singular, any position of one joint would do; there is a branch for the reference's position
    /// only. Branches of the A12 that meet are one, also within about a tenth of a degree of each other.
    pub fn inverse_all(
        &self,
        flange: impl Into<Transform>,
        reference: impl Into<JointPosition>,
    ) -> Result<Branches, NoSolution> {
        let target = flange.into().0;
        let candidates = self.candidates(&target, &reference.into().0)?;
        let mut branches = Branches::default();
        let confirmed = candidates.iter().filter_map(|joints| self.confirmed(joints, &target));
        confirmed.for_each(|joints| branches.add(joints));
        if branches.is_empty() { Err(NoSolution::NotConfirmed) } else { Ok(branches) }
    }

    /// Returns joint positions for [`fit`](Self::fit), for which to ask a controller for `kine_forward` (section 4.46),
    /// which moves nothing. All joints differ, within the middle of their ranges.
    pub fn positions_to_compare(&self) -> [JointPosition; 12] {
        fit::positions_to_compare(self)
    }

    /// Compares the model with the poses of the controller's `kine_forward` (section 4.46) for joint positions.
    ///
    /// The controller's poses are of its tool in its user frame, and follow its mounting, which no known query returns.
    /// So the computation first finds the two constant transforms before and after the arm that fit all poses best. It
    /// does not compare figures that these transforms absorb: the height of the base, the length of the flange, and the
    /// zeros of joints 1 and 6.
    ///
    /// ```
    /// use jaka_motion::{Frames, Model, Tolerance};
    /// use jaka_proto::messages::types::Pose;
    ///
    /// let arm = Model::named("Zu 7").expect("a published arm");
    /// let tool = Pose::from_millimetres_degrees([10.0, 0.0, 150.0], [0.0, 30.0, 0.0]);
    /// let frames = Frames::new().with_tool(tool);
    /// // In place of what the controller answers:
    /// let pairs = arm.positions_to_compare().map(|joints| (joints, frames.pose(arm.forward(joints))));
    ///
    /// let fit = arm.fit(&pairs, Tolerance::default())?;
    /// assert!(fit.position_mm < 1e-6 && fit.frames.tool().distance_mm(&tool.into()) < 1e-6);
    ///
    /// let other = Model::named("Zu 5").expect("a published arm");
    /// assert!(other.fit(&pairs, Tolerance::default()).is_err());
    /// # Ok::<(), jaka_motion::FitError>(())
    /// ```
    ///
    /// # Errors
    /// The poses do not determine the frames, or the model differs from the poses.
    pub fn fit(&self, pairs: &[(JointPosition, Pose)], tolerance: Tolerance) -> Result<Fit, FitError> {
        fit::fit(self, pairs, tolerance)
    }

    /// Returns the distances of shoulder, elbow and wrist from their singularities, for the frames of the joints.
    pub(crate) fn distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        self.signed_distances(frames).map(f64::abs)
    }

    /// Returns the distances, with opposite signs on the two sides of a singularity.
    pub(crate) fn signed_distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        match self.closed_form.wrist {
            Wrist::Parallel | Wrist::Spherical => self.three_distances(frames),
            Wrist::Offset => {
                let determinant = jacobian(frames, &frames[5].translation.vector).determinant();
                // NaN if the frames are not finite.
                let far = if determinant.is_finite() { 1.0 } else { f64::NAN };
                [far, far, determinant / self.links.largest_determinant()]
            }
        }
    }

    /// Returns the three distances; their product times lengths is the determinant of the Jacobian.
    fn three_distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        let at = |index: usize| frames[index].translation.vector;
        let axis = |index: usize| frames[index].rotation * Vector3::z();
        // Joint 2 turns both in one plane; lengths along its axis do not count.
        let in_plane = |bar: Vector3<f64>| bar - axis(1) * axis(1).dot(&bar);
        let (upper_arm, forearm) = (in_plane(at(2) - at(1)), in_plane(at(3) - at(2)));
        let (bend, turn) = (upper_arm.cross(&forearm), axis(3).cross(&axis(5)));
        [
            axis(0).cross(&axis(1)).dot(&(at(4) - at(0))) / self.reach_mm(),
            bend.norm().copysign(bend.dot(&axis(1))) / (upper_arm.norm() * forearm.norm()),
            turn.norm().copysign(turn.dot(&axis(4))),
        ]
    }

    /// Whether the closed form is that of other links, so that Newton steps must improve its angles.
    fn is_calibrated(&self) -> bool {
        self.closed_form.precision == Precision::FirstGuess
    }

    fn compare(
        &self,
        parameter: &'static str,
        found: &[f64; 6],
        published: &[f64; 6],
        most: f64,
    ) -> Result<(), DhMismatch> {
        // `<=` and not `>`: not-a-number differs, too.
        let near = |index: &usize| (found[*index] - published[*index]).abs() <= most;
        (0..6).find(|index| !near(index)).map_or(Ok(()), |index| {
            let (found, published) = (found[index], published[index]);
            Err(DhMismatch { model: self.name, parameter, joint: index + 1, found, published })
        })
    }

    /// Returns the solutions of the closed form, in degrees and within the joints' ranges, nearest to the reference
    /// first.
    fn candidates(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Result<AngleSets, NoSolution> {
        if !target.to_homogeneous().iter().chain(reference).all(|number| number.is_finite()) {
            return Err(NoSolution::NotFinite);
        }
        let distance = target.translation.vector.norm();
        if distance > FAR {
            return Err(NoSolution::OutOfReach { by_mm: distance });
        }
        let form = &self.closed_form;
        let found = form.solve(target, &form.links.angles(reference));
        let (mut candidates, mut beyond) = (AngleSets::new(), None::<(f64, NoSolution)>);
        for angles in &found.angles {
            let joints = form.links.positions(angles);
            let joints = if self.is_calibrated() { self.links.refined(joints, target, USUAL) } else { joints };
            match self.nearest_turns(&joints, reference) {
                Ok(joints) => candidates.push(joints),
                Err(other) => beyond = Some(beyond.filter(|least| least.0 <= other.0).unwrap_or(other)),
            }
        }
        if candidates.is_empty() {
            let missed = found.short_mm.map_or(NoSolution::Orientation, |by_mm| NoSolution::OutOfReach { by_mm });
            return Err(beyond.map_or(missed, |(_, reason)| reason));
        }
        let distance = |joints: &[f64; 6]| -> f64 {
            joints.iter().zip(reference).map(|(joint, reference)| (joint - reference).powi(2)).sum()
        };
        candidates.sort_unstable_by(|one, other| distance(one).total_cmp(&distance(other)));
        Ok(candidates)
    }

    /// Turns each joint by the number of full turns that brings it nearest to the reference. An error is for the joint
    /// that is furthest beyond its range, with that distance in degrees.
    fn nearest_turns(&self, joints: &[f64; 6], reference: &[f64; 6]) -> Result<[f64; 6], (f64, NoSolution)> {
        let (mut turned, mut furthest) = ([0.0; 6], None::<(f64, NoSolution)>);
        for index in 0..6 {
            match self.nearest_turn(index, joints[index], reference[index]) {
                Ok(position) => turned[index] = position,
                Err(other) => furthest = Some(furthest.filter(|beyond| beyond.0 >= other.0).unwrap_or(other)),
            }
        }
        furthest.map_or(Ok(turned), Err)
    }

    fn nearest_turn(&self, index: usize, position: f64, reference: f64) -> Result<f64, (f64, NoSolution)> {
        let (min, max) = (self.joint_min[index], self.joint_max[index]);
        let lowest = min - ON_LIMIT + (position - min + ON_LIMIT).rem_euclid(360.0);
        let from_reference = |position: &f64| (position - reference).abs();
        std::iter::successors(Some(lowest), |position| Some(position + 360.0))
            .take_while(|position| *position <= max + ON_LIMIT)
            .min_by(|one, other| from_reference(one).total_cmp(&from_reference(other)))
            .map(|position| position.clamp(min, max))
            .ok_or_else(|| {
                let beyond = |position_deg: f64, limit_deg: f64| {
                    let reason = NoSolution::BeyondRange { joint: index + 1, position_deg, limit_deg };
                    ((position_deg - limit_deg).abs(), reason)
                };
                let (above, below) = (beyond(lowest, max), beyond(lowest - 360.0, min));
                if above.0 <= below.0 { above } else { below }
            })
    }

    /// Returns the joint positions, after Newton steps if rounding has left an error; `None` if they do not bring the
    /// flange to the target.
    fn confirmed(&self, joints: &[f64; 6], target: &Isometry3<f64>) -> Option<JointPosition> {
        let refined = self.links.refined(*joints, target, USUAL);
        let joints = if self.is_within_range(refined) { refined } else { *joints };
        (self.links.error(&joints, target) < ACCEPTED).then_some(JointPosition(joints))
    }
}

/// Returns the Zu 5.
impl Default for Model {
    fn default() -> Self {
        PUBLISHED[0].clone()
    }
}

impl Point {
    /// All points, in the order of their numbers.
    pub(crate) const ALL: [Self; 3] = [Self::Tcp, Self::Elbow, Self::Wrist];

    /// Returns the index of the joint frame at the point; for the tool centre point, of the flange.
    pub(crate) fn frame(self) -> usize {
        match self {
            Self::Tcp => 5,
            Self::Elbow => 2,
            Self::Wrist => 4,
        }
    }
}

impl fmt::Display for DhMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { model, parameter, joint, found, published } = self;
        let unit = if matches!(*parameter, "a" | "d") { "mm" } else { "deg" };
        write!(
            f,
            "DH parameter {parameter} of joint {joint} is {found} {unit}; that of the {model} is {published} {unit}"
        )
    }
}

impl std::error::Error for DhMismatch {}

/// Returns the letters and digits of a name in lower case, without the vendor's name.
fn plain(name: &str) -> String {
    let letters: String = name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
    letters.strip_prefix("jaka").map(str::to_owned).unwrap_or(letters)
}

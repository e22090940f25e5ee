//! One arm's figures.

mod dh;
mod forward;
pub(crate) mod inverse;
mod point;
mod published;
mod singularity;

use jaka_proto::messages::types::JointPosition;

pub use self::dh::DhMismatch;
pub use self::point::Point;
use self::published::PUBLISHED;
pub use self::singularity::{Singularity, SingularityDistance};
use crate::closed_form::{ClosedForm, Precision};
use crate::links::Links;

/// The figures of one arm: its Denavit-Hartenberg parameters, joint ranges and joint speeds, in millimetres and
/// degrees.
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
    /// Of the links, or of the ones nearest to them that have one.
    pub(crate) closed_form: ClosedForm,
    pub(crate) joint_min: [f64; 6],
    pub(crate) joint_max: [f64; 6],
    pub(crate) joint_speed: [f64; 6],
}

impl Model {
    /// Every published arm, the default first.
    ///
    /// Lengths, ranges and speeds are those of the vendor's URDF files; a controller's own lengths can differ by some
    /// tenths of a millimetre.
    pub fn published() -> &'static [Self] {
        &PUBLISHED
    }

    /// The published arm of this name; case, blanks, punctuation and a leading "JAKA" do not matter: `Zu 5`,
    /// `jaka_zu5`, `ZU-5`.
    pub fn named(name: &str) -> Option<&'static Self> {
        let wanted = plain(name);
        PUBLISHED.iter().find(|model| plain(model.name) == wanted)
    }

    /// The vendor's name of the arm, without "JAKA".
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Link twists in degrees, as `get_dh_param` (section 4.82) answers them.
    pub fn alpha(&self) -> &[f64; 6] {
        &self.links.alpha
    }

    /// Link lengths in mm, as `get_dh_param` answers them.
    pub fn a(&self) -> &[f64; 6] {
        &self.links.a
    }

    /// Link offsets in mm, as `get_dh_param` answers them.
    pub fn d(&self) -> &[f64; 6] {
        &self.links.d
    }

    /// The offset from each joint position to the link's angle, in degrees, as `get_dh_param` answers it.
    pub fn joint_home_offset(&self) -> &[f64; 6] {
        &self.links.joint_home_offset
    }

    /// The lower end of each joint's range in degrees.
    pub fn joint_min(&self) -> &[f64; 6] {
        &self.joint_min
    }

    /// The upper end of each joint's range in degrees.
    pub fn joint_max(&self) -> &[f64; 6] {
        &self.joint_max
    }

    /// The highest speed of each joint in deg/s.
    pub fn joint_speed(&self) -> &[f64; 6] {
        &self.joint_speed
    }

    /// The sum of all lengths in mm: no point of the flange is further from the base.
    pub fn reach_mm(&self) -> f64 {
        self.links.length()
    }

    /// Whether every joint position is a number within the joint's range.
    pub fn is_within_range(&self, joints: impl Into<JointPosition>) -> bool {
        let ranges = self.joint_min.iter().zip(&self.joint_max);
        joints.into().0.iter().zip(ranges).all(|(joint, (min, max))| min <= joint && joint <= max)
    }

    /// Whether the closed form is that of other links, so that its angles are improved step by step.
    fn is_calibrated(&self) -> bool {
        self.closed_form.precision == Precision::FirstGuess
    }
}

/// The Zu 5.
impl Default for Model {
    fn default() -> Self {
        PUBLISHED[0].clone()
    }
}

/// The letters and digits of a name in lower case, without the vendor's.
fn plain(name: &str) -> String {
    let letters: String = name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
    letters.strip_prefix("jaka").map(str::to_owned).unwrap_or(letters)
}

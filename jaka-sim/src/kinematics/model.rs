//! One arm's figures.

use super::published::PUBLISHED;

/// The figures of one arm: its Denavit-Hartenberg parameters, joint limits and joint speeds, in millimetres and
/// degrees.
///
/// ```
/// use jaka_sim::Model;
///
/// let arm = Model::default();
/// assert_eq!(arm.name(), "Zu 5");
///
/// let joints = [10.0, 60.0, 80.0, 30.0, -90.0, 0.0].into();
/// let flange = arm.flange(joints);
/// let found = arm.joints(flange, joints).expect("a pose the arm was just in");
/// assert!(found.0.iter().zip(joints.0).all(|(found, joint)| (found - joint).abs() < 1e-6));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(super) name: &'static str,
    pub(super) alpha: [f64; 6],
    pub(super) a: [f64; 6],
    pub(super) d: [f64; 6],
    pub(super) joint_home_offset: [f64; 6],
    pub(super) joint_min: [f64; 6],
    pub(super) joint_max: [f64; 6],
    pub(super) joint_speed: [f64; 6],
    pub(super) wrist: Wrist,
}

/// The geometry of the last three axes, which decides the closed form of the inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wrist {
    /// Joint 4 is parallel to joints 2 and 3, and the three wrist axes do not meet.
    Parallel,
    /// The three wrist axes meet in one point.
    Spherical,
}

impl Model {
    /// Every published arm, the default first.
    pub fn published() -> &'static [Self] {
        &PUBLISHED
    }

    /// The arm of this name; case, blanks, punctuation and a leading "JAKA" do not matter: `Zu 5`, `jaka_zu5`,
    /// `ZU-5`.
    pub fn named(name: &str) -> Option<&'static Self> {
        let wanted = plain(name);
        PUBLISHED.iter().find(|model| plain(model.name) == wanted)
    }

    /// The vendor's name of the arm, without "JAKA".
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Link twists in degrees, as `get_dh_param` answers them.
    pub fn alpha(&self) -> &[f64; 6] {
        &self.alpha
    }

    /// Link lengths in mm, as `get_dh_param` answers them.
    pub fn a(&self) -> &[f64; 6] {
        &self.a
    }

    /// Link offsets in mm, as `get_dh_param` answers them.
    pub fn d(&self) -> &[f64; 6] {
        &self.d
    }

    /// The offset from each joint position to the link's angle, in degrees, as `get_dh_param` answers it.
    pub fn joint_home_offset(&self) -> &[f64; 6] {
        &self.joint_home_offset
    }

    /// The lower soft limit of each joint in degrees.
    pub fn joint_min(&self) -> &[f64; 6] {
        &self.joint_min
    }

    /// The upper soft limit of each joint in degrees.
    pub fn joint_max(&self) -> &[f64; 6] {
        &self.joint_max
    }

    /// The highest speed of each joint in deg/s.
    pub fn joint_speed(&self) -> &[f64; 6] {
        &self.joint_speed
    }

    /// Whether every joint position, in degrees, is a number within its soft limits.
    pub fn within_limits(&self, joints: &[f64; 6]) -> bool {
        joints
            .iter()
            .zip(self.joint_min.iter().zip(&self.joint_max))
            .all(|(joint, (min, max))| min <= joint && joint <= max)
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
    let pending: String = name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
    pending.strip_prefix("jaka").map(str::to_owned).unwrap_or(pending)
}

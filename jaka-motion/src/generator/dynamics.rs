//! Speeds, accelerations and jerks of the joints.

use super::GeneratorError;
use crate::braking::JointLimits;
use crate::limits::{Limits, RATES};

/// Bounds of the joints' motion: speed, acceleration and jerk of each joint, in deg/s, deg/s² and deg/s³.
///
/// ```
/// use jaka_motion::{Dynamics, Limits, Model};
///
/// let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
/// let gentle = Dynamics::of(&limits).with_speeds([30.0; 6])?.with_jerks([200.0; 6])?;
/// assert_eq!((gentle.accelerations()[0], gentle.jerks()[0]), (72.0, 200.0));
///
/// let wrong = gentle.with_accelerations([60.0, 60.0, -1.0, 60.0, 60.0, 60.0]).unwrap_err();
/// assert_eq!(wrong.to_string(), "acceleration of joint 3: -1 deg/s² is not from 0.001 to 1e9 deg/s²");
/// # Ok::<(), jaka_motion::GeneratorError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dynamics {
    speeds: [f64; 6],
    accelerations: [f64; 6],
    jerks: [f64; 6],
}

impl Dynamics {
    /// Returns the speeds, accelerations and jerks of the limits.
    pub fn of(limits: &Limits) -> Self {
        let (speeds, accelerations) = (*limits.joint_speeds(), *limits.joint_accelerations());
        Self { speeds, accelerations, jerks: *limits.joint_jerks() }
    }

    /// Sets the highest speeds of joints 1 to 6, in deg/s.
    ///
    /// # Errors
    /// A number is not from 0.001 to 1e9.
    pub fn with_speeds(self, deg_s: [f64; 6]) -> Result<Self, GeneratorError> {
        Ok(Self { speeds: computable("speed", "deg/s", deg_s)?, ..self })
    }

    /// Sets the highest accelerations of joints 1 to 6, in deg/s².
    ///
    /// # Errors
    /// A number is not from 0.001 to 1e9.
    pub fn with_accelerations(self, deg_s2: [f64; 6]) -> Result<Self, GeneratorError> {
        Ok(Self { accelerations: computable("acceleration", "deg/s²", deg_s2)?, ..self })
    }

    /// Sets the highest jerks of joints 1 to 6, in deg/s³.
    ///
    /// A jerk above the acceleration divided by the period of the set-points has no effect.
    ///
    /// # Errors
    /// A number is not from 0.001 to 1e9.
    pub fn with_jerks(self, deg_s3: [f64; 6]) -> Result<Self, GeneratorError> {
        Ok(Self { jerks: computable("jerk", "deg/s³", deg_s3)?, ..self })
    }

    /// Returns the highest speed of each joint in deg/s.
    pub fn speeds(&self) -> &[f64; 6] {
        &self.speeds
    }

    /// Returns the highest acceleration of each joint in deg/s².
    pub fn accelerations(&self) -> &[f64; 6] {
        &self.accelerations
    }

    /// Returns the highest jerk of each joint in deg/s³.
    pub fn jerks(&self) -> &[f64; 6] {
        &self.jerks
    }

    /// Checks that each value is in its range, and that speeds and accelerations are not beyond the limits.
    pub(super) fn check(&self, limits: &Limits) -> Result<(), GeneratorError> {
        computable("speed", "deg/s", self.speeds)?;
        computable("acceleration", "deg/s²", self.accelerations)?;
        computable("jerk", "deg/s³", self.jerks)?;
        within("speed", "deg/s", &self.speeds, limits.joint_speeds())?;
        within("acceleration", "deg/s²", &self.accelerations, limits.joint_accelerations())
    }

    /// Returns the limits for the computation: a joint takes at least a period to reach its speed or its acceleration.
    pub(super) fn joint_limits(&self, period_s: f64) -> [JointLimits; 6] {
        std::array::from_fn(|index| {
            let speed = self.speeds[index];
            let acceleration = self.accelerations[index].min(speed / period_s);
            JointLimits { speed, acceleration, jerk: self.jerks[index].min(acceleration / period_s) }
        })
    }
}

fn computable(what: &'static str, unit: &'static str, values: [f64; 6]) -> Result<[f64; 6], GeneratorError> {
    match (1..).zip(values).find(|(_, given)| !RATES.contains(given)) {
        Some((joint, given)) => {
            let (least, most) = (*RATES.start(), *RATES.end());
            Err(GeneratorError::OutOfRange { what, unit, joint, given, least, most })
        }
        None => Ok(values),
    }
}

fn within(what: &'static str, unit: &'static str, values: &[f64; 6], limits: &[f64; 6]) -> Result<(), GeneratorError> {
    match (1..).zip(values.iter().zip(limits)).find(|(_, (given, limit))| given > limit) {
        Some((joint, (given, limit))) => {
            Err(GeneratorError::BeyondLimit { what, unit, joint, given: *given, limit: *limit })
        }
        None => Ok(()),
    }
}

//! A model compared with what a controller computes.

mod error;
mod solve;

use jaka_proto::messages::types::{JointPosition, Pose};

pub use self::error::FitError;
use crate::frames::Frames;
use crate::model::Model;

/// How far a model may be from the controller's own poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Of the position, in mm.
    pub position_mm: f64,
    /// Of the orientation, in degrees.
    pub angle_deg: f64,
}

/// 0.5 mm and 0.01 degrees. Four poses of a real Zu 5 (captured on firmware 1.5.14) are within 0.42 mm and 0.00001 degrees of the
/// published model.
impl Default for Tolerance {
    fn default() -> Self {
        Self { position_mm: 0.5, angle_deg: 0.01 }
    }
}

/// A model that agrees with the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// What the controller's poses have before and after the arm: mounting and user frame together as the mounting, and the tool.
    pub frames: Frames,
    /// The largest difference of a position, in mm.
    pub position_mm: f64,
    /// The largest difference of an orientation, in degrees.
    pub angle_deg: f64,
}

/// The least that each joint must move over the poses, in degrees.
const LEAST_MOVED: f64 = 20.0;
/// The least number of poses. Three determine the frames, and more show whether the model agrees.
const LEAST_POSES: usize = 6;
/// Shares of a joint's range in steps that never come together: the fractions of square roots of primes.
const STEPS: [f64; 6] = [0.414_213_6, 0.732_050_8, 0.236_068, 0.645_751_3, 0.316_624_8, 0.605_551_3];

impl Model {
    /// Joint positions at which to ask a controller for `kine_forward` (section 4.46), which moves nothing, for
    /// [`fit`](Self::fit): all joints differ, within the middle of their ranges.
    pub fn positions_to_compare(&self) -> [JointPosition; 12] {
        let mut step = 0.0;
        [(); 12].map(|()| {
            step += 1.0;
            JointPosition(std::array::from_fn(|joint| {
                let (min, max) = (self.joint_min()[joint].max(-170.0), self.joint_max()[joint].min(170.0));
                min + (max - min) * (0.1 + 0.8 * (step * STEPS[joint]).fract())
            }))
        })
    }

    /// Compares the model with poses that the controller's `kine_forward` (section 4.46) answers for joint positions.
    ///
    /// The controller's poses are of its tool in its user frame, and follow its mounting, which no known query gives. So the two
    /// constant transforms before and after the arm are found first, as those that fit all poses best. What these can
    /// take up is not compared: the height of the base, the length of the flange, and the zeros of joints 1 and 6.
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
    /// The poses do not tell enough, or the model differs from them.
    pub fn fit(&self, pairs: &[(JointPosition, Pose)], tolerance: Tolerance) -> Result<Fit, FitError> {
        check(pairs)?;
        let frames = solve::frames(self, pairs).ok_or(FitError::TooAlike)?;
        let (mut fit, mut worst) = (Fit { frames, position_mm: 0.0, angle_deg: 0.0 }, pairs[0].0);
        for (joints, pose) in pairs {
            let ours = frames.pose(self.forward(*joints));
            let position_mm = ours.distance_mm(pose);
            if position_mm > fit.position_mm {
                (fit.position_mm, worst) = (position_mm, *joints);
            }
            fit.angle_deg = fit.angle_deg.max(ours.angle_deg(pose));
        }
        let Fit { position_mm, angle_deg, .. } = fit;
        if position_mm <= tolerance.position_mm && angle_deg <= tolerance.angle_deg {
            Ok(fit)
        } else {
            Err(FitError::Differs { model: self.name(), joints: worst, position_mm, angle_deg, tolerance })
        }
    }
}

/// Whether the poses can tell anything of the model.
fn check(pairs: &[(JointPosition, Pose)]) -> Result<(), FitError> {
    let finite = |(joints, pose): &(JointPosition, Pose)| {
        joints.0.iter().chain(&<[f64; 6]>::from(*pose)).all(|number| number.is_finite())
    };
    if !pairs.iter().all(finite) {
        return Err(FitError::NotFinite);
    }
    if pairs.len() < LEAST_POSES {
        return Err(FitError::TooFew { least: LEAST_POSES });
    }
    for joint in 0..6 {
        let positions = || pairs.iter().map(|(joints, _)| joints.0[joint]);
        let moved_deg = positions().fold(f64::MIN, f64::max) - positions().fold(f64::MAX, f64::min);
        if moved_deg < LEAST_MOVED {
            return Err(FitError::JointNotMoved { joint: joint + 1, moved_deg, least_deg: LEAST_MOVED });
        }
    }
    Ok(())
}

//! Comparison of a model with poses from a controller.

use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::{
    Isometry3, Matrix3, Matrix6, Rotation3, SMatrix, SVector, Translation3, UnitQuaternion, Vector3, Vector6,
};

use super::Model;
use crate::frames::Frames;
use crate::transform::Transform;

/// Greatest difference of a model from the controller's own poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Difference of the position, in mm.
    pub position_mm: f64,
    /// Difference of the orientation, in degrees.
    pub angle_deg: f64,
}

/// Returns 0.5 mm and 0.01 degrees. Four poses of a real Zu 5 (captured on firmware 1.5.14) are within 0.42 mm and
/// 0.00001 degrees of the published model.
impl Default for Tolerance {
    fn default() -> Self {
        Self { position_mm: 0.5, angle_deg: 0.01 }
    }
}

/// Result for a model that agrees with the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// Frames before and after the arm in the controller's poses: the mounting, which includes the user frame, and the
    /// tool.
    pub frames: Frames,
    /// Largest difference of a position, in mm.
    pub position_mm: f64,
    /// Largest difference of an orientation, in degrees.
    pub angle_deg: f64,
}

jaka_proto::worded! {
    /// Error for a model that was not accepted.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum FitError {
        /// A joint position or pose has a number that is not finite.
        NotFinite => "a number of the joint positions or poses is not finite",
        /// There are too few poses.
        TooFew {
            /// Least number of poses.
            least: usize,
        } => "too few poses to compare; at least {least} are needed",
        /// A joint hardly moves over the poses, so they give no evidence about it.
        JointNotMoved {
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Angle by which the joint moves, in degrees.
            moved_deg: f64,
            /// Least angle by which the joint must move, in degrees.
            least_deg: f64,
        } => "joint {joint} moves by {moved_deg:.1} deg over the poses to compare; at least {least_deg} deg are needed",
        /// The poses are turned about a single axis, so more than one tool and mounting fit them.
        TooAlike => "the poses to compare are rotated about a single axis",
        /// The model differs from the controller: the arm is another one, or is calibrated differently.
        Differs {
            /// Name of the model.
            model: &'static str,
            /// Joint position at which the position of the pose differs most.
            joints: JointPosition,
            /// Largest difference of a position, in mm.
            position_mm: f64,
            /// Largest difference of an orientation, in degrees.
            angle_deg: f64,
            /// Allowed difference.
            tolerance: Tolerance,
        } => (format!(
            "at joints {joints} the {model} differs from the controller by {position_mm:.3} mm and {angle_deg:.4} deg; \
             allowed are {} mm and {} deg",
            tolerance.position_mm, tolerance.angle_deg
        )),
    }
}

/// Least motion of each joint over the poses, in degrees.
const LEAST_MOVED: f64 = 20.0;
/// Least number of poses. Three determine the frames, and more show whether the model agrees.
const LEAST_POSES: usize = 6;
/// Steps through a joint's range, as shares of it, that never coincide: the fractions of square roots of primes.
const STEPS: [f64; 6] = [0.414_213_6, 0.732_050_8, 0.236_068, 0.645_751_3, 0.316_624_8, 0.605_551_3];
/// Least amount by which the second singular value must be below the first, for one solution. Both are 1 for turns
/// about a single axis.
const ONE_SOLUTION: f64 = 1e-3;
/// Greatest number of rounds of the search for singular values.
const ROUNDS: usize = 1000;

type Pairs = [(Isometry3<f64>, Isometry3<f64>)];

impl std::error::Error for FitError {}

/// Returns the joint positions for a comparison: see [`Model::positions_to_compare`].
pub(super) fn positions_to_compare(model: &Model) -> [JointPosition; 12] {
    let mut step = 0.0;
    [(); 12].map(|()| {
        step += 1.0;
        JointPosition(std::array::from_fn(|joint| {
            let (min, max) = (model.joint_min()[joint].max(-170.0), model.joint_max()[joint].min(170.0));
            min + (max - min) * (0.1 + 0.8 * (step * STEPS[joint]).fract())
        }))
    })
}

/// Compares a model with poses: see [`Model::fit`].
pub(super) fn fit(model: &Model, pairs: &[(JointPosition, Pose)], tolerance: Tolerance) -> Result<Fit, FitError> {
    check(pairs)?;
    let frames = best_frames(model, pairs).ok_or(FitError::TooAlike)?;
    let (mut fit, mut worst) = (Fit { frames, position_mm: 0.0, angle_deg: 0.0 }, pairs[0].0);
    // Poses of huge numbers have no distance.
    let known = |distance: f64| if distance.is_nan() { f64::INFINITY } else { distance };
    for (joints, pose) in pairs {
        let ours = frames.pose(model.forward(*joints));
        let position_mm = known(ours.distance_mm(pose));
        if position_mm > fit.position_mm {
            (fit.position_mm, worst) = (position_mm, *joints);
        }
        fit.angle_deg = fit.angle_deg.max(known(ours.angle_deg(pose)));
    }
    let Fit { position_mm, angle_deg, .. } = fit;
    if position_mm <= tolerance.position_mm && angle_deg <= tolerance.angle_deg {
        Ok(fit)
    } else {
        Err(FitError::Differs { model: model.name(), joints: worst, position_mm, angle_deg, tolerance })
    }
}

/// Checks that the poses are sufficient for a comparison.
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

/// Returns the transforms before and after the arm that fit pairs of flange and pose best; `None` if more than one
/// solution fits.
///
/// Each pair satisfies `P = L F R`, with L and R unknown. For the rotations, `P R^-1 = L F` is linear in the entries of
/// `R^-1` and of L. Their best values are the first singular vectors of the sum of the Kronecker products of the
/// transposes of F and P. The positions are then linear in those of L and R. Nothing is iterated, so nothing depends on
/// a first guess.
fn best_frames(model: &Model, pairs: &[(JointPosition, Pose)]) -> Option<Frames> {
    let pairs: Vec<_> =
        pairs.iter().map(|(joints, pose)| (model.forward(*joints).0, Transform::from(*pose).0)).collect();
    let (before, after) = rotations(&pairs)?;
    let (moved_before, moved_after) = positions(&pairs, &before)?;
    let transform = |place: Vector3<f64>, turn: &Rotation3<f64>| {
        Transform(Isometry3::from_parts(Translation3::from(place), UnitQuaternion::from_rotation_matrix(turn)))
    };
    let frames = Frames::new().with_mounting(transform(moved_before, &before));
    Some(frames.with_tool(transform(moved_after, &after)))
}

fn rotations(pairs: &Pairs) -> Option<(Rotation3<f64>, Rotation3<f64>)> {
    let mut sum = SMatrix::<f64, 9, 9>::zeros();
    let mut count = 0.0;
    for (flange, pose) in pairs {
        let [flange, pose] = [flange, pose].map(|frame| frame.rotation.to_rotation_matrix().into_inner().transpose());
        sum += flange.kronecker(&pose);
        count += 1.0;
    }
    let parts = (sum / count).try_svd(true, true, f64::EPSILON, ROUNDS)?;
    if parts.singular_values[1] > parts.singular_values[0] - ONE_SOLUTION {
        return None;
    }
    let after_inverse = square(&parts.u?.column(0).into_owned());
    let before = square(&parts.v_t?.row(0).transpose());
    // Both signs solve the equation; a rotation has a positive determinant.
    let sign = after_inverse.determinant().signum();
    Some((nearest_rotation(&(before * sign))?, nearest_rotation(&(after_inverse * sign))?.inverse()))
}

fn square(entries: &SVector<f64, 9>) -> Matrix3<f64> {
    Matrix3::from_column_slice(entries.as_slice())
}

fn nearest_rotation(matrix: &Matrix3<f64>) -> Option<Rotation3<f64>> {
    let parts = matrix.try_svd(true, true, f64::EPSILON, ROUNDS)?;
    let (u, v_t) = (parts.u?, parts.v_t?);
    let mirrored = (u * v_t).determinant().signum();
    Some(Rotation3::from_matrix_unchecked(u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, mirrored)) * v_t))
}

/// Returns the positions of L and R, by least squares.
fn positions(pairs: &Pairs, before: &Rotation3<f64>) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let (mut normal, mut right) = (Matrix6::zeros(), Vector6::zeros());
    for (flange, pose) in pairs {
        let mut row = SMatrix::<f64, 3, 6>::identity();
        row.fixed_columns_mut::<3>(3).copy_from((before * flange.rotation.to_rotation_matrix()).matrix());
        normal += row.transpose() * row;
        right += row.transpose() * (pose.translation.vector - before * flange.translation.vector);
    }
    let found = normal.cholesky()?.solve(&right);
    Some((found.fixed_rows::<3>(0).into_owned(), found.fixed_rows::<3>(3).into_owned()))
}

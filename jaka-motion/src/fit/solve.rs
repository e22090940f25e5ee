//! The transforms before and after the arm that fit pairs of flange and pose best.
//!
//! With `P = L F R` for each pair, where L and R are wanted: for the rotations `P R^-1 = L F` is linear in the entries of
//! `R^-1` and of L, and their best values are the first singular vectors of the sum of the Kronecker products of the
//! transposes of F and P. The positions are then linear in those of L and R. Nothing is iterated, so nothing depends on
//! a first guess.

use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::{
    Isometry3, Matrix3, Matrix6, Rotation3, SMatrix, SVector, Translation3, UnitQuaternion, Vector3, Vector6,
};

use crate::frames::Frames;
use crate::model::Model;
use crate::transform::Transform;

/// How much the second singular value must be below the first, for one solution. Both are 1 for turns about a single
/// axis.
const ONE_SOLUTION: f64 = 1e-3;
/// The most rounds of the search for singular values.
const ROUNDS: usize = 1000;

/// `None` if more than one solution fits.
pub(super) fn frames(model: &Model, pairs: &[(JointPosition, Pose)]) -> Option<Frames> {
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

type Pairs = [(Isometry3<f64>, Isometry3<f64>)];

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
    // Both signs solve the equation; a rotation does not mirror.
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

/// The positions of L and R, by least squares.
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

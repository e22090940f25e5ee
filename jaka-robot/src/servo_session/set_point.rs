//! Set-points, and those by which the arm is braked.

use jaka_proto::geometry::Quaternion;
use jaka_proto::messages::types::{JointPosition, Pose};

/// A set-point of one of the four kinds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SetPoint {
    Joints(JointPosition),
    JointOffset(JointPosition),
    Pose(Pose),
    PoseOffset(Pose),
}

/// Step from one set-point to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SetPointStep {
    /// Of the joints, in degrees.
    Joints([f64; 6]),
    /// Of the tool centre point: a position in millimetres, and a rotation vector in degrees.
    Pose([f64; 6]),
}

impl SetPoint {
    pub(super) fn is_pose(&self) -> bool {
        matches!(self, Self::Pose(_) | Self::PoseOffset(_))
    }
}

impl SetPointStep {
    pub(super) fn between_joints(from: JointPosition, to: JointPosition) -> Self {
        Self::Joints(difference(&to.0, &from.0))
    }

    pub(super) fn between_poses(from: Pose, to: Pose) -> Self {
        let [x, y, z, ..] = difference(&to.into(), &from.into());
        let [rx, ry, rz] = turn_between(from, to);
        Self::Pose([x, y, z, rx, ry, rz])
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Joints(parts) => Self::Joints(parts.map(|part| part * factor)),
            Self::Pose(parts) => Self::Pose(parts.map(|part| part * factor)),
        }
    }

    pub(super) fn is_none(&self) -> bool {
        let (Self::Joints(parts) | Self::Pose(parts)) = self;
        parts.iter().all(|part| *part == 0.0)
    }

    /// Difference from another step of the same kind; none for another kind.
    pub(super) fn change_from(&self, before: &Self) -> Option<Self> {
        match (self, before) {
            (Self::Joints(now), Self::Joints(before)) => Some(Self::Joints(difference(now, before))),
            (Self::Pose(now), Self::Pose(before)) => Some(Self::Pose(difference(now, before))),
            _ => None,
        }
    }
}

fn difference(one: &[f64; 6], other: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|part| one[part] - other[part])
}

/// The shorter way from one orientation to another.
fn turn_between(from: Pose, to: Pose) -> [f64; 3] {
    let (from, to) = (from.quaternion(), to.quaternion());
    let turn = product(to, Quaternion { w: from.w, x: -from.x, y: -from.y, z: -from.z });
    let sign = if turn.w < 0.0 { -1.0 } else { 1.0 };
    let axis = [turn.x * sign, turn.y * sign, turn.z * sign];
    let sine = length(axis);
    if sine == 0.0 {
        return [0.0; 3];
    }
    let degrees = (2.0 * sine.atan2(turn.w.abs())).to_degrees();
    axis.map(|part| part / sine * degrees)
}

/// The pose with its orientation turned, in the same position.
pub(super) fn turned(pose: Pose, turn: [f64; 3]) -> Pose {
    let degrees = length(turn);
    if degrees == 0.0 {
        return pose;
    }
    let half = degrees.to_radians() / 2.0;
    let [x, y, z] = turn.map(|part| part / degrees * half.sin());
    let turned = product(Quaternion { w: half.cos(), x, y, z }, pose.quaternion());
    // Only a pose that is not finite fails here, and such a pose is refused before it is sent.
    pose.with_quaternion(turned).unwrap_or(pose)
}

pub(super) fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

fn product(a: Quaternion, b: Quaternion) -> Quaternion {
    Quaternion {
        w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
        x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    }
}

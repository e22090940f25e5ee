//! Turns of the tool from one set-point to the next.
//!
//! A turn is about an axis that is fixed in the reference frame: the axis, as long as the angle in degrees.

use jaka_proto::geometry::Quaternion;
use jaka_proto::messages::types::Pose;

/// The shorter way from one orientation to another.
pub(super) fn between(from: Pose, to: Pose) -> [f64; 3] {
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

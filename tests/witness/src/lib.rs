//! Kinematics of an arm, computed a second time: from the vendor's URDF files, by plain matrices, without jaka-motion.

pub mod curve;
mod urdf;
pub mod way;

use std::f64::consts::FRAC_PI_2;

use self::urdf::{Joint, URDF};

/// Below this a length in metres is noise of the drawing.
const NOISE: f64 = 0.000_4;

/// A rotation and a position in mm: the first three rows of a homogeneous matrix.
pub type Frame = [[f64; 4]; 3];

/// An arm as its URDF describes it.
#[derive(Debug, Clone)]
pub struct Witness {
    joints: [Joint; 6],
    /// Frame of each joint on the link before it, at its zero.
    origins: [Frame; 6],
    flange: Frame,
}

impl Witness {
    /// The names of all arms.
    pub fn names() -> impl Iterator<Item = &'static str> {
        URDF.iter().map(|(name, _)| *name)
    }

    /// The arm as it is drawn, with up to 0.39 mm of noise a joint. The base mesh may lie aside of the axis of joint 1;
    /// only the height over the base counts.
    ///
    /// # Panics
    /// There is no such arm.
    pub fn drawn(name: &str) -> Self {
        let (_, mut joints) = *URDF.iter().find(|(arm, _)| *arm == name).expect("the vendor draws the arm");
        (joints[0][0], joints[0][1]) = (0.0, 0.0);
        // The mesh of the S7's last link is turned half way against those of its sisters; a flange is not.
        let half_turn = if name == "S7" { -1.0 } else { 1.0 };
        let flange = [[half_turn, 0.0, 0.0, 0.0], [0.0, half_turn, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        Self { joints, origins: origins(&joints), flange }
    }

    /// The arm without that noise: lengths in hundredths of a millimetre, and quarter turns.
    ///
    /// # Panics
    /// There is no such arm.
    pub fn published(name: &str) -> Self {
        let mut arm = Self::drawn(name);
        for joint in &mut arm.joints {
            let (place, turn) = joint.split_at_mut(3);
            for length in place.iter_mut() {
                *length = if length.abs() < NOISE { 0.0 } else { (*length * 1e5).round() / 1e5 };
            }
            for angle in &mut turn[..3] {
                *angle = (*angle / FRAC_PI_2).round() * FRAC_PI_2;
            }
        }
        // The other drawings of this forearm have 303.5 mm, and so do two programs.
        if name == "Zu 7" {
            arm.joints[3][0] = 0.3035;
        }
        arm.origins = origins(&arm.joints);
        arm
    }

    /// The flange in the arm's base for joint positions in degrees.
    pub fn flange(&self, joints: [f64; 6]) -> Frame {
        self.flange_of(&self.frames(joints))
    }

    fn flange_of(&self, frames: &[Frame; 6]) -> Frame {
        product(frames[5], self.flange)
    }

    /// The frames of the joints in the arm's base, with their axes along z, for joint positions in degrees.
    pub fn frames(&self, joints: [f64; 6]) -> [Frame; 6] {
        let mut frame = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        std::array::from_fn(|index| {
            let (sin, cos) = (self.joints[index][6] * joints[index].to_radians()).sin_cos();
            frame = product(frame, self.origins[index]);
            for row in &mut frame {
                (row[0], row[1]) = (row[0] * cos + row[1] * sin, row[1] * cos - row[0] * sin);
            }
            frame
        })
    }
}

fn origins(joints: &[Joint; 6]) -> [Frame; 6] {
    joints.map(|[x, y, z, roll, pitch, yaw, _]| pose([x * 1e3, y * 1e3, z * 1e3], [roll, pitch, yaw]))
}

/// Distance of two frames, in mm and degrees.
pub fn apart(one: Frame, other: Frame) -> (f64, f64) {
    let (mut moved, mut turned) = (0.0, 0.0);
    for (one, other) in one.iter().zip(other) {
        moved += (one[3] - other[3]).powi(2);
        turned += (0..3).map(|column| (one[column] - other[column]).powi(2)).sum::<f64>();
    }
    // The distance of two rotation matrices is the sine of half the angle, times the root of eight.
    (moved.sqrt(), 2.0 * (turned / 8.0).sqrt().min(1.0).asin().to_degrees())
}

/// The frame at a position in mm, turned about the fixed axes x, then y, then z, by angles in radians.
pub fn pose(place: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Frame {
    let about = |axis: usize, angle: f64| {
        let (next, last, (sin, cos)) = ((axis + 1) % 3, (axis + 2) % 3, angle.sin_cos());
        let mut frame = [[0.0; 4]; 3];
        frame[axis][axis] = 1.0;
        (frame[next][next], frame[next][last]) = (cos, -sin);
        (frame[last][next], frame[last][last]) = (sin, cos);
        frame
    };
    let mut frame = product(about(2, yaw), product(about(1, pitch), about(0, roll)));
    for (row, length) in frame.iter_mut().zip(place) {
        row[3] = length;
    }
    frame
}

/// The joint positions near others that bring the flange to a frame, by Newton's method; `None` if it does not get
/// there.
pub fn inverse(arm: &Witness, target: Frame, near: [f64; 6]) -> Option<[f64; 6]> {
    let mut joints = near;
    for _ in 0..8 {
        let frames = arm.frames(joints);
        let here = arm.flange_of(&frames);
        let off = off(here, target);
        if off.iter().all(|off| off.abs() < 1e-7) {
            return Some(joints);
        }
        // Each joint turns the flange about its axis.
        let mut rows = [[0.0; 7]; 6];
        for (index, frame) in frames.into_iter().enumerate() {
            let axis = frame.map(|row| row[2] * arm.joints[index][6]);
            let lever: [f64; 3] = std::array::from_fn(|row| here[row][3] - frame[row][3]);
            let moved = [
                axis[1] * lever[2] - axis[2] * lever[1],
                axis[2] * lever[0] - axis[0] * lever[2],
                axis[0] * lever[1] - axis[1] * lever[0],
            ];
            for row in 0..3 {
                rows[row][index] = moved[row];
                rows[row + 3][index] = axis[row] * TURN;
            }
        }
        for (row, off) in rows.iter_mut().zip(off) {
            row[6] = off;
        }
        let step = solved(rows)?;
        if step.iter().any(|step| step.abs() > 1.0) {
            return None;
        }
        for (joint, step) in joints.iter_mut().zip(step) {
            *joint += step.to_degrees();
        }
    }
    None
}

/// Weight of a radian against a millimetre.
const TURN: f64 = 1e3;

/// Offset from one frame to the other: mm along, and radians times [`TURN`] about x, y and z.
fn off(here: Frame, target: Frame) -> [f64; 6] {
    let mut off = [0.0; 6];
    for row in 0..3 {
        off[row] = target[row][3] - here[row][3];
    }
    for column in 0..3 {
        let (from, to) = (here.map(|row| row[column]), target.map(|row| row[column]));
        off[3] += (from[1] * to[2] - from[2] * to[1]) / 2.0 * TURN;
        off[4] += (from[2] * to[0] - from[0] * to[2]) / 2.0 * TURN;
        off[5] += (from[0] * to[1] - from[1] * to[0]) / 2.0 * TURN;
    }
    off
}

/// Six equations, solved by elimination; `None` if they are not independent.
fn solved(mut rows: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for pivot in 0..6 {
        let best = (pivot..6).max_by(|one, other| rows[*one][pivot].abs().total_cmp(&rows[*other][pivot].abs()))?;
        rows.swap(pivot, best);
        if rows[pivot][pivot].abs() < 1e-9 {
            return None;
        }
        let from = rows[pivot];
        for row in (0..6).filter(|row| *row != pivot) {
            let factor = rows[row][pivot] / from[pivot];
            for column in pivot..7 {
                rows[row][column] -= factor * from[column];
            }
        }
    }
    Some(std::array::from_fn(|row| rows[row][6] / rows[row][row]))
}

/// The turns about the fixed axes x, then y, then z, in degrees, that [`pose`] makes a frame's rotation of.
pub fn angles(frame: Frame) -> [f64; 3] {
    let level = frame[0][0].hypot(frame[1][0]);
    let pitch = (-frame[2][0]).atan2(level);
    let (roll, yaw) = if level > 1e-9 {
        (frame[2][1].atan2(frame[2][2]), frame[1][0].atan2(frame[0][0]))
    } else {
        (0.0, (-frame[0][1]).atan2(frame[1][1]))
    };
    [roll, pitch, yaw].map(f64::to_degrees)
}

/// One frame, seen from the other.
pub fn product(one: Frame, other: Frame) -> Frame {
    one.map(|row| {
        let mut sums = [0.0; 4];
        for (column, sum) in sums.iter_mut().enumerate() {
            *sum = (0..3).map(|inner| row[inner] * other[inner][column]).sum();
        }
        sums[3] += row[3];
        sums
    })
}

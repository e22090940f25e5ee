//! Forward kinematics of the arms whose joints 2, 3 and 4 are parallel, from their six lengths.

/// Pose of the flange: its x and z axes and its position in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flange {
    /// The x axis.
    pub x: [f64; 3],
    /// The z axis.
    pub z: [f64; 3],
    /// The position.
    pub place: [f64; 3],
}

/// The flange for joint positions in degrees. The lengths are the base's height, upper arm, forearm, and the offsets of
/// joints 4, 5 and 6, in mm.
pub fn forward(lengths: &[f64; 6], joints: &[f64; 6]) -> Flange {
    let [base, upper_arm, forearm, wrist_1, wrist_2, wrist_3] = lengths;
    let [q1, q2, q3, q4, q5, q6] = joints.map(f64::to_radians);
    let ((s1, c1), (s5, c5), (s6, c6)) = (q1.sin_cos(), q5.sin_cos(), q6.sin_cos());
    let ((s2, c2), (s23, c23), (s, c)) = (q2.sin_cos(), (q2 + q3).sin_cos(), (q2 + q3 + q4).sin_cos());
    // The plane of upper arm and forearm, from the side; then along the forearm's wrist, along joint 5, and aside.
    let (out, up) = (upper_arm * c2 + forearm * c23, base + upper_arm * s2 + forearm * s23);
    let (along, fifth, aside) = ([c * c1, c * s1, s], [s * c1, s * s1, -c], [-s1, c1, 0.0]);
    let mut flange = Flange { x: [0.0; 3], z: [0.0; 3], place: [out * c1, out * s1, up] };
    for axis in 0..3 {
        flange.z[axis] = -aside[axis] * c5 - along[axis] * s5;
        flange.x[axis] = (along[axis] * c5 - aside[axis] * s5) * c6 - fifth[axis] * s6;
        flange.place[axis] += aside[axis] * wrist_1 + fifth[axis] * wrist_2 + flange.z[axis] * wrist_3;
    }
    flange
}

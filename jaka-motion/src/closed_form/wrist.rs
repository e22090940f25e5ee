//! The angles of joints 2 to 6, for each kind of wrist.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};

use super::two_bars::two_bars;
use super::{ClosedForm, Found};

/// Below this sine of joint 5 two wrist axes are in line and only the sum of their angles counts.
const SINGULAR: f64 = 1e-7;

impl ClosedForm {
    /// Joint 4 parallel to 2 and 3: joints 5 and 6 follow from where the plane's normal points in the flange's frame.
    pub(super) fn parallel_wrist(&self, target: &Isometry3<f64>, first: f64, reference: &[f64; 6], found: &mut Found) {
        let normal = target.rotation.inverse() * Vector3::new(first.sin(), -first.cos(), 0.0);
        for fifth in wrist_turns(normal.x.hypot(normal.y), normal.z).into_iter().flatten() {
            let sixth = if fifth.sin().abs() < SINGULAR {
                reference[5]
            } else {
                (-normal.y * fifth.signum()).atan2(normal.x * fifth.signum())
            };
            self.planar(target, [first, 0.0, 0.0, 0.0, fifth, sixth], found);
        }
    }

    /// Joints 2, 3 and 4 move in one plane: two bars reach the wrist, and joint 4 makes the rest of the rotation.
    fn planar(&self, target: &Isometry3<f64>, known: [f64; 6], found: &mut Found) {
        let (before, after) = (self.links.product(0..1, &known), self.links.product(4..6, &known));
        let plane = flatten(&(before.inverse() * target * after.inverse()));
        let turn = plane.rotation.to_rotation_matrix();
        let total = turn[(1, 0)].atan2(turn[(0, 0)]);
        let (bars, at) = ([self.links.a[2], self.links.a[3]], plane.translation.vector);
        let [first, .., fifth, sixth] = known;
        match two_bars(bars, at.x, at.y, self.precision) {
            Ok(ways) => {
                for (second, third) in ways {
                    found.add([first, second, third, total - second - third, fifth, sixth]);
                }
            }
            Err(short_mm) => found.falls_short(short_mm),
        }
    }

    /// The wrist's axes meet: two bars reach that point, and the three wrist joints make the rest of the rotation.
    pub(super) fn spherical_wrist(&self, target: &Isometry3<f64>, first: f64, reference: &[f64; 6], found: &mut Found) {
        let (a, d) = (&self.links.a, &self.links.d);
        let plane = flatten(&(self.links.product(0..1, &[first; 6]).inverse() * target));
        let wrist = plane * Point3::new(0.0, 0.0, -d[5]);
        // The second bar leads from joint 3 to the wrist, at a fixed angle to the forearm's x axis.
        let (length, lean) = (a[3].hypot(d[3]), d[3].atan2(a[3]));
        match two_bars([a[2], length], wrist.x, wrist.y, self.precision) {
            Ok(ways) => {
                for (second, bend) in ways {
                    self.turns(target, [first, second, bend - lean], reference, found);
                }
            }
            Err(short_mm) => found.falls_short(short_mm),
        }
    }

    /// Joints 4, 5 and 6 from `Rz(fourth) Ry(-fifth) Rz(sixth)`.
    fn turns(&self, target: &Isometry3<f64>, arm: [f64; 3], reference: &[f64; 6], found: &mut Found) {
        let [first, second, third] = arm;
        let forearm = self.links.product(0..3, &[first, second, third, 0.0, 0.0, 0.0]).rotation;
        let left = quarter_turn() * (forearm.inverse() * target.rotation).to_rotation_matrix();
        for fifth in wrist_turns(left[(0, 2)].hypot(left[(1, 2)]), left[(2, 2)]).into_iter().flatten() {
            let fourth = if fifth.sin().abs() < SINGULAR {
                reference[3]
            } else {
                (-left[(1, 2)] * fifth.signum()).atan2(-left[(0, 2)] * fifth.signum())
            };
            found.add([first, second, third, fourth, fifth, last_turn(&left, fourth)]);
        }
    }
}

/// The two solutions for joint 5 from the magnitude of its sine and its cosine, or the only one where they coincide.
fn wrist_turns(sin: f64, cos: f64) -> [Option<f64>; 2] {
    let fifth = sin.atan2(cos);
    [Some(fifth), (sin >= SINGULAR).then_some(-fifth)]
}

/// Joint 6 for a known joint 4; valid even where the wrist is singular.
fn last_turn(left: &Rotation3<f64>, fourth: f64) -> f64 {
    let undone: Matrix3<f64> = Rotation3::from_axis_angle(&Vector3::z_axis(), -fourth) * left.matrix();
    undone[(1, 0)].atan2(undone[(1, 1)])
}

/// A transform in joint 1's frame, with the plane of the arm as x and y.
fn flatten(transform: &Isometry3<f64>) -> Isometry3<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -FRAC_PI_2) * transform
}

fn quarter_turn() -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2)
}

//! All joint angles that reach a pose, in closed form.
//!
//! Joints 2 and 3 are parallel on every arm here, so the wrist stays at a fixed distance from the vertical plane
//! through the base axis that joint 1 turns: that gives two solutions for joint 1. The wrist gives two for each, and the
//! triangle of upper arm and forearm two more: eight in all.

use std::f64::consts::{FRAC_PI_2, PI};

use arrayvec::ArrayVec;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};

use crate::links::Links;

/// Links that have a closed form: the angles between neighbouring axes are quarter turns or none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClosedForm {
    pub(crate) links: Links,
    pub(crate) wrist: Wrist,
    pub(crate) precision: Precision,
}

/// What the angles are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Precision {
    /// The links are the arm's: rounding is all that is left to take off.
    Exact,
    /// The arm's links are others, near to these, and the angles a first guess.
    FirstGuess,
}

/// Below this sine of joint 5 two wrist axes are in line and only the sum of their angles counts.
const SINGULAR: f64 = 1e-7;

impl Precision {
    /// How far out of reach, in mm, a target may be and still get the angles nearest to it: a pose on the wire has six
    /// decimals, and a calibrated arm reaches further than this one.
    fn slack_mm(self) -> f64 {
        match self {
            Self::Exact => 1e-4,
            Self::FirstGuess => 20.0,
        }
    }

    /// How far from a singularity, in radians, two branches are kept apart, so that steps from each lead to its own.
    fn apart(self) -> f64 {
        match self {
            Self::Exact => 0.0,
            Self::FirstGuess => 0.1,
        }
    }
}

/// How the last three axes lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wrist {
    /// Joint 4 is parallel to joints 2 and 3, and the three wrist axes do not meet.
    Parallel,
    /// The three wrist axes meet in one point.
    Spherical,
}

/// Sets of six numbers: the arms here have no more than eight branches.
pub(crate) type UpToEight = ArrayVec<[f64; 6], 8>;

/// Solutions for a target.
#[derive(Debug)]
pub(crate) struct Solutions {
    /// Angles of the links in radians.
    pub(crate) angles: UpToEight,
    /// How far the nearest branch without angles falls short, in mm.
    pub(crate) short_mm: f64,
}

impl Solutions {
    fn add(&mut self, angles: [f64; 6]) {
        // A ninth is dropped.
        let _ = self.angles.try_push(angles);
    }

    fn falls_short(&mut self, by_mm: f64) {
        self.short_mm = self.short_mm.min(by_mm);
    }
}

impl ClosedForm {
    /// The angles in radians that bring the flange to `target`; where the wrist is singular, the joint that is free keeps
    /// its angle from `reference`.
    pub(crate) fn solve(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Solutions {
        let mut found = Solutions { angles: UpToEight::new(), short_mm: f64::INFINITY };
        match self.base_angles(target) {
            Ok(firsts) => {
                for first in firsts {
                    match self.wrist {
                        Wrist::Parallel => self.parallel_wrist(target, first, reference, &mut found),
                        Wrist::Spherical => self.spherical_wrist(target, first, reference, &mut found),
                    }
                }
            }
            Err(short_mm) => found.falls_short(short_mm),
        }
        found
    }

    /// The links nearest to others that have this closed form: their lengths where it can have any, and its twists.
    pub(crate) fn nearest_to(&self, links: &Links) -> Links {
        let (mut a, mut d) = (self.links.a, links.d);
        (a[2], a[3]) = (links.a[2], links.a[3]);
        if self.wrist == Wrist::Spherical {
            d[4] = self.links.d[4];
        }
        Links { alpha: self.links.alpha, a, d, joint_home_offset: links.joint_home_offset }
    }

    /// Joint 1: the wrist's offset from the plane of the arm is `x sin - y cos`. An error is by how many mm the wrist is
    /// too near to the axis.
    fn base_angles(&self, target: &Isometry3<f64>) -> Result<[f64; 2], f64> {
        let d = &self.links.d;
        let wrist = target * Point3::new(0.0, 0.0, -d[5]);
        let offset = match self.wrist {
            Wrist::Parallel => d[1] + d[2] + d[3],
            Wrist::Spherical => d[1] + d[2],
        };
        let radius = wrist.x.hypot(wrist.y);
        let short_mm = offset.abs() - radius;
        if short_mm > self.precision.slack_mm() {
            return Err(short_mm);
        }
        let most = FRAC_PI_2 - self.precision.apart();
        let (direction, aside) = (wrist.y.atan2(wrist.x), (offset / radius).clamp(-1.0, 1.0).asin().clamp(-most, most));
        Ok([direction + aside, direction + PI - aside])
    }

    /// Joint 4 parallel to 2 and 3: joints 5 and 6 follow from where the plane's normal points in the flange's frame.
    fn parallel_wrist(&self, target: &Isometry3<f64>, first: f64, reference: &[f64; 6], found: &mut Solutions) {
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
    fn planar(&self, target: &Isometry3<f64>, known: [f64; 6], found: &mut Solutions) {
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
    fn spherical_wrist(&self, target: &Isometry3<f64>, first: f64, reference: &[f64; 6], found: &mut Solutions) {
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
    fn turns(&self, target: &Isometry3<f64>, arm: [f64; 3], reference: &[f64; 6], found: &mut Solutions) {
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

/// Two bars in a plane, joined end to end: the angles at the first joint and between the bars that bring the end to
/// `x, y`, two ways.
///
/// An error is by how many mm the end is too far away or too near, where that is more than the slack.
fn two_bars(bars: [f64; 2], x: f64, y: f64, precision: Precision) -> Result<[(f64, f64); 2], f64> {
    let ([first, second], distance) = (bars, x.hypot(y));
    let short = (distance - (first + second)).max((first - second).abs() - distance);
    if short > precision.slack_mm() {
        return Err(short);
    }
    let cos = (x * x + y * y - first * first - second * second) / (2.0 * first * second);
    let bend = cos.clamp(-1.0, 1.0).acos().clamp(precision.apart(), PI - precision.apart());
    Ok([bend, -bend].map(|bend| (y.atan2(x) - (second * bend.sin()).atan2(first + second * bend.cos()), bend)))
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

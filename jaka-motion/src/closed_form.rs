//! All joint angles that reach a pose, in closed form.
//!
//! Joints 2 and 3 are parallel on every supported arm, so the wrist stays at a fixed distance from the vertical plane
//! through the base axis that joint 1 turns. That gives two solutions for joint 1. The wrist gives two for each of
//! them, and the triangle of upper arm and forearm two more: eight in all. If the axes of the wrist do not meet and the
//! first of them lies along the forearm, joint 6 comes first, as a root of a polynomial ([`OffsetWrist`]): sixteen in
//! all.

use std::f64::consts::{FRAC_PI_2, PI};

use arrayvec::ArrayVec;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};

use crate::links::Links;
use crate::newton::{ACCEPTED, Refinement, USUAL};
use crate::offset_wrist::{OffsetWrist, Search, SixthAngles};

/// Links with a closed form: the angles between neighbouring axes are quarter turns or zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClosedForm {
    pub(crate) links: Links,
    pub(crate) wrist: Wrist,
    pub(crate) precision: Precision,
}

/// Required precision of the angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Precision {
    /// Precision for the arm's own links: only rounding errors remain to be removed.
    Exact,
    /// Precision for links that are only near to the arm's: the angles are a first guess.
    FirstGuess,
}

/// Sine of joint 5 below which two wrist axes are in line and only the sum of their angles counts.
const SINGULAR: f64 = 1e-7;

impl Precision {
    /// Returns the greatest distance out of reach, in mm, at which a target still gets the angles nearest to it. A pose
    /// on the wire has six decimals, and a calibrated arm may reach further than these links.
    fn slack_mm(self) -> f64 {
        match self {
            Self::Exact => 1e-4,
            Self::FirstGuess => 20.0,
        }
    }

    /// Returns the greatest distance out of reach, in mm, for guesses of an offset wrist, whose angle of joint 6 is
    /// approximate.
    fn rough_mm(self) -> f64 {
        match self {
            Self::Exact => 1.0,
            Self::FirstGuess => 20.0,
        }
    }

    /// Returns the resolution of the search for the angle of joint 6 on an offset wrist.
    fn search(self) -> Search {
        match self {
            Self::Exact => Search { touching: 1e-6, finest: 2e-5 },
            Self::FirstGuess => Search { touching: 1e-3, finest: 1e-3 },
        }
    }

    /// Returns the distance, in radians, that two branches keep from a singularity, so that steps from each reach its
    /// own solution.
    fn apart(self) -> f64 {
        match self {
            Self::Exact => 0.0,
            Self::FirstGuess => 0.1,
        }
    }
}

/// Arrangement of the last three axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wrist {
    /// Joint 4 parallel to joints 2 and 3, and three wrist axes that do not meet.
    Parallel,
    /// Three wrist axes that meet in one point.
    Spherical,
    /// Axis of joint 4 along the forearm, and axis of joint 6 at an offset from it.
    Offset,
}

/// Sets of six numbers: the supported arms have no more than sixteen branches.
pub(crate) type AngleSets = ArrayVec<[f64; 6], 16>;

/// Solutions for a target.
#[derive(Debug)]
pub(crate) struct Solutions {
    /// Angles of the links in radians.
    pub(crate) angles: AngleSets,
    /// Shortfall of the nearest branch without angles, in mm; `None` if no branch falls short.
    pub(crate) short_mm: Option<f64>,
}

/// Angles of the links of an offset wrist before their refinement.
#[derive(Debug, Clone, Copy)]
struct Guess {
    /// Whether the guess comes from a place where roots meet.
    is_rough: bool,
    /// Cosine between the axes of joints 4 and 5.
    miss: f64,
    angles: [f64; 6],
}

/// Guesses for all roots.
type Guesses = ArrayVec<Guess, 128>;

/// Room for rounding: the shortfall that a length may have, in mm, and the distance of branches from a singularity, in
/// radians.
#[derive(Debug, Clone, Copy)]
struct Room {
    slack_mm: f64,
    apart: f64,
}

/// Greatest cosine between the axes of joints 4 and 5 of a guess; it is 0 on the arm. Above it the guess is of another
/// branch.
const MOST_MISS: f64 = 0.05;
/// Difference, in radians, below which two solutions may be one.
const NEAR: f64 = 0.02;
/// Least ratio of the error midway between two solutions to their own error, if they are distinct.
const BETWEEN: f64 = 10.0;
/// Refinement of an offset wrist's angles, also for two solutions that nearly meet.
const REFINEMENT: Refinement = Refinement { exact: 1e-11, damping: 1e-6 };

impl Solutions {
    fn add(&mut self, angles: [f64; 6]) {
        // A seventeenth is dropped.
        let _ = self.angles.try_push(angles);
    }

    fn falls_short(&mut self, by_mm: f64) {
        self.short_mm = Some(self.short_mm.map_or(by_mm, |least| least.min(by_mm)));
    }
}

impl ClosedForm {
    /// Returns the angles in radians that bring the flange to `target`. If the wrist is singular, the free joint keeps
    /// its angle from `reference`.
    pub(crate) fn solve(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Solutions {
        let mut found = Solutions { angles: AngleSets::new(), short_mm: None };
        match self.wrist {
            Wrist::Parallel => {
                self.in_planes(target, &mut found, |first, found| self.parallel_wrist(target, first, reference, found));
            }
            Wrist::Spherical => {
                self.in_planes(target, &mut found, |first, found| {
                    self.spherical_wrist(target, first, reference, found);
                });
            }
            Wrist::Offset => self.offset_wrist(target, reference, &mut found),
        }
        found
    }

    /// Calls `solve` for each angle of joint 1 that brings the arm's plane to the wrist.
    fn in_planes(&self, target: &Isometry3<f64>, found: &mut Solutions, solve: impl Fn(f64, &mut Solutions)) {
        match self.base_angles(self.wrist_centre(target), self.room()) {
            Ok(firsts) => firsts.into_iter().for_each(|first| solve(first, found)),
            Err(short_mm) => found.falls_short(short_mm),
        }
    }

    /// Returns the links of this closed form that are nearest to others: it takes their lengths where the form permits
    /// any, and keeps its own twists.
    pub(crate) fn nearest_to(&self, links: &Links) -> Links {
        let (mut a, mut d) = (self.links.a, links.d);
        (a[2], a[3]) = (links.a[2], links.a[3]);
        match self.wrist {
            Wrist::Parallel => {}
            Wrist::Spherical => d[4] = self.links.d[4],
            Wrist::Offset => a[3] = self.links.a[3],
        }
        Links { alpha: self.links.alpha, a, d, joint_home_offset: links.joint_home_offset }
    }

    /// Returns the point at which the axis of joint 6 meets that of joint 5.
    fn wrist_centre(&self, target: &Isometry3<f64>) -> Point3<f64> {
        target * Point3::new(0.0, 0.0, -self.links.d[5])
    }

    fn room(&self) -> Room {
        Room { slack_mm: self.precision.slack_mm(), apart: self.precision.apart() }
    }

    /// Returns the distance of the wrist from the plane through the base axis; on an offset wrist, the distance of the
    /// end of the forearm.
    fn aside(&self) -> f64 {
        let d = &self.links.d;
        match self.wrist {
            Wrist::Parallel => d[1] + d[2] + d[3],
            Wrist::Spherical | Wrist::Offset => d[1] + d[2],
        }
    }

    /// Returns the two angles of joint 1: the offset of a point from the plane of the arm is `x sin - y cos`. An error
    /// is the distance, in mm, by which the point is too near to the axis.
    fn base_angles(&self, point: Point3<f64>, room: Room) -> Result<[f64; 2], f64> {
        let (offset, radius) = (self.aside(), point.x.hypot(point.y));
        let short_mm = offset.abs() - radius;
        if short_mm > room.slack_mm {
            return Err(short_mm);
        }
        let most = FRAC_PI_2 - room.apart;
        let (direction, aside) = (point.y.atan2(point.x), (offset / radius).clamp(-1.0, 1.0).asin().clamp(-most, most));
        Ok([direction + aside, direction + PI - aside])
    }

    /// Solves for a joint 4 parallel to 2 and 3: joints 5 and 6 follow from the direction of the plane's normal in the
    /// flange's frame.
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

    /// Solves for joints 2, 3 and 4, which move in one plane: two bars reach the wrist, and joint 4 makes the rest of
    /// the rotation.
    fn planar(&self, target: &Isometry3<f64>, known: [f64; 6], found: &mut Solutions) {
        let (before, after) = (self.links.product(0..1, &known), self.links.product(4..6, &known));
        let plane = flatten(&(before.inverse() * target * after.inverse()));
        let turn = plane.rotation.to_rotation_matrix();
        let total = turn[(1, 0)].atan2(turn[(0, 0)]);
        let (bars, at) = ([self.links.a[2], self.links.a[3]], plane.translation.vector);
        let [first, .., fifth, sixth] = known;
        match two_bars(bars, at.x, at.y, self.room()) {
            Ok(ways) => {
                for (second, third) in ways {
                    found.add([first, second, third, total - second - third, fifth, sixth]);
                }
            }
            Err(short_mm) => found.falls_short(short_mm),
        }
    }

    /// Solves for wrist axes that meet: two bars reach their point, and the three wrist joints make the rest of the
    /// rotation.
    fn spherical_wrist(&self, target: &Isometry3<f64>, first: f64, reference: &[f64; 6], found: &mut Solutions) {
        let (a, d) = (&self.links.a, &self.links.d);
        let plane = flatten(&(self.links.product(0..1, &[first; 6]).inverse() * target));
        let wrist = plane * Point3::new(0.0, 0.0, -d[5]);
        // The second bar is from joint 3 to the wrist, at a fixed angle to the forearm's x axis.
        let (length, lean) = (a[3].hypot(d[3]), d[3].atan2(a[3]));
        match two_bars([a[2], length], wrist.x, wrist.y, self.room()) {
            Ok(ways) => {
                for (second, bend) in ways {
                    self.turns(target, [first, second, bend - lean], reference, found);
                }
            }
            Err(short_mm) => found.falls_short(short_mm),
        }
    }

    /// Solves for joints 4, 5 and 6 from `Rz(fourth) Ry(-fifth) Rz(sixth)`.
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

    /// Solves for an offset wrist. Joint 6 comes from a polynomial. The arm's plane and its two bars follow from the
    /// point at which joints 4 and 5 then meet; joints 4 and 5 follow from their axes.
    fn offset_wrist(&self, target: &Isometry3<f64>, reference: &[f64; 6], found: &mut Solutions) {
        let (a, d, length) = (&self.links.a, &self.links.d, self.links.length());
        let wrist = self.wrist_centre(target) - Point3::new(0.0, 0.0, d[0]);
        // Joint 4 turns the wrist about the elbow far enough to make the two the sides of a triangle.
        let (upper_arm, forearm) = (a[2].hypot(self.aside()), d[3].hypot(d[4]));
        let short_mm = (wrist.norm() - (upper_arm + forearm)).max((upper_arm - forearm).abs() - wrist.norm());
        if short_mm > self.precision.slack_mm() {
            found.falls_short(short_mm);
            return;
        }
        let equation = OffsetWrist {
            wrist: wrist / length,
            across: [target.rotation * Vector3::x(), target.rotation * Vector3::y()],
            bars: [a[2] / length, d[3] / length],
            aside: self.aside() / length,
            offset: d[4] / length,
        };
        let angles = equation.sixth_angles(self.precision.search()).unwrap_or_else(|| SixthAngles::one(reference[5]));
        let mut guesses = Guesses::new();
        angles.roots.iter().for_each(|sixth| self.guess(target, &equation, *sixth, false, &mut guesses));
        angles.touching.iter().for_each(|sixth| self.guess(target, &equation, *sixth, true, &mut guesses));
        guesses.sort_unstable_by(|one, other| one.is_rough.cmp(&other.is_rough).then(one.miss.total_cmp(&other.miss)));
        for guess in &guesses {
            self.add_guess(target, guess, found);
        }
    }

    /// Adds the guesses for an angle of joint 6 that may bring the flange to `target`.
    fn guess(&self, target: &Isometry3<f64>, equation: &OffsetWrist, sixth: f64, is_rough: bool, all: &mut Guesses) {
        let (a, d) = (&self.links.a, &self.links.d);
        let (sin, cos) = sixth.sin_cos();
        let (axis, room) = (equation.fifth_axis(sin, cos), Room { slack_mm: self.precision.rough_mm(), apart: 0.0 });
        let point = self.wrist_centre(target) - axis * d[4];
        let Ok(firsts) = self.base_angles(point, room) else { return };
        for first in firsts {
            let place = flatten(&self.links.product(0..1, &[first; 6]).inverse()) * point;
            let Ok(ways) = two_bars([a[2], d[3]], place.x, place.y, room) else { continue };
            for (second, bend) in ways {
                // The axis of joint 4, and so the forearm, is a quarter turn behind the link.
                let third = bend + FRAC_PI_2;
                let arm = self.links.product(0..3, &[first, second, third, 0.0, 0.0, 0.0]).rotation * quarter_turn();
                let seen = arm.inverse() * axis;
                let fourth = seen.x.atan2(-seen.y);
                let hand = arm * Rotation3::from_axis_angle(&Vector3::z_axis(), fourth) * quarter_turn();
                let last = hand.inverse() * (target.rotation * Vector3::z());
                let (fifth, miss) = (last.x.atan2(-last.y), seen.z.abs());
                if miss < MOST_MISS {
                    let _ =
                        all.try_push(Guess { is_rough, miss, angles: [first, second, third, fourth, fifth, sixth] });
                }
            }
        }
    }

    /// Adds the solution that a guess leads to, if it exists and is new.
    fn add_guess(&self, target: &Isometry3<f64>, guess: &Guess, found: &mut Solutions) {
        let error = |angles: &[f64; 6]| self.links.error(&self.links.positions(angles), target);
        let angles = match self.precision {
            Precision::Exact => {
                let joints = self.links.refined(self.links.positions(&guess.angles), target, REFINEMENT);
                self.links.angles(&joints)
            }
            Precision::FirstGuess => guess.angles,
        };
        let off = error(&angles);
        let is_same = |other: &[f64; 6]| {
            let apart: [f64; 6] =
                std::array::from_fn(|index| (other[index] - angles[index] + PI).rem_euclid(2.0 * PI) - PI);
            let middle = std::array::from_fn(|index| angles[index] + 0.5 * apart[index]);
            let is_near = apart.iter().all(|apart| apart.abs() < NEAR);
            let between = || self.off_between(&middle, target) >= BETWEEN * off.max(error(other)).max(USUAL.exact);
            is_near && !(self.is_exact() && between())
        };
        if (off < ACCEPTED || !self.is_exact()) && !found.angles.iter().any(is_same) {
            found.add(angles);
        }
    }

    /// Returns the error of the flange between two solutions, after Newton steps of the joints that are not singular.
    /// The error is above zero unless the two solutions are one.
    fn off_between(&self, angles: &[f64; 6], target: &Isometry3<f64>) -> f64 {
        let mut joints = self.links.positions(angles);
        for _ in 0..2 {
            joints = self.links.newton(&joints, target, USUAL.damping).unwrap_or(joints);
        }
        self.links.error(&joints, target)
    }

    fn is_exact(&self) -> bool {
        self.precision == Precision::Exact
    }
}

/// Returns, for two bars in a plane that are joined end to end, the angles at the first joint and between the bars that
/// bring the end to `x, y`. There are two solutions.
///
/// An error is the distance, in mm, by which the end is too far away or too near, if it exceeds the slack.
fn two_bars(bars: [f64; 2], x: f64, y: f64, room: Room) -> Result<[(f64, f64); 2], f64> {
    let ([first, second], distance) = (bars, x.hypot(y));
    let short = (distance - (first + second)).max((first - second).abs() - distance);
    if short > room.slack_mm {
        return Err(short);
    }
    let cos = (x * x + y * y - first * first - second * second) / (2.0 * first * second);
    let bend = cos.clamp(-1.0, 1.0).acos().clamp(room.apart, PI - room.apart);
    Ok([bend, -bend].map(|bend| (y.atan2(x) - (second * bend.sin()).atan2(first + second * bend.cos()), bend)))
}

/// Returns the two solutions for joint 5 from the magnitude of its sine and its cosine, or the only one if they
/// coincide.
fn wrist_turns(sin: f64, cos: f64) -> [Option<f64>; 2] {
    let fifth = sin.atan2(cos);
    [Some(fifth), (sin >= SINGULAR).then_some(-fifth)]
}

/// Returns joint 6 for a known joint 4; valid even if the wrist is singular.
fn last_turn(left: &Rotation3<f64>, fourth: f64) -> f64 {
    let undone: Matrix3<f64> = Rotation3::from_axis_angle(&Vector3::z_axis(), -fourth) * left.matrix();
    undone[(1, 0)].atan2(undone[(1, 1)])
}

/// Returns a transform in joint 1's frame, with the plane of the arm as x and y.
fn flatten(transform: &Isometry3<f64>) -> Isometry3<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -FRAC_PI_2) * transform
}

fn quarter_turn() -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2)
}

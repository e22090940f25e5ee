//! All joint angles that reach a pose, in closed form.
//!
//! Joints 2 and 3 are parallel on every arm here, so the wrist stays at a fixed distance from the vertical plane
//! through the base axis that joint 1 turns: that gives two solutions for joint 1. The wrist gives two for each, and the
//! triangle of upper arm and forearm two more: eight in all.

mod two_bars;
mod wrist;

use std::f64::consts::{FRAC_PI_2, PI};

use arrayvec::ArrayVec;
use nalgebra::{Isometry3, Point3};

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

/// What was found.
#[derive(Debug)]
pub(crate) struct Found {
    /// Angles of the links in radians.
    pub(crate) angles: UpToEight,
    /// How far the nearest branch without angles falls short, in mm.
    pub(crate) short_mm: f64,
}

impl Found {
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
    pub(crate) fn solve(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Found {
        let mut found = Found { angles: UpToEight::new(), short_mm: f64::INFINITY };
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
}

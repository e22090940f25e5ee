//! Joints that follow the tool along a line or an arc.

use nalgebra::{Isometry3, Point3, Vector3, Vector6};

use super::Checker;
use super::arm::Arm;
use super::path::{EvenTurn, ToolPath};
use super::placed_regions::PlacedRegions;
use super::radii::{BEND_MM, LEAST_STEP};
use crate::beyond::{Exceeded, Found};
use crate::limits::{Limits, rounded_up};
use crate::model::{Point, Singularity};
use crate::speed::TcpSpeed;

/// Length of a path, in mm, below which it only turns the tool.
const ONLY_TURNS_MM: f64 = 0.1;
/// Longest step, in mm of the path and in degrees of the tool's turn.
const LONGEST_STEP: (f64, f64) = (10.0, 2.0);
/// Greatest motion of a joint in a step, in degrees.
const JOINT_STEP: f64 = 1.0;
/// Greatest deviation of a joint from an even turn within a step, in degrees.
const JOINT_BEND: f64 = 0.05;
/// Greatest difference between a step and the mean of the rates at its ends, in degrees: a greater one means another
/// branch.
const JOINT_JUMP: f64 = 0.1;
/// Least step, as a share of the path. A joint that turns a degree in it is at a singularity.
const LEAST_FOLLOWED: f64 = 1e-9;
/// Greatest number of steps, including rejected ones.
const MOST_STEPS: u32 = 50_000;
/// Distance from a singularity below which an error for a fast joint names the singularity.
const NEAR: f64 = 0.1;
/// Number of samples in the search for the place at which the path is furthest out of reach.
const REACH_STEPS: u32 = 64;

/// Check of a line or an arc.
pub(super) struct Following<'a> {
    arm: &'a Arm,
    limits: &'a Limits,
    regions: PlacedRegions<'a>,
    path: ToolPath,
    tolerance: f64,
    /// Share of the path that is covered in a second; `None` if the path only turns the tool.
    per_second: Option<f64>,
    /// Joint positions at the start.
    start: [f64; 6],
    /// Frames of the joints at the start.
    start_frames: [Isometry3<f64>; 6],
    /// Least permitted distance from each singularity.
    least: [f64; 3],
}

/// State of the joints at a share of the path.
#[derive(Debug, Clone)]
struct PathSample {
    share: f64,
    joints: [f64; 6],
    /// Rates of the joints, in degrees for the length of the whole path.
    rates: [f64; 6],
    /// Changes of the rates, from which the next sample is guessed.
    curve: [f64; 6],
    frames: [Isometry3<f64>; 6],
    distances: [f64; 3],
}

impl<'a> Following<'a> {
    pub(super) fn new(
        arm: &'a Arm,
        limits: &'a Limits,
        regions: PlacedRegions<'a>,
        from: &[f64; 6],
        path: ToolPath,
        asked: TcpSpeed,
    ) -> Self {
        let (length_mm, frames, least) = (path.length_mm(), arm.frames(from), limits.singularity_distance());
        Self {
            arm,
            limits,
            regions,
            tolerance: asked.tolerance_mm,
            per_second: (length_mm >= ONLY_TURNS_MM).then(|| asked.speed_mm_s / length_mm),
            start: *from,
            least: arm.distances(&frames).map(|distance| distance.min(least)),
            start_frames: frames,
            path,
        }
    }

    /// Follows the path, and returns the joint positions at its end.
    pub(super) fn follow(&self) -> Result<[f64; 6], Found> {
        let even_turns = self.path.even_turns().ok_or((Exceeded::HalfTurn, 0.0))?;
        let (mut joints, mut share, mut steps) = (self.start, 0.0, 0);
        for even_turn in &even_turns {
            let longest = self.longest_step(even_turn);
            let mut here = self.sample(even_turn, share, &joints).ok_or_else(|| self.lost(share, &joints))?;
            self.check(&here)?;
            let mut step = longest;
            while here.share < even_turn.end {
                steps += 1;
                if steps > MOST_STEPS {
                    return Err((Exceeded::TooLong, here.share));
                }
                step = step.min(here.joint_step());
                if step < LEAST_FOLLOWED {
                    return Err(self.lost(here.share, &here.joints));
                }
                let next_share = if here.share + step < even_turn.end { here.share + step } else { even_turn.end };
                match self.advance(even_turn, &here, next_share)? {
                    Some(next) => (here, step) = (next, longest.min(1.5 * step)),
                    None => step = 0.5 * (next_share - here.share),
                }
            }
            (joints, share) = (here.joints, here.share);
        }
        Ok(joints)
    }

    fn longest_step(&self, even_turn: &EvenTurn) -> f64 {
        let (most_mm, most_deg) = LONGEST_STEP;
        (most_mm / self.path.length_mm()).min(most_deg / even_turn.turn.norm().to_degrees()).clamp(LEAST_STEP, 1.0)
    }

    /// Returns the next sample, or `None` if a violation between it and this one could go unnoticed.
    fn advance(&self, even_turn: &EvenTurn, here: &PathSample, share: f64) -> Result<Option<PathSample>, Found> {
        let step = share - here.share;
        let guess = std::array::from_fn(|index| {
            here.joints[index] + step * (here.rates[index] + 0.5 * step * here.curve[index])
        });
        let Some(mut next) = self.sample(even_turn, share, &guess).filter(|next| continuous(here, next)) else {
            return Ok(None);
        };
        next.curve = std::array::from_fn(|index| (next.rates[index] - here.rates[index]) / step);
        self.check(&next)?;
        let clear = self.speeds_clear(here, &next)
            && self.singularities_clear(here, &next)
            && self.point_clear(even_turn, Point::Elbow, here, &next)?
            && self.point_clear(even_turn, Point::Wrist, here, &next)?;
        Ok(clear.then_some(next))
    }

    fn sample(&self, even_turn: &EvenTurn, share: f64, guess: &[f64; 6]) -> Option<PathSample> {
        let solved = self.arm.solved(&self.path.at(share), guess)?;
        let (moved, turned) = (self.path.velocity(share), even_turn.turn);
        let rates = solved.rates(&Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z))?;
        let distances = self.arm.distances(&solved.frames);
        Some(PathSample { share, joints: solved.joints, rates, curve: [0.0; 6], frames: solved.frames, distances })
    }

    /// Checks the limits that hold at each share of the path.
    fn check(&self, here: &PathSample) -> Result<(), Found> {
        let there = |exceeded| (exceeded, here.share);
        self.limits.axes().check_positions(&here.joints, &self.start).map_err(there)?;
        self.limits.clearance().check(&self.least, &here.distances).map_err(there)?;
        self.check_speeds(here).map_err(there)?;
        for point in [Point::Elbow, Point::Wrist] {
            self.check_point(point, &here.frames).map_err(there)?;
        }
        Ok(())
    }

    fn check_speeds(&self, here: &PathSample) -> Result<(), Exceeded> {
        let Some(per_second) = self.per_second else { return Ok(()) };
        let limits = self.limits.joint_speeds();
        let factor = |index: usize| (here.rates[index] * per_second).abs() / limits[index];
        let index = (0..6).fold(0, |worst, index| if factor(index) > factor(worst) { index } else { worst });
        let (speed_deg_s, limit_deg_s) = ((here.rates[index] * per_second).abs(), limits[index]);
        if speed_deg_s <= rounded_up(limit_deg_s) {
            return Ok(());
        }
        let (which, distance) = Singularity::nearest(&here.distances);
        let near = (distance < NEAR).then_some(which);
        Err(Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near })
    }

    fn check_point(&self, point: Point, frames: &[Isometry3<f64>; 6]) -> Result<(), Exceeded> {
        let start = place(point, &self.start_frames);
        self.regions.check(point, Some(&start), &place(point, frames), self.tolerance).map(|_| ())
    }

    /// Whether no joint can have exceeded its speed limit between two samples by more than the stated amount.
    fn speeds_clear(&self, here: &PathSample, next: &PathSample) -> bool {
        let Some(per_second) = self.per_second else { return true };
        let limits = self.limits.joint_speeds();
        (0..6).all(|index| {
            let (one, other) = (here.rates[index], next.rates[index]);
            let peak = one.abs().max(other.abs()) + 0.5 * (other - one).abs();
            peak * per_second <= (1.0 + Checker::AMOUNT_SPEED) * limits[index]
        })
    }

    /// Whether no singularity can have been nearer between two samples than the least distance, up to the stated
    /// amount.
    fn singularities_clear(&self, here: &PathSample, next: &PathSample) -> bool {
        let turned = |index: usize| {
            let moved = (next.joints[index] - here.joints[index]).abs();
            (moved + 2.0 * bend(here, next, index)).to_radians()
        };
        let changes = self.arm.radii().distances_change(&std::array::from_fn(turned));
        (0..3).all(|index| {
            let least = 0.5 * (here.distances[index] + next.distances[index] - changes[index]);
            self.least[index] <= 0.0 || least >= self.least[index] - Checker::AMOUNT_SINGULARITY
        })
    }

    /// Checks that elbow or wrist cannot have been beyond a region between two samples by more than the stated amount;
    /// returns false if the step is too long to decide.
    fn point_clear(
        &self,
        even_turn: &EvenTurn,
        point: Point,
        here: &PathSample,
        next: &PathSample,
    ) -> Result<bool, Found> {
        if !self.regions.limit(point) {
            return Ok(true);
        }
        let step = next.share - here.share;
        let change = velocity(point, next) - velocity(point, here);
        // Twice the deviation for an even change.
        if 0.25 * step * change.norm() > BEND_MM {
            return Ok(false);
        }
        let way = [place(point, &here.frames), place(point, &next.frames)];
        let start = place(point, &self.start_frames);
        for part in self.regions.crossings(point, Some(&start), way, self.tolerance) {
            let share = here.share + part * step;
            let guess =
                std::array::from_fn(|index| here.joints[index] + part * (next.joints[index] - here.joints[index]));
            let Some(crossing) = self.sample(even_turn, share, &guess) else { return Ok(false) };
            self.check_point(point, &crossing.frames).map_err(|exceeded| (exceeded, share))?;
        }
        Ok(true)
    }

    /// Returns the reason that the joints cannot follow any further: the path leaves the arm's reach, or it passes
    /// through a singularity.
    fn lost(&self, share: f64, joints: &[f64; 6]) -> Found {
        let (mut furthest, mut turned) = (None::<(f64, f64)>, None);
        for step in 0..=REACH_STEPS {
            let share = share + (1.0 - share) * f64::from(step) / f64::from(REACH_STEPS);
            match self.arm.any_branch(&self.path.at(share), joints) {
                Err(Exceeded::OutOfReach { by_mm }) if furthest.is_none_or(|(most_mm, _)| by_mm >= most_mm) => {
                    furthest = Some((by_mm, share));
                }
                Err(Exceeded::Orientation) if turned.is_none() => turned = Some(share),
                _ => {}
            }
        }
        if let Some((by_mm, share)) = furthest {
            return (Exceeded::OutOfReach { by_mm }, share);
        }
        if let Some(share) = turned {
            return (Exceeded::Orientation, share);
        }
        (self.limits.clearance().nearest(&self.arm.distances(&self.arm.frames(joints))), share)
    }
}

impl PathSample {
    /// Returns the longest step in which no joint turns by more than 0.95 of the permitted angle.
    fn joint_step(&self) -> f64 {
        0.95 * JOINT_STEP / self.rates.iter().fold(0.0, |fastest: f64, rate| fastest.max(rate.abs()))
    }
}

/// Whether the joints moved from one sample to the other without a jump, and evenly enough.
fn continuous(here: &PathSample, next: &PathSample) -> bool {
    let step = next.share - here.share;
    (0..6).all(|index| {
        let moved = next.joints[index] - here.joints[index];
        let even = 0.5 * step * (here.rates[index] + next.rates[index]);
        moved.abs() <= JOINT_STEP && (moved - even).abs() <= JOINT_JUMP && bend(here, next, index) <= JOINT_BEND
    })
}

/// Returns the deviation of a joint from an even turn between two samples, in degrees, if its rate changes evenly.
fn bend(here: &PathSample, next: &PathSample, index: usize) -> f64 {
    0.125 * (next.share - here.share) * (next.rates[index] - here.rates[index]).abs()
}

fn place(point: Point, frames: &[Isometry3<f64>; 6]) -> Point3<f64> {
    frames[point.frame()].translation.vector.into()
}

/// Returns the velocity of elbow or wrist, in mm for the length of the whole path.
fn velocity(point: Point, here: &PathSample) -> Vector3<f64> {
    let at = place(point, &here.frames).coords;
    let parts = here.frames.iter().zip(here.rates).take(point.frame()).map(|(frame, rate)| {
        (frame.rotation * Vector3::z()).cross(&(at - frame.translation.vector)) * rate.to_radians()
    });
    parts.sum()
}

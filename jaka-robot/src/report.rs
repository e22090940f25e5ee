//! Reports of motions: times, set-points and trajectories.

mod histogram;

use std::time::Duration;

use self::histogram::Histogram;
use crate::SelectedFrames;
#[cfg(feature = "serde")]
use crate::form;
use crate::under_way::UnderWay;

/// Report of a motion, a servo session, a stream or a trajectory. A motion that the controller plans has no set-points.
///
/// With the feature `serde` it is written with one key more: `lateness`, with `p50_s`, `p90_s`, `p99_s` and `max_s`, or
/// `null` without set-points.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Report {
    /// Time for which the end was waited for; of set-points, the time since servo mode was entered.
    #[cfg_attr(feature = "serde", serde(rename = "waited_s", serialize_with = "form::seconds"))]
    pub waited: Duration,
    /// Number of set-points sent, without the landing.
    pub cycles: u64,
    /// Set-points sent more than half a period late.
    pub late_cycles: u64,
    /// Gaps: set-points late by three periods or more. The SDK assumes that the arm rested then.
    pub gaps: u64,
    /// The longest of these, by the lateness of the set-point after it; zero without a gap.
    #[cfg_attr(feature = "serde", serde(rename = "longest_gap_s", serialize_with = "form::seconds"))]
    pub longest_gap: Duration,
    /// Set-points of the landing, which braked the arm and held it.
    pub landing_cycles: u64,
    /// Answers that accepted a set-point.
    pub accepted: u64,
    /// Answers that refused one.
    pub refused: u64,
    /// Set-points without an answer.
    pub unanswered: u64,
    /// The most answers that were outstanding at once.
    pub most_outstanding: usize,
    /// Fields that status packets never have, as their type declares
    /// ([`MotionStatus::absent`](crate::MotionStatus::absent)). Without `error_code`, an error of the controller is not
    /// seen.
    pub absent: &'static [&'static str],
    /// Frames that were selected at the start, by status packets. Where an id is none, packets do not show it, or this
    /// program has changed the frames itself: another change of it was not noticed.
    pub frames: SelectedFrames,
    /// Rapid rate (`rapidrate`): of the rates in the packets that were looked at, at least the newest one before each
    /// set-point, the one furthest from 1. None if they show none. That it scales set-points is a hypothesis: no source
    /// says so.
    pub rapid_rate: Option<f64>,
    /// Report of a trajectory; none for other motions.
    pub trajectory: Option<TrajectoryReport>,
    lateness: Histogram,
}

/// Report of a trajectory that was followed.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct TrajectoryReport {
    /// The trajectory time of the last set-point on the trajectory.
    #[cfg_attr(feature = "serde", serde(rename = "reached_s", serialize_with = "form::seconds"))]
    pub reached: Duration,
    /// Duration of the trajectory at its own speed.
    #[cfg_attr(feature = "serde", serde(rename = "duration_s", serialize_with = "form::seconds"))]
    pub duration: Duration,
    /// True if the arm was braked straight on in joint space, off the trajectory, because braking along it would have
    /// taken too long: see [`FollowRun`](crate::FollowRun). This also holds at speed after a panic of the run's own
    /// thread.
    pub has_left_curve: bool,
    /// Lag of the arm behind its set-points, by status packets; `None` if these do not show it.
    pub lag: Option<FollowLag>,
}

/// Lag of an arm behind its set-points, by the joints of status packets.
///
/// The delay is the one with which set-points and packets agree best, by the sum of the squares of all joints'
/// differences. It is measured from sending a set-point to receiving a packet: the link's and the packets' own delay
/// are part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FollowLag {
    /// The delay that fits best, in steps of 1 ms.
    #[cfg_attr(feature = "serde", serde(rename = "delay_s", serialize_with = "form::seconds"))]
    pub delay: Duration,
    /// Distance of each joint from its delayed set-points, in degrees: the root of the mean of the squares.
    pub residual_deg: [f64; 6],
    /// Greatest distance of each joint from them, in degrees.
    pub worst_deg: [f64; 6],
    /// Number of packets that were compared.
    pub packets: u32,
}

impl Report {
    /// Lateness of set-points, at a share from 0 to 1 of them: 0.99 for the 99th percentile, 1 for the maximum. Correct
    /// to 3 %, and to a microsecond.
    pub fn lateness(&self, share: f64) -> Duration {
        self.lateness.at(share)
    }

    /// Report of set-points, with all the memory that it takes, beside packets without these fields.
    pub(crate) fn of_set_points(absent: &'static [&'static str]) -> Self {
        Self { lateness: Histogram::new(), absent, ..Self::default() }
    }

    /// Report of a motion that the controller plans.
    pub(crate) fn of_wait(waited: Duration) -> Self {
        Self { waited, ..Self::default() }
    }

    /// Notes fields that packets leave out.
    pub(crate) fn without(self, absent: &'static [&'static str]) -> Self {
        Self { absent, ..self }
    }

    /// Records changes under way.
    pub(crate) fn saw(&mut self, under_way: &UnderWay) {
        (self.frames, self.rapid_rate) = (under_way.frames(), under_way.rapid_rate());
    }

    /// Adds the report of a trajectory.
    pub(crate) fn of_trajectory(self, trajectory: TrajectoryReport) -> Self {
        Self { trajectory: Some(trajectory), ..self }
    }

    /// Counts a set-point that was so late.
    pub(crate) fn late(&mut self, late: Duration, period: Duration) {
        self.cycles += 1;
        self.late_cycles += u64::from(late > period / 2);
        self.lateness.add(late);
    }

    /// Counts a gap.
    pub(crate) fn gap(&mut self, late: Duration) {
        self.gaps += 1;
        self.longest_gap = self.longest_gap.max(late);
    }
}

//! Report on a trajectory before it is followed, and on its end.

use std::collections::BTreeMap;
use std::fmt::Write;

use jaka_motion::{Checker, Sample, Trajectory};
use jaka_robot::{Cause, End, FollowLag};
use serde::Serialize;

use crate::arm::motion::Ended;
use crate::failure::Failure;
use crate::terminal::output;
use crate::text::number::{fixed, milliseconds};

/// Step of the search for peaks, in seconds, and greatest number of steps.
const STEP_S: f64 = 0.001;
const MOST_STEPS: f64 = 1e6;

/// Greatest number of printed slow points.
pub(super) const SLOW_PLACES: usize = 5;

/// Greatest speeds of a trajectory, in deg/s, and its greatest accelerations, in deg/s².
#[derive(Debug, Serialize)]
pub(super) struct Peaks {
    #[serde(rename = "highest_speeds_deg_s")]
    pub(super) speeds: [f64; 6],
    #[serde(rename = "largest_accelerations_deg_s2")]
    accelerations: [f64; 6],
    /// Greatest speed of the tool, in mm/s.
    #[serde(rename = "highest_flange_speed_mm_s")]
    tool: f64,
}

/// Trajectory that was compared with limits, for programs.
#[derive(Serialize)]
pub(super) struct Checked<'t> {
    #[serde(flatten)]
    pub(super) trajectory: &'t Trajectory,
    #[serde(flatten)]
    pub(super) peaks: &'t Peaks,
}

impl Peaks {
    /// Finds the largest values, in steps of 1 ms, or larger steps for more than 1000 s.
    pub(super) fn of(trajectory: &Trajectory, checker: &Checker) -> Self {
        let duration_s = trajectory.duration_s();
        let step_s = STEP_S.max(duration_s / MOST_STEPS);
        let mut peaks = Self { speeds: [0.0; 6], accelerations: [0.0; 6], tool: 0.0 };
        let (mut time_s, mut last): (f64, Option<[f64; 3]>) = (0.0, None);
        loop {
            let sample = trajectory.at(time_s);
            for joint in 0..6 {
                peaks.speeds[joint] = peaks.speeds[joint].max(sample.velocity[joint].abs());
                peaks.accelerations[joint] = peaks.accelerations[joint].max(sample.acceleration[joint].abs());
            }
            let here = tool_at(&sample, checker);
            let moved =
                last.map_or(0.0, |last| (0..3).map(|axis| (here[axis] - last[axis]).powi(2)).sum::<f64>().sqrt());
            (peaks.tool, last) = (peaks.tool.max(moved / step_s), Some(here));
            if time_s >= duration_s {
                return peaks;
            }
            time_s += step_s;
        }
    }
}

/// Returns the position of the tool centre point, in mm.
pub(super) fn tool_at(sample: &Sample, checker: &Checker) -> [f64; 3] {
    checker.frames().pose(checker.limits().model().forward(sample.joints)).position_mm()
}

/// Returns the report for people on the checks and on the peaks of the trajectory.
pub(super) fn checked(trajectory: &Trajectory, peaks: &Peaks, checker: &Checker) -> String {
    let (count, duration_s, limits) = (trajectory.way_points().len(), trajectory.duration_s(), checker.limits());
    let name = limits.model().name();
    let mut out =
        format!("{count} way-points, {duration_s:.3} s, within the limits of the {name}; nothing was sent\n\n");
    let _ = writeln!(out, "{:10}{:>26}{:>28}", "", "highest speed", "largest acceleration");
    for joint in 0..6 {
        let speed = format!("{} of {} deg/s", fixed(peaks.speeds[joint], 1), limits.joint_speeds()[joint]);
        let most = limits.joint_accelerations()[joint];
        let acceleration = format!("{} of {most} deg/s²", fixed(peaks.accelerations[joint], 1));
        let _ = writeln!(out, "joint {:<4}{speed:>26}{acceleration:>28}", joint + 1);
    }
    let most = limits.tcp_speed().map_or_else(String::new, |most| format!(" of {most}"));
    let _ = writeln!(out, "{:10}{:>26}", "flange", format!("{}{most} mm/s", fixed(peaks.tool, 1)));
    for place in trajectory.slow_places().iter().take(SLOW_PLACES) {
        let percent = fixed(100.0 * place.share, 0);
        let _ =
            writeln!(out, "at {} s: {percent} % of the tool's speed, limited by {}", fixed(place.time_s, 3), place.by);
    }
    out
}

/// Prints the end; as JSON for any end.
pub(super) fn print(ended: Ended, as_json: bool) -> Result<(), Failure> {
    let end = &ended.end;
    if as_json {
        output::json_line(&BTreeMap::from([("end", end)]))?;
    } else if end.cause() == Cause::Reached {
        output::line(&completed(end))?;
    }
    ended.reached()
}

fn completed(end: &End) -> String {
    let lag = lag(end).map_or_else(String::new, |lag| format!(", the arm lagged by {} ms", lag.delay.as_millis()));
    let (cycles, late) = (end.report.cycles, milliseconds(end.report.lateness(0.99)));
    format!("{}{lag}; of {cycles} set-points 99 % were at most {} ms late", end.cause(), fixed(late, 2))
}

fn lag(end: &End) -> Option<FollowLag> {
    end.report.trajectory.as_ref().and_then(|trajectory| trajectory.lag)
}

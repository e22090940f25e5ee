//! Judgement of the wire, set-point by set-point.

use std::time::{Duration, Instant};

use crate::generator::judge::Judge;
use jaka_tests::plain_controller::{PlainController, six};

/// Judges set-points by their index. After a late set-point the stream may treat the arm as stopped and begin the
/// motion again from standstill. The next set-points show if it did. The reports give the number of times. Set-points
/// that are read together, or soon after a late one, have no known time of arrival.
pub(super) struct Wire {
    /// Each with the number of restarts of the motion; more than one judge until the next set-points decide.
    judges: Vec<(Judge, u64)>,
    /// Number of set-points since the last late one, and since the last fork of the judges.
    since_late: u32,
    since_parted: u32,
    period: Duration,
    last: Option<Instant>,
    pub(super) set_points: u64,
    /// Periods that passed without a set-point.
    pub(super) lost: f64,
}

/// Number of set-points with unknown times after one at an odd time.
const TOGETHER: u32 = 3;

impl Wire {
    pub(super) fn new(judge: Judge, period: Duration) -> Self {
        Self {
            judges: vec![(judge, 0)],
            since_late: TOGETHER,
            since_parted: 0,
            period,
            last: None,
            set_points: 0,
            lost: 0.0,
        }
    }

    /// Number of restarts of the motion from standstill.
    pub(super) fn stood(&self) -> u64 {
        self.judges[0].1
    }

    /// A stream has landed.
    pub(super) fn stands(&mut self) {
        self.last = None;
    }

    /// Judges the set-points that arrived since the last call.
    pub(super) fn read(&mut self, controller: &PlainController) -> Result<(), String> {
        for (at, request) in controller.timed_motions() {
            if request["cmdName"] != "servo_j"
                || request["relFlag"] != 0
                || request.get("stepNum").is_some_and(|count| *count != 1)
            {
                return Err(format!("not a set-point of a stream: {request}"));
            }
            self.set_point(at, six(&request["jointPosition"]))?;
        }
        Ok(())
    }

    fn set_point(&mut self, at: Instant, joints: [f64; 6]) -> Result<(), String> {
        let periods = self.last.map_or(1.0, |last| (at - last).as_secs_f64() / self.period.as_secs_f64());
        self.last = Some(at);
        self.set_points += 1;
        self.lost += periods - 1.0;
        self.since_late = if (0.5..1.5).contains(&periods) { self.since_late + 1 } else { 0 };
        if self.since_late < TOGETHER {
            let (mut stands, stood) = self.judges[0].clone();
            stands.paused();
            self.judges.push((stands, stood + 1));
            self.since_parted = 0;
        }
        let mut last = String::new();
        self.judges.retain_mut(|(judge, _)| judge.set_point(joints).map_err(|what| last = what).is_ok());
        if self.judges.is_empty() {
            return Err(format!("set-point {}, {periods:.1} periods after the one before: {last}", self.set_points));
        }
        self.since_parted += 1;
        if self.since_parted >= 3 {
            self.judges.truncate(1);
        }
        Ok(())
    }
}

//! The path to the start of a trajectory.

use jaka_motion::{Checker, Follower, Stopping, Trajectory, TrajectoryError};
use jaka_proto::messages::types::JointPosition;

use crate::guard::SetPointGuard;
use crate::servo_session::beyond_limit;
use crate::{Error, ErrorKind};

/// Trajectory to where another one starts, straight in joint space. The arm is held there for two periods or more, so
/// that the other one begins from a standstill at its start exactly.
#[derive(Debug)]
pub(super) struct Approach {
    /// `None` if the arm is at the start.
    follower: Option<Follower>,
    start: JointPosition,
    held: u32,
    /// Number of periods for which the start is to be held.
    hold: u32,
}

/// Speed in deg/s for the last hundredth of a degree, within which the arm counts as being there.
const NEXT_TO_NOTHING: f64 = 1.0;
/// Distance in degrees that needs no approach.
const THERE: f64 = 1e-6;
const PERIODS_HELD: u32 = 2;
/// Speed of the tool in mm/s below which no slower one is tried.
const SLOWEST_MM_S: f64 = 0.01;

impl Approach {
    /// Plans the path, and checks it against all limits and the guard.
    pub(super) fn new(
        checker: &Checker,
        [from, start]: [JointPosition; 2],
        speed_deg_s: Option<f64>,
        period_s: f64,
        guard: Option<&SetPointGuard>,
    ) -> Result<Self, Error> {
        let speed_deg_s = speed_deg_s.unwrap_or(NEXT_TO_NOTHING);
        let is_there = from.max_distance(&start) <= THERE;
        let follower = if is_there { None } else { Some(plan(checker, [from, start], speed_deg_s, period_s, guard)?) };
        // Contacts during the approach are known before the trajectory begins.
        let hold = PERIODS_HELD + guard.map_or(0, |guard| guard.periods_unknown(period_s));
        Ok(Self { follower, start, held: 0, hold })
    }

    /// True once the start was held for so long that the trajectory can begin.
    pub(super) fn is_done(&self) -> bool {
        self.held >= self.hold
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.follower.as_ref().is_none_or(Follower::is_at_rest)
    }

    /// The path, unless the arm was at the start from the beginning.
    pub(super) fn follower(&mut self) -> Option<&mut Follower> {
        self.follower.as_mut()
    }

    /// Looks ahead at a stop on the path.
    pub(super) fn stopping(&self) -> Option<Stopping> {
        self.follower.as_ref().map(Follower::stopping)
    }

    /// Returns the next set-point.
    pub(super) fn advance(&mut self) -> JointPosition {
        match &mut self.follower {
            Some(follower) if !follower.is_at_end() => follower.advance(),
            _ => {
                self.held += 1;
                self.start
            }
        }
    }

    pub(super) fn take_back(&mut self) {
        if self.held > 0 {
            self.held -= 1;
        } else if let Some(follower) = &mut self.follower {
            follower.take_back();
        }
    }
}

/// Plans the path from rest to rest, with a tool speed that the guard permits.
fn plan(
    checker: &Checker,
    from_to: [JointPosition; 2],
    speed_deg_s: f64,
    period_s: f64,
    guard: Option<&SetPointGuard>,
) -> Result<Follower, Error> {
    let through = Trajectory::through(from_to).joint_speeds([speed_deg_s; 6]);
    let tool_stop = guard.and_then(|guard| guard.tool_stop(period_s));
    let mut tcp_speed = tool_stop.map_or(f64::INFINITY, |[speed_mm_s, _]| speed_mm_s.max(SLOWEST_MM_S));
    loop {
        let trajectory = through.clone().tcp_speed(tcp_speed).build(checker).map_err(not_planned)?;
        let mut follower = Follower::new(trajectory, checker, period_s).map_err(not_planned)?;
        match guard.map_or(Ok(()), |guard| guard.check_trajectory(&follower, checker)) {
            Err(_) if tcp_speed > SLOWEST_MM_S => tcp_speed = (0.5 * tcp_speed).max(SLOWEST_MM_S),
            fits => {
                // Nothing has moved yet.
                follower.set_scale(0.0);
                return fits.map(|()| follower);
            }
        }
    }
}

fn not_planned(error: TrajectoryError) -> Error {
    match error {
        TrajectoryError::Place { beyond, .. } | TrajectoryError::Beyond { beyond, .. } => beyond_limit(*beyond),
        source => ErrorKind::Trajectory { source }.into(),
    }
}

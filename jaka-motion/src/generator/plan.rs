//! Path to a goal, computed by rsruckig: a proposal, of which the generator takes only the jerks.

use std::fmt;

use rsruckig::calculator_target::TargetCalculator;
use rsruckig::prelude::{
    ControlInterface, DataArrayOrVec, InputParameter, Profile, RuckigError, RuckigErrorHandler, RuckigResult,
    Synchronization, Trajectory,
};

use crate::braking::{JointLimits, JointState};

/// Path to a goal, if one was computed.
#[derive(Clone)]
pub(super) struct Plan {
    calculator: TargetCalculator<6>,
    input: InputParameter<6>,
    way: Trajectory<6>,
    /// Memory for a path that may be better.
    other: Trajectory<6>,
    /// Elapsed time of the path, in seconds; `None` if there is no path.
    elapsed: Option<f64>,
}

/// Share of the limits that the path may use; less than 1, so that rounding does not exceed them.
const USED: f64 = 0.999;
/// Longest time for which a joint keeps a requested speed, in seconds.
const HORIZON: f64 = 1000.0;
/// Speed below which a joint's goal counts as rest, in deg/s.
const NEXT_TO_NOTHING: f64 = 1e-6;

/// Relative distance from the greatest speed within which a joint counts as moving at that speed.
const AT_SPEED: f64 = 1e-6;
/// Relative change of the greatest speed that avoids a singular case.
const NUDGE: f64 = 1e-9;

/// Handler that ignores errors of rsruckig: the result shows that there is no path.
struct Quiet;

impl RuckigErrorHandler for Quiet {
    fn handle_validation_error(_: &str) -> Result<(), RuckigError> {
        Ok(())
    }

    fn handle_calculator_error(_: &str) -> Result<(), RuckigError> {
        Ok(())
    }
}

impl Plan {
    pub(super) fn new() -> Self {
        let mut input = InputParameter::new(None);
        input.per_dof_control_interface = Some(DataArrayOrVec::Stack([ControlInterface::Position; 6]));
        let (way, other) = (Trajectory::new(None), Trajectory::new(None));
        Self { calculator: TargetCalculator::new(None), input, way, other, elapsed: None }
    }

    pub(super) fn drop_way(&mut self) {
        self.elapsed = None;
    }

    /// Whether there is a path of which less than half of the horizon has elapsed.
    pub(super) fn is_fresh(&self) -> bool {
        self.elapsed.is_some_and(|elapsed| elapsed < 0.5 * HORIZON)
    }

    /// Whether the path is at its end, or there is none.
    pub(super) fn is_done(&self) -> bool {
        self.elapsed.is_none_or(|elapsed| elapsed >= self.way.duration)
    }

    /// Plans a path to joint positions, which all joints reach at the same time.
    pub(super) fn lead_to_joints(&mut self, from: &[JointState; 6], limits: &[JointLimits; 6], target: &[f64; 6]) {
        self.start(from, limits, Synchronization::Phase);
        self.input.target_position = DataArrayOrVec::Stack(*target);
        self.compute();
    }

    /// Plans a path to speeds. Each joint reaches its speed as soon as it can, and keeps it until it must stop at the
    /// end of its range.
    pub(super) fn lead_to_speeds(
        &mut self,
        from: &[JointState; 6],
        limits: &[JointLimits; 6],
        speeds: &[f64; 6],
        ranges: [&[f64; 6]; 2],
    ) {
        self.start(from, limits, Synchronization::None);
        let mut interfaces = [ControlInterface::Position; 6];
        for (index, speed) in speeds.iter().enumerate() {
            if speed.abs() < NEXT_TO_NOTHING {
                interfaces[index] = ControlInterface::Velocity;
                continue;
            }
            let far = from[index].position + speed * HORIZON;
            self.input.target_position[index] = far.clamp(ranges[0][index], ranges[1][index]);
            self.input.max_velocity[index] = speed.abs().min(self.input.max_velocity[index]);
        }
        self.input.per_dof_control_interface = Some(DataArrayOrVec::Stack(interfaces));
        self.compute();
    }

    /// Plans a path to speeds, which all joints reach at the same time.
    pub(super) fn lead_to_speeds_together(
        &mut self,
        from: &[JointState; 6],
        limits: &[JointLimits; 6],
        speeds: &[f64; 6],
    ) {
        self.start(from, limits, Synchronization::Time);
        self.input.per_dof_control_interface = Some(DataArrayOrVec::Stack([ControlInterface::Velocity; 6]));
        self.input.target_velocity = DataArrayOrVec::Stack(*speeds);
        self.compute();
    }

    /// Returns the states a period later; `None` if there is no path or it is beyond the limits.
    pub(super) fn next(
        &self,
        from: &[JointState; 6],
        limits: &[JointLimits; 6],
        period_s: f64,
    ) -> Option<[JointState; 6]> {
        let elapsed = self.elapsed?;
        let mut next = *from;
        for (index, state) in next.iter_mut().enumerate() {
            *state = led(&self.way.profiles[0][index], *state, limits[index], elapsed, period_s)?;
        }
        Some(next)
    }

    pub(super) fn pass(&mut self, period_s: f64) {
        self.elapsed = self.elapsed.map(|elapsed| elapsed + period_s);
    }

    fn start(&mut self, from: &[JointState; 6], limits: &[JointLimits; 6], synchronization: Synchronization) {
        let input = &mut self.input;
        let each = |of: &dyn Fn(usize) -> f64| DataArrayOrVec::Stack(std::array::from_fn(of));
        input.current_position = each(&|index| from[index].position);
        input.current_velocity = each(&|index| from[index].speed);
        input.current_acceleration = each(&|index| from[index].acceleration);
        input.max_velocity = each(&|index| USED * limits[index].speed);
        input.max_acceleration = each(&|index| USED * limits[index].acceleration);
        input.max_jerk = each(&|index| USED * limits[index].jerk);
        input.target_position = each(&|index| from[index].position);
        input.target_velocity = DataArrayOrVec::Stack([0.0; 6]);
        input.synchronization = synchronization;
        input.per_dof_control_interface = Some(DataArrayOrVec::Stack([ControlInterface::Position; 6]));
    }

    /// Computes the path by Ruckig. For a joint at its greatest speed, or about to reach it, Ruckig is singular:
    /// rounding decides between paths, one of which takes up to twice as long. Then the shortest of the paths for three
    /// greatest speeds that differ by a billionth is taken.
    fn compute(&mut self) {
        let speeds: [f64; 6] = std::array::from_fn(|index| self.input.max_velocity[index]);
        let is_at_speed = |index: usize| {
            let (speed, acceleration) = (self.input.current_velocity[index], self.input.current_acceleration[index]);
            // Speed once the acceleration has ended.
            let soon = speed + acceleration * acceleration.abs() / (2.0 * self.input.max_jerk[index]);
            (soon.abs() - speeds[index]).abs() <= AT_SPEED * speeds[index]
        };
        let at_speed: [bool; 6] = std::array::from_fn(is_at_speed);
        let factors: &[f64] = if at_speed.contains(&true) { &[1.0, 1.0 - NUDGE, 1.0 + NUDGE] } else { &[1.0] };
        let mut best = None;
        for factor in factors {
            for index in (0..6).filter(|index| at_speed[*index]) {
                self.input.max_velocity[index] = speeds[index] * factor;
            }
            let found = self.calculate();
            if found.is_some_and(|found| best.is_none_or(|best| found < best)) {
                best = found;
                std::mem::swap(&mut self.way, &mut self.other);
            }
        }
        // The best path is kept beside the last computed one.
        std::mem::swap(&mut self.way, &mut self.other);
        self.elapsed = best.map(|_| 0.0);
    }

    /// Computes a path; returns its duration in seconds, or `None` if there is no path.
    fn calculate(&mut self) -> Option<f64> {
        let result = self.calculator.calculate::<Quiet>(&self.input, &mut self.way, 0.0);
        matches!(result, Ok(RuckigResult::Working)).then_some(self.way.duration)
    }
}

/// Returns the state of a joint a period later, after this time of its profile; `None` if it exceeds its limits on the
/// path.
fn led(profile: &Profile, from: JointState, limits: JointLimits, elapsed: f64, period_s: f64) -> Option<JointState> {
    let brake = profile.brake.t.into_iter().zip(profile.brake.j);
    let phases = brake.chain(profile.t.into_iter().zip(profile.j));
    let (mut state, mut passed, mut left) = (from, elapsed, period_s);
    for (duration, jerk) in phases {
        let seconds = (duration - passed).clamp(0.0, left);
        passed = (passed - duration).max(0.0);
        if seconds > 0.0 {
            let jerk = jerk.clamp(-limits.jerk, limits.jerk);
            let next = state.after(seconds, jerk);
            if !(next.is_within(limits) && state.speed_is_within(seconds, jerk, limits)) {
                return None;
            }
            (state, left) = (next, left - seconds);
        }
    }
    let state = state.after(left, 0.0);
    state.is_within(limits).then_some(state)
}

impl fmt::Debug for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Plan").field("elapsed", &self.elapsed).finish_non_exhaustive()
    }
}

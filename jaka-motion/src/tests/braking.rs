//! Stops of one joint.

use super::Random;
use crate::braking::{JointLimits, JointState, Stop};

fn some_limits(random: &mut Random) -> JointLimits {
    let mut one = |low: f64, high: f64| 10_f64.powf(random.between(low, high));
    JointLimits { speed: one(0.0, 2.5), acceleration: one(0.5, 4.0), jerk: one(1.0, 5.5) }
}

/// Returns a state from which a joint can stop within its limits.
fn some_state(random: &mut Random, limits: JointLimits) -> JointState {
    loop {
        let state = JointState {
            position: random.between(-300.0, 300.0),
            speed: random.between(-limits.speed, limits.speed),
            acceleration: random.between(-limits.acceleration, limits.acceleration),
        };
        if state.is_within(limits) {
            return state;
        }
    }
}

/// Brakes step by step, with as much acceleration as permitted against the speed that would remain if it went to zero
/// now.
fn braked(mut state: JointState, limits: JointLimits, step_s: f64) -> (JointState, f64) {
    let mut seconds = 0.0;
    while (state.speed.abs() > 2.0 * limits.acceleration * step_s
        || state.acceleration.abs() > 2.0 * limits.jerk * step_s)
        && seconds < 1e4
    {
        let ahead = state.speed + state.acceleration * state.acceleration.abs() / (2.0 * limits.jerk);
        let wanted = -ahead.signum() * limits.acceleration;
        let change = limits.jerk * step_s;
        state.acceleration += (wanted - state.acceleration).clamp(-change, change);
        state.speed += state.acceleration * step_s;
        state.position += state.speed * step_s;
        seconds += step_s;
    }
    (state, seconds)
}

#[test]
fn a_stop_ends_where_a_step_by_step_one_does() {
    let mut random = Random::new(11);
    for _ in 0..60 {
        let limits = some_limits(&mut random);
        let from = some_state(&mut random, limits);
        let stop = Stop::of(from, limits);
        let step_s = (stop.seconds() / 40_000.0).max(1e-9);
        let (end, seconds) = braked(from, limits, step_s);
        let scale = limits.speed * stop.seconds();
        assert!(
            (end.position - stop.end()).abs() < 3e-3 * scale + 1e-9,
            "{from:?}, {limits:?}: {end:?}, {}",
            stop.end()
        );
        assert!((seconds - stop.seconds()).abs() < 0.02 * stop.seconds() + 1e-6, "{from:?}, {limits:?}");
    }
}

#[test]
fn a_stop_stays_within_its_limits_and_goes_on_as_it_began() {
    let mut random = Random::new(12);
    for _ in 0..2000 {
        let limits = some_limits(&mut random);
        let from = some_state(&mut random, limits);
        let stop = Stop::of(from, limits);
        let (least, most) = stop.span();
        let rounding = 1e-9 * (1.0 + from.position.abs() + limits.speed * stop.seconds());
        let mut before = from;
        for part in 1..=40 {
            let seconds = stop.seconds() * f64::from(part) / 40.0;
            let state = stop.at(seconds);
            assert!(state.is_within(limits), "{from:?}, {limits:?}: {state:?}");
            assert!(state.position > least - rounding && state.position < most + rounding, "{from:?}, {limits:?}");
            assert!(state.speed.abs() <= stop.top_speed() * (1.0 + 1e-9), "{from:?}, {limits:?}: {state:?}");
            assert!(
                state.acceleration.abs() <= stop.top_acceleration() * (1.0 + 1e-9),
                "{from:?}, {limits:?}: {state:?}"
            );
            let mean_jerk = (state.acceleration - before.acceleration) / stop.seconds() * 40.0;
            assert!(mean_jerk.abs() <= limits.jerk * (1.0 + 1e-6) + 1e-6, "{from:?}, {limits:?}");
            let rest = Stop::of(state, limits);
            assert!((rest.end() - stop.end()).abs() < rounding, "{from:?}, {limits:?}: {state:?}");
            before = state;
        }
        // The ends of the span are reached.
        let positions = (0..=2000).map(|part| stop.at(stop.seconds() * f64::from(part) / 2000.0).position);
        let (low, high) = positions.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
        let near = 1e-3 * limits.speed * stop.seconds() + rounding;
        assert!(low < least + near && high > most - near, "{from:?}, {limits:?}");
        assert_eq!(stop.at(stop.seconds() + 1.0), JointState::at_rest(stop.end()));
    }
}

#[test]
fn a_joint_at_rest_stays() {
    let limits = JointLimits { speed: 180.0, acceleration: 72.0, jerk: 720.0 };
    let stop = Stop::of(JointState::at_rest(12.5), limits);
    assert_eq!((stop.seconds(), stop.end(), stop.span()), (0.0, 12.5, (12.5, 12.5)));
    // The distance is 51 degrees, and 175 deg/s for half of the 0.1 s in which the acceleration is reached.
    let fast = JointState { speed: 175.0, ..JointState::at_rest(0.0) };
    let stop = Stop::of(fast, JointLimits { acceleration: 300.0, jerk: 3000.0, ..limits });
    assert!((stop.end() - (175.0 * 175.0 / 600.0 + 175.0 * 0.05)).abs() < 1e-9, "{}", stop.end());
}

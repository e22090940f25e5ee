//! Time to begin to follow a trajectory of 10,000 way-points, and time for each set-point.

use std::fmt::Write as _;
use std::time::Instant;

use jaka_motion::{Checker, Follower, Frames, Limits, Model, TimedPoint, Trajectory};

use crate::kinematics::{JOINTS, PERIOD};

/// Number of way-points of the trajectory.
const WAY_POINTS: u32 = 10_000;
/// Longest permitted time to check the trajectory and make its follower, in milliseconds.
const TARGET_MS: f64 = 100.0;
/// Number of timed set-points.
const SET_POINTS: u32 = 40_000;

/// For a Zu 5 without regions.
///
/// # Panics
/// There is no Zu 5.
pub fn checker() -> Checker {
    Checker::new(Limits::of(Model::named("Zu 5").expect("a published arm")), Frames::new())
}

/// To and fro with all joints, each 20 s, a way-point each 50 ms.
pub fn way_points() -> Vec<TimedPoint> {
    let at = |number: u32| {
        let time_s = 0.05 * f64::from(number);
        let by = 5.0 * (1.0 - (0.1 * std::f64::consts::PI * time_s).cos());
        TimedPoint::new(time_s, JOINTS.map(|joint| joint + by))
    };
    (0..=WAY_POINTS).map(at).collect()
}

/// The trajectory through them.
///
/// # Panics
/// It is beyond a limit.
pub fn trajectory() -> Trajectory {
    Trajectory::timed(&way_points(), &checker()).expect("within the limits")
}

/// The scale at a set-point: it changes each 50 of them.
pub fn scale(number: u32) -> f64 {
    [1.0, 0.4, 0.0, 0.7, 1.0, 0.9][(number / 50 % 6) as usize]
}

/// Times to make the trajectory, to begin it and to follow it.
///
/// # Panics
/// The follower does not take the period of servo mode.
pub fn report() -> String {
    let mut out = format!("a trajectory of {WAY_POINTS} way-points\n");
    let checker = checker();
    let since = Instant::now();
    let trajectory = trajectory();
    let made_ms = since.elapsed().as_secs_f64() * 1e3;
    let _ = writeln!(out, "  made and compared with the limits {made_ms:6.1} ms");
    let since = Instant::now();
    let is_within = trajectory.check(&checker).is_ok();
    let mut follower = Follower::new(trajectory, &checker, PERIOD).expect("a period of servo mode");
    let began_ms = since.elapsed().as_secs_f64() * 1e3;
    let met = if is_within && began_ms <= TARGET_MS { "met" } else { "MISSED" };
    let _ = writeln!(
        out,
        "  begun with the limits with which it was made: target at most {TARGET_MS} ms: {began_ms:.1} ms, {met}"
    );
    let mut times: Vec<_> = (0..SET_POINTS)
        .map(|number| {
            follower.set_scale(scale(number));
            let since = Instant::now();
            std::hint::black_box(follower.advance());
            since.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let at = |share: usize| times[times.len() * share / 1000];
    let _ = writeln!(out, "  a set-point p50 {:6.1} us, p99 {:6.1} us, p99.9 {:6.1} us", at(500), at(990), at(999));
    out
}

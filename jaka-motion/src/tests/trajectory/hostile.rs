//! Input that nobody would send.

use super::{HOME, Random, checker, slow_enough, some_points};
use crate::{RateChange, TimedPoint, Trajectory, TrajectoryError, Via};

#[test]
fn no_numbers_make_it_panic() {
    let (mut random, checker) = (Random::new(5), checker());
    let odd = [0.0, -0.0, 1e308, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-300, 5e-324, 180.0, 1.0];
    let pick = |random: &mut Random| odd[random.below(11)];
    for _ in 0..20_000 {
        let count = 1 + random.below(4);
        let mut points = Vec::new();
        for index in 0..=count {
            let time_s = if index == 0 { 0.0 } else { pick(&mut random) };
            let mut point = TimedPoint::new(time_s, HOME.map(|joint| joint + pick(&mut random)));
            let many = random.below(3);
            point.velocity = (many > 0).then(|| std::array::from_fn(|_| pick(&mut random)));
            point.acceleration = (many > 1).then(|| std::array::from_fn(|_| pick(&mut random)));
            points.push(point);
        }
        if let Ok(trajectory) = Trajectory::timed(&points, &checker) {
            look_everywhere(&trajectory);
        }
    }
    let (_, trajectory) = slow_enough(&some_points(&mut random, 4), &checker);
    look_everywhere(&trajectory);
}

fn look_everywhere(trajectory: &Trajectory) {
    for time_s in [f64::NAN, f64::NEG_INFINITY, -1.0, 0.0, 1e-300, 0.5, 1e308, f64::INFINITY] {
        let here = trajectory.at(time_s);
        assert!(here.joints.0.iter().chain(&here.velocity).chain(&here.acceleration).all(|number| number.is_finite()));
        for rate in [0.0, 1.0, f64::NAN, 1e308] {
            assert!(is_room(trajectory.rate_change(time_s, time_s, rate)));
            assert!(is_room(trajectory.rate_change(time_s, f64::NAN, rate)));
            assert!(is_room(trajectory.rate_change(f64::NAN, time_s, f64::INFINITY)));
        }
    }
    let _ = trajectory.duration();
}

fn is_room(change: RateChange) -> bool {
    change.fall >= 0.0 && change.rise >= 0.0
}

#[test]
fn times_that_are_nearly_equal_are_refused() {
    let checker = checker();
    let [start, mut next] = [TimedPoint::new(0.0, HOME), TimedPoint::new(1e-300, HOME)];
    // The arm rests, for any duration, however short.
    let _ = Trajectory::timed(&[start, next], &checker);
    next.joints.0[0] += 1e-9;
    assert!(Trajectory::timed(&[start, next], &checker).is_err());
}

#[test]
fn very_many_points_at_one_place_are_no_harm() {
    let checker = checker();
    let points = (0..100_000).map(|number| TimedPoint::new(f64::from(number), HOME)).collect::<Vec<_>>();
    assert_eq!(Trajectory::timed(&points, &checker).expect("it rests").way_points().len(), points.len());
    let mut points = vec![HOME; 100_000];
    assert!(Trajectory::through(points.clone()).build(&checker).is_err());
    points[99_999][0] += 1.0;
    let trajectory = Trajectory::through(points).corner_deg(1.0).build(&checker).expect("a way");
    assert_eq!(trajectory.way_points().len(), 100_000);
}

#[test]
fn a_trajectory_of_more_than_a_week_is_none() {
    let to = |time_s| {
        let points = [TimedPoint::new(0.0, HOME), TimedPoint::new(time_s, HOME.map(|joint| joint + 1.0))];
        Trajectory::timed(&points, &checker())
    };
    assert!(to(604_800.0).is_ok());
    for time_s in [604_801.0, 1e30, 1e308, f64::MAX] {
        let error = to(time_s).expect_err("nothing moves for so long");
        assert!(
            matches!(error, TrajectoryError::TooLong { duration_s } if duration_s.total_cmp(&time_s).is_eq()),
            "{error}"
        );
    }
    assert_eq!(
        to(1e308).expect_err("nothing moves for so long").to_string(),
        "the trajectory takes 1.000e308 s; at most 604800 s, a week, are allowed"
    );
    // This applies to a trajectory with computed times, too.
    let points = [Via::joints(HOME), Via::joints(HOME.map(|joint| joint + 1.0))];
    let slow = Trajectory::through(points).joint_speeds([1e-300; 6]).build(&checker());
    assert!(slow.is_err(), "{slow:?}");
}

//! Trajectories through points with times.

use super::{HOME, Random, checker, slow_enough, some_points, witness, zu5};
use crate::{Checker, Frames, Limits, Passing, Region, TimedPoint, Trajectory, TrajectoryError};

fn with_rates(random: &mut Random, points: &mut [TimedPoint], accelerations: bool) {
    let last = points.len() - 1;
    for (index, point) in points.iter_mut().enumerate() {
        let most = if index == 0 || index == last { 0.0 } else { 5.0 };
        point.velocity = Some(std::array::from_fn(|_| random.between(-most, most)));
        point.acceleration = accelerations.then(|| std::array::from_fn(|_| random.between(-most, most)));
    }
}

#[test]
fn points_are_passed_at_their_times_within_the_limits() {
    let (mut random, checker) = (Random::new(1), checker());
    for round in 0_usize..30 {
        let mut points = some_points(&mut random, 2 + round % 7);
        if round % 3 > 0 {
            with_rates(&mut random, &mut points, round % 3 == 2);
        }
        let (points, trajectory) = slow_enough(&points, &checker);
        for (point, way_point) in points.iter().zip(trajectory.way_points()) {
            let here = trajectory.at(point.time_s);
            assert!(here.joints.max_distance(&point.joints) < 1e-11 && (way_point.time_s - point.time_s).abs() < 1e-12);
            for (given, found) in [(point.velocity, here.velocity), (point.acceleration, here.acceleration)] {
                let differ = |(given, found): (f64, f64)| (given - found).abs() > 1e-8;
                assert!(!given.is_some_and(|given| given.into_iter().zip(found).any(differ)), "{given:?}, {found:?}");
            }
        }
        assert_eq!(trajectory.way_points()[0].passing, Passing::Stops);
        for period_s in [0.001, 0.008] {
            witness(&trajectory, &checker, period_s);
        }
    }
}

#[test]
fn speeds_and_accelerations_are_those_of_the_positions() {
    let (mut random, checker) = (Random::new(2), checker());
    let (_, trajectory) = slow_enough(&some_points(&mut random, 6), &checker);
    let step = 1e-5;
    for place in 1..100 {
        let time_s = f64::from(place) / 100.0 * trajectory.duration_s();
        let [before, here, after] = [time_s - step, time_s, time_s + step].map(|time_s| trajectory.at(time_s));
        for joint in 0..6 {
            let speed = (after.joints.0[joint] - before.joints.0[joint]) / (2.0 * step);
            let acceleration = (after.velocity[joint] - before.velocity[joint]) / (2.0 * step);
            assert!((speed - here.velocity[joint]).abs() < 1e-5);
            assert!((acceleration - here.acceleration[joint]).abs() < 1e-2);
        }
    }
}

/// The check uses third differences of set-points each millisecond, from rest to rest.
#[test]
fn accelerations_step_nowhere_and_jerks_are_within_the_limits() {
    let (mut random, checker) = (Random::new(3), checker());
    for round in 0_usize..60 {
        let mut points = some_points(&mut random, 2 + round % 8);
        if round % 3 > 0 {
            with_rates(&mut random, &mut points, round % 3 == 2);
        }
        let (_, trajectory) = slow_enough(&points, &checker);
        let (step_s, duration_s) = (1e-3, trajectory.duration_s());
        let mut last = [trajectory.start().0; 3];
        let mut time_s = 0.0;
        while time_s < duration_s + 5.0 * step_s {
            let here = trajectory.at(time_s).joints.0;
            for joint in 0..6 {
                let third = here[joint] - 3.0 * last[2][joint] + 3.0 * last[1][joint] - last[0][joint];
                let jerk = third.abs() / step_s.powi(3);
                let most = checker.limits().joint_jerks()[joint];
                assert!(jerk < most * (1.0 + 1e-6) + 1e-3, "round {round}, joint {}, {time_s} s: {jerk}", joint + 1);
            }
            last = [last[1], last[2], here];
            time_s += step_s;
        }
    }
}

/// Times that are longer by the factor of the error are just long enough.
#[test]
fn a_jerk_beyond_its_limit_is_told_with_the_factor_that_helps() {
    let mut random = Random::new(4);
    let limits = zu5().with_joint_accelerations([3000.0; 6]).expect("above 0").with_joint_jerks([700.0; 6]);
    let checker = Checker::new(limits.expect("above 0"), Frames::new());
    let mut told = 0;
    for _ in 0..60 {
        let points =
            some_points(&mut random, 5).into_iter().map(|point| TimedPoint { time_s: 1.4 * point.time_s, ..point });
        let points: Vec<_> = points.collect();
        let Err(TrajectoryError::Jerk { joint, slower, .. }) = Trajectory::timed(&points, &checker) else { continue };
        told += 1;
        let by = |factor: f64| {
            points.iter().map(|point| TimedPoint { time_s: factor * point.time_s, ..*point }).collect::<Vec<_>>()
        };
        assert!(Trajectory::timed(&by(slower * (1.0 + 1e-9)), &checker).is_ok(), "{slower}");
        let still = Trajectory::timed(&by(slower * 0.999), &checker);
        assert!(matches!(still, Err(TrajectoryError::Jerk { joint: same, .. }) if same == joint), "{still:?}");
    }
    assert!(told > 10, "{told}");
}

#[test]
fn a_step_of_acceleration_at_an_end_is_refused() {
    let [here, there] =
        [TimedPoint::new(0.0, HOME), TimedPoint::new(2.0, turned(1, 10.0))].map(|point| point.with_velocity([0.0; 6]));
    let points = [here.with_acceleration([0.0; 6]), there.with_acceleration([0.0, 0.0, 1.5, 0.0, 0.0, 0.0])];
    refused(&points, "way-point 2: joint 3 accelerates by 1.5 deg/s²; a trajectory ends without acceleration");
}

#[track_caller]
fn refused(points: &[TimedPoint], text: &str) {
    refused_within(points, &checker(), text);
}

#[track_caller]
fn refused_within(points: &[TimedPoint], checker: &Checker, text: &str) {
    assert_eq!(Trajectory::timed(points, checker).unwrap_err().to_string(), text);
}

fn turned(joint: usize, by: f64) -> [f64; 6] {
    std::array::from_fn(|index| HOME[index] + if index + 1 == joint { by } else { 0.0 })
}

#[test]
fn wrong_points_are_refused_and_named() {
    let [here, there] = [TimedPoint::new(0.0, HOME), TimedPoint::new(2.0, turned(1, 10.0))];
    refused(&[], "a trajectory takes at least 2 way-points; given 0");
    refused(&[here], "a trajectory takes at least 2 way-points; given 1");
    refused(&[there, here], "way-point 1 is at 2 s; the first must be at 0 s");
    refused(&[here, there, there], "way-point 3 is at 2 s, and the one before it at 2 s; times must increase");
    let timeless = TimedPoint { time_s: f64::NAN, ..there };
    refused(&[here, timeless], "way-point 2: its time is not finite");
    refused(&[here, TimedPoint::new(1.0, [f64::INFINITY; 6])], "way-point 2: its joint position is not finite");
    let moving = there.with_velocity([0.0, 2.5, 0.0, 0.0, 0.0, 0.0]);
    refused(&[here, moving], "way-point 2: either all way-points have a velocity or none");
    let still = here.with_velocity([0.0; 6]);
    refused(&[still, moving], "way-point 2: joint 2 turns at 2.5 deg/s; a trajectory ends at rest");
    let quintic = there.with_velocity([0.0; 6]).with_acceleration([0.0; 6]);
    refused(
        &[still, quintic],
        "way-point 2: either all way-points have acceleration and velocity or none has acceleration",
    );
    let alone = [here, there].map(|point| point.with_acceleration([0.0; 6]));
    refused(&alone, "way-point 1: either all way-points have acceleration and velocity or none has acceleration");
}

#[test]
fn what_is_beyond_a_limit_is_refused_with_its_place() {
    let at = |time_s: f64, joint: usize, by: f64| TimedPoint::new(time_s, turned(joint, by));
    refused(
        &[at(0.0, 1, 0.0), at(10.0, 3, -94.0), at(20.0, 3, -97.5), at(30.0, 1, 0.0)],
        "after way-point 2, at 15.156 s: joint 3 would be at -211.7 deg; limit -175 (Zu 5)",
    );
    refused(
        &[at(0.0, 1, 0.0), at(3.0, 1, 170.0), at(6.0, 1, 200.0)],
        "after way-point 2, at 3.000 s: joint 1 would accelerate by 93.3 deg/s²; limit 72 (Zu 5)",
    );
    let within = |limits: Limits| Checker::new(limits, Frames::new());
    refused_within(
        &[at(0.0, 1, 0.0), at(0.5, 1, 90.0)],
        &within(zu5().with_joint_accelerations([1e4; 6]).expect("limits")),
        "after way-point 1, at 0.250 s: joint 1 would turn at 337.5 deg/s; limit 180 (Zu 5)",
    );
    let table = Region::half_space("table", [0.0, 0.0, 380.0], [0.0, 0.0, 1.0]).expect("a region");
    let found = [
        Trajectory::timed(&[at(0.0, 1, 0.0), at(2.0, 1, 20.0)], &within(zu5().with_tcp_speed(100.0).expect("limits"))),
        Trajectory::timed(&[at(0.0, 2, 0.0), at(4.0, 2, -20.0)], &within(zu5().with_region(table).expect("limits"))),
    ];
    let texts = found.map(|found| found.unwrap_err().to_string());
    assert_eq!(
        texts,
        [
            "after way-point 1, at 0.542 s: the tool centre point would move at 100.01 mm/s; limit 100 (Zu 5)",
            "after way-point 1, at 2.336 s: the tool centre point would be 0.6 mm beyond `table` (Zu 5)",
        ]
    );
}

/// Joint 1 stops in time along the path; straight on, together with joint 2, which is faster, it would not.
#[test]
fn room_to_stop_is_looked_for() {
    let point = |time_s: f64, [first, second]: [f64; 2], [one, other]: [f64; 2]| {
        let mut joints = HOME;
        (joints[0], joints[1]) = (first, HOME[1] + second);
        TimedPoint::new(time_s, joints).with_velocity([one, other, 0.0, 0.0, 0.0, 0.0])
    };
    let points = [
        point(0.0, [0.0, 0.0], [0.0, 0.0]),
        point(2.0, [5.0, 40.0], [5.0, 40.0]),
        point(4.0, [9.9, 120.0], [0.0, 40.0]),
        point(6.0, [9.9, 160.0], [0.0, 0.0]),
    ];
    let within = |most: f64| Checker::new(zu5().with_joint_range(1, -10.0, most).expect("limits"), Frames::new());
    let checker = within(9.92);
    witness(&Trajectory::timed(&points, &checker).expect("it can stop"), &checker, 0.008);
    let text =
        "after way-point 2, at 3.880 s: the arm could not stop before joint 1 is at 9.90405 deg; limit 9.904 (Zu 5)";
    refused_within(&points, &within(9.904), text);
}

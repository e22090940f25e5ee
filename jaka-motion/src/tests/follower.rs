//! Set-points along a trajectory, and their differences by index.

use jaka_proto::messages::types::JointPosition;

use crate::{Checker, Follower, Frames, Limits, Model, TimedPoint, Trajectory};

const PERIOD: f64 = 0.008;

fn limits() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn checker() -> Checker {
    Checker::new(limits(), Frames::new())
}

/// Returns a motion to and fro, with peaks of some 60 % of a Zu 5's limits.
fn trajectory() -> Trajectory {
    let at =
        |time_s: f64, joint_1: f64, joint_6: f64| TimedPoint::new(time_s, [joint_1, 100.0, 80.0, 90.0, -90.0, joint_6]);
    let points = [at(0.0, 0.0, 0.0), at(2.0, 20.0, -15.0), at(4.0, 0.0, 15.0), at(6.0, 10.0, 0.0)];
    Trajectory::timed(&points, &checker()).expect("within the limits")
}

fn follower() -> Follower {
    Follower::new(trajectory(), &checker(), PERIOD).expect("a period of servo mode")
}

/// Follows to the end, with a scale for each set-point; returns the set-points, and the rate at each.
fn followed(mut follower: Follower, scale: impl Fn(usize) -> f64) -> (Vec<[f64; 6]>, Vec<f64>) {
    let (mut set_points, mut rates) = (vec![follower.joints().0; 2], Vec::new());
    while !follower.is_at_end() {
        follower.set_scale(scale(rates.len()));
        let (joints, last) = (follower.advance(), follower.time_s());
        assert_eq!(joints, follower.trajectory().at(last).joints);
        set_points.push(joints.0);
        rates.push(follower.rate());
        assert!(rates.len() < 100_000, "it ends");
    }
    (set_points, rates)
}

/// Returns the largest acceleration of a joint, in deg/s².
fn worst(set_points: &[[f64; 6]]) -> f64 {
    let second = |three: &[[f64; 6]], joint: usize| three[2][joint] - 2.0 * three[1][joint] + three[0][joint];
    let each = set_points.windows(3).flat_map(|three| (0..6).map(|joint| second(three, joint).abs() / PERIOD / PERIOD));
    each.fold(0.0, f64::max)
}

#[test]
fn undisturbed_it_is_the_trajectory() {
    let (set_points, _) = followed(follower(), |_| 1.0);
    for (index, joints) in (1_u32..).zip(&set_points[2..]) {
        let expected = trajectory().at(f64::from(index) * PERIOD).joints;
        assert!(expected.max_distance(&(*joints).into()) < 1e-9);
    }
    assert_eq!((set_points.len(), set_points.last()), (752, Some(&trajectory().end().0)));
    assert!(worst(&set_points) < 72.0);
}

#[test]
fn it_pauses_slows_down_and_goes_on_within_the_accelerations() {
    for shift in 0..60 {
        let (set_points, rates) = followed(follower(), |index| match (index + 7 * shift) % 420 {
            0..120 => 1.0,
            120..180 | 260..270 => 0.0,
            180..260 => 0.3,
            _ => 0.9,
        });
        assert!(worst(&set_points) <= 72.0 * (1.0 + 1e-6), "{shift}: {}", worst(&set_points));
        assert!(rates.iter().all(|rate| (0.0..=1.0).contains(rate)));
    }
}

#[test]
fn the_rate_changes_smoothly_to_what_is_asked_for() {
    let mut follower = follower();
    (0..125).for_each(|_| _ = follower.advance());
    follower.set_scale(0.0);
    let expected = follower.stopping().look_ahead(1000).expect("there is room");
    let mut rates = vec![1.0, 1.0];
    while !follower.is_at_rest() {
        follower.advance();
        rates.push(follower.rate());
    }
    assert_eq!(rates.len() - 2, expected as usize);
    assert!((20..150).contains(&expected), "{expected} periods");
    let changes: Vec<_> = rates.windows(2).map(|two| two[1] - two[0]).collect();
    assert!(changes.iter().all(|change| *change <= 0.0), "{changes:?}");
    let largest = changes.iter().fold(0.0, |largest: f64, change| largest.max(-change));
    let jerks = changes.windows(2).map(|two| (two[1] - two[0]).abs());
    // The rate's change reaches the value that the curve allows in 0.1 s; here that is up to twice the value in use.
    assert!(jerks.fold(0.0, f64::max) <= 2.5 * largest * PERIOD / 0.1, "{changes:?}");
    let stood = follower.joints();
    assert_eq!((follower.advance(), follower.rate()), (stood, 0.0));
}

#[test]
fn a_scale_before_the_start_holds_at_once_and_one_that_is_no_number_is_a_pause() {
    let mut follower = follower();
    follower.set_scale(0.5);
    follower.advance();
    assert!((follower.time_s() - 0.5 * PERIOD).abs() < 1e-12);
    for (given, taken) in [(f64::NAN, 0.0), (-1.0, 0.0), (f64::INFINITY, 1.0), (7.0, 1.0)] {
        let mut follower = self::follower();
        follower.set_scale(given);
        assert!((follower.rate() - taken).abs() < 1e-12, "{given}");
    }
}

#[test]
fn after_a_gap_it_starts_from_standstill_and_what_was_not_sent_comes_again() {
    let mut follower = follower();
    (0..250).for_each(|_| _ = follower.advance());
    follower.paused();
    let (rest, time) = (follower.joints(), follower.time_s());
    let (set_points, _) = followed(follower.clone(), |_| 1.0);
    assert_eq!(JointPosition(set_points[0]), rest);
    assert!(worst(&set_points) <= 72.0 * (1.0 + 1e-6));
    let first = follower.advance();
    follower.take_back();
    assert_eq!((follower.joints(), follower.time_s()), (rest, time));
    assert_eq!(follower.advance(), first);
}

/// A look-ahead computes no more set-points at a time than requested, for any length of the trajectory and of the stop.
#[test]
fn a_stop_is_looked_at_bit_by_bit() {
    let to_and_fro = |number: u32| {
        let by = 10.0 * f64::from(number % 2);
        TimedPoint::new(2.0 * f64::from(number), [by, 100.0, 80.0, 90.0, -90.0, -by])
    };
    for count in [20, 20_000] {
        let points: Vec<_> = (0..count).map(to_and_fro).collect();
        let trajectory = Trajectory::timed(&points, &checker()).expect("within the limits");
        let mut follower = Follower::new(trajectory, &checker(), PERIOD).expect("a period of servo mode");
        (0..600).for_each(|_| _ = follower.advance());
        let (mut stopping, mut looks) = (follower.stopping(), 0);
        let found = loop {
            match stopping.look_ahead(7) {
                Some(found) => break found,
                None => looks += 1,
            }
            assert_eq!(stopping.periods(), 7 * looks);
        };
        assert!(looks > 1 && found > 7 * looks && found <= 7 * (looks + 1));
        assert_eq!(stopping.look_ahead(7), Some(found));
        let within = |most: u32| follower.stopping().look_ahead(most);
        assert_eq!((within(found), within(found - 1)), (Some(found), None));
    }
}

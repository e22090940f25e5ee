//! Random trajectories with random pauses, scales and stops.
//!
//! `JAKA_TRAJECTORIES=1000 cargo test --release -p jaka-tests --test servo follow::random::` is the long form.

use std::thread;

use jaka_robot::jaka_motion::{Follower, Via};
use jaka_robot::servo::ServoJ;

use super::*;
use jaka_tests::rig::Random;
use jaka_tests::witness::curve::are_on;

/// Number of trajectories in this run.
fn count(usual: u32) -> u32 {
    std::env::var("JAKA_TRAJECTORIES").map_or(usual, |text| text.parse().expect("a number of trajectories"))
}

/// Through two to six points, as fast as it may be or up to three times as slow.
fn random_curve(random: &mut Random) -> (Curve, Trajectory) {
    let checker = checker();
    let mut time_s = 0.0;
    let mut points = vec![(0.0, START)];
    for _ in 0..=random.below(5) {
        time_s += random.between(0.2, 0.7);
        let by = random.offsets::<6>(12.0);
        points.push((time_s, turned(by)));
    }
    let mut curve = Curve::through(&points).slower(random.between(1.0, 1.5));
    loop {
        match trajectory(&curve, &checker) {
            Ok(trajectory) => return (curve, trajectory),
            Err(_) => curve = curve.slower(1.2),
        }
        assert!(curve.duration_s() < 100.0, "{curve:?}");
    }
}

/// The scale for some time: mostly another speed, often a pause, seldom the trajectory's own.
fn checker() -> Checker {
    Checker::new(limits(), Frames::new())
}

fn random_scale(random: &mut Random) -> f64 {
    match random.below(6) {
        0 | 1 => 0.0,
        2 => 1.0,
        _ => random.between(0.0, 1.0),
    }
}

/// A set-point as it is on the wire.
fn on_the_wire(joints: JointPosition) -> [f64; 6] {
    let text = serde_json::from_str::<Value>(&encoded(joints)).expect("a request is JSON");
    std::array::from_fn(|joint| text["jointPosition"][joint].as_f64().expect("a number"))
}

fn encoded(joints: JointPosition) -> String {
    use jaka_proto::Command as _;
    let mut out = jaka_proto::wire::Writer::new();
    ServoJ::absolute(joints).write_request(&mut out);
    out.as_str().to_owned()
}

/// Set-points at random scales until the end, or until it has come to rest where it was stopped.
fn followed_at_random(random: &mut Random, trajectory: &Trajectory) -> Vec<[f64; 6]> {
    let mut follower = Follower::new(trajectory.clone(), &checker(), PERIOD).expect("a period of servo mode");
    let stops_at = if random.one_in(3) { random.between(0.0, trajectory.duration_s()) } else { f64::INFINITY };
    let (mut set_points, mut left) = (vec![START], 0);
    while !follower.is_at_end() {
        if left == 0 {
            follower.set_scale(random_scale(random));
            left = random.below(40) + 1;
        }
        left -= 1;
        if follower.time_s() >= stops_at {
            follower.set_scale(0.0);
            let periods = follower.stopping().look_ahead(10_000).expect("it comes to rest");
            set_points.extend((0..=periods).map(|_| on_the_wire(follower.advance())));
            assert!(follower.is_at_rest());
            return set_points;
        }
        set_points.push(on_the_wire(follower.advance()));
        assert!(set_points.len() < 100_000, "it goes on");
    }
    assert!(apart(set_points.last().expect("there are some"), &trajectory.end().0) < 1e-9);
    set_points
}

#[test]
fn through_bytes_in_memory_they_stay_on_the_curve_and_within_the_limits() {
    for seed in 0..count(30) {
        let mut random = Random::new(seed);
        let (curve, trajectory) = random_curve(&mut random);
        let set_points = followed_at_random(&mut random, &trajectory);
        curve.has(&set_points).unwrap_or_else(|what| panic!("seed {seed}: {what}"));
        assert_eq!(jump(START, &set_points), None, "seed {seed}: {set_points:?}");
    }
}

/// Planning leaves a share of the accelerations unused, so that a stop does not take long.
#[test]
fn with_rounded_corners_they_stay_on_the_curve_and_stop_soon() {
    let checker = checker();
    for seed in 0..count(30) {
        let mut random = Random::new(2_000_000 + seed);
        let joints = (0..random.below(5) + 2).map(|_| Via::joints(turned(random.offsets::<6>(15.0))));
        let points: Vec<_> = std::iter::once(Via::joints(START)).chain(joints).collect();
        let planned = Trajectory::through(points).corner_deg(random.between(0.0, 4.0)).build(&checker);
        let trajectory = planned.expect("it is far from all limits");
        let set_points = followed_at_random(&mut random, &trajectory);
        let at = |time_s: f64| trajectory.at(time_s).joints.0;
        are_on(&at, trajectory.duration_s(), &set_points).unwrap_or_else(|what| panic!("seed {seed}: {what}"));
        assert_eq!(jump(START, &set_points), None, "seed {seed}: {set_points:?}");
        let mut follower = Follower::new(trajectory.clone(), &checker, PERIOD).expect("a period of servo mode");
        while !follower.is_at_end() {
            follower.advance();
            // 180 deg/s at 300 deg/s² take 0.6 s straight on.
            assert!(follower.stopping().look_ahead(50).is_some(), "seed {seed}: at {} s", follower.time_s());
        }
    }
}

/// Number of arms at once: each waits most of the time.
const AT_ONCE: u32 = 10;

#[test]
fn on_the_wire_they_stay_on_the_curve_and_within_the_limits() {
    let all = count(10);
    for first in (0..all).step_by(AT_ONCE as usize) {
        thread::scope(|scope| {
            for seed in first..all.min(first + AT_ONCE) {
                scope.spawn(move || follow_at_random(1_000_000 + seed));
            }
        });
    }
}

fn follow_at_random(seed: u32) {
    let mut random = Random::new(seed);
    let (curve, trajectory) = random_curve(&mut random);
    let (arm, end) = led_at_random(&mut random, &trajectory);
    assert!(matches!(end.cause(), Cause::Reached | Cause::Stopped), "seed {seed}: {end}");
    let set_points = judge(&arm, &curve, &end);
    let last = set_points.last().expect("there are some");
    assert!(apart(&curve.at(followed(&end).reached.as_secs_f64()), last) < 1e-6, "seed {seed}: {end:?}");
}

/// The end of a run with pauses, scales and stops at random.
fn led_at_random(random: &mut Random, trajectory: &Trajectory) -> (Arm, End) {
    let (arm, mut robot) = ready();
    let run = robot.start_follow(trajectory, &config().speed_scale(random_scale(random))).expect("it is there");
    for number in 0.. {
        let told = match random.below(8) {
            0 | 1 => run.handle().pause(),
            2 if number > 5 => run.handle().stop(),
            2 | 3 => run.handle().resume(),
            _ => run.handle().set_speed_scale(random.between(0.1, 1.0)),
        };
        // It ends meanwhile, or it is to end.
        if told.is_err() || number > 12 {
            break;
        }
        arm.clock().sleep(Duration::from_secs_f64(random.between(0.0, 0.3)));
    }
    let _ = run.handle().resume().and_then(|()| run.handle().set_speed_scale(1.0));
    let end = run.wait();
    drop(robot);
    (arm, end)
}

/// Points, the tolerance of each joint, and what is planned: through few points, or along a curve near many.
fn random_planned(random: &mut Random) -> (Vec<[f64; 6]>, f64, Trajectory) {
    let checker = checker();
    let planned = if random.one_in(2) {
        let joints = (0..random.below(5) + 2).map(|_| turned(random.offsets::<6>(15.0)));
        let points: Vec<_> = std::iter::once(START).chain(joints).collect();
        let within = random.between(0.5, 4.0);
        let trajectory = Trajectory::through(points.clone()).corner_deg(within).build(&checker);
        (points, within, trajectory)
    } else {
        let (rates, turns) = (random.offsets::<6>(2.0), random.offsets::<6>(15.0));
        let count = random.below(300) + 20;
        let point = |index: u32| {
            let share = f64::from(index) / f64::from(count);
            turned(std::array::from_fn(|joint| turns[joint] * (rates[joint] * share * 3.0).sin()))
        };
        let (points, within) = ((0..=count).map(point).collect::<Vec<_>>(), random.between(0.05, 0.5));
        let trajectory = Trajectory::curve(points.clone()).within_deg(within).build(&checker);
        (points, within, trajectory)
    };
    (planned.0, planned.1, planned.2.expect("it is far from all limits"))
}

/// Largest difference of a joint from the ways straight between points, at the nearest place, by bisection on each way.
fn off_ways(joints: &[f64; 6], points: &[[f64; 6]]) -> f64 {
    let off = |pair: &[[f64; 6]], share: f64| {
        let each = |joint: usize| pair[0][joint] + share * (pair[1][joint] - pair[0][joint]) - joints[joint];
        (0..6).map(|joint| each(joint).abs()).fold(0.0, f64::max)
    };
    let on_way = |pair: &[[f64; 6]]| {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            // The largest difference is convex along the way.
            let [one, other] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
            if off(pair, one) < off(pair, other) { high = other } else { low = one }
        }
        off(pair, f64::midpoint(low, high))
    };
    points.windows(2).map(on_way).fold(f64::INFINITY, f64::min)
}

/// Trajectories without times: the set-points that came are within the tolerance of the ways between the points, and
/// pass each point within it where the run is completed.
#[test]
fn what_is_planned_stays_on_the_wire_within_tolerance_and_limits() {
    let all = count(10);
    for first in (0..all).step_by(AT_ONCE as usize) {
        thread::scope(|scope| {
            for seed in first..all.min(first + AT_ONCE) {
                scope.spawn(move || follow_planned(3_000_000 + seed));
            }
        });
    }
}

fn follow_planned(seed: u32) {
    let mut random = Random::new(seed);
    let (points, within, trajectory) = random_planned(&mut random);
    let (arm, end) = led_at_random(&mut random, &trajectory);
    assert!(matches!(end.cause(), Cause::Reached | Cause::Stopped), "seed {seed}: {end}");
    assert!(end.rest.was_seen() && !followed(&end).has_left_curve, "seed {seed}: {end:?}");
    let (set_points, _) = set_points(&arm);
    assert_eq!(jump(START, &set_points), None, "seed {seed}: {end:?}");
    for joints in &set_points {
        let off = off_ways(joints, &points);
        assert!(off <= within + 1e-6, "seed {seed}: {off} deg off the ways, {within} allowed");
    }
    let at_rest = &set_points[set_points.len() - 2..];
    assert!(apart(&at_rest[0], &at_rest[1]) < 1e-9, "seed {seed}");
    if end.cause() == Cause::Reached {
        assert!(apart(points.last().expect("there are some"), &at_rest[1]) < 1e-6, "seed {seed}");
    }
}

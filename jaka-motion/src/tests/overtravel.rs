//! Overtravel of the tool after a contact, at any rate of the follower at that time.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::Random;
use crate::braking::JointState;
use crate::{Checker, Follower, Frames, Limits, Model, TimedPoint, Trajectory};

const PERIOD: f64 = 0.008;
const UNBRAKED_S: f64 = 0.066;
/// Number of periods in that time, rounded up.
const UNBRAKED: usize = 9;

fn checker() -> Checker {
    Checker::new(Limits::of(Model::named("Zu 5").expect("a published arm")), Frames::new())
}

/// Returns a motion to and fro with three joints, with peaks of some 60 % of a Zu 5's limits.
fn trajectory() -> Trajectory {
    let at = |time_s: f64, by: [f64; 3]| TimedPoint::new(time_s, [by[0], 100.0 + by[1], 80.0, 90.0, -90.0, by[2]]);
    let points = [
        at(0.0, [0.0; 3]),
        at(2.0, [20.0, 5.0, -15.0]),
        at(4.0, [0.0, -5.0, 15.0]),
        at(5.0, [2.0, -5.0, 15.0]),
        at(7.0, [10.0, 0.0, 0.0]),
    ];
    Trajectory::timed(&points, &checker()).expect("within the limits")
}

fn apart(one: JointPosition, other: JointPosition) -> f64 {
    let model = Model::named("Zu 5").expect("a published arm");
    let [one, other] = [one, other].map(|joints| Pose::from(model.forward(joints)));
    (one.x - other.x).hypot(one.y - other.y).hypot(one.z - other.z)
}

/// Returns the distance that the tool travels from a set-point, in mm, at the rates that `scale` sets until it brakes.
fn way(mut follower: Follower, scale: impl Fn(usize) -> f64) -> f64 {
    let (mut way, mut last) = (0.0, follower.joints());
    for index in 0.. {
        if index < UNBRAKED {
            follower.set_scale(scale(index));
        } else if follower.is_at_rest() {
            return way;
        } else {
            follower.brake();
        }
        let next = follower.advance();
        way += apart(last, next);
        last = next;
    }
    way
}

/// Returns the least allowed overtravel that is not exceeded.
fn least_allowed(follower: &Follower) -> f64 {
    let (mut low, mut high) = (0.0, 1000.0);
    for _ in 0..24 {
        let middle = f64::midpoint(low, high);
        let is_refused = follower.worst_overtravel(&checker(), UNBRAKED_S, middle).is_some();
        (low, high) = if is_refused { (middle, high) } else { (low, middle) };
    }
    high
}

#[test]
fn nowhere_does_the_tool_go_on_further_than_is_told() {
    let mut follower = Follower::new(trajectory(), &checker(), PERIOD).expect("a period of servo mode");
    let allowed = least_allowed(&follower);
    let (mut random, mut scale, mut furthest) = (Random::new(17), 1.0, 0.0);
    for round in 0..6 {
        while !follower.is_at_end() {
            if random.below(20) == 0 {
                scale = [0.0, 0.3, 1.0, 1.0][random.below(4)];
            }
            let then = if random.below(2) == 0 { 1.0 } else { scale };
            let gone = way(follower.clone(), |_| then);
            assert!(gone <= allowed, "round {round}, at {} s: {gone} mm of {allowed} mm", follower.time_s());
            furthest = f64::max(furthest, gone);
            follower.set_scale(scale.max(0.01));
            follower.advance();
        }
        follower = Follower::new(trajectory(), &checker(), PERIOD).expect("a period of servo mode");
    }
    // The contact may come at any moment of a period, which adds up to one period.
    assert!(furthest > 0.85 * allowed, "{furthest} mm of {allowed} mm");
}

#[test]
fn the_figures_of_the_worst_contact_make_its_way() {
    let follower = Follower::new(trajectory(), &checker(), PERIOD).expect("a period of servo mode");
    let allowed = 0.99 * least_allowed(&follower);
    let worst = follower.worst_overtravel(&checker(), UNBRAKED_S, allowed).expect("it is too far somewhere");
    assert!(worst.way_mm > 0.0 && (0.0..7.0).contains(&worst.time_s), "{worst:?}");
    assert!((worst.unbraked_s - 0.080).abs() < 1e-9, "{worst:?}");
    let braking = worst.speed_mm_s * worst.speed_mm_s / (2.0 * worst.braking_mm_s2);
    let most = worst.speed_mm_s * worst.unbraked_s + braking;
    assert!(worst.way_mm <= most + 1e-9 && worst.way_mm > 0.8 * most, "{most}: {worst:?}");
    assert!(follower.worst_overtravel(&checker(), UNBRAKED_S, 1e6).is_none());
}

#[test]
fn braking_keeps_to_the_accelerations_and_is_sooner_than_a_smooth_stop() {
    let start = Follower::new(trajectory(), &checker(), PERIOD).expect("a period of servo mode");
    for after in [10, 60, 125, 300, 700] {
        let mut smooth = start.clone();
        let mut set_points = vec![smooth.joints().0];
        for _ in 0..after {
            set_points.push(smooth.advance().0);
        }
        let mut braked = smooth.clone();
        braked.brake();
        let periods = braked.stopping().look_ahead(1000).expect("it comes to rest");
        smooth.set_scale(0.0);
        assert!(Some(periods) < smooth.stopping().look_ahead(1000), "after {after}: {periods}");
        for _ in 0..periods {
            set_points.push(braked.advance().0);
        }
        assert!(braked.is_at_rest() && braked.advance() == braked.joints());
        for three in set_points.windows(3) {
            let step = |from: usize, joint: usize| three[from + 1][joint] - three[from][joint];
            for [before, now] in (0..6).map(|joint| [step(0, joint), step(1, joint)]) {
                let acceleration = (now - before).abs() / PERIOD / PERIOD;
                // A joint that slows down may do so at the 570 deg/s² of a stop.
                let most = if now.abs() < before.abs() { 570.0 } else { 72.0 };
                assert!(acceleration < most + 1e-4, "after {after}: {acceleration} deg/s²");
            }
        }
    }
}

/// Returns a random motion to and fro, near to the limits of the accelerations.
fn some_trajectory(random: &mut Random) -> Trajectory {
    let mut time_s = 0.0;
    let points: Vec<_> = (0..4)
        .map(|number| {
            let size = if number == 0 { 0.0 } else { 7.0 };
            let by = [0.0; 3].map(|_: f64| random.between(-size, size));
            time_s += random.between(0.1, 0.6);
            (time_s, by)
        })
        .collect();
    let start_s = points[0].0;
    let stretched = |by: f64| {
        let at = |(time_s, [one, two, six]): &(f64, [f64; 3])| {
            TimedPoint::new((time_s - start_s) * by, [*one, 100.0 + two, 80.0, 90.0, -90.0, *six])
        };
        Trajectory::timed(&points.iter().map(at).collect::<Vec<_>>(), &checker()).ok()
    };
    (10..200).find_map(|tenths| stretched(f64::from(tenths) / 10.0)).expect("it is slow in the end")
}

#[test]
fn no_contact_is_left_out_that_leads_further_than_is_allowed() {
    let mut random = Random::new(23);
    for round in 0..30 {
        let start = Follower::new(some_trajectory(&mut random), &checker(), PERIOD).expect("a period of servo mode");
        let (mut follower, mut braked, mut unbraked) = (start.clone(), 0.0, 0.0);
        while !follower.is_at_end() {
            // The delay, and one period more.
            let (mut on, mut gone) = (follower.clone(), 0.0);
            for _ in 0..=UNBRAKED {
                let last = on.joints();
                gone += apart(last, on.advance());
            }
            unbraked = f64::max(unbraked, gone);
            braked = f64::max(braked, gone + way_braked(on));
            follower.advance();
        }
        for share in [0.3, 0.8, 0.95, 0.999] {
            let allowed = share * braked;
            let worst = start.worst_overtravel(&checker(), UNBRAKED_S, allowed).expect("it is further");
            assert!(worst.way_mm > allowed, "round {round}: {worst:?}");
            assert!(allowed < unbraked || worst.way_mm >= braked - 1e-9, "round {round}: {worst:?} of {braked} mm");
        }
    }
}

fn way_braked(mut follower: Follower) -> f64 {
    let (mut way, mut last) = (0.0, follower.joints());
    follower.brake();
    while !follower.is_at_rest() {
        let next = follower.advance();
        way += apart(last, next);
        last = next;
    }
    way
}

/// On a path that uses all of a joint's acceleration, motions have none left to brake with.
#[test]
fn a_joint_that_cannot_be_braked_matters_only_where_the_tool_goes_on() {
    let turn = |joint: usize, stop_deg_s2: f64| {
        let mut state = JointState::at_rest(0.0);
        // The acceleration rises to 71.9 deg/s² and falls again in 0.1 s each.
        let phases = [(0.1, 719.0), (0.8, 0.0), (0.2, -719.0), (0.8, 0.0), (0.1, 719.0)];
        let mut points = vec![(0.0, state)];
        for (seconds, jerk) in phases {
            state = state.after(seconds, jerk);
            points.push((points[points.len() - 1].0 + seconds, state));
        }
        let last = points.len() - 1;
        points[last].1 = JointState::at_rest(state.position);
        let points: Vec<_> = points
            .into_iter()
            .map(|(time_s, state)| {
                let with = |value: f64| std::array::from_fn(|index| if index == joint { value } else { 0.0 });
                let mut joints = [0.0, 100.0, 80.0, 90.0, -90.0, 0.0];
                joints[joint] += state.position;
                let point = TimedPoint::new(time_s, joints).with_velocity(with(state.speed));
                point.with_acceleration(with(state.acceleration))
            })
            .collect();
        let limits = Limits::of(&Model::default()).with_stop_accelerations([stop_deg_s2; 6]).expect("above 0");
        let checker = Checker::new(limits, Frames::new());
        Follower::new(Trajectory::timed(&points, &checker).expect("within the limits"), &checker, PERIOD)
            .expect("a period of servo mode")
    };
    // The flange turns about its own middle.
    assert_eq!(turn(5, 1.0).worst_overtravel(&checker(), UNBRAKED_S, 0.1), None);
    let worst = turn(0, 1.0).worst_overtravel(&checker(), UNBRAKED_S, 100.0).expect("it is far");
    assert!(worst.way_mm.is_infinite(), "{worst:?}");
    let worst = turn(0, 570.0).worst_overtravel(&checker(), UNBRAKED_S, 80.0).expect("it is far");
    // The tool travels some 0.2 s at 65 deg/s, at 0.57 m.
    assert!((90.0..140.0).contains(&worst.way_mm), "{worst:?}");
}

//! Numeric options of all public builders, with numbers that nobody would give.

use jaka_proto::messages::types::{JointPosition, Pose};

use crate::{
    Checker, Curve, Follower, Frames, JointSpeed, Limits, Model, Region, TcpSpeed, Through, TimedPoint, Tolerance,
    Trajectory, TrajectoryError, Transform, Via,
};
#[cfg(feature = "generator")]
use crate::{Dynamics, Generator, Goal, TcpVelocity, VelocityFrame};

const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];

const ODD: [f64; 30] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    f64::EPSILON,
    5e-324,
    -5e-324,
    1e308,
    -1e308,
    1e300,
    1e154,
    1e102,
    1e30,
    1e18,
    1e12,
    1.000_001e9,
    1e9,
    1e6,
    180.0,
    1.0,
    0.9,
    1e-3,
    9.99e-4,
    1e-9,
    1e-154,
    1e-300,
    0.0,
    -1.0,
];

/// Numbers that an option takes.
type Takes = &'static dyn Fn(f64) -> bool;

const RATE: Takes = &|number| (0.001..=1e9).contains(&number);
const TOLERANCE: Takes = &|number| number == 0.0 || number >= 0.001 && number.is_finite();
const SPEED: Takes = &|number| number >= 0.001;
const RESERVE: Takes = &|number| (0.0..=0.9).contains(&number);

/// Name of an option in errors, the numbers that it takes, and its use, which returns the error's text.
type NumericOption = (&'static str, Takes, fn(f64) -> Result<(), String>);

/// An option takes just the numbers that make sense. The error for another one names the option, the number and what is
/// expected.
fn check(options: &[NumericOption]) {
    for (name, takes, set) in options {
        for odd in ODD {
            check_one(name, *takes, odd, set(odd));
        }
    }
}

fn check_one(name: &str, takes: Takes, odd: f64, result: Result<(), String>) {
    match result {
        Ok(()) => assert!(takes(odd), "{name} takes {odd:e}"),
        Err(error) => {
            assert!(!takes(odd), "{name} does not take {odd:e}: {error}");
            let is_told = error.contains(name) && error.contains(&odd.to_string());
            let expects = ["is not", "is beyond", "is empty"].into_iter().any(|words| error.contains(words));
            assert!(is_told && expects, "{name}: {error}");
        }
    }
}

fn zu5() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn checker() -> Checker {
    Checker::new(zu5(), Frames::new())
}

fn told<T, E: ToString>(result: Result<T, E>) -> Result<T, String> {
    result.map_err(|error| error.to_string())
}

/// Points in joint space with a corner.
fn joints() -> [Via; 3] {
    let to = |joint: usize| {
        let mut there = HOME;
        there[joint] += 5.0;
        there
    };
    let mut last = to(0);
    last[1] += 5.0;
    [Via::from(HOME), Via::from(to(0)), Via::from(last)]
}

/// Points of the tool with a corner.
fn tool() -> [Via; 3] {
    let start = Pose::from(Model::named("Zu 5").expect("a published arm").forward(HOME));
    [
        Via::from(HOME),
        Via::from(Pose { x: start.x + 20.0, ..start }),
        Via::from(Pose { x: start.x + 20.0, y: start.y + 20.0, ..start }),
    ]
}

/// Plans within these limits. A setting that is taken gives a motion, unless that would take more than a week.
fn planned(build: &dyn Fn(&Checker) -> Result<Trajectory, TrajectoryError>, limits: Limits) -> Result<(), String> {
    match build(&Checker::new(limits, Frames::new())) {
        Ok(trajectory) => {
            for time_s in [0.0, 1e-6, 0.1, 0.5, 1.0, 1e3, f64::MAX] {
                let here = trajectory.at(time_s);
                let numbers = here.joints.0.iter().chain(&here.velocity).chain(&here.acceleration);
                assert!(numbers.copied().all(f64::is_finite), "{here:?}");
            }
            Ok(())
        }
        Err(TrajectoryError::TooLong { .. }) => Ok(()),
        Err(error) => Err(error.to_string()),
    }
}

fn through(with: impl Fn(Through) -> Through) -> Result<(), String> {
    for points in [joints(), tool()] {
        let rounded = Trajectory::through(points).corner_mm(2.0).corner_deg(2.0);
        planned(&|checker| with(rounded.clone()).build(checker), zu5())?;
    }
    Ok(())
}

fn curve(with: impl Fn(Curve) -> Curve) -> Result<(), String> {
    for points in [joints(), tool()] {
        let near = Trajectory::curve(points).within_mm(0.5).within_deg(0.5);
        planned(&|checker| with(near.clone()).build(checker), zu5())?;
    }
    Ok(())
}

fn via(with: impl Fn(Via) -> Via) -> Result<(), String> {
    for [first, middle, last] in [joints(), tool()] {
        let points = [first, with(middle), last];
        let rounded = Trajectory::through(points).corner_mm(2.0).corner_deg(2.0);
        planned(&|checker| rounded.build(checker), zu5())?;
    }
    Ok(())
}

fn one(odd: f64) -> [f64; 6] {
    let mut numbers = [90.0; 6];
    numbers[2] = odd;
    numbers
}

#[test]
fn options_of_trajectories() {
    check(&[
        ("corner_mm", TOLERANCE, |odd| through(|through| through.corner_mm(odd))),
        ("corner_turn_deg", TOLERANCE, |odd| through(|through| through.corner_turn_deg(odd))),
        ("corner_deg", TOLERANCE, |odd| through(|through| through.corner_deg(odd))),
        ("tcp_speed", SPEED, |odd| through(|through| through.tcp_speed(odd))),
        ("joint_speeds", SPEED, |odd| through(|through| through.joint_speeds(one(odd)))),
        ("jerks", RATE, |odd| through(|through| through.jerks([odd; 6]))),
        ("jerks", RATE, |odd| through(|through| through.jerks(one(odd)))),
        ("reserve", RESERVE, |odd| through(|through| through.reserve(odd))),
    ]);
}

#[test]
fn options_of_curves() {
    check(&[
        ("within_mm", &|number| number >= 0.001 && number.is_finite(), |odd| {
            let near = Trajectory::curve(tool()).within_mm(odd);
            planned(&|checker| near.build(checker), zu5())
        }),
        ("within_deg", &|number| number >= 0.001 && number.is_finite(), |odd| curve(|curve| curve.within_deg(odd))),
        ("corner_above_deg", &|number| number > 0.0 && number <= 180.0, |odd| {
            curve(|curve| curve.corner_above_deg(odd))
        }),
        ("corner_mm", TOLERANCE, |odd| curve(|curve| curve.corner_mm(odd))),
        ("corner_deg", TOLERANCE, |odd| curve(|curve| curve.corner_deg(odd))),
        ("tcp_speed", SPEED, |odd| curve(|curve| curve.tcp_speed(odd))),
        ("joint_speeds", SPEED, |odd| curve(|curve| curve.joint_speeds(one(odd)))),
        ("jerks", RATE, |odd| curve(|curve| curve.jerks([odd; 6]))),
        ("jerks", RATE, |odd| curve(|curve| curve.jerks(one(odd)))),
        ("reserve", RESERVE, |odd| curve(|curve| curve.reserve(odd))),
    ]);
}

#[test]
fn options_of_points() {
    check(&[
        ("corner_mm", TOLERANCE, |odd| via(|via| via.with_corner_mm(odd))),
        ("corner_turn_deg", TOLERANCE, |odd| via(|via| via.with_corner_turn_deg(odd))),
        ("corner_deg", TOLERANCE, |odd| via(|via| via.with_corner_deg(odd))),
        ("tcp_speed", SPEED, |odd| via(|via| via.with_tcp_speed(odd))),
        ("joint_speeds", SPEED, |odd| via(|via| via.with_joint_speeds(one(odd)))),
    ]);
}

/// Plans, checks and leads within limits that are taken.
fn limited(with: impl Fn(Limits) -> Result<Limits, crate::InvalidLimit>) -> Result<(), String> {
    let limits = told(with(zu5()))?;
    for points in [joints(), tool()] {
        let rounded = Trajectory::through(points).corner_mm(2.0).corner_deg(2.0);
        planned(&|checker| rounded.build(checker), limits.clone())?;
        let near = Trajectory::curve(points).within_mm(0.5).within_deg(0.5);
        planned(&|checker| near.build(checker), limits.clone())?;
    }
    let checker = Checker::new(limits, Frames::new());
    let there = HOME.map(|joint| joint + 1e-3);
    let _ = checker.check_set_point([HOME.into(); 2], there.into(), 0.008);
    let stop = checker.straight_stop([HOME.into(), there.into()], 0.008);
    assert!(stop.steps() >= 0.0 && stop.step(1).is_finite());
    #[cfg(feature = "generator")]
    {
        let generator = Generator::new(&checker, Dynamics::of(checker.limits()), HOME.into(), 0.008);
        lead(generator.expect("each limit is one of dynamics, too"));
    }
    Ok(())
}

/// Leads to a goal, and to rest on the way.
#[cfg(feature = "generator")]
fn lead(mut generator: Generator) {
    let there = HOME.map(|joint| joint + 1.0);
    for goal in [Goal::Joints(there.into()), Goal::Velocity([5.0; 6]), Goal::Rest] {
        for _ in 0..40 {
            let joints = generator.next(&goal).joints;
            assert!(joints.0.into_iter().all(f64::is_finite), "{joints:?}");
        }
        let landing = generator.landing();
        assert!(landing.joints.0.into_iter().all(f64::is_finite) && landing.time_s >= 0.0, "{landing:?}");
    }
}

#[test]
fn options_of_limits() {
    check(&[
        ("joint", &|number| (-360.0..=90.0).contains(&number), |odd| {
            told(zu5().with_joint_range(1, odd, 90.0)).map(drop)
        }),
        ("joint", &|number| (-90.0..=360.0).contains(&number), |odd| {
            told(zu5().with_joint_range(1, -90.0, odd)).map(drop)
        }),
        ("joint", &|number| (0.001..=180.0).contains(&number), |odd| {
            limited(|limits| limits.with_joint_speeds([odd; 6]))
        }),
        ("joint acceleration", RATE, |odd| limited(|limits| limits.with_joint_accelerations([odd; 6]))),
        ("joint acceleration", RATE, |odd| limited(|limits| limits.with_joint_accelerations(one(odd)))),
        ("joint jerk", RATE, |odd| limited(|limits| limits.with_joint_jerks([odd; 6]))),
        ("joint jerk", RATE, |odd| limited(|limits| limits.with_joint_jerks(one(odd)))),
        ("speed of the tool centre point", RATE, |odd| limited(|limits| limits.with_tcp_speed(odd))),
        ("acceleration of the tool centre point", RATE, |odd| limited(|limits| limits.with_tcp_acceleration(odd))),
        ("joint acceleration of a stop", RATE, |odd| limited(|limits| limits.with_stop_accelerations([odd; 6]))),
        ("joint jerk of a stop", RATE, |odd| limited(|limits| limits.with_stop_jerks([odd; 6]))),
        ("acceleration of the tool centre point in a stop", RATE, |odd| {
            limited(|limits| limits.with_stop_tcp_acceleration(odd))
        }),
        ("distance from a singularity", &|number| (0.0..1.0).contains(&number), |odd| {
            limited(|limits| limits.with_singularity_distance(odd))
        }),
    ]);
}

#[test]
fn options_of_regions() {
    let far = [-1e6; 3];
    let with = |region: Result<Region, crate::InvalidLimit>| limited(|limits| limits.with_region(region.clone()?));
    check(&[
        ("box", &f64::is_finite, |odd| {
            told(Region::inside_box("cell", [f64::MIN, odd, f64::MIN], [f64::MAX; 3])).map(drop)
        }),
        ("half-space", &f64::is_finite, |odd| told(Region::half_space("wall", [odd; 3], [0.0, 0.0, 1.0])).map(drop)),
    ]);
    for odd in ODD {
        let _ = with(Region::inside_box("cell", far, [1e6, odd, 1e6]));
        let _ = with(Region::outside_box("camera", far, [-1e5, odd, 1e6]));
        let _ = with(Region::half_space("wall", [odd; 3], [odd, 1.0, odd]));
    }
}

/// Odd numbers in a velocity mean rest.
#[cfg(feature = "generator")]
#[test]
fn options_of_generators() {
    let new = |dynamics: Dynamics, period_s: f64| {
        Generator::new(&checker(), dynamics, HOME.into(), period_s).map_err(|error| error.to_string())
    };
    let dynamics = |with: Result<Dynamics, crate::GeneratorError>| {
        // Only jerks may be above those of the limits.
        match new(told(with)?, 0.008) {
            Ok(generator) => lead(generator),
            Err(error) => assert!(error.contains("the arm's limit"), "{error}"),
        }
        Ok(())
    };
    let usual = || Dynamics::of(&zu5());
    let stopping = |speed: f64, within: f64| told(new(usual(), 0.008)?.with_tool_stop(speed, within)).map(lead);
    let dynamics = &dynamics;
    for odd in ODD {
        let options = [
            ("speed", RATE, dynamics(usual().with_speeds([odd; 6]))),
            ("speed", RATE, dynamics(usual().with_speeds(one(odd)))),
            ("acceleration", RATE, dynamics(usual().with_accelerations([odd; 6]))),
            ("jerk", RATE, dynamics(usual().with_jerks([odd; 6]))),
            ("jerk", RATE, dynamics(usual().with_jerks(one(odd)))),
            ("period", &|number| (0.001..=1.0).contains(&number), new(usual(), odd).map(lead)),
            ("speed of the tool centre point", RATE, stopping(odd, 10.0)),
            ("distance in which the tool centre point stops", RATE, stopping(100.0, odd)),
        ];
        for (name, takes, result) in options {
            check_one(name, takes, odd, result);
        }
        for frame in [VelocityFrame::ArmBase, VelocityFrame::User, VelocityFrame::Tool] {
            let velocity = TcpVelocity::new(frame).with_linear([odd; 3]).with_angular([odd, 0.0, 0.0]);
            let mut generator = new(usual(), 0.008).expect("it can be made");
            for goal in [Goal::TcpVelocity(velocity), Goal::Velocity([odd; 6]), Goal::Joints([odd; 6].into())] {
                let _ = generator.check_goal(&goal);
                for _ in 0..20 {
                    let joints = generator.next(&goal).joints;
                    assert!(joints.0.into_iter().all(f64::is_finite), "{joints:?}");
                }
            }
        }
    }
}

#[test]
fn options_of_followers() {
    let checker = checker();
    let turn = Trajectory::through(joints()).build(&checker).expect("within the limits");
    for odd in ODD {
        let follower = Follower::new(turn.clone(), &checker, odd);
        check_one("period_s", &|number| (0.001..=1.0).contains(&number), odd, told(follower.clone()).map(drop));
        let Ok(mut follower) = Follower::new(turn.clone(), &checker, 0.008) else { continue };
        follower.set_scale(odd);
        for _ in 0..20 {
            assert!(follower.advance().0.into_iter().all(f64::is_finite));
        }
        // What is unknown is as bad as can be.
        let worst = follower.worst_overtravel(&checker, 0.02, odd);
        assert_eq!(worst.is_some(), odd.is_nan() || odd < 60.0, "{odd:e}: {worst:?}");
        let delayed = follower.worst_overtravel(&checker, odd, 60.0);
        assert_eq!(delayed.is_some(), odd.is_nan() || odd >= 0.9, "{odd:e}: {delayed:?}");
    }
}

/// A number that makes no sense is refused by the check, which never panics.
#[test]
fn options_of_checks() {
    let checker = checker();
    let there = HOME.map(|joint| joint + 1e-3);
    let pose = Pose::from(checker.limits().model().forward(there));
    let frames = Frames::new().with_tool(pose).with_user_frame(pose).with_mounting(pose);
    for odd in ODD {
        let makes_sense = odd.is_finite() && odd > 0.0;
        let asked = JointSpeed { speed_deg_s: odd, acceleration_deg_s2: Some(10.0) };
        let slow = JointSpeed { speed_deg_s: 10.0, acceleration_deg_s2: Some(odd) };
        for asked in [asked, slow] {
            let found = checker.check_joint_way(HOME.into(), there.into(), asked);
            assert!(makes_sense || found.is_err(), "{odd:e}");
        }
        for asked in [TcpSpeed { speed_mm_s: odd, tolerance_mm: 0.0 }, TcpSpeed { speed_mm_s: 10.0, tolerance_mm: odd }]
        {
            let found = checker.check_line(HOME.into(), pose, asked);
            assert!(makes_sense || odd == 0.0 && asked.tolerance_mm == 0.0 || found.is_err(), "{odd:e}");
        }
        let set_point = checker.check_set_point([HOME.into(); 2], there.into(), odd);
        assert!(makes_sense || set_point.is_err(), "{odd:e}");
        let set_point = checker.check_pose_set_point([HOME.into(); 2], pose, odd);
        assert!(makes_sense || set_point.is_err(), "{odd:e}");
        let stop = checker.straight_stop([HOME.into(), there.into()], odd);
        let _ = (stop.periods(), stop.steps(), stop.step(0), stop.step(1), stop.step(u32::MAX));
        let moved = Pose { x: odd, rx: odd, ..pose };
        for frames in [frames.with_tool(moved), frames.with_user_frame(moved), frames.with_mounting(moved)] {
            let odd_frames = Checker::new(zu5(), frames);
            let asked = TcpSpeed { speed_mm_s: 10.0, tolerance_mm: 0.0 };
            let _ = odd_frames.check_line(HOME.into(), pose, asked);
            let _ = Trajectory::through(tool()).build(&odd_frames);
        }
        let model = checker.limits().model();
        let pairs: Vec<(JointPosition, Pose)> = model
            .positions_to_compare()
            .into_iter()
            .map(|joints| (joints, Pose { x: odd, ..Pose::from(model.forward(joints)) }))
            .collect();
        assert!(model.fit(&pairs, Tolerance::default()).is_err(), "{odd:e}");
        let tolerance = Tolerance { position_mm: odd, angle_deg: odd };
        let pairs = model.positions_to_compare().map(|joints| (joints, Pose::from(model.forward(joints))));
        assert!(odd > 0.0 || model.fit(&pairs, tolerance).is_err(), "{odd:e}");
        let between = Transform::from(pose).between(&Transform::from(pose), odd);
        let _ = between.position_mm();
        let timed = [TimedPoint::new(0.0, HOME), TimedPoint::new(odd, there)];
        assert!(makes_sense || Trajectory::timed(&timed, &checker).is_err(), "{odd:e}");
    }
}

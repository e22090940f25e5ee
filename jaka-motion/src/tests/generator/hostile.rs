//! Invalid numbers, and unusable limits.

use super::{CYCLE, ELBOW_UP, Watched, joints, zu5};
use crate::{Checker, Dynamics, Frames, Generator, GeneratorError, Goal, TcpVelocity, VelocityFrame};

#[test]
fn odd_goals_are_refused_and_mean_rest() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut goals = Vec::new();
        for index in 0..6 {
            let mut numbers = ELBOW_UP;
            numbers[index] = odd;
            goals.extend([joints(numbers), Goal::Velocity(numbers)]);
            let (linear, angular) = numbers.split_at(3);
            goals.push(Goal::TcpVelocity(TcpVelocity {
                linear_mm_s: linear.try_into().expect("three"),
                angular_deg_s: angular.try_into().expect("three"),
                frame: VelocityFrame::User,
            }));
        }
        for goal in goals {
            let mut arm = Watched::new(zu5(), ELBOW_UP);
            arm.generator.check_goal(&goal).expect_err("not finite");
            for _ in 0..20 {
                arm.next(&Goal::Velocity([50.0; 6]));
            }
            arm.until_rest(&goal, 500);
        }
    }
}

#[test]
fn huge_and_tiny_goals_do_no_harm() {
    for size in [1e-300, 1e-12, 1e-7, 1e3, 1e8, 1e16, 1e100, 1e300, f64::MAX] {
        for sign in [1.0, -1.0] {
            let numbers = [size * sign; 6];
            let velocity =
                TcpVelocity { linear_mm_s: [size * sign; 3], angular_deg_s: [size; 3], frame: VelocityFrame::Tool };
            for goal in [joints(numbers), Goal::Velocity(numbers), Goal::TcpVelocity(velocity)] {
                let mut arm = Watched::new(zu5(), ELBOW_UP);
                for _ in 0..60 {
                    arm.next(&goal);
                }
                arm.until_rest(&Goal::Rest, 2000);
            }
        }
    }
}

/// A generator may run in its own thread.
#[test]
fn a_generator_can_be_sent_to_another_thread() {
    fn is_sent<T: Send + 'static>(_: T) {}
    is_sent(Watched::new(zu5(), ELBOW_UP).generator);
}

#[test]
fn dynamics_beyond_limits_and_odd_starts_are_refused() {
    let checker = Checker::new(zu5(), Frames::new());
    let new =
        |dynamics: Dynamics, start: [f64; 6], period: f64| Generator::new(&checker, dynamics, start.into(), period);
    let dynamics = Dynamics::of(&zu5());
    let error = |result: Result<Generator, GeneratorError>| result.expect_err("refused").to_string();
    let fast = dynamics.with_accelerations([300.0, 300.0, 300.0, 301.0, 300.0, 300.0]).expect("above 0");
    let words = "acceleration of joint 4: 301 deg/s² is beyond the arm's limit of 300 deg/s²";
    assert_eq!(error(new(fast, ELBOW_UP, CYCLE)), words);
    assert_eq!(error(new(dynamics, ELBOW_UP, 0.0)), "period: 0 s is not from 0.001 s to 1 s");
    let mut start = ELBOW_UP;
    start[0] = 361.0;
    assert_eq!(error(new(dynamics, start, CYCLE)), "start: joint 1 would be at 361 deg; limit 360 (Zu 5)");
    start[0] = f64::NAN;
    assert!(matches!(new(dynamics, start, CYCLE), Err(GeneratorError::Start(_))));
    for odd in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e308] {
        let mut values = [10.0; 6];
        values[2] = odd;
        let is_named = |error: GeneratorError| matches!(error, GeneratorError::OutOfRange { joint: 3, .. });
        assert!(is_named(dynamics.with_speeds(values).expect_err("refused")));
        assert!(is_named(dynamics.with_accelerations(values).expect_err("refused")));
        assert!(is_named(dynamics.with_jerks(values).expect_err("refused")));
    }
}

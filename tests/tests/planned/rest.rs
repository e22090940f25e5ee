//! Rest of the arm by three answers of the controller, whose encoders may be noisy.

use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Error, ErrorKind, Guard, MotionExt as _, Remedy, RobotConfig, ServoConfig, wait_for_rest};
use jaka_tests::{Arm, Configured as _, LONG};

/// Greatest speed of an arm at rest, in deg/s.
const REST_SPEED: f64 = 0.5;

/// Time between the first question and the last one, and its error by the controller's cycle.
const WINDOW: f64 = 0.2;
const CYCLES: f64 = 0.008;

/// Noise of the encoders, in degrees.
const NOISE: [f64; 4] = [0.0, 0.002, 0.01, 0.03];

fn noisy(noise: f64) -> Arm {
    Arm::simulated().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).controller(|arm| arm.joint_noise(noise)).start()
}

fn to(angle: f64, speed: f64) -> JointMove {
    JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], speed).acceleration(500.0)
}

/// Measured speed of the joint, and the greatest speed of an arm at rest.
fn measured(error: &Error) -> (f64, f64) {
    if let ErrorKind::NotSent { command, because, .. } = error.kind() {
        assert_eq!((&**command, error.cause(), error.may_have_run()), ("servo_move", Cause::Moving, false));
        return measured(because);
    }
    let ErrorKind::NotAtRest { joint: 1, by_deg, within, speed, rest_speed } = *error.kind() else {
        panic!("{error:?}")
    };
    assert_eq!((error.cause(), error.remedy(), error.may_have_run()), (Cause::Moving, Remedy::WaitForRest, false));
    assert!((by_deg / within.as_secs_f64() - speed).abs() < 1e-9, "{error}");
    (speed, rest_speed)
}

#[test]
fn an_arm_is_at_rest_below_the_threshold_and_never_above_it() {
    for noise in NOISE {
        // Noise of both ends of the window.
        let most = 2.0 * noise / WINDOW;
        for speed in [0.0, 0.3, 0.6, 2.0, 20.0] {
            let arm = noisy(noise);
            let mut client = arm.client();
            if speed > 0.0 {
                client.call(&to(300.0, speed)).expect("it is reachable");
                arm.clock().sleep(Duration::from_millis(100));
            }
            let (slowest, fastest) =
                (speed * (WINDOW - CYCLES) / WINDOW - most, speed * (WINDOW + CYCLES) / WINDOW + most);
            for _ in 0..20 {
                // Three answers, whatever they say.
                let since = arm.clock().elapsed();
                match wait_for_rest(&mut client, Duration::ZERO) {
                    Ok(()) => assert!(slowest <= REST_SPEED, "{speed} deg/s is rest, noise {noise}"),
                    Err(error) => {
                        let (measured, allowed) = measured(&error);
                        assert!((allowed - REST_SPEED).abs() < 1e-9 && measured > REST_SPEED, "{error}");
                        assert!((slowest..=fastest).contains(&measured), "{speed} deg/s, noise {noise}: {error}");
                    }
                }
                assert!(arm.clock().elapsed() < since + Duration::from_millis(220));
            }
            if speed < REST_SPEED {
                wait_for_rest(&mut client, Duration::from_secs(1)).expect("it is slow enough");
            }
            assert_eq!(arm.state().at_rest, speed == 0.0);
        }
    }
}

#[test]
fn a_wait_for_rest_ends_with_the_first_three_answers_that_show_it() {
    for noise in NOISE {
        let arm = noisy(noise);
        let mut robot = arm.robot();
        robot.start(&to(40.0, 40.0)).expect("it is reachable");
        let error = robot.wait_for_rest(Duration::from_millis(500)).expect_err("it moves");
        let (speed, _) = measured(&error);
        assert!((speed - 40.0).abs() < 2.0 + 2.0 * noise / WINDOW, "{error}");
        jaka_tests::simulated::until(arm.clock(), || arm.state().at_rest);
        let since = arm.clock().elapsed();
        robot.wait_for_rest(LONG).expect("it rests");
        assert!(arm.clock().elapsed() < since + Duration::from_millis(220));
        // Begun while it moves.
        robot.start(&to(20.0, 40.0)).expect("it is reachable");
        robot.wait_for_rest(LONG).expect("it comes to rest");
        assert!(arm.state().at_rest, "noise {noise}");
    }
}

#[test]
fn the_error_names_the_joint_its_speed_and_what_is_allowed() {
    let arm = noisy(0.0);
    let mut client = arm.client();
    client.call(&to(300.0, 20.0)).expect("it is reachable");
    arm.clock().sleep(Duration::from_millis(504));
    let error = wait_for_rest(&mut client, Duration::ZERO).expect_err("it moves");
    assert_eq!(
        error.to_string(),
        "the arm is moving: joint 1 turned by 4.000 deg within 200.0ms (20.00 deg/s), and at rest it turns at most at \
         0.5 deg/s; stop the arm or wait for the end of its motion, then wait for its rest (`wait_for_rest`) and try \
         again"
    );
}

#[test]
fn the_threshold_is_an_option() {
    let arm = noisy(0.0);
    let robot = arm.robot();
    let mut robot = robot.configured(&RobotConfig::new().rest_speed(3.0)).expect("it is a speed");
    robot.client().call(&to(300.0, 2.0)).expect("it is reachable");
    robot.wait_for_rest(Duration::ZERO).expect("2 deg/s are rest for this robot");
    robot.configure(&RobotConfig::new()).expect("the defaults");
    let error = robot.wait_for_rest(Duration::ZERO).expect_err("2 deg/s are no rest");
    assert!((measured(&error).1 - REST_SPEED).abs() < 1e-9);
}

#[test]
fn a_robot_with_noisy_encoders_sees_rest_after_a_stop_and_enters_servo_mode() {
    for noise in NOISE {
        let arm = noisy(noise);
        let mut robot = arm.robot();
        let guard =
            Guard::when("it is far", |status| status.joint_actual_position.is_some_and(|joints| joints.0[0] > 10.0));
        let trip = robot.run(&to(90.0, 40.0).guard(guard), LONG).expect("it is sent").guarded().expect("it trips");
        assert!(trip.is_at_rest && arm.state().at_rest, "noise {noise}: {trip}");
        drop(robot.enter_servo_mode(ServoConfig::new()).expect("it rests"));
        // From where the last answer says that it is.
        let from = arm.state().joint_position.0[0];
        robot
            .start(&JointMove::relative([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.0).acceleration(400.0))
            .expect("it is sent");
        jaka_tests::simulated::until(arm.clock(), || {
            arm.state().at_rest && arm.state().joint_position.0[0] > from + 4.9
        });
    }
}

#[test]
fn servo_mode_is_not_entered_while_the_arm_moves() {
    for speed in [0.6, 2.0, 20.0] {
        let arm = noisy(0.002);
        let mut robot = arm.robot();
        robot.client().call(&to(300.0, speed)).expect("it is reachable");
        arm.clock().sleep(Duration::from_millis(100));
        let config = ServoConfig::new().enter_timeout(Duration::from_secs(1));
        let error = robot.enter_servo_mode(config).map(drop).expect_err("it moves");
        let (measured, _) = measured(&error);
        assert!((measured - speed).abs() < 0.04 * speed + 0.02, "{error}");
        assert!(!arm.requests().iter().any(|request| request.contains("servo_move")), "{speed} deg/s");
    }
}

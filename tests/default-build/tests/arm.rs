//! A first motion, a servo session and a stop, by jaka-sync with its default features.

use std::thread;
use std::time::{Duration, Instant};

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Config, Robot, ServoConfig, SessionConfig};
use jaka_sim::{Controller, Delays};

/// Timeout for what must happen, however busy the machine is.
const LONG: Duration = Duration::from_secs(60);

/// A controller in real time, and a robot for which packets of a minute ago are fresh.
fn connected() -> (Controller, Robot) {
    let controller = Controller::builder().delays(Delays::NONE).start().expect("loopback has free ports");
    let config = Config::new().stale_after(LONG).reply_timeout(LONG);
    let robot = Robot::connect_at(&config, controller.command_addr(), controller.status_addr());
    (controller, robot.expect("the controller listens"))
}

fn joint_6(controller: &Controller) -> f64 {
    controller.state().joint_position.0[5]
}

/// Waits until the controller has carried out such a request.
fn wait_for(controller: &Controller, command: &str) {
    for count in 1.. {
        assert!(controller.wait_for_requests(count, LONG), "{command} does not come");
        if controller.requests()[count - 1].contains(command) {
            return;
        }
    }
}

/// Waits until the arm is at rest by the controller's own state.
fn wait_for_rest(controller: &Controller) {
    let since = Instant::now();
    while !controller.state().at_rest {
        assert!(since.elapsed() < LONG, "the arm does not come to rest");
        // Looks again: a longer sleep only makes the test slower.
        thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn a_first_motion_reaches_its_target() {
    let (controller, mut robot) = connected();
    let before = joint_6(&controller);
    robot.power_up(LONG).expect("nothing keeps it from being enabled");
    let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 50.0).acceleration(200.0);
    robot.run(&turn, LONG).expect("it is accepted").reached().expect("nothing is in the way");
    assert!((joint_6(&controller) - before - 5.0).abs() < 1e-6);
    let told = robot.client().get_joint_pos().expect("it answers").joint_position.0[5];
    assert!((told - before - 5.0).abs() < 1e-6);
}

#[test]
fn each_set_point_of_a_servo_session_arrives() {
    let (controller, mut robot) = connected();
    robot.power_up(LONG).expect("nothing keeps it from being enabled");
    // Late cycles end no session, however late they are: set-points may differ by any step.
    let config = SessionConfig::new().servo(ServoConfig::new().max_unanswered(LONG).rest_timeout(LONG)).unchecked();
    let mut session = robot.enter_servo_mode(&config).expect("the arm is at rest");
    for _ in 0..25 {
        session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, 0.004]).expect("servo mode is on");
    }
    let report = session.land().expect("the arm comes to rest").report;
    assert_eq!((report.cycles, report.refused, report.unanswered), (25, 0, 0));
    let is_set_point = |request: &&String| request.contains(r#""servo_j""#);
    let received = controller.requests().iter().filter(is_set_point).count();
    assert_eq!(u64::try_from(received), Ok(report.cycles + report.landing_cycles));
    assert!(!controller.state().servo_mode && controller.state().at_rest);
}

#[test]
fn a_stop_of_another_thread_ends_a_motion() {
    let (controller, mut robot) = connected();
    let before = joint_6(&controller);
    robot.power_up(LONG).expect("nothing keeps it from being enabled");
    let stop = robot.stop_handle();
    // Longer than this test may take.
    let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 100.0], 0.5).acceleration(200.0);
    let end = thread::scope(|scope| {
        let stopping = scope.spawn(|| {
            wait_for(&controller, "joint_move");
            stop.stop()
        });
        let end = robot.run(&turn, LONG).expect("it is accepted");
        stopping.join().expect("it does not panic").expect("the stop is accepted");
        end
    });
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    assert!(end.reached().is_err());
    // The outcome says that the stop was accepted; the arm may still be braking then.
    wait_for_rest(&controller);
    let turned = joint_6(&controller) - before;
    assert!((0.0..100.0).contains(&turned), "it turned by {turned}");
}

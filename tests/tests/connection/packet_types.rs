//! Packets of a type of the user's own whose code panics: they count as packets that cannot be read.

use std::panic::resume_unwind;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_robot::motion::JointMove;
use jaka_robot::status::RobotStatus;
use jaka_robot::{Cause, ErrorKind, Evidence, MotionStatus, Robot, ServoConfig};
use jaka_sim::Controller;
use jaka_tests::{Arm, LONG};
use serde_json::Value;

/// Panics where it is to say what a packet means that shows the first input high.
struct Odd(RobotStatus);

impl Odd {
    fn is_odd(&self) -> bool {
        self.0.digital_inputs.as_ref().is_some_and(|inputs| inputs[0])
    }
}

impl Decode for Odd {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl MotionStatus for Odd {
    fn robot_status(&self) -> RobotStatus {
        if self.is_odd() {
            // A panic without a message, which could take longer than the test has.
            resume_unwind(Box::new("as it should"));
        }
        self.0.clone()
    }
}

fn ready() -> (Arm, Robot<Odd>) {
    let arm = Arm::simulated().status_period(Duration::from_millis(10)).start();
    let robot = Robot::with_monitor(arm.client(), arm.monitor::<Odd>()).expect("it is the only robot");
    (arm, robot)
}

/// Lets a packet come now whose type panics or not, as all later ones do.
fn pass_packet(arm: &Arm, is_odd: bool) {
    arm.set_state(|state| state.digital_inputs[0] = is_odd);
    arm.publish();
    arm.clock().sleep(Duration::from_millis(1));
}

fn motion() -> JointMove {
    JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0)
}

#[test]
fn motions_are_kept_back_by_a_packet_whose_type_panics_and_by_the_stops_after_it() {
    let (controller, mut robot) = ready();
    pass_packet(&controller, true);
    pass_packet(&controller, false);
    let error = robot.start(&motion()).expect_err("that packet may have shown a stop");
    let ErrorKind::NotAcknowledged { occurrence } = error.kind() else { panic!("{error:?}") };
    let Evidence::Status { unreadable: Some(source), .. } = &occurrence.evidence else { panic!("{error:?}") };
    assert!(source.to_string().contains("a panic"), "{source}");
    controller.collide();
    robot.monitor().wait_until(|packet| packet.0.protective_stop == Some(true), LONG).expect("packets show it");
    robot.monitor().next_packet().expect("packets come");
    assert!(
        robot.unacknowledged().is_some_and(|found| found.cause == Cause::ProtectiveStop),
        "{:?}",
        robot.unacknowledged()
    );
    controller.set_state(|state| {
        state.protective_stop = false;
        (state.powered, state.enabled) = (true, true);
    });
    robot.monitor().wait_until(|packet| packet.0.protective_stop == Some(false), LONG).expect("packets show it");
    let error = robot.start(&motion()).expect_err("nobody has looked");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    robot.acknowledge();
    robot.monitor().wait_until(|packet| packet.0.enabled == Some(true), LONG).expect("packets show it");
    robot.run(&motion(), LONG).expect("nothing keeps it back").reached().expect("nothing stops it");
}

#[test]
fn no_motion_is_sent_while_the_type_of_packets_panics() {
    let (controller, mut robot) = ready();
    pass_packet(&controller, true);
    robot.acknowledge();
    let error = robot.start(&motion()).expect_err("the status is not known");
    let is_kept_back = matches!(error.kind(), ErrorKind::StatusUnknown { .. } | ErrorKind::NotAcknowledged { .. });
    assert!(is_kept_back, "{error:?}");
    drop(robot);
    assert!(controller.requests().is_empty(), "{:?}", controller.requests());
}

/// The steps of joint 3 in the set-points that have come.
fn steps(controller: &Controller) -> Vec<f64> {
    let requests = controller.requests();
    let requests = requests.iter().map(|text| serde_json::from_str::<Value>(text).expect("requests are JSON"));
    let set_points = requests.filter(|request| request["cmdName"] == "servo_j");
    set_points.map(|request| request["jointPosition"][2].as_f64().expect("a number")).collect()
}

/// The longest step from which an arm may be left at rest, in deg: 720 deg/s² over periods of 32 ms.
const MOST: f64 = 0.74;

#[test]
fn a_servo_session_lands_where_the_type_of_packets_panics_once_or_from_then_on() {
    for is_once in [true, false] {
        let (controller, mut robot) = ready();
        let config = ServoConfig::new().step_count(4).max_unanswered(LONG).rest_timeout(Duration::from_secs(1));
        let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
        let error = (1..60).find_map(|n| {
            if n == 5 {
                pass_packet(&controller, true);
                controller.set_state(|state| state.digital_inputs[0] = !is_once);
            }
            session.send_joint_offset([0.0, 0.0, f64::min(0.5 * f64::from(n), 2.0), 0.0, 0.0, 0.0]).err()
        });
        let error = error.expect("the session ends with the status");
        drop(session);
        let state = controller.state();
        assert!(!state.servo_mode && state.enabled, "{error}");
        let steps = steps(&controller);
        assert!(steps.last().is_some_and(|step| step.abs() <= MOST), "{error}: {steps:?}");
        assert!(robot.unacknowledged().is_some(), "{error}");
    }
}

/// The lost status would have the session land.
#[test]
fn no_set_point_goes_out_after_a_stop_that_a_packet_has_shown_also_if_the_status_is_lost_after_it() {
    for (key, cause) in [("emergency_stop", Cause::EmergencyStop), ("protective_stop", Cause::ProtectiveStop)] {
        let (controller, mut robot) = ready();
        let show = |stop: u8| {
            controller.set_status([(key.to_owned(), stop.into())]);
            pass_packet(&controller, false);
        };
        let mut session = robot.enter_servo_mode(ServoConfig::new().step_count(4)).expect("the arm is enabled");
        for n in 1..=5 {
            session.send_joint_offset([0.0, 0.0, 0.5 * f64::from(n), 0.0, 0.0, 0.0]).expect("it is within the limits");
        }
        show(1);
        show(0);
        pass_packet(&controller, true);
        let error = session.send_joint_offset([0.0, 0.0, 2.5, 0.0, 0.0, 0.0]).expect_err("a packet has shown a stop");
        assert_eq!(error.cause(), cause, "{error:?}");
        drop(session);
        assert_eq!(steps(&controller), [0.5, 1.0, 1.5, 2.0, 2.5]);
    }
}

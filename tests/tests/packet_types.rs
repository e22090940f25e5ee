//! Packets of a type of the user's own whose code panics: they count as packets that cannot be read.

use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::mpsc;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_sim::{Controller, Delays};
use jaka_sync::motion::JointMove;
use jaka_sync::status::RobotStatus;
use jaka_sync::{Config, ErrorKind, Monitor, MotionStatus, Outcome, Robot, ServoConfig};
use serde_json::Value;

/// Longer than anything takes.
const LONG: Duration = Duration::from_secs(60);

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

fn ready() -> (Controller, Robot<Odd>) {
    let builder = Controller::builder().delays(Delays::NONE).status_period(Duration::from_millis(10));
    let controller = builder.start().expect("loopback has free ports");
    controller.set_state(|state| (state.powered, state.enabled) = (true, true));
    let config = Config::new().stale_after(LONG);
    let monitor: Monitor<Odd> = config.connect_monitor(controller.status_addr()).expect("the controller listens");
    monitor.wait_until(|packet| packet.0.enabled == Some(true), LONG).expect("it is enabled");
    let client = config.connect_client(controller.command_addr()).expect("the controller listens");
    (controller, Robot::with_monitor(client, monitor))
}

/// Lets packets come whose type panics, and then others.
fn pass_odd_packets(controller: &Controller, robot: &Robot<Odd>) {
    for is_odd in [true, false] {
        controller.set_state(|state| state.digital_inputs[0] = is_odd);
        robot.monitor().wait_until(|packet| packet.is_odd() == is_odd, LONG).expect("packets come");
    }
    // Observers have had those before.
    robot.monitor().next_packet().expect("packets come");
}

fn motion() -> JointMove {
    JointMove::absolute([5.0, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0)
}

#[test]
fn motions_are_kept_back_by_a_packet_whose_type_panics_and_by_the_stops_after_it() {
    let (controller, mut robot) = ready();
    pass_odd_packets(&controller, &robot);
    let error = robot.start(&motion()).expect_err("that packet may have shown a stop");
    let ErrorKind::NotAcknowledged { outcome: Outcome::StatusLost { unreadable: Some(source), .. } } = error.kind()
    else {
        panic!("{error:?}")
    };
    assert!(source.to_string().contains("a panic"), "{source}");
    controller.collide();
    robot.monitor().wait_until(|packet| packet.0.protective_stop == Some(true), LONG).expect("packets show it");
    robot.monitor().next_packet().expect("packets come");
    assert!(matches!(robot.unacknowledged(), Some(Outcome::ProtectiveStop)), "{:?}", robot.unacknowledged());
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
    controller.set_state(|state| state.digital_inputs[0] = true);
    robot.monitor().wait_until(Odd::is_odd, LONG).expect("packets come");
    robot.monitor().next_packet().expect("packets come");
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
        let (odd, odd_comes) = mpsc::channel();
        robot.monitor().observe(move |packet| {
            let is_told = !packet.status.is_odd() || odd.send(()).is_ok();
            if is_told { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        let is_odd = |is_odd| controller.set_state(|state| state.digital_inputs[0] = is_odd);
        let config = ServoConfig::new().step_count(4).max_unanswered(LONG).rest_timeout(Duration::from_secs(1));
        let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
        let error = (1..60).find_map(|n| {
            if n == 5 {
                is_odd(true);
                odd_comes.recv_timeout(LONG).expect("packets come");
                is_odd(!is_once);
            }
            session.send_joint_offset([0.0, 0.0, f64::min(0.5 * f64::from(n), 2.0), 0.0, 0.0, 0.0]).err()
        });
        let error = error.expect("the session ends with the status");
        drop(session);
        let state = controller.state();
        assert!(!state.servo_mode && state.enabled, "{error}");
        let steps = steps(&controller);
        assert!(steps.last().is_some_and(|step| step.abs() <= MOST), "{error}: {steps:?}");
        // Where the machine was too busy to follow, the arm stood before.
        assert!(error.is_invalid_argument() || robot.unacknowledged().is_some(), "{error}");
    }
}

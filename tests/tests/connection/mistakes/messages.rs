//! The other messages of the page, in its order: made with a simulated controller where it can make them, and otherwise
//! by themselves.

use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_robot::{
    Cause, Client, Disconnect, Error, ErrorKind, Evidence, Monitor, Occurrence, Remedy, Robot, ServoConfig,
    ServoModeState,
};
use jaka_sim::{Fault, StatusFault};
use jaka_tests::{Arm, LONG};

use super::{refusal, robot, said, turn};

const SHORT: Duration = Duration::from_millis(300);

pub(super) fn all() -> Vec<String> {
    [of_the_connection(), of_the_status(), of_the_state(), of_ends()].concat()
}

fn kind(kind: impl Into<Error>) -> String {
    said(&kind.into())
}

fn of_the_connection() -> Vec<String> {
    let controller = Arm::simulated().config(|config| config.reply_timeout(SHORT)).start();
    let client = || controller.client();
    let answered = |bytes: &[u8]| {
        controller.inject(Fault::Instead(bytes.to_vec()));
        refusal(client().get_version())
    };
    controller.inject(Fault::Drop);
    let late = refusal(client().get_version());
    let web_server = answered(b"HTTP/1.1 400 Bad Request\r\n");
    let other_shape = answered(br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_version"}"#);
    let config = controller.config();
    let mut on_status_port = Client::connect_with(&config, controller.status_addr()).expect("it listens");
    let monitor: Monitor = Monitor::connect_with(&config, controller.command_addr()).expect("it listens");
    let silent = refusal(monitor.next_packet());
    vec![late, refusal(on_status_port.get_version()), silent, web_server, other_shape]
}

fn of_the_status() -> Vec<String> {
    let controller = Arm::simulated().config(|config| config.stale_after(SHORT)).start();
    controller.status_fault(StatusFault::Silent);
    let config = controller.config();
    let mut robot =
        Robot::connect_at(&config, controller.command_addr(), controller.status_addr()).expect("it listens");
    let missing = refusal(robot.run(&turn(5.0, 5.0), LONG));
    controller.status_fault(StatusFault::None);
    robot.monitor().wait_until(|_| true, LONG).expect("packets come");
    controller.status_fault(StatusFault::Silent);
    controller.clock().sleep(2 * SHORT);
    vec![missing, refusal(robot.run(&turn(5.0, 5.0), LONG))]
}

fn of_the_state() -> Vec<String> {
    let (controller, mut robot) = robot(true, true);
    let denied = br#"{"errorCode": "3", "errorMsg": "permission deny, please check remote control source", "cmdName": "joint_move"}"#;
    controller.inject_for("joint_move", Fault::Instead(denied.to_vec()));
    let denied = refusal(robot.run(&turn(5.0, 5.0), LONG));
    controller.press_emergency_stop();
    let mut stopped = controller.robot();
    let soft_limit = ErrorKind::NotReady { occurrence: Cause::SoftLimit.into() };
    let not_entered = ErrorKind::NotReady { occurrence: ServoModeState::NotEntered.into() };
    let says = Some("powered, not enabled".to_owned());
    let within = Duration::from_millis(200);
    let moves = ErrorKind::NotAtRest { joint: 1, by_deg: 9.4, within, speed: 47.0, rest_speed: 0.5 };
    let command = "disable_robot".to_owned();
    let moving = ErrorKind::NotSent { command, because: moves.into(), remedy: Remedy::WaitForRest };
    let (silent, mut asked) = super::robot(true, true);
    silent.inject_for("get_joint_pos", Fault::Drop);
    vec![
        denied,
        refusal(stopped.power_up(LONG)),
        kind(jaka_sync::ErrorKind::StateTimeout { after: LONG, packets: 1998, says }),
        kind(soft_limit),
        Occurrence::from(Cause::SoftLimit).to_string(),
        kind(ErrorKind::NotAcknowledged { occurrence: Cause::DragMode.into() }),
        kind(ErrorKind::NotReady { occurrence: Cause::DragMode.into() }),
        kind(not_entered),
        kind(moving),
        refusal(asked.run(&turn(5.0, 5.0), LONG)),
    ]
}

fn of_ends() -> Vec<String> {
    let ends = [Cause::Stopped, Cause::AtRest, Cause::EmergencyStop, Cause::NotPowered, Cause::NotEnabled];
    let lost = Occurrence::new(Cause::StatusLost, Evidence::Status { cause: None, unreadable: None });
    let seat_lost = Evidence::Commands {
        address: "10.5.5.100:10001".to_owned(),
        cause: Arc::new(Disconnect::Closed { partial: 0 }),
    };
    let seat_lost = Occurrence::new(Cause::CommandsLost, seat_lost);
    let (accepted, not_sent) = (vec!["power_on".to_owned()], vec!["enable_robot".to_owned()]);
    let stopped = ErrorKind::Stopped { accepted, not_sent };
    let late = ErrorKind::SetPointLate { late: Duration::from_millis(120) };
    let step_count = refusal(robot(true, true).1.enter_servo_mode(ServoConfig::new().step_count(99)));
    let denied = io::ErrorKind::PermissionDenied.into();
    let priority = ErrorKind::RealtimePriority { priority: 20, source: denied };
    let ends = ends.map(Occurrence::from).into_iter().chain([lost, seat_lost]).map(|end| end.to_string());
    ends.chain([kind(stopped), kind(late), step_count, kind(priority)]).collect()
}

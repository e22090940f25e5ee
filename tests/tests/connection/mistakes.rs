//! `docs/troubleshooting.md`: each mistake that it names is made, and each message that it quotes is one that this code
//! gives.

mod messages;

use std::error::Error as StdError;
use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::motion::JointMove;
use jaka_robot::servo::ServoJ;
use jaka_robot::types::Switch;
use jaka_robot::{Client, Config, Robot, RobotConfig, ServoConfig};
use jaka_sim::Fault;
use jaka_tests::{Arm, Configured as _, LONG, ReservedPort};

const PAGE: &str = include_str!("../../../docs/troubleshooting.md");
/// Joint position of the simulated arm, in degrees.
const START: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0];

/// An error with its causes, in one line, as `jaka` prints it.
fn said(error: &(dyn StdError + 'static)) -> String {
    let errors = std::iter::successors(Some(error), |&error| error.source());
    errors.map(ToString::to_string).collect::<Vec<_>>().join(": ")
}

fn refusal<T: std::fmt::Debug>(result: Result<T, impl StdError + 'static>) -> String {
    said(&result.expect_err("it is a mistake"))
}

/// A robot whose arm has power, and is enabled or not.
fn robot(powered: bool, enabled: bool) -> (Arm, Robot) {
    let arm = Arm::simulated().start();
    arm.set_state(|state| (state.powered, state.enabled) = (powered, enabled));
    let robot = arm.robot();
    (arm, robot)
}

/// Joint 1 by so many degrees, at this speed.
fn turn(offset: f64, speed: f64) -> JointMove {
    JointMove::relative([offset, 0.0, 0.0, 0.0, 0.0, 0.0], speed)
}

fn to(joint: usize, position: f64) -> JointMove {
    let mut joints = START;
    joints[joint - 1] = position;
    JointMove::absolute(joints, 20.0).acceleration(100.0)
}

fn wrong_address() -> Vec<String> {
    let nobody = ReservedPort::any();
    let config = Config::new();
    let with_port = Robot::connect("10.5.5.100:10001");
    vec![refusal(Robot::connect_at(&config, nobody.address(), nobody.address())), refusal(with_port)]
}

fn robot_off() -> Vec<String> {
    vec![refusal(robot(false, false).1.run(&turn(5.0, 5.0), LONG))]
}

fn not_enabled() -> Vec<String> {
    vec![refusal(robot(true, false).1.run(&turn(5.0, 5.0), LONG))]
}

fn seat_taken() -> Vec<String> {
    let (controller, mut client) = Arm::simulated().with_client();
    controller.inject_for("get_joint_pos", Fault::Takeover);
    let nobody = ReservedPort::any();
    vec![refusal(Client::connect(nobody.address())), refusal(client.get_joint_pos()), refusal(client.get_joint_pos())]
}

fn servo_mode() -> Vec<String> {
    let (_controller, mut robot) = robot(true, true);
    let set_point = robot.client().servo_j(&ServoJ::relative([0.1, 0.0, 0.0, 0.0, 0.0, 0.0]));
    robot.client().set_servo_mode(Switch::On).expect("it is entered at rest");
    vec![refusal(set_point), refusal(robot.enter_servo_mode(ServoConfig::new()).map(drop))]
}

fn unit_of_speed() -> Vec<String> {
    let (_controller, mut robot) = robot(true, true);
    let millimetres = robot.run(&turn(5.0, 500.0), LONG);
    let radians = robot.run(&turn(5.0, 0.1), Duration::from_secs(1)).expect("it is accepted");
    vec![refusal(millimetres), said(&radians.reached().expect_err("it takes 50 s"))]
}

fn beyond_limits() -> Vec<String> {
    let (controller, mut robot) = robot(true, true);
    let (never, refused) = (robot.run(&to(3, 400.0), LONG), robot.run(&to(3, 200.0), LONG));
    drop(robot);
    let limits = Limits::of(Model::named("Zu 5").expect("it is published"));
    let mut limited = controller.robot().configured(&RobotConfig::new().limits(limits)).expect("it is a Zu 5");
    vec![refusal(never), refusal(refused), refusal(limited.run(&to(3, 181.2), LONG))]
}

fn collision() -> Vec<String> {
    let (controller, mut robot) = robot(true, true);
    robot.start(&turn(60.0, 5.0)).expect("it is accepted");
    controller.collide();
    let end = robot.wait(LONG).reached().expect_err("it does not get there");
    robot.client().clear_error().expect("it is accepted");
    robot.monitor().wait_until(|status| status.protective_stop == Some(false), LONG).expect("it is left");
    vec![said(&end), refusal(robot.run(&turn(5.0, 5.0), LONG))]
}

fn forgot_to_wait() -> Vec<String> {
    let (_controller, mut robot) = robot(true, true);
    robot.start(&turn(60.0, 5.0)).expect("it is accepted");
    vec![refusal(robot.enter_servo_mode(ServoConfig::new()).map(drop))]
}

fn dropped_client() -> Vec<String> {
    let (_controller, robot) = robot(true, true);
    let stop = robot.stop_handle();
    drop(robot);
    vec![refusal(stop.stop())]
}

/// The rows of the table below a heading, each with its cells.
fn rows(heading: &str) -> Vec<Vec<&'static str>> {
    let part = PAGE.split("\n# ").find(|part| part.starts_with(heading)).expect("the page has the part");
    let lines = part.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |")).skip(1);
    lines.map(|line| line.split(" | ").collect()).collect()
}

/// The messages that a cell quotes.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split("``").skip(1).step_by(2).map(str::trim).collect()
}

/// True if it is the message, in whose quotation `…` stands for anything.
fn fits(quotation: &str, message: &str) -> bool {
    let parts: Vec<_> = quotation.split('…').collect();
    let [first, between @ .., last] = &parts[..] else { return quotation == message };
    let rest = message.strip_prefix(first).and_then(|rest| rest.strip_suffix(last));
    rest.is_some_and(|rest| {
        let after = between.iter().try_fold(rest, |rest, part| rest.split_once(part).map(|(_, after)| after));
        after.is_some()
    })
}

/// Makes a mistake, and returns the messages, one a line.
type Mistake = fn() -> Vec<String>;

#[test]
fn each_of_the_ten_mistakes_is_told_as_the_page_says() {
    let mistakes: [(&str, Mistake); 10] = [
        ("Wrong address", wrong_address),
        ("The arm has no power", robot_off),
        ("The arm is not enabled", not_enabled),
        ("The seat is taken", seat_taken),
        ("Servo mode", servo_mode),
        ("Wrong unit of speed", unit_of_speed),
        ("Target beyond limits", beyond_limits),
        ("Collision", collision),
        ("Not waited for", forgot_to_wait),
        ("The client was dropped", dropped_client),
    ];
    let rows = rows("The ten mistakes");
    assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), mistakes.map(|(name, _)| name));
    for (row, (name, make)) in rows.iter().zip(mistakes) {
        assert_quoted(name, &quoted(row[1]), &make());
        assert!(!row[2].is_empty(), "{name}");
    }
}

fn assert_quoted(name: &str, quoted: &[&str], said: &[String]) {
    let fit = quoted.len() == said.len() && quoted.iter().zip(said).all(|(quoted, said)| fits(quoted, said));
    assert!(fit, "{name}: the page has\n{quoted:#?}\nwhere the code says\n{said:#?}");
    for quoted in quoted {
        assert!(quoted.replace('…', "").len() > 15, "{name}: {quoted} says too little");
    }
}

#[test]
fn each_other_message_is_one_that_the_code_gives() {
    let rows = rows("Other messages");
    let said = messages::all();
    let quoted: Vec<_> = rows.iter().flat_map(|row| quoted(row[0])).collect();
    assert_quoted("other messages", &quoted, &said);
    assert!(rows.iter().all(|row| row.len() == 3 && row.iter().all(|cell| !cell.is_empty())));
}

#[test]
fn a_message_that_the_code_does_not_give_is_noticed() {
    assert!(fits("no reply to `…` within …; it", "no reply to `a` within 1s; it"));
    for other in ["no reply to `a` within 1s", "a no reply to `a` within 1s; it", "no reply to `a` in 1s; it", ""] {
        assert!(!fits("no reply to `…` within …; it", other), "{other}");
    }
    assert!(fits("a", "a") && !fits("a", "ab") && !fits("ab…ba", "aba"));
}

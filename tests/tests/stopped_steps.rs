//! A stop of the program's own while a call sends one step after the other. The controller is two plain sockets.

use std::io::{Read, Write};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sync::servo::SetServoMoveFilter;
use jaka_sync::{Error, ErrorKind, Robot, RobotStop, ServoConfig};
use jaka_tests::HandFed;

/// Longer than anything takes.
const LONG: Duration = Duration::from_secs(60);

/// What the controller received, and what it tells of the arm.
#[derive(Debug, Default)]
struct Arm {
    received: Vec<String>,
    powered: bool,
    enabled: bool,
    /// What is being switched, and how many queries that takes yet.
    switching: Option<(String, u32)>,
}

impl Arm {
    /// Takes a request, and replies to it. What is switched takes until the third query after it.
    fn reply(&mut self, command: &str) -> String {
        match command {
            "power_on" | "enable_robot" | "disable_robot" | "power_off" => {
                self.switching = Some((command.to_owned(), 3));
            }
            "get_robot_state" => self.switch(),
            _ => {}
        }
        self.received.push(command.to_owned());
        let more = match command {
            "get_robot_state" => {
                let enable = if self.enabled { "robot_enabled" } else { "robot_disabled" };
                let power = if self.powered { "powered_on" } else { "powered_off" };
                format!(r#", "enable": "{enable}", "power": "{power}""#)
            }
            "power_on" => r#", "power status": "True""#.to_owned(),
            "enable_robot" => r#", "enabled status": "True""#.to_owned(),
            "get_joint_pos" => r#", "joint_pos": [0, 90, 90, 90, -90, 0]"#.to_owned(),
            "is_in_servomove" => r#", "in_servomove": false"#.to_owned(),
            _ => String::new(),
        };
        format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{command}"{more}}}"#)
    }

    fn switch(&mut self) {
        let Some((what, left)) = &mut self.switching else { return };
        *left -= 1;
        match what.as_str() {
            _ if *left > 0 => {}
            "power_on" => self.powered = true,
            "enable_robot" => self.enabled = true,
            "disable_robot" => self.enabled = false,
            _ => self.powered = false,
        }
        self.switching.take_if(|(_, left)| *left == 0);
    }

    /// The commands that change something.
    fn changes(&self) -> Vec<&str> {
        let is_query = |name: &&str| name.starts_with("get_") || name.starts_with("is_");
        self.received.iter().map(String::as_str).filter(|name| !is_query(name)).collect()
    }
}

/// Answers for the controller while the robot works. When this many requests of this name have come, a stop is called, and the reply waits until the
/// stop has come.
fn stopped_at<T: Send>(
    controller: &mut HandFed,
    arm: &mut Arm,
    (at, times): (&str, usize),
    stop: &RobotStop,
    work: impl FnOnce() -> T + Send,
) -> T {
    controller.commands.set_read_timeout(Some(Duration::from_millis(10))).expect("it is a time");
    thread::scope(|scope| {
        let working = scope.spawn(work);
        let (since, mut seen, mut held) = (Instant::now(), 0, None);
        while !working.is_finished() {
            assert!(since.elapsed() < LONG, "the call does not end: {arm:?}");
            controller.packet("");
            let mut space = [0; 4096];
            let length = controller.commands.read(&mut space).unwrap_or(0);
            let text = String::from_utf8_lossy(&space[..length]).replace("\": \"", "\":\"");
            let mut replies = String::new();
            for command in text.split("\"cmdName\":\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                let reply = arm.reply(command);
                seen += usize::from(command == at);
                if command == at && seen == times {
                    held = Some(reply);
                    scope.spawn(|| stop.stop().expect("it is accepted"));
                } else {
                    replies.extend(held.take_if(|_| command == "stop_program"));
                    replies.push_str(&reply);
                }
            }
            controller.commands.write_all(replies.as_bytes()).expect("the robot is connected");
        }
        working.join().expect("the call does not panic")
    })
}

/// A robot, and its controller, which has told that the arm is not stopped.
fn robot() -> (HandFed, Robot) {
    let (mut controller, robot) = HandFed::new(LONG);
    controller.packet_to(&robot, "");
    (controller, robot)
}

/// The steps that had been accepted, and those that were not sent.
fn steps(error: &Error) -> [&[String]; 2] {
    let ErrorKind::Stopped { accepted, not_sent } = error.kind() else { panic!("{error:?}") };
    assert!(!error.may_have_run() && !error.is_disconnected() && !error.is_timeout(), "{error:?}");
    [accepted, not_sent]
}

#[test]
fn after_a_stop_no_further_step_of_powering_up_is_sent() {
    for (at, accepted, not_sent) in [
        // Before the first step; while the first one is done; while the second one is done.
        (("get_robot_state", 1), &[][..], &["power_on", "enable_robot"][..]),
        (("power_on", 1), &["power_on"], &["enable_robot"]),
        (("get_robot_state", 2), &["power_on"], &["enable_robot"]),
        (("enable_robot", 1), &["power_on", "enable_robot"], &[]),
    ] {
        let ((mut controller, mut robot), mut arm) = (robot(), Arm::default());
        let stop = robot.stop_handle();
        let ended = stopped_at(&mut controller, &mut arm, at, &stop, || robot.power_up(LONG));
        let error = ended.expect_err("it was stopped");
        assert_eq!(steps(&error), [accepted, not_sent], "{at:?}: {error}");
        let mut changes = arm.changes();
        changes.retain(|name| *name != "stop_program");
        assert_eq!(changes, accepted, "{at:?}");
        // Nor by another call, until somebody has acknowledged it.
        let before = arm.changes().len();
        let again = stopped_at(&mut controller, &mut arm, ("none", 1), &stop, || robot.power_up(LONG));
        if accepted.len() < 2 {
            again.expect_err("nobody has acknowledged the stop");
        }
        assert_eq!(arm.changes().len(), before, "{at:?}");
        robot.acknowledge();
        stopped_at(&mut controller, &mut arm, ("none", 1), &stop, || robot.power_up(LONG))
            .expect("it was acknowledged");
        assert!(arm.powered && arm.enabled, "{at:?}: {arm:?}");
    }
}

#[test]
fn after_a_stop_no_further_step_of_powering_down_is_sent() {
    let ((mut controller, mut robot), mut arm) = (robot(), Arm { powered: true, enabled: true, ..Arm::default() });
    let stop = robot.stop_handle();
    let ended = stopped_at(&mut controller, &mut arm, ("disable_robot", 1), &stop, || robot.power_down(LONG));
    let error = ended.expect_err("it was stopped");
    assert_eq!(steps(&error), [["disable_robot"], ["power_off"]], "{error}");
    assert_eq!(arm.changes(), ["disable_robot", "stop_program"]);
    assert_eq!(
        error.to_string(),
        "ended by a stop of this program (accepted before it: `disable_robot`; not sent: `power_off`); when somebody has checked the \
         robot, call `acknowledge`"
    );
}

#[test]
fn after_a_stop_no_filter_is_set_for_servo_mode() {
    let ((mut controller, mut robot), mut arm) = (robot(), Arm::default());
    let stop = robot.stop_handle();
    let config = ServoConfig::new().filter(SetServoMoveFilter::disabled());
    let error = stopped_at(&mut controller, &mut arm, ("is_in_servomove", 1), &stop, || {
        robot.enter_servo_mode(&config).map(drop).expect_err("it was stopped")
    });
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    assert_eq!(arm.changes(), ["stop_program"]);
}

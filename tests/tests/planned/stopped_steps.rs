//! A stop of the program's own while a call sends one step after the other. The controller is two plain sockets.

use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::{Error, ErrorKind, Robot, RobotStop, ServoConfig};
use jaka_sim::SimulatedClock;
use jaka_tests::simulated::{beside, until};
use jaka_tests::{ClockedSocket, HandFed, LONG};

/// Time between two packets, and between two looks at the requests.
const PERIOD: Duration = Duration::from_millis(10);

/// Requests that the controller received, and the state of the arm that it reports.
#[derive(Debug, Default)]
struct Arm {
    received: Vec<String>,
    powered: bool,
    enabled: bool,
    /// Command that is being carried out, and the number of queries until its effect.
    switching: Option<(String, u32)>,
}

impl Arm {
    /// Takes a request, and replies to it. A switch takes effect with the third query after it.
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

/// A robot, and its controller, which has told that the arm is not stopped.
struct Bench {
    clock: SimulatedClock,
    controller: HandFed<ClockedSocket>,
    robot: Robot,
    arm: Arm,
}

impl Bench {
    fn new(arm: Arm) -> Self {
        let clock = SimulatedClock::new();
        let (mut controller, robot) = HandFed::by_clock(&clock, LONG);
        controller.packet_to(&robot, "");
        Self { clock, controller, robot, arm }
    }

    /// Answers for the controller while the robot works. When this many requests of this name have come, a stop is
    /// called, and the reply waits until the stop has come.
    fn stopped_at<T>(&mut self, (at, times): (&str, usize), work: impl FnOnce(&mut Robot) -> T) -> T {
        let Self { clock, controller, robot, arm } = self;
        let stop: RobotStop = robot.stop_handle();
        let (is_called, has_stopped, is_done) =
            (AtomicBool::new(false), AtomicBool::new(false), AtomicBool::new(false));
        let is = |flag: &AtomicBool| flag.load(Ordering::SeqCst);
        let stop_when_called = || {
            until(clock, || is(&is_called) || is(&is_done));
            if is(&is_called) {
                stop.stop().expect("it is accepted");
            }
            has_stopped.store(true, Ordering::SeqCst);
        };
        let serve = || {
            let (since, mut seen, mut held) = (clock.elapsed(), 0, None);
            while !(is(&is_done) && is(&has_stopped)) {
                assert!(clock.elapsed() < since + 2 * LONG, "the call does not end: {arm:?}");
                controller.packet("");
                let text = controller.commands.waiting();
                let mut replies = String::new();
                for command in text.split("\"cmdName\":\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                    let reply = arm.reply(command);
                    seen += usize::from(command == at);
                    if command == at && seen == times {
                        held = Some(reply);
                        is_called.store(true, Ordering::SeqCst);
                    } else {
                        replies.extend(held.take_if(|_| command == "stop_program"));
                        replies.push_str(&reply);
                    }
                }
                controller.commands.write_all(replies.as_bytes()).expect("the robot is connected");
                clock.sleep(PERIOD);
            }
        };
        beside(clock, stop_when_called, || {
            beside(clock, serve, || {
                let done = work(robot);
                is_done.store(true, Ordering::SeqCst);
                done
            })
        })
    }
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
        let mut bench = Bench::new(Arm::default());
        let ended = bench.stopped_at(at, |robot| robot.power_up(LONG));
        let error = ended.expect_err("it was stopped");
        assert_eq!(steps(&error), [accepted, not_sent], "{at:?}: {error}");
        let mut changes = bench.arm.changes();
        changes.retain(|name| *name != "stop_program");
        assert_eq!(changes, accepted, "{at:?}");
        // Nor by another call, until somebody has acknowledged it.
        let before = bench.arm.changes().len();
        let again = bench.stopped_at(("none", 1), |robot| robot.power_up(LONG));
        if accepted.len() < 2 {
            again.expect_err("nobody has acknowledged the stop");
        }
        assert_eq!(bench.arm.changes().len(), before, "{at:?}");
        bench.robot.acknowledge();
        bench.stopped_at(("none", 1), |robot| robot.power_up(LONG)).expect("it was acknowledged");
        assert!(bench.arm.powered && bench.arm.enabled, "{at:?}: {:?}", bench.arm);
    }
}

#[test]
fn after_a_stop_no_further_step_of_powering_down_is_sent() {
    let mut bench = Bench::new(Arm { powered: true, enabled: true, ..Arm::default() });
    let ended = bench.stopped_at(("disable_robot", 1), |robot| robot.power_down(LONG));
    let error = ended.expect_err("it was stopped");
    assert_eq!(steps(&error), [["disable_robot"], ["power_off"]], "{error}");
    assert_eq!(bench.arm.changes(), ["disable_robot", "stop_program"]);
    assert_eq!(
        error.to_string(),
        "ended by a stop of this program (accepted before it: `disable_robot`; not sent: `power_off`); look at the \
         arm, then call `acknowledge`"
    );
}

#[test]
fn after_a_stop_no_filter_is_set_for_servo_mode() {
    let mut bench = Bench::new(Arm::default());
    let config = ServoConfig::new().filter(SetServoMoveFilter::disabled());
    let error = bench.stopped_at(("is_in_servomove", 1), |robot| {
        robot.enter_servo_mode(&config).map(drop).expect_err("it was stopped")
    });
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    assert_eq!(bench.arm.changes(), ["stop_program"]);
}

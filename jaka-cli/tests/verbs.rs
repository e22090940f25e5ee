//! The commands that do one thing to a robot: `up`, `down`, `stop`, `clear`, `move` and `jog`.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::io::Write;
use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use expect_test::expect;
use jaka_sim::{Controller, Delays, Fault, Habits};
use jaka_tests::{Arm, ReservedPort};
use serde_json::{Deserializer, Map, Value, json};

#[cfg(unix)]
use crate::common::{interrupt, wait_until};
use crate::program::{Run, jaka, result, scratch, started_at, wait_for_motion, without_late_answer};

fn run(controller: &Controller, line: &str) -> Run {
    result(started_at(controller, line))
}

/// The requests that were not queries.
fn changes(controller: &Controller) -> Vec<String> {
    let requests = controller.requests().into_iter();
    requests.filter(|request| !request.contains("\"get_")).collect()
}

#[test]
fn up_and_down_send_what_is_needed() {
    let controller = Arm::real_time().without_power().start();
    let up = run(&controller, "up --yes");
    assert_eq!((up.code, up.out.as_str()), (Some(0), "the arm is powered and enabled\n"), "{up:?}");
    assert!(controller.state().enabled);
    assert_eq!(changes(&controller), [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"enable_robot"}"#]);
    assert_eq!(run(&controller, "up --yes").code, Some(0));
    assert_eq!(changes(&controller).len(), 2, "it is up already");
    expect![[r"
        the arm has no power
        exit code 0
    "]]
    .assert_eq(&run(&controller, "down --yes").text());
    assert!(!controller.state().powered);
    assert_eq!(changes(&controller)[2..], [r#"{"cmdName":"disable_robot"}"#, r#"{"cmdName":"power_off"}"#]);
    controller.press_emergency_stop();
    let pressed = run(&controller, "up --yes");
    assert_eq!(pressed.code, Some(20), "{pressed:?}");
    assert!(pressed.err.contains("emergency stop is pressed"), "{pressed:?}");
    assert_eq!(changes(&controller).len(), 4, "nothing was sent");
}

#[test]
fn down_leaves_the_power_to_an_arm_that_moves() {
    let controller = Arm::real_time().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).start();
    let far = "call joint_move --mode absolute --joint-position 300,90,90,90,-90,0 --speed 5 --acceleration 100 --yes";
    assert_eq!(run(&controller, far).code, Some(0));
    for line in ["down --yes", "down --yes --without-joints"] {
        let down = run(&controller, line);
        assert_eq!((down.code, down.out.as_str()), (Some(20), ""), "{down:?}");
        let [fact, hint] = down.err.lines().collect::<Vec<_>>()[..] else { panic!("{down:?}") };
        assert!(
            fact.starts_with("error: `disable_robot` was not sent: the arm is moving: joint 1 turned by "),
            "{fact}"
        );
        assert_eq!(hint, "hint: `jaka stop` stops it; try again once it is at rest");
    }
    let sent = changes(&controller);
    assert!(sent.len() == 1 && sent[0].contains("joint_move"), "{sent:?}");
    assert!(controller.state().powered && !controller.state().at_rest);
}

#[test]
fn down_of_an_arm_without_joints_takes_an_option() {
    let controller = Arm::real_time().start();
    let refused = r#"{"errorCode": "2", "errorMsg": "no", "cmdName": "get_joint_pos"}"#;
    (0..20).for_each(|_| controller.inject_for("get_joint_pos", Fault::Instead(refused.as_bytes().to_vec())));
    expect![[r"
        error: `disable_robot` was not sent: the controller refused `get_joint_pos` with code 2: no
        hint: look at the arm; `jaka down --without-joints` powers it down all the same
        exit code 20
    "]]
    .assert_eq(&run(&controller, "down --yes").text());
    assert!(changes(&controller).is_empty());
    let down = run(&controller, "down --yes --without-joints");
    assert_eq!((down.code, down.out.as_str()), (Some(0), "the arm has no power\n"), "{down:?}");
}

#[test]
fn up_tells_how_far_it_has_come() {
    let without_times = |text: &str| text.replace(|c: char| c.is_ascii_digit(), "0");
    let notes = |controller: &Controller, line: &str| {
        let run = run(controller, line);
        assert_eq!((run.code, run.out.as_str()), (Some(0), "the arm is powered and enabled\n"), "{run:?}");
        without_times(&run.err)
    };
    let slow = || {
        let slow = Arm::real_time().without_power();
        slow.controller(|controller| controller.delays(Delays::REAL).time_scale(20.0)).start()
    };
    let controller = slow();
    expect![[r#"
        note: switching the power on
        note: the arm has power, after 0.0 s; enabling it
    "#]]
    .assert_eq(&notes(&controller, "up --yes"));
    assert_eq!(notes(&controller, "up --yes"), "", "it is up already");
    controller.set_state(|state| state.enabled = false);
    expect![[r#"
        note: enabling the arm, which has power
    "#]]
    .assert_eq(&notes(&controller, "up --yes"));
    assert_eq!(notes(&slow(), "up --yes -q"), "");
}

/// A controller of two plain sockets whose packets do not have a key: as [`showing`].
fn without_shown(key: &'static str) -> [String; 6] {
    showing(move |packet| drop(packet.remove(key).expect("it has the key")))
}

/// A controller of two plain sockets whose packets are changed, and whose arm has no power until it is switched on.
/// Returns the words that lead to it.
fn showing(change: impl Fn(&mut Map<String, Value>) + Send + 'static) -> [String; 6] {
    let (commands, status) = (listener(), listener());
    let port = |listener: &TcpListener| listener.local_addr().expect("it is bound").port().to_string();
    let words =
        ["-r", "127.0.0.1", "--command-port", &port(&commands), "--status-port", &port(&status)].map(str::to_owned);
    let is_enabled = Arc::new(AtomicBool::new(false));
    let shown = Arc::clone(&is_enabled);
    thread::spawn(move || {
        let (mut reader, _) = status.accept().expect("it listens");
        loop {
            let enabled = shown.load(Ordering::SeqCst);
            let mut packet = json!({
                "len": 100, "errcode": "0x0", "enabled": enabled, "powered_on": enabled, "inpos": true,
                "emergency_stop": 0, "protective_stop": 0,
            });
            change(packet.as_object_mut().expect("it is one"));
            // The length stands first.
            let packet = packet.to_string().replace(r#""len":100,"#, "").replacen('{', r#"{"len":100,"#, 1);
            if reader.write_all(packet.as_bytes()).is_err() {
                return;
            }
            // Packets that come later change no result.
            thread::sleep(Duration::from_millis(20));
        }
    });
    thread::spawn(move || {
        let (client, _) = commands.accept().expect("it listens");
        let mut power = "powered_off";
        for request in Deserializer::from_reader(&client).into_iter::<Value>().map_while(Result::ok) {
            let name = request["cmdName"].as_str().expect("it has a name");
            let state = match name {
                "power_on" => {
                    power = "powered_on";
                    String::new()
                }
                "enable_robot" => {
                    is_enabled.store(true, Ordering::SeqCst);
                    String::new()
                }
                _ => {
                    let enabled = if is_enabled.load(Ordering::SeqCst) { "robot_enabled" } else { "robot_disabled" };
                    format!(r#", "enable": "{enabled}", "power": "{power}""#)
                }
            };
            let reply = format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{name}"{state}}}"#);
            (&client).write_all(reply.as_bytes()).expect("the client reads");
        }
    });
    words
}

fn listener() -> TcpListener {
    TcpListener::bind("127.0.0.1:0").expect("loopback has free ports")
}

#[test]
fn up_says_nothing_of_power_that_packets_do_not_show() {
    let run = jaka(["up", "--yes"].map(str::to_owned).into_iter().chain(without_shown("powered_on")));
    assert_eq!(run.code, Some(0), "{run:?}");
    expect![[r"
        note: switching the power on
        note: the arm has power, after 0.0 s; enabling it
    "]]
    .assert_eq(&run.err.replace(|c: char| c.is_ascii_digit(), "0"));
}

#[test]
fn a_motion_is_not_sent_where_packets_do_not_show_whether_the_arm_moves() {
    for line in ["jog 6 5 --speed 5 --yes", "move --joints 0,90,80,90,-90,0 --speed 10 --yes"] {
        let run = jaka(line.split(' ').map(str::to_owned).chain(without_shown("inpos")));
        assert_eq!(run.code, Some(20), "{run:?}");
        assert!(run.err.contains("was not sent: status packets do not show whether the arm moves"), "{run:?}");
    }
}

#[test]
fn a_motion_begins_where_packets_show_the_joints_by_a_pack() {
    let pack = scratch("joints.toml");
    let text = "title = 'T'\n[[override]]\ntarget = 'RobotStatus'\nfield = 'joint_actual_position'\nwire = 'joints'\n";
    std::fs::write(&pack, text).expect("the folder is there");
    let robot = showing(|packet| drop(packet.insert("joints".to_owned(), json!([0, 90, 90, 90, -90, 0]))));
    let words = ["jog", "3", "86", "--speed", "10", "--model", "zu5", "--dry-run", "--pack"].map(str::to_owned);
    expect![[r#"
        error: `joint_move` was not sent: joint 3 would be at 176 deg; limit 175 (Zu 5)
        exit code 20
    "#]]
    .assert_eq(&jaka(words.into_iter().chain([pack.display().to_string()]).chain(robot)).text());
}

#[test]
fn a_dry_run_prints_the_request_and_takes_no_seat() {
    let controller = Arm::real_time().start();
    let dry = |line: &str| run(&controller, &format!("{line} --dry-run")).text();
    for line in ["jog 6 5 --speed 5", "move --pose -400,100,450,180,0,90 --speed 50"] {
        let alone = jaka(line.split(' ').chain(["--dry-run"]));
        assert_eq!((alone.code, alone.err.as_str()), (Some(0), ""), "{alone:?}");
        assert_eq!(dry(line), alone.text(), "nothing is asked for");
    }
    expect![[r#"
        {"cmdName":"joint_move","relFlag":1,"jointPosition":[0,0,0,0,0,5],"speed":5}
        exit code 0
    "#]]
    .assert_eq(&dry("jog 6 5 --speed 5"));
    expect![[r#"
        {"cmdName":"joint_move","relFlag":0,"jointPosition":[0,90,80,90,-90,0],"speed":10,"accel":72}
        note: compared with the limits of joints, from the position of the arm; regions and the tool's speed are compared before it is sent
        exit code 0
    "#]].assert_eq(&dry("move --joints 0,90,80,90,-90,0 --speed 10 --model zu5"));
    expect![[r#"
        error: `joint_move` was not sent: joint 3 would be at 176 deg; limit 175 (Zu 5)
        exit code 20
    "#]]
    .assert_eq(&dry("jog 3 86 --speed 10 --model zu5"));
    expect![[r#"
        {"cmdName":"moveL","relFlag":1,"cartPosition":[0,0,5,0,0,0],"speed":10}
        note: only the tool's speed was compared with limits: the tool and the frames are read before it is sent
        exit code 0
    "#]]
    .assert_eq(&dry("jog z 5 --speed 10 --model zu5"));
    expect![[r#"
        {"cmdName":"joint_move","relFlag":1,"jointPosition":[0,0,86,0,0,0],"speed":10,"accel":72}
        note: only the speed was compared with limits, because the position of the arm is not known; --robot or --sim name an arm
        exit code 0
    "#]]
    .assert_eq(&jaka("jog 3 86 --speed 10 --model zu5 --dry-run".split(' ')).text());
    let nowhere = ReservedPort::any();
    let line =
        format!("jog 1 1 --speed 5 --model zu5 --dry-run -r 127.0.0.1 --status-port {}", nowhere.address().port());
    assert_eq!(jaka(line.split(' ')).code, Some(3), "a robot that is named has to answer");
    assert!(controller.requests().is_empty());
    let before = controller.state().joint_position;
    assert_eq!(run(&controller, "jog 6 5 --speed 50 --yes").code, Some(0));
    assert!(
        (controller.state().joint_position.0[5] - before.0[5] - 5.0).abs() < 0.1,
        "what it printed is what it sends"
    );
}

#[test]
fn the_pace_is_compared_before_a_question() {
    // Nothing needs to be connected to.
    let nowhere = ReservedPort::any();
    let line = format!("jog 3 8 --speed 190 --model zu5 -r 127.0.0.1 --status-port {}", nowhere.address().port());
    let run = jaka(line.split(' '));
    assert_eq!(run.code, Some(20), "{run:?}");
    assert!(run.err.contains("joint 3 would turn at 190 deg/s; limit 180 (Zu 5)"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_of_up_keeps_further_steps_back() {
    // Power takes minutes; the replies, and that to the stop, come at once.
    let slow = Arm::real_time().without_power();
    let slow = slow.controller(|it| it.delays(Delays::REAL).habits(Habits::none()).time_scale(0.05)).start();
    let child = started_at(&slow, "up --yes --quiet");
    wait_until("power_on is sent", || changes(&slow).len() == 1);
    interrupt(&child);
    let run = result(child);
    let text = "note: interrupted: no further step is sent\n\
                note: the arm is at rest\n\
                error: interrupted; accepted before: power_on; not sent: enable_robot\n\
                hint: look at the arm before it moves again\n\
                exit code 4\n";
    assert_eq!(without_late_answer(&run), text);
    assert_eq!(changes(&slow), [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"stop_program"}"#]);
}

#[test]
fn each_asks_but_stop() {
    let controller = Arm::real_time().start();
    let moves = ["move --joints 0,90,90,90,-90,0 --speed 10", "jog 6 5 --speed 5"];
    for line in ["up", "down", "clear"].into_iter().chain(moves) {
        let run = run(&controller, line);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{run:?}");
        assert!(run.err.contains("not sent") && run.err.contains("--yes"), "{run:?}");
    }
    assert!(controller.requests().is_empty());
    expect![[r"
        error: `power_on` and `enable_robot` were not sent: there is no terminal to ask on; use --yes to send them anyway
        exit code 2
    "]]
    .assert_eq(&run(&controller, "up").text());
    expect![[r"
        the controller accepted the stop (`stop_program`)
        the arm is at rest
        exit code 0
    "]]
    .assert_eq(&without_late_answer(&run(&controller, "stop")));
    assert_eq!(controller.requests()[0], r#"{"cmdName":"stop_program"}"#);
    assert_eq!(changes(&controller).len(), 1);
}

#[test]
fn clear_leaves_a_protective_stop() {
    let controller = Arm::real_time().start();
    controller.collide();
    expect![[r"
        the robot is not in a protective stop
        exit code 0
    "]]
    .assert_eq(&run(&controller, "clear --yes").text());
    assert!(!controller.state().protective_stop);
}

#[test]
fn move_goes_to_joints_and_poses() {
    let controller = Arm::real_time().start();
    let run_to = |line: &str| {
        let run = run(&controller, line);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
        run.out
    };
    let out = run_to("move --joints -5,90,90,90,-90,0 --speed 90 --yes");
    assert!(out.starts_with("the motion has reached its target, after "), "{out}");
    assert!((controller.state().joint_position.0[0] + 5.0).abs() < 0.1);
    let pose = controller.state().tcp_pose;
    let line = format!("move --pose {},{},{},{},{},{} ", pose.x, pose.y, pose.z + 10.0, pose.rx, pose.ry, pose.rz);
    let json: Value = serde_json::from_str(&run_to(&(line + "--speed 100 --yes --json"))).expect("JSON");
    assert_eq!(json["end"]["cause"], "reached");
    assert!((controller.state().tcp_pose.z - pose.z - 10.0).abs() < 0.5);
}

#[test]
fn jog_goes_by_an_increment() {
    let controller = Arm::real_time().start();
    let before = controller.state();
    for line in ["jog 6 -2.5 --speed 50 --yes", "jog z -10 --speed 100 --yes --model zu5"] {
        let run = run(&controller, line);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    }
    let after = controller.state();
    assert!((after.joint_position.0[5] - before.joint_position.0[5] + 2.5).abs() < 2.0);
    assert!((after.tcp_pose.z - before.tcp_pose.z + 10.0).abs() < 0.5);
}

#[test]
fn a_jog_of_a_joint_is_compared_with_limits_and_runs() {
    let limits = scratch("limits.toml");
    std::fs::write(&limits, "model = \"Zu 5\"\n[joints]\nacceleration_deg_s2 = [60, 60, 60, 60, 60, 50]\n")
        .expect("it can be written");
    let own = format!("--limits {}", limits.display());
    for (options, acceleration) in [("--model zu5", 72.0), (&own, 50.0), ("--model zu5 --acceleration 20", 20.0)] {
        let controller = Arm::real_time().start();
        let before = controller.state().joint_position.0[0];
        let run = run(&controller, &format!("jog 1 1 --speed 5 --yes {options}"));
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
        assert!((controller.state().joint_position.0[0] - before - 1.0).abs() < 0.05);
        let sent =
            changes(&controller).into_iter().find(|request| request.contains("joint_move")).expect("it was sent");
        let sent: Value = serde_json::from_str(&sent).expect("it is JSON");
        assert_eq!(sent["accel"], acceleration, "{options}: {sent}");
    }
    let controller = Arm::real_time().start();
    let beyond = run(&controller, "jog 1 1 --speed 5 --acceleration 300 --model zu5 --yes");
    assert_eq!(beyond.code, Some(20), "{beyond:?}");
    assert!(beyond.err.contains("joint 1 would accelerate by 300 deg/s²"), "{beyond:?}");
    assert!(changes(&controller).iter().all(|request| !request.contains("joint_move")));
}

#[test]
fn what_is_beyond_a_limit_is_not_sent() {
    let controller = Arm::real_time().start();
    let run = run(&controller, "move --joints 0,90,176,90,-90,0 --speed 10 --acceleration 50 --model zu5 --yes");
    assert_eq!(run.code, Some(20), "{run:?}");
    assert!(run.err.contains("joint 3 would be at 176 deg; limit 175 (Zu 5)"), "{run:?}");
    assert!(changes(&controller).iter().all(|request| !request.contains("joint_move")));
}

#[cfg(unix)]
#[test]
fn an_interrupt_stops_a_move_and_a_jog() {
    for line in ["move --joints 90,90,90,90,-90,0 --speed 1 --yes", "jog 1 90 --speed 1 --yes"] {
        let controller = Arm::real_time().start();
        let child = started_at(&controller, line);
        wait_for_motion(&controller);
        interrupt(&child);
        expect![[r"
            note: interrupted: the controller accepted the stop (`stop_program`)
            note: the arm is at rest
            error: the motion was stopped before its target
            hint: look at the arm before it moves again
            exit code 22
        "]]
        .assert_eq(&without_late_answer(&result(child)));
        assert!(controller.state().at_rest && controller.state().joint_position.0[0] < 60.0);
    }
}

#[test]
fn a_stop_that_is_not_taken_names_the_emergency_stop() {
    let controller = Arm::real_time().start();
    let refusal = r#"{"errorCode":"2","errorMsg":"call stop_program failed","cmdName":"stop_program"}"#;
    controller.inject_for("stop_program", Fault::Instead(refusal.into()));
    let refused = run(&controller, "stop");
    assert_eq!(refused.code, Some(29), "{refused:?}");
    let text = "error: the controller did not accept the stop; the arm may still move, use the emergency stop: ";
    assert!(refused.err.starts_with(text), "{refused:?}");
    controller.inject_for("stop_program", Fault::Drop);
    let unanswered = run(&controller, "stop --timeout 0.2");
    assert_eq!(unanswered.code, Some(29), "{unanswered:?}");
    let text = "error: it is not known whether the controller accepted the stop; the arm may still move, use the emergency stop: ";
    assert!(unanswered.err.starts_with(text), "{unanswered:?}");
}

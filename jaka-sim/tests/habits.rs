//! Habits of real controllers that no document describes, one by one, on a clock that the test moves on.

use std::time::Duration;

use crate::common::{LIMIT, Peer, assert_accepted, enabled, json, request};
use jaka_sim::{Controller, Delays, Firmware, Habit, Habits, State};

const CYCLE: Duration = Duration::from_millis(8);
const PAUSE: Duration = Duration::from_millis(100);

/// A controller with these habits whose arm is enabled, and a client.
fn with(habits: impl Into<Habits>) -> (Controller, Peer) {
    let builder = Controller::builder().delays(Delays::NONE).stepped_clock().firmware(Firmware::Newer);
    let controller = enabled(builder.habits(habits).status_period(Duration::MAX));
    let peer = Peer::commands(&controller);
    (controller, peer)
}

fn turn(degrees: f64, speed: f64) -> String {
    format!(
        r#"{{"cmdName":"joint_move","relFlag":1,"jointPosition":[{degrees},0,0,0,0,0],"speed":{speed},"accel":200}}"#
    )
}

fn shift(by: [f64; 3], tolerance: f64) -> String {
    let [x, y, z] = by;
    format!(
        r#"{{"cmdName":"moveL","relFlag":1,"cartPosition":[{x},{y},{z},0,0,0],"speed":100,"accel":500,"tol":{tolerance}}}"#
    )
}

/// The states of each cycle until the arm is at rest, without the first.
fn until_rest(controller: &Controller) -> Vec<State> {
    let step = || {
        controller.advance(CYCLE);
        controller.state()
    };
    let mut states = vec![step()];
    while !states.last().is_some_and(|state| state.at_rest) {
        assert!(states.len() < 10_000, "the arm comes to rest");
        states.push(step());
    }
    states
}

fn first_joint(state: &State) -> f64 {
    state.joint_position.0[0]
}

fn distance(state: &State, place: [f64; 3]) -> f64 {
    let pose = <[f64; 6]>::from(state.tcp_pose);
    (0..3).map(|i| (pose[i] - place[i]).powi(2)).sum::<f64>().sqrt()
}

fn place(state: &State) -> [f64; 3] {
    let pose = <[f64; 6]>::from(state.tcp_pose);
    [pose[0], pose[1], pose[2]]
}

#[test]
fn no_habit_is_on_unless_asked_for() {
    let (controller, mut peer) = with(Habits::none());
    for degrees in [10.0, 10.0] {
        assert_accepted(&peer.ask(&turn(degrees, 50.0)), "joint_move");
    }
    let states = until_rest(&controller);
    let (last, moving) = states.split_last().expect("there are states");
    assert!(moving.iter().all(|state| !state.in_position));
    assert!(last.in_position);
    assert!(states.iter().all(|state| state.joint_commanded_position == state.joint_position));
    assert!(states.iter().all(|state| state.error_code == "0x0"));
}

#[test]
fn the_arm_is_in_position_between_two_motions() {
    let (controller, mut peer) = with(Habit::Pause(PAUSE));
    for degrees in [10.0, 10.0, -20.0] {
        assert_accepted(&peer.ask(&turn(degrees, 50.0)), "joint_move");
    }
    let states = until_rest(&controller);
    let (last, moving) = states.split_last().expect("there are states");
    assert!(last.in_position && first_joint(last).abs() < 1e-9);
    for target in [10.0, 20.0] {
        let resting = moving.iter().filter(|state| state.in_position && (first_joint(state) - target).abs() < 1e-9);
        // 13 cycles, and the one that came there.
        let count = u32::try_from(resting.count()).expect("there are few");
        assert!((PAUSE..PAUSE + 3 * CYCLE).contains(&(CYCLE * count)), "{target}: {count}");
    }
    assert!(moving.iter().all(|state| !state.at_rest));
}

#[test]
fn a_stop_ends_the_pause() {
    let (controller, mut peer) = with(Habit::Pause(Duration::from_secs(3600)));
    for degrees in [10.0, 10.0] {
        assert_accepted(&peer.ask(&turn(degrees, 50.0)), "joint_move");
    }
    controller.advance(Duration::from_secs(10));
    let state = controller.state();
    assert!(state.in_position && !state.at_rest && (first_joint(&state) - 10.0).abs() < 1e-9);
    assert_accepted(&peer.call("stop_program"), "stop_program");
    assert!(controller.state().at_rest);
    assert_accepted(&peer.ask(&turn(5.0, 50.0)), "joint_move");
    assert!((first_joint(until_rest(&controller).last().expect("there are states")) - 15.0).abs() < 1e-9);
}

#[test]
fn commanded_positions_lead_while_the_arm_moves() {
    let (controller, mut peer) = with(Habit::Lead(2 * CYCLE));
    let mut reader = Peer::status(&controller);
    reader.receive();
    assert_accepted(&peer.ask(&turn(10.0, 5.0)), "joint_move");
    controller.advance(Duration::from_secs(1));
    let state = controller.state();
    let ahead = state.joint_commanded_position.0[0] - first_joint(&state);
    assert!((ahead - 0.08).abs() < 1e-6, "{ahead}");
    // The actual ones of packets do not.
    let reply = peer.call("get_joint_pos");
    let told = reply["joint_pos"][0].to_string().parse::<f64>().expect("it is a number");
    assert!((told - state.joint_commanded_position.0[0]).abs() < 1e-5, "{told}");
    controller.publish();
    let packet = json(&reader.receive());
    let shown = |key: &str| packet[key][0].to_string().parse::<f64>().expect("it is a number");
    assert!((shown("joint_position") - shown("joint_actual_position") - 0.08).abs() < 1e-4);
    assert_ne!(packet["position"], packet["actual_position"]);
    let reply = peer.call("get_tcp_pos");
    assert_ne!(reply["tcp_pos"], packet["actual_position"]);

    for state in until_rest(&controller) {
        let ahead = state.joint_commanded_position.0[0] - first_joint(&state);
        assert!((0.0..=0.08 + 1e-6).contains(&ahead), "{ahead}");
        assert!(!state.at_rest || state.joint_commanded_position == state.joint_position);
        assert!(!state.at_rest || state.tcp_commanded_pose == state.tcp_pose);
    }
}

/// Asserts that no reply comes yet. The controller has had its chance to send one.
fn assert_silent(controller: &Controller, peer: &Peer) {
    // This waits for a thread that is about to send a reply.
    controller.release();
    assert!(!peer.has_something());
}

#[test]
fn queries_are_answered_when_the_arm_is_at_rest() {
    let (controller, mut peer) = with(Habit::LateQueries(None));
    assert_accepted(&peer.call("get_joint_pos"), "get_joint_pos");
    assert_accepted(&peer.ask(&turn(10.0, 10.0)), "joint_move");
    controller.advance(Duration::from_millis(500));
    peer.send(request("get_joint_pos") + &request("is_in_servomove"));
    assert!(controller.wait_for_requests(4, LIMIT));
    assert_silent(&controller, &peer);
    // A request that is not a query is carried out immediately, and answered afterwards.
    peer.send(request("stop_program"));
    assert!(controller.wait_for_requests(5, LIMIT));
    assert_silent(&controller, &peer);
    let last = until_rest(&controller).pop().expect("there are states");
    assert!((1.0..9.0).contains(&first_joint(&last)), "{}", first_joint(&last));
    let reply = json(&peer.receive());
    assert_accepted(&reply, "get_joint_pos");
    // It says what was so then.
    let then = reply["joint_pos"][0].to_string().parse::<f64>().expect("it is a number");
    assert!(then < first_joint(&last), "{then}");
    assert_accepted(&json(&peer.receive()), "is_in_servomove");
    assert_accepted(&json(&peer.receive()), "stop_program");
}

#[test]
fn queries_may_be_answered_so_much_later() {
    let (controller, mut peer) = with(Habit::LateQueries(Some(Duration::from_secs(2))));
    assert_accepted(&peer.ask(&turn(100.0, 10.0)), "joint_move");
    controller.advance(Duration::from_millis(400));
    peer.send(request("get_joint_pos"));
    assert!(controller.wait_for_requests(2, LIMIT));
    controller.advance(Duration::from_millis(1600));
    assert_silent(&controller, &peer);
    controller.advance(Duration::from_millis(800));
    assert_accepted(&json(&peer.receive()), "get_joint_pos");
    assert!(!controller.state().at_rest);
}

#[test]
fn a_tolerance_rounds_the_corner() {
    for (habits, is_rounded) in [(Habits::none(), false), (Habit::Blend.into(), true)] {
        let (controller, mut peer) = with(habits);
        let start = place(&controller.state());
        let corner = [start[0], start[1], start[2] - 60.0];
        let end = [start[0] - 60.0, start[1], start[2] - 60.0];
        assert_accepted(&peer.ask(&shift([0.0, 0.0, -60.0], 10.0)), "moveL");
        assert_accepted(&peer.ask(&shift([-60.0, 0.0, 0.0], 10.0)), "moveL");
        let before = controller.state();
        let states = until_rest(&controller);
        let nearest = states.iter().map(|state| distance(state, corner)).fold(f64::INFINITY, f64::min);
        assert_eq!((0.5..10.0).contains(&nearest), is_rounded, "{nearest}");
        assert_eq!(nearest < 1e-6, !is_rounded, "{nearest}");
        let last = states.last().expect("there are states");
        assert!(distance(last, end) < 1e-6);
        // No faster than both together.
        let fastest = std::iter::once(&before).chain(&states).zip(&states);
        let fastest = fastest.map(|(a, b)| distance(b, place(a)) / CYCLE.as_secs_f64()).fold(0.0, f64::max);
        assert!(fastest <= 200.0, "{fastest}");
        let moving = &states[..states.len() - 1];
        assert!(moving.iter().all(|state| !state.in_position));
        assert!(states.iter().all(|state| state.tcp_speed < 200.0));
    }
}

#[test]
fn a_motion_without_a_tolerance_or_a_successor_reaches_its_end() {
    let (controller, mut peer) = with([Habit::Blend, Habit::Pause(PAUSE)]);
    let start = place(&controller.state());
    let corners = [[start[0], start[1], start[2] - 40.0], [start[0] - 40.0, start[1], start[2] - 40.0]];
    assert_accepted(&peer.ask(&shift([0.0, 0.0, -40.0], 0.0)), "moveL");
    assert_accepted(&peer.ask(&shift([-40.0, 0.0, 0.0], 10.0)), "moveL");
    let states = until_rest(&controller);
    for corner in corners {
        let nearest = states.iter().map(|state| distance(state, corner)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{corner:?}: {nearest}");
    }
}

#[test]
fn there_and_back_turns_before_the_end() {
    let (controller, mut peer) = with(Habit::Blend);
    let start = place(&controller.state());
    let end = [start[0], start[1], start[2] - 60.0];
    assert_accepted(&peer.ask(&shift([0.0, 0.0, -60.0], 10.0)), "moveL");
    assert_accepted(&peer.ask(&shift([0.0, 0.0, 60.0], 10.0)), "moveL");
    let states = until_rest(&controller);
    let lowest = states.iter().map(|state| place(state)[2]).fold(f64::INFINITY, f64::min);
    assert!(lowest > end[2] + 0.1, "{lowest} of {}", end[2]);
    assert!(distance(states.last().expect("there are states"), start) < 1e-6);
}

#[test]
fn a_stop_in_the_corner_brakes_and_the_next_motion_begins_there() {
    let (controller, mut peer) = with(Habit::Blend);
    let start = place(&controller.state());
    let corner = [start[0], start[1], start[2] - 60.0];
    assert_accepted(&peer.ask(&shift([0.0, 0.0, -60.0], 10.0)), "moveL");
    assert_accepted(&peer.ask(&shift([-60.0, 0.0, 0.0], 10.0)), "moveL");
    let mut before = controller.state();
    while distance(&before, corner) > 9.0 {
        controller.advance(CYCLE);
        before = controller.state();
    }
    assert_accepted(&peer.call("stop_program"), "stop_program");
    assert_accepted(&peer.ask(&shift([0.0, 0.0, 10.0], 0.0)), "moveL");
    for state in until_rest(&controller) {
        let step = distance(&state, place(&before));
        assert!(step < 200.0 * CYCLE.as_secs_f64(), "{step} mm in a cycle");
        before = state;
    }
}

/// A controller of a firmware as it starts, and a client.
fn real(firmware: Firmware) -> (Controller, Peer) {
    let builder = Controller::builder().stepped_clock().status_period(Duration::MAX);
    let controller = builder.firmware(firmware).start().expect("loopback has ports");
    let peer = Peer::commands(&controller);
    (controller, peer)
}

#[test]
fn power_and_enabling_are_answered_when_the_state_is_there_or_at_once() {
    for (firmware, is_late) in [(Firmware::V1_5_14, true), (Firmware::Newer, false), (Firmware::Document, false)] {
        let (controller, mut peer) = real(firmware);
        for (command, time, count) in [("power_on", 8000, 1), ("enable_robot", 3500, 3)] {
            let is_there = || match command {
                "power_on" => controller.state().powered,
                _ => controller.state().enabled,
            };
            peer.send(request(command));
            // What comes after it waits for its turn, and says what was so when it was asked.
            peer.send(request("get_robot_state"));
            assert!(controller.wait_for_requests(count + 1, LIMIT));
            if !is_late {
                assert_accepted(&json(&peer.receive()), command);
                assert_accepted(&json(&peer.receive()), "get_robot_state");
            }
            controller.advance(Duration::from_millis(time - 8));
            assert!(!is_there(), "{firmware}: {command}");
            if is_late {
                assert_silent(&controller, &peer);
            }
            controller.advance(CYCLE * 2);
            assert!(is_there(), "{firmware}: {command}");
            if is_late {
                assert_accepted(&json(&peer.receive()), command);
                assert_accepted(&json(&peer.receive()), "get_robot_state");
            }
        }
        // There already: at once.
        for command in ["power_on", "enable_robot"] {
            assert_accepted(&peer.call(command), command);
        }
    }
}

#[test]
fn a_reply_that_waits_for_power_is_sent_when_power_is_given_up() {
    let (controller, mut peer) = real(Firmware::V1_5_14);
    peer.send(request("power_on"));
    peer.send(request("power_off"));
    assert_accepted(&json(&peer.receive()), "power_on");
    assert_accepted(&json(&peer.receive()), "power_off");
    assert!(!controller.state().powered);
}

#[test]
fn a_habit_of_the_firmware_can_be_left_out() {
    let events = |habits: Habits| {
        let builder = Controller::builder().delays(Delays::NONE).stepped_clock().habits(habits);
        enabled(builder).state().error_code
    };
    let usual = Firmware::V1_5_14.habits();
    assert_eq!(usual, Habits::from([Habit::LatePower, Habit::ServoAtRest, Habit::DisableMoving, Habit::Events]));
    assert_eq!(Firmware::Newer.habits(), Habits::from([Habit::ServoAtRest, Habit::Events]));
    assert_eq!(events(usual), "0x10f0004");
    assert_eq!(events(usual.iter().filter(|habit| *habit != Habit::Events).collect()), "0x0");
}

#[test]
fn a_protective_stop_is_information_and_a_collision_is_an_error() {
    let (controller, mut peer) = with(Habit::Events);
    controller.set_state(|state| state.protective_stop = true);
    assert_eq!(controller.state().error_code, "0x10f000b");
    assert_accepted(&peer.call("clear_error"), "clear_error");
    assert_eq!(controller.state().error_code, "0x0");
    controller.collide();
    assert_eq!(controller.state().error_code, "0xf0034");
}

/// Firmware 1.5.14 acknowledged it in two transcripts; the vendor's table of events refuses it.
#[test]
fn disabling_a_moving_arm_is_acknowledged_or_refused() {
    let (controller, mut peer) = with(Habit::DisableMoving);
    assert_accepted(&peer.ask(&turn(10.0, 50.0)), "joint_move");
    controller.advance(CYCLE * 10);
    assert_accepted(&peer.call("disable_robot"), "disable_robot");
    let state = until_rest(&controller).pop().expect("there are states");
    assert!(!state.enabled && first_joint(&state) < 9.0, "{state:?}");
    let (controller, mut peer) = with(Habit::Events);
    assert_accepted(&peer.ask(&turn(10.0, 50.0)), "joint_move");
    controller.advance(CYCLE * 10);
    assert_eq!(peer.call("disable_robot")["errorCode"], "2");
}

#[test]
fn servo_mode_is_not_entered_while_the_arm_moves() {
    let (controller, mut peer) = with(Habit::ServoAtRest);
    let set_point = r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[0.1,0,0,0,0,0]}"#;
    let enter = r#"{"cmdName":"servo_move","relFlag":1}"#;
    assert_accepted(&peer.ask(&turn(10.0, 50.0)), "joint_move");
    controller.advance(CYCLE * 10);
    assert_accepted(&peer.ask(enter), "servo_move");
    assert!(!controller.state().servo_mode);
    assert_eq!(peer.call("is_in_servomove")["in_servomove"], json("false"));
    let refused = peer.ask(set_point);
    assert_eq!((&refused["errorCode"], &refused["cmdName"]), (&"-1".into(), &"servo_j".into()));
    let last = until_rest(&controller).pop().expect("there are states");
    assert!((first_joint(&last) - 10.0).abs() < 1e-9);
    // Nor later, unless it is asked for at rest.
    assert!(!last.servo_mode);
    assert_accepted(&peer.ask(enter), "servo_move");
    assert!(controller.state().servo_mode);
    assert_accepted(&peer.ask(set_point), "servo_j");
    // It is left at any time.
    assert_accepted(&peer.ask(r#"{"cmdName":"servo_move","relFlag":0}"#), "servo_move");
    assert!(!controller.state().servo_mode);
}

#[test]
fn information_is_put_into_the_error_code() {
    let (controller, mut peer) = with(Habit::Events);
    let mut reader = Peer::status(&controller);
    reader.receive();
    let mut shown = || {
        controller.publish();
        let packet = json(&reader.receive());
        assert!(packet["errcode"] == *"0x0" || packet["errmsg"] != *"", "{packet}");
        packet["errcode"].as_str().map(str::to_owned)
    };
    let code = |text: &str| Some(text.to_owned());
    assert_eq!(shown(), code("0x10f0004"));
    let steps = [
        (r#"{"cmdName":"servo_move","relFlag":1}"#, "0x10f0015"),
        (r#"{"cmdName":"get_version"}"#, "0x10f0015"),
        (r#"{"cmdName":"servo_move","relFlag":0}"#, "0x10f0016"),
        (r#"{"cmdName":"clear_error"}"#, "0x0"),
        (r#"{"cmdName":"load_program","programName":"test.jks"}"#, "0x0"),
        (r#"{"cmdName":"play_program"}"#, "0x10f001b"),
        (r#"{"cmdName":"stop_program"}"#, "0x10f001b"),
        (r#"{"cmdName":"clear_error"}"#, "0x0"),
        (r#"{"cmdName":"play_program"}"#, "0x10f001b"),
        (r#"{"cmdName":"stop_program"}"#, "0x10f001b"),
        (r#"{"cmdName":"disable_robot"}"#, "0x10f0005"),
        (r#"{"cmdName":"enable_robot"}"#, "0x10f0004"),
    ];
    for (request, expected) in steps {
        assert_eq!(peer.ask(request)["errorCode"], *"0", "{request}");
        assert_eq!(shown(), code(expected), "{request}");
    }
}

#[test]
fn information_leaves_the_error_code_and_errors_stay() {
    let (controller, mut peer) = with(Habit::Events);
    let code = || controller.state().error_code;
    assert_accepted(&peer.ask(r#"{"cmdName":"servo_move","relFlag":1}"#), "servo_move");
    controller.advance(Duration::from_millis(248));
    assert_eq!(code(), "0x10f0015");
    controller.advance(CYCLE);
    assert_eq!((code().as_str(), controller.state().error_message.as_str()), ("0x0", ""));
    assert_accepted(&peer.ask(r#"{"cmdName":"servo_move","relFlag":0}"#), "servo_move");
    controller.collide();
    controller.advance(Duration::from_secs(1));
    assert_eq!(code(), "0xf0034");
}

#[test]
fn each_start_of_a_program_is_an_event_also_when_the_one_before_has_ended_by_itself() {
    let (controller, mut peer) = with(Habit::Events);
    for _ in 0..2 {
        assert_accepted(&peer.call("play_program"), "play_program");
        assert_eq!(controller.state().error_code, "0x10f001b");
        until_rest(&controller);
        assert_accepted(&peer.call("clear_error"), "clear_error");
        assert_eq!(controller.state().error_code, "0x0");
    }
}

#[test]
fn an_error_is_not_replaced_by_information() {
    let (controller, mut peer) = with(Habit::Events);
    assert_accepted(&peer.ask(r#"{"cmdName":"servo_move","relFlag":1}"#), "servo_move");
    controller.collide();
    let state = controller.state();
    // Servo mode ends with it.
    assert!(!state.servo_mode);
    assert_eq!((&*state.error_code, &*state.error_message), ("0xf0034", "a collision was detected"));
    assert_accepted(&peer.call("disable_robot"), "disable_robot");
    assert_eq!(controller.state().error_code, "0xf0034");
}

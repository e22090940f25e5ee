//! The arm in servo mode: how it lags, what makes its drives stop it, and what it does when set-points stop and at a
//! stop.

use std::time::Duration;

use crate::common::servo::{Arm, CYCLE, actual, builder, commanded, greatest, ramp, set_point};
use crate::common::{Peer, assert_accepted, enabled, json};
use jaka_proto::wire::Value;
use jaka_sim::{State, StopInServo, Trip, Underrun};

const LAG: Duration = Duration::from_millis(20);

#[test]
fn the_arm_lags_by_its_speed_and_settles_without_overshoot() {
    let mut arm = Arm::new(builder().lag(LAG));
    let mut reader = Peer::status(&arm.controller);
    reader.receive();
    let states = arm.follow(ramp(50.0, 100));
    let last = states.last().expect("there are states");
    // 50 deg/s times 20 ms.
    assert!((commanded(last) - 40.0).abs() < 1e-9 && (actual(last) - 39.0).abs() < 1e-6, "{last:?}");
    assert_ne!(last.tcp_pose, last.tcp_commanded_pose);
    let reply = arm.peer.call("get_joint_pos");
    arm.controller.publish();
    let packet = json(&reader.receive());
    let number = |value: &Value| value.to_string().parse::<f64>().expect("it is a number");
    assert!((number(&reply["joint_pos"][0]) - 40.0).abs() < 1e-4, "{reply}");
    assert!((number(&packet["joint_position"][0]) - 40.0).abs() < 1e-4);
    assert!((number(&packet["joint_actual_position"][0]) - 39.0).abs() < 1e-4);
    assert_ne!(packet["position"], packet["actual_position"]);

    // No set-point is left, and the arm still moves.
    assert!(!last.at_rest && !last.in_position);
    let states = arm.until_rest();
    let places: Vec<_> = states.iter().map(actual).collect();
    assert!(places.len() > 20 && places.is_sorted() && places.iter().all(|place| *place <= 40.0), "{places:?}");
    let (last, moving) = states.split_last().expect("there are states");
    assert!(moving.iter().all(|state| !state.in_position && state.tcp_speed > 0.0));
    assert!(last.in_position && (actual(last) - 40.0).abs() < 1e-6);
    let last = arm.step();
    assert_eq!((last.joint_position, last.tcp_pose), (last.joint_commanded_position, last.tcp_commanded_pose));
}

#[test]
fn planned_motion_lags_too_and_is_at_rest_when_the_arm_is() {
    let mut arm = Arm::new(builder().lag(LAG));
    assert_accepted(&arm.peer.ask(r#"{"cmdName":"servo_move","relFlag":0}"#), "servo_move");
    let turn = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[10,0,0,0,0,0],"speed":50,"accel":200}"#;
    assert_accepted(&arm.peer.ask(turn), "joint_move");
    let states = arm.until_rest();
    let places: Vec<_> = states.iter().map(actual).collect();
    assert!(places.is_sorted() && (places.last().expect("there are places") - 10.0).abs() < 1e-5, "{places:?}");
    let arrived = states.iter().filter(|state| (commanded(state) - 10.0).abs() < 1e-9 && !state.at_rest).count();
    assert!(arrived > 5, "{arrived}");
}

#[test]
fn a_state_that_is_set_is_where_the_arm_is() {
    let arm = Arm::new(builder().lag(LAG));
    arm.controller.set_state(|state| state.joint_position.0[0] = 30.0);
    let state = arm.step();
    assert_eq!((state.joint_position, state.at_rest), (state.joint_commanded_position, true));
    assert!((actual(&state) - 30.0).abs() < 1e-9);
}

/// Asserts that the drives have stopped the arm, and that it can go on when the error is cleared.
fn assert_tripped(arm: &mut Arm, code: &str) {
    let state = arm.controller.state();
    assert_eq!((&*state.error_code, state.servo_mode, state.at_rest), (code, false, true));
    assert_eq!(state.joint_position, state.joint_commanded_position);
    arm.controller.publish();
    assert_eq!(json(&Peer::status(&arm.controller).receive())["errcode"], code);
    let next = set_point(actual(&state));
    let refused = arm.peer.ask(&next);
    assert_eq!(refused["errorCode"], "-1", "{refused}");
    let later = arm.step();
    assert_eq!(later.joint_position, state.joint_position);
    assert_accepted(&arm.peer.call("clear_error"), "clear_error");
    assert_eq!(arm.controller.state().error_code, "0x0");
    arm.enter();
    assert_accepted(&arm.peer.ask(&next), "servo_j");
}

/// Sends places until the drives stop the arm; false if they do not.
fn trips(arm: &mut Arm, places: impl IntoIterator<Item = f64>) -> bool {
    places.into_iter().any(|place| {
        arm.send(place);
        !arm.step().servo_mode
    })
}

#[test]
fn each_threshold_trips_when_it_is_passed_and_only_then() {
    // What passes and what trips at a speed of the ramp, in deg/s, and the event.
    let table = [
        (Trip::Deviation(0.5), 24.0, 26.0, "0x108611"),
        (Trip::Speed(50.0), 49.9, 51.0, "0x108482"),
        // In the first cycle the arm has 17 % of the speed.
        (Trip::SpeedDeviation(30.0), 35.0, 38.0, "0x108485"),
        (Trip::CommandSpeed(100.0), 100.0, 101.0, "0x108612"),
        // One that would have no effect otherwise.
        (Trip::CommandSpeed(100.0), 100.0, 200.0, "0x108612"),
        (Trip::CommandAcceleration(2000.0), 16.0, 16.1, "0x108613"),
    ];
    for (trip, passes, too_fast, code) in table {
        let builder = builder().lag(LAG).trips([trip]);
        let mut arm = Arm::new(builder.clone());
        assert!(!trips(&mut arm, ramp(passes, 100)), "{trip} at {passes}");
        arm.until_rest();
        assert_eq!(arm.controller.state().error_code, "0x0", "{trip} at {passes}");
        let mut arm = Arm::new(builder);
        assert!(trips(&mut arm, ramp(too_fast, 100)), "{trip} at {too_fast}");
        assert_tripped(&mut arm, code);
    }
}

#[test]
fn without_thresholds_nothing_trips() {
    let mut arm = Arm::new(builder().lag(Duration::from_millis(200)));
    assert!(!trips(&mut arm, ramp(180.0, 50)));
    // Deviation by 180 deg/s times 200 ms.
    assert!(greatest(&arm.until_rest().iter().map(actual).collect::<Vec<_>>())[0] > 100.0);
}

#[test]
fn the_event_names_the_joint() {
    let mut arm = Arm::new(builder().trips([Trip::CommandSpeed(10.0)]));
    let request = r#"{"cmdName":"servo_j","relFlag":1,"jointPosition":[0.01,0,0,0,0,0.1],"stepNum":1}"#;
    assert_accepted(&arm.peer.ask(request), "servo_j");
    arm.step();
    assert_tripped(&mut arm, "0x158612");
}

#[test]
fn set_points_are_compared_by_index_each_over_its_nominal_period() {
    let builder = builder().trips([Trip::CommandAcceleration(2000.0)]);
    let mut arm = Arm::new(builder.clone());
    // 12 deg/s more each time, which is 1500 deg/s².
    let (mut place, mut speed) = (0.0, 0.0);
    for n in 0..10 {
        speed += 12.0;
        place += speed * CYCLE.as_secs_f64();
        arm.send(place);
        // Some come late, some together.
        arm.controller.advance(CYCLE * (n % 3 * 2));
    }
    arm.until_rest();
    assert_eq!(arm.controller.state().error_code, "0x0");
    // After a time in which no set-point came, the next one starts from rest.
    arm.controller.advance(Duration::from_millis(104));
    assert!(trips(&mut arm, [place + speed * CYCLE.as_secs_f64()]));
    assert_tripped(&mut arm, "0x108613");

    // The same step in twice the time is a quarter of the acceleration.
    let mut arm = Arm::new(builder.clone());
    let request = set_point(0.25).replace(r#""stepNum":1"#, r#""stepNum":2"#);
    assert_accepted(&arm.peer.ask(&request), "servo_j");
    arm.until_rest();
    assert_eq!(arm.controller.state().error_code, "0x0");
    assert!(trips(&mut Arm::new(builder), [0.25]));
}

/// The states after set-points at 50 deg/s for 40 deg, and after these, have stopped.
fn stopped(underrun: Underrun, places: &[f64]) -> (Arm, Vec<State>) {
    let mut arm = Arm::new(builder().underrun(underrun));
    arm.follow(ramp(50.0, 100).chain(places.iter().copied()));
    let states = (0..100).map(|_| arm.step()).collect();
    (arm, states)
}

#[test]
fn held_the_arm_stays_at_the_last_set_point() {
    let (arm, states) = stopped(Underrun::Hold, &[]);
    assert!(states.iter().all(|state| (actual(state) - 40.0).abs() < 1e-9 && state.at_rest && state.servo_mode));
    assert_eq!(arm.controller.state().error_code, "0x0");
}

#[test]
fn a_fault_comes_when_no_set_point_has_come_for_so_long() {
    let (mut arm, states) = stopped(Underrun::Fault(CYCLE * 5), &[]);
    assert!(states.iter().all(|state| (actual(state) - 40.0).abs() < 1e-9));
    assert_eq!(states.iter().position(|state| !state.servo_mode), Some(4));
    assert_tripped(&mut arm, "0x108614");

    // A late one is in time.
    let mut arm = Arm::new(builder().underrun(Underrun::Fault(CYCLE * 5)));
    for place in ramp(50.0, 10) {
        arm.send(place);
        arm.controller.advance(CYCLE * 5);
    }
    assert!(arm.controller.state().servo_mode);
    arm.step();
    assert_tripped(&mut arm, "0x108614");
}

#[test]
fn an_arm_that_runs_out_brakes() {
    let (mut arm, states) = stopped(Underrun::RunOut(500.0), &[]);
    let places: Vec<_> = [vec![40.0], states.iter().map(actual).collect()].concat();
    let [speed, ..] = greatest(&places);
    assert!((45.0..=46.0 + 1e-6).contains(&speed), "{speed}");
    let speeds: Vec<_> = places.windows(2).map(|pair| (pair[1] - pair[0]) / CYCLE.as_secs_f64()).collect();
    for pair in speeds.windows(2) {
        assert!((pair[0] - pair[1] - 4.0).abs() < 1e-6 || pair[1].abs() < 1e-6, "{pair:?}");
    }
    // 50 deg/s at 500 deg/s² are 2.5 deg; each cycle moves by the speed at its end.
    let last = states.last().expect("there are states");
    assert!((actual(last) - 42.5).abs() < 0.25, "{}", actual(last));
    assert!(last.at_rest && last.servo_mode && last.error_code == "0x0");
    // The next set-point is followed from there.
    arm.send(actual(last) + 0.1);
    assert!((actual(&arm.step()) - actual(last) - 0.1).abs() < 1e-9);
}

#[test]
fn the_joints_of_an_arm_that_runs_out_stay_within_their_ranges() {
    let mut arm = Arm::new(builder().underrun(Underrun::RunOut(1.0)));
    arm.controller.set_state(|state| state.joint_position.0[0] = 300.0);
    arm.follow(ramp(100.0, 20).map(|place| 300.0 + place));
    let states = arm.until_rest();
    let last = actual(states.last().expect("there are states"));
    assert!((359.0..=360.0).contains(&last), "{last}");
}

#[test]
fn nothing_follows_set_points_that_come_to_rest() {
    for underrun in [Underrun::Hold, Underrun::Fault(Duration::ZERO), Underrun::RunOut(500.0)] {
        let (arm, states) = stopped(underrun, &[40.0]);
        assert!(states.iter().all(|state| (actual(state) - 40.0).abs() < 1e-9 && state.at_rest), "{underrun}");
        assert!(arm.controller.state().servo_mode, "{underrun}");
    }
}

#[test]
fn a_stop_and_a_collision_end_what_is_left() {
    for (underrun, collides) in [(Underrun::RunOut(10.0), true), (Underrun::RunOut(10.0), false)] {
        let (mut arm, _) = stopped(underrun, &[]);
        assert!(!arm.controller.state().at_rest);
        if collides {
            arm.controller.collide();
        } else {
            assert_accepted(&arm.peer.call("stop_program"), "stop_program");
        }
        let state = arm.controller.state();
        assert!(state.at_rest && state.servo_mode != collides);
        assert_eq!(arm.step().joint_position, state.joint_position);
    }
}

/// The arm at 50 deg/s at 40 deg, with set-points up to 41.2 deg waiting, and then a stop.
fn stopped_by_command(reaction: StopInServo) -> Arm {
    let mut arm = Arm::new(builder().stop_in_servo(reaction));
    arm.follow(ramp(50.0, 100));
    ramp(50.0, 103).skip(100).for_each(|place| arm.send(place));
    assert_accepted(&arm.peer.call("stop_program"), "stop_program");
    arm
}

/// Asserts that set-points are refused as outside servo mode, and followed once it is entered again.
fn assert_outside_servo_mode(arm: &mut Arm) {
    let state = arm.controller.state();
    assert!(!state.servo_mode && state.at_rest, "{state:?}");
    let refused = arm.peer.ask(&set_point(actual(&state)));
    assert_eq!(refused["errorCode"], "-1", "{refused}");
    assert_eq!(arm.step().joint_position, state.joint_position);
    arm.enter();
    assert_follows(arm, actual(&state));
}

fn assert_follows(arm: &mut Arm, from: f64) {
    arm.send(from + 0.2);
    assert!((actual(&arm.step()) - from - 0.2).abs() < 1e-9);
}

#[test]
fn a_stop_discards_the_waiting_set_points() {
    let mut arm = stopped_by_command(StopInServo::Discard);
    let states: Vec<_> = (0..10).map(|_| arm.step()).collect();
    assert!(states.iter().all(|state| (actual(state) - 40.0).abs() < 1e-9 && state.at_rest && state.servo_mode));
    assert_eq!(states[9].error_code, "0x0");
    assert_follows(&mut arm, 40.0);
}

#[test]
fn a_stop_that_is_ignored_changes_nothing() {
    let mut arm = stopped_by_command(StopInServo::Ignore);
    let places: Vec<_> = (0..5).map(|_| actual(&arm.step())).collect();
    let wanted = [40.4, 40.8, 41.2, 41.2, 41.2];
    assert!(places.iter().zip(wanted).all(|(place, wanted)| (place - wanted).abs() < 1e-9), "{places:?}");
    let state = arm.controller.state();
    assert!(state.servo_mode && state.error_code == "0x0", "{state:?}");
    assert_follows(&mut arm, 41.2);
}

#[test]
fn a_stop_that_leaves_servo_mode_brakes() {
    let mut arm = stopped_by_command(StopInServo::Leave);
    let refused = arm.peer.ask(&set_point(40.4));
    assert_eq!(refused["errorCode"], "-1", "{refused}");
    let places: Vec<_> = [vec![40.0], arm.until_rest().iter().map(actual).collect()].concat();
    let speeds: Vec<_> = places.windows(2).map(|pair| (pair[1] - pair[0]) / CYCLE.as_secs_f64()).collect();
    // 180 deg/s² are 1.44 deg/s in a cycle.
    assert!(speeds[0] < 50.0 && speeds[0] > 48.5, "{speeds:?}");
    assert!(speeds.windows(2).all(|pair| pair[1] <= pair[0] && pair[0] - pair[1] < 1.45), "{speeds:?}");
    let way = places.last().expect("there are places") - 40.0;
    assert!((way - 50.0 * 50.0 / 2.0 / 180.0).abs() < 1e-9, "{way}");
    assert_eq!(arm.controller.state().error_code, "0x0");
    assert_outside_servo_mode(&mut arm);

    // Not beyond the end of a joint's range.
    let mut arm = Arm::new(builder().stop_in_servo(StopInServo::Leave));
    arm.controller.set_state(|state| state.joint_position.0[0] = 300.0);
    let last = arm.follow(ramp(100.0, 70).map(|place| 300.0 + place)).pop().expect("there are states");
    assert_accepted(&arm.peer.call("stop_program"), "stop_program");
    assert_eq!(arm.step().joint_position, last.joint_position);
    assert_outside_servo_mode(&mut arm);
}

#[test]
fn a_stop_that_is_a_fault_halts_the_arm() {
    let mut arm = stopped_by_command(StopInServo::Fault);
    assert!((actual(&arm.controller.state()) - 40.0).abs() < 1e-9);
    assert_tripped(&mut arm, "0x108614");
}

#[test]
fn a_stop_of_a_resting_arm_leaves_it_in_its_place() {
    for reaction in StopInServo::ALL {
        let mut arm = Arm::new(builder().stop_in_servo(reaction));
        let before = arm.controller.state();
        assert_accepted(&arm.peer.call("stop_program"), "stop_program");
        let (state, later) = (arm.controller.state(), arm.step());
        let (stays, code) = match reaction {
            StopInServo::Leave => (false, "0x0"),
            StopInServo::Fault => (false, "0x108614"),
            _ => (true, "0x0"),
        };
        assert_eq!((state.servo_mode, &*state.error_code), (stays, code), "{reaction}");
        assert_eq!((state.joint_position, later.joint_position), (before.joint_position, before.joint_position));
        assert!(later.at_rest, "{reaction}");
    }
}

#[test]
fn a_stop_outside_servo_mode_brakes_whatever_it_does_in_servo_mode() {
    for reaction in StopInServo::ALL {
        let controller = enabled(builder().stop_in_servo(reaction));
        let mut peer = Peer::commands(&controller);
        let turn = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[90,0,0,0,0,0],"speed":50,"accel":100}"#;
        assert_accepted(&peer.ask(turn), "joint_move");
        controller.advance(Duration::from_secs(1));
        let from = actual(&controller.state());
        assert_accepted(&peer.call("stop_program"), "stop_program");
        controller.advance(Duration::from_secs(1));
        let state = controller.state();
        assert!(state.at_rest && state.error_code == "0x0", "{reaction}: {state:?}");
        assert!((actual(&state) - from - 12.5).abs() < 1e-9, "{reaction}: {}", actual(&state) - from);
    }
}

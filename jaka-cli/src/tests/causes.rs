//! One exit code, one fact and one hint for each event, for all commands that move the arm.

use jaka_sim::{Controller, Port};
use jaka_tests::Arm;
use jaka_tests::simulated::until;

use super::follow::words;
use super::{Run, jaka_beside};

const MOVES: [&str; 3] = [
    "call joint_move --mode absolute --joint-position 90,90,90,90,-90,0 --speed 10 --yes --wait",
    "move --joints 90,90,90,90,-90,0 --speed 10 --yes",
    "jog 1 90 --speed 10 --yes",
];

/// Event while an arm moves, with the exit code, the fact and the hint.
type Row = (fn(&Controller), u8, &'static str, &'static str);

const EVENTS: [Row; 8] = [
    (
        Controller::cut_power,
        25,
        "the arm has no power",
        "when somebody has looked at the arm, `jaka up` powers and enables it",
    ),
    (
        |arm| arm.set_state(|state| state.enabled = false),
        25,
        "the arm is not enabled",
        "when somebody has looked at the arm, `jaka up` powers and enables it",
    ),
    (
        Controller::collide,
        23,
        "the robot is in a protective stop",
        "when somebody has looked at the arm, `jaka clear` leaves the protective stop",
    ),
    (
        Controller::press_emergency_stop,
        24,
        "the emergency stop is pressed",
        "when nobody is at the arm, release it, then `jaka up`",
    ),
    (
        |arm| {
            arm.set_state(|state| {
                "0xF0034".clone_into(&mut state.error_code);
                state.servo_mode = false;
            });
        },
        26,
        "the controller reports an error",
        "look for obstacles around the arm and for signs of a collision; check whether the robot's serial number and model \
         are recognised correctly; check the settings of payload and mounting angle; when the cause is gone \
         and somebody has looked at the arm, `jaka clear` clears the error; `jaka explain 0x0f0034`",
    ),
    (
        |arm| arm.take_over().expect("it listens"),
        4,
        "the command connection is lost, and no stop can be sent on it",
        "use the emergency stop, or `jaka stop`, which takes the command port back and stops the arm",
    ),
    (
        Controller::disconnect,
        4,
        "the command connection is lost, and no stop can be sent on it",
        "use the emergency stop, or `jaka stop`, which takes the command port back and stops the arm",
    ),
    (
        |arm| arm.link(Port::Status).to_client().hold(),
        28,
        "the state of the robot is unknown",
        "check the network; try `jaka stop`: commands may still pass",
    ),
];

/// Runs a command; the event occurs once the arm moves.
fn run(words: &[String], event: fn(&Controller)) -> Run {
    let arm = Arm::simulated().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).start();
    let other = || {
        until(arm.clock(), || arm.state().joint_position.0[0] > 1.0);
        event(&arm);
    };
    jaka_beside(&arm, other, words)
}

#[test]
fn an_event_has_one_exit_code_one_fact_and_one_hint_in_each_command() {
    let moves = MOVES.iter().map(|line| line.split(' ').map(str::to_owned).collect::<Vec<_>>());
    for words in moves.chain([words(10.0, "")]) {
        for (event, code, fact, hint) in EVENTS {
            let run = run(&words, event);
            let told: Vec<_> = run.err.lines().filter(|line| !line.starts_with("note: ")).collect();
            assert_eq!((run.code, told.len()), (code, 2), "{words:?}: {run:?}");
            assert!(told[0].starts_with(&format!("error: {fact}")), "{words:?}: {run:?}");
            assert_eq!(told[1], format!("hint: {hint}"), "{words:?}: {run:?}");
        }
    }
}

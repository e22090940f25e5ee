//! Actions once the state is as a condition says.

use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use crate::common::{LIMIT, Peer, assert_accepted, document, enabled, stepped};
use jaka_sim::{Fault, Happening, Level, SimulatedClock};

const TURN: &str = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[90,0,0,0,0,0],"speed":10,"accel":100}"#;

fn ms(time: u64) -> Duration {
    Duration::from_millis(time)
}

/// The text of a panic.
fn panic_of<T: std::fmt::Debug>(act: impl FnOnce() -> T) -> String {
    let payload = panic::catch_unwind(AssertUnwindSafe(act)).expect_err("it panics");
    payload.downcast_ref::<&str>().map(|text| (*text).to_owned()).expect("it panics with a text")
}

#[test]
fn an_action_comes_in_the_cycle_in_which_its_condition_holds() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let start = controller.state().joint_position.0[0];
    let far = move |joint: f64| joint - start >= 10.0;
    let (sender, seen) = mpsc::channel();
    let action = move |controller: &jaka_sim::Controller| {
        // Within the action, time stands still.
        controller.advance(ms(1000));
        sender.send((controller.elapsed(), controller.state().joint_position.0[0])).expect("it is received");
        controller.collide();
    };
    let trigger = controller.when(move |state| far(state.joint_position.0[0]), action).expect("a thread starts");
    assert_accepted(&peer.ask(TURN), "joint_move");
    assert_eq!((trigger.fired_at(), trigger.wait(Duration::ZERO)), (None, false));
    controller.advance(ms(60_000));
    assert!(trigger.wait(Duration::ZERO), "advancing has waited for it");
    let (at, joint) = seen.recv().expect("it was sent");
    // 0.05 s for 0.5 deg, and 0.95 s for the rest, at its end or in the next cycle.
    assert!(far(joint) && !far(joint - 10.0 * 0.008), "{joint}");
    assert_eq!((Some(at), controller.state().joint_position.0[0]), (trigger.fired_at(), joint));
    assert!(controller.state().protective_stop && seen.recv().is_err());
}

#[test]
fn actions_happen_once_each_also_of_changes_that_no_time_makes() {
    let controller = stepped();
    let (sender, fired) = mpsc::channel();
    let trigger = |name, powered| {
        let sender = sender.clone();
        let action = move |_: &jaka_sim::Controller| sender.send(name).expect("it is received");
        controller.when(move |state| state.powered == powered, action).expect("a thread starts")
    };
    // It holds already.
    assert!(trigger("powered", true).wait(LIMIT));
    let off = trigger("off", false);
    assert!(!off.wait(ms(20)));
    for _ in 0..3 {
        controller.cut_power();
        controller.set_state(|state| state.powered = true);
    }
    assert!(off.wait(LIMIT) && off.fired_at() == Some(Duration::ZERO));
    assert_eq!(fired.try_iter().collect::<Vec<_>>(), ["powered", "off"]);
    // Requests change the state, too.
    let mut peer = Peer::commands(&controller);
    let off = trigger("off by a request", false);
    assert_accepted(&peer.call("power_off"), "power_off");
    assert!(off.wait(LIMIT));
    // And what is scheduled.
    let pressed = controller.when(|state| state.emergency_stop, jaka_sim::Controller::release_emergency_stop);
    let pressed = pressed.expect("a thread starts");
    controller.at(ms(500), Happening::PressEmergencyStop).expect("it has no input");
    controller.advance(ms(1000));
    assert_eq!((pressed.fired_at(), controller.state().emergency_stop), (Some(ms(504)), false));
}

#[test]
fn a_running_controller_asks_by_itself() {
    let controller = enabled(document());
    let mut peer = Peer::commands(&controller);
    let trigger = controller.when(
        |state| state.joint_position.0[0] > 1.0,
        |controller| {
            controller.inject(Fault::Close);
            controller.collide();
        },
    );
    let trigger = trigger.expect("a thread starts");
    assert_accepted(&peer.ask(TURN), "joint_move");
    // Nobody asks the controller for anything.
    assert!(trigger.wait(LIMIT));
    let joint = controller.state().joint_position.0[0];
    // How much more depends on the machine.
    assert!(controller.state().protective_stop && joint > 1.0, "{joint}");
    peer.send(r#"{"cmdName":"get_version"}"#);
    assert_eq!(peer.read_to_end(), b"");
}

#[test]
fn by_a_simulated_clock_actions_take_no_time_but_what_they_wait() {
    let clock = SimulatedClock::new();
    let controller = document().clock(&clock).start().expect("loopback has ports");
    let theirs = clock.clone();
    let pulse = controller.when(
        |state| state.digital_inputs[0],
        move |controller| {
            theirs.sleep(ms(250));
            controller.at(Duration::ZERO, Happening::Input(0, Level::Low)).expect("there is such an input");
        },
    );
    let pulse = pulse.expect("a thread starts");
    let clear = controller.when(
        |state| state.protective_stop,
        |controller| {
            controller.set_state(|state| state.protective_stop = false);
        },
    );
    let clear = clear.expect("a thread starts");
    controller.at(ms(1000), Happening::Input(0, Level::High)).expect("there is such an input");
    // While the other action waits.
    controller.at(ms(1100), Happening::Collide).expect("it has no input");
    assert!(pulse.wait(LIMIT));
    assert_eq!((pulse.fired_at(), clock.elapsed()), (Some(ms(1000)), ms(1250)));
    assert_eq!((clear.fired_at(), controller.state().protective_stop), (Some(ms(1104)), false));
    assert!(!controller.state().digital_inputs[0]);
    // The action waits as the controller goes: time goes on for it.
    let theirs = clock.clone();
    let last = controller.when(|_| true, move |_| theirs.sleep(ms(60_000))).expect("a thread starts");
    drop(controller);
    assert!(last.wait(Duration::ZERO) && clock.elapsed() >= ms(61_250));
}

#[test]
fn panics_are_passed_on_and_concern_nothing_else() {
    let controller = stepped();
    let mut peer = Peer::commands(&controller);
    let of_action = controller.when(|state| state.protective_stop, |_| panic!("the action")).expect("a thread starts");
    let of_condition = controller.when(|state| !state.protective_stop || panic!("the condition"), |_| {});
    // It holds at first.
    assert!(of_condition.expect("a thread starts").wait(LIMIT));
    let ask = |state: &jaka_sim::State| state.protective_stop && panic!("the condition");
    let of_condition = controller.when(ask, |_| {}).expect("a thread starts");
    controller.collide();
    assert_eq!(panic_of(|| of_action.wait(LIMIT)), "the action");
    assert_eq!(panic_of(|| of_condition.wait(LIMIT)), "the condition");
    assert_eq!((of_action.wait(LIMIT), of_condition.wait(LIMIT)), (true, false));
    assert_eq!((of_action.fired_at(), of_condition.fired_at()), (Some(Duration::ZERO), None));
    assert_accepted(&peer.call("clear_error"), "clear_error");
    controller.advance(ms(100));
    assert!(!controller.state().protective_stop);
}

#[test]
fn what_has_not_happened_is_given_up_with_the_controller() {
    let controller = enabled(document());
    let never = controller.when(|_| false, |_| panic!("it never holds")).expect("a thread starts");
    let (sender, begun) = mpsc::channel();
    let begins = controller.when(
        |_| true,
        move |controller| {
            sender.send(()).expect("it is received");
            // The controller begins to go meanwhile: later, this would only prove less.
            thread::sleep(ms(50));
            // Its sockets are there until the action has returned.
            controller.take_over().expect("it listens");
            controller.when(|_| true, |_| {}).expect("a thread starts");
        },
    );
    let begins = begins.expect("a thread starts");
    begun.recv().expect("it begins");
    drop(controller);
    assert!(begins.wait(Duration::ZERO) && !never.wait(LIMIT));
}

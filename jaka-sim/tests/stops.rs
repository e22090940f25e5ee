//! Behaviour of the controller after a stop.

use std::time::Duration;

use crate::common::{Peer, assert_accepted, stepped};

/// The speed and deceleration of each motion here, in deg/s and deg/s²: a stop takes 1.5 s and 45 deg.
const TURN: &str =
    r#"{"cmdName":"joint_move","relFlag":REL,"jointPosition":[J1,90,90,90,-90,0],"speed":60,"accel":40}"#;

fn turn(relative: bool, degrees: f64) -> String {
    let text = TURN.replace("REL", if relative { "1" } else { "0" });
    let text = if relative { text.replace(",90,90,90,-90,0]", ",0,0,0,0,0]") } else { text };
    text.replace("J1", &degrees.to_string())
}

#[test]
fn a_motion_that_is_accepted_while_the_arm_brakes_begins_where_that_ends() {
    for relative in [false, true] {
        let controller = stepped();
        let mut peer = Peer::commands(&controller);
        assert_accepted(&peer.ask(&turn(true, 200.0)), "joint_move");
        controller.advance(Duration::from_secs(2));
        assert_accepted(&peer.call("stop_program"), "stop_program");
        controller.advance(Duration::from_millis(80));
        assert_accepted(&peer.ask(&turn(relative, 10.0)), "joint_move");
        let mut before = controller.state();
        let mut stop = 0.0_f64;
        while !before.at_rest {
            controller.advance(Duration::from_millis(8));
            let state = controller.state();
            let [from, to] = [&before, &state].map(|state| state.joint_position.0[0]);
            assert!((to - from).abs() <= 60.0 * 0.008 + 1e-9, "a jump from {from} to {to} deg");
            stop = stop.max(to);
            before = state;
        }
        let end = before.joint_position.0[0];
        // Relative to where the arm stopped, after 75 deg and 45 more to brake.
        let expected = if relative { stop } else { 10.0 };
        assert!((end - expected).abs() < 1e-9 && (100.0..150.0).contains(&stop), "{end} of {stop}");
    }
}

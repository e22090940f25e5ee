//! Time that passes faster than real time.

use std::io::ErrorKind;
use std::time::Duration;

use crate::common::{Peer, assert_accepted, document};
use jaka_sim::{Delays, Habit, SimulatedClock};

const LONG: Duration = Duration::from_secs(1000);

#[test]
fn delays_motions_and_packets_pass_as_fast_as_the_time() {
    let mut delays = Delays::NONE;
    delays.power_on = LONG;
    let clock = SimulatedClock::new();
    let builder = document().delays(delays).habits(Habit::LatePower).status_period(LONG).time_scale(1000.0);
    let controller = builder.clock(&clock).start().expect("loopback has ports");
    let mut reader = Peer::simulated_status(&controller);
    let mut peer = Peer::simulated_commands(&controller);
    reader.receive();
    assert_eq!(clock.elapsed(), Duration::ZERO);
    reader.receive();
    assert_eq!((clock.elapsed(), controller.elapsed()), (LONG / 1000, LONG));
    assert_accepted(&peer.call("power_on"), "power_on");
    assert_eq!(clock.elapsed(), 2 * LONG / 1000);
    assert!(controller.state().powered);
    controller.set_state(|state| state.enabled = true);
    let turn = r#"{"cmdName":"joint_move","relFlag":1,"jointPosition":[100,0,0,0,0,0],"speed":1,"accel":1}"#;
    assert_accepted(&peer.ask(turn), "joint_move");
    assert_eq!(peer.call("wait_complete")["errorCode"], "0");
    assert!((controller.state().joint_position.0[0] - 100.0).abs() < 1e-9);
    // 101 s, and the time until the controller looks.
    assert_eq!(clock.elapsed(), 2 * LONG / 1000 + Duration::from_millis(102));
}

#[test]
fn a_scale_out_of_range_is_an_error() {
    for scale in [0.0, -1.0, 1001.0, f64::NAN, f64::INFINITY] {
        let error = document().time_scale(scale).start().expect_err("it is out of range");
        assert_eq!(error.kind(), ErrorKind::InvalidInput, "{error}");
    }
}

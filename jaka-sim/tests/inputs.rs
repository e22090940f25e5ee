//! Inputs that change by themselves.

use std::io::ErrorKind;
use std::time::Duration;

use crate::common::{Peer, document, json, stepped};
use jaka_sim::{AnalogInput, Controller, DigitalInput};

fn ms(time: u64) -> Duration {
    Duration::from_millis(time)
}

#[test]
fn inputs_change_at_their_times_and_packets_show_them() {
    let controller = document()
        .stepped_clock()
        .status_period(Duration::MAX)
        .input(DigitalInput::cabinet(3).high_at(ms(1000)).low_at(ms(2000)))
        .input(AnalogInput::tool(0).value_at(ms(500), 2.5).value_at(ms(500), 3.5))
        .start()
        .expect("loopback has ports");
    let mut status = Peer::status(&controller);
    status.receive();
    let mut shown = |time| {
        controller.advance(time);
        controller.publish();
        let packet = json(&status.receive());
        (packet["din"][3].clone(), packet["tio_ain"][0].clone())
    };
    assert_eq!(shown(ms(496)), (0.into(), 0.into()));
    // Two changes at the same time are made in their order.
    assert_eq!(shown(ms(8)), (0.into(), 3.5.into()));
    assert_eq!(shown(ms(496)), (1.into(), 3.5.into()));
    assert_eq!(shown(ms(992)), (1.into(), 3.5.into()));
    assert_eq!(shown(ms(8)), (0.into(), 3.5.into()));
    // An idle arm passes over many cycles at once, and over no change.
    let later = DigitalInput::tool(1).high_at(ms(60_000)).low_at(ms(60_008)).high_at(ms(120_000));
    controller.input(later).expect("there is such an input");
    controller.advance(ms(60_000));
    assert!(controller.state().tool_digital_inputs[1]);
    controller.advance(ms(8));
    assert!(!controller.state().tool_digital_inputs[1]);
    controller.advance(ms(60_000));
    assert!(controller.state().tool_digital_inputs[1]);
}

#[test]
fn an_input_that_the_controller_does_not_have_is_an_error() {
    let error = document().input(DigitalInput::cabinet(144).high_at(ms(1))).start().expect_err("there are 144");
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert_eq!(error.to_string(), "the cabinet has 144 digital inputs, from 0, and not one with number 144");
    let controller: Controller = stepped();
    for script in [AnalogInput::tool(1).value_at(ms(1), 1.0), AnalogInput::cabinet(66).value_at(ms(1), 1.0)] {
        let error = controller.input(script).expect_err("there is none");
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
    }
    controller.advance(ms(100));
    assert!(controller.state().tool_analog_inputs.iter().all(|value| *value == 0.0));
}

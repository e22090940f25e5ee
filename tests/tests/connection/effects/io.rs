//! Inputs and outputs.

use jaka_sync::io::{DigitalOutputKind, FunctionInputKind, SetAnalogOutput, SetDigitalOutput};
use jaka_sync::types::Switch;

use super::arm::Arm;

effects! {
    set_digital_output => digital_outputs_show_on_port_10000,
    get_digital_input_status => digital_inputs_are_read,
    set_analog_output => analog_outputs_show_on_port_10000,
    get_extio_status => extension_modules_are_read,
    get_funcdi_status => function_inputs_are_read,
}

fn digital_outputs_show_on_port_10000(arm: &mut Arm) {
    let set = |kind, value| SetDigitalOutput::new(kind, 2, value);
    arm.client.set_digital_output(&set(DigitalOutputKind::Cabinet, Switch::On)).expect("it answers");
    arm.client.set_digital_output(&set(DigitalOutputKind::Tool, Switch::On)).expect("it answers");
    let status = arm.status();
    let on =
        |pins: Option<Vec<bool>>| pins.map(|pins| (0..pins.len()).filter(|index| pins[*index]).collect::<Vec<_>>());
    assert_eq!((on(status.digital_outputs), on(status.tool_digital_outputs)), (Some(vec![2]), Some(vec![2])));
    arm.client.set_digital_output(&set(DigitalOutputKind::Cabinet, Switch::Off)).expect("it answers");
    let status = arm.status();
    assert_eq!((on(status.digital_outputs), on(status.tool_digital_outputs)), (Some(vec![]), Some(vec![2])));
}

fn digital_inputs_are_read(arm: &mut Arm) {
    arm.controller.set_state(|state| state.digital_inputs[5] = true);
    let inputs = arm.client.get_digital_input_status().expect("it answers").digital_inputs;
    assert_eq!(inputs, arm.controller.state().digital_inputs);
    assert!(inputs[5] && !inputs[4]);
}

fn analog_outputs_show_on_port_10000(arm: &mut Arm) {
    let request = SetAnalogOutput::cabinet(7, 4.32);
    arm.client.set_analog_output(&request).expect("it answers");
    let outputs = arm.status().analog_outputs.expect("the packet has outputs");
    assert_eq!((outputs.get(6), outputs.get(7)), (Some(&0.0), Some(&4.32)));
}

fn extension_modules_are_read(arm: &mut Arm) {
    for running in [true, false] {
        arm.controller.set_state(|state| state.extio.state.running = running);
        let status = arm.client.get_extio_status().expect("it answers").extio_status;
        assert_eq!(status.state.running, running);
        assert_eq!(status, arm.controller.state().extio);
    }
}

fn function_inputs_are_read(arm: &mut Arm) {
    let mut input = arm.controller.state().function_inputs[3];
    (input.kind, input.index) = (FunctionInputKind::Tool, 1);
    arm.controller.set_state(|state| state.function_inputs[3] = input);
    let inputs = arm.client.get_funcdi_status().expect("it answers").function_inputs;
    assert_eq!(inputs[3], input);
    assert_eq!(inputs, arm.controller.state().function_inputs);
}

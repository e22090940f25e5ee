//! Payload of the arm.

use jaka_sync::payload::SetPayload;

use super::arm::Arm;

effects! {
    set_payload => the_payload_is_given_back,
    get_payload => the_payload_is_read,
}

fn the_payload_is_given_back(arm: &mut Arm) {
    let tool = arm.client.get_tool_payload().expect("it answers");
    let (mass, centroid) = (2.5, [1.0, 2.0, 3.0].into());
    arm.client.set_payload(&SetPayload::new(mass, centroid)).expect("it answers");
    let payload = arm.client.get_payload().expect("it answers");
    assert_eq!((payload.mass, payload.centroid), (mass, centroid));
    // That at the sensor is another.
    assert_eq!(arm.client.get_tool_payload().expect("it answers"), tool);
}

fn the_payload_is_read(arm: &mut Arm) {
    let (mass, centroid) = (0.75, [4.0, 5.0, 6.0].into());
    arm.controller.set_state(|state| (state.payload.mass, state.payload.centroid) = (mass, centroid));
    let payload = arm.client.get_payload().expect("it answers");
    assert_eq!((payload.mass, payload.centroid), (mass, centroid));
}

//! Reaction of the controller to a failure of the network.

use jaka_sync::network::{NetworkExceptionAction, SetNetworkExceptionHandle};

use super::arm::Arm;

effects! {
    set_network_exception_handle => the_reaction_is_kept,
}

/// No command reads it back, and the document does not say what counts as a failure.
fn the_reaction_is_kept(arm: &mut Arm) {
    for (delay, action) in [(100, NetworkExceptionAction::Terminate), (0, NetworkExceptionAction::Keep)] {
        arm.client.set_network_exception_handle(&SetNetworkExceptionHandle::new(delay, action)).expect("it answers");
        let kept = &arm.controller.state().remembered["set_network_exception_handle"];
        assert_eq!((kept["delay"].as_i64(), kept["action"].as_i64()), (Some(delay), Some(action.into())));
    }
}

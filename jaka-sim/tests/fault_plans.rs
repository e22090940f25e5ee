//! Plans of the faults of replies.

use crate::common::{Peer, fresh, request};
use jaka_sim::{Controller, Fault, FaultPlan};

fn with(plan: FaultPlan) -> (Controller, Peer) {
    let controller = Controller::builder().faults(plan).start().expect("loopback has ports");
    let peer = Peer::commands(&controller);
    (controller, peer)
}

/// Whether the next reply has a name.
fn is_named(peer: &mut Peer, command: &str) -> bool {
    peer.call(command)["cmdName"] == command
}

#[test]
fn a_request_need_not_be_tidy_to_be_known() {
    let controller = fresh();
    for text in [r#"{ "a": "}", "cmdName" : " get_payload " }"#, r#"{"cmdName":"get_p\u0061yload"}"#] {
        controller.inject_for("get_payload", Fault::Renamed("jog".to_owned()));
        let mut peer = Peer::commands(&controller);
        assert_eq!(peer.ask(text)["cmdName"], "jog", "{text}");
    }
}

#[test]
fn a_fault_may_be_for_all() {
    let controller = fresh();
    controller.inject_always(Fault::Nameless);
    controller.inject(Fault::None);
    let mut peer = Peer::commands(&controller);
    assert!(is_named(&mut peer, "get_payload"));
    assert!((0..10).all(|_| !is_named(&mut peer, "get_payload")));
    controller.inject_always(Fault::None);
    assert!(is_named(&mut peer, "get_payload"));
}

#[test]
fn a_script_may_be_a_text() {
    let plan = "none, nameless\nfor get_payload: renamed jog\nalways oversized 5000".parse();
    let (_controller, mut peer) = with(plan.unwrap_or_else(|error| panic!("{error}")));
    assert!(is_named(&mut peer, "get_version"));
    assert_eq!(peer.call("get_payload")["cmdName"], "jog");
    assert!(!is_named(&mut peer, "get_version"));
    peer.send(request("get_payload"));
    assert_eq!(peer.receive().len(), 5000);
}

/// Results of a hundred requests: true where the reply has a name.
fn hundred(plan: &FaultPlan) -> Vec<bool> {
    let (_controller, mut peer) = with(plan.clone());
    (0..100).map(|_| is_named(&mut peer, "get_version")).collect()
}

#[test]
fn chance_can_be_repeated() {
    let plan =
        FaultPlan::random(7).one_in(5, [Fault::Nameless, Fault::Pieces(vec![3]), Fault::Renamed("jog".to_owned())]);
    let first = hundred(&plan);
    assert!(first.contains(&true) && first.contains(&false), "{plan:?}");
    assert_eq!(hundred(&plan), first, "{plan}");
    // So it can from what a failed test has printed.
    assert_eq!(hundred(&plan.to_string().parse().expect("a plan reads what it writes")), first);
    assert!(format!("{plan:?}").contains("seed: 7"));
    assert_ne!(hundred(&plan.to_string().replace("random 7", "random 8").parse().expect("it is a plan")), first);
}

use jaka_proto::Command as _;
use jaka_proto::exchange::{Exchange, Support};
use jaka_proto::messages::program::StopProgram;

use super::fixture::with_robot;
use super::*;

/// A session that has moved the arm, and was not seen at rest after it, began once the questions had been asked.
#[test]
fn rest_of_before_a_session_is_none_after_it() {
    let stops = with_robot();
    let due = stops.rest_due();
    let lead = stops.lead(Handle::FIRST, Owner(1)).expect("nothing keeps it back");
    lead.expect_set_point(Some(stops.clock().now()));
    drop(lead);
    stops.rest_seen(due);
    assert_eq!(stops.check_motion(), Err(Kept::NotAtRest));
    stops.rest_seen(stops.rest_due());
    assert_eq!(stops.check_motion(), Ok(()));
}

/// A refusal without a name may overtake the reply to a stop: that one is not lost.
#[test]
fn a_stop_is_accepted_whose_reply_comes_after_that_to_a_later_request() {
    let (stops, mut exchange) = (with_robot(), Exchange::default());
    let stop = stops.begin(StopKind::Program);
    let outgoing = Outgoing::of(stops.clock(), StopProgram::INFO, Duration::MAX);
    let outgoing = outgoing.of_stop(stop.number(), stops.clock().stopwatch());
    let request = exchange.send(Owner(0), Support::Everywhere, "stop_program".into());
    stops.entered([request].into_iter(), &outgoing);
    let later = exchange.send(Owner(0), Support::Uncertain, "x".into());
    stops.answered(later, false);
    stops.answered(request, true);
    assert_eq!(stops.accepted(), stop.number());
}

#[test]
fn a_stop_that_is_taken_back_takes_its_acknowledgement_with_it() {
    let stops = with_robot();
    let stop = stops.begin(StopKind::OfMotion);
    stops.acknowledge();
    stop.take_back();
    drop(stops.begin(StopKind::Program));
    assert_eq!(stops.check_motion(), Err(Kept::Stopped), "it is another stop");
}

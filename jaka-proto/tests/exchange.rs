//! The exchange by examples. Random runs are in `tests/tests/exchange_client/`, against a model.

use std::cell::Cell;
use std::time::{Duration, Instant};

use jaka_proto::Request;
use jaka_proto::exchange::{
    Delivery, Exchange, Failure, OutOfSync, Owner, ReadReply, Received, RequestId, Support, TextOnly, Waiter,
};

const OWNER: Owner = Owner(1);

fn send(exchange: &mut Exchange, command: &'static str) -> RequestId {
    exchange.send(OWNER, Support::Everywhere, command.into())
}

fn named(command: &str) -> String {
    format!(r#"{{"errorCode": "0", "cmdName": "{command}"}}"#)
}

/// Sends a command that the controller may lack.
fn send_uncertain(exchange: &mut Exchange, command: &'static str) -> RequestId {
    exchange.send(OWNER, Support::Uncertain, command.into())
}

/// A reply comes, and is read by a thread that waits for nothing.
fn receive(exchange: &mut Exchange, text: &str) -> Result<Received, OutOfSync> {
    Ok(receive_any(exchange, text)?.expect("it completes a request"))
}

/// A reply comes that may be held.
fn receive_any(exchange: &mut Exchange, text: &str) -> Result<Option<Received>, OutOfSync> {
    let envelope = TextOnly.read(text).expect("it is an object or a tuple");
    exchange.receive(text, envelope, &mut Waiter::nobody())
}

fn answer(exchange: &mut Exchange, command: &str) -> Result<Received, OutOfSync> {
    receive(exchange, &named(command))
}

/// Takes the reply or the failure that is pending for a request.
fn pending(exchange: &mut Exchange, request: RequestId) -> Option<Result<String, Failure>> {
    let (mut text, mut reader) = (String::new(), TextOnly);
    let mut waiter = Waiter::new(request, &mut text, &mut reader);
    exchange.take_pending(&mut waiter);
    let outcome = waiter.take_outcome();
    outcome.map(|outcome| outcome.map(|()| text))
}

fn unsolicited<T>(command: &str) -> Result<T, OutOfSync> {
    Err(OutOfSync::Unsolicited { command: command.to_owned() })
}

fn ambiguous<T>(command: &str) -> Result<T, OutOfSync> {
    Err(OutOfSync::Ambiguous { command: command.to_owned() })
}

#[test]
fn replies_in_order_complete_their_requests() {
    let mut exchange = Exchange::default();
    let (a, b) = (send(&mut exchange, "a"), send(&mut exchange, "b"));
    let first = answer(&mut exchange, "a").expect("it is outstanding");
    assert_eq!((first.request, &*first.command, first.delivery), (a, "a", Delivery::Pending));
    assert_eq!(answer(&mut exchange, "b").expect("it is outstanding").request, b);
    assert_eq!(exchange.outstanding(), 0);
    assert_eq!(pending(&mut exchange, b), Some(Ok(named("b"))));
    assert_eq!(pending(&mut exchange, a), Some(Ok(named("a"))));
    assert_eq!(pending(&mut exchange, a), None);
}

#[test]
fn a_waiter_is_given_its_own_reply_as_it_reads_it() {
    let mut exchange = Exchange::default();
    let (a, b) = (send(&mut exchange, "a"), send(&mut exchange, "b"));
    let (mut text, mut reader) = (String::new(), TextOnly);
    let mut waiter = Waiter::new(b, &mut text, &mut reader);
    for (reply, delivery) in [(named("a"), Delivery::Pending), (named("b"), Delivery::Waiter)] {
        assert!(!waiter.is_done());
        let envelope = waiter.read(&reply).expect("it is an object");
        let received = exchange.receive(&reply, envelope, &mut waiter).expect("it is outstanding");
        assert_eq!(received.map(|received| received.delivery), Some(delivery));
    }
    assert!(waiter.is_done());
    assert_eq!(waiter.take_outcome(), Some(Ok(())));
    assert_eq!(text, named("b"));
    assert_eq!(pending(&mut exchange, b), None);
    assert_eq!(pending(&mut exchange, a), Some(Ok(named("a"))));
}

#[test]
fn a_waiter_that_reads_the_reply_to_a_later_request_has_lost_its_own() {
    let mut exchange = Exchange::default();
    let (a, b) = (send(&mut exchange, "a"), send(&mut exchange, "b"));
    let (mut text, mut reader) = (String::new(), TextOnly);
    let mut waiter = Waiter::new(a, &mut text, &mut reader);
    let reply = named("b");
    let envelope = waiter.read(&reply).expect("it is an object");
    let received = exchange.receive(&reply, envelope, &mut waiter).expect("it is outstanding");
    assert_eq!(received.map(|received| received.delivery), Some(Delivery::Pending));
    assert_eq!(waiter.take_outcome(), Some(Err(Failure::Lost)));
    assert_eq!(pending(&mut exchange, b), Some(Ok(reply)));
}

#[test]
fn a_reply_to_a_later_command_means_that_the_earlier_ones_are_lost() {
    let mut exchange = Exchange::default();
    let (a, b) = (send(&mut exchange, "a"), send(&mut exchange, "b"));
    assert_eq!(answer(&mut exchange, "b").expect("it is outstanding").request, b);
    assert_eq!(pending(&mut exchange, a), Some(Err(Failure::Lost)));
    assert_eq!(answer(&mut exchange, "a"), unsolicited("a"));
}

#[test]
fn a_late_reply_is_discarded() {
    let mut exchange = Exchange::default();
    let a = send(&mut exchange, "a");
    exchange.give_up(a).expect("nothing has come");
    let b = send(&mut exchange, "b");
    let late = answer(&mut exchange, "a").expect("it is outstanding");
    assert_eq!((late.request, late.delivery), (a, Delivery::Discarded));
    assert_eq!(answer(&mut exchange, "b").expect("it is outstanding").request, b);
    assert_eq!(pending(&mut exchange, a), None);
}

#[test]
fn a_lost_reply_is_forgotten_when_a_later_command_is_answered() {
    let mut exchange = Exchange::default();
    let a = send(&mut exchange, "a");
    exchange.give_up(a).expect("nothing has come");
    let b = send(&mut exchange, "b");
    assert_eq!(answer(&mut exchange, "b").expect("it is outstanding").request, b);
    assert_eq!(pending(&mut exchange, a), None);
    assert_eq!(exchange.outstanding(), 0);
}

#[test]
fn with_equal_names_the_first_reply_completes_the_older_request() {
    let mut exchange = Exchange::default();
    let older = send(&mut exchange, "a");
    exchange.give_up(older).expect("nothing has come");
    let newer = send(&mut exchange, "a");
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").request, older);
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").request, newer);
    // Both replies came: nothing is in doubt any more.
    let next = send(&mut exchange, "a");
    assert_eq!(exchange.give_up(next), Ok(()));
}

#[test]
fn with_equal_names_a_second_reply_that_does_not_come_leaves_all_in_doubt() {
    let mut exchange = Exchange::default();
    let older = send(&mut exchange, "a");
    exchange.give_up(older).expect("nothing has come");
    let newer = send(&mut exchange, "a");
    answer(&mut exchange, "a").expect("it is outstanding");
    assert_eq!(exchange.give_up(newer), ambiguous("a"));
}

#[test]
fn a_command_sent_after_a_doubtful_one_is_doubtful_too() {
    let mut exchange = Exchange::default();
    let older = send(&mut exchange, "a");
    exchange.give_up(older).expect("nothing has come");
    send(&mut exchange, "a");
    answer(&mut exchange, "a").expect("it is outstanding");
    let third = send(&mut exchange, "a");
    let other = send(&mut exchange, "b");
    assert_eq!(exchange.give_up(other), Ok(()));
    assert!(exchange.give_up(third).is_err());
}

#[test]
fn when_nothing_at_all_came_a_second_timeout_leaves_nothing_in_doubt() {
    let mut exchange = Exchange::default();
    for _ in 0..3 {
        let request = send(&mut exchange, "a");
        assert_eq!(exchange.give_up(request), Ok(()));
    }
    assert_eq!(exchange.outstanding(), 3);
}

#[test]
fn a_reply_to_no_outstanding_request() {
    let mut exchange = Exchange::default();
    assert_eq!(answer(&mut exchange, "a"), unsolicited("a"));
    let a = send(&mut exchange, "a");
    assert_eq!(answer(&mut exchange, "b"), unsolicited("b"));
    // The request stays outstanding: its waiter learns that the connection is broken, not that a reply is lost.
    assert_eq!((exchange.outstanding(), pending(&mut exchange, a)), (1, None));
}

#[test]
fn a_reply_without_a_name_is_attributed_only_if_it_is_the_refusal_of_the_only_request() {
    let refusal = r#"{"errorCode": "1", "errorMsg": "no"}"#;
    let mut exchange = Exchange::default();
    assert_eq!(receive(&mut exchange, refusal), Err(OutOfSync::Nameless));
    let a = send(&mut exchange, "a");
    assert_eq!(receive(&mut exchange, r#"{"errorCode": "0"}"#), Err(OutOfSync::Nameless));
    assert_eq!(receive(&mut exchange, r#"{"errorCode": "fine"}"#), Err(OutOfSync::Nameless));
    assert_eq!(receive(&mut exchange, refusal).expect("only one is outstanding").request, a);
    assert!(matches!(pending(&mut exchange, a), Some(Err(Failure::Refused(refusal))) if refusal.message == "no"));
    let b = send(&mut exchange, "b");
    let reply = r#"{"errorCode": "0", "cmdName": " b"}"#;
    assert_eq!(receive(&mut exchange, reply).expect("it is outstanding").request, b);
    send(&mut exchange, "a");
    send(&mut exchange, "b");
    assert_eq!(receive(&mut exchange, refusal), Err(OutOfSync::Nameless));
}

/// A refusal without a name.
const NAMELESS: &str = r#"{"errorCode": "1", "errorMsg": "no"}"#;

fn is_refused(exchange: &mut Exchange, request: RequestId) -> bool {
    matches!(pending(exchange, request), Some(Err(Failure::Refused(_))))
}

#[test]
fn a_refusal_without_a_name_is_that_of_the_one_command_that_was_never_answered() {
    let mut exchange = Exchange::default();
    send_uncertain(&mut exchange, "known");
    answer(&mut exchange, "known").expect("it is outstanding");
    let (known, stop) = (send_uncertain(&mut exchange, "known"), send(&mut exchange, "stop"));
    assert_eq!(receive_any(&mut exchange, NAMELESS), Err(OutOfSync::Nameless));
    let lacked = send_uncertain(&mut exchange, "lacked");
    let set_point = send(&mut exchange, "set-point");
    assert_eq!(receive(&mut exchange, NAMELESS).expect("one may be lacked").request, lacked);
    // The others have not lost their replies, and each waiter finds its outcome.
    for (command, request) in [("known", known), ("stop", stop), ("set-point", set_point)] {
        assert_eq!(answer(&mut exchange, command).expect("it is outstanding").request, request);
        assert_eq!(pending(&mut exchange, request), Some(Ok(named(command))));
    }
    assert!(is_refused(&mut exchange, lacked));
    // It may be lacked at the next time, too.
    let again = send_uncertain(&mut exchange, "lacked");
    send(&mut exchange, "stop");
    assert_eq!(receive(&mut exchange, NAMELESS).expect("one may be lacked").request, again);
}

#[test]
fn one_command_that_was_never_answered_is_waited_for_at_a_time() {
    let mut exchange = Exchange::default();
    let room = |exchange: &Exchange, command| exchange.room(Support::Uncertain, command);
    assert_eq!(room(&exchange, "a"), 1);
    let a = send_uncertain(&mut exchange, "a");
    assert_eq!((room(&exchange, "a"), room(&exchange, "b")), (0, 0));
    assert_eq!(exchange.room(Support::Everywhere, "b"), usize::MAX);
    // What was given up does not count.
    exchange.give_up(a).expect("nothing has come");
    assert_eq!((room(&exchange, "a"), room(&exchange, "b")), (1, 1));
    let b = send_uncertain(&mut exchange, "b");
    assert_eq!((room(&exchange, "a"), room(&exchange, "b")), (0, 0));
    exchange.withdraw(b).expect("nothing has come");
    assert_eq!(room(&exchange, "b"), 1);
    answer(&mut exchange, "a").expect("it is outstanding");
    assert_eq!((room(&exchange, "a"), room(&exchange, "b")), (usize::MAX, 1));
}

#[test]
fn a_refusal_without_a_name_is_held_while_one_that_was_given_up_may_have_been_refused() {
    for decides in [false, true] {
        let mut exchange = Exchange::default();
        let given_up = send_uncertain(&mut exchange, "a");
        exchange.give_up(given_up).expect("nothing has come");
        let waits = send_uncertain(&mut exchange, "b");
        let stop = send(&mut exchange, "stop");
        assert_eq!(receive_any(&mut exchange, NAMELESS), Ok(None));
        assert_eq!((exchange.outstanding(), pending(&mut exchange, waits)), (3, None));
        if decides {
            // Now both have been refused.
            assert_eq!(receive(&mut exchange, NAMELESS).expect("two may be lacked").request, waits);
            assert!(is_refused(&mut exchange, waits));
            assert_eq!(exchange.outstanding(), 1);
            assert_eq!(answer(&mut exchange, "stop").expect("it is outstanding").request, stop);
        } else {
            // One of the two has been refused, and it is not known which.
            assert_eq!(answer(&mut exchange, "stop").expect("it is outstanding").request, stop);
            assert_eq!(pending(&mut exchange, waits), Some(Err(Failure::Lost)));
        }
        assert_eq!(exchange.outstanding(), 0);
    }
}

#[test]
fn a_reply_with_a_name_ends_that_a_refusal_before_it_is_held() {
    let mut exchange = Exchange::default();
    let given_up = send_uncertain(&mut exchange, "a");
    exchange.give_up(given_up).expect("nothing has come");
    send(&mut exchange, "stop");
    let waits = send_uncertain(&mut exchange, "b");
    assert_eq!(receive_any(&mut exchange, NAMELESS), Ok(None));
    // The refusal came before this reply, and so belongs to the request before it.
    answer(&mut exchange, "stop").expect("it is outstanding");
    send(&mut exchange, "stop");
    assert_eq!((exchange.outstanding(), pending(&mut exchange, waits)), (2, None));
    assert_eq!(receive(&mut exchange, NAMELESS).expect("one may be lacked").request, waits);
    assert_eq!(
        receive_any(&mut exchange, NAMELESS).expect("a stop is left").map(|stop| stop.delivery),
        Some(Delivery::Pending)
    );
}

#[test]
fn a_bare_tuple_is_the_reply_of_the_one_command_that_is_answered_so() {
    let mut exchange = Exchange::new(Request::bare_reply_command());
    send(&mut exchange, "a");
    assert_eq!(receive(&mut exchange, "(0, [])"), unsolicited("get_extio_status"));
    let status = send(&mut exchange, "get_extio_status");
    assert_eq!(receive(&mut exchange, "(0, [])").expect("it is outstanding").request, status);
    assert_eq!(pending(&mut exchange, status), Some(Ok("(0, [])".to_owned())));
}

#[test]
fn a_request_that_did_not_go_out_is_withdrawn() {
    let mut exchange = Exchange::default();
    let (a, b) = (send(&mut exchange, "a"), exchange.post(OWNER, Support::Everywhere, "a", Instant::now()));
    assert_eq!(exchange.withdraw(a), Err(OutOfSync::BeforeSent));
    assert_eq!(exchange.withdraw(b), Ok(()));
    assert_eq!((exchange.outstanding(), exchange.posted_outstanding(OWNER)), (1, 0));
    answer(&mut exchange, "a").expect("it is outstanding");
    assert_eq!(exchange.withdraw(a), Err(OutOfSync::BeforeSent));
    assert_eq!(answer(&mut exchange, "a"), unsolicited("a"));
}

#[test]
fn outcomes_of_posted_requests_are_counted() {
    let (mut exchange, now) = (Exchange::default(), Instant::now());
    let later = now + Duration::from_secs(1);
    let [first, second] = [now, later].map(|now| exchange.post(OWNER, Support::Everywhere, "a", now));
    exchange.post(OWNER, Support::Everywhere, "b", later);
    let oldest = exchange.oldest_posted(OWNER).expect("they are outstanding");
    assert_eq!((oldest.id, oldest.command, oldest.sent_at), (first, "a", now));
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").delivery, Delivery::Counted);
    assert_eq!(exchange.oldest_posted(OWNER).map(|oldest| oldest.id), Some(second));
    receive(&mut exchange, r#"{"errorCode": "7", "cmdName": "a"}"#).expect("it is outstanding");
    exchange.post(OWNER, Support::Everywhere, "c", later);
    answer(&mut exchange, "c").expect("it is outstanding");
    let outcomes = exchange.take_posted_outcomes(OWNER);
    assert_eq!(outcomes.accepted, 2);
    let [("a", Failure::Refused(refusal)), ("b", Failure::Lost)] = &*outcomes.failed else { panic!("{outcomes:?}") };
    assert_eq!(refusal.code.0, 7);
    let again = exchange.take_posted_outcomes(OWNER);
    assert_eq!((again.accepted, again.failed.len(), exchange.posted_outstanding(OWNER)), (0, 0, 0));
}

#[test]
fn posted_requests_are_given_up_from_the_oldest() {
    let (mut exchange, now, after) = (Exchange::default(), Instant::now(), Duration::from_secs(5));
    for _ in 0..3 {
        exchange.post(OWNER, Support::Everywhere, "a", now);
    }
    assert_eq!(exchange.give_up_oldest_posted(OWNER, after), Ok(()));
    assert_eq!(exchange.take_posted_outcomes(OWNER).failed, [("a", Failure::TimedOut { after })]);
    assert_eq!((exchange.outstanding(), exchange.posted_outstanding(OWNER)), (3, 2));
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").delivery, Delivery::Discarded);
    // The reply may have been the second's.
    assert_eq!(exchange.give_up_oldest_posted(OWNER, after), ambiguous("a"));
    assert_eq!(exchange.abandon_posted(OWNER).0, 2);
    assert_eq!((exchange.outstanding(), exchange.posted_outstanding(OWNER)), (2, 0));
    assert_eq!(exchange.give_up_oldest_posted(OWNER, after), Ok(()));
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").delivery, Delivery::Discarded);
    let outcomes = exchange.take_posted_outcomes(OWNER);
    assert_eq!((outcomes.accepted, outcomes.failed), (0, vec![]));
}

#[test]
fn each_owner_has_its_own_counts_and_outcomes() {
    let (mut exchange, now, other) = (Exchange::default(), Instant::now(), Owner(2));
    exchange.post(OWNER, Support::Everywhere, "a", now);
    exchange.post(other, Support::Everywhere, "b", now);
    exchange.post(other, Support::Everywhere, "a", now);
    let request = exchange.send(other, Support::Everywhere, "c".into());
    assert_eq!((exchange.posted_outstanding(OWNER), exchange.posted_outstanding(other)), (1, 2));
    assert_eq!(exchange.outstanding_of(|owner| owner == other), 3);
    receive(&mut exchange, r#"{"errorCode": "7", "cmdName": "a"}"#).expect("it is outstanding");
    assert_eq!(exchange.take_posted_outcomes(other).failed, []);
    assert_eq!(exchange.oldest_posted(OWNER), None);
    assert_eq!(exchange.oldest_posted(other).map(|oldest| oldest.command), Some("b"));
    assert!(matches!(*exchange.take_posted_outcomes(OWNER).failed, [("a", Failure::Refused(_))]));
    assert_eq!(exchange.abandon_posted(OWNER).0, 0);
    assert_eq!(exchange.abandon_posted(other).0, 2);
    // What was abandoned is outstanding in the controller, and so is what is waited for.
    assert_eq!(exchange.outstanding_of(|owner| owner == other), 3);
    assert_eq!(answer(&mut exchange, "b").expect("it is outstanding").delivery, Delivery::Discarded);
    exchange.give_up(request).expect("nothing has come");
    assert_eq!(exchange.outstanding_of(|owner| owner == other), 2);
}

/// Number of owners of which something is kept.
fn owners(exchange: &Exchange) -> usize {
    let count = Cell::new(0);
    exchange.outstanding_of(|_| {
        count.set(count.get() + 1);
        false
    });
    count.get()
}

#[test]
fn nothing_is_kept_of_an_owner_that_has_ended_and_has_its_replies() {
    let mut exchange = Exchange::default();
    for number in 0..100 {
        let (owner, caller) = (Owner(2 * number), Owner(2 * number + 1));
        exchange.send(caller, Support::Everywhere, "a".into());
        exchange.post(owner, Support::Everywhere, "a", Instant::now());
        answer(&mut exchange, "a").expect("it is outstanding");
        assert_eq!(owners(&exchange), 1, "the caller has its reply");
        if number % 2 == 0 {
            answer(&mut exchange, "a").expect("it is outstanding");
            assert_eq!(owners(&exchange), 1, "it may post more");
            assert_eq!(exchange.abandon_posted(owner).1.accepted, 1);
        } else {
            assert_eq!(exchange.abandon_posted(owner).0, 1);
            assert_eq!(owners(&exchange), 1, "a reply is outstanding");
            answer(&mut exchange, "a").expect("it is outstanding");
        }
        assert_eq!(owners(&exchange), 0);
    }
}

#[test]
fn what_is_pending_for_no_waiter_is_dropped() {
    let mut exchange = Exchange::default();
    for drop in [Exchange::abandon, Exchange::discard_pending] {
        let a = send(&mut exchange, "a");
        answer(&mut exchange, "a").expect("it is outstanding");
        drop(&mut exchange, a);
        assert_eq!(pending(&mut exchange, a), None);
    }
    // A request that is still outstanding is not pending.
    let a = send(&mut exchange, "a");
    exchange.discard_pending(a);
    assert_eq!(answer(&mut exchange, "a").expect("it is outstanding").delivery, Delivery::Pending);
}

#[test]
fn what_is_out_of_sync_names_the_command() {
    let command = || "jog".to_owned();
    let told = [
        OutOfSync::Unsolicited { command: command() },
        OutOfSync::BeforeSent,
        OutOfSync::Nameless,
        OutOfSync::Ambiguous { command: command() },
    ];
    assert_eq!(
        told.map(|out_of_sync| out_of_sync.to_string()),
        [
            "a reply to `jog` came, but no such request is outstanding",
            "a reply came to a request before any of it was sent",
            "a reply came that names no command",
            "one of two replies to `jog` is lost, and it is not known which",
        ]
    );
}

/// Takes an hour if a step takes as long as there are outstanding commands.
#[test]
fn the_time_of_a_step_does_not_grow_with_what_is_outstanding() {
    const COUNT: usize = 500_000;
    let since = Instant::now();
    let mut exchange = Exchange::default();
    let send = |exchange: &mut Exchange| -> Vec<RequestId> {
        (0..COUNT).map(|_| exchange.send(OWNER, Support::Everywhere, "a".into())).collect()
    };
    let dropped = send(&mut exchange);
    for request in dropped {
        exchange.abandon(request);
    }
    let awaited = send(&mut exchange);
    for _ in 0..COUNT {
        exchange.post(OWNER, Support::Everywhere, "a", since);
    }
    let reply = named("a");
    for number in 0..3 * COUNT {
        let mut nobody = Waiter::nobody();
        let envelope = nobody.read(&reply).expect("the text is JSON");
        let received = exchange.receive(&reply, envelope, &mut nobody).expect("it is outstanding");
        let delivery = [Delivery::Discarded, Delivery::Pending, Delivery::Counted][number / COUNT];
        assert_eq!(received.map(|received| received.delivery), Some(delivery));
    }
    assert_eq!((exchange.outstanding(), exchange.posted_outstanding(OWNER)), (0, 0));
    assert_eq!(exchange.take_posted_outcomes(OWNER).accepted, COUNT as u64);
    let (mut text, mut reader) = (String::new(), TextOnly);
    for request in awaited {
        let mut waiter = Waiter::new(request, &mut text, &mut reader);
        exchange.take_pending(&mut waiter);
        assert_eq!(waiter.take_outcome(), Some(Ok(())));
    }
    assert!(since.elapsed() < Duration::from_secs(300), "{:?}", since.elapsed());
}

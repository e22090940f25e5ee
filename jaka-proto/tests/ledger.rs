//! Who may receive which reply.

use jaka_proto::{Envelope, Ledger, Mistrust, Ticket};

fn sent(ledger: &mut Ledger, command: &'static str) -> Ticket {
    ledger.sent(command.into())
}

#[test]
fn replies_in_order_settle_their_commands() {
    let mut ledger = Ledger::new();
    let (a, b) = (sent(&mut ledger, "a"), sent(&mut ledger, "b"));
    let first = ledger.arrived("a").expect("it is owed");
    assert_eq!((first.ticket, first.awaited, first.lost.len()), (a, true, 0));
    assert_eq!(ledger.arrived("b").expect("it is owed").ticket, b);
    assert_eq!(ledger.outstanding(), 0);
}

#[test]
fn a_reply_to_a_later_command_means_that_the_earlier_ones_are_lost() {
    let mut ledger = Ledger::new();
    let (a, b) = (sent(&mut ledger, "a"), sent(&mut ledger, "b"));
    let arrival = ledger.arrived("b").expect("it is owed");
    assert_eq!((arrival.ticket, arrival.lost), (b, vec![a]));
    assert_eq!(ledger.arrived("a"), Err(Mistrust::Unasked { command: "a".to_owned() }));
}

#[test]
fn a_late_reply_belongs_to_nobody() {
    let mut ledger = Ledger::new();
    let a = sent(&mut ledger, "a");
    ledger.give_up(a).expect("nothing has come");
    let b = sent(&mut ledger, "b");
    assert!(!ledger.awaits(a) && ledger.awaits(b));
    let late = ledger.arrived("a").expect("it is owed");
    assert_eq!((late.ticket, late.awaited), (a, false));
    assert_eq!(ledger.arrived("b").expect("it is owed").ticket, b);
}

#[test]
fn a_lost_reply_is_forgotten_when_a_later_command_is_answered() {
    let mut ledger = Ledger::new();
    let a = sent(&mut ledger, "a");
    ledger.give_up(a).expect("nothing has come");
    let b = sent(&mut ledger, "b");
    let arrival = ledger.arrived("b").expect("it is owed");
    assert_eq!((arrival.ticket, arrival.lost), (b, vec![]));
    assert_eq!(ledger.outstanding(), 0);
}

#[test]
fn with_equal_names_the_first_reply_settles_the_older_debt() {
    let mut ledger = Ledger::new();
    let older = sent(&mut ledger, "a");
    ledger.give_up(older).expect("nothing has come");
    let newer = sent(&mut ledger, "a");
    assert_eq!(ledger.arrived("a").expect("it is owed").ticket, older);
    assert_eq!(ledger.arrived("a").expect("it is owed").ticket, newer);
    // Both replies came: nothing is in doubt any more.
    let next = sent(&mut ledger, "a");
    assert_eq!(ledger.give_up(next), Ok(()));
}

#[test]
fn with_equal_names_a_second_reply_that_does_not_come_leaves_all_in_doubt() {
    let mut ledger = Ledger::new();
    let older = sent(&mut ledger, "a");
    ledger.give_up(older).expect("nothing has come");
    let newer = sent(&mut ledger, "a");
    ledger.arrived("a").expect("it is owed");
    assert_eq!(ledger.give_up(newer), Err(Mistrust::Ambiguous { command: "a".to_owned() }));
}

#[test]
fn a_command_sent_behind_a_doubtful_one_is_doubtful_too() {
    let mut ledger = Ledger::new();
    let older = sent(&mut ledger, "a");
    ledger.give_up(older).expect("nothing has come");
    sent(&mut ledger, "a");
    ledger.arrived("a").expect("it is owed");
    let third = sent(&mut ledger, "a");
    let other = sent(&mut ledger, "b");
    assert_eq!(ledger.give_up(other), Ok(()));
    assert!(ledger.give_up(third).is_err());
}

#[test]
fn when_nothing_at_all_came_a_second_timeout_leaves_nothing_in_doubt() {
    let mut ledger = Ledger::new();
    for _ in 0..3 {
        let ticket = sent(&mut ledger, "a");
        assert_eq!(ledger.give_up(ticket), Ok(()));
    }
    assert_eq!(ledger.outstanding(), 3);
}

#[test]
fn a_reply_nobody_is_owed() {
    let mut ledger = Ledger::new();
    assert_eq!(ledger.arrived("a"), Err(Mistrust::Unasked { command: "a".to_owned() }));
    sent(&mut ledger, "a");
    assert_eq!(ledger.arrived("b"), Err(Mistrust::Unasked { command: "b".to_owned() }));
    // The debt stands: whoever waits learns of the mistrust, not of a lost reply.
    assert_eq!(ledger.outstanding(), 1);
}

#[test]
fn a_nameless_refusal_is_the_reply_of_the_only_debtor() {
    let mut ledger = Ledger::new();
    assert_eq!(ledger.arrived_nameless(), Err(Mistrust::Nameless));
    let a = sent(&mut ledger, "a");
    assert_eq!(ledger.arrived_nameless().expect("only one is owed").ticket, a);
    sent(&mut ledger, "a");
    sent(&mut ledger, "b");
    assert_eq!(ledger.arrived_nameless(), Err(Mistrust::Nameless));
}

#[test]
fn a_reply_without_a_name_is_attributed_only_if_it_is_a_refusal() {
    let arrived = |ledger: &mut Ledger, json| {
        let envelope = Envelope::read(json).expect("it is an object");
        ledger.arrived_reply(Some(&envelope)).map(|arrival| arrival.ticket)
    };
    let mut ledger = Ledger::new();
    let a = sent(&mut ledger, "a");
    assert_eq!(arrived(&mut ledger, r#"{"errorCode": "0"}"#), Err(Mistrust::Nameless));
    assert_eq!(arrived(&mut ledger, r#"{"errorCode": "fine"}"#), Err(Mistrust::Nameless));
    assert_eq!(arrived(&mut ledger, r#"{"errorCode": "1"}"#), Ok(a));
    let b = sent(&mut ledger, "b");
    assert_eq!(arrived(&mut ledger, r#"{"errorCode": "0", "cmdName": " b"}"#), Ok(b));
}

#[test]
fn a_bare_tuple_is_the_reply_of_the_one_command_that_is_answered_so() {
    let mut ledger = Ledger::new();
    sent(&mut ledger, "a");
    assert!(matches!(ledger.arrived_reply(None), Err(Mistrust::Unasked { .. })));
    let status = sent(&mut ledger, "get_extio_status");
    assert_eq!(ledger.arrived_reply(None).expect("it is owed").ticket, status);
}

#[test]
fn mistrust_names_the_command() {
    let command = || "jog".to_owned();
    let told =
        [Mistrust::Unasked { command: command() }, Mistrust::Nameless, Mistrust::Ambiguous { command: command() }]
            .map(|mistrust| mistrust.to_string());
    assert_eq!(
        told,
        [
            "a reply to `jog` came that nobody is owed",
            "a reply came that names no command",
            "one of two replies to `jog` is lost, and it cannot be told which",
        ]
    );
}

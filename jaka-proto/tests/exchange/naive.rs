//! Random steps, each compared with the simplest account that does the same.

use std::time::{Duration, Instant};

use proptest::prelude::*;

use super::*;

/// Names of commands. Few, so that equal ones meet.
const NAMES: [&str; 3] = ["a", "b", "c"];

#[derive(Debug, Clone, Copy)]
enum Step {
    Send(usize),
    Post(usize),
    /// The newest request did not go out.
    Withdraw,
    /// A reply of this name, accepted or refused.
    Reply(usize, bool),
    Nameless,
    /// The deadline of one of the requests that are waited for passes.
    GiveUp(usize),
    GiveUpPosted,
    Abandon(usize),
    AbandonPosted,
}

fn any_step() -> impl Strategy<Value = Step> {
    (0u8..32, 0..NAMES.len(), any::<bool>()).prop_map(|(kind, which, accepted)| match kind {
        0..=7 => Step::Send(which),
        8..=12 => Step::Post(which),
        13 => Step::Withdraw,
        14..=23 => Step::Reply(which, accepted),
        24 => Step::Nameless,
        25..=27 => Step::GiveUp(which),
        28 => Step::GiveUpPosted,
        29 | 30 => Step::Abandon(which),
        _ => Step::AbandonPosted,
    })
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum For {
    Waiter,
    Count,
    Nobody,
}

#[derive(Debug, Clone, Copy)]
struct Sent {
    id: RequestId,
    name: &'static str,
    whose: For,
    doubtful: bool,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Outcome {
    Accepted,
    Refused,
    Lost,
    TimedOut,
}

/// Everything in lists that are searched from the front.
#[derive(Debug, Default)]
struct Naive {
    outstanding: Vec<Sent>,
    pending: Vec<(RequestId, Outcome)>,
    accepted: u64,
    failed: Vec<(&'static str, Outcome)>,
}

impl Naive {
    fn send(&mut self, id: RequestId, name: &'static str, whose: For) {
        let doubtful = self.outstanding.iter().any(|sent| sent.name == name && sent.doubtful);
        self.outstanding.push(Sent { id, name, whose, doubtful });
    }

    fn tell(&mut self, sent: Sent, outcome: Outcome) {
        match (sent.whose, outcome) {
            (For::Waiter, outcome) => self.pending.push((sent.id, outcome)),
            (For::Count, Outcome::Accepted) => self.accepted += 1,
            (For::Count, outcome) => self.failed.push((sent.name, outcome)),
            (For::Nobody, _) => {}
        }
    }

    /// The request that is completed.
    fn reply(&mut self, name: Option<&'static str>, outcome: Outcome) -> Option<RequestId> {
        let place = match name {
            Some(name) => self.outstanding.iter().position(|sent| sent.name == name)?,
            None if self.outstanding.len() == 1 => 0,
            None => return None,
        };
        let lost: Vec<_> = self.outstanding.drain(..place).collect();
        for sent in lost {
            self.tell(sent, Outcome::Lost);
        }
        let taker = self.outstanding.remove(0);
        if taker.whose == For::Nobody {
            for sent in self.outstanding.iter_mut().filter(|sent| sent.name == taker.name) {
                sent.doubtful = true;
            }
        }
        self.tell(taker, outcome);
        Some(taker.id)
    }

    fn give_up(&mut self, place: usize) -> bool {
        let sent = self.outstanding[place];
        if !sent.doubtful {
            self.outstanding[place].whose = For::Nobody;
            if sent.whose == For::Count {
                self.failed.push((sent.name, Outcome::TimedOut));
            }
        }
        !sent.doubtful
    }

    /// The place of one of the requests of this kind.
    fn find(&self, whose: For, which: usize) -> Option<usize> {
        (0..self.outstanding.len()).filter(|place| self.outstanding[*place].whose == whose).nth(which)
    }
}

fn outcome(failure: &Failure) -> Outcome {
    match failure {
        Failure::Refused(_) => Outcome::Refused,
        Failure::Lost => Outcome::Lost,
        Failure::TimedOut { .. } => Outcome::TimedOut,
        Failure::Unexpected(error) => panic!("{error}"),
    }
}

/// Does the step in both ways; false where the exchange is out of sync, which both must say.
fn take(step: Step, exchange: &mut Exchange, naive: &mut Naive, now: Instant) -> bool {
    match step {
        Step::Send(name) => naive.send(send(exchange, NAMES[name]), NAMES[name], For::Waiter),
        Step::Post(name) => naive.send(exchange.post(NAMES[name], now), NAMES[name], For::Count),
        Step::Withdraw => {
            // A request of which a reply has been given up was sent.
            if let Some(newest) = naive.outstanding.last().copied().filter(|newest| newest.whose != For::Nobody) {
                naive.outstanding.pop();
                assert_eq!(exchange.withdraw(newest.id), Ok(()));
            }
        }
        Step::Reply(name, accepted) => {
            let (code, said) = if accepted { (0, Outcome::Accepted) } else { (3, Outcome::Refused) };
            let text = format!(r#"{{"errorCode": "{code}", "cmdName": "{}"}}"#, NAMES[name]);
            return replied(receive(exchange, &text), naive.reply(Some(NAMES[name]), said));
        }
        Step::Nameless => {
            let text = r#"{"errorCode": "3"}"#;
            return replied(receive(exchange, text), naive.reply(None, Outcome::Refused));
        }
        Step::GiveUp(which) => {
            if let Some(place) = naive.find(For::Waiter, which) {
                let id = naive.outstanding[place].id;
                return both(exchange.give_up(id).is_ok(), naive.give_up(place));
            }
        }
        Step::GiveUpPosted => {
            let place = naive.find(For::Count, 0);
            let given_up = exchange.give_up_oldest_posted(Duration::ZERO).is_ok();
            return both(given_up, place.is_none_or(|place| naive.give_up(place)));
        }
        Step::Abandon(which) => {
            if let Some(place) = naive.find(For::Waiter, which) {
                naive.outstanding[place].whose = For::Nobody;
                exchange.abandon(naive.outstanding[place].id);
            }
        }
        Step::AbandonPosted => {
            let mut count = 0;
            for sent in naive.outstanding.iter_mut().filter(|sent| sent.whose == For::Count) {
                sent.whose = For::Nobody;
                count += 1;
            }
            assert_eq!(exchange.abandon_posted(), count);
        }
    }
    true
}

fn both(exchange: bool, naive: bool) -> bool {
    assert_eq!(exchange, naive);
    naive
}

fn replied(received: Result<Received, OutOfSync>, naive: Option<RequestId>) -> bool {
    assert_eq!(received.map(|received| received.request).ok(), naive);
    naive.is_some()
}

fn compare(exchange: &mut Exchange, naive: &Naive) {
    let posted = naive.outstanding.iter().filter(|sent| sent.whose == For::Count);
    assert_eq!(exchange.outstanding(), naive.outstanding.len());
    assert_eq!(exchange.posted_outstanding(), posted.clone().count());
    let oldest = posted.map(|sent| (sent.id, sent.name)).next();
    assert_eq!(exchange.oldest_posted().map(|oldest| (oldest.id, oldest.command)), oldest);
}

proptest! {
    #[test]
    fn the_exchange_does_as_the_simplest_account(steps in prop::collection::vec(any_step(), 0..60)) {
        let (mut exchange, mut naive, now) = (Exchange::default(), Naive::default(), Instant::now());
        for step in steps {
            if !take(step, &mut exchange, &mut naive, now) {
                break;
            }
            compare(&mut exchange, &naive);
        }
        // In the order of the last request first: each thread asks when it likes.
        for (request, expected) in naive.pending.iter().rev() {
            let found = pending(&mut exchange, *request).expect("it is pending");
            prop_assert_eq!(&found.map_or_else(|failure| outcome(&failure), |_| Outcome::Accepted), expected);
            prop_assert!(pending(&mut exchange, *request).is_none());
        }
        let outcomes = exchange.take_posted_outcomes();
        let failed: Vec<_> = outcomes.failed.iter().map(|(name, failure)| (*name, outcome(failure))).collect();
        prop_assert_eq!((outcomes.accepted, failed), (naive.accepted, naive.failed));
    }
}

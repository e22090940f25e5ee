//! The exchange without sockets, threads or a clock.

use std::time::{Duration, Instant};

use jaka_sync::proto::exchange::{
    Delivery, Exchange, Failure, OutOfSync, Owner, PostedOutcomes, RequestId, TextOnly, Waiter,
};
use proptest::prelude::*;

use crate::model::{Got, Model, NAMES, OWNERS, Recipient, TUPLE, support};
use crate::server::{Form, Message, Move, Server, any_move, number_in};

/// Liberties of a run other than sending, posting, answering late, losing replies, giving up and abandoning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Premise {
    /// Of each name, one command is waited for at a time: a client and its stop handles.
    OneOfAName,
    /// Several commands of a name are waited for at once: stop handles in several threads, servo set-points.
    SeveralOfAName,
    /// As the first, and replies come to no outstanding request: copies, and replies to what was not sent.
    Surplus,
}

#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    Send(usize),
    /// One of the owners posts a request.
    Post(usize, usize),
    /// The newest request did not go out.
    Withdraw,
    Server(Move),
    /// A waiter asks for the outcome of its request.
    Ask(usize),
    /// The deadline of one of the requests that are waited for passes.
    GiveUp(usize),
    GiveUpPosted(usize),
    /// A reply is not wanted any more, though there was time for it.
    Abandon(usize),
    AbandonPosted(usize),
}

pub(crate) fn any_step() -> impl Strategy<Value = Step> {
    (0u8..64, 0..NAMES.len(), 0..OWNERS, any_move()).prop_map(|(kind, which, owner, next)| match kind {
        0..=15 => Step::Send(which),
        16..=20 => Step::Post(which, owner),
        21 => Step::Withdraw,
        22..=45 => Step::Server(next),
        46..=50 => Step::Ask(which),
        51..=56 => Step::GiveUp(which),
        57..=58 => Step::GiveUpPosted(owner),
        59..=62 => Step::Abandon(which),
        _ => Step::AbandonPosted(owner),
    })
}

/// An exchange, and its model.
#[derive(Debug)]
struct Run {
    premise: Premise,
    exchange: Exchange,
    model: Model,
    server: Server,
    /// The requests by their numbers, from 1 on.
    ids: Vec<RequestId>,
    arrivals: usize,
    now: Instant,
}

/// Both say the same: the exchange goes on, or it is out of sync.
fn both(exchange: &Result<(), OutOfSync>, model: Result<(), OutOfSync>) -> Result<(), OutOfSync> {
    assert_eq!(*exchange, model);
    model
}

impl Run {
    fn take(&mut self, step: Step) -> Result<(), OutOfSync> {
        match step {
            Step::Send(name) => self.send(NAMES[name], Recipient::Waiter),
            Step::Post(name, owner) => self.send(NAMES[name], Recipient::Count(owner)),
            Step::Withdraw => self.withdraw()?,
            Step::Server(next) => self.answer(next)?,
            Step::Ask(which) => {
                if let Some(number) = self.of_a_waiter(which) {
                    self.ask(number);
                }
            }
            Step::GiveUp(which) => self.give_up(which)?,
            Step::GiveUpPosted(owner) => {
                let given_up = self.exchange.give_up_oldest_posted(owned(owner), Duration::ZERO);
                let place = self.model.places(Recipient::Count(owner)).next();
                both(&given_up, place.map_or(Ok(()), |place| self.model.give_up(place)))?;
            }
            Step::Abandon(which) => {
                if let Some(number) = self.of_a_waiter(which) {
                    self.exchange.abandon(self.id(number));
                    self.model.abandon(number);
                    self.ask(number);
                }
            }
            Step::AbandonPosted(owner) => {
                let (count, outcomes) = self.exchange.abandon_posted(owned(owner));
                assert_eq!(count, self.model.abandon_posted(owner));
                assert_eq!(outcomes_of(outcomes), self.model.take_posted(owner));
            }
        }
        self.compare();
        Ok(())
    }

    fn id(&self, number: u32) -> RequestId {
        self.ids[number as usize - 1]
    }

    fn send(&mut self, name: &'static str, recipient: Recipient) {
        if self.premise != Premise::SeveralOfAName && self.model.waits_for(name) {
            return;
        }
        let room = self.exchange.room(support(name), name);
        assert_eq!(room, self.model.room(name));
        if room == 0 {
            return;
        }
        self.ids.push(match recipient {
            Recipient::Count(owner) => self.exchange.post(owned(owner), support(name), name, self.now),
            _ => self.exchange.send(CALLER, support(name), name.into()),
        });
        let number = self.server.receive(name);
        self.model.send(number, name, recipient);
    }

    /// Withdraws the newest request, unless it was given up: then it was sent.
    fn withdraw(&mut self) -> Result<(), OutOfSync> {
        let Some(newest) = self.ids.last().copied() else { return Ok(()) };
        let number = u32::try_from(self.ids.len()).expect("a run is short");
        let place = self.model.outstanding.iter().position(|request| request.number == number);
        if place.is_some_and(|place| self.model.outstanding[place].recipient == Recipient::Nobody) {
            return Ok(());
        }
        both(&self.exchange.withdraw(newest), self.model.withdraw(number))?;
        self.server.withdraw();
        Ok(())
    }

    fn answer(&mut self, next: Move) -> Result<(), OutOfSync> {
        if next.is_surplus() && self.premise != Premise::Surplus || matches!(next, Move::Garbage | Move::End) {
            return Ok(());
        }
        let (written, lost) = self.server.make(next, self.model.outstanding.len());
        for (number, name) in lost {
            self.model.lose(number, name);
        }
        written.into_iter().try_for_each(|message| self.arrive(message))
    }

    /// A reply comes, and is read by one of the waiters, or by none.
    fn arrive(&mut self, message: Message) -> Result<(), OutOfSync> {
        let Message::Reply(reply) = message else { return Ok(()) };
        let text = message.to_string();
        self.arrivals += 1;
        let waiters: Vec<_> = self.model.places(Recipient::Waiter).collect();
        let reader = waiters.get(self.arrivals % 3).map(|place| self.model.outstanding[*place].number);
        let (mut got, mut only) = (String::new(), TextOnly);
        let mut waiter = reader.map_or_else(Waiter::nobody, |own| Waiter::new(self.id(own), &mut got, &mut only));
        let envelope = waiter.read(&text).expect("the server writes JSON and tuples");
        let received = self.exchange.receive(&text, envelope, &mut waiter);
        let outcome = waiter.take_outcome().map(|outcome| outcome_of(outcome, &got));
        let received = received.map(|received| received.map(|received| (received.request, received.delivery)));
        let completed = self.model.arrive(reply);
        let expected = completed.map(|completed| {
            completed.map(|(number, recipient)| {
                let delivery = match recipient {
                    Recipient::Waiter if reader == Some(number) => Delivery::Waiter,
                    Recipient::Waiter => Delivery::Pending,
                    Recipient::Count(_) => Delivery::Counted,
                    Recipient::Nobody => Delivery::Discarded,
                };
                (self.id(number), delivery)
            })
        });
        assert_eq!(received, expected, "{reply:?}");
        expected?;
        assert_eq!(outcome, reader.and_then(|reader| self.model.take(reader)), "{reply:?}");
        Ok(())
    }

    /// One of the requests for which a thread waits or an outcome is pending.
    fn of_a_waiter(&self, which: usize) -> Option<u32> {
        let outstanding = self.model.places(Recipient::Waiter).map(|place| self.model.outstanding[place].number);
        self.model.outcomes.iter().map(|(number, _)| *number).chain(outstanding).nth(which)
    }

    /// The outcome of a request is that of the model, and there is no second.
    fn ask(&mut self, number: u32) {
        for expected in [self.model.take(number), None] {
            let (mut got, mut only) = (String::new(), TextOnly);
            let mut waiter = Waiter::new(self.id(number), &mut got, &mut only);
            self.exchange.take_pending(&mut waiter);
            let outcome = waiter.take_outcome();
            assert_eq!(outcome.map(|outcome| outcome_of(outcome, &got)), expected);
        }
    }

    fn give_up(&mut self, which: usize) -> Result<(), OutOfSync> {
        let Some(place) = self.model.places(Recipient::Waiter).nth(which) else { return Ok(()) };
        let number = self.model.outstanding[place].number;
        self.ask(number);
        both(&self.exchange.give_up(self.id(number)), self.model.give_up(place))?;
        // The waiter has its outcome from the deadline.
        assert_eq!(self.model.take(number), Some(Got::TimedOut));
        Ok(())
    }

    fn compare(&self) {
        assert_eq!(self.exchange.outstanding(), self.model.outstanding.len());
        for owner in 0..OWNERS {
            let posted = self.exchange.posted_outstanding(owned(owner));
            assert_eq!(posted, self.model.places(Recipient::Count(owner)).count());
            let oldest = self.exchange.oldest_posted(owned(owner)).map(|oldest| (oldest.id, oldest.command));
            assert_eq!(oldest, self.model.oldest_posted(owner).map(|oldest| (self.id(oldest.number), oldest.name)));
        }
        // Each request is one of the caller's or of another owner.
        let of_others = self.exchange.outstanding_of(|owner| owner != CALLER);
        assert_eq!(self.exchange.outstanding_of(|owner| owner == CALLER) + of_others, self.model.outstanding.len());
    }

    /// All that is on its way comes; then all waiters ask, the last one first.
    fn finish(&mut self) {
        let rest = self.server.answer(usize::MAX, Form::Accepted);
        if rest.into_iter().try_for_each(|message| self.arrive(message)).is_ok() {
            self.model.assert_nothing_is_forgotten();
        }
    }

    fn ask_for_all(&mut self) {
        for number in (1..=self.ids.len()).rev() {
            self.ask(u32::try_from(number).expect("a run is short"));
        }
        for owner in 0..OWNERS {
            let outcomes = self.exchange.take_posted_outcomes(owned(owner));
            assert_eq!(outcomes_of(outcomes), self.model.take_posted(owner));
        }
    }
}

/// Owner of the requests that are waited for.
const CALLER: Owner = Owner(OWNERS as u64);

fn owned(owner: usize) -> Owner {
    Owner(owner as u64)
}

fn outcomes_of(outcomes: PostedOutcomes) -> (u64, Vec<(&'static str, Got)>) {
    let failed = outcomes.failed.into_iter().map(|(name, failure)| (name, outcome_of(Err(failure), "")));
    (outcomes.accepted, failed.collect())
}

fn outcome_of(outcome: Result<(), Failure>, text: &str) -> Got {
    match outcome {
        Ok(()) => Got::Accepted(number_in(text)),
        Err(Failure::Refused(refusal)) => Got::Refused(u32::try_from(refusal.code.0).expect("it is numbered")),
        Err(Failure::Lost) => Got::Lost,
        Err(Failure::TimedOut { .. }) => Got::TimedOut,
        Err(other) => panic!("no exchange may end with {other:?}"),
    }
}

pub(crate) fn run(premise: Premise, steps: &[Step]) {
    let mut run = Run {
        premise,
        exchange: Exchange::new(Some(TUPLE)),
        model: Model::default(),
        server: Server::default(),
        ids: Vec::new(),
        arrivals: 0,
        now: Instant::now(),
    };
    if steps.iter().try_for_each(|step| run.take(*step)).is_ok() {
        run.finish();
    }
    run.ask_for_all();
}

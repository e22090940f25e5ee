//! Who may receive which reply: random runs of the exchange, without I/O. The model knows whose each reply is, the exchange only
//! its name.

use std::collections::{HashSet, VecDeque};
use std::time::{Duration, Instant};

use jaka_proto::exchange::{Delivery, Exchange, Failure, OutOfSync, RequestId, TextOnly, Waiter};
use proptest::prelude::*;

/// Names of commands. Few, so that equal ones meet.
const NAMES: [&str; 3] = ["a", "b", "c"];

/// How many runs for each premise, times `JAKA_RELIABILITY`.
const RUNS: u32 = 34_000;

/// What a run may do other than sending, answering late, losing replies, giving up and dropping what is outstanding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Premise {
    /// Of each name, one command is waited for at a time: a client and its stop handles.
    OneOfAName,
    /// Several commands of a name are waited for at once: stop handles in several threads, servo set-points.
    SeveralOfAName,
    /// As the first, and replies come to no outstanding request: copies, and replies to what was not sent.
    Surplus,
}

#[derive(Debug, Clone, Copy)]
enum Step {
    Send(usize),
    /// The deadline of one of the commands that are waited for passes.
    GiveUp(usize),
    /// One of the commands that are waited for is waited for no longer, in good time: a pipeline is dropped.
    Abandon(usize),
    /// The reply to the oldest command that has none yet arrives: in time, or late.
    Deliver,
    /// It never will.
    Lose,
    /// It arrives as a refusal without a name.
    DeliverNameless,
    /// It arrives without a name and is not a refusal.
    DeliverAnonymous,
    /// A reply to no outstanding request, under this name.
    Surplus(usize),
    /// A refusal without a name, to no outstanding request.
    SurplusNameless,
}

fn any_step() -> impl Strategy<Value = Step> {
    (0u8..36, 0usize..NAMES.len()).prop_map(|(kind, which)| match kind {
        0..=11 => Step::Send(which),
        12..=15 => Step::GiveUp(which),
        32..=35 => Step::Abandon(which),
        16..=23 => Step::Deliver,
        24..=26 => Step::Lose,
        27 => Step::DeliverNameless,
        28 => Step::DeliverAnonymous,
        29 => Step::SurplusNameless,
        _ => Step::Surplus(which),
    })
}

/// What became of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Waiting,
    Reply,
    Lost,
    GaveUp,
}

/// Where the true reply to a command is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reply {
    OnItsWay,
    Delivered,
    Lost,
}

#[derive(Debug)]
struct Sent {
    name: usize,
    request: RequestId,
    outcome: Outcome,
    reply: Reply,
    /// A reply has completed it, or a later reply has shown that its own is lost.
    completed: bool,
}

/// A reply was attributed.
#[derive(Debug)]
struct Arrival {
    /// The request that it completes.
    request: RequestId,
    /// Whether its waiter was given the reply.
    awaited: bool,
    /// The requests whose waiters were told that their replies are lost.
    lost: Vec<RequestId>,
}

/// An exchange, and the truth about it.
#[derive(Debug)]
struct World {
    premise: Premise,
    exchange: Exchange,
    /// How many replies have come.
    arrivals: usize,
    sent: Vec<Sent>,
    on_their_way: VecDeque<usize>,
    /// Names of which a reply was given to no waiter.
    dropped: HashSet<usize>,
    /// Names of which a reply was lost.
    lost: HashSet<usize>,
    /// Names whose replies may be mistaken, since a surplus one came while a request of the name was outstanding.
    mistakable: HashSet<usize>,
}

/// The run is over: the connection is broken, and rightly so; or the exchange has done wrong.
enum End {
    Broken,
    Wrong(String),
}

type Progress = Result<(), End>;

fn holds(condition: bool, claim: impl FnOnce() -> String) -> Progress {
    if condition { Ok(()) } else { Err(End::Wrong(claim())) }
}

impl World {
    fn new(premise: Premise) -> Self {
        Self {
            premise,
            exchange: Exchange::default(),
            arrivals: 0,
            sent: Vec::new(),
            on_their_way: VecDeque::new(),
            dropped: HashSet::new(),
            lost: HashSet::new(),
            mistakable: HashSet::new(),
        }
    }

    fn take(&mut self, step: Step) -> Progress {
        match step {
            Step::Send(name) => {
                self.send(name);
                Ok(())
            }
            Step::GiveUp(which) => self.give_up(which),
            Step::Abandon(which) => {
                self.abandon(which);
                Ok(())
            }
            Step::Deliver => self.deliver(|name| named(NAMES[name])),
            Step::DeliverNameless => self.deliver(|_| nameless("1")),
            Step::DeliverAnonymous => self.deliver(|_| nameless("0")),
            Step::Lose => {
                self.lose();
                Ok(())
            }
            Step::Surplus(name) => self.surplus(&named(NAMES[name])),
            Step::SurplusNameless => self.surplus(&nameless("1")),
        }
    }

    fn send(&mut self, name: usize) {
        let waits = |sent: &Sent| sent.name == name && sent.outcome == Outcome::Waiting;
        if self.premise != Premise::SeveralOfAName && self.sent.iter().any(waits) {
            return;
        }
        let request = self.exchange.send(NAMES[name].into());
        self.on_their_way.push_back(self.sent.len());
        let (outcome, reply) = (Outcome::Waiting, Reply::OnItsWay);
        self.sent.push(Sent { name, request, outcome, reply, completed: false });
    }

    fn lose(&mut self) {
        if let Some(serial) = self.on_their_way.pop_front() {
            self.sent[serial].reply = Reply::Lost;
            self.lost.insert(self.sent[serial].name);
        }
    }

    fn waiting(&self, which: usize) -> Option<usize> {
        (0..self.sent.len()).filter(|place| self.sent[*place].outcome == Outcome::Waiting).nth(which)
    }

    /// Nothing is missed: it cannot break the connection. What its reply, or the lack of it, does to others is the exchange's to know.
    fn abandon(&mut self, which: usize) {
        if let Some(place) = self.waiting(which) {
            self.sent[place].outcome = Outcome::GaveUp;
            self.exchange.abandon(self.sent[place].request);
        }
    }

    /// A call that ends without a reply must not leave the next one to its own reply.
    fn give_up(&mut self, which: usize) -> Progress {
        let Some(place) = self.waiting(which) else { return Ok(()) };
        let mistakable = self.is_mistakable(self.sent[place].name);
        let sent = &mut self.sent[place];
        let has_come = sent.reply == Reply::Delivered;
        sent.outcome = Outcome::GaveUp;
        match self.exchange.give_up(sent.request) {
            Ok(()) => {
                let sent = format!("{sent:?}");
                holds(!has_come || mistakable, || format!("the reply to {sent} has come and is not missed"))
            }
            Err(OutOfSync::Ambiguous { .. }) => {
                holds(self.dropped.contains(&sent.name), || format!("nothing makes {sent:?} doubtful"))?;
                Err(End::Broken)
            }
            Err(other) => Err(End::Wrong(format!("giving up {sent:?} led to {other:?}"))),
        }
    }

    /// The reply to the oldest command arrives.
    fn deliver(&mut self, text: impl FnOnce(usize) -> String) -> Progress {
        let Some(serial) = self.on_their_way.pop_front() else { return Ok(()) };
        self.sent[serial].reply = Reply::Delivered;
        let text = text(self.sent[serial].name);
        match self.arrive(&text) {
            Ok(arrival) => self.complete(&arrival, Some(serial)),
            Err(out_of_sync) => {
                let outstanding = self.outstanding().count();
                let right = match out_of_sync {
                    OutOfSync::Nameless => !text.contains("cmdName") && (outstanding != 1 || !text.contains("\"1\"")),
                    OutOfSync::Unsolicited { .. } => self.is_mistakable(self.sent[serial].name),
                    _ => false,
                };
                holds(right, || format!("the reply to {:?} led to {out_of_sync:?}", self.sent[serial]))?;
                Err(End::Broken)
            }
        }
    }

    /// A reply to no outstanding request arrives: where it can be told, the connection must be broken.
    fn surplus(&mut self, text: &str) -> Progress {
        if self.premise != Premise::Surplus {
            return Ok(());
        }
        let name = NAMES.iter().position(|name| *text == named(name));
        let takers = self.outstanding().filter(|sent| name.is_none_or(|name| sent.name == name)).count();
        let undetectable = if name.is_some() { takers > 0 } else { takers == 1 };
        match self.arrive(text) {
            Ok(arrival) => {
                holds(undetectable, || format!("{arrival:?} was taken from a surplus reply"))?;
                self.complete(&arrival, None)
            }
            Err(out_of_sync) => {
                holds(!undetectable, || format!("{text} led to {out_of_sync:?}"))?;
                Err(End::Broken)
            }
        }
    }

    /// A reply arrives, and is read by one of the waiters, or by none. Then all ask for the outcomes of their commands.
    fn arrive(&mut self, text: &str) -> Result<Arrival, OutOfSync> {
        self.arrivals += 1;
        let reader = self.waiting(self.arrivals % 3).map(|place| self.sent[place].request);
        let (mut got, mut only) = (String::new(), TextOnly);
        let mut waiter = reader.map_or_else(Waiter::nobody, |own| Waiter::new(own, &mut got, &mut only));
        let envelope = waiter.read(text).expect("the text is JSON");
        let received = self.exchange.receive(text, envelope, &mut waiter)?;
        let mut outcomes = vec![(reader, waiter.take_outcome(), got)];
        for sent in &self.sent {
            let mut got = String::new();
            let mut waiter = Waiter::new(sent.request, &mut got, &mut only);
            self.exchange.take_pending(&mut waiter);
            outcomes.push((Some(sent.request), waiter.take_outcome(), got));
        }
        let mut arrival = Arrival { request: received.request, awaited: false, lost: Vec::new() };
        for (request, outcome, got) in outcomes {
            match (request, outcome) {
                (_, None) => {}
                (Some(request), Some(Err(Failure::Lost))) => arrival.lost.push(request),
                (request, Some(_)) => {
                    assert_eq!((request, &*got, arrival.awaited), (Some(received.request), text, false));
                    arrival.awaited = true;
                }
            }
        }
        let expected = match (arrival.awaited, reader == Some(received.request)) {
            (true, true) => Delivery::Waiter,
            (true, false) => Delivery::Pending,
            (false, _) => Delivery::Discarded,
        };
        assert_eq!(received.delivery, expected);
        Ok(arrival)
    }

    fn outstanding(&self) -> impl Iterator<Item = &Sent> {
        self.sent.iter().filter(|sent| !sent.completed)
    }

    /// The exchange gives a reply, the true one of `serial` if of any, to a command.
    fn complete(&mut self, arrival: &Arrival, serial: Option<usize>) -> Progress {
        let taker = self.sent.iter().position(|sent| sent.request == arrival.request);
        let taker = taker.ok_or_else(|| End::Wrong(format!("{arrival:?} completes what was never sent")))?;
        holds(!self.sent[taker].completed, || format!("{arrival:?} completes it for the second time"))?;
        let mistaken = |serial: usize| {
            let names = [self.sent[serial].name, self.sent[taker].name];
            serial != taker && names.iter().any(|name| self.mistakable.contains(name))
        };
        if serial.is_none_or(mistaken) {
            // A mistake spreads to what is written off by it.
            self.mistakable.extend(self.sent[..=taker].iter().filter(|sent| !sent.completed).map(|sent| sent.name));
        }
        for place in 0..taker {
            self.write_off(place, arrival)?;
        }
        self.sent[taker].completed = true;
        let expected = if arrival.awaited { Outcome::Waiting } else { Outcome::GaveUp };
        holds(self.sent[taker].outcome == expected, || format!("{arrival:?}, but {:?}", self.sent[taker]))?;
        if !arrival.awaited {
            self.dropped.insert(self.sent[taker].name);
            return Ok(());
        }
        self.sent[taker].outcome = Outcome::Reply;
        let mistakable = self.is_mistakable(self.sent[taker].name);
        holds(serial == Some(taker) || mistakable, || format!("the reply to {serial:?} was given to {taker}"))
    }

    /// A command before the one that was answered: its reply must be lost, and its waiter must learn that.
    fn write_off(&mut self, place: usize, arrival: &Arrival) -> Progress {
        let mistakable = self.is_mistakable(self.sent[place].name);
        let sent = &mut self.sent[place];
        let told = arrival.lost.contains(&sent.request);
        if sent.completed {
            return holds(!told, || format!("{arrival:?} loses what was completed: {sent:?}"));
        }
        sent.completed = true;
        holds(told == (sent.outcome == Outcome::Waiting), || format!("{arrival:?} does not tell {sent:?}"))?;
        if told {
            sent.outcome = Outcome::Lost;
        }
        // What has come completed an older request of its name.
        let gone = sent.reply == Reply::Lost || self.lost.contains(&sent.name);
        holds(gone || mistakable, || format!("{arrival:?} loses what is on its way: {sent:?}"))
    }

    /// The two cases in which a name does not tell whose a reply is.
    fn is_mistakable(&self, name: usize) -> bool {
        let one_of_several_is_lost = self.premise == Premise::SeveralOfAName && self.lost.contains(&name);
        one_of_several_is_lost || self.mistakable.contains(&name)
    }

    /// All that is on its way arrives; then there must be no wait without a reason.
    fn finish(&mut self) -> Progress {
        while !self.on_their_way.is_empty() {
            self.deliver(|name| named(NAMES[name]))?;
        }
        let without_reason = |sent: &&Sent| {
            let excused = self.lost.contains(&sent.name) || self.mistakable.contains(&sent.name);
            sent.outcome == Outcome::Waiting && !excused
        };
        let forgotten = self.sent.iter().find(without_reason);
        holds(forgotten.is_none(), || format!("all replies have come, but {forgotten:?}"))
    }
}

fn named(name: &str) -> String {
    format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{name}"}}"#)
}

fn nameless(code: &str) -> String {
    format!(r#"{{"errorCode": "{code}", "errorMsg": ""}}"#)
}

fn run(premise: Premise, steps: &[Step]) -> Result<(), String> {
    let mut world = World::new(premise);
    let end = steps.iter().try_for_each(|step| world.take(*step)).and_then(|()| world.finish());
    match end {
        Ok(()) | Err(End::Broken) => Ok(()),
        Err(End::Wrong(claim)) => Err(format!("{claim}\n{world:#?}")),
    }
}

fn check(premise: Premise) {
    let config = ProptestConfig {
        cases: RUNS * jaka_tests::reliability_times(),
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let steps = proptest::collection::vec(any_step(), 0..40);
    let checked = proptest::test_runner::TestRunner::new(config)
        .run(&steps, |steps| run(premise, &steps).map_err(TestCaseError::fail));
    checked.unwrap_or_else(|error| panic!("{premise:?}: {error}"));
}

#[test]
fn with_one_command_of_a_name_every_reply_is_given_to_its_own_command() {
    check(Premise::OneOfAName);
}

#[test]
fn with_several_commands_of_a_name_a_lost_reply_alone_can_be_mistaken() {
    check(Premise::SeveralOfAName);
}

#[test]
fn a_surplus_reply_is_noticed_unless_a_request_of_its_name_is_outstanding() {
    check(Premise::Surplus);
}

/// Where a step took as long as there are outstanding commands, this would take an hour.
#[test]
fn the_time_of_a_step_does_not_grow_with_what_is_outstanding() {
    const COUNT: usize = 500_000;
    let since = Instant::now();
    let mut exchange = Exchange::default();
    let send = |exchange: &mut Exchange| -> Vec<RequestId> { (0..COUNT).map(|_| exchange.send("a".into())).collect() };
    let dropped = send(&mut exchange);
    for request in dropped {
        exchange.abandon(request);
    }
    let awaited = send(&mut exchange);
    for _ in 0..COUNT {
        exchange.post("a", since);
    }
    let reply = named("a");
    for number in 0..3 * COUNT {
        let mut nobody = Waiter::nobody();
        let envelope = nobody.read(&reply).expect("the text is JSON");
        let delivery = exchange.receive(&reply, envelope, &mut nobody).expect("it is outstanding").delivery;
        assert_eq!(delivery, [Delivery::Discarded, Delivery::Pending, Delivery::Counted][number / COUNT]);
    }
    assert_eq!((exchange.outstanding(), exchange.posted_outstanding()), (0, 0));
    assert_eq!(exchange.take_posted_outcomes().accepted, COUNT as u64);
    let (mut text, mut reader) = (String::new(), TextOnly);
    for request in awaited {
        let mut waiter = Waiter::new(request, &mut text, &mut reader);
        exchange.take_pending(&mut waiter);
        assert_eq!(waiter.take_outcome(), Some(Ok(())));
    }
    assert!(since.elapsed() < Duration::from_secs(300), "{:?}", since.elapsed());
}

//! Who may receive which reply: random runs of the ledger, without I/O. The model knows whose each reply is, the ledger only
//! its name.

use std::collections::{HashSet, VecDeque};
use std::time::{Duration, Instant};

use jaka_proto::{Arrival, Envelope, Ledger, Mistrust, Ticket};
use proptest::prelude::*;

/// Names of commands. Few, so that equal ones meet.
const NAMES: [&str; 3] = ["a", "b", "c"];

/// How many runs for each premise, times `JAKA_RELIABILITY`.
const RUNS: u32 = 34_000;

/// What a run may do beside sending, answering late, losing replies, giving up and dropping what is outstanding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Premise {
    /// Of each name, one command is waited for at a time: a client and its stop handles.
    OneOfAName,
    /// Several commands of a name are waited for at once: stop handles in several threads, servo set-points.
    SeveralOfAName,
    /// As the first, and replies come that nobody is owed: copies, and replies to what was not sent.
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
    /// It arrives without a name and is no refusal.
    DeliverAnonymous,
    /// A reply that nobody is owed, under this name.
    Surplus(usize),
    /// A refusal without a name that nobody is owed.
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
    ticket: Ticket,
    outcome: Outcome,
    reply: Reply,
    /// A reply has settled its debt, or a later reply has written it off.
    settled: bool,
}

/// A ledger, and the truth about it.
#[derive(Debug)]
struct World {
    premise: Premise,
    ledger: Ledger,
    sent: Vec<Sent>,
    on_their_way: VecDeque<usize>,
    /// Names of which a reply was given to nobody.
    dropped: HashSet<usize>,
    /// Names of which a reply was lost.
    lost: HashSet<usize>,
    /// Names whose replies may be mistaken, since one that nobody was owed came while one was.
    mistakable: HashSet<usize>,
}

/// The run is over: the connection is broken, and rightly so; or the ledger has done wrong.
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
            ledger: Ledger::new(),
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
        let ticket = self.ledger.sent(NAMES[name].into());
        self.on_their_way.push_back(self.sent.len());
        let (outcome, reply) = (Outcome::Waiting, Reply::OnItsWay);
        self.sent.push(Sent { name, ticket, outcome, reply, settled: false });
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

    /// Nothing is missed: it cannot break the connection. What its reply, or the lack of it, does to others is the ledger's to know.
    fn abandon(&mut self, which: usize) {
        if let Some(place) = self.waiting(which) {
            self.sent[place].outcome = Outcome::GaveUp;
            self.ledger.abandon(self.sent[place].ticket);
        }
    }

    /// A call that ends without a reply must not leave the next one to its own reply.
    fn give_up(&mut self, which: usize) -> Progress {
        let Some(place) = self.waiting(which) else { return Ok(()) };
        let mistakable = self.is_mistakable(self.sent[place].name);
        let sent = &mut self.sent[place];
        let has_come = sent.reply == Reply::Delivered;
        sent.outcome = Outcome::GaveUp;
        match self.ledger.give_up(sent.ticket) {
            Ok(()) => {
                let sent = format!("{sent:?}");
                holds(!has_come || mistakable, || format!("the reply to {sent} has come and is not missed"))
            }
            Err(Mistrust::Ambiguous { .. }) => {
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
            Ok(arrival) => self.settle(&arrival, Some(serial)),
            Err(mistrust) => {
                let owed = self.owed().count();
                let right = match mistrust {
                    Mistrust::Nameless => !text.contains("cmdName") && (owed != 1 || !text.contains("\"1\"")),
                    Mistrust::Unasked { .. } => self.is_mistakable(self.sent[serial].name),
                    _ => false,
                };
                holds(right, || format!("the reply to {:?} led to {mistrust:?}", self.sent[serial]))?;
                Err(End::Broken)
            }
        }
    }

    /// A reply arrives that nobody is owed: where it can be told, the connection must be broken.
    fn surplus(&mut self, text: &str) -> Progress {
        if self.premise != Premise::Surplus {
            return Ok(());
        }
        let name = NAMES.iter().position(|name| *text == named(name));
        let takers = self.owed().filter(|sent| name.is_none_or(|name| sent.name == name)).count();
        let undetectable = if name.is_some() { takers > 0 } else { takers == 1 };
        match self.arrive(text) {
            Ok(arrival) => {
                holds(undetectable, || format!("{arrival:?} was taken from a reply that nobody is owed"))?;
                self.settle(&arrival, None)
            }
            Err(mistrust) => {
                holds(!undetectable, || format!("{text} led to {mistrust:?}"))?;
                Err(End::Broken)
            }
        }
    }

    fn arrive(&mut self, text: &str) -> Result<Arrival, Mistrust> {
        let envelope = Envelope::read(text).expect("the text is JSON");
        self.ledger.arrived_reply(Some(&envelope))
    }

    fn owed(&self) -> impl Iterator<Item = &Sent> {
        self.sent.iter().filter(|sent| !sent.settled)
    }

    /// The ledger gives a reply, the true one of `serial` if of any, to a command.
    fn settle(&mut self, arrival: &Arrival, serial: Option<usize>) -> Progress {
        let taker = self.sent.iter().position(|sent| sent.ticket == arrival.ticket);
        let taker = taker.ok_or_else(|| End::Wrong(format!("{arrival:?} settles what was never sent")))?;
        holds(!self.sent[taker].settled, || format!("{arrival:?} settles for the second time"))?;
        let mistaken = |serial: usize| {
            let names = [self.sent[serial].name, self.sent[taker].name];
            serial != taker && names.iter().any(|name| self.mistakable.contains(name))
        };
        if serial.is_none_or(mistaken) {
            // A mistake spreads to what is written off by it.
            self.mistakable.extend(self.sent[..=taker].iter().filter(|sent| !sent.settled).map(|sent| sent.name));
        }
        for place in 0..taker {
            self.write_off(place, arrival)?;
        }
        self.sent[taker].settled = true;
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

    /// A command before the one that was answered: its reply must be lost, and whoever waits for it must learn it.
    fn write_off(&mut self, place: usize, arrival: &Arrival) -> Progress {
        let mistakable = self.is_mistakable(self.sent[place].name);
        let sent = &mut self.sent[place];
        let told = arrival.lost.contains(&sent.ticket);
        if sent.settled {
            return holds(!told, || format!("{arrival:?} loses what was settled: {sent:?}"));
        }
        sent.settled = true;
        holds(told == (sent.outcome == Outcome::Waiting), || format!("{arrival:?} does not tell {sent:?}"))?;
        if told {
            sent.outcome = Outcome::Lost;
        }
        // What has come settled an older debt of its name.
        let gone = sent.reply == Reply::Lost || self.lost.contains(&sent.name);
        holds(gone || mistakable, || format!("{arrival:?} loses what is on its way: {sent:?}"))
    }

    /// The two cases in which a name does not tell whose a reply is.
    fn is_mistakable(&self, name: usize) -> bool {
        let one_of_several_is_lost = self.premise == Premise::SeveralOfAName && self.lost.contains(&name);
        one_of_several_is_lost || self.mistakable.contains(&name)
    }

    /// All that is on its way arrives; then nobody may wait without reason.
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
fn a_reply_that_nobody_is_owed_is_noticed_unless_one_of_its_name_is_owed() {
    check(Premise::Surplus);
}

/// Where a step took as long as there are outstanding commands, this would take an hour.
#[test]
fn the_time_of_a_step_does_not_grow_with_what_is_outstanding() {
    const COUNT: usize = 500_000;
    let since = Instant::now();
    let mut ledger = Ledger::new();
    let send = |ledger: &mut Ledger| -> Vec<Ticket> { (0..COUNT).map(|_| ledger.sent("a".into())).collect() };
    let dropped = send(&mut ledger);
    for ticket in dropped {
        ledger.abandon(ticket);
    }
    let awaited = send(&mut ledger);
    assert!(awaited.iter().all(|ticket| ledger.awaits(*ticket)));
    for number in 0..2 * COUNT {
        let arrival = ledger.arrived("a").expect("it is owed");
        assert_eq!((arrival.awaited, arrival.lost.len()), (number >= COUNT, 0));
    }
    assert_eq!(ledger.outstanding(), 0);
    assert!(since.elapsed() < Duration::from_secs(300), "{:?}", since.elapsed());
}

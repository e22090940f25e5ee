//! A client and two stop handles, each in a thread of its own, against a server whose every step the test decides.

use std::collections::VecDeque;
use std::io::{Read, Write};
use std::net::Shutdown;
use std::time::{Duration, Instant};

use jaka_proto::framing::Framer;
use jaka_sim::SimulatedClock;
use jaka_sim::jaka_clock::Stream;
use jaka_sync::{Client, Config};
use proptest::prelude::*;

use crate::model::{Got, Model, NAMES, PAUSE, Recipient, STOP};
use crate::server::{Form, Message, Move, Server, any_move};
use crate::workers::{Order, Workers};

/// A thread: the client's own, or one with a stop handle.
pub(crate) type Actor = usize;
pub(crate) const CLIENT: Actor = 0;
const STOPS: [Actor; 2] = [1, 2];

/// Recipient of the replies to a pipeline's commands.
const PIPELINE: Recipient = Recipient::Count(0);

/// Time that goes on after a step: then all has happened that the step leads to.
const MOMENT: Duration = Duration::from_nanos(2);

/// Reply timeout of stop handles and pipelines, and the timeouts of calls. They are odd, and steps begin at even times,
/// so that nothing happens at the moment of a deadline. No two deadlines meet: see [`Run::keep_apart`].
const TIMEOUT: Duration = Duration::from_nanos(1_000_211_001);
pub(crate) const SHORT: Duration = Duration::from_nanos(100_003_001);
const LONG: Duration = Duration::from_nanos(10_007_717_001);

#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    /// A call that waits for a short or a long time.
    Call(usize, Duration),
    Stop(usize),
    /// A query and a stop at the same time, from two threads.
    CallAndStop(usize),
    /// Commands in a pipeline, which begins with the first of them.
    Post(&'static str, usize),
    /// The pipeline is finished.
    Finish,
    /// It is dropped.
    Drop,
    /// Time goes on to the next deadline.
    Pass,
    Server(Move),
}

pub(crate) fn any_step() -> impl Strategy<Value = Step> {
    (0u8..64, 0..NAMES.len(), 0..STOPS.len(), any_move()).prop_map(|(kind, name, handle, next)| match kind {
        0..=8 => Step::Call(name, SHORT),
        9..=12 => Step::Call(name, LONG),
        13..=20 => Step::Stop(handle),
        21..=23 => Step::CallAndStop(handle),
        24..=29 => Step::Post([PAUSE, STOP][name % 2], 1 + handle),
        30..=32 => Step::Finish,
        33 => Step::Drop,
        34..=39 => Step::Pass,
        _ => Step::Server(next),
    })
}

/// End of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Got(Got),
    /// All commands of a pipeline have been answered: so many were accepted.
    Finished(u64),
    /// The connection broke while the call waited.
    Broken,
    /// The connection was broken before, and nothing was sent.
    NotSent,
}

/// The client as it should be: the exchange, and what has come of the connection's bytes.
#[derive(Debug, Default)]
struct Connection {
    exchange: Model,
    /// Messages that the client has read and not attributed, and those that it has not read.
    read: VecDeque<Message>,
    unread: VecDeque<Message>,
    is_broken: bool,
    /// The calls that wait: their numbers and deadlines.
    calls: [Option<(u32, Instant)>; 3],
    /// The deadlines of posted requests.
    posted: Vec<(u32, Instant)>,
    has_pipeline: bool,
    is_finishing: bool,
    ended: Vec<(Actor, End)>,
}

impl Connection {
    fn is_busy(&self, actor: Actor) -> bool {
        self.calls[actor].is_some() || actor == CLIENT && self.has_pipeline
    }

    fn is_waited_for(&self) -> bool {
        self.is_finishing || self.calls.iter().any(Option::is_some)
    }

    /// Attributes what was read, before a command goes out: none of it is a reply to that. False if the connection is
    /// broken.
    fn may_send(&mut self, actor: Actor) -> bool {
        self.attribute_read();
        if self.is_broken {
            self.ended.push((actor, End::NotSent));
        }
        !self.is_broken
    }

    /// A call's command has gone out.
    fn begin(&mut self, actor: Actor, number: u32, name: &'static str, deadline: Instant) {
        self.exchange.send(number, name, Recipient::Waiter);
        self.calls[actor] = Some((number, deadline));
        self.look();
    }

    fn post(&mut self, number: u32, name: &'static str, deadline: Instant) {
        self.exchange.send(number, name, PIPELINE);
        self.posted.push((number, deadline));
    }

    /// The pipeline waits for its replies.
    fn finish(&mut self, now: Instant) {
        (self.has_pipeline, self.is_finishing) = (false, true);
        if self.oldest_posted().is_none() {
            // There is nothing to wait for, also if the connection is broken.
            return self.end_finishing(None);
        }
        self.pass(now);
        self.look();
        self.ask_for_end();
    }

    fn drop_pipeline(&mut self) {
        self.has_pipeline = false;
        if !self.is_broken {
            self.read_once();
            self.attribute_read();
        }
        self.exchange.abandon_posted(0);
        self.exchange.take_posted(0);
    }

    fn write(&mut self, messages: &[Message]) {
        self.unread.extend(messages);
        self.look();
    }

    fn oldest_posted(&self) -> Option<Instant> {
        let oldest = self.exchange.oldest_posted(0)?;
        self.posted.iter().find(|(number, _)| *number == oldest.number).map(|(_, deadline)| *deadline)
    }

    /// The first deadline of those that wait.
    fn next_deadline(&self) -> Option<Instant> {
        let calls = self.calls.iter().flatten().map(|(_, deadline)| *deadline);
        calls.chain(self.oldest_posted().filter(|_| self.is_finishing)).min()
    }

    /// True if a deadline would come in the same moment as another one, so that the threads would decide which is
    /// first.
    fn meets(&self, deadline: Instant) -> bool {
        let calls = self.calls.iter().flatten().map(|(_, other)| *other);
        let apart = |other: Instant| other.max(deadline).duration_since(other.min(deadline));
        calls.chain(self.posted.iter().map(|(_, other)| *other)).any(|other| apart(other) <= MOMENT * 4)
    }

    /// It is this time: those whose deadlines have passed give up.
    fn pass(&mut self, now: Instant) {
        while self.is_finishing && self.oldest_posted().is_some_and(|deadline| deadline <= now) {
            let oldest = self.exchange.places(PIPELINE).next();
            self.give_up(oldest);
            if self.is_broken {
                break;
            }
        }
        for call in self.calls.into_iter().flatten().filter(|(_, deadline)| *deadline <= now) {
            let place = self.exchange.outstanding.iter().position(|request| request.number == call.0);
            self.give_up(place);
        }
        self.ask_for_end();
    }

    fn give_up(&mut self, place: Option<usize>) {
        if place.is_some_and(|place| self.exchange.give_up(place).is_err()) {
            self.break_off();
        }
        self.end_calls();
    }

    /// While somebody waits, all that has come is read and attributed.
    fn look(&mut self) {
        while self.is_waited_for() && !self.is_broken {
            if self.read.is_empty() {
                self.read_once();
            }
            let Some(message) = self.read.pop_front() else { break };
            self.arrive(message);
            if self.is_finishing {
                // It looks at all that it has read before it asks whether it has all replies.
                self.attribute_read();
            }
            self.ask_for_end();
        }
    }

    /// The end is found by a read of its own.
    fn read_once(&mut self) {
        let end = self.unread.iter().position(|message| *message == Message::End);
        let count = end.map_or(self.unread.len(), |place| place.max(1));
        self.read.extend(self.unread.drain(..count));
    }

    fn attribute_read(&mut self) {
        while let Some(message) = self.read.pop_front() {
            self.arrive(message);
        }
    }

    fn arrive(&mut self, message: Message) {
        let is_attributed = match message {
            Message::Reply(reply) => self.exchange.arrive(reply).is_ok(),
            Message::Garbage | Message::End => false,
        };
        if !is_attributed {
            self.break_off();
        }
        self.end_calls();
    }

    /// The calls whose outcomes are known end.
    fn end_calls(&mut self) {
        for actor in [CLIENT, STOPS[0], STOPS[1]] {
            let got = self.calls[actor].and_then(|(number, _)| self.exchange.take(number));
            if let Some(got) = got {
                self.calls[actor] = None;
                self.ended.push((actor, End::Got(got)));
            }
        }
    }

    /// The pipeline ends once nothing is outstanding of it, or the connection is broken.
    fn ask_for_end(&mut self) {
        let is_answered = self.oldest_posted().is_none();
        if self.is_finishing && (is_answered || self.is_broken) {
            self.end_finishing(self.is_broken.then_some(End::Broken));
        }
    }

    fn end_finishing(&mut self, failure: Option<End>) {
        self.is_finishing = false;
        let (accepted, failed) = self.exchange.take_posted(0);
        let first = failed.first().map(|(_, got)| End::Got(*got));
        self.ended.push((CLIENT, first.or(failure).unwrap_or(End::Finished(accepted))));
        self.drop_pipeline();
    }

    fn break_off(&mut self) {
        self.is_broken = true;
        // What was answered before has its outcome.
        self.end_calls();
        for actor in [CLIENT, STOPS[0], STOPS[1]] {
            if self.calls[actor].take().is_some() {
                self.ended.push((actor, End::Broken));
            }
        }
        self.read.clear();
        self.unread.clear();
    }
}

/// The server's side, the threads, and the model.
struct Run {
    clock: SimulatedClock,
    model: Connection,
    workers: Workers,
    stream: Stream,
    framer: Framer,
    server: Server,
}

impl Run {
    fn new() -> Self {
        let clock = SimulatedClock::new();
        let listener = clock.bind("127.0.0.1:0".parse().expect("an address")).expect("loopback has free ports");
        let client = Client::connect_with(&Config::new().clock(&clock).reply_timeout(TIMEOUT), listener.local_addr());
        let client = client.expect("it listens");
        let mut stream = listener.accept().expect("the client has connected");
        stream.set_timeout(Some(Duration::ZERO));
        let workers = Workers::new(&clock, client);
        let (model, server, framer) = (Connection::default(), Server::default(), Framer::default());
        Self { clock, model, workers, stream, framer, server }
    }

    fn take(&mut self, step: Step) -> Result<(), String> {
        match step {
            Step::Call(name, timeout) => self.call(CLIENT, NAMES[name], timeout),
            Step::Stop(handle) => self.call(STOPS[handle], STOP, TIMEOUT),
            Step::CallAndStop(handle) => self.call_and_stop(STOPS[handle]),
            Step::Post(name, count) => self.post(name, count),
            // The thread that finishes and others that wait could each be the one that reads, which looks at more.
            Step::Finish if !self.model.has_pipeline || self.model.is_waited_for() => Ok(()),
            Step::Finish => {
                self.workers.order(CLIENT, Order::Finish);
                self.model.finish(self.clock.now());
                self.settle(&[])
            }
            Step::Drop if !self.model.has_pipeline => Ok(()),
            Step::Drop => {
                self.workers.order(CLIENT, Order::Drop);
                self.model.drop_pipeline();
                self.settle(&[])
            }
            Step::Pass => {
                let Some(deadline) = self.model.next_deadline() else { return Ok(()) };
                self.clock.sleep_until(deadline + MOMENT / 2);
                self.settle(&[])
            }
            Step::Server(next) => self.make(next),
        }
    }

    fn call(&mut self, actor: Actor, name: &'static str, timeout: Duration) -> Result<(), String> {
        if self.model.is_busy(actor) || self.model.is_finishing || self.model.exchange.room(name) == 0 {
            return Ok(());
        }
        self.keep_apart(&[timeout])?;
        self.order(actor, name, timeout);
        if !self.model.may_send(actor) {
            return self.settle(&[]);
        }
        let number = self.server.receive(name);
        self.model.begin(actor, number, name, self.clock.now() + timeout);
        self.settle(&[name])
    }

    /// Lets time go on until the deadlines of commands with these timeouts meet no other: those after other sums of
    /// timeouts may.
    fn keep_apart(&mut self, timeouts: &[Duration]) -> Result<(), String> {
        while timeouts.iter().any(|timeout| self.model.meets(self.clock.now() + *timeout)) {
            self.settle(&[])?;
        }
        Ok(())
    }

    fn order(&self, actor: Actor, name: &'static str, timeout: Duration) {
        let order = if actor == CLIENT { Order::Call { name, timeout } } else { Order::Stop };
        self.workers.order(actor, order);
    }

    /// Two threads send at the same time: the wire says which was first.
    fn call_and_stop(&mut self, stop: Actor) -> Result<(), String> {
        let model = &self.model;
        let has_more = !model.read.is_empty() || !model.unread.is_empty();
        let has_room = model.exchange.room(NAMES[0]) > 0;
        if model.is_busy(CLIENT)
            || model.is_busy(stop)
            || model.is_finishing
            || model.is_broken
            || has_more
            || !has_room
        {
            return Ok(());
        }
        self.keep_apart(&[LONG, TIMEOUT])?;
        let (name, now) = (NAMES[0], self.clock.now());
        self.order(CLIENT, name, LONG);
        self.order(stop, STOP, TIMEOUT);
        self.clock.sleep(MOMENT);
        let received = self.received()?;
        for request in &received {
            let (actor, name, timeout) =
                if request.contains(STOP) { (stop, STOP, TIMEOUT) } else { (CLIENT, name, LONG) };
            let number = self.server.receive(name);
            self.model.begin(actor, number, name, now + timeout);
        }
        if received.len() != 2 {
            return Err(format!("{received:?} were sent, of two: {:?}", self.model));
        }
        self.settle(&[])
    }

    fn post(&mut self, name: &'static str, count: usize) -> Result<(), String> {
        if self.model.calls[CLIENT].is_some() || self.model.is_finishing || self.model.exchange.room(name) < count {
            return Ok(());
        }
        self.keep_apart(&[TIMEOUT])?;
        self.workers.order(CLIENT, Order::Post { name, count });
        self.model.has_pipeline = true;
        // A stop goes out whatever has failed before it; others first tell what has been read, and are not sent.
        if let Some(got) = (name != STOP).then(|| self.model.exchange.tell_posted(0)).flatten() {
            self.model.ended.push((CLIENT, End::Got(got)));
            return self.settle(&[]);
        }
        if !self.model.may_send(CLIENT) {
            return self.settle(&[]);
        }
        for _ in 0..count {
            let number = self.server.receive(name);
            self.model.post(number, name, self.clock.now() + TIMEOUT);
        }
        self.settle(&vec![name; count])
    }

    fn make(&mut self, next: Move) -> Result<(), String> {
        // One read takes in one write, so that it makes no difference when the system delivers each.
        if self.model.is_broken || !self.model.unread.is_empty() && next != Move::End {
            return Ok(());
        }
        // While nobody waits, the client may send more before it reads.
        let outstanding = if self.model.is_waited_for() { self.model.exchange.outstanding.len() } else { 0 };
        let (written, lost) = self.server.make(next, outstanding);
        for (number, name) in lost {
            self.model.exchange.lose(number, name);
        }
        self.write(&written)
    }

    /// Writes in one piece.
    fn write(&mut self, messages: &[Message]) -> Result<(), String> {
        if self.model.is_broken || messages.is_empty() {
            return Ok(());
        }
        if messages.contains(&Message::End) {
            self.stream.shutdown(Shutdown::Write).expect("the connection is open");
        } else {
            let text: String = messages.iter().map(ToString::to_string).collect();
            let written = self.stream.write_all(text.as_bytes());
            written.map_err(|error| format!("the client does not take {text}: {error}"))?;
        }
        self.model.write(messages);
        self.settle(&[])
    }

    /// Has all happen that the step leads to: these commands were sent, and no other; and each call has ended of which
    /// the model says so, in the way that it says, and no other.
    fn settle(&mut self, sent: &[&str]) -> Result<(), String> {
        self.clock.sleep(MOMENT);
        self.model.pass(self.clock.now());
        let received = self.received()?;
        let is_sent = received.len() == sent.len() && received.iter().zip(sent).all(|(text, name)| text.contains(name));
        if !is_sent {
            let ended = self.workers.take_ended();
            return Err(format!("{received:?} were sent in place of {sent:?}, {ended:?}: {:?}", self.model));
        }
        let (mut expected, mut ended) = (std::mem::take(&mut self.model.ended), self.workers.take_ended());
        expected.sort_by_key(|(actor, _)| *actor);
        ended.sort_by_key(|(actor, _)| *actor);
        if ended == expected { Ok(()) } else { Err(format!("{ended:?} in place of {expected:?}: {:?}", self.model)) }
    }

    /// The requests that have come by now.
    fn received(&mut self) -> Result<Vec<String>, String> {
        let mut requests = Vec::new();
        loop {
            while let Some(request) = self.framer.next_frame().map_err(|error| error.to_string())? {
                requests.push(String::from_utf8_lossy(request).into_owned());
            }
            match self.stream.read(self.framer.spare()) {
                // The end, a reset, or no more for now.
                Ok(0) | Err(_) => return Ok(requests),
                Ok(count) => self.framer.filled(count),
            }
        }
    }

    /// All answers come, and then the connection ends: now every call has ended, and nothing more is sent.
    fn finish(mut self) -> Result<(), String> {
        self.take(Step::Finish)?;
        // What was written before is read first.
        self.call(STOPS[0], STOP, TIMEOUT)?;
        let replies = self.server.answer(usize::MAX, Form::Accepted);
        self.write(&replies)?;
        if !self.model.is_broken && self.model.read.is_empty() && self.model.unread.is_empty() {
            self.model.exchange.assert_nothing_is_forgotten();
        }
        self.take(Step::Server(Move::End))?;
        self.take(Step::Finish)?;
        for actor in [CLIENT, STOPS[0], STOPS[1], CLIENT] {
            self.call(actor, STOP, TIMEOUT)?;
        }
        assert!(self.model.is_broken && !self.model.is_waited_for(), "nobody waits on a connection that has ended");
        self.workers.join();
        Ok(())
    }
}

pub(crate) fn run(steps: &[Step]) -> Result<(), String> {
    let mut run = Run::new();
    steps.iter().try_for_each(|step| run.take(*step))?;
    run.finish()
}

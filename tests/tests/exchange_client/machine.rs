//! The same runs without sockets and threads: the exchange alone against the model.

use std::collections::VecDeque;

use jaka_sync::proto::exchange::{Delivery, Exchange, Failure, RequestId, TextOnly, Waiter};

use crate::model::{Actor, Got, Message, Model, STOP};
use crate::server::Server;
use crate::step::{CLIENT, Handles, NAMES, STOPS, Step};

/// A client without a socket: what a connection does with its exchange.
#[derive(Debug, Default)]
struct Machine {
    exchange: Exchange,
    /// What each actor waits for.
    waiting: [Option<RequestId>; 3],
    /// What has been read and not attributed, and what has not been read.
    read: VecDeque<Message>,
    unread: VecDeque<Message>,
    is_broken: bool,
    ended: Vec<(Actor, Got)>,
    dropped: u32,
    arrivals: usize,
}

impl Machine {
    fn send(&mut self, actor: Actor, name: &'static str) {
        while let Some(message) = self.read.pop_front() {
            self.arrive(message);
        }
        if self.is_broken {
            self.ended.push((actor, Got::NotSent));
            return;
        }
        self.waiting[actor] = Some(self.exchange.send(name.into()));
        self.look();
    }

    fn give_up(&mut self, actor: Actor) {
        let Some(request) = self.waiting[actor] else { return };
        match self.exchange.give_up(request) {
            Ok(()) => self.end(actor, Got::Timeout),
            Err(_) => self.break_off(),
        }
    }

    fn write(&mut self, messages: &[Message]) {
        self.unread.extend(messages);
        self.look();
    }

    /// As long as somebody waits, what has come is read and attributed.
    fn look(&mut self) {
        while self.waiting.iter().any(Option::is_some) {
            if self.read.is_empty() {
                let end = self.unread.iter().position(|message| *message == Message::End);
                let count = end.map_or(self.unread.len(), |place| place.max(1));
                self.read.extend(self.unread.drain(..count));
            }
            let Some(message) = self.read.pop_front() else { break };
            self.arrive(message);
        }
    }

    fn arrive(&mut self, message: Message) {
        if matches!(message, Message::Garbage | Message::End) {
            return self.break_off();
        }
        let text = message.to_string();
        // Another thread reads each time.
        self.arrivals += 1;
        let actors: Vec<Actor> = (0..3).filter(|actor| self.waiting[*actor].is_some()).collect();
        let reader = actors.get(self.arrivals % 3).copied();
        let own = reader.and_then(|actor| self.waiting[actor]);
        let (mut got, mut only) = (String::new(), TextOnly);
        let mut waiter = own.map_or_else(Waiter::nobody, |own| Waiter::new(own, &mut got, &mut only));
        let envelope = waiter.read(&text).expect("the server writes JSON");
        let Ok(received) = self.exchange.receive(&text, envelope, &mut waiter) else { return self.break_off() };
        self.dropped += u32::from(received.delivery == Delivery::Discarded);
        let outcome = waiter.take_outcome();
        if let (Some(actor), Some(outcome)) = (reader, outcome) {
            self.end(actor, end(outcome, &got));
        }
        for actor in actors {
            self.ask(actor);
        }
    }

    /// An actor asks what became of its request.
    fn ask(&mut self, actor: Actor) {
        let Some(request) = self.waiting[actor] else { return };
        let (mut got, mut only) = (String::new(), TextOnly);
        let mut waiter = Waiter::new(request, &mut got, &mut only);
        self.exchange.take_pending(&mut waiter);
        if let Some(outcome) = waiter.take_outcome() {
            self.end(actor, end(outcome, &got));
        }
    }

    fn end(&mut self, actor: Actor, got: Got) {
        self.waiting[actor] = None;
        self.ended.push((actor, got));
    }

    fn break_off(&mut self) {
        self.is_broken = true;
        for actor in 0..3 {
            if self.waiting[actor].is_some() {
                self.end(actor, Got::Broken);
            }
        }
        self.read.clear();
        self.unread.clear();
    }
}

/// A refusal shows whose it is by its code.
fn end(outcome: Result<(), Failure>, text: &str) -> Got {
    match outcome {
        Ok(()) => {
            let reply: serde_json::Value = serde_json::from_str(text).expect("the server writes JSON");
            Got::Reply(reply["number"].as_u64().and_then(|number| u32::try_from(number).ok()).expect("it is numbered"))
        }
        Err(Failure::Refused(refusal)) => Got::Reply(u32::try_from(refusal.code.0).expect("it is numbered")),
        Err(Failure::Lost) => Got::Lost,
        Err(other) => panic!("no exchange may end with {other:?}"),
    }
}

/// The server, the model and the machine.
struct Run {
    model: Model,
    machine: Machine,
    handles: Handles,
    server: Server,
}

impl Run {
    fn take(&mut self, step: Step) {
        match step {
            Step::Call(name) => self.begin(CLIENT, NAMES[name]),
            Step::CallInVain(name) => self.call_in_vain(CLIENT, NAMES[name]),
            Step::Stop(handle) if self.handles == Handles::Hasty => self.call_in_vain(STOPS[handle], STOP),
            Step::Stop(handle) => self.begin(STOPS[handle], STOP),
            Step::CallAndStop(name, handle) => {
                self.begin(CLIENT, NAMES[name]);
                self.begin(STOPS[handle], STOP);
            }
            Step::Lose => {
                if let Some(name) = self.server.lose() {
                    self.model.lose(name);
                }
            }
            step => {
                let messages = self.server.write(step);
                self.write(&messages);
            }
        }
    }

    fn begin(&mut self, actor: Actor, name: &'static str) {
        if self.model.waits(actor) {
            return;
        }
        if self.model.send(actor, name, self.server.next_number()) {
            self.server.receive(name);
        }
        self.machine.send(actor, name);
    }

    fn call_in_vain(&mut self, actor: Actor, name: &'static str) {
        if !self.model.waits(actor) {
            self.begin(actor, name);
            self.model.give_up(actor);
            self.machine.give_up(actor);
        }
    }

    fn write(&mut self, messages: &[Message]) {
        if self.model.is_broken || messages.is_empty() {
            return;
        }
        self.model.write(messages);
        self.machine.write(messages);
    }

    /// Each call has ended of which the model says so, in the way that it says, and no other.
    fn compare(&mut self) -> Result<(), String> {
        let mut expected = std::mem::take(&mut self.model.ended);
        let mut ended = std::mem::take(&mut self.machine.ended);
        expected.sort_by_key(|(actor, _)| *actor);
        ended.sort_by_key(|(actor, _)| *actor);
        let same = ended == expected
            && self.machine.is_broken == self.model.is_broken
            && self.machine.dropped == self.model.dropped;
        if same {
            Ok(())
        } else {
            Err(format!("{ended:?}, and not {expected:?}: {:#?} {:#?}", self.machine, self.model))
        }
    }
}

pub(crate) fn run(handles: Handles, steps: &[Step]) -> Result<(), String> {
    let mut run = Run { model: Model::default(), machine: Machine::default(), handles, server: Server::default() };
    for step in steps {
        run.take(*step);
        run.compare()?;
    }
    let replies = run.server.answer_all();
    run.write(&replies);
    run.take(Step::End);
    run.begin(CLIENT, NAMES[0]);
    run.compare()
}

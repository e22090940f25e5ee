//! One run: the server's moves, and the calls of the threads.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::time::Duration;

use jaka_proto::framing::Framer;
use jaka_sync::Config;

use crate::drops::Drops;
use crate::model::{Actor, Got, Message, Model, STOP};
use crate::server::Server;
use crate::step::{CLIENT, Handles, NAMES, STOPS, Step};
use crate::workers::{Order, Worker, got};

/// How long a call waits that is not to wait in vain.
const PATIENCE: Duration = Duration::from_secs(20);

/// How long a call waits that is.
const HASTE: Duration = Duration::from_millis(2);

/// The server's side, and the model.
struct Run {
    model: Model,
    workers: Vec<Worker>,
    handles: Handles,
    stream: TcpStream,
    framer: Framer,
    server: Server,
    drops: Drops,
}

impl Run {
    fn new(handles: Handles) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let address = listener.local_addr().expect("it is bound");
        let timeout = if handles == Handles::Hasty { HASTE } else { PATIENCE };
        let client = Config::new().reply_timeout(timeout).connect_client(address).expect("it listens");
        let (stream, _) = listener.accept().expect("the client has connected");
        stream.set_read_timeout(Some(PATIENCE)).expect("the time is not zero");
        let stops = STOPS.map(|_| Worker::of_stop_handle(client.stop_handle()));
        let workers = [Worker::of_client(client)].into_iter().chain(stops).collect();
        let (model, server, framer) = (Model::default(), Server::default(), Framer::default());
        Self { model, workers, handles, stream, framer, server, drops: Drops::from_now() }
    }

    fn take(&mut self, step: Step) -> Result<(), String> {
        match step {
            Step::Call(name) => self.begin(CLIENT, NAMES[name])?,
            Step::CallInVain(name) => self.call_in_vain(CLIENT, NAMES[name])?,
            Step::Stop(handle) if self.handles == Handles::Hasty => self.call_in_vain(STOPS[handle], STOP)?,
            Step::Stop(handle) => self.begin(STOPS[handle], STOP)?,
            Step::CallAndStop(name, handle) => self.call_and_stop(NAMES[name], STOPS[handle]),
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
        self.check_ends()
    }

    /// A call begins, and the server receives it.
    fn begin(&mut self, actor: Actor, name: &'static str) -> Result<(), String> {
        if self.model.waits(actor) {
            return Ok(());
        }
        self.order(actor, name, PATIENCE);
        if self.model.send(actor, name, self.server.next_number()) {
            self.receive(name);
        }
        self.check_ends()
    }

    /// A call ends at its deadline, with what has been waiting for it, or before that is read.
    fn call_in_vain(&mut self, actor: Actor, name: &'static str) -> Result<(), String> {
        if self.model.waits(actor) {
            return Ok(());
        }
        let mut in_haste = self.model.clone();
        self.order(actor, name, HASTE);
        let end = self.end_of(actor)?;
        if end == Got::NotSentInTime {
            // On a busy machine the deadline can come before anything is sent.
            self.model.send_nothing(actor);
            return self.check_ends();
        }
        if self.model.send(actor, name, self.server.next_number()) {
            let number = self.receive(name);
            self.model.give_up(actor);
            in_haste.send_only(actor, name, number);
            in_haste.give_up(actor);
        }
        if !self.model.ended.contains(&(actor, end)) {
            // Or before what is waiting is read.
            self.model = in_haste;
        }
        self.check(actor, end)?;
        self.check_ends()
    }

    /// Two threads send at the same time: the wire says which was first.
    fn call_and_stop(&mut self, name: &'static str, stop: Actor) {
        let is_busy = self.model.waits(CLIENT) || self.model.waits(stop);
        if is_busy || self.handles == Handles::Hasty || self.model.is_broken || self.model.has_more() {
            return;
        }
        self.order(CLIENT, name, PATIENCE);
        self.order(stop, STOP, PATIENCE);
        for _ in 0..2 {
            let received = self.next_request();
            let (actor, name) = if received.contains(STOP) { (stop, STOP) } else { (CLIENT, name) };
            let number = self.server.receive(name);
            self.model.send(actor, name, number);
        }
    }

    fn order(&self, actor: Actor, name: &'static str, timeout: Duration) {
        let order = if actor == CLIENT { Order::Call { name, timeout } } else { Order::Stop };
        self.workers[actor].orders.send(order).expect("the thread waits for orders");
    }

    fn receive(&mut self, name: &'static str) -> u32 {
        let request = self.next_request();
        assert!(request.contains(name), "{request} in place of {name}");
        self.server.receive(name)
    }

    fn next_request(&mut self) -> String {
        loop {
            if let Some(request) = self.framer.next_frame().expect("clients send requests") {
                return String::from_utf8_lossy(request).into_owned();
            }
            let count = self.stream.read(self.framer.spare()).expect("the client sends a request");
            assert!(count > 0, "the client has closed the connection");
            self.framer.filled(count);
        }
    }

    /// Writes at once, unless the connection is broken.
    fn write(&mut self, messages: &[Message]) {
        if self.model.is_broken || messages.is_empty() {
            return;
        }
        let text: String = messages.iter().map(ToString::to_string).collect();
        self.stream.write_all(text.as_bytes()).expect("the client's system takes bytes");
        if messages.contains(&Message::End) {
            self.stream.shutdown(Shutdown::Write).expect("the connection is open");
        }
        self.model.write(messages);
    }

    /// Each call has ended of which the model says so, and in the way that it says.
    fn check_ends(&mut self) -> Result<(), String> {
        while let Some((actor, _)) = self.model.ended.first().copied() {
            let end = self.end_of(actor)?;
            self.check(actor, end)?;
        }
        let has_come = self.drops.wait_for(self.model.dropped, PATIENCE);
        if has_come { Ok(()) } else { Err(format!("a late reply is not dropped: {:?}", self.model)) }
    }

    fn end_of(&self, actor: Actor) -> Result<Got, String> {
        let result = self.workers[actor].results.recv_timeout(PATIENCE);
        result.map(got).map_err(|_| format!("the call of {actor} does not end: {:?}", self.model))
    }

    fn check(&mut self, actor: Actor, end: Got) -> Result<(), String> {
        let place = self.model.ended.iter().position(|(other, _)| *other == actor);
        let expected = place.map(|place| self.model.ended.remove(place).1);
        if expected == Some(end) {
            return Ok(());
        }
        Err(format!("the call of {actor} ended with {end:?}, and not {expected:?}: {:?}", self.model))
    }

    /// All answers come, and then the connection ends: now every call has ended, and nothing more is sent.
    fn finish(mut self) -> Result<(), String> {
        let replies = self.server.answer_all();
        self.write(&replies);
        self.check_ends()?;
        self.take(Step::End)?;
        self.begin(CLIENT, NAMES[0])?;
        self.check_ends()?;
        assert!(!self.model.is_waited_for(), "nobody waits on a connection that has ended");
        for actor in [CLIENT, STOPS[0], STOPS[1]] {
            self.begin(actor, STOP)?;
        }
        for worker in self.workers.drain(..) {
            drop(worker.orders);
            worker.thread.join().expect("no call panics");
        }
        let mut rest = Vec::new();
        self.stream.read_to_end(&mut rest).map_err(|error| error.to_string())?;
        let sent = [self.framer.partial(), &rest].concat();
        if sent.is_empty() { Ok(()) } else { Err(format!("sent after the end: {}", String::from_utf8_lossy(&sent))) }
    }
}

pub(crate) fn run(handles: Handles, steps: &[Step]) -> Result<(), String> {
    let mut run = Run::new(handles);
    steps.iter().try_for_each(|step| run.take(*step))?;
    run.finish()
}

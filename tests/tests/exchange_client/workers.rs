//! Threads that call, in the time of a simulated clock.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_sim::SimulatedClock;
use jaka_sim::jaka_clock::{Clock, Signal, lock};
use jaka_sync::program::{PauseProgram, StopProgram};
use jaka_sync::{Client, Error, ErrorKind, Pipeline, StopHandle};

use crate::client::{Actor, CLIENT, End};
use crate::model::{Got, PAUSE};
use crate::server::number_in;

/// Task of a thread.
#[derive(Debug)]
pub(crate) enum Order {
    Call {
        name: &'static str,
        timeout: Duration,
    },
    Stop,
    /// Posts so many commands of a name in a pipeline, which lasts until it is finished or dropped.
    Post {
        name: &'static str,
        count: usize,
    },
    Finish,
    Drop,
}

/// State that the threads share.
#[derive(Debug)]
struct Shared {
    state: Mutex<State>,
    changed: Signal,
}

#[derive(Debug, Default)]
struct State {
    orders: [VecDeque<Order>; 3],
    are_closed: bool,
    ended: Vec<(Actor, End)>,
}

impl Shared {
    /// Waits for the next order; none once there will be none.
    fn next(&self, actor: Actor) -> Option<Order> {
        let is_ready = |state: &State| !state.orders[actor].is_empty() || state.are_closed;
        self.changed.wait_until(&self.state, Duration::MAX, is_ready).orders[actor].pop_front()
    }

    fn end(&self, actor: Actor, end: End) {
        lock(&self.state).ended.push((actor, end));
    }

    fn change(&self, act: impl FnOnce(&mut State)) {
        act(&mut lock(&self.state));
        self.changed.notify_all();
    }
}

/// A client's thread, and threads with its stop handles. They end when this is dropped.
#[derive(Debug)]
pub(crate) struct Workers {
    shared: Arc<Shared>,
    threads: Vec<JoinHandle<()>>,
}

impl Workers {
    pub(crate) fn new(clock: &SimulatedClock, client: Client) -> Self {
        let shared = Arc::new(Shared { state: Mutex::default(), changed: Signal::new(&Clock::simulated(clock)) });
        let stops = [1, 2].map(|actor| {
            let (shared, stop) = (Arc::clone(&shared), client.stop_handle());
            start(clock, move || stop_whenever_told(&shared, actor, &stop))
        });
        let theirs = Arc::clone(&shared);
        let calling = start(clock, move || call_whenever_told(&theirs, client));
        Self { shared, threads: stops.into_iter().chain([calling]).collect() }
    }

    pub(crate) fn order(&self, actor: Actor, order: Order) {
        self.shared.change(|state| state.orders[actor].push_back(order));
    }

    /// Takes the ends of calls since this was last asked.
    pub(crate) fn take_ended(&self) -> Vec<(Actor, End)> {
        std::mem::take(&mut lock(&self.shared.state).ended)
    }

    /// Waits for the ends of the threads.
    ///
    /// # Panics
    /// One of them did.
    pub(crate) fn join(mut self) {
        self.close();
        for thread in self.threads.drain(..) {
            self.shared.changed.clock().outside(|| thread.join()).expect("no call panics");
        }
    }

    fn close(&self) {
        self.shared.change(|state| state.are_closed = true);
    }
}

impl Drop for Workers {
    fn drop(&mut self) {
        self.close();
    }
}

fn start(clock: &SimulatedClock, act: impl FnOnce() + Send + 'static) -> JoinHandle<()> {
    let place = clock.participant();
    thread::spawn(move || place.run(act))
}

fn stop_whenever_told(shared: &Shared, actor: Actor, stop: &StopHandle) {
    while shared.next(actor).is_some() {
        shared.end(actor, end_of(stop.stop().map(|()| 0)));
    }
}

fn call_whenever_told(shared: &Shared, mut client: Client) {
    while let Some(order) = shared.next(CLIENT) {
        match order {
            Order::Call { name, timeout } => {
                let request = format!(r#"{{"cmdName": "{name}"}}"#);
                shared.end(CLIENT, end_of(client.call_text(&request, timeout).map(number_in)));
            }
            Order::Stop => shared.end(CLIENT, end_of(client.stop_handle().stop().map(|()| 0))),
            Order::Post { name, count } => post_whenever_told(shared, client.pipeline(256), name, count),
            Order::Finish | Order::Drop => unreachable!("there is no pipeline"),
        }
    }
}

fn post_whenever_told(shared: &Shared, mut pipeline: Pipeline<'_>, name: &'static str, count: usize) {
    let mut order = Some(Order::Post { name, count });
    while let Some(Order::Post { name, count }) = order {
        let posted = match name {
            PAUSE => pipeline.send_all(&vec![PauseProgram::new(); count]),
            _ => pipeline.send_all(&vec![StopProgram::new(); count]),
        };
        if let Err(error) = posted {
            shared.end(CLIENT, end_of(Err(error)));
        }
        order = shared.next(CLIENT);
    }
    if matches!(order, Some(Order::Finish)) {
        let end = pipeline.finish().map_or_else(|error| end_of(Err(error)), End::Finished);
        shared.end(CLIENT, end);
    }
}

/// A refusal shows whose it is by its code.
fn end_of(result: Result<u32, Error>) -> End {
    End::Got(match result.map_err(Error::into_kind) {
        Ok(number) => Got::Accepted(number),
        Err(ErrorKind::Refused { refusal, .. }) => {
            Got::Refused(u32::try_from(refusal.code.0).expect("the server numbers its replies"))
        }
        Err(ErrorKind::Timeout { .. }) => Got::TimedOut,
        Err(ErrorKind::ReplyLost { .. }) => Got::Lost,
        Err(ErrorKind::Disconnected { sent: true, .. }) => return End::Broken,
        Err(ErrorKind::Disconnected { sent: false, .. }) => return End::NotSent,
        Err(other) => panic!("no exchange may end with {other:?}"),
    })
}

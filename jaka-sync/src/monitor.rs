//! A thread that keeps the newest status packet.

mod observer;
mod statistics;
mod subscription;
mod thread;

#[cfg(all(test, shuttle))]
mod interleavings;

use std::any::Any;
use std::fmt::Display;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

use jaka_clock::{Clock, Socket};
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::recording::Port;
use jaka_proto::wire::{Decode, DecodeError};

use self::observer::Observers;
pub use self::observer::StatusNews;
use self::statistics::Counters;
pub use self::statistics::MonitorStatistics;
pub use self::subscription::Subscription;
use self::subscription::{Items, Queue};
use crate::packets::Packets;
use crate::recorder::Tap;
use crate::sync::{MutexGuard, Watched};
use crate::{Config, Disconnect, Error, ErrorKind, Snapshot, StatusProblem};

/// Keeps the newest status packet of a controller. A thread reads port 10000 all the time, and wakes the threads that
/// wait for a state.
///
/// `S` is the type that each packet is decoded to: the whole [`RobotStatus`], or a smaller type, made by
/// [`status_subset!`](crate::status_subset) or with your own [`Decode`], so that unused fields are not decoded.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_sync::Monitor;
///
/// let monitor = Monitor::connect("10.5.5.100")?;
/// let powered = monitor.wait_until(|status| status.powered_on == Some(true), Duration::from_secs(30))?;
/// println!("powered, {:?} ago", powered.age());
/// # Ok::<(), jaka_sync::Error>(())
/// ```
///
/// The reader never falls behind: packets that come faster than they are used are dropped, and the newest is kept.
/// Several monitors can be connected to one controller. Dropping the monitor ends its connection and waits for its
/// thread, which takes up to [`Config::connect_timeout`] while the thread reconnects.
#[derive(Debug)]
#[must_use = "dropping a monitor ends its connection and its thread"]
pub struct Monitor<S = RobotStatus> {
    board: Arc<Board<S>>,
    clock: Clock,
    thread: Option<JoinHandle<()>>,
    timeout: Duration,
    stale_after: Duration,
}

/// State that the thread and the monitor share.
///
/// For the order of locks see [`Link`](crate::link::Link): a thread that holds `state` must not take the link's.
type Board<S> = Watched<BoardState<S>>;

#[derive(Debug)]
struct BoardState<S> {
    latest: Option<Arc<Snapshot<S>>>,
    counters: Counters,
    queues: Vec<Arc<Queue<S>>>,
    observers: Observers<S>,
    /// Cause of the end of the connection. No packet comes after it.
    ended: Option<Arc<Disconnect>>,
    /// Error of the newest packet, until a packet can be decoded.
    unfit: Option<DecodeError>,
    /// The connection, for the monitor to end it.
    stream: Option<Arc<Socket>>,
    tap: Tap,
    closing: bool,
    /// True while the connection is lost and the thread reconnects.
    reconnecting: bool,
    /// Number of times that waiting threads were told to check again.
    wakes: u64,
}

impl<S> BoardState<S> {
    fn new(stream: Option<Arc<Socket>>, tap: Tap) -> Self {
        Self {
            latest: None,
            counters: Counters::default(),
            queues: Vec::new(),
            observers: Observers::default(),
            ended: None,
            unfit: None,
            stream,
            tap,
            closing: false,
            reconnecting: false,
            wakes: 0,
        }
    }
}

impl<S> Board<S> {
    /// Wakes the threads that wait, to check again.
    fn tell(&self, mut state: MutexGuard<'_, BoardState<S>>) {
        state.wakes += 1;
        drop(state);
        self.wake();
    }
}

impl Monitor<RobotStatus> {
    /// Connects to a controller's status port: `10.5.5.100`, or an address with a port.
    ///
    /// # Errors
    /// [`ErrorKind::Connect`] if no controller answers there within the connect timeout.
    pub fn connect(address: impl Display) -> Result<Self, Error> {
        Self::connect_with(&Config::new(), address)
    }
}

impl<S: Decode + Send + Sync + 'static> Monitor<S> {
    /// Connects to a controller's status port by a configuration.
    ///
    /// # Errors
    /// As [`connect`](Monitor::connect).
    pub fn connect_with(config: &Config, address: impl Display) -> Result<Self, Error> {
        let address = address.to_string();
        let packets = Packets::connect(&address, config)?;
        let source_address = packets.tap.address();
        let state = BoardState::new(Some(Arc::clone(&packets.stream)), packets.tap.clone());
        let board = Arc::new(Board::new(&config.clock, state));
        let worker = thread::Worker::new(Arc::clone(&board), address, config.clone());
        let builder = std::thread::Builder::new().name("jaka-monitor".to_owned());
        let thread = builder.spawn(config.clock.serving(move || worker.run(packets)));
        let thread = thread.map_err(|source| {
            let (address, port) = (source_address, Port::Status);
            ErrorKind::Connect { address, port, source }
        })?;
        let (timeout, stale_after) = (config.reply_timeout, config.stale_after);
        Ok(Self { board, clock: config.clock.clone(), thread: Some(thread), timeout, stale_after })
    }
}

impl<S: 'static> Monitor<S> {
    /// Returns the newest packet, if one has come. It may be old: see [`Snapshot::age`] and
    /// [`is_stale`](Self::is_stale).
    ///
    /// # Errors
    /// [`ErrorKind::Disconnected`] if the connection has ended: no newer packet will come.
    #[doc(alias = "last")]
    #[doc(alias = "latest")]
    #[doc(alias = "status")]
    pub fn newest_packet(&self) -> Result<Option<Arc<Snapshot<S>>>, Error> {
        let state = self.board.lock();
        ended(&state)?;
        Ok(state.latest.clone())
    }

    /// The last packet that has come, even if the connection has ended since.
    pub fn last_known_packet(&self) -> Option<Arc<Snapshot<S>>> {
        self.board.lock().latest.clone()
    }

    /// True if no packet has come for longer than [`Config::stale_after`].
    pub fn is_stale(&self) -> bool {
        self.last_known_packet().is_none_or(|snapshot| snapshot.age() > self.stale_after)
    }

    /// Waits for the next packet that comes. A packet that [may be old](Snapshot::follows_silence) does not count.
    ///
    /// # Errors
    /// After the reply timeout [`ErrorKind::StatusTimeout`] if none came, [`ErrorKind::StatusUnknown`] if all may be
    /// old;
    /// [`ErrorKind::Disconnected`] if the connection has ended.
    pub fn next_packet(&self) -> Result<Arc<Snapshot<S>>, Error> {
        let now = self.last_known_packet().map_or(0, |snapshot| snapshot.number);
        self.wait_for(self.timeout, |snapshot| snapshot.number > now)
    }

    /// Waits until `wanted` is true of a packet. The newest packet so far counts too, unless it is stale or
    /// [may be old](Snapshot::follows_silence).
    ///
    /// The packet describes the arm at a time before its arrival, and nothing bounds the time between: see
    /// [`Snapshot`]. If a person or a part depends on the state, query it on the command port afterwards.
    ///
    /// # Errors
    /// After `timeout` [`ErrorKind::StateTimeout`] if packets came but `wanted` was true of none,
    /// [`ErrorKind::StatusUnknown`] if the newest may be old, [`ErrorKind::UnexpectedStatus`] if they could not be
    /// read,
    /// [`ErrorKind::StatusTimeout`] if none came. [`ErrorKind::Disconnected`] if the connection has ended.
    pub fn wait_until(&self, wanted: impl Fn(&S) -> bool, timeout: Duration) -> Result<Arc<Snapshot<S>>, Error> {
        let fresh = self.stale_after;
        self.wait_for(timeout, |snapshot| snapshot.age() <= fresh && wanted(&snapshot.status))
    }

    /// Calls `find` with each newest packet as it comes, until it has found something. Returns `None` after `timeout`,
    /// and the error once the connection has ended.
    pub(crate) fn watch<T>(
        &self,
        timeout: Duration,
        mut find: impl FnMut(Option<&Arc<Snapshot<S>>>) -> Option<T>,
    ) -> Result<Option<T>, Error> {
        let since = self.clock.stopwatch();
        let mut seen = 0;
        loop {
            let state = self.board.lock();
            let (latest, wakes, ended) = (state.latest.clone(), state.wakes, ended(&state));
            drop(state);
            // Without the lock: other threads, which may send a stop, do not wait for this call.
            let latest = latest.filter(|snapshot| snapshot.number > seen);
            seen = latest.as_ref().map_or(seen, |snapshot| snapshot.number);
            if let Some(found) = find(latest.as_ref()) {
                return Ok(Some(found));
            }
            drop(latest);
            ended?;
            let left = since.left_of(timeout);
            if left.is_zero() {
                return Ok(None);
            }
            let state = self.board.lock();
            if state.wakes == wakes {
                drop(self.board.wait(state, left));
            }
        }
    }

    fn wait_for(&self, timeout: Duration, wanted: impl Fn(&Snapshot<S>) -> bool) -> Result<Arc<Snapshot<S>>, Error> {
        ended(&self.board.lock())?;
        let before = self.statistics().packets;
        let counts = |latest: &&Arc<Snapshot<S>>| !latest.follows_silence && wanted(latest);
        let found = self.watch(timeout, |latest| latest.filter(counts).cloned())?;
        found.ok_or_else(|| self.not_in_time(timeout, before))
    }

    /// Error for a state, or for packets, that did not come in time.
    fn not_in_time(&self, after: Duration, before: u64) -> Error {
        let packets = self.statistics().packets.saturating_sub(before);
        let state = self.board.lock();
        let kind = match (state.unfit.clone(), &state.latest) {
            (Some(source), _) => ErrorKind::UnexpectedStatus { source },
            (None, Some(last)) if packets > 0 && last.follows_silence => {
                ErrorKind::StatusUnknown { problem: StatusProblem::Resuming }
            }
            (None, Some(last)) if packets > 0 => ErrorKind::StateTimeout { after, packets, says: describe(last) },
            _ => ErrorKind::StatusTimeout { address: state.tap.address(), after },
        };
        state.tap.attach(kind.into())
    }

    /// Queues every packet from now on, at most `capacity` of them: if the queue is full, the oldest is dropped and
    /// counted.
    ///
    /// Packets that [may be old](Snapshot::follows_silence) are queued too, and are marked as such.
    pub fn subscribe(&self, capacity: usize) -> Subscription<S> {
        let queue = Arc::new(Queue::new(&self.clock, Items::new(capacity)));
        let mut state = self.board.lock();
        if state.ended.is_some() {
            queue.close();
        } else {
            state.queues.push(Arc::clone(&queue));
        }
        Subscription { queue }
    }

    /// Calls `call` with every packet from now on, on the monitor's thread, until it returns `Break`.
    ///
    /// Packets wait while it runs, so it should be short. If it panics, it is not called again, and the monitor
    /// continues.
    pub fn observe(&self, call: impl FnMut(&Arc<Snapshot<S>>) -> ControlFlow<()> + Send + 'static) {
        self.board.lock().observers.users.push(Box::new(call));
    }

    /// Statistics on the number and the regularity of packets.
    pub fn statistics(&self) -> MonitorStatistics {
        self.board.lock().counters.statistics()
    }

    /// Cause of the end of the connection, if it has ended.
    pub fn disconnect_cause(&self) -> Option<Arc<Disconnect>> {
        self.board.lock().ended.clone()
    }
}

/// Parts of a [`Monitor`].
pub trait MonitorParts<S> {
    /// Clock of the monitor.
    fn clock(&self) -> &Clock;

    /// Age from which a packet is stale: [`Config::stale_after`].
    fn stale_after(&self) -> Duration;

    /// Address of the connection, with the port.
    fn address(&self) -> String;

    /// Passes the news of the port to `listener` from now on, on the monitor's thread, before the program's observers.
    fn listen(&self, listener: impl FnMut(StatusNews<'_, S>) -> ControlFlow<()> + Send + 'static);

    /// Passes the current state to `tell`, in this thread: the newest packet, and then the news that followed it.
    fn tell_known(&self, tell: impl FnMut(StatusNews<'_, S>));
}

impl<S: 'static> MonitorParts<S> for Monitor<S> {
    fn clock(&self) -> &Clock {
        &self.clock
    }

    fn stale_after(&self) -> Duration {
        self.stale_after
    }

    fn address(&self) -> String {
        self.board.lock().tap.address()
    }

    fn listen(&self, listener: impl FnMut(StatusNews<'_, S>) -> ControlFlow<()> + Send + 'static) {
        self.board.lock().observers.listeners.push(Box::new(listener));
    }

    fn tell_known(&self, mut tell: impl FnMut(StatusNews<'_, S>)) {
        let state = self.board.lock();
        let (latest, unfit) = (state.latest.clone(), state.unfit.clone());
        let (is_reconnecting, ended) = (state.reconnecting, state.ended.clone());
        drop(state);
        if let Some(packet) = &latest {
            tell(StatusNews::Packet { packet, is_newest: true });
        }
        if let Some(source) = &unfit {
            tell(StatusNews::Unreadable(source));
        }
        if is_reconnecting {
            tell(StatusNews::Reconnecting);
        }
        if let Some(cause) = &ended {
            tell(StatusNews::Ended(cause));
        }
    }
}

/// Describes the arm by a status packet; `None` for a type other than [`RobotStatus`].
pub fn describe<S: 'static>(snapshot: &Snapshot<S>) -> Option<String> {
    let status = (&snapshot.status as &dyn Any).downcast_ref::<RobotStatus>()?;
    let named = |error: &DecodeError| match error.field() {
        "" => "the packet cannot be read".to_owned(),
        field => format!("{field} cannot be read"),
    };
    let unfit = snapshot.unfit.iter().map(named);
    let says = |holds: Option<bool>, yes: &str, no: &str| holds.map(|holds| if holds { yes } else { no }.to_owned());
    let code = status.error_code.as_ref().map(|code| format!("code {code}"));
    let parts = [
        says(status.powered_on, "powered", "not powered"),
        says(status.enabled, "enabled", "not enabled"),
        says(status.in_position, "in position", "not in position"),
        status.emergency_stop.filter(|pressed| *pressed).map(|_| "emergency stop".to_owned()),
        status.protective_stop.filter(|stopped| *stopped).map(|_| "protective stop".to_owned()),
        code,
    ];
    Some(parts.into_iter().flatten().chain(unfit).collect::<Vec<_>>().join(", "))
}

fn ended<S>(state: &BoardState<S>) -> Result<(), Error> {
    let disconnected =
        |cause| ErrorKind::Disconnected { address: state.tap.address(), command: None, sent: false, cause };
    state.ended.clone().map_or(Ok(()), |cause| Err(state.tap.attach(disconnected(cause).into())))
}

impl<S> Drop for Monitor<S> {
    fn drop(&mut self) {
        let mut state = self.board.lock();
        state.closing = true;
        if let Some(stream) = state.stream.take() {
            // An error here means that the connection has ended already.
            let _ = stream.shutdown(std::net::Shutdown::Both);
        }
        self.board.tell(state);
        // An observer may drop the monitor: the thread that calls it cannot wait for its own end.
        if let Some(thread) = self.thread.take().filter(|thread| thread.thread().id() != std::thread::current().id()) {
            // A panic there has been reported.
            drop(self.clock.outside(|| thread.join()));
        }
    }
}

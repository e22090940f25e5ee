//! Threads other than the one that makes the calls: stop handles, and readers of the status port.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_robot::jaka_sync::{self, ErrorKind as Failure};
use jaka_robot::status::RobotStatus;
use jaka_robot::{Config, Error, ErrorKind, Monitor, StatusStream};
use jaka_sim::jaka_clock::Clock;

use super::account::{Fate, Stops};
use super::host::{FIRST_RATE, Ports};
use super::orders::Orders;
use super::tally::Tally;

/// Pause of a reader of the status port before it reconnects.
const PAUSE: Duration = Duration::from_millis(20);

/// Findings of all threads.
#[derive(Debug, Clone, Default)]
pub(super) struct Findings(Arc<Mutex<Vec<String>>>);

impl Findings {
    pub(super) fn add(&self, finding: String) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(finding);
    }

    pub(super) fn take(&self) -> Vec<String> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Counts what a call ended with.
pub(super) fn count<T>(tally: &mut Tally, result: &Result<T, Error>) {
    let failure = |error: &Error| match crate::failure(error) {
        _ if error.is_refused() => "refused",
        Some(Failure::Timeout { .. }) => "timeouts",
        Some(Failure::ReplyLost { .. }) => "replies lost",
        Some(Failure::UnexpectedReply { .. }) => "unexpected replies",
        _ if error.may_have_run() => "broken off",
        _ => "not sent",
    };
    let ended = result.as_ref().err().map_or("accepted", failure);
    if ended == "not sent" {
        tally.one(ended);
        if result.as_ref().is_err_and(|error| matches!(error.kind(), ErrorKind::StatusUnknown { .. })) {
            tally.one("motions kept back without status");
        }
        return;
    }
    tally.one("commands");
    tally.one(ended);
}

/// A thread that stops the arm whenever it is told to.
#[derive(Debug)]
pub(super) struct Hand {
    time: Clock,
    orders: Orders,
    thread: JoinHandle<(Stops, Tally)>,
}

impl Hand {
    pub(super) fn new(time: &Clock, stop: impl Fn() -> Result<(), Error> + Send + 'static) -> Self {
        let orders = Orders::new(time);
        let theirs = orders.clone();
        let thread = thread::spawn(time.participating(move || {
            let (mut stops, mut tally) = (Stops::default(), Tally::default());
            while theirs.take() {
                let stopped = stop();
                count(&mut tally, &stopped);
                let fate = Fate::of(&stopped);
                stops.sent += usize::from(fate != Fate::NotSent);
                stops.seen += usize::from(fate == Fate::Seen);
            }
            (stops, tally)
        }));
        Self { time: time.clone(), orders, thread }
    }

    /// It stops some time from now.
    pub(super) fn go(&self) {
        // A thread that has panicked is reported at its end.
        self.orders.add();
    }

    /// `None` if it has panicked.
    pub(super) fn end(self) -> Option<(Stops, Tally)> {
        self.orders.close();
        self.time.outside(|| self.thread.join()).ok()
    }
}

/// The rate of motions that an arm was told last. Each is higher than the one before, so that packets show their order.
#[derive(Debug, Clone, Default)]
pub(super) struct Rate(Arc<AtomicU64>);

impl Rate {
    /// The next one, to be sent.
    pub(super) fn next(&self) -> f64 {
        Self::at(self.0.fetch_add(1, Ordering::SeqCst) + 1)
    }

    /// The last that was sent.
    fn last(&self) -> f64 {
        Self::at(self.0.load(Ordering::SeqCst))
    }

    fn at(number: u64) -> f64 {
        FIRST_RATE + f64::from(u32::try_from(number).unwrap_or(u32::MAX)) / 1e6
    }
}

/// Sees to it that packets come in order, and say nothing that was not set.
#[derive(Debug)]
struct Order {
    rate: Rate,
    last: f64,
    findings: Findings,
}

impl Order {
    fn new(rate: &Rate, findings: &Findings) -> Self {
        Self { rate: rate.clone(), last: 0.0, findings: findings.clone() }
    }

    fn see(&mut self, status: &RobotStatus) {
        // Of some faults nothing but the braces comes.
        let Some(rate) = status.rapid_rate else { return };
        if rate < self.last || rate > self.rate.last() {
            self.findings.add(format!("a packet has the rate {rate} after {}, of {}", self.last, self.rate.last()));
        }
        self.last = rate;
    }
}

/// Has each packet of a monitor looked at.
pub(super) fn observe(monitor: &Monitor, rate: &Rate, findings: &Findings) {
    let (mut order, mut number, findings) = (Order::new(rate, findings), 0, findings.clone());
    monitor.observe(move |snapshot| {
        if snapshot.number <= number {
            findings.add(format!("packet {} came after {number}", snapshot.number));
        }
        number = snapshot.number;
        order.see(&snapshot.status);
        ControlFlow::Continue(())
    });
}

/// A thread that reads status packets by a stream, and reconnects when it breaks.
#[derive(Debug)]
pub(super) struct Reader {
    time: Clock,
    ends: Arc<AtomicBool>,
    thread: JoinHandle<Tally>,
}

impl Reader {
    pub(super) fn new(config: Config, ports: &Ports, rate: &Rate, findings: &Findings) -> Self {
        let ends = Arc::new(AtomicBool::new(false));
        let (told, mut order) = (Arc::clone(&ends), Order::new(rate, findings));
        let (ports, time) = (ports.clone(), ports.time.clone());
        let thread = thread::spawn(time.participating(move || {
            let mut tally = Tally::default();
            while !told.load(Ordering::SeqCst) {
                if let Err(error) = read(&config, &ports, &told, &mut order, &mut tally) {
                    order.findings.add(format!("the status stream failed with {error:?}"));
                    break;
                }
            }
            tally
        }));
        Self { time, ends, thread }
    }

    /// `None` if it has panicked.
    pub(super) fn end(self) -> Option<Tally> {
        self.ends.store(true, Ordering::SeqCst);
        self.time.outside(|| self.thread.join()).ok()
    }
}

/// Reads to the end of one connection.
fn read(
    config: &Config,
    ports: &Ports,
    ends: &AtomicBool,
    order: &mut Order,
    tally: &mut Tally,
) -> Result<(), jaka_sync::Error> {
    let mut stream = StatusStream::connect_with(config, ports.status)?;
    tally.one("status streams");
    while !ends.load(Ordering::SeqCst) {
        let newest = tally.get("packets").is_multiple_of(4);
        let error = match if newest { stream.newest_packet() } else { stream.next_packet() } {
            Ok(status) => {
                tally.one("packets");
                order.see(&status);
                continue;
            }
            Err(error) => error,
        };
        match error.kind() {
            Failure::StatusTimeout { .. } => tally.one("silences of the status port"),
            Failure::UnexpectedStatus { .. } => tally.one("packets that do not fit"),
            Failure::Disconnected { .. } => {
                tally.one("status streams broken");
                // Where each connection ends at once, ports would run out.
                ports.time.sleep(PAUSE);
                break;
            }
            _ => return Err(error),
        }
    }
    Ok(())
}

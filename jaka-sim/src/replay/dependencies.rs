//! Arrival of requests: status packets wait for the requests recorded before them.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use jaka_clock::{Clock, lock};
use jaka_proto::recording::{Event, Port, Recording};

/// Requests of all command connections, in the order of their recorded times.
#[derive(Debug)]
pub(super) struct Dependencies {
    recorded: Vec<Duration>,
    arrivals: Mutex<Arrivals>,
    time: Clock,
}

#[derive(Debug)]
struct Arrivals {
    /// Time of arrival of each request.
    came: Vec<Option<Instant>>,
    /// Number of requests that have come without a gap.
    whole: usize,
}

/// Request on which a packet waits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dependency {
    /// No request was recorded before the packet.
    None,
    /// The last request before the packet came at this instant, and was recorded at this time.
    Came(Instant, Duration),
    /// A request has not come yet.
    Awaited,
}

impl Dependencies {
    pub(super) fn new(recording: &Recording, time: &Clock) -> Self {
        let sent = |event: &Event| matches!(event, Event::Sent(_));
        let requests = recording.entries.iter().filter(|entry| entry.port == Port::Command && sent(&entry.event));
        let mut recorded: Vec<_> = requests.map(|entry| entry.time).collect();
        recorded.sort_unstable();
        let came = vec![None; recorded.len()];
        Self { recorded, arrivals: Mutex::new(Arrivals { came, whole: 0 }), time: time.clone() }
    }

    /// Records that the request of this recorded time has come or never will.
    pub(super) fn came(&self, recorded: Duration) {
        let first = self.recorded.partition_point(|time| *time < recorded);
        let mut arrivals = lock(&self.arrivals);
        if let Some(request) = arrivals.came[first..].iter_mut().find(|request| request.is_none()) {
            *request = Some(self.time.now());
        }
        while arrivals.came.get(arrivals.whole).is_some_and(Option::is_some) {
            arrivals.whole += 1;
        }
    }

    /// Returns the dependency of a message recorded at this time.
    pub(super) fn before(&self, recorded: Duration) -> Dependency {
        let count = self.recorded.partition_point(|time| *time < recorded);
        let Some(last) = count.checked_sub(1) else { return Dependency::None };
        let arrivals = lock(&self.arrivals);
        match arrivals.came[last] {
            Some(instant) if arrivals.whole >= count => Dependency::Came(instant, self.recorded[last]),
            _ => Dependency::Awaited,
        }
    }
}

#[cfg(test)]
mod tests {
    use jaka_proto::recording::{Entry, Header, Message};

    use super::*;

    #[test]
    fn a_packet_waits_for_all_requests_before_it() {
        let millis = Duration::from_millis;
        let sent = |at, connection| Entry::new(millis(at), Port::Command, connection, Event::Sent(Message::new("{}")));
        let entries = vec![sent(10, 1), sent(20, 1), sent(20, 2)];
        let dependencies =
            Dependencies::new(&Recording::new(Header::new(Duration::ZERO, ""), entries), &Clock::default());
        assert_eq!(dependencies.before(millis(10)), Dependency::None);
        assert_eq!(dependencies.before(millis(11)), Dependency::Awaited);
        dependencies.came(millis(20));
        assert_eq!(dependencies.before(millis(30)), Dependency::Awaited);
        dependencies.came(millis(10));
        assert!(matches!(dependencies.before(millis(20)), Dependency::Came(_, recorded) if recorded == millis(10)));
        assert_eq!(dependencies.before(millis(30)), Dependency::Awaited);
        dependencies.came(millis(20));
        assert!(matches!(dependencies.before(millis(30)), Dependency::Came(_, recorded) if recorded == millis(20)));
        dependencies.came(millis(99));
    }
}

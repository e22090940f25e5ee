//! What is wrong with each link, now and later.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use crate::fault::{LinkEvent, LinkFault};
use crate::link_selector::LinkSelector;
use crate::{Direction, Port};

/// The faults of each port in each direction.
#[derive(Debug, Default)]
pub(super) struct LinkStates {
    links: [[LinkState; 2]; 2],
}

/// One port in one direction.
#[derive(Debug, Default)]
pub(super) struct LinkState {
    fault: LinkFault,
    /// How many times it has been cut. A connection that is older than the last of these is cut.
    cuts: u64,
    /// What is to follow, in order.
    schedule: VecDeque<(Instant, LinkFault)>,
}

impl LinkStates {
    /// The links of a controller that starts now.
    pub(super) fn new(events: &[LinkEvent], start: Instant) -> Self {
        let mut states = Self::default();
        for event in events {
            states.schedule(event, start);
        }
        states.links.iter_mut().flatten().for_each(|link| link.catch_up(start));
        states
    }

    /// Sets what is wrong with these links from now on, and forgets what was to follow.
    pub(super) fn set(&mut self, selector: LinkSelector, fault: LinkFault) {
        for (port, direction) in selector.each() {
            let link = self.link(port, direction);
            link.schedule.clear();
            link.set(fault);
        }
    }

    fn schedule(&mut self, event: &LinkEvent, start: Instant) {
        let Some(begin) = start.checked_add(event.after) else { return };
        let end = event.lasting.and_then(|time| begin.checked_add(time));
        for (port, direction) in event.selector.each() {
            let schedule = &mut self.link(port, direction).schedule;
            schedule.push_back((begin, event.fault));
            schedule.extend(end.map(|end| (end, LinkFault::None)));
            // Of two for the same moment, the one that was given later holds.
            schedule.make_contiguous().sort_by_key(|(at, _)| *at);
        }
    }

    /// The link of a port in a direction, as it is at this time, which is now.
    pub(super) fn at(&mut self, now: Instant, port: Port, direction: Direction) -> &mut LinkState {
        let link = self.link(port, direction);
        link.catch_up(now);
        link
    }

    fn link(&mut self, port: Port, direction: Direction) -> &mut LinkState {
        &mut self.links[port as usize][direction as usize]
    }
}

impl LinkState {
    fn set(&mut self, fault: LinkFault) {
        self.fault = fault;
        if fault == LinkFault::Cut {
            self.cuts += 1;
        }
    }

    fn catch_up(&mut self, now: Instant) {
        while self.schedule.front().is_some_and(|(at, _)| *at <= now) {
            if let Some((_, fault)) = self.schedule.pop_front() {
                self.set(fault);
            }
        }
    }

    /// What a connection that is made now remembers, to know whether it has been cut.
    pub(super) fn generation(&self) -> u64 {
        if self.fault == LinkFault::Cut { self.cuts.saturating_sub(1) } else { self.cuts }
    }

    /// What is wrong for a connection of this generation.
    pub(super) fn fault(&self, generation: u64) -> LinkFault {
        if self.cuts > generation { LinkFault::Cut } else { self.fault }
    }

    /// How long it stays as it is now, if that is known.
    pub(super) fn stays_for(&self, now: Instant) -> Option<Duration> {
        self.schedule.front().map(|(at, _)| at.saturating_duration_since(now))
    }
}

/// The shorter of two times, of which none is the longest.
pub(super) fn shorter(a: Option<Duration>, b: Option<Duration>) -> Option<Duration> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

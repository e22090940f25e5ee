//! Faults of each link.

use crate::fault::LinkFault;
use crate::link_selector::LinkSelector;
use crate::{Direction, Port};

/// Faults of each port in each direction.
#[derive(Debug, Default)]
pub(super) struct LinkStates {
    links: [[LinkState; 2]; 2],
}

/// State of one port in one direction.
#[derive(Debug, Default)]
pub(super) struct LinkState {
    fault: LinkFault,
    /// Number of cuts of the link. A connection older than the last cut is cut.
    cuts: u64,
}

impl LinkStates {
    /// Sets the fault of these links from now on.
    pub(super) fn set(&mut self, selector: LinkSelector, fault: LinkFault) {
        for (port, direction) in selector.each() {
            self.links[port as usize][direction as usize].set(fault);
        }
    }

    /// Returns the link of a port in a direction.
    pub(super) fn link(&self, port: Port, direction: Direction) -> &LinkState {
        &self.links[port as usize][direction as usize]
    }
}

impl LinkState {
    fn set(&mut self, fault: LinkFault) {
        self.fault = fault;
        if fault == LinkFault::Cut {
            self.cuts += 1;
        }
    }

    /// Returns the generation of a connection opened now, which shows later whether it has been cut.
    pub(super) fn generation(&self) -> u64 {
        if self.fault == LinkFault::Cut { self.cuts.saturating_sub(1) } else { self.cuts }
    }

    /// Returns the fault of the link for a connection of this generation.
    pub(super) fn fault(&self, generation: u64) -> LinkFault {
        if self.cuts > generation { LinkFault::Cut } else { self.fault }
    }
}

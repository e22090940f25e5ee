//! Messages on the wire of a command port, with their times.

use std::net::SocketAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use jaka_sim::SimulatedClock;
use serde_json::{Deserializer, Value};

use super::forwarded::forwarded;

/// A message, and the simulated time at which it came.
pub type TimedMessage = (Duration, Value);

/// A proxy to a command port for one client, which keeps each message with its time. It reads JSON by itself, and knows
/// nothing of what makes the requests.
#[derive(Debug)]
pub struct CommandWire {
    address: SocketAddr,
    requests: Arc<Mutex<Vec<TimedMessage>>>,
    replies: Arc<Mutex<Vec<TimedMessage>>>,
}

impl CommandWire {
    /// Begins to listen, for one client of this controller.
    ///
    /// # Panics
    /// Loopback has no free port.
    pub fn watch(clock: &SimulatedClock, controller: SocketAddr) -> Self {
        let (requests, replies) = (Arc::default(), Arc::default());
        let address = forwarded(clock, controller, keeping(clock, &requests), keeping(clock, &replies));
        Self { address, requests, replies }
    }

    /// Address on which the proxy listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// All requests by now.
    pub fn requests(&self) -> Vec<TimedMessage> {
        self.requests.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// All replies by now.
    pub fn replies(&self) -> Vec<TimedMessage> {
        self.replies.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

/// Keeps the messages of one direction.
fn keeping(clock: &SimulatedClock, kept: &Arc<Mutex<Vec<TimedMessage>>>) -> impl FnMut(&mut Vec<u8>) + Send + use<> {
    let (clock, kept, mut text) = (clock.clone(), Arc::clone(kept), Vec::new());
    move |bytes| {
        text.extend_from_slice(bytes);
        let mut messages = Deserializer::from_slice(&text).into_iter::<Value>();
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        while let Some(Ok(message)) = messages.next() {
            kept.push((clock.elapsed(), message));
        }
        let done = messages.byte_offset();
        text.drain(..done);
    }
}

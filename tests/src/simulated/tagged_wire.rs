//! A proxy to a command port that marks each reply with its request's own number.

use std::net::SocketAddr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use jaka_sim::SimulatedClock;
use serde_json::{Deserializer, Value, json};

use super::forwarded::forwarded;

/// A request, the simulated time at which it came, and the reply to it, as the client gets it.
#[derive(Debug, Clone)]
pub struct Exchanged {
    /// Time of the request.
    pub at: Duration,
    /// The request.
    pub request: Value,
    /// The reply; `None` before it comes.
    pub reply: Option<Value>,
}

/// A proxy to a command port for one client, which keeps the requests with their replies, in the order of both.
///
/// A request has a tag in its field `tag`, or else in `value`. Its reply gets the tag as `tag`, and as its message if
/// it is a refusal. So each reply can be told from those to all other requests. A request with the field `lacked` is
/// refused without its name, as by a controller that does not have the command.
#[derive(Debug)]
pub struct TaggedWire {
    address: SocketAddr,
    seen: Arc<Mutex<Seen>>,
}

#[derive(Debug, Default)]
struct Seen {
    exchanged: Vec<Exchanged>,
    answered: usize,
}

impl Exchanged {
    /// Tag of the request.
    pub fn tag(&self) -> Option<u64> {
        let tag = |key: &str| self.request[key].as_f64();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "tags are whole numbers")]
        tag("tag").or_else(|| tag("value")).map(|tag| tag as u64)
    }

    /// True for a request of this command.
    pub fn is(&self, command: &str) -> bool {
        self.request["cmdName"] == command
    }

    /// True if the controller has accepted it.
    pub fn is_accepted(&self) -> bool {
        self.reply.as_ref().is_some_and(|reply| reply["errorCode"] == "0")
    }

    /// The reply with the tag.
    fn tagged(&self, mut reply: Value) -> Value {
        let Some(tag) = self.tag() else { return reply };
        if !self.request["lacked"].is_null() {
            reply = json!({"errorCode": "1", "errorMsg": ""});
        }
        reply["tag"] = tag.into();
        if reply["errorCode"] != "0" {
            reply["errorMsg"] = tag.to_string().into();
        }
        reply
    }
}

impl TaggedWire {
    /// Begins to listen, for one client of this controller.
    ///
    /// # Panics
    /// Loopback has no free port.
    pub fn watch(clock: &SimulatedClock, controller: SocketAddr) -> Self {
        let seen = Arc::<Mutex<Seen>>::default();
        let (requests, replies, clock_of_requests) = (Arc::clone(&seen), Arc::clone(&seen), clock.clone());
        let (mut sent, mut received) = (Vec::new(), Vec::new());
        let see_requests = move |bytes: &mut Vec<u8>| {
            let at = clock_of_requests.elapsed();
            let requests_seen = messages(&mut sent, bytes);
            lock(&requests).exchanged.extend(requests_seen.into_iter().map(|request| Exchanged {
                at,
                request,
                reply: None,
            }));
        };
        let see_replies = move |bytes: &mut Vec<u8>| {
            let replies_seen = messages(&mut received, bytes);
            bytes.clear();
            let mut seen = lock(&replies);
            for reply in replies_seen {
                let number = seen.answered;
                seen.answered += 1;
                let exchanged = seen.exchanged.get_mut(number).expect("a reply follows its request");
                let reply = exchanged.tagged(reply);
                bytes.extend_from_slice(reply.to_string().as_bytes());
                exchanged.reply = Some(reply);
            }
        };
        let address = forwarded(clock, controller, see_requests, see_replies);
        Self { address, seen }
    }

    /// Address on which the proxy listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// All requests by now.
    pub fn exchanged(&self) -> Vec<Exchanged> {
        lock(&self.seen).exchanged.clone()
    }
}

fn lock(seen: &Mutex<Seen>) -> MutexGuard<'_, Seen> {
    seen.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes the whole messages off a text to which bytes are added.
fn messages(text: &mut Vec<u8>, bytes: &[u8]) -> Vec<Value> {
    text.extend_from_slice(bytes);
    let mut messages = Deserializer::from_slice(text).into_iter::<Value>();
    let whole = std::iter::from_fn(|| messages.next().and_then(Result::ok)).collect();
    let done = messages.byte_offset();
    text.drain(..done);
    whole
}

//! Threads that call.

use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_sync::{Client, Error, ErrorKind, StopHandle};

use crate::model::Got;

/// What a thread is to do.
#[derive(Debug)]
pub(crate) enum Order {
    Call { name: &'static str, timeout: Duration },
    Stop,
}

/// A thread that calls, one call after the other.
pub(crate) struct Worker {
    pub(crate) orders: Sender<Order>,
    pub(crate) results: Receiver<Result<u32, Error>>,
    pub(crate) thread: JoinHandle<()>,
}

impl Worker {
    fn new(mut call: impl FnMut(Order) -> Result<u32, Error> + Send + 'static) -> Self {
        let (orders, to_do) = mpsc::channel();
        let (done, results) = mpsc::channel();
        let calls = move || {
            for order in to_do {
                if done.send(call(order)).is_err() {
                    // The run has failed: its results are no longer wanted.
                    return;
                }
            }
        };
        let thread = thread::spawn(calls);
        Self { orders, results, thread }
    }

    pub(crate) fn of_client(mut client: Client) -> Self {
        Self::new(move |order| match order {
            Order::Call { name, timeout } => {
                let request = format!(r#"{{"cmdName": "{name}"}}"#);
                client.call_text(&request, timeout).map(number_in)
            }
            Order::Stop => client.stop_handle().stop().map(|()| 0),
        })
    }

    pub(crate) fn of_stop_handle(stop: StopHandle) -> Self {
        Self::new(move |_| stop.stop().map(|()| 0))
    }
}

fn number_in(reply: &str) -> u32 {
    let reply: serde_json::Value = serde_json::from_str(reply).expect("the server writes JSON");
    reply["number"].as_u64().and_then(|number| u32::try_from(number).ok()).expect("the server numbers its replies")
}

/// A refusal shows whose it is by its code.
pub(crate) fn got(result: Result<u32, Error>) -> Got {
    match result.map_err(Error::into_kind) {
        Ok(number) => Got::Reply(number),
        Err(ErrorKind::Refused { refusal, .. }) => {
            Got::Reply(u32::try_from(refusal.code.0).expect("the server numbers its replies"))
        }
        Err(ErrorKind::Timeout { .. }) => Got::Timeout,
        Err(ErrorKind::NotSentInTime { .. }) => Got::NotSentInTime,
        Err(ErrorKind::ReplyLost { .. }) => Got::Lost,
        Err(ErrorKind::Disconnected { sent: true, .. }) => Got::Broken,
        Err(ErrorKind::Disconnected { sent: false, .. }) => Got::NotSent,
        Err(other) => panic!("no exchange may end with {other:?}"),
    }
}

//! Calls on the command port, each with its reply.

use std::time::Duration;

use jaka_sync::kinematics::{GetJointPos, GetJointPosReply};
use jaka_sync::payload::SetPayload;
use jaka_sync::program::StopProgram;
use jaka_sync::{Client, Command, Error};
use jaka_tests::simulated::beside;
use jaka_tests::{RecordingBuffer, requests};
use serde_json::json;

use crate::cell::{Cell, Kind, Next, SHORT, Seen, position};
use crate::outcome::Outcome;

/// The commands of these calls.
fn command(kind: Kind) -> &'static str {
    match kind {
        Kind::Setting => SetPayload::INFO.name,
        Kind::Stop => StopProgram::INFO.name,
        _ => GetJointPos::INFO.name,
    }
}

pub(crate) fn run(cell: &Cell<'_>) -> Seen {
    let buffer = RecordingBuffer::default();
    let recorder = (cell.kind == Kind::Recorded).then(|| buffer.recorder());
    let config = recorder.iter().fold(cell.config(), |config, recorder| config.recorder(recorder.clone()));
    let mut client = Client::connect_with(&config, cell.controller.command_addr()).expect("the controller listens");
    cell.strike(command(cell.kind));
    let timeout = cell.patience(cell.expected.first);
    let first = cell.ends(timeout, cell.expected.first, || call(cell, &mut client, timeout));
    cell.lift();
    let timeout = cell.patience(cell.then);
    let next = cell.ends(timeout, cell.then, || match cell.next {
        Next::Other => other(cell, &mut client, timeout),
        Next::Same => same(cell, &mut client, timeout),
    });
    if let Some(recorder) = recorder {
        let sent = requests(&buffer.finish(&recorder).expect("memory loses nothing"));
        let received = cell.controller.requests();
        assert!(sent.starts_with(&received), "{cell}: recorded {sent:?}, received {received:?}");
    }
    Seen { first, stop: None, next }
}

fn call(cell: &Cell<'_>, client: &mut Client, timeout: Duration) -> Result<(), Error> {
    match cell.kind {
        // The timeout of these two is the configuration's.
        Kind::Stop => client.stop_handle().stop(),
        Kind::Raw => {
            let mark = cell.mark();
            let reply = client.call_raw(GetJointPos::INFO.name, &json!({}))?;
            check_text(cell, mark, &reply.to_string());
            Ok(())
        }
        Kind::Text => {
            let mark = cell.mark();
            let request = json!({"cmdName": GetJointPos::INFO.name}).to_string();
            check_text(cell, mark, client.call_text(&request, timeout)?);
            Ok(())
        }
        _ => same(cell, client, timeout),
    }
}

/// Another call of the same name.
fn same(cell: &Cell<'_>, client: &mut Client, timeout: Duration) -> Result<(), Error> {
    match cell.kind {
        Kind::Setting => {
            let centroid = cell.controller.state().payload.centroid;
            let mass = cell.mark() + 0.5;
            client.call_within(&SetPayload::new(mass, centroid), timeout)?;
            assert_eq!(cell.controller.state().payload.mass.to_bits(), mass.to_bits(), "the setting was not made");
            Ok(())
        }
        Kind::Stop => client.call_within(&StopProgram::new(), timeout),
        _ => cell.joint_position(client, timeout),
    }
}

/// A call of another name.
fn other(cell: &Cell<'_>, client: &mut Client, timeout: Duration) -> Result<(), Error> {
    match cell.kind {
        Kind::Setting | Kind::Stop => cell.joint_position(client, timeout),
        _ => cell.payload(client, timeout),
    }
}

/// A raw reply, which the fault may have replaced: if it has the field, it has the arm's position.
fn check_text(cell: &Cell<'_>, mark: f64, reply: &str) {
    if let Ok(reply) = jaka_proto::read_payload::<GetJointPosReply>(GetJointPos::INFO, reply) {
        assert_eq!(reply.joint_position, position(mark), "{cell}: the reply is another's");
    }
}

/// A query that waits, and meanwhile a stop from another thread.
pub(crate) fn run_concurrent_stop(cell: &Cell<'_>) -> Seen {
    let mut client = cell.client();
    let stop = client.stop_handle();
    cell.strike(GetJointPos::INFO.name);
    let (timeout, expected) = (cell.patience(cell.expected.first), cell.expected);
    let mark = cell.mark();
    let (mut called, clock) = (None, cell.clock());
    let stopped = cell.while_held(|| {
        let query = || called = Some(client.call_within(&GetJointPos::new(), timeout));
        beside(clock, query, || {
            // By then the query is sent, and waits.
            clock.sleep(SHORT);
            stop.stop()
        })
    });
    let called = called.expect("the query has ended");
    if let Ok(reply) = &called {
        assert_eq!(reply.joint_position, position(mark), "{cell}: the reply is another's");
    }
    let first = cell.ends(Duration::ZERO, expected.first, || called.map(drop));
    let stop = cell.ends(Duration::ZERO, expected.stop.unwrap_or(Outcome::Ok), || stopped);
    cell.lift();
    let timeout = cell.patience(cell.then);
    let next = cell.ends(timeout, cell.then, || cell.payload(&mut client, timeout));
    Seen { first, stop: Some(stop), next }
}

//! Readers of status packets.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use jaka_sync::kinematics::GetJointPos;
use jaka_sync::types::JointPosition;
use jaka_sync::{Client, Command, Error, Monitor, StatusStream};

use crate::cell::{Cell, PERIOD, Seen, position};
use crate::outcome::Outcome;

/// Time enough for a slow packet, and for a monitor to find packets again.
const WHILE: u32 = 25;

/// Makes a call if the fault is one of replies: status packets must be independent of it.
fn trouble_elsewhere(cell: &Cell<'_>) {
    if cell.trouble.is_of_replies() {
        let config = cell.config().reply_timeout(Duration::from_millis(20));
        let mut client = Client::connect_with(&config, cell.controller.command_addr()).expect("the controller listens");
        // What it ends with is for other cells.
        drop(client.get_joint_pos());
    }
}

pub(crate) fn run_stream(cell: &Cell<'_>) -> Seen {
    let mut stream =
        StatusStream::connect_with(&cell.config(), cell.controller.status_addr()).expect("the controller listens");
    stream.next_packet().expect("the first packet comes at once");
    cell.strike(GetJointPos::INFO.name);
    trouble_elsewhere(cell);
    let read = |stream: &mut StatusStream, expected| {
        let mark = cell.mark();
        cell.clock().sleep(WHILE * PERIOD);
        // The timeout is the connection's.
        let timeout = cell.patience(cell.expected.first);
        cell.ends(timeout, expected, || find(cell, stream, mark, timeout))
    };
    let first = read(&mut stream, cell.expected.first);
    cell.lift();
    let next = read(&mut stream, cell.then);
    Seen { first, stop: None, next }
}

/// Reads packets up to the one with this mark, and none that the controller has not had before. Packets may come that
/// show nothing.
fn find(cell: &Cell<'_>, stream: &mut StatusStream, mark: f64, timeout: Duration) -> Result<Outcome, Error> {
    let since = cell.clock().elapsed();
    while cell.clock().elapsed().saturating_sub(since) < timeout {
        let Some(found) = stream.next_packet()?.joint_actual_position else { continue };
        assert!((0.0..=mark).contains(&found.0[0]), "the packet has {found:?}, where {mark} was the last");
        if found == position(mark) {
            return Ok(Outcome::Ok);
        }
    }
    Ok(Outcome::Timeout)
}

pub(crate) fn run_monitor(cell: &Cell<'_>) -> Seen {
    let monitor: Monitor =
        Monitor::connect_with(&cell.config(), cell.controller.status_addr()).expect("the controller listens");
    let found = observe(&monitor);
    monitor.wait_until(|_| true, cell.patience(Outcome::Ok)).expect("the first packet comes at once");
    cell.strike(GetJointPos::INFO.name);
    trouble_elsewhere(cell);
    let read = |expected| {
        let mark = cell.mark();
        let timeout = cell.patience(expected);
        cell.clock().sleep(WHILE * PERIOD);
        let outcome = cell.ends(timeout, expected, || {
            monitor.wait_until(|status| status.joint_actual_position == Some(position(mark)), timeout).map(drop)
        });
        let found = found.lock().unwrap_or_else(PoisonError::into_inner);
        assert!(found.iter().all(|at| (0.0..=mark).contains(&at.0[0])), "{found:?}, where {mark} was the last");
        outcome
    };
    let first = read(cell.expected.first);
    cell.lift();
    let next = read(cell.then);
    Seen { first, stop: None, next }
}

/// All positions that come.
fn observe(monitor: &Monitor) -> Arc<Mutex<Vec<JointPosition>>> {
    let found: Arc<Mutex<Vec<JointPosition>>> = Arc::default();
    let theirs = Arc::clone(&found);
    monitor.observe(move |snapshot| {
        theirs.lock().unwrap_or_else(PoisonError::into_inner).extend(snapshot.status.joint_actual_position);
        ControlFlow::Continue(())
    });
    found
}

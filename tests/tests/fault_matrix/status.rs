//! Readers of status packets.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use jaka_sync::kinematics::GetJointPos;
use jaka_sync::types::JointPosition;
use jaka_sync::{Command, Error, ErrorKind, Monitor, StatusStream};

use crate::cell::{Cell, PATIENCE, PERIOD, Seen, position};
use crate::outcome::Outcome;

/// Time enough for a slow packet, and for a monitor to find packets again.
const WHILE: u32 = 25;

/// Where the trouble is with replies, has one come: status packets must know nothing of it.
fn trouble_elsewhere(cell: &Cell<'_>) {
    if cell.trouble.is_of_replies() {
        let config = cell.config().reply_timeout(Duration::from_millis(20));
        let mut client = config.connect_client(cell.controller.command_addr()).expect("the controller listens");
        // What it ends with is for other cells.
        drop(client.get_joint_pos());
    }
}

pub(crate) fn run_stream(cell: &Cell<'_>) -> Seen {
    let mut stream = cell.config().connect_status(cell.controller.status_addr()).expect("the controller listens");
    patiently(|| stream.next_packet().map(drop)).expect("the first packet comes at once");
    cell.strike(GetJointPos::INFO.name);
    trouble_elsewhere(cell);
    let read = |stream: &mut StatusStream, expected| {
        let mark = cell.mark();
        for _ in 0..WHILE {
            cell.controller.advance(PERIOD);
        }
        // The timeout is the connection's, and what is to come may take longer.
        cell.ends(cell.patience(cell.expected.first), expected, || match expected {
            Outcome::Ok => patiently(|| find(stream, mark)),
            _ => find(stream, mark),
        })
    };
    let first = read(&mut stream, cell.expected.first);
    cell.lift();
    let next = read(&mut stream, cell.then);
    Seen { first, stop: None, next }
}

/// Again after timeouts, for as long as a call may take that is to succeed.
fn patiently(mut read: impl FnMut() -> Result<(), Error>) -> Result<(), Error> {
    let since = Instant::now();
    loop {
        match read() {
            Err(error) if matches!(error.kind(), ErrorKind::StatusTimeout { .. }) && since.elapsed() < PATIENCE => {}
            result => return result,
        }
    }
}

/// Reads packets up to the one with this mark, and none that the controller has not had before.
fn find(stream: &mut StatusStream, mark: f64) -> Result<(), Error> {
    loop {
        let Some(found) = stream.next_packet()?.joint_actual_position else { continue };
        assert!((0.0..=mark).contains(&found.0[0]), "the packet has {found:?}, where {mark} was the last");
        if found == position(mark) {
            return Ok(());
        }
    }
}

pub(crate) fn run_monitor(cell: &Cell<'_>) -> Seen {
    let monitor: Monitor =
        cell.config().connect_monitor(cell.controller.status_addr()).expect("the controller listens");
    let found = observe(&monitor);
    monitor.wait_until(|_| true, cell.patience(Outcome::Ok)).expect("the first packet comes at once");
    cell.strike(GetJointPos::INFO.name);
    trouble_elsewhere(cell);
    let read = |expected| {
        let mark = cell.mark();
        let timeout = cell.patience(expected);
        for _ in 0..WHILE {
            cell.controller.advance(PERIOD);
        }
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

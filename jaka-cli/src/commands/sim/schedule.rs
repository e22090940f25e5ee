//! Events of the simulated controller, printed as they occur.

use std::io::{BufRead, stdin};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use jaka_sim::{Controller, Scheduled};

use crate::failure::Failure;
use crate::terminal::output;

/// Interval of the checks for due events.
const TICK: Duration = Duration::from_millis(10);

/// Runs the scheduled events and the typed ones, and prints each with its time, until no more can come.
pub(super) fn run(
    controller: &Controller,
    scheduled: Vec<Scheduled>,
    typed: &Receiver<Scheduled>,
) -> Result<(), Failure> {
    let mut ahead = Vec::new();
    for event in scheduled {
        schedule(controller, event, &mut ahead);
    }
    loop {
        let now = controller.elapsed();
        for Scheduled { happening, at } in ahead.extract_if(.., |event| event.at <= now) {
            output::line(&format!("{:.3} s: {happening}", at.as_secs_f64()))?;
        }
        match typed.recv_timeout(TICK) {
            Ok(event) => schedule(controller, event, &mut ahead),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) if ahead.is_empty() => return Ok(()),
            Err(RecvTimeoutError::Disconnected) => thread::sleep(TICK),
        }
    }
}

/// Schedules one event. For an input that the controller does not have, prints an error message instead.
fn schedule(controller: &Controller, event: Scheduled, ahead: &mut Vec<Scheduled>) {
    let at = event.at.max(controller.elapsed());
    match controller.at(at, event.happening) {
        Ok(()) => ahead.push(Scheduled { at, ..event }),
        Err(error) => output::error(&format!("{}: {error}", event.happening)),
    }
    ahead.sort_by_key(|event| event.at);
}

/// Sends the lines of standard input from a reading thread. Prints an error message for an invalid line.
pub(super) fn begin_lines(sender: Sender<Scheduled>) {
    thread::spawn(move || read(&sender));
}

fn read(sender: &Sender<Scheduled>) {
    for line in stdin().lock().lines().map_while(Result::ok).filter(|line| !line.trim().is_empty()) {
        match line.parse() {
            Ok(event) if sender.send(event).is_err() => return,
            Ok(_) => {}
            Err(error) => output::error(&format!("{error}")),
        }
    }
}

//! Packets of the status port.

use jaka_dynamic::{Departure, Node};
use jaka_spec::Spec;
use jaka_sync::{ErrorKind, StatusStream};

use super::finding::{Finding, Outcome};
use super::progress::ProbeProgress;
use crate::commands::call::reply_json;
use crate::failure::{chain, fact};
use crate::target::Target;

/// Name of the finding.
const NAME: &str = "status packet";

/// Reads packets, and compares them with the spec. Reports a departure in several packets once.
pub(super) fn take(spec: &Spec, target: &Target, count: u32, progress: &ProbeProgress) -> Finding {
    if progress.is_interrupted() {
        return Finding::without(NAME, Outcome::NotProbed("interrupted".to_owned()));
    }
    let mut stream = match target.status_stream() {
        Ok(stream) => stream,
        Err(failure) => return Finding::without(NAME, Outcome::NoReply(chain(&failure))),
    };
    let mut found: Option<Finding> = None;
    let mut samples = Vec::new();
    for _ in (0..count).take_while(|_| !progress.is_interrupted()) {
        let packet = match next(&mut stream) {
            Ok(packet) => packet,
            // Earlier packets still count.
            Err(outcome) => {
                let found = found.unwrap_or_else(|| Finding::without(NAME, none()));
                return Finding { outcome, samples, ..found };
            }
        };
        let mut departures = found.as_ref().map(|found| found.departures.clone()).unwrap_or_default();
        let before = departures.len();
        let sample = reply_json(&packet);
        add_new(&mut departures, Node::status(spec, sample.clone()).departures());
        samples.push(sample);
        // Shows a packet that departs.
        if found.is_none() || departures.len() > before {
            found = Some(Finding::of(NAME, departures, packet));
        }
    }
    Finding { samples, ..found.unwrap_or_else(|| Finding::without(NAME, none())) }
}

fn none() -> Outcome {
    Outcome::NoReply("no packet was received".to_owned())
}

/// Returns the text of the next packet, whether it fits or not.
fn next(stream: &mut StatusStream) -> Result<String, Outcome> {
    if let Err(error) = stream.next_packet() {
        match error.kind() {
            ErrorKind::UnexpectedStatus { .. } => {}
            ErrorKind::Disconnected { cause, .. } => return Err(Outcome::Unreadable(chain(&**cause))),
            _ => return Err(Outcome::NoReply(fact(error.kind(), &error))),
        }
    }
    Ok(stream.packet_text().unwrap_or_default().to_owned())
}

fn add_new(departures: &mut Vec<Departure>, more: Vec<Departure>) {
    for new in more {
        if !departures.iter().any(|old| old.field == new.field && old.kind == new.kind) {
            departures.push(new);
        }
    }
}

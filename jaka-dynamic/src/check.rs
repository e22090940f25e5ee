//! Requests as a controller sees them.

use serde_json::{Map, Value};

use super::decode::Decoder;
use super::departure::{Departure, DepartureKind, Reading};
use super::problem::{Problem, ProblemKind};
use jaka_spec::{COMMAND_NAME, Command, Request, Spec};

/// What a controller must refuse in a request that came off the wire, `cmdName` and all.
///
/// The request is read as the generated code reads it: unknown keys are skipped, numbers may be strings, truth values
/// may have any of their forms. Ranges and enum values that newer firmware has widened are not enforced. Fields are
/// named by their keys on the wire.
pub fn check_request(spec: &Spec, command: &Command, message: &Map<String, Value>) -> Vec<Problem> {
    let mut decoder = Decoder::new(spec);
    match &command.request {
        Request::Fields(fields) => decoder.object("", fields, message, &[COMMAND_NAME]),
        Request::Choice(choice) => decoder.object_choice(choice, message, &[COMMAND_NAME]),
    }
    decoder.departures.into_iter().filter(is_refused).map(problem).collect()
}

fn is_refused(departure: &Departure) -> bool {
    let forbidden = matches!(departure.kind, DepartureKind::Range | DepartureKind::Unlisted);
    departure.reading == Reading::Unreadable || forbidden && !departure.advisory
}

fn problem(departure: Departure) -> Problem {
    let Departure { field, kind, found, expected, advisory, .. } = departure;
    let kind = if kind == DepartureKind::Missing { ProblemKind::Missing } else { ProblemKind::Forbidden };
    Problem { field, kind, value: found, allowed: expected, advisory }
}

//! The report as JSON.

use jaka_dynamic::{Departure, DepartureKind, Reading};
use serde_json::{Value, json};

use super::finding::{Finding, Findings, Outcome};

/// The findings as one JSON object, with the text of every message that came.
pub(super) fn text(findings: &Findings) -> String {
    let report = json!({
        "controller": findings.version,
        "jaka": env!("CARGO_PKG_VERSION"),
        "packs": findings.packs,
        "commands": findings.commands.iter().map(finding).collect::<Vec<_>>(),
        "status": finding(&findings.status),
        "asked": findings.asked(),
        "departing": findings.departing(),
    });
    format!("{report:#}\n")
}

fn finding(finding: &Finding) -> Value {
    let (outcome, code, text) = match &finding.outcome {
        Outcome::Answered => ("answered", None, None),
        Outcome::Refused { code, message } => ("refused", Some(code.0), Some(message)),
        Outcome::Unreadable(why) => ("unreadable", None, Some(why)),
        Outcome::NoReply(why) => ("no_reply", None, Some(why)),
        Outcome::NotProbed(why) => ("not_probed", None, Some(why)),
    };
    json!({
        "name": finding.name,
        "outcome": outcome,
        "code": code,
        "text": text,
        "departures": finding.departures.iter().map(departure).collect::<Vec<_>>(),
        "raw": finding.raw,
    })
}

fn departure(departure: &Departure) -> Value {
    let Departure { field, kind, found, expected, reading, advisory, more, .. } = departure;
    json!({
        "field": field,
        "kind": name(*kind),
        "found": found,
        "expected": expected,
        "readable": *reading == Reading::Lenient,
        "advisory": advisory,
        "more": more,
    })
}

fn name(kind: DepartureKind) -> &'static str {
    match kind {
        DepartureKind::Missing => "missing",
        DepartureKind::Unknown => "unknown",
        DepartureKind::Form => "form",
        DepartureKind::Length => "length",
        DepartureKind::Range => "range",
        DepartureKind::Unlisted => "unlisted",
        _ => "other",
    }
}

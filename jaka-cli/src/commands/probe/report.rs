//! Report, for people and as JSON.

use std::fmt::Write;

use jaka_dynamic::{Departure, DepartureKind, Reading};
use jaka_sync::proto::text::{visible, visible_json_line};
use serde_json::{Value, json};

use super::finding::{Finding, Findings, Outcome};

/// Returns each message with its findings, then the text of those that depart.
pub(super) fn text(findings: &Findings) -> String {
    let packs = if findings.packs.is_empty() { "none".to_owned() } else { findings.packs.join(", ") };
    let version = findings.version.as_ref();
    let version = version.map_or_else(|| "does not report its version".to_owned(), |version| format!("{version:?}"));
    let mut text = format!("controller  {version}\njaka        {}\npacks       {packs}\n\n", env!("CARGO_PKG_VERSION"));
    let width = findings.all().map(|finding| finding.name.len()).max().unwrap_or_default();
    for finding in findings.all() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:width$}  {}", finding.name, visible(&in_short(finding)));
        for departure in &finding.departures {
            let _ = writeln!(text, "    {}", visible(&departure.to_string()));
        }
    }
    let _ = writeln!(text, "\n{} asked, {} depart from the spec", findings.asked(), findings.departing());
    let departing = findings.all().filter(|finding| finding.departs());
    for (name, raw) in departing.filter_map(|finding| Some((&finding.name, finding.raw.as_ref()?))) {
        let _ = write!(text, "\n{name}:\n{}\n", visible_json_line(raw));
    }
    text
}

fn in_short(finding: &Finding) -> String {
    match &finding.outcome {
        Outcome::Answered if finding.departures.is_empty() => "ok".to_owned(),
        Outcome::Answered => "departs, but can be read".to_owned(),
        Outcome::Refused { code, message } => format!("refused: code {code}, {message:?}"),
        Outcome::Unreadable(why) if why.is_empty() => "unreadable".to_owned(),
        Outcome::Unreadable(why) => format!("unreadable: {why}"),
        Outcome::NoReply(why) => format!("no reply: {why}"),
        Outcome::NotProbed(why) => format!("not probed: {why}"),
    }
}

/// Returns the findings as one JSON object, with the text of every received message.
pub(super) fn json(findings: &Findings) -> String {
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

//! The report for people.

use std::fmt::Write;

use jaka_sync::proto::text::{visible, visible_json_line};

use super::finding::{Finding, Findings, Outcome};

/// Each message with what was found in it, then the text of those that depart.
pub(super) fn text(findings: &Findings) -> String {
    let packs = if findings.packs.is_empty() { "none".to_owned() } else { findings.packs.join(", ") };
    let version = findings.version.as_ref();
    let version = version.map_or_else(|| "does not report its version".to_owned(), |version| format!("{version:?}"));
    let mut text = format!("controller  {version}\njaka        {}\npacks       {packs}\n\n", env!("CARGO_PKG_VERSION"));
    let width = findings.all().map(|finding| finding.name.len()).max().unwrap_or_default();
    for finding in findings.all() {
        // A string takes all that is written.
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

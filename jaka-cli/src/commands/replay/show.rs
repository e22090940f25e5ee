//! Recording as text.

use std::cmp::Reverse;
use std::collections::HashMap;

use itertools::Itertools as _;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Event, Port, Recording};

use super::filter::Filter;
use crate::failure::Failure;
use crate::recordings::recorded::{command_of, excerpt, missing, refusal_of};
use crate::terminal::output;
use crate::text::number::count;
use crate::text::utc;

/// Greatest number of shown characters of a message.
const SHOWN: usize = 160;
/// Greatest number of requests in a list of the summary.
const LISTED: usize = 5;

/// Prints the entries, a line each, and a summary.
pub(super) fn print(recording: &Recording, filter: Option<&Filter>) -> Result<(), Failure> {
    let header = &recording.header;
    output::line(&format!("recorded by {}, from {}", header.software, utc::date_and_time(header.started)))?;
    let is_shown = |entry: &&Entry| filter.is_none_or(|filter| filter.shows(entry));
    let entries: Vec<_> = recording.entries.iter().filter(is_shown).collect();
    for entry in &entries {
        output::line(&line(entry))?;
    }
    let mut answers = recording.answers();
    answers.retain(|answered| filter.is_none_or(|filter| filter.names(&answered.request)));
    output::lines(&format!("\n{}{}", requests(answers), packets(&entries)))
}

fn line(entry: &Entry) -> String {
    let Entry { time, port, connection, event, .. } = entry;
    format!("{:12.6}  {:<7} {connection:>2}  {}", time.as_secs_f64(), port.word(), describe(event))
}

fn describe(event: &Event) -> String {
    match event {
        Event::Connected { address } => format!("connected to {address}"),
        Event::Sent(message) => format!("-> {}", excerpt(message, SHOWN)),
        Event::Received(message) => format!("<- {}", excerpt(message, SHOWN)),
        Event::Closed { by, why } => format!("closed by {}: {why}", by.word()),
        Event::Error { text } => format!("error: {text}"),
        Event::Motion { step, text } => format!("{}: {text}", step.word()),
        Event::Dropped { count } => format!("{count} entries are missing here"),
        _ => event.word().to_owned(),
    }
}

/// Returns the number of requests by their outcomes, with the slowest replies and the requests without one.
fn requests(answers: Vec<Answered>) -> String {
    let (mut replies, mut unanswered, mut refused) = (Vec::new(), Vec::new(), 0);
    for Answered { request, sent, answer, .. } in answers {
        let name = command_of(&request).unwrap_or_else(|| "a request without a name".to_owned());
        let line = format!("{:12.6}  {}", sent.as_secs_f64(), visible(&name));
        if let Answer::Reply { reply, after } = answer {
            refused += usize::from(refusal_of(&reply).is_some());
            replies.push((after, format!("{line} after {:.6} s", after.as_secs_f64())));
        } else {
            unanswered.push(line);
        }
    }
    replies.sort_by_key(|(after, _)| Reverse(*after));
    let slowest: Vec<_> = replies.into_iter().map(|(_, line)| line).collect();
    let mut text = String::new();
    let requests = slowest.len() + unanswered.len();
    if requests > 0 {
        let (requests, done) = (count(requests, "request"), slowest.len() - refused);
        text = format!("{requests}: {done} carried out, {refused} refused, {} without reply\n", unanswered.len());
    }
    text + &list("slowest replies", &slowest) + &list("without reply", &unanswered)
}

/// Returns the first of some requests, if there are any.
fn list(title: &str, lines: &[String]) -> String {
    let more = lines.len().saturating_sub(LISTED);
    let more = (more > 0).then(|| format!("{:12}  and {more} more", ""));
    let title = (!lines.is_empty()).then(|| format!("{title}:"));
    title.iter().chain(lines.iter().take(LISTED)).chain(&more).map(|line| line.clone() + "\n").join("")
}

/// Returns the number of status packets, with the longest time between two of a connection, and the number of missing
/// entries.
fn packets(entries: &[&Entry]) -> String {
    let is_packet = |entry: &&&Entry| entry.port == Port::Status && matches!(entry.event, Event::Received(_));
    let mut text = String::new();
    let packets: Vec<_> = entries.iter().filter(is_packet).collect();
    if !packets.is_empty() {
        let mut last = HashMap::new();
        let gaps = packets.iter().filter_map(|entry| {
            let before = last.insert(entry.connection, entry.time)?;
            Some((entry.time.saturating_sub(before).as_secs_f64(), entry.time.as_secs_f64()))
        });
        let longest = gaps.max_by(|one, other| one.0.total_cmp(&other.0));
        let longest = longest.map(|(gap, at)| format!(", the longest gap {gap:.6} s before {at:.6}"));
        text = format!("{}{}\n", count(packets.len(), "status packet"), longest.unwrap_or_default());
    }
    match entries.iter().map(|entry| missing(entry)).sum::<u64>() {
        0 => text,
        missing => format!("{text}{missing} entries are missing, because the file could not be written fast enough\n"),
    }
}

//! A recording as text.

use std::collections::HashMap;
use std::fmt;
use std::time::Duration;

use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Event, Port, Recording};

use super::filter::Filter;
use crate::failure::Failure;
use crate::number::count;
use crate::output;
use crate::recorded::{command_of, excerpt, refusal_of};
use crate::utc;

/// How many characters of a message are shown.
const SHOWN: usize = 160;
/// How many requests the summary lists.
const LISTED: usize = 5;

/// Prints the entries, a line each, and a summary.
pub(super) fn print(recording: &Recording, filter: &Filter) -> Result<(), Failure> {
    let header = &recording.header;
    output::line(&format!("recorded by {}, from {}", header.software, utc::date_and_time(header.started)))?;
    for entry in recording.entries.iter().filter(|entry| filter.shows(entry)) {
        output::line(&line(entry))?;
    }
    output::lines(&format!("\n{}", Summary::new(recording, filter)))
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
        Event::Dropped { count } => format!("{count} entries are missing here"),
        _ => event.word().to_owned(),
    }
}

/// Counts of what a recording has in it. Displays a line for each that is not 0.
#[derive(Debug)]
struct Summary {
    requests: usize,
    refused: usize,
    /// The slowest first.
    replies: Vec<ListedRequest>,
    /// The first first.
    unanswered: Vec<ListedRequest>,
    packets: usize,
    /// Between two packets of a connection, and when it ended.
    longest_gap: Option<(Duration, Duration)>,
    dropped: u64,
}

/// A request in a list.
#[derive(Debug)]
struct ListedRequest {
    command: String,
    sent: Duration,
    after: Duration,
}

impl Summary {
    /// Sums up what a filter shows.
    fn new(recording: &Recording, filter: &Filter) -> Self {
        let answers = filter.answers(recording);
        let (mut replies, mut unanswered) = (Vec::new(), Vec::new());
        let mut refused = 0;
        for answered in &answers {
            if let Answer::Reply { reply, after } = &answered.answer {
                refused += usize::from(refusal_of(reply).is_some());
                replies.push(ListedRequest::new(answered, *after));
            } else {
                unanswered.push(ListedRequest::new(answered, Duration::ZERO));
            }
        }
        replies.sort_by_key(|line| std::cmp::Reverse(line.after));
        let shown = || recording.entries.iter().filter(|entry| filter.shows(entry));
        let packets: Vec<_> = shown().filter(|entry| is_packet(entry)).collect();
        let missing = |entry: &Entry| if let Event::Dropped { count } = entry.event { count } else { 0 };
        Self {
            requests: answers.len(),
            refused,
            replies,
            unanswered,
            packets: packets.len(),
            longest_gap: longest_gap(&packets),
            dropped: shown().map(missing).sum(),
        }
    }
}

impl ListedRequest {
    fn new(answered: &Answered, after: Duration) -> Self {
        let command = command_of(&answered.request).unwrap_or_else(|| "a request without a name".to_owned());
        Self { command: visible(&command).into_owned(), sent: answered.sent, after }
    }
}

fn is_packet(entry: &Entry) -> bool {
    entry.port == Port::Status && matches!(entry.event, Event::Received(_))
}

fn longest_gap(packets: &[&Entry]) -> Option<(Duration, Duration)> {
    let mut last = HashMap::new();
    let gaps = packets.iter().filter_map(|entry| {
        let before = last.insert(entry.connection, entry.time)?;
        Some((entry.time.saturating_sub(before), entry.time))
    });
    gaps.max_by_key(|(gap, _)| *gap)
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { requests, refused, replies, unanswered, .. } = self;
        if *requests > 0 {
            let (done, lost) = (replies.len() - refused, unanswered.len());
            writeln!(
                f,
                "{}: {done} carried out, {refused} refused, {lost} without reply",
                count(*requests, "request")
            )?;
        }
        list(f, "slowest replies", replies, |ListedRequest { command, sent, after }| {
            format!("{:12.6}  {command} after {:.6} s", sent.as_secs_f64(), after.as_secs_f64())
        })?;
        list(f, "without reply", unanswered, |line| format!("{:12.6}  {}", line.sent.as_secs_f64(), line.command))?;
        if self.packets > 0 {
            write!(f, "{}", count(self.packets, "status packet"))?;
            if let Some((gap, at)) = self.longest_gap {
                write!(f, ", the longest gap {:.6} s before {:.6}", gap.as_secs_f64(), at.as_secs_f64())?;
            }
            writeln!(f)?;
        }
        match self.dropped {
            0 => Ok(()),
            dropped => writeln!(f, "{dropped} entries are missing, because the file could not be written fast enough"),
        }
    }
}

/// Writes the first of some requests, if there are any.
fn list(
    f: &mut fmt::Formatter<'_>,
    title: &str,
    lines: &[ListedRequest],
    text: impl Fn(&ListedRequest) -> String,
) -> fmt::Result {
    if !lines.is_empty() {
        writeln!(f, "{title}:")?;
    }
    lines.iter().take(LISTED).try_for_each(|line| writeln!(f, "{}", text(line)))?;
    match lines.len().saturating_sub(LISTED) {
        0 => Ok(()),
        more => writeln!(f, "{:12}  and {more} more", ""),
    }
}

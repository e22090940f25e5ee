//! A recording in a few numbers.

use std::collections::HashMap;
use std::fmt;
use std::time::Duration;

use jaka_sync::proto::Envelope;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Answer, Answered, Entry, Event, Message, Port, Recording};

use super::filter::{Filter, name};
use crate::number::count;

/// How many requests are listed.
const LISTED: usize = 5;

/// Counts of what a recording has in it. Displays a line for each that is not 0.
#[derive(Debug)]
pub(super) struct Summary {
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
    pub(super) fn new(recording: &Recording, filter: &Filter) -> Self {
        let answers = filter.answers(recording);
        let (mut replies, mut unanswered) = (Vec::new(), Vec::new());
        let mut refused = 0;
        for answered in &answers {
            if let Answer::Reply { reply, after } = &answered.answer {
                refused += usize::from(is_refusal(reply));
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
        let command = name(&answered.request).unwrap_or_else(|| "a request without a name".to_owned());
        Self { command: visible(&command).into_owned(), sent: answered.sent, after }
    }
}

fn is_refusal(reply: &Message) -> bool {
    reply.text().and_then(|text| Envelope::read(text).ok()).is_some_and(|envelope| envelope.refusal().is_some())
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

//! Requests and their outcomes.

use std::collections::BTreeMap;
use std::time::Duration;

use jaka_sync::recording::{Answer, Answered, Message, Recording};

use super::happenings::{Happening, HappeningKind};
use super::milliseconds;
use crate::plots::Latency;
use crate::recordings::recorded::{command_of, refusal_of};

/// Requests and their outcomes.
#[derive(Debug, Default)]
pub(in crate::commands::report) struct Calls {
    /// Latencies in the order of their times, in seconds.
    pub(in crate::commands::report) latencies: Vec<(f64, Latency)>,
    pub(in crate::commands::report) commands: BTreeMap<String, CommandCount>,
}

/// Outcomes of the requests of a command.
#[derive(Debug, Default)]
pub(in crate::commands::report) struct CommandCount {
    pub(in crate::commands::report) refused: usize,
    pub(in crate::commands::report) unanswered: usize,
    /// Reply times in milliseconds, in increasing order.
    pub(in crate::commands::report) replies: Vec<f64>,
}

impl CommandCount {
    pub(in crate::commands::report) fn requests(&self) -> usize {
        self.replies.len() + self.unanswered
    }
}

impl Calls {
    /// Reads the requests. Also returns an event for each one refused or without a reply.
    pub(super) fn read(recording: &Recording) -> (Self, Vec<Happening>) {
        let mut calls = Self::default();
        let mut answers = recording.answers();
        answers.sort_by_key(|answered| answered.sent);
        let failed = answers.iter().filter_map(|answered| calls.add(answered)).collect();
        for count in calls.commands.values_mut() {
            count.replies.sort_by(f64::total_cmp);
        }
        (calls, failed)
    }

    fn add(&mut self, Answered { request, sent, answer, .. }: &Answered) -> Option<Happening> {
        let name = name(request);
        let count = self.commands.entry(name.clone()).or_default();
        let (latency, failed) = if let Answer::Reply { reply, after } = answer {
            let ms = milliseconds(*after);
            count.replies.push(ms);
            if let Some(what) = refusal(reply, &name) {
                count.refused += 1;
                let arrived = sent.saturating_add(*after);
                (Latency::Refused(ms), Some(Happening::wrong(arrived, HappeningKind::Refused, what)))
            } else {
                (Latency::Accepted(ms), None)
            }
        } else {
            count.unanswered += 1;
            (Latency::Unanswered, Some(unanswered(*sent, &name, answer)))
        };
        self.latencies.push((sent.as_secs_f64(), latency));
        failed
    }
}

fn unanswered(sent: Duration, name: &str, answer: &Answer) -> Happening {
    let why = if let Answer::Closed { .. } = answer { ", since the connection ended" } else { "" };
    Happening::wrong(sent, HappeningKind::Unanswered, format!("no reply to {name} is recorded{why}"))
}

/// Returns the command named in a request.
fn name(request: &Message) -> String {
    command_of(request).map_or_else(|| "a request without a name".to_owned(), |name| format!("`{name}`"))
}

/// Returns the text of the controller's refusal, if the reply is one.
fn refusal(reply: &Message, name: &str) -> Option<String> {
    let refusal = refusal_of(reply)?;
    let message = if refusal.message.is_empty() { String::new() } else { format!(": {}", refusal.message) };
    Some(format!("{name} refused with code {}{message}", refusal.code))
}

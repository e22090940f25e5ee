//! Clones of a client, and what they send by chance. Each checks that it gets its own replies.

use std::ops::Range;
use std::time::Duration;

use jaka_robot::io::{AnalogOutputKind, SetAnalogOutput};
use jaka_robot::power::{DisableRobot, PowerOff};
use jaka_robot::{Client, jaka_sync};
use jaka_sim::SimulatedClock;
use jaka_tests::rig::Random;
use jaka_tests::{LONG, text};
use serde_json::json;

use super::turn;

/// Number of analog outputs of the simulated controller, which refuses those beyond.
const OUTPUTS: i64 = 1024;
/// A query that passes beside set-points, and that the firmware lacks.
const LACKED: &str = "get_funcdi_status";
/// Queries that pass beside set-points.
const QUERIES: [&str; 6] = [
    "get_joint_pos",
    "get_tcp_pos",
    "get_robot_state",
    "get_program_state",
    "get_digital_input_status",
    "protective_stop_status",
];
/// A command that no spec knows.
const UNKNOWN: &str = "nobody_knows_it";

/// Tags of each clone.
const TAGS: u64 = 1_000_000;

/// Number of the clone with this tag.
pub(super) fn number_of(tag: u64) -> u64 {
    tag / TAGS
}

/// Failure of a call.
enum Failed {
    Call(jaka_sync::Error),
    Wrong(String),
}

/// A clone of the client, with tags of its own.
pub(super) struct Sender {
    client: Client,
    number: u32,
    random: Random,
    /// True if set-points move the arm.
    is_led: bool,
    /// Time from which on calls may fail.
    stall: Option<Duration>,
    last_tag: u64,
    sent: Sent,
}

/// Commands of a clone, as sent.
#[derive(Debug, Default)]
pub(super) struct Sent {
    /// Tags of the commands of each finished pipeline, and the number of those that it counts as accepted.
    pub(super) pipelines: Vec<(Range<u64>, u64)>,
    /// Finding of the soak, in words.
    pub(super) found: Option<String>,
}

impl From<jaka_sync::Error> for Failed {
    fn from(error: jaka_sync::Error) -> Self {
        Self::Call(error)
    }
}

/// The call is refused with this tag as the message.
fn check_refused<T>(result: Result<T, jaka_sync::Error>, tag: u64) -> Result<(), Failed> {
    match result {
        Ok(_) => Err(Failed::Wrong(format!("{tag} is accepted"))),
        Err(error) => match error.refusal() {
            Some(refusal) if refusal.message == tag.to_string() => Ok(()),
            Some(refusal) => Err(Failed::Wrong(format!("{tag} is told {refusal:?}"))),
            None => Err(error.into()),
        },
    }
}

impl Sender {
    pub(super) fn new(client: Client, number: u32, random: Random, is_led: bool, stall: Option<Duration>) -> Self {
        let last_tag = u64::from(number + 1) * TAGS;
        Self { client, number, random, is_led, stall, last_tag, sent: Sent::default() }
    }

    fn tag(&mut self) -> u64 {
        self.last_tag += 1;
        self.last_tag
    }

    /// The next output of this handle, or one that the controller refuses.
    fn output(&mut self, is_refused: bool) -> SetAnalogOutput {
        let tag = u32::try_from(self.tag()).expect("tags are small");
        let index = i64::from(self.number) + if is_refused { OUTPUTS } else { 0 };
        SetAnalogOutput::new(AnalogOutputKind::Cabinet, index, f64::from(tag))
    }

    fn outputs(&mut self, count: u32) -> Vec<SetAnalogOutput> {
        (0..count).map(|_| self.output(false)).collect()
    }

    /// Sends until the time, or until a call fails.
    pub(super) fn act(mut self, clock: &SimulatedClock, until: Duration) -> Sent {
        while clock.elapsed() < until {
            let choice = self.random.below(12);
            if let Err(failed) = self.send(choice) {
                let what = match failed {
                    Failed::Call(error) if self.may_fail(clock, &error) => break,
                    Failed::Call(error) => format!("{error:?}"),
                    Failed::Wrong(what) => what,
                };
                self.sent.found = Some(format!("clone {}, choice {choice}: {what}", self.number));
                break;
            }
            clock.sleep(Duration::from_micros(self.random.below(20_000).into()));
        }
        self.sent
    }

    /// True for an error that the stalled link explains.
    fn may_fail(&self, clock: &SimulatedClock, error: &jaka_sync::Error) -> bool {
        let is_of_stall = error.is_disconnected() || error.is_timeout();
        is_of_stall && self.stall.is_some_and(|stall| clock.elapsed() >= stall)
    }

    fn send(&mut self, choice: u32) -> Result<(), Failed> {
        match choice {
            0 => {
                let output = self.output(false);
                Ok(self.client.call(&output)?)
            }
            1 => {
                let output = self.output(true);
                check_refused(self.client.call(&output), self.last_tag)
            }
            2..=4 => {
                let (tag, query) = (self.tag(), QUERIES[self.random.below(6) as usize]);
                let reply = self.client.call_raw(query, &json!({"tag": tag}))?;
                let is_own = reply["tag"] == tag && reply["cmdName"] == query;
                if is_own { Ok(()) } else { Err(Failed::Wrong(format!("`{query}` of {tag} gets {reply}"))) }
            }
            5 => {
                let tag = self.tag();
                check_refused(self.client.call_raw(LACKED, &json!({"tag": tag, "lacked": true})), tag)
            }
            6 if !self.is_led => {
                let tag = self.tag();
                check_refused(self.client.call_raw(UNKNOWN, &json!({"tag": tag})), tag)
            }
            6 | 7 if self.is_led => self.send_kept_back(),
            8 => {
                let count = 30 + self.random.below(70);
                let (first, outputs) = (self.last_tag + 1, self.outputs(count));
                let mut pipeline = self.client.pipeline(256);
                pipeline.send_all(&outputs)?;
                let accepted = pipeline.finish()?;
                self.sent.pipelines.push((first..self.last_tag + 1, accepted));
                Ok(())
            }
            9 => self.send_with_refusals(),
            10 => {
                let outputs = self.outputs(4);
                let mut pipeline = self.client.pipeline(4);
                Ok(pipeline.send_all(&outputs)?)
            }
            _ => {
                (0..5).for_each(|_| drop(self.client.pipeline(1)));
                Ok(())
            }
        }
    }

    fn send_kept_back(&mut self) -> Result<(), Failed> {
        let client = &mut self.client;
        let turn = turn(5.0);
        let result = match self.random.below(6) {
            0 => client.call(&PowerOff::new()),
            1 => client.call(&DisableRobot::new()),
            2 => client.call(&turn),
            3 => client.call_text(&text(&turn), LONG).map(drop),
            4 => client.call_raw(UNKNOWN, &json!({})).map(drop),
            _ => client.get_version().map(drop),
        };
        match result {
            Err(error) if matches!(error.kind(), jaka_sync::ErrorKind::KeptBack { .. }) => Ok(()),
            Err(error) => Err(error.into()),
            Ok(()) => Err(Failed::Wrong("it is not kept back".to_owned())),
        }
    }

    /// Each refusal is told once, before the end, and the commands after it tell it.
    fn send_with_refusals(&mut self) -> Result<(), Failed> {
        let first = self.last_tag + 1;
        let is_refused_at = |random: &mut Random, number| number < 24 && random.one_in(6);
        let outputs: Vec<_> = (0..40).map(|number| is_refused_at(&mut self.random, number)).collect();
        let outputs: Vec<_> = outputs.into_iter().map(|is_refused| self.output(is_refused)).collect();
        let mut values = outputs.iter().filter(|output| output.index >= OUTPUTS).map(|output| output.value.to_string());
        let mut pipeline = self.client.pipeline(8);
        for output in &outputs {
            while let Err(error) = pipeline.send(output) {
                let Some(refusal) = error.refusal() else { return Err(error.into()) };
                if values.next().as_ref() != Some(&refusal.message) {
                    return Err(Failed::Wrong(format!("a pipeline is told {refusal:?}")));
                }
            }
        }
        let accepted = pipeline.finish()?;
        self.sent.pipelines.push((first..self.last_tag + 1, accepted));
        values.next().map_or(Ok(()), |tag| Err(Failed::Wrong(format!("the refusal of {tag} is not told"))))
    }
}

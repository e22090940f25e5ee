//! Shared code of the end-to-end tests: the document's messages, random messages made from the spec, and the seeds of
//! fuzzing.

use std::sync::LazyLock;

use jaka_proto::wire::Writer;
use jaka_robot::{Command, MotionStatus, Robot, RobotConfig};
use jaka_spec::Spec;
use serde_json::{Number, Value};

/// The page's blocks of code.
#[cfg(doctest)]
#[doc = include_str!("../../jaka-sync/docs/newer-firmware.md")]
pub mod newer_firmware {}

mod arm;
mod hand_fed;
pub mod plain_controller;
mod random_messages;
mod recording_buffer;
mod reserved_port;
pub mod resources;
pub mod rig;
mod seeds;
pub mod simulated;
mod skipped;
mod standstill;

pub use arm::{Arm, ArmBuilder, CYCLE, LONG, followed};
pub use hand_fed::{ClockedSocket, HandFed, accepted};
pub use jaka_witness as witness;
pub use random_messages::{any_object, any_request, any_request_of};
pub use recording_buffer::{RecordingBuffer, events, recorded, requests};
pub use reserved_port::ReservedPort;
pub use seeds::seeds;
pub use skipped::{left_out, skipped};

/// Text of a request as it goes over the wire, for a raw call.
pub fn text<C: Command>(command: &C) -> String {
    let mut out = Writer::new();
    command.write_request(&mut out);
    out.as_str().to_owned()
}

/// Robots with options, in one expression.
pub trait Configured: Sized {
    /// Returns the robot with these options.
    ///
    /// # Errors
    /// As [`Robot::configure`].
    fn configured(self, config: &RobotConfig) -> Result<Self, jaka_robot::Error>;
}

impl<S: MotionStatus> Configured for Robot<S> {
    fn configured(mut self, config: &RobotConfig) -> Result<Self, jaka_robot::Error> {
        self.configure(config).map(|()| self)
    }
}

/// Kind of the error of the connection, if a call of it failed.
pub fn failure(error: &jaka_robot::Error) -> Option<&jaka_sync::ErrorKind> {
    error.connection().map(jaka_sync::Error::kind)
}

/// The project's README, for its example to be compiled.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;

/// One message that the document prints.
#[derive(Debug)]
pub struct Printed {
    /// Section, such as `4.7`.
    pub section: String,
    /// True for a request, false for a reply.
    pub is_request: bool,
    /// True if the document prints placeholders.
    pub has_placeholders: bool,
    /// The message as printed, with numbers in place of placeholders.
    pub text: String,
}

/// All messages that the document prints.
///
/// # Panics
/// The data file is damaged.
pub fn printed() -> Vec<Printed> {
    let line = |line: &str| {
        let line: Value = serde_json::from_str(line).expect("each line is JSON");
        let text = |key: &str| line[key].as_str().expect("each line has the key").to_owned();
        let has_placeholders = line["placeholders_filled"] == true;
        Printed {
            section: text("section"),
            is_request: text("direction") == "request",
            has_placeholders,
            text: text("text"),
        }
    };
    include_str!("../data/examples.jsonl").lines().map(line).collect()
}

/// The text without white space outside strings.
pub fn compact(json: &str) -> String {
    let mut in_string = false;
    let mut escaped = false;
    let outside = |c: &char| {
        let keep = in_string || !c.is_whitespace();
        in_string ^= *c == '"' && !escaped;
        escaped = *c == '\\' && !escaped;
        keep
    };
    json.chars().filter(outside).collect()
}

/// Factor on the usual length of the reliability tests: `JAKA_RELIABILITY`, or 1.
pub fn reliability_times() -> u32 {
    std::env::var("JAKA_RELIABILITY").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// The built-in spec.
///
/// # Panics
/// It has errors.
pub fn spec() -> Spec {
    static READ: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the built-in spec is correct"));
    READ.clone()
}

/// True if two JSON values are the same, where 1 and 1.0 are the same number.
pub fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.as_f64() == b.as_f64(),
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
        }
        _ => a == b,
    }
}

/// Returns the number in another form that the field notes list: a string, or a float for a whole number.
pub fn drifted_number(number: &Number, form: u8) -> Value {
    let whole = number.as_i64().and_then(|int| i32::try_from(int).ok());
    match (form % 4, whole) {
        (0, _) => Value::Number(number.clone()),
        (1, Some(int)) => Value::from(f64::from(int)),
        (2, _) => Value::String(format!(" {number} ")),
        _ => Value::String(number.to_string()),
    }
}

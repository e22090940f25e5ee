#![doc = include_str!("../docs/overview.md")]

mod arguments;
mod check;
mod decode;
mod departure;
mod encode;
mod envelope;
mod examples;
mod forms;
mod motion;
mod names;
mod notation;
mod problem;
mod sample;
mod scalar;
mod slot;
mod translation;
mod value;

pub use arguments::{Argument, PossibleValue, arguments};
pub use check::check_request;
pub use departure::{Departure, DepartureKind, Reading};
pub use encode::request;
pub use envelope::{departures, status_departures};
pub use examples::{Misfit, misfits};
pub use forms::Forms;
pub use jaka_proto::check::AdvisoryRanges;
pub use motion::{RequestedMotion, command_info, motion};
pub use notation::notation;
pub use problem::{Problem, ProblemKind};
pub use sample::{complete_reply, is_readable, sample_reply, sample_value};
pub use scalar::truth_value;
pub use translation::{Lost, Message, Translated, Translation, counterpart};
pub use value::value;

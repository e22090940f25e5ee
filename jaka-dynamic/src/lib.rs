#![doc = include_str!("../docs/overview.md")]

mod arguments;
mod departure;
mod encode;
mod examples;
mod firmware;
mod forms;
mod motion;
mod names;
mod problem;
mod sample;
mod scalar;
mod slot;
mod translation;
mod tree;
mod value;

pub use arguments::{Argument, PossibleValue, arguments};
pub use departure::{Departure, DepartureKind, Reading};
pub use encode::request;
pub use examples::{Misfit, misfits};
pub use firmware::{firmware_range, not_in_firmware};
pub use forms::Forms;
pub use jaka_proto::check::AdvisoryRanges;
pub use motion::{RequestedMotion, command_info, motion};
pub use problem::{Problem, ProblemKind};
pub use sample::{complete_reply, sample_reply, sample_value};
pub use translation::{Lost, Message, Translated, Translation, counterpart};
pub use tree::{Label, Node, notation};
pub use value::value;

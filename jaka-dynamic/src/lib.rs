#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]

mod arguments;
mod departure;
mod encode;
mod examples;
mod firmware;
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
pub use jaka_proto::check::AdvisoryRanges;
pub use motion::{RequestedMotion, command_info, motion};
pub use problem::{Problem, ProblemKind};
pub use sample::{complete_reply, sample_reply, sample_value};
pub use translation::{Message, Translated, Translation, counterpart};
pub use tree::{Label, Node, notation};
pub use value::value;

#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// On the host of the documentation each item says which feature it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

// Generated code names this crate by its absolute path.
extern crate self as jaka_proto;

pub mod check;
mod command;
mod controller_event;
mod envelope;
pub mod exchange;
mod firmware;
pub mod framing;
pub mod geometry;
mod motion;
mod near;
pub mod recording;
mod refusal;
mod reply;
mod request;
pub mod text;
pub mod wire;
mod worded;

/// The messages, generated from the spec: a module for each topic, an enum over all requests, and the enums of
/// their meaning.
pub mod messages {
    jaka_proto_derive::messages!();
}

pub use command::{Command, CommandInfo, Visit};
pub use controller_event::{ControllerEvent, EventNote, UnreadableEvent};
pub use envelope::Envelope;
pub use firmware::{FirmwareRange, FirmwareVersion, InvalidFirmwareVersion, NotInFirmware};
pub use messages::{Change, Effect, Request, Requirement, Role, Severity};
pub use motion::{Motion, Path, Target};
pub use refusal::{ErrorCode, Refusal};
pub use reply::{Reply, read_envelope, read_payload, read_reply, write_refusal, write_reply};
pub use request::RequestError;
pub use wire::python;

/// Items that macros of this crate name; no part of the interface.
#[doc(hidden)]
pub mod __private {
    pub use serde;
}

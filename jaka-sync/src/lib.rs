#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// In the hosted documentation each item shows the feature that it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod client;
mod config;
mod connection;
mod disconnect;
mod error;
pub mod layer;
mod link;
mod methods;
mod monitor;
mod motion_status;
mod on_drop;
mod pack;
mod packets;
mod pipeline;
mod receive;
mod recorder;
mod remedy;
mod snapshot;
mod status_problem;
mod status_stream;
mod status_subset;
mod stop;
mod sync;

pub use client::Client;
pub use config::{Config, Reconnect};
pub use disconnect::Disconnect;
pub use error::{Error, ErrorKind};
/// A simulated clock, for tests. Needs the feature `simulated-clock`.
#[cfg(feature = "simulated-clock")]
pub use jaka_clock::{self, SimulatedClock};
/// The layer below: messages, framing and codec, without I/O.
pub use jaka_proto as proto;
#[doc(no_inline)]
pub use jaka_proto::geometry;
#[doc(inline)]
pub use jaka_proto::messages::Request;
#[doc(no_inline)]
pub use jaka_proto::recording;
#[doc(no_inline)]
pub use jaka_proto::{
    Command, CommandInfo, ControllerEvent, Effect, ErrorCode, FirmwareRange, FirmwareVersion, NotInFirmware, Refusal,
    Requirement, Severity, UnreadableEvent,
    check::{AdvisoryRanges, InvalidArgument},
    wire::{DecodeError, Typed},
};
pub use methods::*;
pub use monitor::{Monitor, MonitorStatistics, Subscription};
pub use motion_status::MotionStatus;
pub use pack::Call;
pub use pipeline::Pipeline;
pub use recorder::{Recorder, RecorderReport, Track};
pub use remedy::Remedy;
pub use snapshot::Snapshot;
pub use status_problem::StatusProblem;
pub use status_stream::StatusStream;
pub use stop::StopHandle;

/// Port on which a controller takes commands.
pub const COMMAND_PORT: u16 = 10001;

/// Port on which a controller sends status packets.
pub const STATUS_PORT: u16 = 10000;

// Its blocks of code are tests of jaka-tests, which has the other crates, too.
#[cfg(all(doc, not(doctest)))]
#[doc = include_str!("../docs/newer-firmware.md")]
pub mod newer_firmware {}

/// Items that macros of this crate name; not part of the interface.
#[doc(hidden)]
pub mod __private {
    pub use jaka_proto_derive::{pack, status_subset};
}

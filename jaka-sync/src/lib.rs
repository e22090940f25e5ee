#![doc = include_str!("../docs/overview.md")]

mod address;
mod call;
mod cause;
mod client;
mod clock;
mod config;
mod connection;
mod disconnect;
mod error;
#[cfg(feature = "stream")]
mod follow;
mod link;
mod methods;
mod monitor;
mod pack;
mod packets;
mod pipeline;
mod ports;
mod receive;
mod reconnect;
mod recorder;
mod report;
mod robot;
mod servo_session;
#[cfg(feature = "stream")]
mod servo_thread;
mod snapshot;
mod socket;
mod status_problem;
mod status_stream;
mod status_subset;
mod stop;
#[cfg(feature = "stream")]
mod stream;
mod sync;

pub use call::Call;
#[cfg(feature = "motion")]
pub use cause::Unchecked;
pub use cause::{
    Cause, CauseGroup, Evidence, Explanation, GuardTrip, LagBeyondReaction, NotGuarded, NotShown, Occurrence, Remedy,
    TripReason,
};
pub use client::Client;
pub use config::Config;
pub use disconnect::Disconnect;
pub use error::{End, Error, ErrorKind, Phase, Rest};
#[cfg(feature = "stream")]
pub use follow::{FollowConfig, FollowHandle, FollowProgress, FollowRun};
/// A simulated clock, for tests. Needs the feature `simulated-clock`.
#[cfg(feature = "simulated-clock")]
pub use jaka_clock::{self, SimulatedClock};
/// Kinematics and limits. Needs the feature `motion`.
#[cfg(feature = "motion")]
pub use jaka_motion;
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
pub use pipeline::Pipeline;
pub use reconnect::Reconnect;
pub use recorder::{Recorder, RecorderReport, StatusSampling, Track};
pub use report::Report;
#[cfg(feature = "stream")]
pub use report::{FollowLag, TrajectoryReport};
#[cfg(feature = "motion")]
pub use robot::LimitPolicy;
pub use robot::{
    AnalogCondition, AnalogInput, ForceComponent, ForceLimit, Guard, Input, InputCondition, Motion, MotionStatus,
    Numbering, Path, PowerStep, Robot, RobotStop, Target, TcpBox,
};
#[cfg(feature = "preflight")]
pub use robot::{CheckItem, Finding, Preflight, Verdict};
pub use servo_session::{ServoConfig, ServoSession};
pub use snapshot::Snapshot;
pub use status_problem::StatusProblem;
pub use status_stream::StatusStream;
pub use stop::StopHandle;
#[cfg(feature = "stream")]
pub use stream::{Stream, StreamConfig, StreamHandle};

/// The port on which a controller takes commands.
pub const COMMAND_PORT: u16 = 10001;

/// The port on which a controller sends status packets.
pub const STATUS_PORT: u16 = 10000;

#[cfg(any(doc, doctest))]
#[doc = include_str!("../docs/newer-firmware.md")]
pub mod newer_firmware {}

#[cfg(any(doc, doctest))]
// Its tests take simulated time.
#[cfg_attr(any(not(doctest), feature = "simulated-clock"), doc = include_str!("../docs/cookbook.md"))]
pub mod cookbook {}

/// What macros of this crate name; no part of the interface.
#[doc(hidden)]
pub mod __private {
    pub use jaka_proto_derive::{pack, status_subset};
}

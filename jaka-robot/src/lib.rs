#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// On the host of the documentation each item says which feature it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod arm;
mod cause;
mod error;
mod follow;
#[cfg(feature = "serde")]
mod form;
mod guard;
mod input_wait;
mod inputs;
mod limits;
pub mod motions;
mod place;
mod planned;
mod power_steps;
pub mod preflight;
mod report;
mod robot;
mod servo_session;
mod servo_thread;
#[cfg(feature = "stream")]
mod stream;
mod under_way;

/// Locks and signals of shuttle in place of std's, for tests of interleavings: a file of jaka-sync.
#[cfg(all(test, shuttle))]
#[path = "../../jaka-sync/src/sync.rs"]
#[allow(dead_code, unreachable_pub, reason = "jaka-sync uses and shows all of it")]
mod sync;

/// Kinematics and limits.
pub use jaka_motion;
/// The connection: the crate below. This crate exports all its names.
pub use jaka_sync;
#[doc(no_inline)]
pub use jaka_sync::*;

pub use arm::{RobotStop, wait_for_rest};
pub use cause::{
    Cause, CauseGroup, Evidence, GuardTrip, LagBeyondReaction, NotGuarded, NotShown, Occurrence, Remedy,
    ServoModeState, TripReason, Unchecked,
};
pub use error::{End, Error, ErrorKind, Phase, Rest};
pub use follow::{FollowConfig, FollowHandle, FollowProgress, FollowRun};
pub use guard::{ForceComponent, ForceLimit, Guard, TcpBox};
pub use inputs::{AnalogCondition, AnalogInput, Input, InputCondition, Numbering};
pub use jaka_proto::{Motion, Path, Target};
pub use motions::{MotionExt, Run};
pub use power_steps::PowerStep;
pub use report::{FollowLag, Report, TrajectoryReport};
pub use robot::{HasRobot, Robot, RobotConfig};
pub use servo_session::{ServoConfig, ServoSession, SessionConfig};
#[cfg(feature = "stream")]
pub use stream::{Stream, StreamConfig, StreamHandle};
pub use under_way::{FrameChange, SelectedFrames};

#[cfg(any(doc, doctest))]
// Its tests take simulated time.
#[cfg_attr(any(not(doctest), feature = "simulated-clock"), doc = include_str!("../docs/cookbook.md"))]
pub mod cookbook {}

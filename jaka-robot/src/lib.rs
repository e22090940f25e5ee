#![doc = include_str!("../docs/overview.md")]

mod cause;
mod error;
#[cfg(feature = "stream")]
mod follow;
mod report;
mod robot;
mod servo_session;
#[cfg(feature = "stream")]
mod servo_thread;
#[cfg(feature = "stream")]
mod stream;

/// Kinematics and limits.
pub use jaka_motion;
/// The connection: the crate below, all names of which stand here, too.
pub use jaka_sync;
#[doc(no_inline)]
pub use jaka_sync::*;

pub use cause::{
    Cause, CauseGroup, Evidence, Explanation, GuardTrip, LagBeyondReaction, NotGuarded, NotShown, Occurrence, Remedy,
    TripReason, Unchecked,
};
pub use error::{End, Error, ErrorKind, Phase, Rest};
#[cfg(feature = "stream")]
pub use follow::{FollowConfig, FollowHandle, FollowProgress, FollowRun};
pub use report::Report;
#[cfg(feature = "stream")]
pub use report::{FollowLag, TrajectoryReport};
pub use robot::{
    AnalogCondition, AnalogInput, CheckItem, Finding, ForceComponent, ForceLimit, Guard, Input, InputCondition,
    LimitPolicy, Motion, Numbering, Path, PowerStep, Preflight, Robot, RobotStop, Target, TcpBox, Verdict,
};
pub use servo_session::{ServoConfig, ServoSession};
#[cfg(feature = "stream")]
pub use stream::{Stream, StreamConfig, StreamHandle};

#[cfg(any(doc, doctest))]
// Its tests take simulated time.
#[cfg_attr(any(not(doctest), feature = "simulated-clock"), doc = include_str!("../docs/cookbook.md"))]
pub mod cookbook {}

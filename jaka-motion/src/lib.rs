#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// The documentation host shows the required feature of each item.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod arc;
mod beyond;
#[cfg_attr(not(feature = "generator"), expect(dead_code, reason = "stops from any state are those of the generator"))]
mod braking;
mod checker;
mod closed_form;
mod damped;
mod follower;
mod frames;
#[cfg(feature = "generator")]
mod generator;
mod limits;
mod links;
mod model;
mod newton;
mod offset_wrist;
mod piece;
mod speed;
#[cfg(any(feature = "toml", feature = "trajectory-files"))]
mod text_file;
mod trajectory;
mod transform;

#[cfg(test)]
mod tests;

pub use arc::Arc;
pub use beyond::{Beyond, Exceeded, Way};
pub use braking::{StopBound, StraightStop};
pub use checker::Checker;
pub use follower::{Follower, Overtravel, Stopping};
pub use frames::Frames;
#[cfg(feature = "generator")]
pub use generator::{Bound, Dynamics, Generator, GeneratorError, Goal, Landing, Step};
/// Crate with the types of joint positions and poses.
pub use jaka_proto as proto;
pub use limits::{InvalidLimit, Limits, Preset, Region, RegionFrame};
pub use model::{
    Branches, DhMismatch, Fit, FitError, Model, NoSolution, Point, Singularity, SingularityDistance, Tolerance,
};
pub use piece::Sample;
pub use speed::{JointSpeed, TcpSpeed};
#[cfg(feature = "generator")]
pub use speed::{TcpVelocity, VelocityFrame};
#[cfg(any(feature = "toml", feature = "trajectory-files"))]
pub use text_file::FileError;
#[cfg(feature = "toml")]
pub use text_file::FileErrors as LimitsFileError;
#[cfg(feature = "trajectory-files")]
pub use text_file::FileErrors as TrajectoryFileError;
pub use trajectory::{
    Curve, Passing, RateChange, SlowPlace, SlowedBy, Through, TimedPoint, Trajectory, TrajectoryError, Via, ViaTarget,
    WayPoint,
};
pub use transform::Transform;

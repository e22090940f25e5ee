#![doc = include_str!("../README.md")]

mod answer;
mod book;
mod builder;
mod command_port;
mod controller;
mod door;
mod fault;
mod lock;
mod motion;
mod shared;
mod state;
mod status_port;
mod tape;

pub use builder::{Builder, Takeover};
pub use controller::Controller;
pub use fault::Fault;
/// The messages that [`State`] is made of.
pub use jaka_proto as proto;
/// A state that a command needs, as the spec says it: see [`State::meets`].
pub use jaka_spec::Requirement;
pub use state::{
    AdmittanceControl, Frame, NetworkException, Payload, State, ToolVoltage, TorqueSensor, Trajectory, TrajectoryConfig,
};

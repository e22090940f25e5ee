#![doc = include_str!("../README.md")]

mod answer;
mod book;
mod builder;
mod clock;
mod command_port;
mod controller;
mod delays;
mod door;
mod fault;
mod firmware;
mod habits;
mod kinematics;
mod link;
mod lock;
mod motion;
mod program;
mod replay;
mod shared;
mod state;
mod status_port;
mod tape;
mod world;

pub use builder::{Builder, Takeover};
pub use controller::{Controller, Link};
pub use delays::Delays;
pub use fault::{Fault, FaultPlan, LinkEvent, LinkFault, ScriptError, StatusFault};
pub use firmware::{CodeStyle, Firmware, KeyOrder, NumberStyle, ReplyStyle, Separators, TruthStyle};
pub use habits::{Habit, HabitError, Habits};
/// The messages that [`State`] is made of.
pub use jaka_proto as proto;
/// A state that a command needs, as the spec says it: see [`State::meets`].
pub use jaka_spec::Requirement;
pub use kinematics::Model;
pub use link::{Direction, Port};
pub use replay::{Deviation, Replay, ReplayTiming};
pub use state::{
    AdmittanceControl, Frame, NetworkException, Payload, State, ToolVoltage, TorqueSensor, Trajectory, TrajectoryConfig,
};

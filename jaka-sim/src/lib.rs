#![doc = include_str!("../docs/overview.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]

mod answer;
mod builder;
mod clock;
mod command_port;
mod connection;
mod contact;
mod controller;
mod delays;
mod fault;
mod firmware;
mod habits;
mod happening;
mod json_text;
mod link;
mod link_selector;
mod listener;
mod motion;
mod noise;
mod programs;
mod readers;
mod replay;
mod request_log;
mod shared;
mod spec_index;
mod state;
mod status_packet;
mod status_port;
mod stop_in_servo;
mod trigger;
mod trips;
mod underrun;
mod world;

pub use builder::{Builder, Takeover};
pub use contact::Contact;
pub use controller::{Controller, Link};
pub use delays::Delays;
pub use fault::{Fault, FaultPlan, LinkFault, ScriptError, StatusFault};
pub use firmware::Firmware;
pub use habits::{Habit, Habits};
pub use happening::{Happening, Level, Scheduled};
/// Clock for tests without real time.
pub use jaka_clock::{self, SimulatedClock};
/// Model of the simulated arm.
pub use jaka_motion::Model;
/// Message types of a [`State`].
pub use jaka_proto as proto;
/// Port of the controller: for commands or for status packets.
pub use jaka_proto::recording::Port;
/// State required by a command, in the terms of the spec: see [`State::meets`].
pub use jaka_spec::Requirement;
pub use link_selector::Direction;
pub use replay::{Deviation, Replay, ReplayTiming};
pub use state::{AdmittanceControl, Frame, State, TorqueSensor, Trajectory};
pub use stop_in_servo::StopInServo;
pub use trigger::Trigger;
pub use trips::Trip;
pub use underrun::Underrun;

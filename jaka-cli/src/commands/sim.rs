//! `jaka sim`: a simulated controller for clients in any language.

mod fault_list;
mod schedule;

use std::path::PathBuf;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use clap::Args;
use itertools::Itertools as _;
use jaka_sim::{
    Builder, Controller, Delays, FaultPlan, Firmware, Habits, Model, Scheduled, StopInServo, Takeover, Trip, Underrun,
};

use crate::arm::interrupt::end_on_interrupt;
use crate::choice::{Choice, one_of};
use crate::failure::Failure;
use crate::listen::ListenArgs;
use crate::target::Lookup;
use crate::target::model;
use crate::target::packs::SpecArgs;
use crate::terminal::{logging, output};

/// Run a simulated controller until it is interrupted.
///
/// Anyone who can reach the ports can move the simulated arm, and nothing else.
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own")]
#[derive(Debug, Args)]
#[command(after_long_help = fault_list::text())]
pub(crate) struct Sim {
    #[command(flatten)]
    listen: ListenArgs,
    /// Model of the arm, such as zu5; `list` for all [default: zu5]
    #[arg(long, value_name = "NAME")]
    model: Option<String>,
    /// Firmware of the controller, which determines the form of packets and replies, and habits: 1.5.14, newer or
    /// document
    #[arg(long, value_name = "NAME", default_value_t, value_parser = firmware)]
    firmware: Firmware,
    /// Period of status packets in milliseconds [default: that of the firmware]
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u64).range(1..))]
    period: Option<u64>,
    /// Folder of programs to load: files with one request per line; repeat it for more
    #[arg(long, value_name = "FOLDER")]
    programs: Vec<PathBuf>,
    #[command(flatten)]
    spec: SpecArgs,
    /// Faults of replies and packets, such as `drop, delay 200ms` or `status slow 2s`; @FILE reads them from a file
    #[arg(long, value_name = "TEXT", value_parser = faults)]
    faults: Option<FaultPlan>,
    /// Undocumented habits of the controller, such as `pause 100ms, events`; `all`, or `none` [default: the firmware's]
    #[arg(long, value_name = "LIST")]
    habits: Option<Habits>,
    /// Lag of the arm behind its commanded positions, in milliseconds
    #[arg(long, value_name = "MS", default_value_t)]
    lag: u64,
    /// Thresholds at which the drives stop the arm with an error, such as `deviation 1.5, command-acceleration 2000`,
    /// in deg, deg/s and deg/s²
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    trips: Vec<Trip>,
    /// Reaction of the arm if set-points stop while it moves: `hold`, `fault 40ms`, or `run-out 300`, in deg/s²
    #[arg(long, value_name = "TEXT", default_value_t)]
    underrun: Underrun,
    /// Reaction of the controller to `stop_program` in servo mode: `discard` its waiting set-points, `ignore` the stop,
    /// `leave` servo mode and brake, or end it with a `fault`
    #[arg(long, value_name = "TEXT", default_value_t = StopInServo::Discard)]
    stop_in_servo: StopInServo,
    /// Treatment of a client that connects to the command port while another one is connected there
    #[arg(long, value_name = "WHAT", default_value = "replaces", value_parser = one_of(&SECOND_CLIENTS))]
    second_client: Takeover,
    /// Ratio of the controller's time to real time, for motions, delays and status packets
    #[arg(long, value_name = "NUMBER", default_value_t = 1.0)]
    time_scale: f64,
    /// Switch power and enable at once, instead of after some seconds
    #[arg(long)]
    fast: bool,
    /// Give the arm power and enable it from the start
    #[arg(long)]
    powered: bool,
    /// Events of the arm, of inputs and of links, with their times since the start, such as
    /// `collide at 2s, link both to-client hold at 5s`, by the controller's clock
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    schedule: Vec<Scheduled>,
    /// Read events from standard input, one a line, as in --schedule; an event without a time occurs at once
    #[arg(long)]
    stdin: bool,
    /// Print each message received and sent
    #[arg(long)]
    log: bool,
}

/// Rules for a second client; both were observed.
const SECOND_CLIENTS: [Choice<Takeover>; 2] = [
    ("replaces", "It replaces the first one, whose connection is closed", Takeover::Replace),
    ("is-refused", "Its connection is closed", Takeover::Refuse),
];

impl Sim {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if self.model.as_deref() == Some("list") {
            return Model::published().iter().try_for_each(|model| output::line(model.name()));
        }
        if self.log {
            logging::print("jaka_sim");
        }
        end_on_interrupt(0);
        let controller = self.listen.start(self.builder()?, |controller| {
            if self.powered {
                controller.set_state(|state| (state.powered, state.enabled) = (true, true));
            }
        })?;
        let (sender, typed) = mpsc::channel();
        if self.stdin {
            schedule::begin_lines(sender);
        } else {
            drop(sender);
        }
        schedule::run(&controller, self.schedule, &typed)?;
        loop {
            thread::park();
        }
    }

    fn builder(&self) -> Result<Builder, Failure> {
        let mut builder = Controller::builder();
        let packs = self.spec.load(Lookup::default())?.packs;
        builder = packs.iter().fold(builder, Builder::pack);
        builder = builder.firmware(self.firmware);
        if let Some(name) = &self.model {
            let model = model(name).map_err(|text| Failure::Usage(format!("there is no model `{name}`; {text}")))?;
            builder = builder.model(model.clone());
        }
        if let Some(ms) = self.period {
            builder = builder.status_period(Duration::from_millis(ms));
        }
        builder = builder.time_scale(self.time_scale).takeover(self.second_client);
        builder = builder.lag(Duration::from_millis(self.lag)).trips(self.trips.iter().copied());
        builder = builder.underrun(self.underrun).stop_in_servo(self.stop_in_servo);
        builder = self.programs.iter().fold(builder, Builder::programs_from);
        if let Some(plan) = &self.faults {
            builder = builder.faults(plan.clone());
        }
        if let Some(habits) = self.habits {
            builder = builder.habits(habits);
        }
        Ok(if self.fast { builder.delays(Delays::NONE) } else { builder })
    }
}

fn firmware(name: &str) -> Result<Firmware, String> {
    let found = Firmware::ALL.iter().find(|firmware| firmware.name() == name).copied();
    found.ok_or_else(|| format!("there are {}", Firmware::ALL.iter().map(|firmware| firmware.name()).join(", ")))
}

fn faults(text: &str) -> Result<FaultPlan, String> {
    let read = |path| jaka_spec::read_text(path).map_err(|error| format!("cannot read `{path}`: {error}"));
    let text = text.strip_prefix('@').map_or_else(|| Ok(text.to_owned()), read)?;
    text.parse().map_err(|error| {
        format!("{error}; the faults of replies are {}; `jaka sim --help` has all", fault_list::words())
    })
}

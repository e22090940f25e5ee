//! Host of the simulated controllers: this process, or another one, so that the memory of this process is the memory of
//! the clients.

use std::io::{self, BufRead, BufReader, Write};
use std::net::SocketAddr;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use jaka_sim::jaka_clock::Clock;
use jaka_sim::{Controller, Delays, SimulatedClock};
use serde_json::json;

use super::faults;
use crate::standstill::Standstill;

/// Period of status packets.
const PERIOD: Duration = Duration::from_millis(20);

/// The rate of motions in the beginning; the first of those that rise.
pub(super) const FIRST_RATE: f64 = 0.5;

/// Host of the simulated controllers.
///
/// It takes orders as lines of text and answers each with a line, in this process as well.
#[derive(Debug)]
pub struct Host(Mutex<Place>);

#[derive(Debug)]
enum Place {
    Here(Controllers),
    Elsewhere { child: Child, orders: Option<ChildStdin>, answers: BufReader<ChildStdout> },
}

/// The ports of a controller, and its time.
#[derive(Debug, Clone)]
pub(super) struct Ports {
    pub(super) commands: SocketAddr,
    pub(super) status: SocketAddr,
    pub(super) time: Clock,
}

impl Host {
    /// In this process, each with a simulated clock of its own, which its clients share.
    pub fn here() -> Self {
        Self(Mutex::new(Place::Here(Controllers { are_simulated: true, ..Controllers::default() })))
    }

    /// In another process, which runs [`serve`] on its standard input and output.
    ///
    /// # Errors
    /// It cannot be started.
    pub fn elsewhere(mut command: Command) -> io::Result<Self> {
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let (Some(orders), Some(answers)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(io::ErrorKind::BrokenPipe.into());
        };
        Ok(Self(Mutex::new(Place::Elsewhere { child, orders: Some(orders), answers: BufReader::new(answers) })))
    }

    /// # Panics
    /// The other process is gone.
    fn ask(&self, order: &str) -> String {
        let mut place = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match &mut *place {
            Place::Here(controllers) => controllers.obey(order),
            Place::Elsewhere { orders, answers, .. } => {
                let mut answer = String::new();
                let mut orders = orders.as_ref().expect("it takes orders until it is dropped");
                let asked = orders.write_all(format!("{order}\n").as_bytes());
                asked.and_then(|()| answers.read_line(&mut answer)).expect("the process of the simulators goes on");
                answer.trim_end().to_owned()
            }
        }
    }

    /// Starts the controllers of a round.
    pub(super) fn begin(&self, seed: u64, round: u32, arms: u32) -> Vec<Ports> {
        let answer = self.ask(&format!("begin {seed} {round} {arms}"));
        let addresses: Vec<SocketAddr> = answer.split(' ').map(|address| address.parse().expect("it is one")).collect();
        let place = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let time = |arm: usize| match &*place {
            Place::Here(controllers) => controllers.all[arm].clock().map_or_else(Clock::default, Clock::simulated),
            Place::Elsewhere { .. } => Clock::default(),
        };
        let pairs = addresses.chunks(2).enumerate();
        pairs.map(|(arm, pair)| Ports { commands: pair[0], status: pair[1], time: time(arm) }).collect()
    }

    /// Sets what is wrong with an arm's status packets: one of [`faults::of_status`].
    pub(super) fn status_fault(&self, arm: u32, fault: usize) {
        self.ask(&format!("status {arm} {fault}"));
    }

    /// The requests that an arm's controller has received in this round.
    pub(super) fn requests(&self, arm: u32) -> Vec<String> {
        serde_json::from_str(&self.ask(&format!("requests {arm}"))).expect("it answers with an array")
    }

    /// Ends the controllers of a round.
    pub(super) fn end(&self) {
        self.ask("end");
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        let place = self.0.get_mut().unwrap_or_else(PoisonError::into_inner);
        if let Place::Elsewhere { child, orders, .. } = place {
            // Without orders to come it ends.
            drop(orders.take());
            child.wait().ok();
        }
    }
}

/// Runs the controllers of a [`Host`] in another process, on standard input and output, until there are no more orders.
///
/// # Errors
/// What the pipes report.
pub fn serve() -> io::Result<()> {
    let mut controllers = Controllers::default();
    for order in io::stdin().lines() {
        let answer = controllers.obey(&order?);
        writeln!(io::stdout(), "{answer}")?;
    }
    Ok(())
}

/// The controllers of a round.
#[derive(Debug, Default)]
struct Controllers {
    all: Vec<Controller>,
    /// Watches of their clocks, which end after the controllers.
    standstills: Vec<Standstill>,
    are_simulated: bool,
}

impl Controllers {
    fn obey(&mut self, order: &str) -> String {
        let words: Vec<_> = order.split(' ').collect();
        let number = |at: usize| words[at].parse::<u32>().expect("orders have numbers");
        match words[0] {
            "begin" => self.begin(words[1].parse().expect("the seed is a number"), number(2), number(3)),
            "status" => {
                self.all[number(1) as usize].status_fault(faults::of_status()[number(2) as usize].clone());
                String::new()
            }
            "requests" => json!(self.all[number(1) as usize].requests()).to_string(),
            _ => {
                self.all.clear();
                self.standstills.clear();
                String::new()
            }
        }
    }

    fn begin(&mut self, seed: u64, round: u32, arms: u32) -> String {
        let clock = || self.are_simulated.then(SimulatedClock::new);
        self.all = (0..arms).map(|arm| controller(seed, round, arm, clock().as_ref())).collect();
        self.standstills = self.all.iter().filter_map(Controller::clock).map(Standstill::end_test).collect();
        let ports = self.all.iter().map(|one| format!("{} {}", one.command_addr(), one.status_addr()));
        ports.collect::<Vec<_>>().join(" ")
    }
}

fn controller(seed: u64, round: u32, arm: u32, clock: Option<&SimulatedClock>) -> Controller {
    let builder = Controller::builder().delays(Delays::NONE).status_period(PERIOD);
    let builder = clock.into_iter().fold(builder, jaka_sim::Builder::clock);
    let builder = builder.faults(faults::plan(&faults::script(seed, round, arm)));
    let links = faults::links(seed, round, arm).into_iter();
    let builder = links.fold(builder, |builder, scheduled| builder.at(scheduled.at, scheduled.happening));
    let controller = builder.start().expect("loopback has free ports");
    controller.set_state(|state| {
        state.powered = true;
        state.enabled = true;
        state.rapid_rate = FIRST_RATE;
    });
    controller
}

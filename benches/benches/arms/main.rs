//! Many arms from one process: a servo session at 125 Hz and a monitor at 50 Hz for each, compared with bare loops with
//! the same sockets.
//!
//! Options: `--seconds N` for each turn (5), `--rounds N` (2), `--arms N` for one number of arms (1, 10 and 100).

mod bare;
mod session;
mod worker;

use std::error::Error;

use jaka_benches::system::child::Server;
use jaka_benches::system::options;
use jaka_benches::system::report::{self, Target};

use self::worker::Figures;

type Failure = Box<dyn Error>;

/// The status period of the simulated controllers, in milliseconds.
const STATUS: &str = "20";

/// Counts of the set-points and status packets of one arm.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    /// Set-points sent.
    cycles: u64,
    /// Set-points that were never sent since the next one was due.
    lost: u64,
    /// Set-points sent more than half a period late.
    late: u64,
    /// Set-points that were answered.
    answered: u64,
    /// Status packets read.
    packets: u64,
}

impl Tally {
    fn add(&mut self, other: Self) {
        self.cycles += other.cycles;
        self.lost += other.lost;
        self.late += other.late;
        self.answered += other.answered;
        self.packets += other.packets;
    }
}

fn main() -> Result<(), Failure> {
    if let Some(role) = options::text("--role") {
        return worker::run(&role);
    }
    let seconds = options::number("--seconds", 5)?;
    let rounds = options::number("--rounds", 2)?;
    let steps = match options::number("--arms", 0)? {
        0 => vec![1, 10, 100],
        arms => vec![arms],
    };
    report::title(
        "Many arms from one process",
        format_args!(
            "{rounds} rounds of {seconds} s of each; set-points at 125 Hz, status packets at 50 Hz, simulators in another process"
        ),
    );
    Figures::print_head();
    for arms in steps {
        let server = Server::start(env!("CARGO_BIN_EXE_robots"), &[&arms.to_string(), STATUS], None)?;
        let (mut ours, mut bare) = (Figures::default(), Figures::default());
        for round in 0..rounds {
            let mut turns = [("sessions", &mut ours), ("bare", &mut bare)];
            turns.rotate_left(round as usize % 2);
            for (role, sum) in turns {
                sum.add(&worker::start(role, server.robots(), seconds)?);
            }
        }
        bare.print("bare loops", arms);
        ours.print("sessions", arms);
        let more = 1000.0 * (ours.lost_share() - bare.lost_share());
        report::verdict(&format!("of 1000 cycles, lost beyond the bare loops, {arms} arms"), more, Target::AtMost(0.0));
    }
    Ok(())
}

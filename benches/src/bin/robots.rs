//! Simulated controllers in a process of their own: `robots COUNT STATUS_PERIOD_MS`.

use std::error::Error;
use std::time::Duration;

use jaka_benches::system::child;
use jaka_sim::{Controller, Delays, Firmware};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut number =
        || arguments.next().ok_or("robots COUNT STATUS_PERIOD_MS")?.parse::<u32>().map_err(Box::<dyn Error>::from);
    let (count, period) = (number()?, Duration::from_millis(number()?.into()));
    // The packets of the figures in docs/performance.md, which are the document's.
    let start =
        || Controller::builder().firmware(Firmware::Document).delays(Delays::NONE).status_period(period).start();
    let controllers = (0..count).map(|_| start()).collect::<Result<Vec<_>, _>>()?;
    for controller in &controllers {
        controller.set_state(|state| {
            state.powered = true;
            state.enabled = true;
        });
        println!("{} {}", controller.command_addr(), controller.status_addr());
    }
    println!();
    Ok(child::wait_for_parent()?)
}

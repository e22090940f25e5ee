//! A pipeline of settings to a simulated controller in the same process, in real time: how long it takes. The time of
//! processors is that of both.
//!
//! `cargo run -p jaka-tests --example pipeline -- 100000 256`: how many, and how many are outstanding.

use std::time::Instant;

use jaka_sync::io::SetDigitalOutput;
use jaka_sync::types::Switch;
use jaka_tests::Arm;

fn main() -> Result<(), jaka_sync::Error> {
    let mut numbers = std::env::args().skip(1).map_while(|text| text.parse::<usize>().ok());
    let (count, window) = (numbers.next().unwrap_or(100_000), numbers.next().unwrap_or(256));
    let (arm, mut client) = Arm::real_time().with_client();
    let since = Instant::now();
    let mut pipeline = client.pipeline(window);
    for index in (0..8).cycle().take(count) {
        pipeline.send(&SetDigitalOutput::cabinet(index, Switch::On))?;
    }
    let accepted = pipeline.finish()?;
    println!("{accepted} commands in {:.2?}, {} outstanding at most", since.elapsed(), window.clamp(1, 256));
    drop(arm);
    Ok(())
}

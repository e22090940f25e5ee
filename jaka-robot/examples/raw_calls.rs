//! Calls that no spec knows, and the raw JSON of replies.
//!
//! `cargo run --example raw_calls` runs against a simulated controller; with an address, against a robot. It only
//! reads.

mod common;

use std::error::Error;
use std::process::ExitCode;

use jaka_robot::Client;
use serde_json::json;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    let mut robot = Client::connect(&target.commands)?;

    println!("\nA typed call, and the text of its reply:");
    let state = robot.get_robot_state()?;
    println!("  {state:?}");
    println!("  {}", robot.last_reply().unwrap_or_default());

    println!("\nThe same command by name:");
    let reply = robot.call_raw("get_robot_state", &json!({}))?;
    println!("  enable: {}, power: {}", reply["enable"], reply["power"]);

    println!("\nWith parameters:");
    let parameters = json!({"jointPosition": [0, 0, 90, 0, 90, 0]});
    let reply = robot.call_raw("kine_forward", &parameters)?;
    println!("  {}", reply["cartPosition"]);

    println!("\nA command of newer firmware, which this controller may not know:");
    match robot.call_raw("demo_motion_state", &json!({})) {
        Ok(reply) => println!("  {reply}"),
        Err(error) if error.is_refused() => println!("  {error}"),
        Err(error) => return Err(error.into()),
    }
    Ok(())
}

//! Texts of errors, and the questions that a program can ask them.
//!
//! `cargo run --example errors` runs against a simulated controller; with an address, against a robot. It causes errors
//! that move nothing: the arm must not be enabled.

mod common;

use std::error::Error as StdError;
use std::process::ExitCode;
use std::time::Duration;

use jaka_robot::jaka_sync::{Client, Config, Error};
use jaka_robot::motion::JointMove;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn StdError>> {
    let target = common::target()?;
    let mut robot = Client::connect(&target.commands)?;
    if robot.get_robot_state()?.enabled {
        return Err("the arm is enabled: disable it first, so that no motion is accepted".into());
    }

    println!("\nAn argument that the spec forbids is not sent:");
    report(&robot.set_rapid_rate(1.5));

    println!("\nA motion that the controller refuses, since the arm is not enabled:");
    let mut request = JointMove::relative([0.0; 6], 1.0);
    report(&robot.joint_move(&request));

    println!("\nNot a number, deep inside a request:");
    request.joint_position.0[3] = f64::NAN;
    report(&robot.joint_move(&request));

    println!("\nAfter all of this the connection is fine: {:?}", robot.get_robot_state()?);

    println!("\nNobody at the address:");
    let nobody = Client::connect_with(&Config::new().connect_timeout(Duration::from_millis(500)), "127.0.0.1:1");
    report(&nobody.map(drop));

    println!("\nThe session has ended:");
    robot.quit()?;
    report(&robot.get_robot_state().map(drop));
    Ok(())
}

/// Prints an error, its sources, and its remedy.
fn report(result: &Result<(), Error>) {
    let Err(error) = result else {
        println!("  no error");
        return;
    };
    println!("  {error}");
    let mut source = error.source();
    while let Some(cause) = source {
        println!("    because: {cause}");
        source = cause.source();
    }
    if let Some(refusal) = error.refusal() {
        println!("    code {}: {}", refusal.code, refusal.code.meaning().unwrap_or("not in any document"));
    }
    println!("    may have run: {}, disconnected: {}", error.may_have_run(), error.is_disconnected());
}

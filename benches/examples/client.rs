//! For `benches/build-time`: a small program that uses jaka-sync, the generator included.

use std::error::Error;

use jaka_sync::motion::JointMove;
use jaka_sync::{Client, StatusStream};

fn main() -> Result<(), Box<dyn Error>> {
    let address = std::env::args().nth(1).ok_or("which robot?")?;
    let mut robot = Client::connect(&address)?;
    robot.joint_move(&JointMove::absolute([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 20.0))?;
    let status = StatusStream::connect(&address)?.next_packet()?;
    println!("{:?}", status.joint_actual_position);
    Ok(())
}

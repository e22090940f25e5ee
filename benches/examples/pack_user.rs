//! For `benches/build-time`: a program with a command pack.

jaka_sync::pack!("../tests/pack-user/newer.toml");

use newer::NewerCommands as _;

fn main() -> Result<(), jaka_sync::Error> {
    let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
    println!("{:?} {:?}", robot.get_joint_pos()?, robot.demo_motion_state()?);
    Ok(())
}

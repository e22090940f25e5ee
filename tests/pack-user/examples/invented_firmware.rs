//! Programs with a robot of an invented firmware, which differ from others in TOML alone.
//!
//! With the two ports of the controller on loopback: commands of a pack, a motion that is waited for, a stop, and a
//! setting. With `upstream` and the ports of two controllers, of the invented firmware and of an older one: one program
//! for both, by a pack with the fields of both.

use std::error::Error;
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::proto::wire::Typed;
use jaka_robot::{Call as _, Cause, Client, Config, FirmwareVersion, Monitor, MotionStatus, Robot};

jaka_robot::pack!("../invented_firmware/invented.toml");
jaka_robot::pack!("../invented_firmware/upstream.toml");

const LONG: Duration = Duration::from_secs(10);

fn main() -> Result<(), Box<dyn Error>> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let is_upstream = words.first().is_some_and(|word| word == "upstream");
    let ports: Vec<u16> = words.drain(usize::from(is_upstream)..).map(|port| port.parse()).collect::<Result<_, _>>()?;
    match (is_upstream, &ports[..]) {
        (false, [commands, status]) => glides(&mut robot::<invented::RobotStatus>(*commands, *status)?),
        (true, [commands, status, older_commands, older_status]) => {
            turns(&mut robot(*commands, *status)?)?;
            turns(&mut robot(*older_commands, *older_status)?)?;
            println!("one program for both");
            Ok(())
        }
        _ => Err("give the port of commands and that of status packets, of one controller or of two".into()),
    }
}

fn robot<S: MotionStatus>(commands: u16, status: u16) -> Result<Robot<S>, Box<dyn Error>> {
    let [commands, status] = [commands, status].map(|port| format!("127.0.0.1:{port}"));
    let config = Config::new();
    let monitor = Monitor::connect_with(&config, status)?;
    Ok(Robot::with_monitor(Client::connect_with(&config, commands)?, monitor)?)
}

fn glides(robot: &mut Robot<invented::RobotStatus>) -> Result<(), Box<dyn Error>> {
    use invented::InventedCommands as _;

    let far = invented::DemoGlide::new([40.0, 90.0, 90.0, 90.0, -90.0, 0.0], 30.0);
    robot.run(&far, LONG)?.reached()?;
    println!("the arm is there");

    let plan = robot.client().demo_glide(&invented::DemoGlide::new([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 30.0))?.plan;
    println!("it goes back in {:.1} s", plan.seconds);
    robot.client().demo_halt()?;
    robot.wait_for_rest(LONG)?;
    robot.acknowledge();

    robot.start(&far)?;
    robot.stop_handle().stop()?;
    let end = robot.wait(LONG);
    if end.cause() != Cause::Stopped {
        return Err(format!("it was stopped: {end}").into());
    }
    println!("{end}");
    Ok(())
}

fn turns(robot: &mut Robot<upstream::RobotStatus>) -> Result<(), Box<dyn Error>> {
    use upstream::UpstreamCommands as _;

    let firmware = robot.client().check_firmware()?;
    let (array, object) = (Typed::Known([1.0, 2.0, 3.0].into()), Typed::Raw(r#"{"x":1.0,"y":2.0,"z":3.0}"#.parse()?));
    let [older, newer] = [upstream::SetPayload::new(array).mass(1.5), upstream::SetPayload::new(object).weight(1.5)];
    let (payload, other) = if firmware < FirmwareVersion::new([9, 1]) { (older, newer) } else { (newer, older) };
    match robot.call(&other) {
        Err(error) if error.is_not_in_firmware() => {}
        other => return Err(format!("firmware {firmware} does not have the other key, but: {other:?}").into()),
    }
    robot.call(&payload)?;
    let reply = robot.client().get_payload_upstream()?;
    if (reply.mass, reply.weight, &reply.centroid) != (payload.mass, payload.weight, &payload.centroid) {
        return Err(format!("firmware {firmware} gives back {reply:?}").into());
    }
    let mut joints = robot.client().get_joint_pos()?.joint_position;
    joints.0[0] += 5.0;
    robot.run(&JointMove::absolute(joints, 30.0), LONG)?.reached()?;
    println!("firmware {firmware}: the arm has turned");
    Ok(())
}

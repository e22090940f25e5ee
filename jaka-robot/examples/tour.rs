//! A tour of the SDK: power, motion, outputs, frames, servo filter, programs and status.
//!
//! `cargo run --example tour` runs it against a simulated controller, `cargo run --example tour 10.5.5.100` against a
//! robot. On a robot it switches power on, moves joint 1 by two degrees and back, switches digital output 1 of the
//! cabinet on and off, and leaves everything else as it was; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use jaka_robot::frames::SetToolOffsets;
use jaka_robot::io::SetDigitalOutput;
use jaka_robot::motion::JointMove;
use jaka_robot::power::GetRobotStateReply;
use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::types::{JointPosition, MoveMode, Pose, Switch};
use jaka_robot::{Client, StatusStream};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 1 will move by 2 deg. Clear the area.")?;
    let mut robot = Client::connect(&target.commands)?;
    let mut status = StatusStream::connect(&target.status)?;
    println!("Version: {}", robot.get_version()?.version);

    power_up(&mut robot)?;
    move_and_return(&mut robot)?;
    switch_output(&mut robot, &mut status)?;
    tool_frame(&mut robot, target.is_simulated)?;
    servo_filter(&mut robot)?;
    programs(&mut robot, target.is_simulated)?;
    show_status(&mut status)?;
    power_down(&mut robot)?;

    robot.quit()?;
    println!("Done.");
    Ok(())
}

fn power_up(robot: &mut Client) -> Result<(), Box<dyn Error>> {
    println!("\nPower on and enable");
    robot.power_on()?;
    wait_for("power", robot, |state| state.powered_on)?;
    robot.enable_robot()?;
    wait_for("enabled", robot, |state| state.enabled)
}

/// A reply without error does not prove the new state; only the state itself does.
fn wait_for(
    what: &str,
    robot: &mut Client,
    reached: impl Fn(&GetRobotStateReply) -> bool,
) -> Result<(), Box<dyn Error>> {
    let deadline = Instant::now() + Duration::from_secs(30);
    while Instant::now() < deadline {
        let state = robot.get_robot_state()?;
        if reached(&state) {
            println!("  powered on: {}, enabled: {}", state.powered_on, state.enabled);
            return Ok(());
        }
        std::thread::sleep(Duration::from_millis(100));
    }
    Err(format!("the robot was not {what} within 30 s").into())
}

fn move_and_return(robot: &mut Client) -> Result<(), Box<dyn Error>> {
    println!("\nMove joint 1 by 2 deg, and back");
    let start = robot.get_joint_pos()?.joint_position;
    println!("  at {}", joints(start));
    let mut away = start;
    away.0[0] += 2.0;
    for joint_position in [away, start] {
        let mode = MoveMode::Absolute;
        robot.joint_move(&JointMove::new(mode, joint_position, 5.0).acceleration(10.0))?;
        arrive(robot, joint_position)?;
    }
    Ok(())
}

/// The reply to a motion says that it was accepted; the joints show the position of the arm.
fn arrive(robot: &mut Client, target: JointPosition) -> Result<(), Box<dyn Error>> {
    let deadline = Instant::now() + Duration::from_secs(30);
    while Instant::now() < deadline {
        let position = robot.get_joint_pos()?.joint_position;
        if position.0.iter().zip(target.0).all(|(is, wanted)| (is - wanted).abs() < 0.05) {
            println!("  at {}", joints(position));
            return Ok(());
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    robot.stop_program()?;
    Err("the arm did not arrive within 30 s, and was stopped".into())
}

fn joints(position: JointPosition) -> String {
    let joints: Vec<_> = position.0.iter().map(|joint| format!("{joint:.2}")).collect();
    format!("[{}] deg", joints.join(", "))
}

fn switch_output(robot: &mut Client, status: &mut StatusStream) -> Result<(), Box<dyn Error>> {
    println!("\nSwitch digital output 1 of the cabinet on and off");
    for value in [Switch::On, Switch::Off] {
        robot.set_digital_output(&SetDigitalOutput::cabinet(1, value))?;
        // A packet that has arrived by now is older than the reply; the packet after it is not.
        status.newest_packet()?;
        let outputs = status.next_packet()?.digital_outputs.unwrap_or_default();
        println!("  set {value:?}; the status shows {:?}", &outputs[..outputs.len().min(4)]);
    }
    Ok(())
}

fn tool_frame(robot: &mut Client, may_change: bool) -> Result<(), Box<dyn Error>> {
    println!("\nTool frames");
    if may_change {
        let offset = Pose { x: 0.0, y: 0.0, z: 120.0, rx: 0.0, ry: 0.0, rz: 90.0 };
        robot.set_tool_offsets(&SetToolOffsets::new(offset, 3, "gripper"))?;
        robot.set_tool_id(3)?;
        println!("  set frame 3 and selected it");
    }
    let offsets = robot.get_tool_offsets()?.offsets;
    for (id, offset) in offsets.iter().enumerate().filter(|(_, offset)| **offset != Pose::from([0.0; 6])) {
        println!("  frame {id}: {offset:?}");
    }
    if may_change {
        robot.set_tool_id(0)?;
        println!("  selected the flange again");
    }
    Ok(())
}

fn servo_filter(robot: &mut Client) -> Result<(), Box<dyn Error>> {
    println!("\nServo filter");
    robot.set_servo_move_filter(&SetServoMoveFilter::disabled())?;
    println!("  disabled; in servo mode: {}", robot.is_in_servomove()?.in_servo_mode);
    Ok(())
}

fn programs(robot: &mut Client, may_play: bool) -> Result<(), Box<dyn Error>> {
    println!("\nPrograms");
    if may_play {
        robot.load_program("test.jks")?;
        println!("  loaded {}", robot.get_loaded_program()?.program_name);
        robot.play_program()?;
        println!("  played; state: {:?}", robot.get_program_state()?.program_state);
        robot.stop_program()?;
    }
    println!("  state: {:?}", robot.get_program_state()?.program_state);
    Ok(())
}

fn show_status(status: &mut StatusStream) -> Result<(), Box<dyn Error>> {
    println!("\nStatus");
    let now = status.newest_packet()?;
    println!("  {} bytes", now.length.unwrap_or_default());
    println!("  task state {:?}, mode {:?}", now.task_state, now.task_mode);
    println!("  enabled {:?}, in position {:?}, rapid rate {:?}", now.enabled, now.in_position, now.rapid_rate);
    println!("  protective stop {:?}, emergency stop {:?}", now.protective_stop, now.emergency_stop);
    Ok(())
}

fn power_down(robot: &mut Client) -> Result<(), Box<dyn Error>> {
    println!("\nDisable and power off");
    robot.disable_robot()?;
    robot.power_off()?;
    wait_for("powered off", robot, |state| !state.powered_on)
}

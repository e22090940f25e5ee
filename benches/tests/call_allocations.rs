//! Allocations of calls.

use std::net::{SocketAddr, TcpListener};
use std::thread;
use std::time::Duration;

use allocation_counter::measure;
use jaka_benches::system::canned;
use jaka_robot::servo::ServoJ;
use jaka_robot::{Client, Config, Monitor, Robot, RobotConfig, ServoConfig};

/// Address of the command port of a server with printed answers.
fn commands() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || canned::serve(&listener));
    address
}

/// Address of a status port that sends no packet.
fn status() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || canned::keep_silent(&listener));
    address
}

fn set_point() -> ServoJ {
    ServoJ::relative([0.0; 6]).step_count(1.into())
}

#[test]
fn a_call_with_a_reply_of_fixed_shape_allocates_nothing() {
    let mut client = Client::connect(commands()).expect("the server listens");
    client.get_joint_pos().expect("it answers");
    let allocations = measure(|| {
        for _ in 0..100 {
            client.get_joint_pos().expect("it answers");
        }
    });
    assert_eq!(allocations.count_total, 0);
}

#[test]
fn a_pipeline_allocates_nothing_once_its_window_has_been_full() {
    let mut client = Client::connect(commands()).expect("the server listens");
    let mut pipeline = client.pipeline(16);
    let mut send = |count| (0..count).try_for_each(|_| pipeline.send(&set_point())).expect("it answers");
    send(100);
    assert_eq!(measure(|| send(1000)).count_total, 0);
}

#[test]
fn a_set_point_allocates_nothing_but_room_for_how_late_it_was() {
    let monitor: Monitor = Monitor::connect_with(&Config::new(), status()).expect("the server listens");
    let mut robot =
        Robot::new(Client::connect(commands()).expect("the server listens"), monitor).expect("it is the only robot");
    robot.configure(&RobotConfig::new().allow_motion_without_status()).expect("it has no limits");
    // Room for answers that a busy machine lets wait.
    let mut pipeline = robot.client().pipeline(100);
    (0..100).try_for_each(|_| pipeline.send(&set_point())).expect("it answers");
    pipeline.finish().expect("it answers");
    let mut session =
        robot.enter_servo_mode(ServoConfig::new().max_unanswered(Duration::from_secs(30))).expect("it answers");
    let mut send = |count| (0..count).try_for_each(|_| session.send_joint_offset([0.0; 6])).expect("it answers");
    // The report's list has room for 128 then.
    send(65);
    assert_eq!(measure(|| send(60)).count_total, 0);
}

//! Pipelines: commands that do not wait for one another's replies.

use std::io::{Read, Write};
use std::time::Duration;

use jaka_sim::{Controller, Fault, SimulatedClock};
use jaka_sync::io::SetDigitalOutput;
use jaka_sync::layer::ClientParts as _;
use jaka_sync::program::SetRapidRate;
use jaka_sync::servo::ServoJ;
use jaka_sync::types::Switch;
use jaka_sync::{Client, Config, ErrorKind, Recorder};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, ClockedSocket};

/// Reply timeout where no reply comes.
const SHORT: Duration = Duration::from_millis(300);

fn connected() -> (Arm, Client) {
    Arm::real_time().without_power().with_client()
}

/// As [`connected`], and the controller has answered the commands of these tests: until then, one at a time goes out.
fn tried() -> (Arm, Client) {
    let (controller, mut client) = connected();
    client.set_digital_output(&output(0)).expect("the controller has such an output");
    client.call(&SetRapidRate::new(1.0)).expect("it is a rate");
    (controller, client)
}

/// A client of somebody who has answered one output, and answers nothing more.
fn unanswered(clock: &SimulatedClock) -> (ClockedSocket, Client) {
    let config = Config::new().clock(clock).reply_timeout(SHORT);
    let (mut server, mut client) = ClockedSocket::accepted(clock, |address| Client::connect_with(&config, address));
    let answer = || {
        server.read_exact(&mut [0; 1]).expect("the output comes");
        let reply = r#"{"errorCode": "0", "errorMsg": "", "cmdName": "set_digital_output"}"#;
        server.write_all(reply.as_bytes()).expect("the client reads");
    };
    beside(clock, answer, || client.set_digital_output(&output(0)).expect("it is answered"));
    (server, client)
}

fn output(index: i64) -> SetDigitalOutput {
    SetDigitalOutput::cabinet(index, Switch::On)
}

/// A command that the controller refuses outside servo mode.
fn set_point() -> ServoJ {
    ServoJ::relative([0.0; 6])
}

/// The connection works, and answers belong to their questions.
fn assert_usable(controller: &Controller, client: &mut Client) {
    let joints = [1.0, 2.0, 3.0, 4.0, 5.0, 6.5];
    controller.set_state(|state| state.joint_position = joints.into());
    assert_eq!(client.get_joint_pos().expect("the connection works").joint_position, joints.into());
}

#[test]
fn all_commands_go_out_in_order_and_no_more_than_the_window_is_outstanding() {
    for window in [0, 1, 2, 7, 64, 1000, usize::MAX] {
        let (controller, mut client) = connected();
        let mut pipeline = client.pipeline(window);
        for index in 0..100 {
            pipeline.send(&output(index % 8)).expect("the controller has such outputs");
            assert!((1..=window.max(1)).contains(&pipeline.outstanding()));
        }
        assert_eq!(pipeline.finish().expect("nothing was refused"), 100);
        let requests = controller.requests();
        assert_eq!(requests.len(), 100);
        let in_order = |(number, request): (usize, &String)| request.contains(&format!("\"index\":{}", number % 8));
        assert!(requests.iter().enumerate().all(in_order), "{requests:?}");
        assert_usable(&controller, &mut client);
    }
}

#[test]
fn a_full_window_is_waited_for_down_to_its_half() {
    let (controller, mut client) = tried();
    for fault in [Fault::None, Fault::None, Fault::Drop, Fault::Drop] {
        controller.inject(fault);
    }
    let mut pipeline = client.pipeline(4);
    for index in 0..5 {
        pipeline.send(&output(index)).expect("two answers make room");
    }
    assert_eq!((pipeline.accepted(), pipeline.outstanding()), (2, 3));
}

#[test]
fn commands_that_are_sent_together_go_out_in_order_and_are_recorded_one_by_one() {
    let file = std::env::temp_dir().join(format!("jaka-pipeline-{}.jsonl", std::process::id()));
    let recorder = Recorder::create(&file).expect("the folder for temporary files can be written");
    let (controller, mut client) = Arm::real_time().config(|config| config.recorder(recorder.clone())).with_client();
    let mut pipeline = client.pipeline(16);
    let outputs: Vec<_> = (0..100).map(|number| output(number % 8)).collect();
    pipeline.send_all(&outputs).expect("the controller has such outputs");
    assert_eq!(pipeline.sent(), 100);
    assert_eq!(pipeline.finish().expect("nothing was refused"), 100);
    let requests = controller.requests();
    let in_order = |(number, request): (usize, &String)| request.contains(&format!("\"index\":{}", number % 8));
    assert!(requests.len() == 100 && requests.iter().enumerate().all(in_order), "{requests:?}");
    assert_usable(&controller, &mut client);
    drop(client);
    recorder.finish().expect("the file can be written");
    let text = std::fs::read_to_string(&file).expect("it was written");
    assert_eq!(text.lines().filter(|line| line.matches("set_digital_output").count() == 1).count(), 200);
    std::fs::remove_file(&file).expect("it is ours");
}

#[test]
fn one_wrong_command_keeps_all_those_of_its_call_from_being_sent() {
    let (controller, mut client) = connected();
    // The window has room for one command at a time.
    let mut pipeline = client.pipeline(1);
    let wrong = [output(1), output(2), output(-1)];
    assert!(pipeline.send_all(&wrong).expect_err("no output has such a number").is_invalid_argument());
    assert_eq!(pipeline.sent(), 0);
    assert_eq!(pipeline.finish().expect("nothing was sent"), 0);
    assert_eq!(controller.requests(), Vec::<String>::new());
}

/// So the pipeline never waits for room.
#[test]
fn a_refusal_that_another_thread_has_read_is_told_by_the_next_call() {
    let (_controller, mut client) = tried();
    let mut other = client.try_clone().expect("the connection is there");
    let mut pipeline = client.pipeline(8);
    pipeline.send(&set_point()).expect("its reply has not been read");
    other.get_joint_pos().expect("it reads both replies");
    let error = pipeline.send(&output(1)).expect_err("the set-point was refused");
    assert!(error.is_refused(), "{error:?}");
    assert_eq!((pipeline.sent(), pipeline.accepted(), pipeline.outstanding()), (1, 0, 0));
    pipeline.send(&output(1)).expect("the refusal was told");
    assert_eq!(pipeline.finish().expect("it is accepted"), 1);
}

#[test]
fn pipelines_that_are_dropped_again_and_again_are_no_evidence_of_lost_replies() {
    let (controller, mut client) = connected();
    let stop = client.stop_handle();
    for _ in 0..50 {
        let mut pipeline = client.pipeline(8);
        for index in 0..9 {
            pipeline.send(&output(index % 8)).expect("each is answered, at once and in order");
        }
        drop(pipeline);
    }
    stop.stop().expect("the connection lives");
    assert_eq!(controller.requests().len(), 50 * 9 + 1);
    assert_usable(&controller, &mut client);
}

#[test]
fn no_more_than_256_commands_are_outstanding_so_that_a_stop_is_of_use() {
    let clock = SimulatedClock::new();
    let (_server, mut client) = unanswered(&clock);
    let outputs: Vec<_> = (0..1000).map(|number| output(number % 8)).collect();
    let mut pipeline = client.pipeline(100_000);
    assert!(pipeline.send_all(&outputs).expect_err("nobody answers").is_timeout());
    assert_eq!(pipeline.sent(), 256);
    // What a dropped pipeline has sent is still to be done.
    drop(pipeline);
    let error = client.pipeline(8).send(&outputs[0]).expect_err("nobody answers");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
    assert!(error.is_timeout() && !error.may_have_run() && !error.is_disconnected());
}

#[test]
fn pipelines_of_two_handles_have_their_own_counts_and_errors() {
    let (controller, mut client) = tried();
    let mut other = client.try_clone().expect("the connection is there");
    let (mut refused, mut accepted) = (client.pipeline(8), other.pipeline(8));
    refused.send(&set_point()).expect("it is not known yet");
    accepted.send_all(&[output(1), output(2), output(3)]).expect("it is not known yet");
    assert_eq!((refused.outstanding(), accepted.outstanding()), (1, 3));
    refused.send(&output(4)).expect("it is not known yet");
    assert_eq!(accepted.finish().expect("its outputs are accepted"), 3);
    assert_eq!(refused.outstanding(), 2);
    let error = refused.finish().expect_err("its set-point is refused");
    assert_eq!(error.refusal().expect("the controller refuses").command, "servo_j");
    assert_usable(&controller, &mut client);
}

#[test]
fn a_dropped_pipeline_gives_up_its_own_replies_alone() {
    let (controller, mut client) = tried();
    let mut other = client.try_clone().expect("the connection is there");
    let mut kept = client.pipeline(8);
    controller.inject(Fault::WithNext);
    kept.send(&output(1)).expect("it is not known yet");
    let mut dropped = other.pipeline(8);
    controller.inject(Fault::WithNext);
    dropped.send(&output(2)).expect("it is not known yet");
    drop(dropped);
    kept.send(&output(3)).expect("it is not known yet");
    assert_eq!(kept.outstanding(), 2);
    assert_eq!(kept.finish().expect("nothing was refused"), 2);
    assert_usable(&controller, &mut client);
}

#[test]
fn beside_a_reservation_eight_commands_of_others_are_outstanding_and_stops_pass() {
    let clock = SimulatedClock::new();
    let (_server, client) = unanswered(&clock);
    let link = client.link();
    let session = link.new_owner();
    let lead = link.lead(client.handle(), session).expect("nothing keeps it back");
    let [mut other, mut third] = [(); 2].map(|()| client.try_clone().expect("the connection is there"));
    let outputs: Vec<_> = (0..100).map(|number| output(number % 8)).collect();
    let mut pipeline = other.pipeline(256);
    let began = clock.elapsed();
    let error = pipeline.send_all(&outputs).expect_err("nobody answers");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
    assert_eq!((pipeline.sent(), clock.elapsed().saturating_sub(began)), (8, SHORT));
    let error = third.set_digital_output(&output(1)).expect_err("nobody answers");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }) && !error.may_have_run(), "{error:?}");
    // What leads the arm is not counted, and no stop waits.
    assert_eq!(client.post(session, None::<&dyn Fn() -> Result<(), ErrorKind>>, &outputs).expect("it has room"), 100);
    for stopped in [third.stop_program(), client.stop_handle().stop()] {
        let error = stopped.expect_err("nobody answers");
        assert!(matches!(error.kind(), ErrorKind::Timeout { .. }), "{error:?}");
    }
    drop(lead);
    pipeline.send_all(&outputs).expect("there is room without it");
}

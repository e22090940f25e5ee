//! Refusals without a name, as controllers send for a command that they do not have, while several requests are
//! outstanding. The controller is a plain socket.

use std::io::{Read, Write};
use std::time::Duration;

use jaka_proto::Command;
use jaka_sim::SimulatedClock;
use jaka_sync::kinematics::GetJointPos;
use jaka_sync::program::{SetRapidRate, StopProgram};
use jaka_sync::{Client, Config, Error, ErrorKind};
use jaka_tests::simulated::{beside, side_by_side};
use jaka_tests::{ClockedSocket, LONG};

const QUERY: &str = GetJointPos::INFO.name;
const STOP: &str = StopProgram::INFO.name;

/// Timeout of a call that is not answered.
const SHORT: Duration = Duration::from_millis(20);

/// Time between two calls that reach the controller in this order.
const LATER: Duration = Duration::from_millis(1);

const REPLY_TIMEOUT: Duration = Duration::from_millis(500);

/// The request that sets the rapid rate.
const RATE: &str = r#"{"cmdName":"rapid_rate","rate_value":0.5}"#;

const REFUSAL: &str = r#"{"errorCode": "1", "errorMsg": "no such command"}"#;

fn connected() -> (SimulatedClock, ClockedSocket, Client) {
    let clock = SimulatedClock::new();
    let config = Config::new().clock(&clock).reply_timeout(REPLY_TIMEOUT);
    let (server, client) = ClockedSocket::accepted(&clock, |address| Client::connect_with(&config, address));
    (clock, server, client)
}

/// A connection on which [`QUERY`] was answered.
fn queried() -> (SimulatedClock, ClockedSocket, Client) {
    let (clock, mut server, mut client) = connected();
    let answer = || {
        receive(&mut server, QUERY);
        write(&mut server, &[&accepted(QUERY)]);
    };
    beside(&clock, answer, || call(&mut client, QUERY, LONG).expect("it is answered"));
    (clock, server, client)
}

fn request(command: &str) -> String {
    format!(r#"{{"cmdName":"{command}"}}"#)
}

fn accepted(command: &str) -> String {
    format!(r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{command}"}}"#)
}

fn call(client: &mut Client, command: &str, timeout: Duration) -> Result<(), Error> {
    client.call_text(&request(command), timeout).map(drop)
}

/// The next request that comes is this one.
fn receive(server: &mut ClockedSocket, command: &str) {
    let mut bytes = vec![0; request(command).len()];
    server.read_exact(&mut bytes).expect("a request comes");
    assert_eq!(String::from_utf8_lossy(&bytes), request(command));
}

/// Writes replies in one piece.
fn write(server: &mut ClockedSocket, replies: &[&str]) {
    server.write_all(replies.concat().as_bytes()).expect("the client reads");
}

fn assert_refused(outcome: Result<(), Error>, command: &str) {
    let error = outcome.expect_err("the controller does not have it");
    let refusal = error.refusal().unwrap_or_else(|| panic!("{error:?}"));
    assert_eq!((&*refusal.command, &*refusal.message), (command, "no such command"));
}

/// The connection works: a stop goes out and is answered.
fn assert_usable(clock: &SimulatedClock, server: &mut ClockedSocket, client: &Client) {
    let answer = || {
        receive(server, STOP);
        write(server, &[&accepted(STOP)]);
    };
    beside(clock, answer, || client.stop_handle().stop().expect("it is accepted"));
}

type Act<'a> = Box<dyn FnOnce() + Send + 'a>;

#[test]
fn the_command_that_was_never_answered_is_refused_and_the_others_go_on() {
    let (clock, mut server, mut client) = queried();
    let mut other = client.try_clone().expect("the connection is there");
    let acts: [Act<'_>; 3] = [
        Box::new(|| assert_refused(call(&mut other, "lacked", LONG), "lacked")),
        Box::new(|| {
            clock.sleep(LATER);
            call(&mut client, QUERY, LONG).expect("it is answered");
        }),
        Box::new(|| {
            receive(&mut server, "lacked");
            receive(&mut server, QUERY);
            write(&mut server, &[REFUSAL, &accepted(QUERY)]);
        }),
    ];
    side_by_side(&clock, acts);
    assert_usable(&clock, &mut server, &client);
}

#[test]
fn a_stop_is_never_taken_for_the_command_that_a_controller_lacks() {
    let (clock, mut server, mut client) = connected();
    let stop = client.stop_handle();
    let acts: [Act<'_>; 3] = [
        Box::new(|| assert_refused(call(&mut client, "lacked", LONG), "lacked")),
        Box::new(|| {
            clock.sleep(LATER);
            stop.stop().expect("it is accepted");
        }),
        Box::new(|| {
            receive(&mut server, "lacked");
            receive(&mut server, STOP);
            write(&mut server, &[REFUSAL, &accepted(STOP)]);
        }),
    ];
    side_by_side(&clock, acts);
    assert_usable(&clock, &mut server, &client);
}

#[test]
fn a_second_command_that_was_never_answered_waits_for_the_first_and_a_stop_does_not() {
    let (clock, mut server, mut client) = connected();
    let (mut other, stop) = (client.try_clone().expect("the connection is there"), client.stop_handle());
    let acts: [Act<'_>; 4] = [
        Box::new(|| assert_refused(call(&mut client, "first", LONG), "first")),
        Box::new(|| {
            clock.sleep(LATER);
            call(&mut other, "second", LONG).expect("it is answered");
        }),
        Box::new(|| {
            clock.sleep(LATER * 2);
            stop.stop().expect("it is accepted");
        }),
        Box::new(|| {
            receive(&mut server, "first");
            receive(&mut server, STOP);
            write(&mut server, &[REFUSAL, &accepted(STOP)]);
            receive(&mut server, "second");
            write(&mut server, &[&accepted("second")]);
        }),
    ];
    side_by_side(&clock, acts);
    assert_usable(&clock, &mut server, &client);
}

#[test]
fn a_command_that_waits_for_another_to_be_answered_keeps_its_deadline_and_did_not_run() {
    let (clock, mut server, mut client) = connected();
    let mut other = client.try_clone().expect("the connection is there");
    let acts: [Act<'_>; 3] = [
        Box::new(|| call(&mut client, "first", LONG).expect("it is answered")),
        Box::new(|| {
            clock.sleep(LATER);
            let since = clock.elapsed();
            let error = call(&mut other, "second", SHORT).expect_err("the first one is not answered");
            assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }) && !error.may_have_run(), "{error:?}");
            assert_eq!(clock.elapsed().saturating_sub(since), SHORT);
        }),
        Box::new(|| {
            receive(&mut server, "first");
            clock.sleep(SHORT * 2);
            assert_eq!(server.waiting(), "");
            write(&mut server, &[&accepted("first")]);
        }),
    ];
    side_by_side(&clock, acts);
    assert_usable(&clock, &mut server, &client);
}

/// The first command has timed out, so that the refusal may be its own.
#[test]
fn a_refusal_that_may_be_that_of_one_of_two_is_told_to_none_until_both_are_refused() {
    for is_refused in [false, true] {
        let (clock, mut server, mut client) = connected();
        let stop = client.stop_handle();
        let error = call(&mut client, "first", SHORT).expect_err("nobody answers");
        assert!(matches!(error.kind(), ErrorKind::Timeout { .. }), "{error:?}");
        receive(&mut server, "first");
        let acts: [Act<'_>; 3] = [
            Box::new(|| {
                let outcome = call(&mut client, "second", LONG);
                if is_refused {
                    assert_refused(outcome, "second");
                } else {
                    let error = outcome.expect_err("whether it was refused is not known");
                    assert!(matches!(error.kind(), ErrorKind::ReplyLost { .. }) && error.may_have_run(), "{error:?}");
                }
            }),
            Box::new(|| {
                clock.sleep(LATER);
                stop.stop().expect("it is accepted");
            }),
            Box::new(|| {
                receive(&mut server, "second");
                receive(&mut server, STOP);
                write(&mut server, &[REFUSAL]);
                clock.sleep(LATER);
                if is_refused {
                    write(&mut server, &[REFUSAL]);
                }
                write(&mut server, &[&accepted(STOP)]);
            }),
        ];
        side_by_side(&clock, acts);
        assert_usable(&clock, &mut server, &client);
    }
}

#[test]
fn a_command_that_is_not_answered_by_name_while_a_refusal_is_held_times_out_and_the_connection_lives() {
    let (clock, mut server, mut client) = connected();
    call(&mut client, "first", SHORT).expect_err("nobody answers");
    receive(&mut server, "first");
    let refuse_one = || {
        receive(&mut server, "second");
        write(&mut server, &[REFUSAL]);
    };
    let outcome = beside(&clock, refuse_one, || call(&mut client, "second", SHORT));
    let error = outcome.expect_err("which of the two was refused is not known");
    assert!(matches!(error.kind(), ErrorKind::Timeout { .. }) && error.may_have_run(), "{error:?}");
    assert_usable(&clock, &mut server, &client);
}

/// A posted command is waited for by nobody in particular.
#[test]
fn a_posted_command_that_is_not_answered_in_its_time_keeps_no_other_command_back() {
    let (clock, mut server, mut client) = connected();
    let mut other = client.try_clone().expect("the connection is there");
    let mut pipeline = other.pipeline(8);
    pipeline.send(&StopProgram::new()).expect("a stop waits for nothing");
    pipeline.send(&SetRapidRate::new(0.5)).expect("it is the first of its kind");
    let since = clock.elapsed();
    let answer = || {
        receive(&mut server, STOP);
        server.read_exact(&mut vec![0; RATE.len()]).expect("a request comes");
        receive(&mut server, "second");
        assert_eq!(clock.elapsed().saturating_sub(since), REPLY_TIMEOUT);
        write(&mut server, &[&accepted("second")]);
    };
    beside(&clock, answer, || call(&mut client, "second", REPLY_TIMEOUT * 2)).expect("it is answered");
    drop(pipeline);
    assert_usable(&clock, &mut server, &client);
}

//! The exchange against one model, which knows whose each reply is: random runs of the exchange alone, and of a client
//! with its stop handles against a server that follows the same script.
//!
//! Without sockets a run takes microseconds, and anything may happen at any moment. With sockets all threads share a
//! simulated clock: after each step time goes on by some nanoseconds, so that everything that the step leads to has
//! happened, and each deadline passes at its exact time.

mod alone;
mod client;
mod model;
mod server;
mod workers;

use std::fmt::Debug;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use proptest::prelude::*;
use proptest::test_runner::{TestError, TestRunner};

use self::alone::Premise;
use self::client::Step;
use self::server::Move;

/// Number of runs with sockets, times `JAKA_RELIABILITY`.
const RUNS: u32 = 300;

/// Number of runs for each premise without sockets, times `JAKA_RELIABILITY`.
const RUNS_ALONE: u32 = 20_000;

/// Time for all runs of a test, times `JAKA_RELIABILITY`: far more than they take.
const LIMIT: Duration = Duration::from_secs(600);

#[test]
fn the_client_does_what_the_model_says() {
    check(RUNS, client::any_step(), client::run);
}

/// Sums of timeouts meet where their differences do not: the deadline of a stop after a short call, and that of a short
/// call after a stop.
#[test]
fn deadlines_that_would_meet_are_kept_apart() {
    let (call, stop) = (Step::Call(0, client::SHORT), Step::Stop);
    let steps = [
        call,
        stop(1),
        Step::Pass,
        stop(0),
        Step::Pass,
        Step::Server(Move::Lose),
        call,
        Step::Server(Move::Accept),
        Step::Pass,
    ];
    client::run(&steps).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn with_one_command_of_a_name_every_reply_is_given_to_its_own_command() {
    check(RUNS_ALONE, alone::any_step(), |steps| {
        alone::run(Premise::OneOfAName, steps);
        Ok(())
    });
}

#[test]
fn with_several_commands_of_a_name_a_lost_reply_alone_can_be_mistaken() {
    check(RUNS_ALONE, alone::any_step(), |steps| {
        alone::run(Premise::SeveralOfAName, steps);
        Ok(())
    });
}

#[test]
fn a_surplus_reply_is_noticed_unless_a_request_of_its_name_is_outstanding() {
    check(RUNS_ALONE, alone::any_step(), |steps| {
        alone::run(Premise::Surplus, steps);
        Ok(())
    });
}

/// Checks random runs. One that fails is shrunk to its shortest form, and one that does not end fails, too.
fn check<S: Debug + Clone + 'static>(
    runs: u32,
    step: impl Strategy<Value = S> + Send + 'static,
    run: fn(&[S]) -> Result<(), String>,
) {
    let times = jaka_tests::reliability_times();
    let config = ProptestConfig { cases: runs * times, failure_persistence: None, ..ProptestConfig::default() };
    let (checked, result) = mpsc::channel();
    thread::spawn(move || {
        let steps = proptest::collection::vec(step, 0..40);
        let ended = TestRunner::new(config).run(&steps, |steps| run(&steps).map_err(TestCaseError::fail));
        checked.send(ended.map_err(|error: TestError<Vec<S>>| error.to_string()))
    });
    let ended = result.recv_timeout(LIMIT * times).expect("all runs end");
    ended.unwrap_or_else(|error| panic!("{error}"));
}

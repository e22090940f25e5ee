//! The real client and its stop handles against a server whose every move the test decides: random runs, each call against
//! a model that knows whose each reply is.
//!
//! The order of events is made by handshakes: the server waits until it has received what was sent, the test waits for each
//! call that the model says has ended and for each late reply that it says was dropped, and a call that is to wait in vain
//! ends before anything else happens.

mod drops;
mod machine;
mod model;
mod run;
mod server;
mod step;
mod workers;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use self::run::run;
use self::step::{Handles, Step, any_step};

/// How many runs, times `JAKA_RELIABILITY`.
const RUNS: u32 = 300;

/// How many without sockets, where a run takes microseconds.
const RUNS_OF_THE_MACHINE: u32 = 30_000;

#[test]
fn the_client_does_what_the_model_says() {
    check(RUNS, run);
}

#[test]
fn the_exchange_without_sockets_does_what_the_model_says() {
    check(RUNS_OF_THE_MACHINE, machine::run);
}

fn check(runs: u32, run: fn(Handles, &[Step]) -> Result<(), String>) {
    let cases = runs * jaka_tests::reliability_times();
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    let handles = prop_oneof![3 => Just(Handles::Patient), 1 => Just(Handles::Hasty)];
    let runs = (handles, proptest::collection::vec(any_step(), 0..40));
    let checked =
        TestRunner::new(config).run(&runs, |(handles, steps)| run(handles, &steps).map_err(TestCaseError::fail));
    checked.unwrap_or_else(|error| panic!("{error}"));
}

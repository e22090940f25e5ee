//! The short form of the soak: `docs/reliability.md` has the long one.
//!
//! One test, alone in its process, so that handles and threads can be counted.

use std::alloc::System;

use jaka_tests::soak::{self, Host, Length, Options};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

#[test]
fn what_is_sent_is_what_comes_and_nothing_is_left_behind() {
    let rounds = 4 * jaka_tests::reliability_times();
    let options = Options { seed: 7, arms: 3, operations: 80, length: Length::Rounds(rounds), allocator: ALLOCATOR };
    let summary = soak::run(&options, Host::here(), &mut std::io::stdout()).expect("lines can be written");
    println!("{summary}");
    assert_eq!(summary.findings(), Vec::<String>::new());
    // It has to have tested something.
    for what in ["accepted", "refused", "broken off", "connections broken", "recordings", "set-points", "packets"] {
        assert!(summary.count(what) > 0, "{what}");
    }
}

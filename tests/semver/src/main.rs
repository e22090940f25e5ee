//! Measures what `jaka spec diff` says about random edits of the spec.
//!
//!     cargo run --manifest-path tests/semver/Cargo.toml --locked -- COUNT SEED [--second-witness]
//!
//! An edit changes one thing in a file of the spec, or in `more.toml`, a topic of constructs that are rare in it. The
//! crate jaka-proto is compiled with the messages of the spec and with those of the edited one. Programs that use the
//! whole interface of the spec (`corpus.rs`) compile with the first, and the compiler says whether they do with the
//! second. `diff` has to say the same, in both directions: for the edit, and for undoing it. A change that is major
//! though every program compiles must be one that shows at run time, such as another unit: `verdict.rs` has the list.
//!
//! With `--second-witness`, `cargo-semver-checks` is asked as well. It does not see types, so that it can only confirm:
//! where it finds a break, programs must not compile.

mod compiler;
mod corpus;
mod draft;
mod edit;
mod measure;
mod random;
mod verdict;
mod witness;

/// The generator, as jaka-proto-derive has it, and as the macros of jaka-proto call it.
#[path = "../../../jaka-proto-derive/src"]
#[allow(dead_code, unused_imports, clippy::all, clippy::pedantic, reason = "the macro crate is checked by itself")]
mod generator {
    pub(crate) mod call;
    pub(crate) mod choice;
    pub(crate) mod client;
    pub(crate) mod codec;
    pub(crate) mod command;
    pub(crate) mod construct;
    pub(crate) mod docs;
    pub(crate) mod enums;
    pub(crate) mod error_codes;
    pub(crate) mod events;
    pub(crate) mod literal;
    pub(crate) mod motion;
    pub(crate) mod role;
    pub(crate) mod scope;
    pub(crate) mod topic;
    pub(crate) mod typedef;
    pub(crate) mod validate;
}

// Modules of the macro crate name one another from its root.
#[allow(unused_imports, reason = "each is named by some module of the macro crate")]
use generator::{
    call, choice, client, codec, command, construct, docs, enums, error_codes, events, literal, motion, role, scope,
    topic, typedef, validate,
};

use std::env;
use std::process::ExitCode;
use std::time::Instant;

use measure::Measure;

const USAGE: &str = "arguments: COUNT SEED [--second-witness]";

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args().skip(1).collect();
    let (numbers, options): (Vec<_>, Vec<_>) = arguments.iter().partition(|argument| !argument.starts_with('-'));
    let numbers: Option<Vec<u64>> = numbers.iter().map(|number| number.parse().ok()).collect();
    let options: Vec<_> = options.iter().map(|option| option.as_str()).collect();
    let (Some([count, seed]), [] | ["--second-witness"]) = (numbers.as_deref(), options.as_slice()) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    println!("{count} edits, seed {seed}");
    let start = Instant::now();
    let mut measure = Measure::new(*seed, !options.is_empty());
    let agreed = (1..=*count).filter(|number| measure.edit(*number)).count();
    println!("{}", measure.drawn_again());
    println!("{agreed} of {count} edits with the compiler's verdict, after {} s", start.elapsed().as_secs());
    if u64::try_from(agreed) == Ok(*count) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

//! Measures what `jaka spec diff` says about random edits of the spec.

mod compiler;
mod corpus;
mod draft;
mod edit;
mod random;
mod verdict;

/// The generator, as jaka-proto-derive has it, and as the macros of jaka-proto call it.
#[path = "../../../jaka-proto-derive/src"]
#[allow(dead_code, unused_imports, clippy::all, clippy::pedantic, reason = "the macro crate is checked by itself")]
mod generator {
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
    pub(crate) mod request;
    pub(crate) mod scope;
    pub(crate) mod topic;
    pub(crate) mod typedef;
    pub(crate) mod validate;
}

// Modules of the macro crate name one another from its root.
#[allow(unused_imports, reason = "each is named by some module of the macro crate")]
use generator::{
    choice, client, codec, command, construct, docs, enums, error_codes, events, literal, motion, request, scope, topic,
    typedef, validate,
};

use std::env;
use std::process::ExitCode;
use std::thread;
use std::time::Instant;

use compiler::{Compiler, Errors};
use draft::Draft;
use edit::Kind;
use jaka_spec::tools::{Change, diff};
use jaka_spec::{BUILTIN, Source, Spec};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;
use random::Random;
use verdict::{Verdict, addition_problem};

const USAGE: &str = "arguments: the number of edits, and a seed";

/// A stand-in for the client of jaka-sync, whose methods the generator writes.
const CLIENT: &str = "
#[derive(Debug)]
pub struct Error;
pub struct Client(());
impl Client {
    pub fn call<C: ::jaka_proto::Command>(&mut self, _request: &C) -> Result<C::Reply, Error> { Err(Error) }
}
";

fn main() -> ExitCode {
    let numbers: Option<Vec<u64>> = env::args().skip(1).map(|argument| argument.parse().ok()).collect();
    let Some([count, seed]) = numbers.as_deref() else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    println!("{count} edits, seed {seed}");
    let start = Instant::now();
    let mut measure = Measure::new(*seed);
    let agreed = (1..=*count).filter(|number| measure.edit(*number)).count();
    println!("{agreed} of {count} edits agree, after {} s", start.elapsed().as_secs());
    println!(
        "drawn again: {} that the loader refuses, {} that code of jaka-proto by hand has to follow",
        measure.refused, measure.by_hand
    );
    if u64::try_from(agreed) == Ok(*count) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The spec that is edited, with its programs.
struct Measure {
    compiler: Compiler,
    random: Random,
    /// Kinds of edits that are still to come in this round.
    kinds: Vec<Kind>,
    draft: Draft,
    spec: Spec,
    messages: String,
    program: String,
    refused: usize,
    by_hand: usize,
}

/// An edit that the loader takes, and whose crate compiles.
struct Edited {
    what: String,
    spec: Spec,
    /// The version whose crate has its code: `old` where an edit changes none.
    version: &'static str,
    changes: Vec<Change>,
    undone: Vec<Change>,
}

impl Measure {
    /// # Panics
    /// The programs of the spec as it is do not compile with its own crate.
    fn new(seed: u64) -> Self {
        let more = Source { path: "spec/more.toml", text: include_str!("../more.toml") };
        let draft = Draft::new(&[BUILTIN, &[more]].concat());
        let spec = draft.load().unwrap_or_else(|errors| panic!("{errors}"));
        let compiler = Compiler::new();
        let messages = messages(&spec);
        compiler.library("old", &messages).unwrap_or_else(|errors| panic!("{errors}"));
        let program = corpus::program(&spec);
        compiler.program("program", &program, "old").unwrap_or_else(|errors| panic!("{errors}"));
        let random = Random::new(seed);
        Self { compiler, random, kinds: Vec::new(), draft, spec, messages, program, refused: 0, by_hand: 0 }
    }

    /// Measures one edit; true if everybody agrees.
    fn edit(&mut self, number: u64) -> bool {
        let edited = loop {
            let kind = self.next_kind();
            if let Some(edited) = (0..ATTEMPTS).find_map(|_| self.draw(kind)) {
                break edited;
            }
        };
        let Edited { what, spec, version, changes, undone } = edited;
        let program = corpus::program(&spec);
        let (compiler, is_known) = (&self.compiler, version == "old" && program == self.program);
        // The programs of the older spec with the newer crate, of the newer one with its own crate, and with the older.
        let (forth, own, back) = thread::scope(|scope| {
            if is_known {
                return (Ok(()), Ok(()), Ok(()));
            }
            let forth = scope.spawn(|| compiler.program("forth", &self.program, version));
            let own = compiler.program("own", &program, version);
            let back = compiler.program("back", &program, "old");
            (forth.join().expect("the compiler runs"), own, back)
        });
        let done = Verdict::new(&self.spec, &spec, &changes, forth.is_ok());
        let undone_verdict = Verdict::new(&spec, &self.spec, &undone, back.is_ok());
        let own = own.err().map(|errors| format!("the programs of the edited spec do not compile: {errors}"));
        let problems: Vec<_> = [
            done.problem(),
            undone_verdict.problem().map(|problem| format!("undone: {problem}")),
            addition_problem(&self.spec, &spec, &changes, back.is_ok()),
            addition_problem(&spec, &self.spec, &undone, forth.is_ok()).map(|problem| format!("undone: {problem}")),
            own,
        ]
        .into_iter()
        .flatten()
        .collect();
        let verdict = if problems.is_empty() { "agree" } else { "DISAGREE" };
        println!("{number:4} {verdict}: {what}: {}; undone: {}", done.words(), undone_verdict.words());
        if !problems.is_empty() {
            for problem in &problems {
                println!("       {problem}");
            }
            for change in &changes {
                println!("       diff: {change}");
            }
            for change in &undone {
                println!("       undone: {change}");
            }
            for line in [&forth, &back].into_iter().filter_map(|result| result.as_ref().err()).flat_map(Errors::lines).take(6) {
                println!("       {line}");
            }
        }
        problems.is_empty()
    }

    /// The next kind of edits: each once in a round, in a random order.
    fn next_kind(&mut self) -> Kind {
        if self.kinds.is_empty() {
            self.kinds = edit::kinds();
            self.random.shuffle(&mut self.kinds);
        }
        self.kinds.pop().expect("there are kinds of edits")
    }

    /// An edit of this kind, or nothing where the loader refuses it or the crate needs other changes.
    fn draw(&mut self, kind: Kind) -> Option<Edited> {
        let mut draft = self.draft.clone();
        let what = (kind.make)(&mut draft, &mut self.random)?;
        let Ok(spec) = draft.load() else {
            self.refused += 1;
            return None;
        };
        let (changes, undone) = (diff(&self.spec, &spec), diff(&spec, &self.spec));
        if changes.is_empty() {
            return None;
        }
        let what = format!("{}: {what}", kind.name);
        let code = messages(&spec);
        if code == self.messages {
            return Some(Edited { what, spec, version: "old", changes, undone });
        }
        match self.compiler.library("new", &code) {
            Ok(()) => Some(Edited { what, spec, version: "new", changes, undone }),
            Err(errors) if errors.are_in_messages() => panic!("{what}: the messages do not compile: {errors}"),
            Err(_) => {
                self.by_hand += 1;
                None
            }
        }
    }
}

/// How often a kind of edits is tried before it is left out.
const ATTEMPTS: usize = 40;

/// The code of all messages of a spec, and of the client's methods, without docs.
fn messages(spec: &Spec) -> String {
    let (messages, methods) = (topic::messages(spec), client::methods(spec));
    format!("{CLIENT}{}", without_docs(quote!(#messages #methods)))
}

/// The code without its attributes `#[doc…]` and `#![doc…]`.
fn without_docs(code: TokenStream) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    for token in code {
        let TokenTree::Group(group) = token else {
            kept.push(token);
            continue;
        };
        let is_doc = matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc");
        if group.delimiter() == Delimiter::Bracket && is_doc {
            let is_mark = |token: &TokenTree| matches!(token, TokenTree::Punct(mark) if "#!".contains(mark.as_char()));
            while kept.last().is_some_and(is_mark) {
                kept.pop();
            }
            continue;
        }
        kept.push(Group::new(group.delimiter(), without_docs(group.stream())).into());
    }
    kept.into_iter().collect()
}

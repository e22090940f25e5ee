//! One edit after the other: what `diff` says, and what the compiler says.

use std::path::PathBuf;
use std::thread;

use jaka_spec::tools::{Difference, diff};
use jaka_spec::{BUILTIN, Source, Spec};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use crate::compiler::{Compiler, Errors};
use crate::draft::Draft;
use crate::edit::{self, Kind};
use crate::random::Random;
use crate::verdict::{Verdict, addition_problem};
use crate::{client, corpus, topic, witness};

/// A stand-in for the client of jaka-sync, whose methods the generator writes.
const CLIENT: &str = "
#[derive(Debug)]
pub struct Error;
pub struct Client(());
impl Client {
    pub fn call<C: ::jaka_proto::Command>(&mut self, _request: &C) -> Result<C::Reply, Error> { Err(Error) }
}
";

/// Attempts to make an edit of a kind before the kind is left out.
const ATTEMPTS: usize = 40;

/// The spec that is edited, with its programs.
pub(crate) struct Measure {
    compiler: Compiler,
    /// Description of the interface, where a second witness is asked.
    described: Option<PathBuf>,
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
    changes: Vec<Difference>,
    undone: Vec<Difference>,
}

/// Verdicts of the compiler on programs.
struct Compiled {
    /// Programs of the older spec with the newer crate.
    forth: Result<(), Errors>,
    /// Programs of the newer spec with its own crate.
    own: Result<(), Errors>,
    /// Programs of the newer spec with the older crate.
    back: Result<(), Errors>,
}

impl Measure {
    /// # Panics
    /// The programs of the spec as it is do not compile with its own crate.
    pub(crate) fn new(seed: u64, second_witness: bool) -> Self {
        let more = Source { path: "spec/more.toml", text: include_str!("../more.toml") };
        let draft = Draft::new(&[BUILTIN, &[more]].concat());
        let spec = draft.load().unwrap_or_else(|errors| panic!("{errors}"));
        let compiler = Compiler::new();
        let messages = messages(&spec);
        compiler.library("old", &messages).unwrap_or_else(|errors| panic!("{errors}"));
        let program = corpus::program(&spec);
        compiler.program("program", &program, "old").unwrap_or_else(|errors| panic!("{errors}"));
        let described = second_witness.then(|| compiler.description("old"));
        let random = Random::new(seed);
        Self { compiler, described, random, kinds: Vec::new(), draft, spec, messages, program, refused: 0, by_hand: 0 }
    }

    /// Numbers of edits that could not be measured, in words.
    pub(crate) fn drawn_again(&self) -> String {
        let Self { refused, by_hand, .. } = self;
        format!("drawn again: {refused} that the loader refuses, {by_hand} that need a change of other code")
    }

    /// Measures one edit; true if `diff` and the compiler agree.
    ///
    /// # Panics
    /// No kind of edits can be made.
    pub(crate) fn edit(&mut self, number: u64) -> bool {
        let drawn = (0..edit::kinds().len()).find_map(|_| {
            let kind = self.next_kind();
            (0..ATTEMPTS).find_map(|_| self.draw(kind))
        });
        let edited = drawn.expect("some kind of edits can be made");
        let compiled = self.compile(&edited);
        let Edited { what, spec, changes, undone, .. } = &edited;
        let forth = Verdict::new(&self.spec, spec, changes, compiled.forth.is_ok());
        let back = Verdict::new(spec, &self.spec, undone, compiled.back.is_ok());
        let mut problems: Vec<String> = Vec::new();
        problems.extend(forth.problem());
        problems.extend(addition_problem(&self.spec, spec, changes, compiled.back.is_ok()));
        problems.extend(back.problem().map(|problem| format!("undone: {problem}")));
        let added = addition_problem(spec, &self.spec, undone, compiled.forth.is_ok());
        problems.extend(added.map(|problem| format!("undone: {problem}")));
        problems.extend(compiled.own.as_ref().err().map(|errors| format!("not with its own crate: {errors}")));
        let witness = self.witness(&edited, &compiled, &mut problems);
        let agree = if problems.is_empty() { "agree" } else { "DISAGREE" };
        println!("{number:4} {agree}: {what}: {}; undone: {}{witness}", forth.words(), back.words());
        for problem in &problems {
            println!("       {problem}");
        }
        if !problems.is_empty() {
            report(&edited, &compiled);
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
    ///
    /// # Panics
    /// The generator writes messages that do not compile.
    fn draw(&mut self, kind: Kind) -> Option<Edited> {
        let mut draft = self.draft.clone();
        let what = format!("{}: {}", kind.name, (kind.make)(&mut draft, &mut self.random)?);
        let Ok(spec) = draft.load() else {
            self.refused += 1;
            return None;
        };
        let (changes, undone) = (diff(&self.spec, &spec), diff(&spec, &self.spec));
        if changes.is_empty() {
            return None;
        }
        let code = messages(&spec);
        if code == self.messages {
            return Some(Edited { what, spec, version: "old", changes, undone });
        }
        match self.compiler.library("new", &code) {
            Ok(()) => Some(Edited { what, spec, version: "new", changes, undone }),
            Err(errors) if errors.are_in_messages() => panic!("{what}: the messages do not compile: {errors}"),
            // Code of jaka-proto that is written by hand has to follow.
            Err(_) => {
                self.by_hand += 1;
                None
            }
        }
    }

    fn compile(&self, edited: &Edited) -> Compiled {
        let (compiler, program) = (&self.compiler, corpus::program(&edited.spec));
        if edited.version == "old" && program == self.program {
            return Compiled { forth: Ok(()), own: Ok(()), back: Ok(()) };
        }
        thread::scope(|scope| {
            let forth = scope.spawn(|| compiler.program("forth", &self.program, edited.version));
            let own = compiler.program("own", &program, edited.version);
            let back = compiler.program("back", &program, "old");
            Compiled { forth: forth.join().expect("the compiler runs"), own, back }
        })
    }

    /// Breaks that the second witness finds in both directions, if it is asked.
    fn witness(&self, edited: &Edited, compiled: &Compiled, problems: &mut Vec<String>) -> String {
        let Some(old) = &self.described else { return String::new() };
        if edited.version == "old" {
            return "; second witness: the same code".to_owned();
        }
        let new = self.compiler.description("new");
        let mut found = |lints: Vec<String>, compiles: bool| {
            let lints = if lints.is_empty() { "nothing".to_owned() } else { lints.join(", ") };
            if compiles && lints != "nothing" {
                problems.push(format!("every program compiles, but the second witness finds {lints}"));
            }
            lints
        };
        let forth = found(witness::breaks(old, &new), compiled.forth.is_ok());
        let back = found(witness::breaks(&new, old), compiled.back.is_ok());
        format!("; second witness: {forth}; undone: {back}")
    }
}

/// Prints the changes and the errors behind a disagreement.
fn report(edited: &Edited, compiled: &Compiled) {
    for change in &edited.changes {
        println!("       diff: {change}");
    }
    for change in &edited.undone {
        println!("       undone: {change}");
    }
    for errors in [&compiled.forth, &compiled.back].into_iter().filter_map(|result| result.as_ref().err()) {
        println!("{errors}");
    }
}

/// The code of all messages of a spec, and of the client's methods, without docs.
fn messages(spec: &Spec) -> String {
    let (messages, methods) = (topic::messages(spec), client::methods(spec));
    let code = without_docs(quote!(#messages #methods)).to_string();
    // Tools count columns from the beginning of a line.
    format!("{CLIENT}{}", code.replace("} ", "}\n"))
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

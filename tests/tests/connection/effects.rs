//! Each command of the spec does something: what is set is shown, and commands beyond the document are answered.
//!
//! `planned/motion.rs` has the effects of motions, and `jaka-sim/tests/commands.rs` those of all commands, as bytes.

mod beyond;
mod pairs;

use jaka_spec::{Command, Effect};
use jaka_sync::proto::wire::Writer;
use jaka_sync::proto::{self, Request, Visit, write_reply};
use jaka_sync::{Client, Error};
use jaka_tests::spec;
use serde_json::Value;

/// Calls a command, and returns its reply as the document would print it.
struct Call<'c>(&'c mut Client);

impl Visit for Call<'_> {
    type Output = Result<Value, Error>;

    fn visit<C: proto::Command>(self, command: &C) -> Self::Output {
        let mut out = Writer::new();
        write_reply(C::INFO, &self.0.call(command)?, &mut out);
        Ok(serde_json::from_str(out.as_str()).expect("a reply is JSON"))
    }
}

/// Calls the command of a request, which goes out as the client writes it.
pub(crate) fn call(client: &mut Client, request: &str) -> Result<Value, Error> {
    let request = Request::read(request).unwrap_or_else(|error| panic!("{request}: {error}"));
    request.visit(Call(client))
}

/// The simulator's tests compare all queries without parameters with the document's replies.
#[test]
fn each_command_of_the_document_has_a_test() {
    let tests = [
        include_str!("../../../jaka-sim/tests/commands.rs"),
        include_str!("../planned/motion.rs"),
        include_str!("exchange.rs"),
        include_str!("foreign_clients/transcripts.jsonl"),
    ];
    let is_bare_query = |command: &Command| command.effect == Effect::Query && command.is_bare();
    for command in spec().commands().filter(|command| command.section.is_some() && !is_bare_query(command)) {
        let (wire, method) = (&command.wire, &command.name);
        let names = [format!("\"{wire}\""), format!("\\\"{wire}\\\""), format!(".{method}(")];
        let is_named = tests.iter().any(|test| names.iter().any(|name| test.contains(name)));
        assert!(is_named || pairs::covered().contains(wire), "{wire}");
    }
}

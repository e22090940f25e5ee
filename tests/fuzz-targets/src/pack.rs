//! Packs upon the built-in spec.

use jaka_spec::{Source, load_pack, tools};
use serde_json::json;

use crate::builtin::SPEC;
use crate::spec_file::places;

/// The text is loaded as a pack. Of what loaded, all else can be made, the simulator's replies are readable, and the
/// pack can be loaded once more upon its own result.
///
/// # Panics
/// One of these is not so.
pub fn pack(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let source = Source { path: "fuzz.toml", text };
    let pack = match load_pack(&SPEC, source) {
        Ok(pack) => pack,
        Err(errors) => return places(&errors, text),
    };
    tools::diff(&SPEC, &pack.spec);
    tools::reference(&pack.spec);
    for command in pack.spec.commands() {
        jaka_dynamic::arguments(&pack.spec, command);
        let mut reply = jaka_dynamic::sample_reply(&pack.spec, command);
        reply.extend([("errorCode".to_owned(), json!("0")), ("cmdName".to_owned(), command.wire.clone().into())]);
        jaka_dynamic::Node::reply(&pack.spec, command, reply.into()).departures();
    }
    if let Err(errors) = load_pack(&pack.spec, source) {
        panic!("upon its own result: {errors}");
    }
}

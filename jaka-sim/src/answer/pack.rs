//! Commands that a pack adds or changes: checks and answers by the pack's spec.

use jaka_dynamic::Node;
use jaka_proto::wire::Writer;
use jaka_proto::{Envelope, ErrorCode};
use jaka_spec::{Command, Field, Spec};
use serde_json::{Map, Value};

use crate::spec_index::SpecIndex;

/// Whether the spec allows the request.
pub(super) fn allows(spec: &Spec, command: &Command, request: &str) -> bool {
    let message: Result<Map<_, _>, _> = serde_json::from_str(request);
    message.is_ok_and(|message| Node::request(spec, command, message).problems().is_empty())
}

/// Converts a reply to the keys and forms of the pack, which the handlers do not know. Returns false if the state has a
/// value that the pack does not allow; the reply is then discarded.
pub(super) fn complete(spec_index: &SpecIndex, command: &Command, out: &mut Writer) -> bool {
    let Some(written) = accepted(out.as_str()) else { return true };
    let (spec, mut reply) = (&spec_index.spec, written.clone());
    let is_translated = spec_index.with_packs(&command.wire, &mut reply);
    let fits = |field: &Field| {
        reply.get(&field.wire).is_none_or(|value| Node::field(spec, field, value.clone()).is_readable())
    };
    if !is_translated || !spec.reply_fields(command).iter().all(fits) {
        out.clear();
        return false;
    }
    jaka_dynamic::complete_reply(spec, command, &mut reply);
    if reply != written {
        rewrite(&reply, out);
    }
    true
}

/// Writes the user's fields into the reply to an accepted command.
pub(crate) fn put(fields: &Map<String, Value>, out: &mut Writer) {
    let Some(mut reply) = accepted(out.as_str()) else { return };
    reply.extend(fields.clone());
    rewrite(&reply, out);
}

/// Returns the reply if it accepts the command.
fn accepted(reply: &str) -> Option<Map<String, Value>> {
    let envelope = Envelope::read(reply).ok()?;
    let is_success = envelope.code.is_ok_and(ErrorCode::is_success);
    serde_json::from_str(reply).ok().filter(|_| is_success)
}

fn rewrite(reply: &Map<String, Value>, out: &mut Writer) {
    out.clear();
    out.json(&Value::Object(reply.clone()));
}

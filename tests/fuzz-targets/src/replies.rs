//! Replies to any command.

use jaka_proto::wire::Writer;
use jaka_proto::{Command, Envelope, Visit, framing, read_payload, read_reply, write_refusal, write_reply};

use crate::builtin::COMMANDS;

/// The text is read as a reply to the command that it names, or else to each. What was read comes back when it is
/// written and read again. Where the reply is JSON throughout, it is read the same as where it may be odd.
///
/// # Panics
/// It does not.
pub fn replies(data: &[u8]) {
    let text = &*framing::text(data);
    let envelope = Envelope::read_odd(text).ok();
    if let Ok(strict) = Envelope::read(text) {
        assert_eq!(envelope.as_ref(), Some(&strict));
    }
    let named = envelope.as_ref().and_then(|envelope| COMMANDS.get(envelope.command.as_deref()?));
    match named {
        Some(request) => request.visit(Again(text)),
        None => COMMANDS.values().for_each(|request| request.visit(Again(text))),
    }
    if let Some(envelope) = envelope {
        refusal(&envelope);
    }
}

/// A refusal comes back.
fn refusal(envelope: &Envelope<'_>) {
    let Some(refusal) = envelope.refusal() else { return };
    let mut out = Writer::new();
    write_refusal(envelope.command.as_deref(), refusal.code, &refusal.message, &mut out);
    let again = Envelope::read(out.as_str()).expect("it was written just now");
    assert_eq!(again.refusal(), Some(refusal));
}

/// Reads a reply, writes it and reads it again.
struct Again<'t>(&'t str);

impl Visit for Again<'_> {
    type Output = ();

    fn visit<C: Command>(self, _command: &C) {
        self.one_pass::<C>();
        let Ok(reply) = read_payload::<C::Reply>(C::INFO, self.0) else { return };
        let written = write::<C>(&reply);
        let again = read_payload::<C::Reply>(C::INFO, &written)
            .unwrap_or_else(|error| panic!("{}: {error}: {written}", C::INFO.name));
        assert_eq!(write::<C>(&again), written);
        let envelope = Envelope::read(&written).expect("what reads as a reply has an envelope");
        assert_eq!(envelope.command.as_deref(), Some(C::INFO.name));
        assert!(envelope.code.is_ok_and(jaka_proto::ErrorCode::is_success));
    }
}

impl Again<'_> {
    /// Checks that one pass reads the same envelope and payload as two passes.
    fn one_pass<C: Command>(&self) {
        let Ok(reply) = read_reply::<C::Reply>(C::INFO, self.0) else {
            assert!(Envelope::read_odd(self.0).is_err());
            return;
        };
        let envelope = Envelope::read_odd(self.0).ok();
        assert_eq!(reply.envelope, envelope.filter(|_| !self.0.starts_with('(')));
        let accepted = reply.envelope.is_none_or(|envelope| envelope.code.is_ok_and(jaka_proto::ErrorCode::is_success));
        let payload = accepted.then(|| read_payload::<C::Reply>(C::INFO, self.0).map(|payload| write::<C>(&payload)));
        assert_eq!(reply.payload.map(|payload| payload.map(|payload| write::<C>(&payload))), payload);
    }
}

fn write<C: Command>(reply: &C::Reply) -> String {
    let mut out = Writer::new();
    write_reply(C::INFO, reply, &mut out);
    out.into_string()
}

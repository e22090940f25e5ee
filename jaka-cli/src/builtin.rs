//! Built-in protocol, and the protocol of status packets.

use std::sync::{LazyLock, OnceLock};

use jaka_dynamic::{Message, Translation};
use jaka_spec::Spec;

/// Returns the built-in spec.
pub(crate) fn spec() -> &'static Spec {
    static BUILTIN: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the spec's own tests load it"));
    &BUILTIN
}

/// True if packs leave the request and the reply of a command in their built-in form.
pub(crate) fn is_unchanged(spec: &Spec, command: &str) -> bool {
    let translation = Translation::new(self::spec(), spec);
    translation.is_identity(Message::Request(command)) && translation.is_identity(Message::Reply(command))
}

/// Protocol of status packets, once it is set.
static STATUS: OnceLock<Spec> = OnceLock::new();

/// Returns the protocol of status packets: the built-in one, unless [`read_status_by`] sets another.
pub(crate) fn of_status() -> &'static Spec {
    STATUS.get_or_init(|| spec().clone())
}

/// Sets the protocol of status packets. Called before the first packet.
pub(crate) fn read_status_by(protocol: &Spec) {
    // The protocol is set only once.
    let _ = STATUS.set(protocol.clone());
}

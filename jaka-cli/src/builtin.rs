//! The built-in protocol, and that of status packets.

use std::sync::{LazyLock, OnceLock};

use jaka_spec::Spec;

/// The built-in spec.
pub(crate) fn spec() -> &'static Spec {
    static BUILTIN: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the spec's own tests load it"));
    &BUILTIN
}

/// The protocol of status packets, once it is known.
static STATUS: OnceLock<Spec> = OnceLock::new();

/// The protocol by which status packets are read: the built-in one, unless [`read_status_by`] says otherwise.
pub(crate) fn of_status() -> &'static Spec {
    STATUS.get_or_init(|| spec().clone())
}

/// Has status packets read by this protocol, which is said before the first of them comes.
pub(crate) fn read_status_by(protocol: &Spec) {
    // There is no other.
    let _ = STATUS.set(protocol.clone());
}

//! The built-in protocol.

use std::sync::LazyLock;

use jaka_spec::Spec;

/// The built-in spec.
pub(crate) fn spec() -> &'static Spec {
    static BUILTIN: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the spec's own tests load it"));
    &BUILTIN
}

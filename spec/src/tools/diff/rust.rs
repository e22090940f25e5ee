//! What the generated Rust looks like, as far as a change can break it. The generator is `jaka-proto-derive`.

use super::collect::Differ;
use crate::{Scalar, Type};

impl Differ<'_> {
    /// True if both types are the same in Rust, however they are written on the wire.
    pub(super) fn same_type(&self, old: &Type, new: &Type) -> bool {
        match (old, new) {
            (Type::Python(old), new) => self.same_type(old, new),
            (old, Type::Python(new)) => self.same_type(old, new),
            (Type::Scalar(Scalar::Bool { .. }), Type::Scalar(Scalar::Bool { .. })) => true,
            (Type::Scalar(old), Type::Scalar(new)) => old == new,
            (Type::List(old), Type::List(new)) => self.same_type(old, new),
            (Type::Array(old, old_len), Type::Array(new, new_len)) => old_len == new_len && self.same_type(old, new),
            (Type::Named(old), Type::Named(new)) => self.old[*old].name == self.new[*new].name,
            (Type::Scalar(_) | Type::List(_) | Type::Array(..) | Type::Named(_), _) => false,
        }
    }
}

//! What the generated Rust looks like, as far as a change can break it. The generator is `jaka-proto-derive`.

use std::slice;

use super::collect::Differ;
use crate::{Command, Scalar, Spec, Type};

/// The interface generated from a spec.
pub(super) struct Interface<'s>(pub(super) &'s Spec);

impl Interface<'_> {
    /// True if the struct or enum of the command's request is `Copy`.
    pub(super) fn request_is_copy(&self, command: &str) -> bool {
        let is_copy = |command: &Command| command.request.fields().all(|field| self.0.all_copy(slice::from_ref(field)));
        self.0.command(command).is_some_and(is_copy)
    }

    /// True if the command has a reply struct, and that is `Copy`.
    pub(super) fn reply_is_copy(&self, command: &str) -> bool {
        self.0.command(command).is_some_and(|command| self.0.all_copy(self.0.reply_fields(command)))
    }

    /// True if the named type is `Copy`.
    pub(super) fn named_is_copy(&self, name: &str) -> bool {
        self.0.type_id(name).is_some_and(|id| self.0.is_copy(&Type::Named(id)))
    }
}

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

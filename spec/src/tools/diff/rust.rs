//! What the generated Rust looks like, as far as a change can break it. The generator is `jaka-proto-derive`.

use crate::{Command, Field, Request, Spec, Type, TypeKind};

/// The interface generated from a spec.
pub(super) struct Interface<'s>(pub(super) &'s Spec);

impl Interface<'_> {
    /// True if the struct or enum of the command's request is `Copy`.
    pub(super) fn request_is_copy(&self, command: &str) -> bool {
        self.0.command(command).is_some_and(|command| match &command.request {
            Request::Fields(fields) => self.0.all_copy(fields),
            Request::Choice(choice) => choice.variants.iter().all(|variant| self.0.all_copy(&variant.fields)),
        })
    }

    /// True if the command has a reply struct, and that is `Copy`.
    pub(super) fn reply_is_copy(&self, command: &str) -> bool {
        self.0.command(command).is_some_and(|command| self.0.all_copy(&command.reply))
    }

    /// True if the named type is `Copy`.
    pub(super) fn named_is_copy(&self, name: &str) -> bool {
        self.0.is_copy(&Type::Named(name.to_owned()))
    }
}

/// True if both types are the same in Rust, however they are written on the wire.
pub(super) fn same_type(a: &Type, b: &Type) -> bool {
    match (a, b) {
        (Type::Python(a), b) => same_type(a, b),
        (a, Type::Python(b)) => same_type(a, b),
        (Type::Bool { .. }, Type::Bool { .. }) => true,
        (Type::List(a), Type::List(b)) => same_type(a, b),
        (Type::Array(a, a_len), Type::Array(b, b_len)) => a_len == b_len && same_type(a, b),
        (a, b) => a == b,
    }
}

/// True if both commands have a request struct, or a reply struct, to compare.
pub(super) fn both_answer(old: &Command, new: &Command) -> bool {
    !old.reply.is_empty() && !new.reply.is_empty()
}

/// The types that the client checks before it sends them: those of requests, also inside other types.
pub(super) fn is_checked(spec: &Spec, name: &str) -> bool {
    spec.commands().flat_map(sent_fields).any(|field| reaches(spec, &field.ty, name))
}

fn sent_fields(command: &Command) -> Vec<&Field> {
    match &command.request {
        Request::Fields(fields) => fields.iter().collect(),
        Request::Choice(choice) => choice.variants.iter().flat_map(|variant| &variant.fields).collect(),
    }
}

/// True if the check of `ty` checks the type `name`.
fn reaches(spec: &Spec, ty: &Type, name: &str) -> bool {
    let reach = |ty| reaches(spec, ty, name);
    match ty {
        Type::List(inner) | Type::Array(inner, _) | Type::Python(inner) => reach(inner),
        Type::Named(named) if named == name => true,
        Type::Named(named) => spec.type_def(named).is_some_and(|def| match &def.kind {
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => fields.iter().any(|field| reach(&field.ty)),
            TypeKind::Choice(choice) => choice.variants.iter().flat_map(|v| &v.fields).any(|field| reach(&field.ty)),
            TypeKind::Wrapper(ty, _) => reach(ty),
            TypeKind::IntEnum(_) | TypeKind::TextEnum(_) => false,
        }),
        _ => false,
    }
}

//! What the generated Rust looks like, as far as a change can break it. The generator is `jaka-proto-derive`.

use crate::{Command, Field, Request, Spec, Type, TypeKind};

/// The interface generated from a spec.
pub(super) struct Interface<'s>(pub(super) &'s Spec);

impl Interface<'_> {
    /// True if the struct or enum of the command's request is `Copy`.
    pub(super) fn request_is_copy(&self, command: &str) -> bool {
        self.0.command(command).is_some_and(|command| match &command.request {
            Request::Fields(fields) => self.all_copy(fields),
            Request::Choice(choice) => choice.variants.iter().all(|variant| self.all_copy(&variant.fields)),
        })
    }

    /// True if the command has a reply struct, and that is `Copy`.
    pub(super) fn reply_is_copy(&self, command: &str) -> bool {
        self.0.command(command).is_some_and(|command| self.all_copy(&command.reply))
    }

    /// True if the named type is `Copy`.
    pub(super) fn named_is_copy(&self, name: &str) -> bool {
        self.0.type_def(name).is_some_and(|def| match &def.kind {
            TypeKind::IntEnum(_) => true,
            TypeKind::TextEnum(_) | TypeKind::Choice(_) => false,
            TypeKind::Wrapper(ty, _) => self.is_copy(ty),
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => self.all_copy(fields),
        })
    }

    fn all_copy(&self, fields: &[Field]) -> bool {
        fields.iter().all(|field| !field.or_raw && self.is_copy(&field.ty))
    }

    fn is_copy(&self, ty: &Type) -> bool {
        match ty {
            Type::Bool { .. } | Type::Int | Type::Float => true,
            Type::Text | Type::Json | Type::List(_) => false,
            Type::Array(inner, _) | Type::Python(inner) => self.is_copy(inner),
            Type::Named(name) => self.named_is_copy(name),
        }
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

/// True for a struct of nothing but floats, which converts from and into an array of them.
pub(super) fn converts_from_floats(fields: &[Field]) -> bool {
    fields.iter().all(|field| field.ty == Type::Float && !field.optional && !field.or_raw)
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

/// True if the check of `ty` checks the type `name`. It passes over choices inside arrays, as no request sends one.
fn reaches(spec: &Spec, ty: &Type, name: &str) -> bool {
    let reach = |ty| reaches(spec, ty, name);
    match ty {
        Type::List(inner) | Type::Array(inner, _) | Type::Python(inner) => reach(inner),
        Type::Named(named) if named == name => true,
        Type::Named(named) => spec.type_def(named).is_some_and(|def| match &def.kind {
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => fields.iter().any(|field| reach(&field.ty)),
            TypeKind::Wrapper(ty, _) => reach(ty),
            _ => false,
        }),
        _ => false,
    }
}

//! What the generated Rust types can do, which whoever generates them and whoever compares two specs must see alike.

use crate::model::{Field, Spec, Type, TypeKind};

impl Spec {
    /// True if the type can be `Copy`.
    pub fn is_copy(&self, ty: &Type) -> bool {
        match ty {
            Type::Bool { .. } | Type::Int | Type::Float => true,
            Type::Text | Type::Json | Type::List(_) => false,
            Type::Array(inner, _) | Type::Python(inner) => self.is_copy(inner),
            Type::Named(name) => self.type_def(name).is_some_and(|def| match &def.kind {
                TypeKind::IntEnum(_) => true,
                TypeKind::TextEnum(_) | TypeKind::Choice(_) => false,
                TypeKind::Wrapper(ty, _) => self.is_copy(ty),
                TypeKind::Object(fields) | TypeKind::Array { fields, .. } => self.all_copy(fields),
            }),
        }
    }

    /// True if a struct of these fields can be `Copy`.
    pub fn all_copy(&self, fields: &[Field]) -> bool {
        fields.iter().all(|field| !field.or_raw && self.is_copy(&field.ty))
    }
}

/// True for fields that are nothing but floats: a struct of them converts from and into an array.
pub fn is_floats(fields: &[Field]) -> bool {
    fields.iter().all(|field| field.ty == Type::Float && !field.optional && !field.or_raw)
}

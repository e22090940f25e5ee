//! Types with their names looked up: what they are on the wire, and what the generated Rust types can do.

use std::collections::BTreeSet;

use crate::model::{Choice, EnumValue, Field, Spec, Type, TypeId, TypeKind};
use crate::scalar::Scalar;

/// What a type is on the wire: named types are looked up, and wrappers taken off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape<'s> {
    /// One value that has no parts.
    Scalar(&'s Scalar),
    /// A string that holds a Python literal of this type.
    Python(&'s Type),
    /// An array of elements of one type, and its length where the protocol fixes it.
    List(&'s Type, Option<usize>),
    /// An object with these keys.
    Object(&'s [Field]),
    /// An array with an element for each field.
    Tuple {
        /// The elements, in order.
        fields: &'s [Field],
        /// True where an array with further elements is an error; otherwise they are ignored.
        exact: bool,
    },
    /// One of some whole numbers, or another one.
    IntEnum(&'s [EnumValue<i64>]),
    /// One of some strings, or another one.
    TextEnum(&'s [EnumValue<String>]),
    /// An array that begins with the tag of a variant.
    Choice(&'s Choice),
}

impl Spec {
    /// What the type is on the wire.
    pub fn shape<'s>(&'s self, ty: &'s Type) -> Shape<'s> {
        match ty {
            Type::Scalar(scalar) => Shape::Scalar(scalar),
            Type::Python(inner) => Shape::Python(inner),
            Type::List(element) => Shape::List(element, None),
            Type::Array(element, len) => Shape::List(element, Some(*len)),
            Type::Named(id) => match &self[*id].kind {
                TypeKind::Object(fields) => Shape::Object(fields),
                TypeKind::Array { fields, exact } => Shape::Tuple { fields, exact: *exact },
                TypeKind::IntEnum(values) => Shape::IntEnum(values),
                TypeKind::TextEnum(values) => Shape::TextEnum(values),
                TypeKind::Choice(choice) => Shape::Choice(choice),
                TypeKind::Wrapper(ty, _) => self.shape(ty),
            },
        }
    }

    /// The type itself, or the one inside all wrappers around it.
    pub fn unwrapped<'s>(&'s self, ty: &'s Type) -> &'s Type {
        match ty {
            Type::Named(id) => match &self[*id].kind {
                TypeKind::Wrapper(inner, _) => self.unwrapped(inner),
                _ => ty,
            },
            _ => ty,
        }
    }

    /// The unit of the wrapper that the type is, if it is one and has a unit.
    pub fn unit<'s>(&'s self, ty: &Type) -> Option<&'s str> {
        let Type::Named(id) = ty else { return None };
        match &self[*id].kind {
            TypeKind::Wrapper(ty, unit) => unit.as_deref().or_else(|| self.unit(ty)),
            _ => None,
        }
    }

    /// True if the type can be `Copy`.
    pub fn is_copy(&self, ty: &Type) -> bool {
        match self.shape(ty) {
            Shape::Scalar(scalar) => scalar.is_copy(),
            Shape::IntEnum(_) => true,
            Shape::List(_, None) | Shape::TextEnum(_) | Shape::Choice(_) => false,
            Shape::List(inner, Some(_)) | Shape::Python(inner) => self.is_copy(inner),
            Shape::Object(fields) | Shape::Tuple { fields, .. } => self.all_copy(fields),
        }
    }

    /// True if a struct of these fields can be `Copy`.
    pub fn all_copy(&self, fields: &[Field]) -> bool {
        fields.iter().all(|field| !field.or_raw && self.is_copy(&field.ty))
    }
}

impl Spec {
    /// True if requests have the type, also inside other types: the client checks it, and programs make values of it.
    pub fn is_sent(&self, id: TypeId) -> bool {
        self.sent_types().contains(&id)
    }

    /// The types that requests have, also inside other types.
    pub fn sent_types(&self) -> BTreeSet<TypeId> {
        let mut sent = BTreeSet::new();
        let fields = self.commands().flat_map(|command| command.request.fields());
        let mut open: Vec<_> = fields.filter_map(|field| field.ty.named()).collect();
        while let Some(id) = open.pop() {
            if sent.insert(id) {
                open.extend(self[id].kind.parts());
            }
        }
        sent
    }
}

/// True for fields that are nothing but floats: a struct of them converts from and into an array.
pub fn is_floats(fields: &[Field]) -> bool {
    fields.iter().all(|field| field.ty == Type::Scalar(Scalar::Float) && !field.optional && !field.or_raw)
}

//! A spec, and queries of it: items by name, types by their shape on the wire, and the sources of the status that a
//! robot needs.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Index;
use std::sync::Arc;

use crate::model::{
    Choice, Command, EnumValue, ErrorCode, Event, EventFamily, Field, Reply, Topic, Type, TypeDef, TypeId, TypeKind,
};
use crate::names::nearest;
use crate::needed::{FieldSource, NEEDED_FIELDS, NeededSource, StatusLine};
use crate::scalar::Scalar;
use crate::type_text::notation;

/// A whole protocol: the topics in the order they were given.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// One topic for each source file.
    pub topics: Vec<Topic>,
    /// All named types, each at the place of its id.
    pub(crate) types: Vec<TypeDef>,
    /// Types of the spec to which packs have been added; none without a pack.
    pub(crate) built_in: Option<Arc<Spec>>,
    /// Lines of the packs for the fields of status packets that a robot needs.
    pub(crate) status_lines: BTreeMap<&'static str, StatusLine>,
}

/// Shape of a type on the wire: named types are looked up, and wrappers taken off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape<'s> {
    /// One value that has no parts.
    Scalar(&'s Scalar),
    /// A string that holds a Python literal of this type.
    Python(&'s Type),
    /// An array of elements of one type, and its length if the protocol fixes it.
    List(&'s Type, Option<usize>),
    /// An object with these keys.
    Object(&'s [Field]),
    /// An array with an element for each field.
    Tuple {
        /// The elements, in order.
        fields: &'s [Field],
        /// True if an array with further elements is an error; otherwise they are ignored.
        exact: bool,
    },
    /// One of some whole numbers, or another one.
    IntEnum(&'s [EnumValue<i64>]),
    /// One of some strings, or another one.
    TextEnum(&'s [EnumValue<String>]),
    /// An array that begins with the tag of a variant.
    Choice(&'s Choice),
}

/// The name of the type of the packets of port 10000, which is an object.
pub(crate) const STATUS_TYPE: &str = "RobotStatus";

impl Spec {
    /// All commands, topic by topic.
    pub fn commands(&self) -> impl Iterator<Item = &Command> {
        self.topics.iter().flat_map(|topic| &topic.commands)
    }

    /// All named types, topic by topic.
    pub fn types(&self) -> impl Iterator<Item = (TypeId, &TypeDef)> {
        self.topics.iter().flat_map(|topic| self.types_of(topic))
    }

    /// The named types of a topic.
    pub fn types_of(&self, topic: &Topic) -> impl Iterator<Item = (TypeId, &TypeDef)> {
        topic.types.iter().map(|id| (*id, &self[*id]))
    }

    /// All error codes, topic by topic.
    pub fn errors(&self) -> impl Iterator<Item = &ErrorCode> {
        self.topics.iter().flat_map(|topic| &topic.errors)
    }

    /// All events of the controller, topic by topic.
    pub fn events(&self) -> impl Iterator<Item = &Event> {
        self.topics.iter().flat_map(|topic| &topic.events)
    }

    /// The events among which this code is.
    pub fn event(&self, code: u32) -> Option<&Event> {
        self.events().find(|event| event.has(code))
    }

    /// All families of events, topic by topic.
    pub fn event_families(&self) -> impl Iterator<Item = &EventFamily> {
        self.topics.iter().flat_map(|topic| &topic.event_families)
    }

    /// The family of an event, if it has one.
    pub fn family_of(&self, event: &Event) -> Option<&EventFamily> {
        let name = event.family.as_ref()?;
        self.event_families().find(|family| family.name == *name)
    }

    /// The command with this `cmdName`.
    pub fn command(&self, wire: &str) -> Option<&Command> {
        self.commands().find(|command| command.wire == wire)
    }

    /// The command with this `cmdName`, or else with this name in Rust.
    pub fn command_called(&self, name: &str) -> Option<&Command> {
        self.command(name).or_else(|| self.commands().find(|command| command.name == name))
    }

    /// The command with the `cmdName` or Rust name most similar to this one, if one is similar.
    pub fn command_like(&self, name: &str) -> Option<&Command> {
        let names = self.commands().flat_map(|command| [&*command.wire, &*command.name]);
        nearest(name, names).and_then(|name| self.command_called(name))
    }

    /// The topic in which the type is defined.
    pub fn topic_of(&self, id: TypeId) -> Option<&Topic> {
        self.topics.iter().find(|topic| topic.types.contains(&id))
    }

    /// The type with this name.
    pub fn type_id(&self, name: &str) -> Option<TypeId> {
        self.types.iter().position(|def| def.name == name).map(TypeId)
    }

    /// The fields of the command's reply, its own or those of the object that it is.
    pub fn reply_fields<'s>(&'s self, command: &'s Command) -> &'s [Field] {
        match &command.reply {
            Reply::Fields(fields) => fields,
            Reply::Object(id) => self.object_fields(*id),
            Reply::Raw => &[],
        }
    }

    /// True if a type is defined here as in another spec, with all the types of which it is made, but for docs, ranges
    /// and versions.
    pub fn defines_as(&self, other: &Self, ty: &Type) -> bool {
        let Some(id) = ty.named() else { return true };
        let def = &self[id];
        let Some(known) = other.type_id(&def.name) else { return false };
        // Ids are those of the same types in all specs that packs make of one; a type cannot contain itself.
        id == known
            && def.kind.undescribed() == other[known].kind.undescribed()
            && def.kind.types().all(|part| self.defines_as(other, part))
    }

    /// The fields of an object; none of any other type.
    fn object_fields(&self, id: TypeId) -> &[Field] {
        if let TypeKind::Object(fields) = &self[id].kind { fields } else { &[] }
    }

    /// The type of the packets of port 10000, if the spec has it.
    pub fn status_type(&self) -> Option<TypeId> {
        self.type_id(STATUS_TYPE)
    }

    /// The fields of the packets of port 10000; none if the spec does not have their type.
    pub fn status_fields(&self) -> &[Field] {
        self.status_type().map_or(&[], |id| self.object_fields(id))
    }

    /// Shape of the type on the wire.
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

    /// True for a field that functions take as `impl Into<…>`: a text, and what other types convert into.
    pub fn is_converted(&self, field: &Field) -> bool {
        let is_converted = match &field.ty {
            Type::Scalar(Scalar::Text) => true,
            Type::Named(id) => self[*id].converts(),
            Type::Scalar(Scalar::Bool { .. } | Scalar::Int | Scalar::Float | Scalar::Json)
            | Type::List(_)
            | Type::Array(..)
            | Type::Python(_) => false,
        };
        field.or_raw || is_converted
    }

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

    /// The notation of the TOML files, such as `float[6]`.
    pub fn notation(&self, ty: &Type) -> String {
        notation(ty, &|id| &self[id].name)
    }

    /// Sources of the status that a robot needs, in the order of [`NEEDED_FIELDS`]; `None` if the spec has no status
    /// packet.
    pub fn robot_status(&self) -> impl Iterator<Item = NeededSource<'_>> {
        NEEDED_FIELDS.iter().filter_map(|needed| {
            let known = self.as_built_in().status_fields().iter().find(|known| known.name == needed.name)?;
            let is_changed = |field: &Field| field.wire != known.wire || field.ty != known.ty;
            let source = self.status_source(known)?;
            let is_changed = self.status_lines.contains_key(needed.name)
                || matches!(source, FieldSource::Field(field) if is_changed(field));
            Some(NeededSource { needed, source, is_changed })
        })
    }

    /// Field of the status packet with the meaning of a field of the built-in one.
    pub fn status_field_as(&self, built_in: &Field) -> Option<&Field> {
        match self.status_source(built_in)? {
            FieldSource::Field(field) => Some(field),
            FieldSource::Absent | FieldSource::Program => None,
        }
    }

    /// The spec, or that to which packs have been added.
    pub(crate) fn as_built_in(&self) -> &Self {
        self.built_in.as_deref().unwrap_or(self)
    }

    /// Source of a field of the built-in status packet; none if packs change it and say nothing of that.
    pub(crate) fn status_source(&self, built_in: &Field) -> Option<FieldSource<'_>> {
        let name = match self.status_lines.get(built_in.name.as_str()) {
            Some(StatusLine::Absent) => return Some(FieldSource::Absent),
            Some(StatusLine::Program) => return Some(FieldSource::Program),
            Some(StatusLine::Field(name)) => name,
            None => &built_in.name,
        };
        let field = self.status_fields().iter().find(|field| field.name == *name);
        field.filter(|field| self.means_as_built_in(field, built_in)).map(FieldSource::Field)
    }

    /// True if the values of a field mean what those of the built-in field mean, however truth values are written:
    /// type, unit, and all that the type is made of.
    fn means_as_built_in(&self, field: &Field, built_in: &Field) -> bool {
        field.ty.is_alike(&built_in.ty)
            && (field.or_raw, &field.unit) == (built_in.or_raw, &built_in.unit)
            && self.defines_as(self.as_built_in(), &field.ty)
    }
}

/// # Panics
/// The id is that of a type of another spec.
impl Index<TypeId> for Spec {
    type Output = TypeDef;

    fn index(&self, id: TypeId) -> &TypeDef {
        &self.types[id.0]
    }
}

//! Messages read by the spec, once, as leniently as the generated code reads them. Every view of a message is a walk
//! over its tree.

mod read;

pub(crate) use self::read::is_success;
pub use self::read::notation;

use jaka_spec::{EnumValue, Field, Scalar, Shape, Variant};
use serde_json::{Map, Value};

use super::departure::{Departure, DepartureKind, Reading};
use super::problem::{Problem, ProblemKind, element, member};
use super::scalar;
use super::slot::Slot;

/// Message, or one of its parts.
#[derive(Debug, Clone)]
pub struct Node<'s> {
    label: Label<'s>,
    /// Type and limits; `None` if the spec does not describe the node.
    pub(crate) slot: Option<Slot<'s>>,
    body: Body<'s>,
    /// Text of the Python literal that contained this value.
    literal: Option<String>,
    /// Departures from the spec except those of parts, by paths inside the node.
    departures: Vec<Departure>,
}

/// Place of a node in the one around it.
#[derive(Debug, Clone)]
pub enum Label<'s> {
    /// Message as a whole.
    Message,
    /// Tag of a choice.
    Tag {
        /// Key of the tag; empty in an array.
        key: &'s str,
        /// Variant that the tag selects; `None` if there is no such variant.
        variant: Option<&'s Variant>,
    },
    /// Field of the spec.
    Field(&'s Field),
    /// Element of an array. An element that the spec does not describe is beyond the fields of an array.
    Element(usize),
    /// Key that is not in the spec.
    Unknown(String),
}

/// Content of a node.
#[derive(Debug, Clone)]
enum Body<'s> {
    /// No content: the message does not have the node.
    Absent,
    /// JSON without parts that the spec describes, unchanged.
    Leaf(Value),
    /// Parts, those without a description first.
    Parts(Vec<Node<'s>>),
}

impl Label<'_> {
    /// Whether it is the same place in another message.
    fn is(&self, other: &Label<'_>) -> bool {
        match (self, other) {
            (Label::Field(one), Label::Field(other)) => one.name == other.name,
            (Label::Element(one), Label::Element(other)) => one == other,
            _ => false,
        }
    }

    /// Returns the path of the part inside the value at `outer`, by names in Rust.
    pub fn path(&self, outer: &str) -> String {
        match self {
            Self::Field(field) => member(outer, &field.name),
            _ => self.wire_path(outer),
        }
    }

    /// Returns the path by keys on the wire, and by names where there are no keys.
    fn wire_path(&self, outer: &str) -> String {
        match self {
            Self::Message | Self::Tag { key: "", .. } => outer.to_owned(),
            Self::Element(index) => element(outer, *index),
            _ => member(outer, self.key()),
        }
    }

    /// Returns the key in an object on the wire; for an element of an array, its name.
    fn key(&self) -> &str {
        match self {
            Self::Tag { key, .. } => key,
            Self::Field(field) if field.wire.is_empty() => &field.name,
            Self::Field(field) => &field.wire,
            Self::Unknown(key) => key,
            Self::Message | Self::Element(_) => "",
        }
    }
}

/// The spec's view of the node.
impl<'s> Node<'s> {
    /// Returns the place in the node around it.
    pub fn label(&self) -> &Label<'s> {
        &self.label
    }

    /// Returns its type on the wire; `None` if the spec does not describe it. For a Python literal it is the type of
    /// its content.
    pub fn shape(&self) -> Option<Shape<'s>> {
        self.slot.map(|slot| slot.shape)
    }

    /// Returns the unit of its number or numbers, if there is one.
    pub fn unit(&self) -> Option<&'s str> {
        self.slot.map(|slot| slot.limits.unit).filter(|unit| !unit.is_empty())
    }

    /// Whether the spec describes it.
    pub fn is_described(&self) -> bool {
        self.slot.is_some() || matches!(self.label, Label::Tag { .. })
    }

    /// Whether its type has parts with names or elements.
    pub fn is_nested(&self) -> bool {
        !matches!(self.shape(), None | Some(Shape::Scalar(_) | Shape::IntEnum(_) | Shape::TextEnum(_)))
    }

    /// Returns the fields of its type, each without a value.
    pub fn members(&self) -> Vec<Self> {
        match self.slot {
            Some(Slot { spec, shape: Shape::Object(fields) | Shape::Tuple { fields, .. }, .. }) => {
                fields.iter().map(|field| Self::blank(Label::Field(field), Slot::of(spec, field))).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Returns an element of its array type, without a value; `None` for another type, and beyond a fixed length.
    pub fn element(&self, index: usize) -> Option<Self> {
        let (slot, Shape::List(ty, len)) = (self.slot?, self.shape()?) else { return None };
        let is_there = len.is_none_or(|len| index < len);
        is_there.then(|| Self::blank(Label::Element(index), slot.inner(ty)))
    }

    fn blank(label: Label<'s>, slot: Slot<'s>) -> Self {
        Self { label, slot: Some(slot), body: Body::Absent, literal: None, departures: Vec::new() }
    }
}

/// The message's view of the node.
impl<'s> Node<'s> {
    /// Returns its parts without the envelope: keys without a description first, then all parts that the spec
    /// describes, including absent ones.
    pub fn parts(&self) -> &[Self] {
        if let Body::Parts(parts) = &self.body { parts } else { &[] }
    }

    /// Returns the part that is the field of this name.
    pub(crate) fn part(&self, name: &str) -> Option<&Self> {
        self.parts().iter().find(|part| matches!(part.label, Label::Field(field) if field.name == name))
    }

    /// Whether the message does not have it.
    pub fn is_absent(&self) -> bool {
        matches!(self.body, Body::Absent)
    }

    /// Whether the message has a value without the parts of its type.
    pub fn is_leaf(&self) -> bool {
        matches!(self.body, Body::Leaf(_))
    }

    /// Returns the part at a path of labels, if the message has one that is not null.
    pub fn at(&self, path: &[Label<'_>]) -> Option<&Self> {
        let mut found = self;
        for label in path {
            found = found.parts().iter().find(|part| part.label.is(label))?;
        }
        (!matches!(found.body, Body::Absent | Body::Leaf(Value::Null))).then_some(found)
    }

    /// Returns its JSON unchanged, without the envelope; null if the message has none.
    pub fn found(&self) -> Value {
        self.literal.as_deref().map_or_else(|| self.json(), Value::from)
    }

    /// Returns its JSON unchanged; for a Python literal its value.
    pub(crate) fn json(&self) -> Value {
        let parts = match &self.body {
            Body::Absent => return Value::Null,
            Body::Leaf(value) => return value.clone(),
            Body::Parts(parts) => parts.iter().filter(|part| !part.is_absent()),
        };
        match self.shape() {
            Some(Shape::Object(_)) => {
                parts.map(|part| (part.label.key().to_owned(), part.found())).collect::<Map<_, _>>().into()
            }
            _ => parts.map(Self::found).collect(),
        }
    }

    /// Returns its JSON by the names in Rust, without the envelope, and with values as from [`value`](Self::value).
    ///
    /// A key without a description is unchanged, and so is an array with an element without one.
    pub fn named(&self) -> Value {
        let Body::Parts(parts) = &self.body else { return self.value() };
        let is_beyond = |part: &Self| !part.is_described() && matches!(part.label, Label::Element(_));
        match self.shape() {
            Some(Shape::List(..)) => parts.iter().map(Self::named).collect(),
            Some(Shape::Object(_) | Shape::Tuple { .. }) if !parts.iter().any(is_beyond) => {
                let present = parts.iter().filter(|part| !part.is_absent());
                present.map(|part| (part.label.path(""), part.named())).collect::<Map<_, _>>().into()
            }
            _ => self.found(),
        }
    }

    /// Returns a value without parts in one form, for any form that the controller used: a truth value as true or
    /// false, a number as a number. A value that does not fit its type is unchanged; for a node with parts it is
    /// [`found`](Self::found).
    pub fn value(&self) -> Value {
        let Body::Leaf(value) = &self.body else { return self.found() };
        let read = match self.shape() {
            Some(Shape::Scalar(scalar)) => scalar::read(scalar, value),
            Some(Shape::IntEnum(_)) => scalar::read(&Scalar::Int, value),
            _ => None,
        };
        read.unwrap_or_else(|| value.clone())
    }

    /// Returns the name of the value of an enum or of the tag of a choice, if there is one.
    pub fn value_name(&self) -> Option<&'s str> {
        match &self.label {
            Label::Tag { variant, .. } => variant.map(|variant| &*variant.name),
            _ => self.listed(|listed| &*listed.name, |listed| &*listed.name),
        }
    }

    /// Returns the spec's entry for the value of an enum, if there is one.
    pub(crate) fn listed<T>(
        &self,
        of_int: impl Fn(&'s EnumValue<i64>) -> T,
        of_text: impl Fn(&'s EnumValue<String>) -> T,
    ) -> Option<T> {
        let value = self.value();
        match self.shape()? {
            Shape::IntEnum(values) => values.iter().find(|listed| Some(listed.wire) == value.as_i64()).map(of_int),
            Shape::TextEnum(values) => values.iter().find(|listed| Some(&*listed.wire) == value.as_str()).map(of_text),
            _ => None,
        }
    }
}

/// Departures from the spec.
impl Node<'_> {
    /// Returns the differences from the spec: for each object, unknown keys first, then the rest in the order of the
    /// spec. Paths are inside the message; for a single field they begin with its name in Rust.
    pub fn departures(&self) -> Vec<Departure> {
        let mut found = Vec::new();
        self.collect(&self.label.path(""), &mut found);
        found
    }

    /// Whether the generated code can read it, if only leniently.
    pub fn is_readable(&self) -> bool {
        let is_unreadable = |departure: &Departure| departure.reading == Reading::Unreadable;
        self.is_kept_raw() || !self.departures.iter().any(is_unreadable) && self.parts().iter().all(Self::is_readable)
    }

    /// Whether it is a value that the generated code keeps as raw JSON if it does not fit.
    fn is_kept_raw(&self) -> bool {
        let is_raw = matches!(self.label, Label::Field(field) if field.or_raw);
        is_raw && !matches!(self.body, Body::Absent | Body::Leaf(Value::Null))
    }

    /// Returns the problems for which a controller must refuse a request. Unknown keys are skipped, numbers may be
    /// strings, and truth values may have any of their forms. Ranges and values of enums that newer firmware has
    /// widened are not enforced. Fields have their keys on the wire.
    pub fn problems(&self) -> Vec<Problem> {
        let is_refused = |departure: &Departure| {
            let forbidden = matches!(departure.kind, DepartureKind::Range | DepartureKind::Unlisted);
            departure.reading == Reading::Unreadable || forbidden && !departure.advisory
        };
        let problem = |departure: Departure| {
            let Departure { field, kind, found, expected, advisory, .. } = departure;
            let kind = if kind == DepartureKind::Missing { ProblemKind::Missing } else { ProblemKind::Forbidden };
            Problem { field, kind, value: found, allowed: expected, advisory }
        };
        self.departures().into_iter().filter(is_refused).map(problem).collect()
    }

    fn collect(&self, place: &str, found: &mut Vec<Departure>) {
        let own = found.len();
        found.extend(self.departures.iter().cloned().map(|own| {
            let field = if own.field.is_empty() { place.to_owned() } else { member(place, &own.field) };
            Departure { field, ..own }
        }));
        let first = found.len();
        for part in self.parts() {
            let before = found.len();
            part.collect(&part.label.wire_path(place), found);
            if matches!(self.shape(), Some(Shape::List(..))) {
                for departure in found.split_off(before) {
                    add_or_count(place, first, departure, found);
                }
            }
        }
        if self.is_kept_raw() {
            found[own..].iter_mut().for_each(|departure| departure.reading = Reading::Lenient);
        }
    }
}

/// Adds a departure of an element, or counts it if a previous element differs in the same way.
fn add_or_count(array: &str, first: usize, new: Departure, found: &mut Vec<Departure>) {
    /// Returns the path inside the element.
    fn inner<'f>(array: &str, field: &'f str) -> &'f str {
        field[array.len()..].split_once(']').map_or("", |(_, inner)| inner)
    }
    let is_same = |old: &&mut Departure| {
        (old.kind, old.reading) == (new.kind, new.reading) && inner(array, &old.field) == inner(array, &new.field)
    };
    match found[first..].iter_mut().find(is_same) {
        Some(old) => old.more += new.more + 1,
        None => found.push(new),
    }
}

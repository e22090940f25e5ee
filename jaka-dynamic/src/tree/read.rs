//! Trees read from messages and values.

use jaka_spec::{COMMAND_NAME, Command, ERROR_CODE, ERROR_MESSAGE, Field, Reply, Request, Shape, Spec};
use serde_json::{Map, Value};

use super::{Body, Label, Node};
use crate::departure::{Departure, DepartureKind, Reading};
use crate::problem::shown;
use crate::scalar::{self, Fit};
use crate::slot::{Slot, variants};

/// Messages.
impl<'s> Node<'s> {
    /// Reads a packet of port 10000.
    pub fn status(spec: &'s Spec, packet: Value) -> Self {
        let Value::Object(found) = packet else { return Self::no_object(packet) };
        Self::message(spec, spec.status_fields(), object(spec, spec.status_fields(), found))
    }

    /// Reads a reply to a command. Of a reply to an unknown command the spec describes nothing.
    ///
    /// For a refusal only the envelope is compared with the spec, since it has no payload. A bare Python tuple, which
    /// some firmware sends in place of a reply, is given as a JSON string.
    ///
    /// For a repeated key a [`Value`] has only the last value, and it rounds a number with a fraction. The parser of
    /// the reply must refuse these, as the decoder of jaka-proto does for a [`Value`]. A client that uses jaka-sync
    /// never gets a reply in which one of the three keys of the envelope is repeated with different values.
    pub fn reply(spec: &'s Spec, command: impl Into<Option<&'s Command>>, reply: Value) -> Self {
        let command = command.into();
        let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
        if let Some(found) = command.and_then(|command| bare_reply(command, &reply)) {
            let departures = departures("", Fit::Lenient(DepartureKind::Form), &reply, || "an object".to_owned());
            return Self { departures, ..Self::message(spec, fields, object(spec, fields, found)) };
        }
        let Value::Object(mut found) = reply else { return Self::no_object(reply) };
        let has_payload = command.is_some_and(|command| command.reply != Reply::Raw) && is_success(&found);
        let departures = envelope(command, &mut found);
        let parts = if has_payload { object(spec, fields, found) } else { undescribed(found) };
        Self { departures, ..Self::message(spec, fields, parts) }
    }

    /// Reads a request for a command, with or without `cmdName`.
    pub fn request(spec: &'s Spec, command: &'s Command, mut found: Map<String, Value>) -> Self {
        found.remove(COMMAND_NAME);
        let choice = match &command.request {
            Request::Fields(fields) => return Self::message(spec, fields, object(spec, fields, found)),
            Request::Choice(choice) => choice,
        };
        let tag = found.remove(&choice.tag).unwrap_or_default();
        let variant = choice.variants.iter().find(|variant| Some(variant.wire) == wire(&tag));
        let fit = match variant {
            Some(_) => Fit::Plain,
            None if tag.is_null() => Fit::Unreadable(DepartureKind::Missing),
            None => Fit::Unreadable(DepartureKind::Unlisted),
        };
        let departures = departures("", fit, &tag, || variants(&choice.variants));
        let tag = Self { departures, ..Self::undescribed(Label::Tag { key: &choice.tag, variant }, tag) };
        let Some(variant) = variant else { return Self::message(spec, &[], vec![tag]) };
        let members = object(spec, &variant.fields, found);
        Self::message(spec, &variant.fields, std::iter::once(tag).chain(members).collect())
    }

    fn message(spec: &'s Spec, fields: &'s [Field], parts: Vec<Self>) -> Self {
        Self { body: Body::Parts(parts), ..Self::blank(Label::Message, Slot::of_object(spec, fields)) }
    }

    /// Creates the node of a message that is no object.
    fn no_object(found: Value) -> Self {
        let departures = departures("", Fit::Unreadable(DepartureKind::Form), &found, || "an object".to_owned());
        Self { departures, ..Self::undescribed(Label::Message, found) }
    }

    fn undescribed(label: Label<'s>, found: Value) -> Self {
        Self { label, slot: None, body: Body::Leaf(found), literal: None, departures: Vec::new() }
    }
}

/// Values.
impl<'s> Node<'s> {
    /// Reads the value of a field, if the message has it.
    pub fn field(spec: &'s Spec, field: &'s Field, found: impl Into<Option<Value>>) -> Self {
        let (label, slot) = (Label::Field(field), Slot::of(spec, field));
        let found = match found.into() {
            Some(value) if !value.is_null() => return Self::value_of(label, slot, value),
            found => found,
        };
        let fit = if field.optional { Fit::Plain } else { Fit::Unreadable(DepartureKind::Missing) };
        let departures = departures("", fit, &Value::Null, || slot.words());
        Self { departures, body: found.map_or(Body::Absent, Body::Leaf), ..Self::blank(label, slot) }
    }

    fn value_of(label: Label<'s>, slot: Slot<'s>, value: Value) -> Self {
        let inner = if let Shape::Python(inner) = slot.shape { Some(inner) } else { None };
        let found = inner.and_then(|inner| Some((inner, scalar::literal(value.as_str()?)?)));
        if let Some((inner, found)) = found {
            let literal = value.as_str().map(str::to_owned);
            return Self { literal, ..Self::value_of(label, slot.inner(inner), found) };
        }
        let (body, fit) = read(&slot, value);
        let mut node = Self { body, ..Self::blank(label, slot) };
        if fit != Fit::Plain {
            node.departures = departures("", fit, &node.json(), || slot.words());
        }
        for departure in &mut node.departures {
            departure.advisory = departure.kind == DepartureKind::Range && slot.limits.advisory;
        }
        node
    }
}

/// Returns the parts of a value, if it has those of its type, and the fit of the value without them.
fn read<'s>(slot: &Slot<'s>, value: Value) -> (Body<'s>, Fit) {
    let (too_long, unlisted) = (Fit::Lenient(DepartureKind::Length), Fit::Lenient(DepartureKind::Unlisted));
    match (slot.shape, value) {
        (Shape::List(ty, len), Value::Array(found)) => {
            let fits = len.is_none_or(|len| len == found.len());
            let fit = if fits { Fit::Plain } else { Fit::Unreadable(DepartureKind::Length) };
            let element = |(index, value)| Node::value_of(Label::Element(index), slot.inner(ty), value);
            (Body::Parts(found.into_iter().enumerate().map(element).collect()), fit)
        }
        (Shape::Object(fields), Value::Object(found)) => (Body::Parts(object(slot.spec, fields, found)), Fit::Plain),
        (Shape::Tuple { fields, exact }, Value::Array(found)) => {
            let fit = match found.len() > fields.len() {
                true if exact => Fit::Unreadable(DepartureKind::Length),
                true => too_long,
                false => Fit::Plain,
            };
            (Body::Parts(elements(slot.spec, fields, found.into_iter()).collect()), fit)
        }
        (Shape::Choice(choice), Value::Array(found)) => {
            let Some(tag) = found.first().and_then(wire) else { return misfit(found.into()) };
            let Some(variant) = choice.variants.iter().find(|variant| variant.wire == tag) else {
                return (Body::Leaf(found.into()), unlisted);
            };
            let fit = if found.len() - 1 > variant.fields.len() { too_long } else { Fit::Plain };
            let (mut found, label) = (found.into_iter(), Label::Tag { key: "", variant: Some(variant) });
            let tag = found.next().map(|tag| Node::undescribed(label, tag));
            (Body::Parts(tag.into_iter().chain(elements(slot.spec, &variant.fields, found)).collect()), fit)
        }
        (Shape::IntEnum(values), value) => {
            let Some((wire, fit)) = scalar::int(&value) else { return misfit(value) };
            let is_listed = values.iter().any(|listed| listed.wire == wire);
            (Body::Leaf(value), if is_listed { fit } else { unlisted })
        }
        (Shape::TextEnum(values), Value::String(text)) => {
            let is_listed = values.iter().any(|listed| listed.wire == text);
            (Body::Leaf(text.into()), if is_listed { Fit::Plain } else { unlisted })
        }
        (Shape::Scalar(scalar), value) => {
            let fit = scalar::fit(scalar, &slot.limits, &value);
            (Body::Leaf(value), fit)
        }
        (_, value) => misfit(value),
    }
}

/// Returns the result for a value of another JSON type.
fn misfit<'s>(value: Value) -> (Body<'s>, Fit) {
    (Body::Leaf(value), Fit::Unreadable(DepartureKind::Form))
}

/// Returns the keys of an object without a description, then its fields.
fn object<'s>(spec: &'s Spec, fields: &'s [Field], mut found: Map<String, Value>) -> Vec<Node<'s>> {
    let fields: Vec<_> = fields.iter().map(|field| Node::field(spec, field, found.remove(&field.wire))).collect();
    let unknown = found.into_iter().map(|(key, value)| Node {
        departures: departures("", Fit::Lenient(DepartureKind::Unknown), &value, || notation(&value)),
        ..Node::undescribed(Label::Unknown(key), value)
    });
    unknown.chain(fields).collect()
}

fn undescribed<'s>(found: Map<String, Value>) -> Vec<Node<'s>> {
    found.into_iter().map(|(key, value)| Node::undescribed(Label::Unknown(key), value)).collect()
}

/// Returns the elements of a struct that is an array on the wire, and those beyond its fields.
fn elements<'s>(
    spec: &'s Spec,
    fields: &'s [Field],
    mut found: impl Iterator<Item = Value>,
) -> impl Iterator<Item = Node<'s>> {
    let members: Vec<_> = fields.iter().map(|field| Node::field(spec, field, found.next())).collect();
    let beyond = found.enumerate();
    let beyond = beyond.map(|(index, value)| Node::undescribed(Label::Element(fields.len() + index), value));
    members.into_iter().chain(beyond)
}

/// Reads the tag of a choice.
fn wire(tag: &Value) -> Option<i64> {
    scalar::int(tag).map(|(wire, _)| wire)
}

/// Returns the departures for this fit of a value, without those of its parts.
fn departures(field: &str, fit: Fit, value: &Value, expected: impl FnOnce() -> String) -> Vec<Departure> {
    let (kind, reading) = match fit {
        Fit::Plain => return Vec::new(),
        Fit::Lenient(kind) => (kind, Reading::Lenient),
        Fit::Unreadable(kind) => (kind, Reading::Unreadable),
    };
    let found = if kind == DepartureKind::Missing { String::new() } else { shown(value) };
    let (field, expected) = (field.to_owned(), expected());
    vec![Departure { field, kind, found, expected, reading, advisory: false, more: 0 }]
}

/// Returns the reply that a bare Python tuple represents.
fn bare_reply(command: &Command, reply: &Value) -> Option<Map<String, Value>> {
    let name = command.bare_reply.as_ref()?;
    let field = command.reply.own_fields().iter().find(|field| field.name == *name)?;
    let is_tuple = reply.as_str()?.trim_start().starts_with('(');
    is_tuple.then(|| Map::from_iter([(field.wire.clone(), reply.clone())]))
}

/// Removes from a reply the keys that every reply has; returns their departures, if the command is known.
fn envelope(command: Option<&Command>, found: &mut Map<String, Value>) -> Vec<Departure> {
    let [code, message, name] =
        [ERROR_CODE, ERROR_MESSAGE, COMMAND_NAME].map(|key| found.remove(key).unwrap_or_default());
    let Some(command) = command else { return Vec::new() };
    let kind = |value: &Value| if value.is_null() { DepartureKind::Missing } else { DepartureKind::Form };
    let code_fit = match scalar::error_code(&code) {
        Some(number) if code.as_str() == Some(&*number.to_string()) => Fit::Plain,
        Some(_) => Fit::Lenient(kind(&code)),
        None => Fit::Unreadable(kind(&code)),
    };
    let message_fit = if message.is_string() { Fit::Plain } else { Fit::Lenient(kind(&message)) };
    let name_fit = match name.as_str() {
        Some(text) if text == command.wire => Fit::Plain,
        Some(text) if text.trim() != command.wire => Fit::Unreadable(kind(&name)),
        _ => Fit::Lenient(kind(&name)),
    };
    let code = departures(ERROR_CODE, code_fit, &code, || "text of decimal digits".to_owned());
    let message = departures(ERROR_MESSAGE, message_fit, &message, || "text".to_owned());
    [code, message, departures(COMMAND_NAME, name_fit, &name, || format!("`{}`", command.wire))].concat()
}

/// Whether it is the reply to a command that was carried out.
pub(crate) fn is_success(reply: &Map<String, Value>) -> bool {
    let code = reply.get(ERROR_CODE).and_then(scalar::error_code);
    code.is_some_and(jaka_proto::ErrorCode::is_success)
}

/// Returns the apparent type of a value, in the spec's notation.
///
/// Numbers in arrays are floats: even if all of them are whole, others of their kind need not be. A number that is too
/// large for an `int` is `json`, which keeps all its digits.
pub fn notation(value: &Value) -> String {
    match value {
        Value::Bool(_) => "bool".to_owned(),
        Value::Number(number) if number.is_f64() => "float".to_owned(),
        Value::Number(number) if number.is_i64() => "int".to_owned(),
        Value::String(_) => "text".to_owned(),
        Value::Array(elements) => elements_notation(elements),
        Value::Number(_) | Value::Object(_) | Value::Null => "json".to_owned(),
    }
}

fn elements_notation(elements: &[Value]) -> String {
    let mut kinds: Vec<_> = elements.iter().map(notation).collect();
    kinds.sort();
    kinds.dedup();
    match kinds.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["int" | "float"] | ["float", "int"] => "float[]".to_owned(),
        [one] => format!("{one}[]"),
        _ => "json".to_owned(),
    }
}

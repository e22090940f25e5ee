//! Translation of messages between two specs that have the same fields in other forms.

use jaka_spec::{Command, EnumValue, Field, Request, Scalar, Shape, Spec, unit_factor};
use serde_json::{Map, Value};

use crate::scalar;
use crate::slot::Slot;
use crate::tree::{Label, Node};

/// Translation of messages between two specs, one of which is made from the other by a pack: keys, words for false
/// and true, units, literals, and objects that are arrays. Fields correspond by their names in Rust.
#[derive(Debug)]
pub struct Translation<'s> {
    from: &'s Spec,
    to: &'s Spec,
}

/// Message that is translated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Message<'m> {
    /// Request of this command.
    Request(&'m str),
    /// Reply to this command.
    Reply(&'m str),
    /// Packet of port 10000.
    Status,
}

/// Members of a translated message.
#[derive(Debug, Default, Clone, PartialEq)]
pub struct Translated {
    /// Members by the keys of the second spec.
    pub members: Map<String, Value>,
    /// Names in Rust, by the second spec, of fields whose values have no translation, which are left out.
    pub lost: Vec<String>,
    /// Names in Rust of fields that the second spec does not have, which are left out.
    pub unknown: Vec<String>,
}

impl<'s> Translation<'s> {
    /// Creates the translation of messages of the first spec into messages of the second.
    pub fn new(from: &'s Spec, to: &'s Spec) -> Self {
        Self { from, to }
    }

    /// Translates the members of a message. A member that neither spec knows stays as it is. A member whose key is a
    /// field of another name in the second spec is left out.
    pub fn message(&self, message: Message<'_>, members: &Map<String, Value>) -> Translated {
        let [from, to] = [self.from, self.to].map(|spec| fields(spec, message, members));
        self.members(from, to, members)
    }

    /// True if a message of the first spec is the same message of the second: with the same keys, types and units, and
    /// no further required field.
    pub fn is_identity(&self, message: Message<'_>) -> bool {
        self.parts_of(message).into_iter().all(|(from, to)| {
            let is_same = |field: &Field| {
                let other = counterpart(field, from, to);
                other.is_some_and(|other| {
                    field.wire == other.wire && Slot::of(self.from, field).means(&Slot::of(self.to, other))
                })
            };
            let is_known = |other: &Field| other.optional || counterpart(other, to, from).is_some();
            from.iter().all(is_same) && to.iter().all(is_known)
        })
    }

    /// Translates the value of a field; `None` if it has no translation.
    pub fn field(&self, from: &Field, to: &Field, value: &Value) -> Option<Value> {
        let to = Slot::of(self.to, to);
        if value.is_null() || Slot::of(self.from, from).means(&to) {
            return Some(value.clone());
        }
        self.value(&Node::field(self.from, from, value.clone()), to)
    }

    /// Returns the keys in the first spec of fields that the second does not have, or whose values have no translation.
    pub fn lost(&self, message: Message<'_>) -> Vec<String> {
        let can = |field: &Field, other: &Field| self.can(Slot::of(self.from, field), Slot::of(self.to, other));
        self.parts_of(message).into_iter().flat_map(|(from, to)| unmatched(from, to, can)).collect()
    }

    /// Returns the keys in the second spec of fields that the first does not have, or whose values have no translation.
    pub fn missing(&self, message: Message<'_>) -> Vec<String> {
        let can = |other: &Field, field: &Field| self.can(Slot::of(self.from, field), Slot::of(self.to, other));
        self.parts_of(message).into_iter().flat_map(|(from, to)| unmatched(to, from, can)).collect()
    }

    /// Returns the fields of a message in both specs; for a choice, those of each variant.
    fn parts_of(&self, message: Message<'_>) -> Vec<(&'s [Field], &'s [Field])> {
        let none = Map::new();
        let (Message::Request(name), (from, to)) = (message, (self.from, self.to)) else {
            return vec![(fields(self.from, message, &none), fields(self.to, message, &none))];
        };
        let choice = |spec: &'s Spec| spec.command(name).map_or(&[][..], Command::variants);
        let variants = choice(from).iter().map(|variant| {
            let same = choice(to).iter().find(|other| other.wire == variant.wire);
            (&*variant.fields, same.map_or(&[][..], |other| &other.fields))
        });
        variants.chain([(fields(from, message, &none), fields(to, message, &none))]).collect()
    }

    fn members(&self, from: &[Field], to: &[Field], members: &Map<String, Value>) -> Translated {
        let mut translated = Translated::default();
        for (key, value) in members {
            let Some(field) = from.iter().find(|field| field.wire == *key) else {
                if to.iter().all(|field| field.wire != *key) {
                    translated.members.insert(key.clone(), value.clone());
                }
                continue;
            };
            let Some(other) = counterpart(field, from, to) else {
                translated.unknown.push(field.name.clone());
                continue;
            };
            match self.field(field, other, value) {
                Some(value) => drop(translated.members.insert(other.wire.clone(), value)),
                None => translated.lost.push(other.name.clone()),
            }
        }
        translated
    }

    fn value(&self, node: &Node<'_>, to: Slot<'_>) -> Option<Value> {
        let (value, from) = (node.json(), node.slot?);
        if value.is_null() || from.means(&to) {
            return Some(value);
        }
        match (from.shape, to.shape) {
            (_, Shape::Python(inner)) => {
                let value = self.value(node, to.inner(inner))?;
                jaka_proto::python::from_json(&value.to_string()).ok().map(Value::from)
            }
            (Shape::Scalar(scalar), Shape::Scalar(other)) => match (scalar, other) {
                (Scalar::Bool { .. }, Scalar::Bool { off, on }) => {
                    let is_on = node.value().as_bool()?;
                    serde_json::from_str(if is_on { on } else { off }).ok()
                }
                (Scalar::Float | Scalar::Int, Scalar::Float) => number(value, factor(&from, &to)?),
                (Scalar::Float | Scalar::Int, Scalar::Int) if from.limits.unit == to.limits.unit => {
                    scalar::int(&value).map(|(whole, _)| whole.into())
                }
                (_, Scalar::Json) => Some(value),
                (scalar, other) => (scalar == other && from.limits.unit == to.limits.unit).then_some(value),
            },
            (Shape::IntEnum(_) | Shape::TextEnum(_) | Shape::Scalar(_), _) => listed(from.shape, to.shape, &value),
            _ if node.is_leaf() => None,
            (Shape::List(..), Shape::List(ty, len)) => {
                let elements: Option<Vec<_>> = node.parts().iter().map(|part| self.value(part, to.inner(ty))).collect();
                elements.filter(|elements| len.is_none_or(|len| elements.len() == len)).map(Value::from)
            }
            (Shape::Object(fields), Shape::Object(others)) => {
                let translated = self.members(fields, others, value.as_object()?);
                (translated.lost.is_empty() && translated.unknown.is_empty()).then(|| translated.members.into())
            }
            (Shape::Tuple { .. }, Shape::Object(others)) => {
                let member = |other: &Field| {
                    let part = node.part(&other.name).filter(|part| !part.json().is_null())?;
                    Some(self.value(part, Slot::of(self.to, other)).map(|value| (other.wire.clone(), value)))
                };
                others.iter().filter_map(member).collect::<Option<_>>().map(Value::Object)
            }
            (Shape::Object(_), Shape::Tuple { fields: others, .. }) => {
                let element = |other: &Field| self.value(node.part(&other.name)?, Slot::of(self.to, other));
                others.iter().map(element).collect::<Option<_>>().map(Value::Array)
            }
            (Shape::Tuple { .. }, Shape::Tuple { fields: others, .. }) => {
                self.elements(node.parts(), others).map(Value::from)
            }
            (Shape::Choice(_), Shape::Choice(other)) => {
                let other = other.variants.iter().find(|other| Some(&*other.name) == node.parts()[0].value_name())?;
                let elements = self.elements(&node.parts()[1..], &other.fields)?;
                Some([vec![other.wire.into()], elements].concat().into())
            }
            _ => None,
        }
    }

    /// Translates the elements of an array; elements beyond the fields stay as they are.
    fn elements(&self, parts: &[Node<'_>], others: &[Field]) -> Option<Vec<Value>> {
        let each = |(at, part): (usize, &Node<'_>)| match (part.label(), others.get(at)) {
            (Label::Field(field), Some(other)) if field.name == other.name => {
                self.value(part, Slot::of(self.to, other))
            }
            (Label::Element(_), _) => Some(part.json()),
            _ => None,
        };
        parts.iter().filter(|part| !part.is_absent()).enumerate().map(each).collect()
    }

    /// Whether values of the first can be translated into values of the second.
    fn can(&self, from: Slot<'_>, to: Slot<'_>) -> bool {
        if from.means(&to) {
            return true;
        }
        let can_list = |value: &Value| listed(from.shape, to.shape, value).is_some();
        let is_same_unit = from.limits.unit == to.limits.unit;
        let all = |fields: &[Field], others: &[Field]| {
            let can = |field: &Field, other: &Field| self.can(Slot::of(self.from, field), Slot::of(self.to, other));
            fields.iter().all(|field| others.iter().any(|other| other.name == field.name && can(field, other)))
        };
        match (from.shape, to.shape) {
            (Shape::Python(inner), _) => self.can(from.inner(inner), to),
            (_, Shape::Python(inner)) => self.can(from, to.inner(inner)),
            (Shape::Scalar(scalar), Shape::Scalar(other)) => match (scalar, other) {
                (Scalar::Bool { .. }, Scalar::Bool { .. }) | (_, Scalar::Json) => true,
                (Scalar::Float | Scalar::Int, Scalar::Float) => factor(&from, &to).is_some(),
                // The translation requires a whole number.
                (Scalar::Float, Scalar::Int) => is_same_unit,
                (scalar, other) => scalar == other && is_same_unit,
            },
            (Shape::List(element, len), Shape::List(other, other_len)) => {
                (other_len.is_none() || len == other_len) && self.can(from.inner(element), to.inner(other))
            }
            (
                Shape::Object(fields) | Shape::Tuple { fields, .. },
                Shape::Object(others) | Shape::Tuple { fields: others, .. },
            ) => all(fields, others),
            (Shape::Scalar(Scalar::Int), Shape::IntEnum(_)) => true,
            (Shape::Choice(choice), Shape::Choice(other)) => choice.variants.iter().all(|variant| {
                let same = other.variants.iter().find(|other| other.name == variant.name);
                same.is_some_and(|other| all(&variant.fields, &other.fields))
            }),
            (Shape::IntEnum(values), _) => values.iter().all(|value| can_list(&value.wire.into())),
            (Shape::TextEnum(values), _) => values.iter().all(|value| can_list(&value.wire.as_str().into())),
            _ => false,
        }
    }
}

/// Returns the field of the other spec that corresponds to a field of this one: by its name in Rust, or else by its
/// key, which a pack may have given another name.
pub fn counterpart<'f>(field: &Field, own: &[Field], others: &'f [Field]) -> Option<&'f Field> {
    let by_name = others.iter().find(|other| other.name == field.name);
    by_name.or_else(|| {
        let is_free = |other: &&Field| own.iter().all(|own| own.name != other.name);
        others.iter().filter(is_free).find(|other| other.wire == field.wire && !field.wire.is_empty())
    })
}

/// Returns the keys of fields that have no counterpart, or none whose value `can` be translated.
fn unmatched(fields: &[Field], others: &[Field], can: impl Fn(&Field, &Field) -> bool) -> Vec<String> {
    let is_unmatched = |field: &&Field| !counterpart(field, fields, others).is_some_and(|other| can(field, other));
    fields.iter().filter(is_unmatched).map(|field| field.wire.clone()).collect()
}

/// Returns the value of an enum as one of another enum, or as a raw number that a pack names. Enums are open.
fn listed(from: Shape<'_>, to: Shape<'_>, value: &Value) -> Option<Value> {
    let int = || scalar::int(value).map(|(int, _)| int);
    let text = || value.as_str().map(str::to_owned);
    match (from, to) {
        (Shape::Scalar(Scalar::Int), Shape::IntEnum(_)) | (Shape::IntEnum(_), Shape::Scalar(Scalar::Int)) => {
            int().map(Value::from)
        }
        (Shape::IntEnum(values), Shape::IntEnum(others)) => translated(values, others, &int()?).map(Value::from),
        (Shape::TextEnum(values), Shape::TextEnum(others)) => translated(values, others, &text()?).map(Value::from),
        (Shape::IntEnum(values), Shape::TextEnum(others)) => renamed(values, others, &int()?).map(Value::from),
        (Shape::TextEnum(values), Shape::IntEnum(others)) => renamed(values, others, &text()?).map(Value::from),
        _ => None,
    }
}

/// Returns the value of the other enum that has the same name.
fn renamed<T: PartialEq, U: Clone>(values: &[EnumValue<T>], others: &[EnumValue<U>], wire: &T) -> Option<U> {
    let name = &values.iter().find(|value| value.wire == *wire)?.name;
    others.iter().find(|other| other.name == *name).map(|other| other.wire.clone())
}

/// Returns the value of another enum of the same kind. A value of the same name is preferred. Otherwise the value keeps
/// its form, also under another name or if an enum does not list it, since enums are open. There is no value if the
/// other enum gives this form the name of another value.
fn translated<T: PartialEq + Clone>(values: &[EnumValue<T>], others: &[EnumValue<T>], wire: &T) -> Option<T> {
    renamed(values, others, wire).or_else(|| {
        let other = others.iter().find(|other| other.wire == *wire);
        let is_another = other.is_some_and(|other| values.iter().any(|value| value.name == other.name));
        (!is_another).then(|| wire.clone())
    })
}

/// Returns the fields of a message; for a choice, those of the variant.
fn fields<'s>(spec: &'s Spec, message: Message<'_>, members: &Map<String, Value>) -> &'s [Field] {
    let command = |name: &str| spec.command(name);
    match message {
        Message::Status => spec.status_fields(),
        Message::Reply(name) => command(name).map_or(&[], |command| spec.reply_fields(command)),
        Message::Request(name) => match command(name).map(|command| &command.request) {
            None => &[],
            Some(Request::Fields(fields)) => fields,
            Some(Request::Choice(choice)) => {
                let tag = members.get(&choice.tag).and_then(scalar::int).map(|(tag, _)| tag);
                let variant = choice.variants.iter().find(|variant| Some(variant.wire) == tag);
                variant.map_or(&[], |variant| &variant.fields)
            }
        },
    }
}

/// Returns a number in another unit.
fn number(value: Value, factor: f64) -> Option<Value> {
    #[expect(clippy::float_cmp, reason = "the factor of one unit is exactly one")]
    if factor == 1.0 {
        return Some(value);
    }
    serde_json::Number::from_f64(scalar::float_value(&value)? * factor).map(Value::from)
}

/// Returns the factor between the units of two places; `None` if it is not known.
fn factor(from: &Slot<'_>, to: &Slot<'_>) -> Option<f64> {
    match (from.limits.unit, to.limits.unit) {
        (from, to) if from == to => Some(1.0),
        (from, to) => unit_factor(from, to),
    }
}

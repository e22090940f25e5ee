//! Messages of one spec as messages of another, which has the same fields in other forms.

use jaka_spec::{Command, EnumValue, Field, Request, Scalar, Shape, Spec, Type, unit_factor};
use serde_json::{Map, Value};

use crate::scalar;

/// Translation of messages between two specs, one of which was made of the other by a pack, or is that of a firmware:
/// keys, words for false and true, units, literals, and objects that are arrays. Fields belong together by their names
/// in Rust.
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
    /// Members, by the keys of the second spec.
    pub members: Map<String, Value>,
    /// Fields without a translation of their value, which are left out.
    pub lost: Vec<Lost>,
    /// Names in Rust of fields that the second spec does not have, which are left out.
    pub unknown: Vec<String>,
}

/// Field whose value has no translation.
#[derive(Debug, Clone, PartialEq)]
pub struct Lost {
    /// Name in Rust that the second spec has for the field.
    pub name: String,
    /// Value in the message.
    pub value: Value,
}

impl<'s> Translation<'s> {
    /// Translation of messages of the first spec into messages of the second.
    pub fn new(from: &'s Spec, to: &'s Spec) -> Self {
        Self { from, to }
    }

    /// Translates the members of a message. A member that neither spec knows stays as it is; one that the second spec
    /// has for a field of another name is left out.
    pub fn message(&self, message: Message<'_>, members: &Map<String, Value>) -> Translated {
        let [from, to] = [self.from, self.to].map(|spec| fields(spec, message, members));
        self.members(from, to, members)
    }

    /// True if a message of the first spec is the same message of the second, whatever its firmware: with the same
    /// keys, types and units, and no field more that must be there.
    pub fn is_identity(&self, message: Message<'_>) -> bool {
        self.parts_of(message).into_iter().all(|(from, to)| {
            let is_same = |field: &Field| {
                let other = counterpart(field, from, to);
                other.is_some_and(|other| {
                    field.wire == other.wire
                        && of(field).means(self.from, of(other), self.to)
                        && !self.to.has_forms(std::slice::from_ref(other))
                })
            };
            let is_known = |other: &Field| other.optional || counterpart(other, to, from).is_some();
            from.iter().all(is_same) && to.iter().all(is_known)
        })
    }

    /// Translates the value of a field; none where it has no translation.
    pub fn field(&self, from: &Field, to: &Field, value: &Value) -> Option<Value> {
        self.value(of(from), of(to), value)
    }

    /// Keys in the first spec of fields of a message that the second has not, or whose values have no translation.
    pub fn lost(&self, message: Message<'_>) -> Vec<String> {
        let can = |field: &Field, other: &Field| self.can(of(field), of(other));
        self.parts_of(message).into_iter().flat_map(|(from, to)| unmatched(from, to, can)).collect()
    }

    /// Keys in the second spec of fields of a message that the first has not, or whose values have no translation.
    pub fn missing(&self, message: Message<'_>) -> Vec<String> {
        let can = |other: &Field, field: &Field| self.can(of(field), of(other));
        self.parts_of(message).into_iter().flat_map(|(from, to)| unmatched(to, from, can)).collect()
    }

    /// The fields of a message in both specs; of a choice, those of each variant.
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
            match self.value(of(field), of(other), value) {
                Some(value) => drop(translated.members.insert(other.wire.clone(), value)),
                None => translated.lost.push(Lost { name: other.name.clone(), value: value.clone() }),
            }
        }
        translated
    }

    fn value(&self, from: Kind<'_>, to: Kind<'_>, value: &Value) -> Option<Value> {
        if value.is_null() || from.means(self.from, to, self.to) {
            return Some(value.clone());
        }
        let (from, to) = (from.unwrapped(self.from), to.unwrapped(self.to));
        match (from.ty, to.ty) {
            (Type::Python(inner), _) => self.value(from.inner(inner), to, &scalar::literal(value.as_str()?)?),
            (_, Type::Python(inner)) => {
                let value = self.value(from, to.inner(inner), value)?;
                jaka_proto::python::from_json(&value.to_string()).ok().map(Value::from)
            }
            (Type::Scalar(from_scalar), Type::Scalar(to_scalar)) => match (from_scalar, to_scalar) {
                (Scalar::Bool { .. }, Scalar::Bool { off, on }) => {
                    let is_on = scalar::truth_value(from_scalar, value)?;
                    serde_json::from_str(if is_on { on } else { off }).ok()
                }
                (Scalar::Float | Scalar::Int, Scalar::Float) => number(value, from.unit, to.unit),
                (Scalar::Float | Scalar::Int, Scalar::Int) if from.unit == to.unit => {
                    scalar::int(value).map(|(whole, _)| whole.into())
                }
                (_, Scalar::Json) => Some(value.clone()),
                (from_scalar, to_scalar) => (from_scalar == to_scalar && from.unit == to.unit).then(|| value.clone()),
            },
            _ => self.parts(from, to, value),
        }
    }

    /// Translates what has parts.
    fn parts(&self, from: Kind<'_>, to: Kind<'_>, value: &Value) -> Option<Value> {
        match (self.from.shape(from.ty), self.to.shape(to.ty)) {
            (Shape::List(element, _), Shape::List(other, len)) => {
                let elements = value.as_array()?;
                let each = |value| self.value(from.inner(element), to.inner(other), value);
                let elements: Option<Vec<_>> = elements.iter().map(each).collect();
                elements.filter(|elements| len.is_none_or(|len| elements.len() == len)).map(Value::from)
            }
            (Shape::Object(fields), Shape::Object(others)) => {
                let translated = self.members(fields, others, value.as_object()?);
                (translated.lost.is_empty() && translated.unknown.is_empty()).then(|| translated.members.into())
            }
            (Shape::Object(fields), Shape::Tuple { fields: others, .. }) => {
                let found = value.as_object()?;
                let element = |other: &Field| {
                    let field = fields.iter().find(|field| field.name == other.name)?;
                    self.value(of(field), of(other), found.get(&field.wire).unwrap_or(&Value::Null))
                };
                let elements: Option<Vec<_>> = others.iter().map(element).collect();
                elements.map(Value::from)
            }
            (Shape::Tuple { fields, .. }, Shape::Object(others)) => {
                let found = value.as_array()?;
                let mut members = Map::new();
                for (field, value) in fields.iter().zip(found).filter(|(_, value)| !value.is_null()) {
                    let other = others.iter().find(|other| other.name == field.name)?;
                    members.insert(other.wire.clone(), self.value(of(field), of(other), value)?);
                }
                Some(members.into())
            }
            (Shape::Tuple { fields, .. }, Shape::Tuple { fields: others, .. }) => {
                self.elements(fields, others, value.as_array()?).map(Value::from)
            }
            (Shape::Choice(choice), Shape::Choice(other)) => {
                let (tag, rest) = value.as_array()?.split_first()?;
                let wire = scalar::int(tag)?.0;
                let variant = choice.variants.iter().find(|variant| variant.wire == wire)?;
                let other = other.variants.iter().find(|other| other.name == variant.name)?;
                let elements = self.elements(&variant.fields, &other.fields, rest)?;
                Some([vec![other.wire.into()], elements].concat().into())
            }
            // A raw number that a pack names, or the other way round. Enums are open.
            (Shape::Scalar(Scalar::Int), Shape::IntEnum(_)) | (Shape::IntEnum(_), Shape::Scalar(Scalar::Int)) => {
                Some(scalar::int(value)?.0.into())
            }
            (Shape::IntEnum(values), Shape::IntEnum(others)) => {
                translated(values, others, &scalar::int(value)?.0).map(Value::from)
            }
            (Shape::TextEnum(values), Shape::TextEnum(others)) => {
                translated(values, others, &value.as_str()?.to_owned()).map(Value::from)
            }
            (Shape::IntEnum(values), Shape::TextEnum(others)) => {
                renamed(values, others, &scalar::int(value)?.0).map(Value::from)
            }
            (Shape::TextEnum(values), Shape::IntEnum(others)) => {
                renamed(values, others, &value.as_str()?.to_owned()).map(Value::from)
            }
            _ => None,
        }
    }

    /// Translates the elements of an array; those beyond the fields stay as they are.
    fn elements(&self, fields: &[Field], others: &[Field], found: &[Value]) -> Option<Vec<Value>> {
        let each = |(at, value): (usize, &Value)| match (fields.get(at), others.get(at)) {
            (Some(field), Some(other)) if field.name == other.name => self.value(of(field), of(other), value),
            (None, _) => Some(value.clone()),
            _ => None,
        };
        found.iter().enumerate().map(each).collect()
    }

    /// True if values of the one can be translated into values of the other.
    fn can(&self, from: Kind<'_>, to: Kind<'_>) -> bool {
        if from.means(self.from, to, self.to) {
            return true;
        }
        let (from, to) = (from.unwrapped(self.from), to.unwrapped(self.to));
        match (from.ty, to.ty) {
            (Type::Python(inner), _) => return self.can(from.inner(inner), to),
            (_, Type::Python(inner)) => return self.can(from, to.inner(inner)),
            (Type::Scalar(from_scalar), Type::Scalar(to_scalar)) => {
                return match (from_scalar, to_scalar) {
                    (Scalar::Bool { .. }, Scalar::Bool { .. }) | (_, Scalar::Json) => true,
                    (Scalar::Float | Scalar::Int, Scalar::Float) => factor(from.unit, to.unit).is_some(),
                    // As far as the number is whole.
                    (Scalar::Float, Scalar::Int) => from.unit == to.unit,
                    (from_scalar, to_scalar) => from_scalar == to_scalar && from.unit == to.unit,
                };
            }
            _ => {}
        }
        let all = |fields: &[Field], others: &[Field]| {
            fields
                .iter()
                .all(|field| others.iter().any(|other| other.name == field.name && self.can(of(field), of(other))))
        };
        match (self.from.shape(from.ty), self.to.shape(to.ty)) {
            (Shape::List(element, len), Shape::List(other, other_len)) => {
                (other_len.is_none() || len == other_len) && self.can(from.inner(element), to.inner(other))
            }
            (
                Shape::Object(fields) | Shape::Tuple { fields, .. },
                Shape::Object(others) | Shape::Tuple { fields: others, .. },
            ) => all(fields, others),
            (Shape::Scalar(Scalar::Int), Shape::IntEnum(_)) | (Shape::IntEnum(_), Shape::Scalar(Scalar::Int)) => true,
            (Shape::Choice(choice), Shape::Choice(other)) => choice.variants.iter().all(|variant| {
                let same = other.variants.iter().find(|other| other.name == variant.name);
                same.is_some_and(|other| all(&variant.fields, &other.fields))
            }),
            (Shape::IntEnum(values), Shape::IntEnum(others)) => {
                values.iter().all(|value| translated(values, others, &value.wire).is_some())
            }
            (Shape::TextEnum(values), Shape::TextEnum(others)) => {
                values.iter().all(|value| translated(values, others, &value.wire).is_some())
            }
            (Shape::IntEnum(values), Shape::TextEnum(others)) => {
                values.iter().all(|value| renamed(values, others, &value.wire).is_some())
            }
            (Shape::TextEnum(values), Shape::IntEnum(others)) => {
                values.iter().all(|value| renamed(values, others, &value.wire).is_some())
            }
            _ => false,
        }
    }
}

/// The field of the other spec that a field of this one stands for: that of its name in Rust, or else of its key, which
/// a pack may have given another name.
pub fn counterpart<'f>(field: &Field, own: &[Field], others: &'f [Field]) -> Option<&'f Field> {
    let by_name = others.iter().find(|other| other.name == field.name);
    by_name.or_else(|| {
        let is_free = |other: &&Field| own.iter().all(|own| own.name != other.name);
        others.iter().filter(is_free).find(|other| other.wire == field.wire && !field.wire.is_empty())
    })
}

/// Keys of fields that have no counterpart, or none whose value `can` be translated.
fn unmatched(fields: &[Field], others: &[Field], can: impl Fn(&Field, &Field) -> bool) -> Vec<String> {
    let is_unmatched = |field: &&Field| !counterpart(field, fields, others).is_some_and(|other| can(field, other));
    fields.iter().filter(is_unmatched).map(|field| field.wire.clone()).collect()
}

/// Value of the other enum with the name of this one.
fn renamed<T: PartialEq, U: Clone>(values: &[EnumValue<T>], others: &[EnumValue<U>], wire: &T) -> Option<U> {
    let name = &values.iter().find(|value| value.wire == *wire)?.name;
    others.iter().find(|other| other.name == *name).map(|other| other.wire.clone())
}

/// Value of another enum of the same kind. A value that is written alike stands for itself, also under another name or
/// where an enum does not list it, since enums are open; unless it has there the name of another value of this one.
fn translated<T: PartialEq + Clone>(values: &[EnumValue<T>], others: &[EnumValue<T>], wire: &T) -> Option<T> {
    renamed(values, others, wire).or_else(|| {
        let other = others.iter().find(|other| other.wire == *wire);
        let is_another = other.is_some_and(|other| values.iter().any(|value| value.name == other.name));
        (!is_another).then(|| wire.clone())
    })
}

/// The fields of a message; of a choice, those of the variant.
pub(crate) fn fields<'s>(spec: &'s Spec, message: Message<'_>, members: &Map<String, Value>) -> &'s [Field] {
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

/// Type of a value, and the unit that its field gives it.
#[derive(Debug, Clone, Copy)]
struct Kind<'f> {
    ty: &'f Type,
    unit: Option<&'f str>,
}

fn of(field: &Field) -> Kind<'_> {
    Kind { ty: &field.ty, unit: field.unit.as_deref() }
}

impl<'f> Kind<'f> {
    fn inner(self, ty: &'f Type) -> Self {
        Self { ty, ..self }
    }

    /// The wrapped type with its unit, if it is a wrapper.
    fn unwrapped<'s>(self, spec: &'s Spec) -> Kind<'s>
    where
        'f: 's,
    {
        Kind { ty: spec.unwrapped(self.ty), unit: spec.unit(self.ty).or(self.unit) }
    }

    /// True if values mean the same in both specs as they stand.
    fn means(self, spec: &Spec, other: Kind<'_>, other_spec: &Spec) -> bool {
        self.ty == other.ty && self.unit == other.unit && spec.defines_as(other_spec, self.ty)
    }
}

/// A number in another unit; none where it is not known how they relate.
fn number(value: &Value, from: Option<&str>, to: Option<&str>) -> Option<Value> {
    let factor = factor(from, to)?;
    #[expect(clippy::float_cmp, reason = "the factor of one unit is exactly one")]
    if factor == 1.0 {
        return Some(value.clone());
    }
    let number: f64 = scalar::float_value(value)?;
    serde_json::Number::from_f64(number * factor).map(Value::from)
}

fn factor(from: Option<&str>, to: Option<&str>) -> Option<f64> {
    match (from, to) {
        (Some(from), Some(to)) => unit_factor(from, to),
        (from, to) => (from == to).then_some(1.0),
    }
}

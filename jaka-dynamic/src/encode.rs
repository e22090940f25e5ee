//! Requests encoded as JSON, strictly.

use jaka_proto::check::{Advice, Advised, AdvisoryRanges};
use jaka_proto::wire::Writer;
use jaka_spec::{Choice, Command, EnumValue, Field, Request, Shape, Spec, Variant};
use serde_json::{Map, Value};

use crate::names::{field_of, same, suggestion};
use crate::problem::{Problem, ProblemKind, element, member};
use crate::scalar::{self, Forbidden};
use crate::slot::{Slot, variants};

/// Returns the request with these fields, byte for byte as the generated code writes it.
///
/// - A field has its wire spelling or its Rust name as key. A field that is null counts as absent.
/// - A struct that the wire writes as an array may be that array, or an object of its fields.
/// - A value of an enum may be its wire form or its name, in any case: `0`, `"Absolute"`, `"absolute"`. So may the tag
///   of a choice, which has its key on the wire.
/// - A truth value may be true or false, or its form on the wire. A Python literal is taken as text, unread.
///
/// # Errors
/// All violations of the spec at once: unknown fields, and then the rest in the order of the spec.
pub fn request(
    spec: &Spec,
    command: &Command,
    fields: &Map<String, Value>,
    ranges: AdvisoryRanges,
) -> Result<String, Vec<Problem>> {
    let mut encoder = Encoder { spec, ranges, out: Writer::new(), problems: Vec::new() };
    encoder.out.raw(&command.head());
    match &command.request {
        Request::Fields(known) => encoder.object(("", Advised::NONE), known, fields, ""),
        Request::Choice(choice) => encoder.object_choice(choice, fields),
    }
    encoder.out.raw("}");
    if encoder.problems.is_empty() { Ok(encoder.out.into_string()) } else { Err(encoder.problems) }
}

/// Path of the enclosing value, and the advice on the numbers in it.
type Outer<'a> = (&'a str, Advised<'a>);

struct Encoder<'s> {
    spec: &'s Spec,
    ranges: AdvisoryRanges,
    out: Writer,
    problems: Vec<Problem>,
}

/// Fields of structs, of arrays and of choices.
impl Encoder<'_> {
    /// Writes the fields of an object, without braces. Advice on outer numbers applies to each field without advice of
    /// its own. `tag` is a key that is not a field.
    fn object(&mut self, (place, advised): Outer<'_>, fields: &[Field], given: &Map<String, Value>, tag: &str) {
        for (key, value) in given.iter().filter(|(key, _)| *key != tag && field_of(fields, key).is_none()) {
            let known = suggestion(key, fields.iter().map(|field| [field.name.as_str(), field.wire.as_str()]));
            self.problem(&member(place, key), ProblemKind::Unknown, value, known);
        }
        let values: Vec<_> = fields.iter().map(|field| self.given(place, fields, field, given)).collect();
        self.members((place, advised), fields, &values);
    }

    /// Returns the value given for a field.
    fn given<'v>(
        &mut self,
        place: &str,
        fields: &[Field],
        field: &Field,
        given: &'v Map<String, Value>,
    ) -> Option<&'v Value> {
        let is_field = |key: &str| field_of(fields, key).is_some_and(|found| found.name == field.name);
        let mut values = given.iter().filter(|(key, value)| is_field(key) && !value.is_null()).map(|(_, value)| value);
        let value = values.next();
        if let Some(again) = values.next() {
            self.problem(&member(place, &field.name), ProblemKind::Repeated, again, String::new());
        }
        value
    }

    /// Writes one value for each field, with its key if it has one.
    fn members(&mut self, (outer, advised): Outer<'_>, fields: &[Field], values: &[Option<&Value>]) {
        for (index, (field, value)) in fields.iter().zip(values).enumerate() {
            // An element of an array cannot be left out before one that is given.
            let gap = field.wire.is_empty() && values[index..].iter().any(Option::is_some);
            let place = member(outer, &field.name);
            let (rows, times) = rows(self.spec, fields, (field, self.ranges), values);
            let advised = if rows.is_empty() { advised } else { Advised::to(&rows).times(times) };
            let slot = Slot::of(self.spec, field).advised(advised);
            if let Some(value) = value {
                if field.wire.is_empty() {
                    self.out.comma();
                } else {
                    self.out.key(&field.key());
                }
                self.value(&place, &slot, value);
            } else if !field.optional || gap {
                self.problem(&place, ProblemKind::Missing, &Value::Null, slot.words());
            }
        }
    }

    fn object_choice(&mut self, choice: &Choice, given: &Map<String, Value>) {
        let tag = given.get(&choice.tag).unwrap_or(&Value::Null);
        let Some(variant) = variant(choice, tag) else {
            let kind = if tag.is_null() { ProblemKind::Missing } else { ProblemKind::Forbidden };
            return self.problem(&choice.tag, kind, tag, variants(&choice.variants));
        };
        self.out.key(&choice.key());
        self.out.int(variant.wire);
        self.object(("", Advised::NONE), &variant.fields, given, &choice.tag);
    }

    fn problem(&mut self, place: &str, kind: ProblemKind, value: &Value, allowed: String) {
        self.problems.push(Problem::new(place, kind, value, allowed));
    }

    fn value(&mut self, place: &str, slot: &Slot<'_>, value: &Value) {
        if let Err(forbidden) = self.write(place, slot, value) {
            let problem = Problem::new(place, ProblemKind::Forbidden, value, slot.words());
            self.problems.push(Problem { advisory: forbidden == Forbidden::Advisory, ..problem });
        }
    }

    fn write(&mut self, place: &str, slot: &Slot<'_>, value: &Value) -> Result<(), Forbidden> {
        match slot.shape {
            Shape::Scalar(scalar) => scalar::write(scalar, &slot.limits, self.ranges, value, &mut self.out)?,
            Shape::Python(_) => {
                let text = value.as_str().filter(|text| slot.limits.allow_text(text));
                self.out.text(text.ok_or(Forbidden::Always)?);
            }
            Shape::List(element, len) => self.list(place, &slot.inner(element), value, len)?,
            Shape::Object(fields) => {
                let given = value.as_object().ok_or(Forbidden::Always)?;
                self.out.raw("{");
                self.object((place, slot.limits.advised), fields, given, "");
                self.out.raw("}");
            }
            Shape::Tuple { fields, .. } => {
                self.out.raw("[");
                match value {
                    Value::Object(given) => self.object((place, slot.limits.advised), fields, given, ""),
                    Value::Array(elements) => self.elements((place, slot.limits.advised), fields, elements)?,
                    _ => return Err(Forbidden::Always),
                }
                self.out.raw("]");
            }
            Shape::IntEnum(values) => {
                let listed = values.iter().find(|listed| is_value(value, listed.wire, &listed.name));
                self.out.int(self.allowed(listed)?.wire);
            }
            Shape::TextEnum(values) => {
                let text = value.as_str().unwrap_or_default();
                let listed = values.iter().find(|listed| listed.wire == text);
                let listed = listed.or_else(|| values.iter().find(|listed| same(&listed.name, text)));
                let wire = &self.allowed(listed)?.wire;
                self.out.text(wire);
            }
            Shape::Choice(choice) => {
                let (tag, rest) =
                    value.as_array().and_then(|elements| elements.split_first()).ok_or(Forbidden::Always)?;
                let variant = variant(choice, tag).ok_or(Forbidden::Always)?;
                self.out.raw("[");
                self.out.int(variant.wire);
                self.elements((place, slot.limits.advised), &variant.fields, rest)?;
                self.out.raw("]");
            }
        }
        Ok(())
    }

    /// Writes the elements of a struct that is an array on the wire.
    fn elements(&mut self, outer: Outer<'_>, fields: &[Field], elements: &[Value]) -> Result<(), Forbidden> {
        let required = fields.iter().filter(|field| !field.optional).count();
        if elements.len() < required || elements.len() > fields.len() {
            return Err(Forbidden::Always);
        }
        let values: Vec<_> = elements.iter().map(|value| Some(value).filter(|value| !value.is_null())).collect();
        self.members(outer, fields, &values);
        Ok(())
    }

    fn list(&mut self, outer: &str, slot: &Slot<'_>, value: &Value, len: Option<usize>) -> Result<(), Forbidden> {
        let items =
            value.as_array().filter(|items| len.is_none_or(|len| items.len() == len)).ok_or(Forbidden::Always)?;
        self.out.raw("[");
        for (index, item) in items.iter().enumerate() {
            self.out.comma();
            self.value(&element(outer, index), slot, item);
        }
        self.out.raw("]");
        Ok(())
    }

    /// Returns the value of an enum, if it may be sent.
    fn allowed<'v, T>(&self, listed: Option<&'v EnumValue<T>>) -> Result<&'v EnumValue<T>, Forbidden> {
        let allowed = listed.filter(|listed| !listed.advisory || self.ranges == AdvisoryRanges::Ignored);
        allowed.ok_or(if listed.is_some() { Forbidden::Advisory } else { Forbidden::Always })
    }
}

/// Returns the variant with this tag or name.
fn variant<'c>(choice: &'c Choice, tag: &Value) -> Option<&'c Variant> {
    choice.variants.iter().find(|variant| is_value(tag, variant.wire, &variant.name))
}

/// Whether `value` is this number, or the name of it.
fn is_value(value: &Value, wire: i64, name: &str) -> bool {
    value.as_i64() == Some(wire) || value.as_str().is_some_and(|text| same(text, name))
}

/// Returns the advice for a field, which is one of `fields` with `values`, and the factor of its bounds. There is no
/// advice if the caller leaves that to the controller.
fn rows<'a>(
    spec: &Spec,
    fields: &[Field],
    (field, ranges): (&'a Field, AdvisoryRanges),
    values: &[Option<&Value>],
) -> (Vec<Advice<'a>>, Option<i64>) {
    let sibling = |name: &String| {
        let at = fields.iter().position(|other| other.name == *name)?;
        Some((&fields[at], values[at]?))
    };
    let holds = |advice: &&jaka_spec::Advice| {
        ranges == AdvisoryRanges::Enforced
            && advice.when.as_ref().is_none_or(|when| {
                sibling(&when.field).is_some_and(|(selector, value)| is_selected(spec, selector, value, when.value))
            })
    };
    let held: Vec<_> = field.advised.iter().filter(holds).collect();
    let count = held.first().and_then(|advice| sibling(advice.per.as_ref()?));
    let times = count.and_then(|(_, value)| value.as_i64());
    let row = |advice: &&'a jaka_spec::Advice| Advice {
        max: advice.max,
        nonzero: advice.nonzero,
        unit: advice.unit.as_deref().unwrap_or_default(),
    };
    (held.iter().map(row).collect(), times)
}

/// Whether the value given for an enum is the one with this number.
fn is_selected(spec: &Spec, selector: &Field, value: &Value, wire: i64) -> bool {
    let Shape::IntEnum(values) = spec.shape(&selector.ty) else { return false };
    values.iter().any(|listed| listed.wire == wire && is_value(value, wire, &listed.name))
}

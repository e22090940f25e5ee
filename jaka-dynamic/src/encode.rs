//! Requests into JSON, strictly.

mod advice;
mod value;

use jaka_proto::check::{Advised, AdvisoryRanges};
use jaka_proto::wire::Writer;
use serde_json::{Map, Value};

use super::names::{field_of, same, suggestion};
use super::problem::{Problem, ProblemKind, member};
use super::slot::{Slot, variants};
use jaka_spec::{Choice, Command, Field, Request, Spec, Variant};

/// The request with these fields, byte for byte as the generated code writes it.
///
/// - A field is given under its wire spelling or its Rust name. One that is null counts as absent.
/// - A struct that the wire writes as an array is taken as that array, or as an object of its fields.
/// - A value of an enum is taken by its wire form or by its name, in any case: `0`, `"Absolute"`, `"absolute"`. So is
///   the tag of a choice, which is given under its key on the wire.
/// - A truth value is taken as true or false, or as the wire writes it. A Python literal is taken as its text, unread.
///
/// # Errors
/// Everything that the spec forbids, at once: unknown fields, and then the rest in the order of the spec.
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

/// Path of what fields stand in, and what is advised of the numbers in it.
type Outer<'a> = (&'a str, Advised<'a>);

struct Encoder<'s> {
    spec: &'s Spec,
    ranges: AdvisoryRanges,
    out: Writer,
    problems: Vec<Problem>,
}

/// Fields of structs, of arrays and of choices.
impl Encoder<'_> {
    /// Writes the fields of an object, without braces. What is advised of outer numbers holds where a field does not
    /// say otherwise. `tag` is a key that is not a field.
    fn object(&mut self, (place, advised): Outer<'_>, fields: &[Field], given: &Map<String, Value>, tag: &str) {
        for (key, value) in given.iter().filter(|(key, _)| *key != tag && field_of(fields, key).is_none()) {
            let known = suggestion(key, fields.iter().map(|field| [field.name.as_str(), field.wire.as_str()]));
            self.problem(&member(place, key), ProblemKind::Unknown, value, known);
        }
        let values: Vec<_> = fields.iter().map(|field| self.given(place, fields, field, given)).collect();
        self.members((place, advised), fields, &values);
    }

    /// The value given for a field.
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

    /// Writes one value for each field, with its key where it has one.
    fn members(&mut self, (outer, advised): Outer<'_>, fields: &[Field], values: &[Option<&Value>]) {
        for (index, (field, value)) in fields.iter().zip(values).enumerate() {
            // An element of an array cannot be left out before one that is given.
            let gap = field.wire.is_empty() && values[index..].iter().any(Option::is_some);
            let place = member(outer, &field.name);
            let rows = advice::rows(self.spec, fields, (field, self.ranges), values);
            let advised = if rows.list.is_empty() { advised } else { Advised::to(&rows.list).times(rows.times) };
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
}

/// The variant whose tag, or name, this is.
fn variant<'c>(choice: &'c Choice, tag: &Value) -> Option<&'c Variant> {
    choice.variants.iter().find(|variant| is_value(tag, variant.wire, &variant.name))
}

/// True if `value` is this number, or the name that goes with it.
fn is_value(value: &Value, wire: i64, name: &str) -> bool {
    value.as_i64() == Some(wire) || value.as_str().is_some_and(|text| same(text, name))
}

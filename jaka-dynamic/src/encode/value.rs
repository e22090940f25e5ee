//! Values into JSON.

use jaka_proto::check::AdvisoryRanges;
use jaka_spec::{EnumValue, Field, Shape};
use serde_json::Value;

use super::{Encoder, Outer, is_value, variant};
use crate::names::same;
use crate::problem::{Problem, ProblemKind, element};
use crate::scalar;
use crate::slot::Slot;

/// A value may be forbidden: the error says whether that is advisory.
type Written = Result<(), bool>;

impl Encoder<'_> {
    pub(super) fn value(&mut self, place: &str, slot: &Slot<'_>, value: &Value) {
        if let Err(advisory) = self.write(place, slot, value) {
            let problem = Problem::new(place, ProblemKind::Forbidden, value, slot.words());
            self.problems.push(Problem { advisory, ..problem });
        }
    }

    fn write(&mut self, place: &str, slot: &Slot<'_>, value: &Value) -> Written {
        match slot.shape {
            Shape::Scalar(scalar) => scalar::write(scalar, &slot.limits, self.ranges, value, &mut self.out)?,
            Shape::Python(_) => {
                let text = value.as_str().filter(|text| slot.limits.allow_text(text));
                self.out.text(text.ok_or(false)?);
            }
            Shape::List(element, len) => self.list(place, &slot.inner(element), value, len)?,
            Shape::Object(fields) => {
                let given = value.as_object().ok_or(false)?;
                self.out.raw("{");
                self.object((place, slot.limits.advised), fields, given, "");
                self.out.raw("}");
            }
            Shape::Tuple { fields, .. } => {
                self.out.raw("[");
                match value {
                    Value::Object(given) => self.object((place, slot.limits.advised), fields, given, ""),
                    Value::Array(elements) => self.elements((place, slot.limits.advised), fields, elements)?,
                    _ => return Err(false),
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
                let (tag, rest) = value.as_array().and_then(|elements| elements.split_first()).ok_or(false)?;
                let variant = variant(choice, tag).ok_or(false)?;
                self.out.raw("[");
                self.out.int(variant.wire);
                self.elements((place, slot.limits.advised), &variant.fields, rest)?;
                self.out.raw("]");
            }
        }
        Ok(())
    }

    /// Writes the elements of a struct that is an array on the wire.
    fn elements(&mut self, outer: Outer<'_>, fields: &[Field], elements: &[Value]) -> Written {
        let required = fields.iter().filter(|field| !field.optional).count();
        if elements.len() < required || elements.len() > fields.len() {
            return Err(false);
        }
        let values: Vec<_> = elements.iter().map(|value| Some(value).filter(|value| !value.is_null())).collect();
        self.members(outer, fields, &values);
        Ok(())
    }

    fn list(&mut self, outer: &str, slot: &Slot<'_>, value: &Value, len: Option<usize>) -> Written {
        let items = value.as_array().filter(|items| len.is_none_or(|len| items.len() == len)).ok_or(false)?;
        self.out.raw("[");
        for (index, item) in items.iter().enumerate() {
            self.out.comma();
            self.value(&element(outer, index), slot, item);
        }
        self.out.raw("]");
        Ok(())
    }

    /// The value of an enum, if it may be sent.
    fn allowed<'v, T>(&self, listed: Option<&'v EnumValue<T>>) -> Result<&'v EnumValue<T>, bool> {
        let allowed = listed.filter(|listed| !listed.advisory || self.ranges == AdvisoryRanges::Ignored);
        allowed.ok_or(listed.is_some())
    }
}

//! Types and limits of places in messages.

use std::fmt;

use jaka_proto::check::{Advised, FieldLimits};
use jaka_spec::{EnumValue, Field, Shape, Spec, Type, Variant, words};

use super::scalar;

/// Type and limits of a place in a message.
#[derive(Clone, Copy)]
pub(crate) struct Slot<'a> {
    pub(crate) spec: &'a Spec,
    /// Type; `None` for a message as a whole.
    ty: Option<&'a Type>,
    pub(crate) shape: Shape<'a>,
    pub(crate) limits: FieldLimits<'a>,
}

impl<'a> Slot<'a> {
    /// Creates the place of a value of the type that is in no message.
    pub(crate) fn of_type(spec: &'a Spec, ty: &'a Type) -> Self {
        Self { spec, ty: Some(ty), shape: spec.shape(ty), limits: FieldLimits::NONE }.with_unit(ty)
    }

    /// Creates the place of a message with these fields.
    pub(crate) fn of_object(spec: &'a Spec, fields: &'a [Field]) -> Self {
        Self { spec, ty: None, shape: Shape::Object(fields), limits: FieldLimits::NONE }
    }

    /// Creates the place of a field.
    pub(crate) fn of(spec: &'a Spec, field: &'a Field) -> Self {
        Self { limits: limits(field), ..Self::of_type(spec, &field.ty) }.with_unit(&field.ty)
    }

    /// Returns the place with this advice on its numbers.
    pub(crate) fn advised(mut self, advised: Advised<'a>) -> Self {
        self.limits.advised = advised;
        self
    }

    /// Returns the place of a value of a type inside this one; limits apply to each number in it.
    pub(crate) fn inner(&self, ty: &'a Type) -> Self {
        Self { ty: Some(ty), shape: self.spec.shape(ty), ..*self }.with_unit(ty)
    }

    /// Returns the place with the unit of its type, if the type is a wrapper with a unit.
    fn with_unit(mut self, ty: &Type) -> Self {
        self.limits.unit = self.spec.unit(ty).unwrap_or(self.limits.unit);
        self
    }

    /// Whether the same JSON value has the same meaning in both places.
    pub(crate) fn means(&self, other: &Slot<'_>) -> bool {
        let is_same = self.ty == other.ty && self.limits.unit == other.limits.unit;
        is_same && self.ty.is_some_and(|ty| self.spec.defines_as(other.spec, ty))
    }

    /// Describes the values allowed here, such as `a number, at least 0 deg/s` or `0 (Absolute) or 1 (Relative)`.
    pub(crate) fn words(&self) -> String {
        let each = |element| self.inner(element).words();
        match self.shape {
            Shape::Scalar(scalar) => scalar::words(scalar, &self.limits),
            Shape::Python(_) => "text with a Python literal".to_owned(),
            Shape::List(element, None) => format!("an array, each {}", each(element)),
            Shape::List(element, Some(len)) => format!("an array of {len}, each {}", each(element)),
            Shape::Object(_) => "an object".to_owned(),
            Shape::Tuple { fields, .. } => {
                let names: Vec<_> = fields.iter().map(|field| field.name.as_str()).collect();
                format!("an array [{}]", names.join(", "))
            }
            Shape::IntEnum(values) => either(listed(values).map(|value| named(value.wire, &value.name))),
            Shape::TextEnum(values) => either(listed(values).map(|value| format!("`{}`", value.wire))),
            Shape::Choice(choice) => format!("an array that begins with {}", variants(&choice.variants)),
        }
    }
}

/// Writes the allowed values, without the spec.
impl fmt::Debug for Slot<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words())
    }
}

/// Returns the limits of a field's numbers and texts.
fn limits(field: &Field) -> FieldLimits<'_> {
    let jaka_spec::Range { min, max, advisory } = field.range;
    let unit = field.unit.as_deref().unwrap_or_default();
    FieldLimits { min, max, advisory, ascii: field.ascii, unit, ..FieldLimits::NONE }
}

fn listed<T>(values: &[EnumValue<T>]) -> impl Iterator<Item = &EnumValue<T>> {
    values.iter().filter(|value| !value.advisory)
}

/// Returns the tags of variants in words, such as `0 (Rtu) or 1 (Tcp)`.
pub(crate) fn variants(variants: &[Variant]) -> String {
    either(variants.iter().map(|variant| named(variant.wire, &variant.name)))
}

fn named(wire: i64, name: &str) -> String {
    format!("{wire} ({name})")
}

fn either(items: impl Iterator<Item = String>) -> String {
    words::list(&items.collect::<Vec<_>>(), "or")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// jaka-proto has its own words at run time, since it does not depend on jaka-spec there.
    #[test]
    fn pages_and_errors_have_the_same_words_for_a_range() {
        let spec = jaka_spec::builtin().expect("the spec is correct");
        let requests = spec.commands().flat_map(|command| command.request.fields());
        let ranges = requests.filter_map(|field| Some((words::range(field.range)?, limits(field))));
        let mut compared = 0;
        for (on_pages, limits) in ranges {
            let in_errors = FieldLimits { unit: "", advised: Advised::NONE, ..limits }.to_string();
            assert_eq!(in_errors, on_pages);
            compared += 1;
        }
        assert!(compared > 20, "{compared}");
    }
}

//! What a value may be.

use crate::{EnumValue, Field, Range, Spec, Type, TypeKind, Variant};

/// Whether ranges and enum values are enforced that newer firmware has widened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AdvisoryRanges {
    /// They are enforced like all others.
    #[default]
    Enforced,
    /// They are left to the controller.
    Ignored,
}

/// Where a value stands in a message, and what may stand there.
pub(super) struct Slot<'a> {
    pub(super) place: &'a str,
    pub(super) ty: &'a Type,
    pub(super) limits: Limits<'a>,
}

impl<'a> Slot<'a> {
    pub(super) fn of(place: &'a str, field: &'a Field) -> Self {
        Self { place, ty: &field.ty, limits: Limits::of(field) }
    }

    /// The same place, of a type that stands inside the slot's; limits go down to each number.
    pub(super) fn inner<'b>(&'b self, place: &'b str, ty: &'b Type) -> Slot<'b> {
        Slot { place, ty, limits: self.limits }
    }

    /// The value inside a wrapper, which has a unit of its own.
    pub(super) fn unwrapped<'b>(&'b self, ty: &'b Type, unit: Option<&'b str>) -> Slot<'b> {
        Slot { place: self.place, ty, limits: Limits { unit, ..self.limits } }
    }

    /// What may stand here, such as `a number, at least 0 deg/s` or `0 (Absolute) or 1 (Relative)`.
    pub(super) fn words(&self, spec: &Spec) -> String {
        match self.ty {
            Type::Bool { off, on } => format!("{off} or {on}"),
            Type::Int => self.limits.number("a whole number"),
            Type::Float => self.limits.number("a number"),
            Type::Text if self.limits.ascii => "text of printable ASCII".to_owned(),
            Type::Text => "text".to_owned(),
            Type::Json => "any JSON".to_owned(),
            Type::Python(_) => "text with a Python literal".to_owned(),
            Type::List(element) => format!("an array, each {}", self.inner(self.place, element).words(spec)),
            Type::Array(element, len) => {
                format!("an array of {len}, each {}", self.inner(self.place, element).words(spec))
            }
            Type::Named(name) => self.named_words(spec, name),
        }
    }

    fn named_words(&self, spec: &Spec, name: &str) -> String {
        match spec.type_def(name).map(|def| &def.kind) {
            Some(TypeKind::Object(_)) => "an object".to_owned(),
            Some(TypeKind::Array { fields, .. }) => format!("an array [{}]", names(fields).join(", ")),
            Some(TypeKind::IntEnum(values)) => either(listed(values).map(|value| named(value.wire, &value.name))),
            Some(TypeKind::TextEnum(values)) => either(listed(values).map(|value| format!("`{}`", value.wire))),
            Some(TypeKind::Choice(choice)) => format!("an array that begins with {}", variants(&choice.variants)),
            Some(TypeKind::Wrapper(ty, unit)) => self.unwrapped(ty, unit.as_deref()).words(spec),
            None => "any JSON".to_owned(),
        }
    }
}

/// What the numbers and texts of a field may be.
#[derive(Clone, Copy, Default)]
pub(super) struct Limits<'s> {
    pub(super) range: Range,
    pub(super) unit: Option<&'s str>,
    pub(super) ascii: bool,
}

impl<'s> Limits<'s> {
    pub(super) fn of(field: &'s Field) -> Self {
        Self { range: field.range, unit: field.unit.as_deref(), ascii: field.ascii }
    }

    /// True for a number within the range.
    pub(super) fn allow(&self, number: f64) -> bool {
        self.range.min.is_none_or(|min| number >= min) && self.range.max.is_none_or(|max| number <= max)
    }

    /// True for text that may be sent.
    pub(super) fn allow_text(&self, text: &str) -> bool {
        !self.ascii || text.bytes().all(|b| b == b' ' || b.is_ascii_graphic())
    }

    /// The range in words, such as `0 to 1` or `at least 0 deg/s`.
    pub(super) fn range_words(&self) -> Option<String> {
        let range = match (self.range.min, self.range.max) {
            (Some(min), Some(max)) => format!("{min} to {max}"),
            (Some(min), None) => format!("at least {min}"),
            (None, Some(max)) => format!("at most {max}"),
            (None, None) => return None,
        };
        Some(self.unit.map(|unit| format!("{range} {unit}")).unwrap_or(range))
    }

    fn number(&self, noun: &str) -> String {
        match (self.range_words(), self.unit) {
            (Some(range), _) => format!("{noun}, {range}"),
            (None, Some(unit)) => format!("{noun} (in {unit})"),
            (None, None) => noun.to_owned(),
        }
    }
}

fn names(fields: &[Field]) -> Vec<&str> {
    fields.iter().map(|field| field.name.as_str()).collect()
}

fn listed<T>(values: &[EnumValue<T>]) -> impl Iterator<Item = &EnumValue<T>> {
    values.iter().filter(|value| !value.advisory)
}

/// The tags of variants in words, such as `0 (Rtu) or 1 (Tcp)`.
pub(super) fn variants(variants: &[Variant]) -> String {
    either(variants.iter().map(|variant| named(variant.wire, &variant.name)))
}

fn named(wire: i64, name: &str) -> String {
    format!("{wire} ({name})")
}

fn either(words: impl Iterator<Item = String>) -> String {
    let words: Vec<_> = words.collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => words.concat(),
    }
}

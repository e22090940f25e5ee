//! Where a value stands in a message, and what may stand there.

use jaka_proto::check::Limits;
use jaka_spec::{EnumValue, Field, Shape, Spec, Type, Variant, words};

/// A place in a message, and what may stand there.
#[derive(Clone, Copy)]
pub(crate) struct Slot<'a> {
    pub(crate) spec: &'a Spec,
    /// Its path, such as `pose.x`; empty for the message as a whole.
    pub(crate) place: &'a str,
    pub(crate) shape: Shape<'a>,
    pub(crate) limits: Limits<'a>,
}

impl<'a> Slot<'a> {
    /// A value of the type that stands nowhere.
    pub(crate) fn of_type(spec: &'a Spec, ty: &'a Type) -> Self {
        Self { spec, place: "", shape: Shape::Json, limits: Limits::NONE }.inner("", ty)
    }

    /// The place of a field.
    pub(crate) fn of(spec: &'a Spec, place: &'a str, field: &'a Field) -> Self {
        let outer = Self { spec, place, shape: Shape::Json, limits: limits(field) };
        outer.inner(place, &field.ty)
    }

    /// The place of a value of a type that stands inside this one; limits go down to each number.
    pub(crate) fn inner<'b>(&self, place: &'b str, ty: &'b Type) -> Slot<'b>
    where
        'a: 'b,
    {
        let unit = self.spec.unit(ty).unwrap_or(self.limits.unit);
        Slot { spec: self.spec, place, shape: self.spec.shape(ty), limits: Limits { unit, ..self.limits } }
    }

    /// What may stand here, such as `a number, at least 0 deg/s` or `0 (Absolute) or 1 (Relative)`.
    pub(crate) fn words(&self) -> String {
        let each = |element| self.inner(self.place, element).words();
        match self.shape {
            Shape::Bool { off, on } => format!("{off} or {on}"),
            Shape::Int => self.number("a whole number"),
            Shape::Float => self.number("a number"),
            Shape::Text if self.limits.ascii => "text of printable ASCII".to_owned(),
            Shape::Text => "text".to_owned(),
            Shape::Json => "any JSON".to_owned(),
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

    fn number(&self, noun: &str) -> String {
        match (range(&self.limits), self.limits.unit) {
            (Some(range), _) => format!("{noun}, {range}"),
            (None, "") => noun.to_owned(),
            (None, unit) => format!("{noun} (in {unit})"),
        }
    }
}

/// What the numbers and texts of a field may be.
pub(crate) fn limits(field: &Field) -> Limits<'_> {
    let jaka_spec::Range { min, max, advisory } = field.range;
    let unit = field.unit.as_deref().unwrap_or_default();
    Limits { min, max, advisory, ascii: field.ascii, unit, ..Limits::NONE }
}

/// The range in words, such as `0 to 1` or `at least 0 deg/s`.
pub(crate) fn range(limits: &Limits<'_>) -> Option<String> {
    (limits.min.is_some() || limits.max.is_some()).then(|| limits.to_string())
}

fn listed<T>(values: &[EnumValue<T>]) -> impl Iterator<Item = &EnumValue<T>> {
    values.iter().filter(|value| !value.advisory)
}

/// The tags of variants in words, such as `0 (Rtu) or 1 (Tcp)`.
pub(crate) fn variants(variants: &[Variant]) -> String {
    either(variants.iter().map(|variant| named(variant.wire, &variant.name)))
}

fn named(wire: i64, name: &str) -> String {
    format!("{wire} ({name})")
}

fn either(items: impl Iterator<Item = String>) -> String {
    words::list(&items.collect::<Vec<_>>(), "or")
}

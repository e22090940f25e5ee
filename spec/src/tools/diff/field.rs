//! The fields of requests, replies and types.

use super::Impact;
use super::collect::{Differ, pairs};
use super::command::versions;
use crate::words;
use crate::{Field, Range, Scalar, Type, is_floats};

/// What holds the fields, as far as that decides what their changes mean.
pub(super) struct Holder {
    /// How the fields are called, such as `request field`.
    pub(super) noun: &'static str,
    /// What an optional field that is added means.
    pub(super) grows: Impact,
    /// What another order of the fields means.
    pub(super) order: Impact,
    /// Whether the client checks the fields.
    pub(super) checks: Checks,
}

/// Whether the client checks values against the spec.
#[derive(Clone, Copy)]
pub(super) enum Checks {
    /// Before it sends them.
    Sent,
    /// Never, since they are only received: limits are documentation.
    Received,
}

impl Checks {
    /// A type is checked where requests have it.
    pub(super) fn of_type(d: &Differ<'_>, name: &str) -> Self {
        let is_sent = [d.old, d.new].iter().all(|spec| spec.type_id(name).is_some_and(|id| spec.is_sent(id)));
        if is_sent { Self::Sent } else { Self::Received }
    }

    /// What a change of limits means here, if it means `impact` for what is sent.
    pub(super) fn impact(self, impact: Impact) -> Impact {
        match self {
            Self::Sent => impact,
            Self::Received => Impact::Patch,
        }
    }
}

impl Holder {
    const FIXED: Self = Self { noun: "field", grows: Impact::Major, order: Impact::Patch, checks: Checks::Received };

    /// A variant of a request that is a choice.
    pub(super) const REQUEST_VARIANT: Self = Self { checks: Checks::Sent, ..Self::FIXED };

    /// A variant of a choice inside an array.
    pub(super) const ARRAY_VARIANT: Self = Self { order: Impact::Minor, ..Self::FIXED };

    /// A request that had these fields. Without fields it was a unit struct.
    pub(super) fn request(old: &[Field]) -> Self {
        Self { noun: "request field", checks: Checks::Sent, ..Self::reply(old) }
    }

    /// A reply that had these fields. Without fields it was `()`.
    pub(super) fn reply(old: &[Field]) -> Self {
        let fixed = Self { noun: "reply field", ..Self::FIXED };
        if old.is_empty() { fixed } else { Self { grows: Self::object(old).grows, ..fixed } }
    }

    /// An object that had these fields.
    pub(super) fn object(old: &[Field]) -> Self {
        let all_optional = old.iter().all(|field| field.optional);
        Self { grows: if all_optional { Impact::Minor } else { Impact::Major }, ..Self::FIXED }
    }

    /// An array that had these fields.
    pub(super) fn array(old: &[Field]) -> Self {
        // The conversion from an array of numbers goes by place.
        let order = if is_floats(old) { Impact::Major } else { Impact::Minor };
        Self { order, ..Self::FIXED }
    }
}

/// Compares the fields of `place`.
pub(super) fn fields(d: &mut Differ<'_>, place: &str, holder: &Holder, old: &[Field], new: &[Field]) {
    for pair in pairs(old, new, key) {
        let field = pair.any();
        let inner = format!("{place}, {} `{}`", holder.noun, key(field));
        let added = if field.optional { holder.grows } else { Impact::Major };
        if let Some((old, new)) = d.both(&inner, &pair, added) {
            compare(d, &inner, holder, old, new);
        }
    }
    if common(old, new) != common(new, old) {
        d.note(place, format!("order of the {}s changed", holder.noun), holder.order);
    }
}

/// What a field is matched by.
fn key(field: &Field) -> String {
    if field.wire.is_empty() { field.name.clone() } else { field.wire.clone() }
}

/// The keys of `fields` that `others` have too, in the order of `fields`.
fn common(fields: &[Field], others: &[Field]) -> Vec<String> {
    fields.iter().map(key).filter(|found| others.iter().any(|other| key(other) == *found)).collect()
}

fn compare(d: &mut Differ<'_>, place: &str, holder: &Holder, old: &Field, new: &Field) {
    d.value(place, "name", &old.name, &new.name, Impact::Major);
    field_type(d, place, &old.ty, &new.ty);
    unit(d, place, old.unit.as_ref(), new.unit.as_ref());
    limits(d, place, holder.checks, old, new);
    let optional = ("becomes optional", Impact::Major);
    d.flag(place, (old.optional, new.optional), optional, ("is no longer optional", Impact::Major));
    let or_raw = ("may have another shape, kept as raw JSON", Impact::Major);
    d.flag(place, (old.or_raw, new.or_raw), or_raw, ("has no other shape any more", Impact::Major));
    d.reworded(place, "doc", &old.doc, &new.doc);
    d.reworded(place, "disputed readings", &old.disputed, &new.disputed);
    versions(d, place, &old.versions, &new.versions);
}

/// Compares the types of a field or a wrapper.
pub(super) fn field_type(d: &mut Differ<'_>, place: &str, old: &Type, new: &Type) {
    let (was, is) = (d.old.notation(old), d.new.notation(new));
    if d.same_type(old, new) {
        d.value(place, "form on the wire", &form(was, old), &form(is, new), Impact::Minor);
    } else {
        d.value(place, "type", &was, &is, Impact::Major);
    }
}

/// The notation, with how false and true are written.
fn form(notation: String, ty: &Type) -> String {
    match ty.scalar() {
        Some(Scalar::Bool { off, on }) => format!("{notation} written [{off}, {on}]"),
        _ => notation,
    }
}

/// Compares the units of a field or a wrapper.
pub(super) fn unit(d: &mut Differ<'_>, place: &str, old: Option<&String>, new: Option<&String>) {
    let impact = if old.is_some() && new.is_some() { Impact::Major } else { Impact::Patch };
    d.option(place, "unit", (old, new), impact);
}

fn limits(d: &mut Differ<'_>, place: &str, checks: Checks, old: &Field, new: &Field) {
    let words = |range: Range| {
        let words = words::range(range)?;
        Some(if range.advisory { words + ", advisory" } else { words })
    };
    let impact = if is_narrower(old.range, new.range) { Impact::Major } else { Impact::Minor };
    d.option(place, "range", (words(old.range).as_ref(), words(new.range).as_ref()), checks.impact(impact));
    let ascii = ("takes printable ASCII only", checks.impact(Impact::Major));
    d.flag(place, (old.ascii, new.ascii), ascii, ("takes any text", checks.impact(Impact::Minor)));
}

/// True if something that `old` lets pass is refused by `new`.
fn is_narrower(old: Range, new: Range) -> bool {
    let least = |range: Range| range.min.unwrap_or(f64::NEG_INFINITY);
    let greatest = |range: Range| range.max.unwrap_or(f64::INFINITY);
    let is_limited = new.min.is_some() || new.max.is_some();
    // What is advisory can be switched off.
    let enforced = old.advisory && !new.advisory && is_limited;
    least(new) > least(old) || greatest(new) < greatest(old) || enforced
}

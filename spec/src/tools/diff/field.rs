//! The fields of requests, replies and types.

use super::collect::{Differ, common, key, pairs};
use super::{Impact, made};
use crate::{Advice, Field, Range, Scalar, Spec, Type, is_floats, words};

/// Holder of the fields, as far as it decides the impact of their changes.
pub(super) struct Holder {
    /// Noun for the fields, such as `request field`.
    pub(super) noun: &'static str,
    /// Impact of an added field that is optional.
    pub(super) optional_added: Impact,
    /// Impact of an added field that is always there.
    pub(super) required_added: Impact,
    /// Impact of another order of the fields.
    pub(super) order: Impact,
    /// True if programs make values by constructors and setters.
    pub(super) is_made: bool,
    /// Checks of the fields by the client.
    pub(super) checks: Checks,
}

/// Checks of values against the spec by the client.
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

    /// Impact of a change of limits, which is `impact` for values that are sent.
    pub(super) fn impact(self, impact: Impact) -> Impact {
        match self {
            Self::Sent => impact,
            Self::Received => Impact::Patch,
        }
    }
}

impl Holder {
    /// Values that programs make by a constructor of the required fields.
    const MADE: Self = Self {
        noun: "field",
        optional_added: Impact::Minor,
        required_added: Impact::Major,
        order: Impact::Patch,
        is_made: true,
        checks: Checks::Sent,
    };

    /// Values that programs receive and cannot make.
    const RECEIVED: Self =
        Self { required_added: Impact::Minor, is_made: false, checks: Checks::Received, ..Self::MADE };

    /// A variant of a request that is a choice.
    pub(super) const REQUEST_VARIANT: Self = Self::MADE;

    /// A request.
    pub(super) const REQUEST: Self = Self { noun: "request field", ..Self::MADE };

    /// A reply that had these fields. Without fields it was `()`.
    pub(super) fn reply(old: &[Field]) -> Self {
        let added = if old.is_empty() { Impact::Major } else { Impact::Minor };
        let reply = Self { noun: "reply field", optional_added: added, required_added: added, ..Self::RECEIVED };
        reply.with_default(old)
    }

    /// A type that is written as an object and had these fields.
    pub(super) fn object(d: &Differ<'_>, name: &str, old: &[Field]) -> Self {
        Self::of_type(d, name).with_default(old)
    }

    /// A type that is written as an array and had these fields.
    pub(super) fn array(d: &Differ<'_>, name: &str, old: &[Field]) -> Self {
        let array = Self { order: Impact::Minor, ..Self::of_type(d, name) };
        if is_floats(old) {
            // The conversion from an array of numbers goes by place, and by their count.
            let (optional_added, required_added, order) = (Impact::Major, Impact::Major, Impact::Major);
            return Self { optional_added, required_added, order, is_made: false, ..array };
        }
        array.with_default(old)
    }

    /// A variant of a type that is a choice inside an array.
    pub(super) fn array_variant(d: &Differ<'_>, name: &str) -> Self {
        Self { order: Impact::Minor, ..Self::of_type(d, name) }
    }

    fn of_type(d: &Differ<'_>, name: &str) -> Self {
        let is_made = d.old.type_id(name).is_some_and(|id| d.old.is_sent(id));
        let holder = if is_made { Self::MADE } else { Self::RECEIVED };
        Self { checks: Checks::of_type(d, name), ..holder }
    }

    /// Makes an added field that is always there a major change where all fields are optional, since it removes
    /// `Default`.
    fn with_default(self, old: &[Field]) -> Self {
        let has_default = old.iter().all(|field| field.optional);
        let required_added = if has_default { Impact::Major } else { self.required_added };
        Self { required_added, ..self }
    }
}

/// Compares the fields of `place`.
pub(super) fn fields(d: &mut Differ<'_>, place: &str, holder: &Holder, old: &[Field], new: &[Field]) {
    for pair in pairs(old, new, key) {
        let field = pair.any();
        let inner = format!("{place}, {} `{}`", holder.noun, key(field));
        let added = if field.optional { holder.optional_added } else { holder.required_added };
        if let Some((old, new)) = d.both(&inner, &pair, added) {
            compare(d, &inner, holder, old, new);
        }
    }
    if common(old, new) != common(new, old) {
        let is_noticed = holder.is_made && made::is_reordered(old, new);
        let impact = if is_noticed { Impact::Major } else { holder.order };
        d.note(place, format!("order of the {}s changed", holder.noun), impact);
    }
    if holder.is_made {
        made::compare(d, place, holder.noun, old, new);
    }
}

fn compare(d: &mut Differ<'_>, place: &str, holder: &Holder, old: &Field, new: &Field) {
    d.value(place, "name", &old.name, &new.name, Impact::Major);
    field_type(d, place, &old.ty, &new.ty);
    unit(d, place, old.unit.as_ref(), new.unit.as_ref());
    limits(d, place, holder.checks, old, new);
    let optional = ("becomes optional", Impact::Major);
    d.flag(place, (old.optional, new.optional), optional, ("is no longer optional", Impact::Major));
    let or_raw = ("may have another shape, kept as raw JSON", Impact::Major);
    // What programs only receive has none.
    let (comes, goes) = if holder.is_made { (Impact::Minor, Impact::Major) } else { (Impact::Patch, Impact::Patch) };
    let constructors = ("gets a constructor for each value", comes);
    let none = ("no longer has constructors", goes);
    d.flag(place, (old.constructors, new.constructors), constructors, none);
    d.flag(place, (old.or_raw, new.or_raw), or_raw, ("can no longer have another shape", Impact::Major));
    d.reworded(place, "doc", &old.doc, &new.doc);
    d.reworded(place, "disputed readings", &old.disputed, &new.disputed);
    d.reworded(place, "evidence", &old.evidence, &new.evidence);
    d.versions(place, &old.versions, &new.versions);
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
    let less = if is_advised_less(old, new) { Impact::Major } else { Impact::Minor };
    let (was, is) = (advised(d.old, old), advised(d.new, new));
    d.option(place, "advised range", (was.as_ref(), is.as_ref()), checks.impact(less));
    let ascii = ("takes printable ASCII only", checks.impact(Impact::Major));
    d.flag(place, (old.ascii, new.ascii), ascii, ("takes any text", checks.impact(Impact::Minor)));
}

/// Advised limits of a field without its range, in words.
fn advised(spec: &Spec, field: &Field) -> Option<String> {
    let field = Field { range: Range::default(), ..field.clone() };
    words::advised(spec, &[], &field, |other| other.name.clone())
}

/// True if something that `old` advises is not advised by `new`.
fn is_advised_less(old: &Field, new: &Field) -> bool {
    let key = |row: &Advice| (row.when.clone(), row.unit.clone(), row.per.clone());
    let covers =
        |row: &Advice, was: &Advice| key(row) == key(was) && row.max >= was.max && (was.nonzero || !row.nonzero);
    new.advised.iter().any(|row| !old.advised.iter().any(|was| covers(row, was)))
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

//! Forms of fields and types by firmware.

use super::common::{keyword, versions};
use super::wire::{check_written, field_type, key, written};
use crate::form::overlap;
use crate::item::{Item, Placed};
use crate::model::{Field, Form, FormKind, Type, TypeForm, TypeKind};
use crate::resolve::{Index, Need};
use crate::scalar::Scalar;
use crate::unit::Factors;
use crate::version::Versions;

/// Keys of a field's forms that are not the field's own, each once.
pub(super) fn keys<'s>(item: &Item<'_, 's>, own: &Placed<'s, String>) -> Vec<Placed<'s, String>> {
    let mut keys: Vec<Placed<'s, String>> = Vec::new();
    for form in item.items("form", "form") {
        if !form.is_text("wire") {
            continue;
        }
        let wire = form.required_text("wire");
        if wire.value != own.value && keys.iter().all(|known| known.value != wire.value) {
            keys.push(wire);
        }
    }
    keys
}

/// Forms of a field by firmware, from `[[… .form]]`; `taken` are keys that it may not have.
pub(super) fn forms<'s>(item: &Item<'_, 's>, field: &Field, taken: &[&str], index: &mut Index<'s>) -> Vec<Form> {
    let items = item.items("form", "form");
    if let Some(first) = items.first().filter(|_| field.or_raw || !field.disputed.is_empty()) {
        first.error(first.at, "a field of which sources leave another shape open has no forms");
    }
    let forms: Vec<_> = items.iter().map(|item| form(item, field, taken, index)).collect();
    are_apart(&items, &forms.iter().map(|form| &form.versions).collect::<Vec<_>>());
    forms
}

fn form<'s>(item: &Item<'_, 's>, field: &Field, taken: &[&str], index: &mut Index<'s>) -> Form {
    let wire = if item.has("wire") { key(item, taken).value } else { field.wire.clone() };
    let mut ty = field.ty.clone();
    if item.has("type") {
        ty = field_type(item, index);
    } else {
        written(item, &mut ty);
    }
    let (unit, factors) = unit(item, field.unit.as_ref(), is_floats(&field.ty));
    let form = Form { versions: firmware(item), wire, ty, unit, factors };
    check_written(item, &form.ty, !form.wire.is_empty());
    // A literal is a string: beside it stands an array or an object, which is none.
    let literal = match (&form.ty, &field.ty) {
        (Type::Python(_), Type::Python(_)) => None,
        (Type::Python(inner), _) | (_, Type::Python(inner)) => Some(&**inner),
        _ => None,
    };
    if let Some(inner) = literal {
        index.needs(item, item.at, Need::Parts(inner.clone()));
    }
    if field.wire.is_empty() && (form.wire != field.wire || form.ty != field.ty) {
        item.error(item.at, "an element of an array has forms that differ in the unit alone");
    }
    if !same_type(&form.ty, &field.ty) {
        item.error(item.at, "a form has the field's type, with other words for false and true, or in python(…)");
    } else if (&form.wire, &form.ty, &form.unit) == (&field.wire, &field.ty, &field.unit) {
        item.error(item.at, "a form differs from the field by `wire`, `type`, `written` or `unit`");
    }
    item.finish();
    form
}

/// Forms of a type by firmware, from `[[type.form]]`.
pub(crate) fn type_forms(item: &Item<'_, '_>, kind: &TypeKind) -> Vec<TypeForm> {
    let items = item.items("form", "form");
    let forms: Vec<_> = items.iter().map(|item| type_form(item, kind)).collect();
    are_apart(&items, &forms.iter().map(|form| &form.versions).collect::<Vec<_>>());
    forms
}

fn type_form(item: &Item<'_, '_>, kind: &TypeKind) -> TypeForm {
    let form = match kind {
        TypeKind::Array { fields, .. } => {
            keyword(item, "kind", &[("object", ())]);
            FormKind::Object(object_keys(item, fields))
        }
        TypeKind::Object(_) => {
            keyword(item, "kind", &[("array", ())]);
            FormKind::Array
        }
        TypeKind::Wrapper(ty, own) => {
            item.require("unit");
            let (unit, factors) = unit(item, own.as_ref(), is_floats(ty));
            FormKind::Unit { unit: unit.unwrap_or_default(), factors }
        }
        TypeKind::IntEnum(_) | TypeKind::TextEnum(_) | TypeKind::Choice(_) => {
            item.error(item.at, "`form` is for an object, an array or a wrapper");
            FormKind::Array
        }
    };
    let form = TypeForm { versions: firmware(item), kind: form };
    item.finish();
    form
}

/// Rule of the keys of an array that is an object in some firmware.
pub(crate) const KEYS: &str = "`keys` has a key for each element";

/// Keys of an array that is an object in some firmware: `keys`, or else the names of its elements.
fn object_keys(item: &Item<'_, '_>, fields: &[Field]) -> Vec<String> {
    let keys = item.texts("keys");
    if keys.is_empty() {
        return fields.iter().map(|field| field.name.clone()).collect();
    }
    let are_apart = keys.iter().enumerate().all(|(at, key)| keys[..at].iter().all(|other| other.value != key.value));
    if keys.len() != fields.len() || !are_apart || keys.iter().any(|key| key.value.is_empty()) {
        item.error(item.at, KEYS);
    }
    keys.into_iter().map(|key| key.value).collect()
}

/// Unit of a form, and the factors between its numbers and those in the unit of the field or the type.
fn unit(item: &Item<'_, '_>, own: Option<&String>, is_floats: bool) -> (Option<String>, Factors) {
    let Some(unit) = item.text("unit") else { return (own.cloned(), Factors::ONE) };
    let factors = own.and_then(|own| Factors::of(&unit.value, own));
    match (own, factors) {
        (_, Some(_)) if !is_floats => item.error(unit.at, "forms in another unit are for floats"),
        (_, Some(_)) => {}
        (Some(own), None) => {
            item.error(unit.at, &format!("no factor is known from `{}` to `{own}`", unit.value));
        }
        (None, None) => item.error(unit.at, "a form in another unit is for numbers whose unit is stated"),
    }
    (Some(unit.value), factors.unwrap_or(Factors::ONE))
}

/// Firmware of a form, which has a first or a last one.
fn firmware(item: &Item<'_, '_>) -> Versions {
    let versions = versions(item, &Versions::default());
    if versions == Versions::default() && !item.has("since") && !item.has("until") {
        item.error(item.at, "a form is that of some firmware: give `since`, `until` or both");
    }
    versions
}

/// Reports forms that the same firmware has.
fn are_apart(items: &[Item<'_, '_>], versions: &[&Versions]) {
    for (at, item) in items.iter().enumerate() {
        if versions[..at].iter().any(|other| overlap(versions[at], other)) {
            item.error(item.at, "some firmware has this form and one before it");
        }
    }
}

/// True for floats, and for arrays of them.
fn is_floats(ty: &Type) -> bool {
    match ty {
        Type::List(element) | Type::Array(element, _) => is_floats(element),
        other => *other == Type::Scalar(Scalar::Float),
    }
}

/// True for types that are the same in Rust, however they are written.
fn same_type(ty: &Type, other: &Type) -> bool {
    match (ty, other) {
        (Type::Python(inner), other) | (other, Type::Python(inner)) => same_type(inner, other),
        (Type::Scalar(Scalar::Bool { .. }), Type::Scalar(Scalar::Bool { .. })) => true,
        (Type::List(element), Type::List(other)) => same_type(element, other),
        (Type::Array(element, len), Type::Array(other, other_len)) => len == other_len && same_type(element, other),
        (ty, other) => ty == other,
    }
}

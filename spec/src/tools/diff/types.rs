//! Named types, and the variants of choices.

use std::fmt::Display;

use super::Impact;
use super::collect::{Differ, pairs};
use super::field::{Checks, Holder, field_type, fields, unit};
use crate::{EnumValue, Role, Spec, Type, TypeDef, TypeKind, Variant};

/// Compares one type of both specs.
pub(super) fn compare(d: &mut Differ<'_>, place: &str, old: &TypeDef, new: &TypeDef) {
    d.reworded(place, "doc", &old.doc, &new.doc);
    let checks = Checks::of_type(d, &new.name);
    match (&old.kind, &new.kind) {
        (TypeKind::Object(was), TypeKind::Object(is)) => {
            fields(d, place, &Holder::object(d, &new.name, was), was, is);
        }
        (TypeKind::Array { fields: was, exact: was_exact }, TypeKind::Array { fields: is, exact: is_exact }) => {
            let exact = ("an array with further elements becomes an error", Impact::Major);
            d.flag(place, (*was_exact, *is_exact), exact, ("an array may have further elements", Impact::Minor));
            fields(d, place, &Holder::array(d, &new.name, was), was, is);
        }
        (TypeKind::IntEnum(was), TypeKind::IntEnum(is)) => values(d, place, checks, was, is),
        (TypeKind::TextEnum(was), TypeKind::TextEnum(is)) => values(d, place, checks, was, is),
        (TypeKind::Choice(was), TypeKind::Choice(is)) => {
            variants(d, place, &Holder::array_variant(d, &new.name), &was.variants, &is.variants);
        }
        (TypeKind::Wrapper(was, was_unit), TypeKind::Wrapper(is, is_unit)) => {
            field_type(d, place, was, is);
            unit(d, place, was_unit.as_ref(), is_unit.as_ref());
        }
        (was, is) => return d.value(place, "kind", &kind(was), &kind(is), Impact::Major),
    }
    let is_copy = |spec: &Spec| spec.type_id(&new.name).is_some_and(|id| spec.is_copy(&Type::Named(id)));
    d.copies(place, (is_copy(d.old), is_copy(d.new)));
}

fn kind(kind: &TypeKind) -> &'static str {
    match kind {
        TypeKind::Object(_) => "object",
        TypeKind::Array { .. } => "array",
        TypeKind::IntEnum(_) => "enum of integers",
        TypeKind::TextEnum(_) => "enum of strings",
        TypeKind::Choice(_) => "choice",
        TypeKind::Wrapper(..) => "wrapper",
    }
}

fn values<T: PartialEq + Clone + Display>(
    d: &mut Differ<'_>,
    place: &str,
    checks: Checks,
    old: &[EnumValue<T>],
    new: &[EnumValue<T>],
) {
    for pair in pairs(old, new, |value| value.wire.clone()) {
        let place = format!("{place}, value `{}`", pair.any().wire);
        let Some((old, new)) = d.both(&place, &pair, Impact::Minor) else {
            continue;
        };
        d.value(&place, "name", &old.name, &new.name, Impact::Major);
        d.reworded(&place, "doc", &old.doc, &new.doc);
        d.versions(&place, &old.versions, &new.versions);
        let newer = ("only newer firmware takes it", checks.impact(Impact::Major));
        let every = ("every firmware takes it", checks.impact(Impact::Minor));
        d.flag(&place, (old.advisory, new.advisory), newer, every);
    }
}

/// Compares the variants of a choice, all of which hold their fields in the same way.
pub(super) fn variants(d: &mut Differ<'_>, place: &str, holder: &Holder, old: &[Variant], new: &[Variant]) {
    for pair in pairs(old, new, |variant| variant.wire) {
        let place = format!("{place}, variant `{}`", pair.any().wire);
        if let Some((old, new)) = d.both(&place, &pair, Impact::Minor) {
            d.value(&place, "name", &old.name, &new.name, Impact::Major);
            let role = |variant: &Variant| variant.role.map(Role::word);
            d.option(&place, "role", (role(old).as_ref(), role(new).as_ref()), Impact::Minor);
            d.reworded(&place, "doc", &old.doc, &new.doc);
            fields(d, &place, holder, &old.fields, &new.fields);
        }
    }
}

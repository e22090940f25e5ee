//! Functions by which programs make values: constructors of the required fields, setters of the optional ones, and the
//! client's methods. The generator is `jaka-proto-derive`.

use super::Impact;
use super::collect::{Differ, common, key};
use crate::names::to_snake;
use crate::{Field, Spec, TypeKind};

/// True if the constructors take the fields in another order.
pub(super) fn is_reordered(old: &[Field], new: &[Field]) -> bool {
    let required = |fields: &[Field]| fields.iter().filter(|field| !field.optional).cloned().collect::<Vec<_>>();
    let (old, new) = (required(old), required(new));
    common(&old, &new) != common(&new, &old)
}

/// Compares how constructors and setters take fields of `place` that are added, or written in another form.
pub(super) fn compare(d: &mut Differ<'_>, place: &str, noun: &str, old: &[Field], new: &[Field]) {
    let constructors = constructors(d.old, old);
    let is_constant = old.iter().all(|field| field.optional || !d.old.is_converted(field));
    for field in new {
        let place = format!("{place}, {noun} `{}`", key(field));
        let is_setter = |fields: &[Field]| fields.iter().any(|other| other.optional && other.name == field.name);
        if constructors.contains(&field.name) && is_setter(new) && !is_setter(old) {
            d.note(&place, format!("its setter takes the name of the constructor `{}`", field.name), Impact::Major);
        }
        let Some(known) = old.iter().find(|known| key(known) == key(field)) else { continue };
        // Where a named type converts no more, or begins to, its own changes say so.
        let is_written_otherwise = d.old.notation(&known.ty) != d.new.notation(&field.ty);
        if known.or_raw == field.or_raw && d.same_type(&known.ty, &field.ty) && is_written_otherwise {
            match (d.old.is_converted(known), d.new.is_converted(field)) {
                (true, false) => d.note(&place, "functions take nothing that converts into it", Impact::Major),
                (false, true) if is_constant && !known.optional => {
                    d.note(&place, "constructors are no longer `const`", Impact::Major);
                }
                _ => {}
            }
        }
    }
}

/// Compares the arguments of a command's method, with equal required fields.
pub(super) fn method(d: &mut Differ<'_>, place: &str, old: &[Field], new: &[Field]) {
    let (Some(old), Some(new)) = (only_required(old), only_required(new)) else { return };
    if key(old) == key(new) && old.or_raw == new.or_raw && d.same_type(&old.ty, &new.ty) {
        let request = ("the method takes the request", Impact::Major);
        d.flag(place, (!old.is_argument(), !new.is_argument()), request, ("the method takes the field", Impact::Major));
    }
}

/// The required field, if there is one alone.
fn only_required(fields: &[Field]) -> Option<&Field> {
    let mut required = fields.iter().filter(|field| !field.optional);
    required.next().filter(|_| required.next().is_none())
}

/// Names of the constructors for the values of enums that select a kind.
fn constructors(spec: &Spec, fields: &[Field]) -> Vec<String> {
    let selecting = fields.iter().filter(|field| field.constructors);
    let kinds = selecting.filter_map(|field| field.ty.named().map(|id| &spec[id].kind));
    let names = kinds.flat_map(|kind| match kind {
        TypeKind::IntEnum(values) => values.iter().map(|value| to_snake(&value.name)).collect(),
        TypeKind::TextEnum(values) => values.iter().map(|value| to_snake(&value.name)).collect(),
        TypeKind::Object(_) | TypeKind::Array { .. } | TypeKind::Choice(_) | TypeKind::Wrapper(..) => Vec::new(),
    });
    names.collect()
}

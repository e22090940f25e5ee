//! Forms of fields and types by firmware.

use std::collections::BTreeMap;

use crate::model::{Field, FormKind, TypeDef, TypeKind};
use crate::range::Range;
use crate::version::Versions;

/// Gives a field the form of a firmware; `is_among` says of which versions the firmware's is one.
pub(crate) fn settle(field: &mut Field, is_among: &impl Fn(&Versions) -> bool) {
    (field.range, field.advised) = (Range::default(), Vec::new());
    let forms = std::mem::take(&mut field.forms);
    let Some(form) = forms.into_iter().find(|form| is_among(&form.versions)) else { return };
    (field.wire, field.ty, field.unit) = (form.wire, form.ty, form.unit);
}

/// Gives a type the form of a firmware.
pub(crate) fn settle_type(def: &mut TypeDef, is_among: &impl Fn(&Versions) -> bool) {
    let forms = std::mem::take(&mut def.forms);
    let Some(form) = forms.into_iter().find(|form| is_among(&form.versions)) else { return };
    let mut fields: Vec<_> = def.kind.fields().cloned().collect();
    def.kind = match (form.kind, &def.kind) {
        (FormKind::Object(keys), _) => {
            fields.iter_mut().zip(keys).for_each(|(field, key)| field.wire = key);
            TypeKind::Object(fields)
        }
        (FormKind::Array, _) => {
            for field in &mut fields {
                field.wire.clear();
            }
            TypeKind::Array { fields, exact: false }
        }
        (FormKind::Unit { unit, .. }, TypeKind::Wrapper(ty, _)) => TypeKind::Wrapper(ty.clone(), Some(unit)),
        (FormKind::Unit { .. }, other) => other.clone(),
    };
}

/// Problem of a type's forms, once all of its fields are known.
pub(crate) fn problem(def: &TypeDef) -> Option<&'static str> {
    match &def.kind {
        TypeKind::Array { fields, .. } => array_problem(def, fields),
        TypeKind::Object(fields) if !def.forms.is_empty() => object_problem(fields),
        _ => None,
    }
}

/// Problem of an array that is an object in some firmware.
fn array_problem(def: &TypeDef, fields: &[Field]) -> Option<&'static str> {
    let keys = def.forms.iter().filter_map(|form| match &form.kind {
        FormKind::Object(keys) => Some(keys),
        FormKind::Array | FormKind::Unit { .. } => None,
    });
    let keys: Vec<_> = keys.collect();
    let mut places = BTreeMap::new();
    for (at, key) in keys.iter().flat_map(|keys| keys.iter().enumerate()) {
        if *places.entry(key).or_insert(at) != at {
            return Some("a key of its forms is that of one element in one form, and of another in another");
        }
    }
    if keys.iter().any(|keys| keys.len() != fields.len()) {
        return Some("its form as an object has a key for each element");
    }
    let differ = keys.windows(2).any(|pair| pair[0] != pair[1]);
    let have_forms = fields.iter().any(|field| !field.forms.is_empty());
    (differ && have_forms).then_some("elements with forms have one key in all forms of their type")
}

/// Problem of an object that is an array in some firmware.
fn object_problem(fields: &[Field]) -> Option<&'static str> {
    if fields.iter().any(|field| field.ty.needs_key() || !field.forms.is_empty()) {
        return Some("the fields of an object that is an array in some firmware are read without their keys");
    }
    let is_in_order = fields.windows(2).all(|pair| !pair[0].optional || pair[1].optional);
    (!is_in_order)
        .then_some("a field after an optional one is optional too, since the object is an array in some firmware")
}

/// True for versions that have something in common.
pub(crate) fn overlap(some: &Versions, others: &Versions) -> bool {
    let is_void = |since: &Versions, until: &Versions| {
        Versions { since: since.since.clone(), until: until.until.clone() }.is_void()
    };
    !is_void(some, others) && !is_void(others, some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::version::Version;

    #[test]
    fn ranges_of_versions_overlap_where_a_version_has_both() {
        let range = |since: &str, until: &str| Versions { since: Version::read(since), until: Version::read(until) };
        assert!(overlap(&range("1.5", "1.6"), &range("1.6.5", "")));
        assert!(overlap(&range("", ""), &range("1.6", "")));
        assert!(!overlap(&range("", "1.6"), &range("1.7", "")));
    }
}

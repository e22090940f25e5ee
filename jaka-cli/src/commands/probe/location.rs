//! The place of a departure in the spec.

use jaka_spec::{Field, Shape, Spec, Type};

/// The part of the spec that a pack would change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Location {
    /// A command's `cmdName` or a type's name.
    pub(super) target: String,
    /// The key of a pack that names fields there: `reply` or `field`.
    pub(super) part: &'static str,
    /// The field's key, or its name where it is an element of an array.
    pub(super) key: String,
    /// True if the spec has the field.
    pub(super) is_known: bool,
}

/// Follows a departure's path from the fields at its beginning; `None` if it ends where a pack can change nothing.
pub(super) fn find(spec: &Spec, target: &str, part: &'static str, fields: &[Field], path: &str) -> Option<Location> {
    let location =
        |key: &str, is_known| Some(Location { target: target.to_owned(), part, key: key.to_owned(), is_known });
    let steps = fields.iter().filter_map(|field| Some((field, rest(path, key(field))?)));
    // Where one key begins with another, the longer one matches.
    let Some((field, rest)) = steps.min_by_key(|(_, rest)| rest.len()) else { return location(path, false) };
    let Some(inner) = inside(spec, &field.ty, rest) else { return location(key(field), true) };
    find(spec, inner.0, "field", inner.1, inner.2)
}

fn key(field: &Field) -> &str {
    if field.wire.is_empty() { &field.name } else { &field.wire }
}

/// What follows a key in a path, if the path begins with the key.
fn rest<'p>(path: &'p str, key: &str) -> Option<&'p str> {
    path.strip_prefix(key).filter(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The type with fields into which a path continues, its fields, and the rest of the path.
fn inside<'s, 'p>(spec: &'s Spec, ty: &'s Type, path: &'p str) -> Option<(&'s str, &'s [Field], &'p str)> {
    let ty = spec.unwrapped(ty);
    match spec.shape(ty) {
        Shape::List(element, _) => inside(spec, element, path.strip_prefix('[')?.split_once(']')?.1),
        Shape::Object(fields) | Shape::Tuple { fields, .. } => {
            Some((&spec[ty.named()?].name, fields, path.strip_prefix('.')?))
        }
        Shape::Scalar(_) | Shape::Python(_) | Shape::IntEnum(_) | Shape::TextEnum(_) | Shape::Choice(_) => None,
    }
}

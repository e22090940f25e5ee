//! Keys of fields, and their types as they are written.

use crate::item::{Item, Placed};
use crate::model::Type;
use crate::resolve::{Index, Need};
use crate::scalar::Scalar;
use crate::type_text;

pub(super) fn key<'s>(item: &Item<'_, 's>, taken: &[&str]) -> Placed<'s, String> {
    let wire = item.required_text("wire");
    if taken.contains(&wire.value.as_str()) {
        item.error(wire.at, &format!("the key `{}` is that of the tag, or of what each message has", wire.value));
    }
    wire
}

pub(super) fn field_type<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Type {
    let text = item.required_text("type");
    let mut ty = match type_text::parse(&text.value, &mut |name| index.type_id(name)) {
        Ok(ty) => ty,
        Err(message) => {
            if !text.value.is_empty() {
                item.error(text.at, &message);
            }
            return Type::Scalar(Scalar::Json);
        }
    };
    written(item, &mut ty);
    index.needs(item, text.at, Need::Type(ty.clone()));
    ty
}

/// Takes from the table how a truth value is written.
pub(super) fn written(item: &Item<'_, '_>, ty: &mut Type) {
    let Some(written) = item.json_scalars("written") else { return };
    match (scalar_mut(ty), written.value.as_slice()) {
        (Some(Scalar::Bool { off, on }), [no, yes]) if are_told_apart(no, yes) => {
            no.clone_into(off);
            yes.clone_into(on);
        }
        _ => item.error(
            written.at,
            "`written` gives a bool's two forms, which are read in any case: how false is written, then true",
        ),
    }
}

/// True for two forms of which a reader can say which it has before it.
fn are_told_apart(no: &str, yes: &str) -> bool {
    let [no, yes] = [no, yes].map(|form| form.trim_matches('"').to_ascii_lowercase());
    let is_readable = |form: &str| form.trim() == form && !form.contains(char::is_control);
    let is_same_number = no.parse::<f64>().is_ok_and(|no| yes.parse() == Ok(no));
    is_readable(&no) && is_readable(&yes) && no != yes && !is_same_number && no != "true" && yes != "false"
}

fn scalar_mut(ty: &mut Type) -> Option<&mut Scalar> {
    match ty {
        Type::List(inner) | Type::Array(inner, _) | Type::Python(inner) => scalar_mut(inner),
        Type::Scalar(scalar) => Some(scalar),
        Type::Named(_) => None,
    }
}

pub(super) const NEEDS_KEY: &str =
    "words for false and true, and python(…), are read only as the whole of a field that has a key and no `or_raw`";

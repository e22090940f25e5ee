//! Samples of a key in the received messages, and their common type.

use jaka_dynamic::notation;
use jaka_spec::{Command, Spec, Type, TypeKind};
use serde_json::Value;

/// Greatest length of an array of fixed length.
const MOST: usize = 64;

/// Returns the values at a path, such as `extio.setup[0].name`, in all messages. An index means each element of its
/// array.
pub(super) fn at<'v>(messages: &'v [Value], path: &str) -> Vec<&'v Value> {
    messages.iter().flat_map(|message| inside(message, path)).filter(|value| !value.is_null()).collect()
}

fn inside<'v>(value: &'v Value, path: &str) -> Vec<&'v Value> {
    if path.is_empty() {
        return vec![value];
    }
    if let Some((_, rest)) = path.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        return value.as_array().into_iter().flatten().flat_map(|element| inside(element, rest)).collect();
    }
    let path = path.strip_prefix('.').unwrap_or(path);
    let members = value.as_object().into_iter().flatten();
    let steps = members.filter_map(|(key, member)| Some((member, super::rest(path, key)?)));
    // If one key is a prefix of another, the longer one matches.
    steps.min_by_key(|(_, rest)| rest.len()).map(|(member, rest)| inside(member, rest)).unwrap_or_default()
}

/// Returns the common type of all samples, in the spec's notation; `None` without samples.
///
/// An array has a fixed length if all samples have it, and there are at least two or the spec has such an array.
pub(super) fn ty(samples: &[&Value], known: &[(String, usize)]) -> Option<String> {
    let arrays: Option<Vec<_>> = samples.iter().map(|sample| sample.as_array()).collect();
    let Some(arrays) = arrays else { return scalar(samples) };
    let (first, others) = arrays.split_first()?;
    let elements: Vec<_> = arrays.iter().copied().flatten().collect();
    // Elements may be whole numbers by chance.
    let element = match ty(&elements, known).unwrap_or_else(|| "json".to_owned()) {
        element if element == "int" => "float".to_owned(),
        element if element == "json" => return Some(element),
        element => element,
    };
    let len = first.len();
    let is_fixed = (1..=MOST).contains(&len) && others.iter().all(|other| other.len() == len);
    let is_certain = !others.is_empty() || known.iter().any(|(ty, known)| *ty == element && *known == len);
    Some(if is_fixed && is_certain { format!("{element}[{len}]") } else { format!("{element}[]") })
}

fn scalar(samples: &[&Value]) -> Option<String> {
    let (first, others) = samples.split_first()?;
    let mut ty = notation(first);
    for other in others.iter().map(|other| notation(other)) {
        ty = match [&*ty, &*other] {
            [one, same] if one == same => ty,
            ["int", "float"] | ["float", "int"] => "float".to_owned(),
            _ => return Some("json".to_owned()),
        };
    }
    Some(ty)
}

/// Returns the arrays of fixed length in a spec: the type of their elements, and their length.
pub(super) fn fixed(spec: &Spec) -> Vec<(String, usize)> {
    let of_commands = spec.commands().flat_map(Command::fields).map(|field| &field.ty);
    let of_types = spec.types().flat_map(|(_, def)| match &def.kind {
        TypeKind::Object(fields) | TypeKind::Array { fields, .. } => fields.iter().map(|field| &field.ty).collect(),
        TypeKind::Wrapper(ty, _) => vec![ty],
        TypeKind::Choice(_) | TypeKind::IntEnum(_) | TypeKind::TextEnum(_) => Vec::new(),
    });
    of_commands.chain(of_types).filter_map(array).collect()
}

fn array(ty: &Type) -> Option<(String, usize)> {
    let Type::Array(element, len) = ty else { return None };
    let Type::Scalar(scalar) = &**element else { return None };
    Some((scalar.name().to_owned(), *len))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn of(samples: &Value) -> String {
        let samples: Vec<_> = samples.as_array().expect("a list of samples").iter().collect();
        ty(&samples, &[("float".to_owned(), 6)]).unwrap_or_default()
    }

    #[test]
    fn a_length_is_fixed_where_two_samples_or_the_spec_have_it() {
        assert_eq!(of(&json!([[1, 2, 3]])), "float[]");
        assert_eq!(of(&json!([[1, 2, 3], [4, 5.5, 6]])), "float[3]");
        assert_eq!(of(&json!([[1, 2, 3], [4, 5]])), "float[]");
        assert_eq!(of(&json!([[1, 2, 3, 4, 5, 6]])), "float[6]");
        assert_eq!(of(&json!([["1", "2", "3", "4", "5", "6"]])), "text[]");
        assert_eq!(of(&json!([[[1, 2], [3, 4], [5, 6]]])), "float[2][]");
        assert_eq!(of(&json!([[[1, 2], [3]]])), "float[][]");
        assert_eq!(of(&json!([[true], [false]])), "bool[1]");
    }

    #[test]
    fn samples_of_several_kinds_have_a_type_that_takes_all() {
        assert_eq!(of(&json!([1, 2])), "int");
        assert_eq!(of(&json!([1, 2.5])), "float");
        assert_eq!(of(&json!([1, "2"])), "json");
        assert_eq!(of(&json!([[1], 2])), "json");
        assert_eq!(of(&json!([[1, "2"], [3, "4"]])), "json");
        assert_eq!(of(&json!([[], []])), "json");
        assert_eq!(of(&json!([])), "");
    }

    #[test]
    fn a_path_leads_to_each_element() {
        let messages = [json!({"a": [{"b c": 1}, {"b c": 2}], "a.d": 3}), json!({"a": [{"b c": null}]})];
        assert_eq!(at(&messages, "a[0].b c"), [&json!(1), &json!(2)]);
        assert_eq!(at(&messages, "a.d"), [&json!(3)]);
        assert!(at(&messages, "e").is_empty());
    }
}

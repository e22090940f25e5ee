//! Parts of the model in words.

use crate::{Effect, Range, Requirement, Type, Versions};

/// The first sentence with its full stop, and all behind it.
pub(super) fn first_sentence(text: &str) -> (&str, &str) {
    let end = ["\n\n", ". ", ".\n"].iter().filter_map(|end| Some(text.find(end)? + usize::from(end.starts_with('.'))));
    let (first, rest) = end.min().map_or((text, ""), |end| text.split_at(end));
    (first, rest.trim())
}

/// `0 to 5`, `at least 0`; nothing for a range without ends.
pub(super) fn range(range: Range) -> Option<String> {
    match (range.min, range.max) {
        (Some(min), Some(max)) => Some(format!("{min} to {max}")),
        (Some(min), None) => Some(format!("at least {min}")),
        (None, Some(max)) => Some(format!("at most {max}")),
        (None, None) => None,
    }
}

/// `1.5 and later`; nothing where every firmware has it.
pub(super) fn versions(versions: &Versions) -> Option<String> {
    match (&versions.since, &versions.until) {
        (Some(since), Some(until)) => Some(format!("{since} to {until}")),
        (Some(since), None) => Some(format!("{since} and later")),
        (None, Some(until)) => Some(format!("up to {until}")),
        (None, None) => None,
    }
}

/// The word of the TOML files.
pub(super) fn effect(effect: Effect) -> &'static str {
    match effect {
        Effect::Query => "query",
        Effect::Setting => "setting",
        Effect::Motion => "motion",
        Effect::Power => "power",
        Effect::Session => "session",
    }
}

/// `powered, enabled and outside servo mode`; nothing where the robot may be in any state.
pub(super) fn requirements(requires: &[Requirement]) -> Option<String> {
    let words: Vec<_> = requires.iter().map(|requirement| self::requirement(*requirement).to_owned()).collect();
    (!words.is_empty()).then(|| list(&words))
}

fn requirement(requirement: Requirement) -> &'static str {
    match requirement {
        Requirement::Powered => "powered",
        Requirement::Enabled => "enabled",
        Requirement::ServoMode => "in servo mode",
        Requirement::NotServoMode => "outside servo mode",
    }
}

/// `a, b and c`.
pub(super) fn list(items: &[String]) -> String {
    match items.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => items.concat(),
    }
}

/// The notation of the TOML files, such as `float[6]`.
pub(super) fn notation(ty: &Type) -> String {
    match ty {
        Type::Bool { .. } => "bool".to_owned(),
        Type::Int => "int".to_owned(),
        Type::Float => "float".to_owned(),
        Type::Text => "text".to_owned(),
        Type::Json => "json".to_owned(),
        Type::Named(name) => name.clone(),
        Type::List(element) => format!("{}[]", notation(element)),
        Type::Array(element, len) => format!("{}[{len}]", notation(element)),
        Type::Python(inner) => format!("python({})", notation(inner)),
    }
}

//! Parts that commands, types and fields have in common.

use crate::item::{Item, Placed};
use crate::names::{is_camel, is_snake};
use crate::version::{Version, Versions};

pub(super) fn doc(item: &Item<'_, '_>) -> Option<String> {
    item.text("doc").map(|text| text.value.trim().to_owned())
}

pub(crate) fn required_doc(item: &Item<'_, '_>) -> String {
    item.required_text("doc").value.trim().to_owned()
}

/// The Rust name: `name`, or the wire's spelling where that is a Rust name already.
pub(super) fn snake_name<'s>(item: &Item<'_, 's>, wire: &Placed<'s, String>) -> Placed<'s, String> {
    let name = if item.has("name") { item.required_text("name") } else { wire.clone() };
    if !is_snake(&name.value) && !name.value.is_empty() {
        item.error(name.at, &format!("`{}` is not a snake_case Rust name; give one as `name`", name.value));
    }
    name
}

pub(super) fn camel_name<'s>(item: &Item<'_, 's>) -> Placed<'s, String> {
    let name = item.required_text("name");
    if !is_camel(&name.value) && !name.value.is_empty() {
        item.error(name.at, &format!("`{}` is not a CamelCase Rust name", name.value));
    }
    name
}

pub(crate) fn wire_int<'s>(item: &Item<'_, 's>) -> Placed<'s, i64> {
    if !item.has("wire") {
        item.error(item.at, "`wire` is missing");
    }
    item.int("wire").unwrap_or(Placed { at: item.at, value: 0 })
}

pub(super) fn keyword<T: Copy>(item: &Item<'_, '_>, key: &'static str, words: &[(&str, T)]) -> Option<T> {
    let text = item.required_text(key);
    word(item, key, &text, words)
}

pub(super) fn word<T: Copy>(
    item: &Item<'_, '_>,
    key: &str,
    text: &Placed<'_, String>,
    words: &[(&str, T)],
) -> Option<T> {
    let found = words.iter().find(|(word, _)| *word == text.value).map(|(_, value)| *value);
    if found.is_none() && !text.value.is_empty() {
        let known: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        item.error(text.at, &format!("`{key}` is one of {}, not `{}`", known.join(", "), text.value));
    }
    found
}

/// The versions that know the item; a missing key of its table is as in `before`.
pub(crate) fn versions(item: &Item<'_, '_>, before: &Versions) -> Versions {
    let version = |key| {
        let text = item.text(key)?;
        let version = Version::read(&text.value);
        if version.is_none() {
            item.error(text.at, &format!("`{key}` is a version such as 1.5 or 1.6.5"));
        }
        version
    };
    let versions = Versions { since: version("since"), until: version("until") }.or(before);
    if versions.is_void() {
        item.error(item.at, "`since` is later than `until`");
    }
    versions
}

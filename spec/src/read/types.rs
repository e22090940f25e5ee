//! Named types.

use super::common::{camel_name, keyword, required_doc, versions, wire_int};
use super::field::{fields, wrapped_type};
use super::role::role;
use crate::evidence;
use crate::item::{Item, Placed, Unique};
use crate::model::{Choice, EnumValue, Field, TypeDef, TypeId, TypeKind, Variant};
use crate::resolve::Index;
use crate::spec::STATUS_TYPE;
use crate::version::Versions;

/// Reads a type, and gives its definition to the index.
pub(crate) fn type_def<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> TypeId {
    let name = camel_name(item);
    index.type_name(item, &name);
    let kinds = [("object", 0), ("array", 1), ("enum", 2), ("choice", 3), ("wrapper", 4)];
    let kind = match keyword(item, "kind", &kinds) {
        Some(0) | None => TypeKind::Object(fields(item, ("field", "field"), Some(&[]), index)),
        Some(1) => TypeKind::Array {
            fields: fields(item, ("field", "field"), None, index),
            exact: item.flag("exact").is_some_and(|flag| flag.value),
        },
        Some(2) => enum_kind(item),
        Some(3) => TypeKind::Choice(array_choice(item, index)),
        Some(_) => TypeKind::Wrapper(wrapped_type(item, index), item.text("unit").map(|text| text.value)),
    };
    if name.value == STATUS_TYPE && !matches!(kind, TypeKind::Object(_)) {
        item.error(item.at, "the status packet is an object");
    }
    let id = index.define(TypeDef { name: name.value, doc: required_doc(item), kind });
    item.finish();
    id
}

fn array_choice<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Choice {
    let variants = variants(item, |item| array_variant_fields(item, index));
    Choice { tag: String::new(), variants }
}

/// A variant that is written as an array.
pub(crate) fn array_variant<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Variant {
    variant(item, |item| array_variant_fields(item, index))
}

fn array_variant_fields<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Vec<Field> {
    if item.text("name").is_some_and(|name| name.value == "Other") {
        item.error(item.at, OTHER);
    }
    if item.has("role") {
        item.error(item.at, "`role` is for a command, or a variant of its request");
    }
    fields(item, ("field", "field"), None, index)
}

fn enum_kind(item: &Item<'_, '_>) -> TypeKind {
    let values = item.items("value", "value");
    if values.is_empty() {
        item.error(item.at, "an enum needs at least one `value`");
    }
    let textual = values.first().is_some_and(|value| value.is_text("wire"));
    if textual {
        TypeKind::TextEnum(enum_values(&values, |item| item.required_text("wire")))
    } else {
        TypeKind::IntEnum(enum_values(&values, wire_int))
    }
}

fn enum_values<'s, T: Ord + Clone + std::fmt::Display>(
    items: &[Item<'_, 's>],
    wire: impl Fn(&Item<'_, 's>) -> Placed<'s, T>,
) -> Vec<EnumValue<T>> {
    let mut names = Unique::default();
    let mut wires = Unique::default();
    let read = |item: &Item<'_, 's>| {
        let wire = wire(item);
        wires.add(item, "value", &wire);
        names.add(item, "name", &camel_name(item));
        enum_value(item, wire.value)
    };
    items.iter().map(read).collect()
}

const OTHER: &str = "`Other` is the variant for values that the spec does not list";

/// One value of an enum.
pub(crate) fn enum_value<T>(item: &Item<'_, '_>, wire: T) -> EnumValue<T> {
    let advisory = item.flag("advisory").is_some_and(|flag| flag.value);
    let versions = versions(item, &Versions::default());
    let value = EnumValue {
        wire,
        name: value_name(item),
        doc: required_doc(item),
        advisory,
        versions,
        evidence: evidence::read(item),
    };
    item.finish();
    value
}

/// The value after an `[[override]]`: a missing key of the table changes nothing.
pub(crate) fn changed_value<T: Clone>(item: &Item<'_, '_>, base: &EnumValue<T>) -> EnumValue<T> {
    let value = EnumValue {
        wire: base.wire.clone(),
        name: if item.has("name") { value_name(item) } else { base.name.clone() },
        doc: if item.has("doc") { required_doc(item) } else { base.doc.clone() },
        advisory: item.flag("advisory").map_or(base.advisory, |flag| flag.value),
        versions: versions(item, &base.versions),
        evidence: base.evidence.clone(),
    };
    item.finish();
    value
}

fn value_name(item: &Item<'_, '_>) -> String {
    let name = camel_name(item);
    if name.value == "Other" {
        item.error(name.at, OTHER);
    }
    name.value
}

/// The variants of a choice; `fields` reads their fields.
pub(super) fn variants<'s>(item: &Item<'_, 's>, mut fields: impl FnMut(&Item<'_, 's>) -> Vec<Field>) -> Vec<Variant> {
    let mut names = Unique::default();
    let mut tags = Unique::default();
    let items = item.items("variant", "variant");
    if items.is_empty() {
        item.error(item.at, "a choice needs at least one `variant`");
    }
    let read = |item: &Item<'_, 's>| {
        tags.add(item, "tag value", &wire_int(item));
        names.add(item, "name", &camel_name(item));
        variant(item, &mut fields)
    };
    items.iter().map(read).collect()
}

/// One variant; `fields` reads its fields.
pub(crate) fn variant<'s>(item: &Item<'_, 's>, fields: impl FnOnce(&Item<'_, 's>) -> Vec<Field>) -> Variant {
    let (wire, name, fields) = (wire_int(item).value, camel_name(item).value, fields(item));
    let variant = Variant { wire, name, doc: required_doc(item), role: role(item), fields };
    item.finish();
    variant
}

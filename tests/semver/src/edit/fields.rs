//! Edits of fields.

use jaka_spec::to_snake;
use toml::{Table, Value};

use super::{Kind, pick, remove, reorder, set, table, tables, toggle};
use crate::draft::{Draft, List, Place};
use crate::random::Random;

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "optional field added", make: |d, r| added(d, r, true) },
    Kind { name: "required field added", make: |d, r| added(d, r, false) },
    Kind { name: "optional request field added", make: |d, r| added_to(d, r, true, is_request) },
    Kind { name: "reply field added", make: |d, r| added_to(d, r, false, is_reply) },
    Kind { name: "field named as a constructor", make: named_as_constructor },
    Kind { name: "field removed", make: |d, r| any(d, r).map(|place| remove(d, &place)) },
    Kind { name: "request field removed", make: |d, r| of(d, r, Place::is_of_request).map(|place| remove(d, &place)) },
    Kind { name: "field moved", make: |d, r| any(d, r).and_then(|place| reorder(d, r, &place)) },
    Kind { name: "request field moved", make: |d, r| of(d, r, Place::is_of_request).and_then(|p| reorder(d, r, &p)) },
    Kind { name: "field renamed", make: renamed },
    Kind { name: "key", make: key },
    Kind { name: "type of a field", make: retyped },
    Kind { name: "type of a request field", make: request_retyped },
    Kind { name: "optional", make: |d, r| any(d, r).map(|place| toggle(d, &place, "optional", true)) },
    Kind {
        name: "optional request",
        make: |d, r| of(d, r, Place::is_of_request).map(|p| toggle(d, &p, "optional", true)),
    },
    Kind { name: "or_raw", make: |d, r| either(d, r, "or_raw", |d, place| toggle(d, place, "or_raw", true)) },
    Kind { name: "constructors", make: constructors },
    Kind { name: "unit", make: unit },
    Kind { name: "unit stated or left out", make: unit_stated },
    Kind { name: "min", make: |d, r| limit(d, r, "min", &[-1000.0, -1.0, 0.0, 0.5]) },
    Kind { name: "max", make: |d, r| limit(d, r, "max", &[1.0, 5.5, 100.0, 1e6]) },
    Kind { name: "advisory", make: advisory },
    Kind { name: "advised", make: advised },
    Kind { name: "ascii", make: ascii },
    Kind { name: "written", make: written },
    Kind { name: "python", make: python },
    Kind {
        name: "disputed",
        make: |d, r| either(d, r, "disputed", |d, p| toggle(d, p, "disputed", tables("['A', 'B']"))),
    },
    Kind { name: "field since", make: |d, r| any(d, r).map(|place| toggle(d, &place, "since", "1.5")) },
    Kind { name: "field until", make: |d, r| any(d, r).map(|place| toggle(d, &place, "until", "1.7")) },
    Kind { name: "field doc", make: |d, r| any(d, r).map(|place| set(d, &place, "doc", "Another text.")) },
];

fn any(draft: &Draft, random: &mut Random) -> Option<Place> {
    // Most fields of the spec are those of types.
    match random.below(3) {
        0 => of(draft, random, Place::is_of_request),
        1 => of(draft, random, Place::is_of_reply),
        _ => of(draft, random, Place::is_of_type),
    }
}

fn of(draft: &Draft, random: &mut Random, group: fn(&Place) -> bool) -> Option<Place> {
    pick(draft, random, draft.fields().into_iter().filter(group).collect(), |_| true)
}

fn with(draft: &Draft, random: &mut Random, fits: impl Fn(&Table) -> bool) -> Option<Place> {
    pick(draft, random, draft.fields(), fits)
}

/// A field that has the key, as often as one that does not have it.
fn either(
    draft: &mut Draft,
    random: &mut Random,
    key: &str,
    change: fn(&mut Draft, &Place) -> String,
) -> Option<String> {
    let is_there = random.percent(50);
    let place = with(draft, random, |table| table.contains_key(key) == is_there)?;
    Some(change(draft, &place))
}

fn text<'t>(table: &'t Table, key: &str) -> &'t str {
    table.get(key).and_then(Value::as_str).unwrap_or_default()
}

fn is_request(list: &List) -> bool {
    list.key == "request" || list.key == "field" && !list.owner.is_of_type()
}

fn is_reply(list: &List) -> bool {
    list.key == "reply"
}

fn added(draft: &mut Draft, random: &mut Random, optional: bool) -> Option<String> {
    added_to(draft, random, optional, |_| true)
}

fn added_to(draft: &mut Draft, random: &mut Random, optional: bool, fits: fn(&List) -> bool) -> Option<String> {
    let name = *random.pick(&["extra", "extra", "new", "note", "first", "clone", "zone"])?;
    let ty = any_type(draft, random)?;
    let lists: Vec<_> = draft.field_lists().into_iter().filter(fits).collect();
    let owners = lists.iter().map(|list| list.owner.clone()).collect();
    let owner = pick(draft, random, owners, |_| true)?;
    let lists: Vec<_> = lists.into_iter().filter(|list| list.owner == owner).collect();
    let list = random.pick(&lists)?.clone();
    let what = format!("{}: {} `{name}` added: {ty}, optional = {optional}", draft.describe(&owner), list.key);
    insert(draft, random, &list, name, &ty, optional);
    Some(what)
}

/// An optional field whose setter has the name of the constructor for a value.
fn named_as_constructor(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |table| table.contains_key("constructors"))?;
    let ty = draft.text(&place, "type").to_owned();
    let def = draft.types().into_iter().find(|def| draft.text(def, "name") == ty)?;
    let value = random.pick(draft.table(&def).get("value")?.as_array()?)?.get("name")?.as_str()?;
    let (name, list) = (to_snake(value), place.list());
    let what = format!("{}: optional `{name}` added", draft.describe(&list.owner));
    insert(draft, random, &list, &name, "float", true);
    Some(what)
}

fn insert(draft: &mut Draft, random: &mut Random, list: &List, name: &str, ty: &str, optional: bool) {
    let is_array = draft.is_array(list);
    let mut field = table(&format!("type = '{ty}'\ndoc = 'Is new.'"));
    field.insert(if is_array { "name" } else { "wire" }.to_owned(), name.into());
    if optional {
        field.insert("optional".to_owned(), true.into());
    }
    let fields = draft.list_mut(list);
    let at = if random.percent(50) { fields.len() } else { random.below(fields.len() + 1) };
    fields.insert(at, field.into());
}

fn any_type(draft: &Draft, random: &mut Random) -> Option<String> {
    let types =
        ["bool", "int", "float", "float", "text", "json", "float[3]", "float[6]", "int[]", "text[]", "python(int)"];
    if random.percent(60) {
        return random.pick(&types).map(|ty| (*ty).to_owned());
    }
    random.pick(&draft.type_names()).cloned()
}

fn renamed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    Some(set(draft, &place, "name", "demo_renamed"))
}

/// Another key; the name in Rust stays in most cases.
fn key(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |table| table.contains_key("wire"))?;
    let name = draft.name(&place);
    let what = set(draft, &place, "wire", "demo_key");
    if random.percent(70) {
        draft.table_mut(&place).insert("name".to_owned(), name.into());
        return Some(what + ", with the same name in Rust");
    }
    Some(what)
}

fn retyped(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    retype(draft, random, &place)
}

fn request_retyped(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = of(draft, random, Place::is_of_request)?;
    retype(draft, random, &place)
}

fn retype(draft: &mut Draft, random: &mut Random, place: &Place) -> Option<String> {
    let ty = any_type(draft, random)?;
    let field = draft.table_mut(place);
    for key in ["min", "max", "advisory", "advised", "written", "ascii", "constructors"] {
        field.remove(key);
    }
    Some(set(draft, place, "type", ty))
}

/// Some enums select a kind, and others could.
fn constructors(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let enums: Vec<_> = draft.types().into_iter().filter(|def| draft.table(def).contains_key("value")).collect();
    let names: Vec<_> = enums.iter().map(|def| draft.text(def, "name").to_owned()).collect();
    let place = with(draft, random, |field| {
        names.iter().any(|name| name == text(field, "type")) && !field.contains_key("optional")
    })?;
    Some(toggle(draft, &place, "constructors", true))
}

fn unit(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| field.contains_key("unit"))?;
    Some(set(draft, &place, "unit", "furlong"))
}

fn unit_stated(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| matches!(text(field, "type"), "float" | "int"))?;
    Some(toggle(draft, &place, "unit", "furlong"))
}

fn limit(draft: &mut Draft, random: &mut Random, key: &str, values: &[f64]) -> Option<String> {
    let place = with(draft, random, |field| matches!(text(field, "type"), "float" | "int" | "float[]"))?;
    let value = *random.pick(values)?;
    if random.percent(30) {
        return Some(toggle(draft, &place, key, value));
    }
    Some(set(draft, &place, key, value))
}

fn advisory(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| field.contains_key("min") || field.contains_key("max"))?;
    Some(toggle(draft, &place, "advisory", true))
}

fn advised(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| matches!(text(field, "type"), "float" | "int"))?;
    if random.percent(40) {
        return Some(toggle(draft, &place, "advised", tables("[{ max = 12 }]")));
    }
    Some(set(draft, &place, "advised", tables("[{ max = 7.5, nonzero = true }]")))
}

fn ascii(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| text(field, "type").contains("text"))?;
    Some(toggle(draft, &place, "ascii", true))
}

fn written(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = with(draft, random, |field| text(field, "type").starts_with("bool"))?;
    Some(toggle(draft, &place, "written", tables("['no', 'yes']")))
}

/// Into a Python literal, or out of one.
fn python(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let is_python = random.percent(60);
    let place = with(draft, random, |field| {
        text(field, "type").starts_with("python(") == is_python && !field.contains_key("constructors")
    })?;
    let ty = draft.text(&place, "type").to_owned();
    let inner = ty.strip_prefix("python(").and_then(|ty| ty.strip_suffix(')'));
    let ty = inner.map_or_else(|| format!("python({ty})"), str::to_owned);
    Some(set(draft, &place, "type", ty))
}

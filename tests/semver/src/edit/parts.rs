//! Edits of types, of their values and variants, and of what else a file has.

use toml::{Table, Value};

use super::{Kind, pick, remove, reorder, reword, set, table, tables, toggle};
use crate::draft::{Draft, List, Place};
use crate::random::Random;

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "type added", make: type_added },
    Kind { name: "type removed", make: type_removed },
    Kind { name: "type renamed", make: type_renamed },
    Kind { name: "type moved", make: type_moved },
    Kind { name: "kind of a type", make: kind },
    Kind { name: "exact", make: exact },
    Kind { name: "wrapped type", make: wrapped },
    Kind { name: "unit of a wrapper", make: wrapper_unit },
    Kind { name: "value added", make: value_added },
    Kind { name: "value removed", make: |d, r| remove_one(d, r, Draft::values) },
    Kind { name: "value renamed", make: |d, r| rename(d, r, Draft::values) },
    Kind { name: "value on the wire", make: value_wire },
    Kind { name: "value advisory", make: |d, r| toggle_one(d, r, Draft::values, "advisory", true.into()) },
    Kind { name: "value since", make: |d, r| toggle_one(d, r, Draft::values, "since", "1.5".into()) },
    Kind { name: "value moved", make: |d, r| reorder_one(d, r, Draft::values) },
    Kind { name: "variant added", make: variant_added },
    Kind { name: "variant removed", make: |d, r| remove_one(d, r, Draft::variants) },
    Kind { name: "variant renamed", make: |d, r| rename(d, r, Draft::variants) },
    Kind { name: "variant on the wire", make: |d, r| set_one(d, r, Draft::variants, "wire", 77.into()) },
    Kind { name: "variant's role", make: |d, r| toggle_one(d, r, Draft::variants, "role", "stop".into()) },
    Kind { name: "variant moved", make: |d, r| reorder_one(d, r, Draft::variants) },
    Kind { name: "error code added", make: error_added },
    Kind { name: "error code removed", make: |d, r| remove_one(d, r, Draft::errors) },
    Kind { name: "error code renamed", make: |d, r| rename(d, r, Draft::errors) },
    Kind { name: "error code on the wire", make: |d, r| set_one(d, r, Draft::errors, "wire", 9777.into()) },
    Kind { name: "error code's message", make: |d, r| toggle_one(d, r, Draft::errors, "message", "m".into()) },
    Kind { name: "event added", make: event_added },
    Kind { name: "event removed", make: |d, r| remove_one(d, r, Draft::events) },
    Kind { name: "event's severity", make: |d, r| set_one(d, r, Draft::events, "severity", "error".into()) },
    Kind { name: "event's codes", make: |d, r| set_one(d, r, Draft::events, "codes", tables("['0xFF0777']")) },
    Kind { name: "event's meaning", make: |d, r| set_one(d, r, Draft::events, "meaning", "something else".into()) },
    Kind { name: "docs of commands", make: |d, r| reword(d, r, d.commands()) },
    Kind { name: "docs of types", make: |d, r| reword(d, r, d.types()) },
    Kind { name: "docs of values and variants", make: |d, r| reword(d, r, [d.values(), d.variants()].concat()) },
    Kind { name: "docs of error codes", make: |d, r| reword(d, r, d.errors()) },
    Kind { name: "docs of a topic", make: |d, r| reword(d, r, d.files()) },
    Kind { name: "topic renamed", make: topic_renamed },
];

/// The places of one kind of tables.
type Places = fn(&Draft) -> Vec<Place>;

fn one(draft: &Draft, random: &mut Random, places: Places) -> Option<Place> {
    pick(draft, random, places(draft), |_| true)
}

fn remove_one(draft: &mut Draft, random: &mut Random, places: Places) -> Option<String> {
    let place = one(draft, random, places)?;
    Some(remove(draft, &place))
}

fn rename(draft: &mut Draft, random: &mut Random, places: Places) -> Option<String> {
    set_one(draft, random, places, "name", "DemoRenamed".into())
}

fn set_one(draft: &mut Draft, random: &mut Random, places: Places, key: &str, value: Value) -> Option<String> {
    let place = one(draft, random, places)?;
    Some(set(draft, &place, key, value))
}

fn toggle_one(draft: &mut Draft, random: &mut Random, places: Places, key: &str, value: Value) -> Option<String> {
    let place = one(draft, random, places)?;
    Some(toggle(draft, &place, key, value))
}

fn reorder_one(draft: &mut Draft, random: &mut Random, places: Places) -> Option<String> {
    let place = one(draft, random, places)?;
    reorder(draft, random, &place)
}

fn push(draft: &mut Draft, owner: &Place, key: &'static str, new: &str) -> String {
    let what = format!("{}: {key} added: {}", draft.describe(owner), new.replace('\n', ", "));
    draft.list_mut(&List { owner: owner.clone(), key }).push(table(new).into());
    what
}

fn type_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let kinds = [
        "kind = 'object'\nfield = [{ wire = 'a', type = 'int', doc = 'A.' }]",
        "kind = 'array'\nfield = [{ name = 'a', type = 'float', doc = 'A.' }]",
        "kind = 'enum'\nvalue = [{ wire = 0, name = 'A', doc = 'A.' }]",
        "kind = 'choice'\nvariant = [{ wire = 0, name = 'A', doc = 'A.' }]",
        "kind = 'wrapper'\ntype = 'text'",
    ];
    let (file, kind) = (one(draft, random, Draft::files)?, random.pick(&kinds)?);
    Some(push(draft, &file, "type", &format!("name = 'DemoNew'\ndoc = 'Is new.'\n{kind}")))
}

/// Types that nothing uses are few; others take the fields of their type along.
fn type_removed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = one(draft, random, Draft::types)?;
    let name = draft.text(&place, "name").to_owned();
    let what = remove(draft, &place);
    if random.percent(30) {
        return Some(what);
    }
    while let Some(field) = draft.fields().into_iter().find(|field| draft.text(field, "type").contains(&name)) {
        draft.remove(&field);
    }
    Some(format!("{what}, with all fields of the type"))
}

fn type_renamed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = one(draft, random, Draft::types)?;
    let name = draft.text(&place, "name").to_owned();
    let what = set(draft, &place, "name", "DemoRenamed");
    for user in [draft.fields(), draft.types(), draft.commands()].concat() {
        for key in ["type", "reply"] {
            let text = draft.text(&user, key).to_owned();
            let rest = text.replace(&name, "");
            if text.contains(&name) && !rest.contains(|c: char| c.is_ascii_uppercase()) {
                draft.table_mut(&user).insert(key.to_owned(), text.replace(&name, "DemoRenamed").into());
            }
        }
    }
    Some(what)
}

fn type_moved(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let (place, file) = (one(draft, random, Draft::types)?, random.pick(&draft.files())?.clone());
    if place.file == file.file {
        return None;
    }
    let what = format!("{}: moved to {}", draft.describe(&place), draft.module(file.file));
    let def = draft.remove(&place);
    draft.list_mut(&List { owner: file, key: "type" }).push(def.into());
    Some(what)
}

/// Between object and array, and between numbers and words.
fn kind(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.types(), |def| {
        matches!(def.get("kind").and_then(Value::as_str), Some("object" | "array" | "enum"))
    })?;
    let (name, old) = (draft.describe(&place), draft.text(&place, "kind").to_owned());
    let def = draft.table_mut(&place);
    let parts = def.get_mut(if old == "enum" { "value" } else { "field" })?.as_array_mut()?;
    let mut tables: Vec<&mut Table> = parts.iter_mut().filter_map(Value::as_table_mut).collect();
    let new = match &*old {
        "enum" => {
            for (at, value) in tables.iter_mut().enumerate() {
                let is_number = value.get("wire").is_some_and(Value::is_integer);
                let wire: Value = if is_number { format!("w{at}").into() } else { i64::try_from(at).ok()?.into() };
                value.insert("wire".to_owned(), wire);
            }
            "enum"
        }
        "object" => {
            for field in &mut tables {
                let wire = field.remove("wire")?;
                field.entry("name").or_insert(wire);
            }
            "array"
        }
        _ => {
            for field in &mut tables {
                let name = field.get("name")?.clone();
                field.insert("wire".to_owned(), name);
            }
            def.remove("exact");
            "object"
        }
    };
    draft.table_mut(&place).insert("kind".to_owned(), new.into());
    Some(format!("{name}: kind {old} becomes {new}, of other keys or values"))
}

fn exact(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.types(), |def| def.get("kind").and_then(Value::as_str) == Some("array"))?;
    Some(toggle(draft, &place, "exact", true))
}

fn wrapper(draft: &Draft, random: &mut Random) -> Option<Place> {
    pick(draft, random, draft.types(), |def| def.get("kind").and_then(Value::as_str) == Some("wrapper"))
}

fn wrapped(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = wrapper(draft, random)?;
    let ty = *random.pick(&["float", "int", "text", "float[6]", "float[7]", "bool", "DemoMode"])?;
    Some(set(draft, &place, "type", ty))
}

fn wrapper_unit(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = wrapper(draft, random)?;
    if random.percent(50) {
        return Some(toggle(draft, &place, "unit", "furlong"));
    }
    Some(set(draft, &place, "unit", "furlong"))
}

/// True for an enum of integers, false for one of strings.
fn is_int_enum(draft: &Draft, def: &Place) -> bool {
    let values = draft.table(def).get("value").and_then(Value::as_array);
    values.and_then(|values| values.first()?.get("wire")).is_some_and(Value::is_integer)
}

fn value_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.types(), |def| def.contains_key("value"))?;
    let wire = if is_int_enum(draft, &place) { "777" } else { "'demo'" };
    let name = *random.pick(&["DemoAdded", "New", "Tolerance", "Count", "Loop"])?;
    Some(push(draft, &place, "value", &format!("wire = {wire}\nname = '{name}'\ndoc = 'Is new.'")))
}

fn value_wire(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = one(draft, random, Draft::values)?;
    let is_number = draft.table(&place).get("wire").is_some_and(Value::is_integer);
    Some(set(draft, &place, "wire", if is_number { Value::from(777) } else { "demo".into() }))
}

fn variant_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let lists: Vec<_> = draft.variants().iter().map(Place::list).collect();
    let list = random.pick(&lists)?.clone();
    let key = if list.owner.is_of_type() { "name" } else { "wire" };
    let fields = [
        String::new(),
        format!("field = [{{ {key} = 'a', type = 'int', doc = 'A.' }}]"),
        format!("field = [{{ {key} = 'a', type = 'text', doc = 'A.' }}]"),
    ];
    let fields = random.pick(&fields)?;
    Some(push(draft, &list.owner, list.key, &format!("wire = 777\nname = 'DemoAdded'\ndoc = 'Is new.'\n{fields}")))
}

fn error_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let file = one(draft, random, Draft::files)?;
    Some(push(draft, &file, "error", "wire = 9003\nname = 'DemoAdded'\ndoc = 'Is new.'"))
}

fn event_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let file = one(draft, random, Draft::files)?;
    Some(push(draft, &file, "event", "severity = 'error'\ncodes = ['0xFF0100']\nmeaning = 'an added event'"))
}

/// Its module is renamed with it.
fn topic_renamed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let file = one(draft, random, Draft::files)?;
    let what = format!("{}: renamed", draft.describe(&file));
    draft.rename_file(file.file, "demo_topic");
    Some(what)
}

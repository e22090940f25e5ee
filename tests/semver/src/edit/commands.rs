//! Edits of commands.

use toml::{Table, Value};

use super::{Kind, pick, remove, set, table, tables, toggle};
use crate::draft::{Draft, Place};
use crate::random::Random;

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "command added", make: added },
    Kind { name: "command removed", make: removed },
    Kind { name: "command renamed", make: renamed },
    Kind { name: "cmdName", make: wire },
    Kind { name: "command moved", make: moved },
    Kind { name: "effect", make: effect },
    Kind { name: "role", make: role },
    Kind { name: "changes", make: |d, r| on_any(d, r, "changes", tables("['tool', 'payload']")) },
    Kind { name: "motion removed", make: motion_removed },
    Kind { name: "motion changed", make: motion_changed },
    Kind { name: "motion added", make: motion_added },
    Kind { name: "requires", make: |d, r| on_any(d, r, "requires", tables("['powered', 'not_servo_mode']")) },
    Kind { name: "requires_source", make: |d, r| on_any(d, r, "requires_source", "A source.") },
    Kind { name: "deadline", make: |d, r| on_any(d, r, "deadline_ms", 1234) },
    Kind { name: "reply certain", make: |d, r| on_any(d, r, "reply_certain", false) },
    Kind { name: "session ends", make: |d, r| on_any(d, r, "ends_session", true) },
    Kind { name: "bare reply", make: bare_reply },
    Kind { name: "deprecated", make: |d, r| on_any(d, r, "deprecated", "take another") },
    Kind { name: "deprecation reworded", make: deprecation },
    Kind { name: "command since", make: |d, r| on_any(d, r, "since", "1.5") },
    Kind { name: "command until", make: |d, r| on_any(d, r, "until", "1.7") },
    Kind { name: "errata", make: |d, r| on_any(d, r, "errata", tables("['An erratum.']")) },
    Kind { name: "section", make: |d, r| on_any(d, r, "section", "9.99") },
    Kind { name: "title in Chinese", make: |d, r| on_any(d, r, "title_zh", "其他") },
    Kind { name: "evidence", make: |d, r| on_any(d, r, "evidence", "Field notes.") },
    Kind { name: "reconstructed", make: |d, r| on_any(d, r, "reconstructed", "Field notes.") },
    Kind { name: "refusal", make: refusal },
    Kind { name: "examples", make: |d, r| on_any(d, r, "example", tables("[{ reply = '{\"errorCode\": \"0\"}' }]")) },
    Kind { name: "reply of a type", make: reply_type },
    Kind { name: "reply of other fields", make: reply_fields },
    Kind { name: "request with variants", make: choice },
    Kind { name: "request without variants", make: no_choice },
    Kind { name: "key of the tag", make: tag },
];

/// A key of any command.
fn on_any(draft: &mut Draft, random: &mut Random, key: &str, value: impl Into<Value>) -> Option<String> {
    // As often where it is there as where it is not.
    let is_there = random.percent(50);
    let place = pick(draft, random, draft.commands(), |table| table.contains_key(key) == is_there);
    let place = place.or_else(|| pick(draft, random, draft.commands(), |_| true))?;
    Some(toggle(draft, &place, key, value))
}

fn any(draft: &Draft, random: &mut Random) -> Option<Place> {
    pick(draft, random, draft.commands(), |_| true)
}

fn added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let requests = [
        "",
        "request = [{ wire = 'label', type = 'text', doc = 'A.' }]",
        "request = [{ wire = 'pair', type = 'DemoPair', doc = 'A.' }, { wire = 'b', type = 'DemoModule', doc = 'B.' }]",
        "choice = { tag = 't', variant = [{ wire = 0, name = 'A', doc = 'A.' }] }",
    ];
    let replies =
        ["", "reply = 'json'", "reply = 'DemoReadings'", "reply = [{ wire = 'a', type = 'int', doc = 'A.' }]"];
    let (request, reply) = (random.pick(&requests)?, random.pick(&replies)?);
    let command = format!("wire = 'demo_new'\neffect = 'query'\ndoc = 'Is new.'\n{request}\n{reply}");
    let file = random.pick(&draft.files())?.clone();
    let what = format!("{}: command demo_new added, {request}; {reply}", draft.describe(&file));
    push(draft, &file, "command", table(&command));
    Some(what)
}

fn push(draft: &mut Draft, file: &Place, key: &'static str, new: Table) {
    let list = crate::draft::List { owner: file.clone(), key };
    draft.list_mut(&list).push(Value::Table(new));
}

fn removed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    Some(remove(draft, &place))
}

fn renamed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    Some(set(draft, &place, "name", "demo_renamed"))
}

/// Another `cmdName`; the name in Rust stays in half of the cases.
fn wire(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    let name = draft.name(&place);
    let what = set(draft, &place, "wire", "demo_wire");
    if random.percent(50) {
        draft.table_mut(&place).insert("name".to_owned(), name.into());
        return Some(what + ", with the same name in Rust");
    }
    Some(what)
}

fn moved(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    let file = random.pick(&draft.files())?.clone();
    if file.file == place.file {
        return None;
    }
    let what = format!("{}: moved to {}", draft.describe(&place), draft.module(file.file));
    let command = draft.remove(&place);
    push(draft, &file, "command", command);
    Some(what)
}

fn effect(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    let effect = *random.pick(&["query", "setting", "motion", "power", "session"])?;
    Some(set(draft, &place, "effect", effect))
}

fn role(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let roles = [("state", "query"), ("output", "setting"), ("pause", "motion"), ("resume", "motion")];
    let (role, effect) = *random.pick(&roles)?;
    let fits =
        |table: &Table| table.get("effect").and_then(Value::as_str) == Some(effect) && !table.contains_key("motion");
    let place = pick(draft, random, draft.commands(), fits)?;
    Some(toggle(draft, &place, "role", role))
}

fn motion_removed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.motions(), |_| true)?;
    Some(remove(draft, &place))
}

fn motion_changed(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let key = *random.pick(&["mode", "acceleration", "tolerance"])?;
    let place = pick(draft, random, draft.motions(), |table| table.contains_key(key))?;
    Some(toggle(draft, &place, key, ""))
}

fn motion_added(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let has = |table: &Table, name: &str, ty: &str| {
        let fields = table.get("request").and_then(Value::as_array);
        fields.is_some_and(|fields| {
            fields.iter().any(|field| {
                let text = |key: &str| field.get(key).and_then(Value::as_str);
                text("name").or(text("wire")) == Some(name) && text("type") == Some(ty)
            })
        })
    };
    let targets = [("pose", "Pose"), ("joint_position", "JointPosition"), ("cart_position", "Pose")];
    let (name, ty) = *random.pick(&targets)?;
    let place = pick(draft, random, draft.commands(), |table| {
        has(table, name, ty) && !table.contains_key("motion") && !table.contains_key("role")
    })?;
    let mut target = Table::new();
    target.insert("target".to_owned(), name.into());
    let what = set(draft, &place, "effect", "motion");
    draft.table_mut(&place).insert("motion".to_owned(), target.into());
    Some(format!("{what}, a motion to {name}"))
}

fn bare_reply(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.commands(), |table| table.get("reply").is_some_and(Value::is_array))?;
    let field = draft.table(&place)["reply"].as_array().and_then(|fields| random.pick(fields))?;
    let name = field.get("name").or_else(|| field.get("wire"))?.clone();
    Some(toggle(draft, &place, "bare_reply", name))
}

fn deprecation(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.commands(), |table| table.contains_key("deprecated"))?;
    Some(set(draft, &place, "deprecated", "take something else"))
}

fn refusal(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let refusal = table("code = -7\nmessage = 'no'");
    on_any(draft, random, "refusal", refusal)
}

fn reply_type(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = any(draft, random)?;
    let reply = *random.pick(&["json", "RobotStatus", "DemoState", "DemoReadings"])?;
    draft.table_mut(&place).remove("bare_reply");
    Some(set(draft, &place, "reply", reply))
}

fn reply_fields(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let replies = [
        "[]",
        "[{ wire = 'a', type = 'int', doc = 'A.' }]",
        "[{ wire = 'a', type = 'text', optional = true, doc = 'A.' }]",
    ];
    let (place, reply) = (any(draft, random)?, *random.pick(&replies)?);
    draft.table_mut(&place).remove("bare_reply");
    Some(set(draft, &place, "reply", tables(reply)))
}

fn choice(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let plain = |table: &Table| !["choice", "motion", "role"].iter().any(|key| table.contains_key(*key));
    let place = pick(draft, random, draft.commands(), plain)?;
    let fields = draft.table_mut(&place).remove("request");
    let mut variant = table("wire = 0\nname = 'Usual'\ndoc = 'As before.'");
    variant.extend(fields.map(|fields| ("field".to_owned(), fields)));
    let mut choice = table("tag = 'demo_tag'");
    choice.insert("variant".to_owned(), Value::Array(vec![variant.into()]));
    let what = format!("{}: the request becomes a choice", draft.describe(&place));
    draft.table_mut(&place).insert("choice".to_owned(), choice.into());
    Some(what)
}

fn no_choice(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.commands(), |table| table.contains_key("choice"))?;
    let what = format!("{}: the request is no longer a choice", draft.describe(&place));
    draft.table_mut(&place).remove("choice");
    Some(what)
}

fn tag(draft: &mut Draft, random: &mut Random) -> Option<String> {
    let place = pick(draft, random, draft.commands(), |table| table.contains_key("choice"))?;
    let what = format!("{}: another key of the tag", draft.describe(&place));
    let choice = draft.table_mut(&place).get_mut("choice").and_then(Value::as_table_mut)?;
    choice.insert("tag".to_owned(), "demo_tag".into());
    Some(what)
}

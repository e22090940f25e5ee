//! From one TOML file to the model, with every check that needs no other file.

use std::time::Duration;

use crate::item::{Item, parse};
use crate::keys::{COMMAND_NAME, ENVELOPE};
use crate::model::{Choice, Command, Effect, ErrorCode, Example, Refusal, Reply, Request, Requirement, Topic, Type};
use crate::names::{RESERVED_MODULES, is_snake, to_camel};
use crate::report::{At, Report};
use crate::resolve::{Index, Need};
use crate::scalar::Scalar;
use crate::version::Versions;
use crate::{Source, evidence};

mod common;
mod event;
mod field;
mod role;
mod types;
mod wire;

use common::{camel_name, doc, keyword, snake_name, word};
pub(crate) use common::{required_doc, versions, wire_int};
pub(crate) use event::{event, event_family};
pub(crate) use field::{OPTIONAL_LAST, changed_field, field, fields};
pub(crate) use role::motion;
use types::variants;
pub(crate) use types::{array_variant, changed_value, enum_value, type_def, variant};

/// Reads a file of the spec. What cannot be read is reported and left out.
pub(crate) fn topic<'s>(source: Source<'s>, index: &mut Index<'s>, report: &Report) -> Topic {
    check_name(source, report);
    file(source, report, |root, topic| {
        topic.commands = root.items("command", "command").iter().map(|item| command(item, index)).collect();
        topic.types = root.items("type", "type").iter().map(|item| type_def(item, index)).collect();
        topic.errors = root.items("error", "error code").iter().map(|item| error_code(item, index)).collect();
        let families = root.items("event_family", "family of events");
        topic.event_families = families.iter().map(|item| event_family(item, index)).collect();
        topic.events = root.items("event", "event").iter().map(|item| event(item, index)).collect();
    })
}

/// Reads the common part of a file, and lets `body` read the rest.
pub(crate) fn file<'s>(source: Source<'s>, report: &Report, body: impl FnOnce(&Item<'_, 's>, &mut Topic)) -> Topic {
    let table = parse(source, report);
    let start = At { source, offset: 0 };
    let root = Item::new(String::new(), start, table.get_ref(), report);
    let mut topic = Topic {
        title: root.required_text("title").value,
        title_zh: root.text("title_zh").map(|text| text.value),
        doc: doc(&root).unwrap_or_default(),
        commands: Vec::new(),
        types: Vec::new(),
        errors: Vec::new(),
        events: Vec::new(),
        event_families: Vec::new(),
        name: stem(source.path).to_owned(),
        is_pack: false,
    };
    body(&root, &mut topic);
    root.finish();
    topic
}

/// Checks that the file's name is a valid name of a module.
pub(crate) fn check_name(source: Source<'_>, report: &Report) {
    let (start, name) = (At { source, offset: 0 }, stem(source.path));
    if !is_snake(name) {
        report.error(start, format!("the file's name is that of a module, and `{name}` is not a snake_case name"));
    }
    if RESERVED_MODULES.contains(&name) {
        report.error(start, format!("the file's name is that of a module, and `{name}` is a name of Rust"));
    }
}

pub(crate) fn stem(path: &str) -> &str {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    file.strip_suffix(".toml").unwrap_or(file)
}

pub(crate) fn command<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Command {
    let wire = item.required_text("wire");
    if wire.value.trim() != wire.value {
        item.error(wire.at, "blanks around a command's name are lost in replies, which are read without them");
    }
    let section = item.text("section");
    let evidence = evidence::read(item);
    if section.is_some() && !evidence.is_empty() {
        item.error(item.at, "`evidence` is for a command without `section`, which the document does not have");
    }
    index.command(item, &wire, section.as_ref());
    let name = snake_name(item, &wire);
    index.method(item, &name);
    let request = request(item, index);
    let reply = reply(item, index);
    let bare_reply = item.text("bare_reply");
    if let Some(bare) =
        bare_reply.as_ref().filter(|bare| reply.own_fields().iter().all(|field| field.name != bare.value))
    {
        item.error(bare.at, &format!("`bare_reply` names `{}`, which is not a field of the reply", bare.value));
    }
    let reply_certain = item.flag("reply_certain").is_none_or(|flag| flag.value);
    if !reply_certain && (reply.object().is_some() || reply.own_fields().iter().any(|field| !field.optional)) {
        item.error(item.at, OPTIONAL_ONLY);
    }
    let command = Command {
        aliases: aliases(item, [&wire.value, &name.value, &to_camel(&name.value)]),
        section: section.map(|text| text.value),
        title_zh: item.text("title_zh").map(|text| text.value),
        evidence,
        effect: keyword(item, "effect", Effect::WORDS).unwrap_or(Effect::Query),
        role: role::role(item),
        changes: role::changes(item),
        motion: motion(item),
        remembers: item.text("remembers").map(|text| text.value),
        requires: requires(item),
        requires_source: item.text("requires_source").map(|text| text.value),
        deadline: deadline(item),
        reply_certain,
        ends_session: item.flag("ends_session").is_some_and(|flag| flag.value),
        reconstructed: item.text("reconstructed").map(|text| text.value),
        deprecated: item.text("deprecated").map(|text| text.value),
        versions: versions(item, &Versions::default()),
        doc: required_doc(item),
        errata: item.texts("errata").into_iter().map(|text| text.value).collect(),
        refused_because: item.texts("refused_because").into_iter().map(|text| text.value).collect(),
        request,
        reply,
        bare_reply: bare_reply.map(|text| text.value),
        refusal: item.item("refusal", "refusal").map(|item| refusal(&item)),
        examples: item.items("example", "example").iter().map(example).collect(),
        wire: wire.value,
        name: name.value,
    };
    index.setting(&command);
    role::check(item, &command, index);
    item.finish();
    command
}

pub(crate) const OPTIONAL_ONLY: &str = "a reply that may never come can have optional fields only";

fn requires(item: &Item<'_, '_>) -> Vec<Requirement> {
    let list = item.texts("requires");
    list.iter().filter_map(|text| word(item, "requires", text, Requirement::WORDS)).collect()
}

/// Other names of a command. rustdoc takes no alias that is a name of the item itself.
fn aliases(item: &Item<'_, '_>, own: [&str; 3]) -> Vec<String> {
    let mut aliases: Vec<String> = Vec::new();
    for alias in item.texts("alias") {
        let is_part = |c: char| c == '_' || c.is_ascii_alphanumeric();
        if alias.value.is_empty() || !alias.value.chars().all(is_part) {
            item.error(alias.at, "`alias` is the name of a function: letters, digits and underscores");
        } else if own.contains(&&*alias.value) || aliases.contains(&alias.value) {
            item.error(alias.at, &format!("the command has the name `{}` already", alias.value));
        }
        aliases.push(alias.value);
    }
    aliases
}

pub(crate) fn deadline(item: &Item<'_, '_>) -> Option<Duration> {
    let ms = item.int("deadline_ms")?;
    let positive = u64::try_from(ms.value).ok().filter(|ms| *ms > 0);
    if positive.is_none() {
        item.error(ms.at, "`deadline_ms` must be positive");
    }
    positive.map(Duration::from_millis)
}

fn request<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Request {
    match item.item("choice", "choice") {
        None => Request::Fields(fields(item, ("request", "field"), Some(&[COMMAND_NAME]), index)),
        Some(choice_item) => {
            if item.has("request") {
                item.error(choice_item.at, "a command has `request` fields or a `choice`, not both");
            }
            let tag = choice_item.required_text("tag");
            if tag.value == COMMAND_NAME {
                choice_item.error(tag.at, "each message has this key, for its command's name");
            }
            let taken = [COMMAND_NAME, &tag.value];
            let variants = variants(&choice_item, |item| fields(item, ("field", "field"), Some(&taken), index));
            choice_item.finish();
            Request::Choice(Choice { tag: tag.value, variants })
        }
    }
}

/// Fields of its own, or the name of the type whose keys it has.
fn reply<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Reply {
    if !item.is_text("reply") {
        return Reply::Fields(fields(item, ("reply", "reply field"), Some(ENVELOPE), index));
    }
    let name = item.required_text("reply");
    if name.value == Scalar::Json.name() {
        return Reply::Raw;
    }
    let id = index.type_id(&name.value);
    index.needs(item, name.at, Need::Type(Type::Named(id)));
    index.needs(item, name.at, Need::Reply(id));
    Reply::Object(id)
}

pub(crate) fn error_code<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> ErrorCode {
    let wire = wire_int(item);
    let name = camel_name(item);
    index.error_code(item, &wire, &name);
    let message = item.text("message").map(|text| text.value);
    let code = ErrorCode { wire: wire.value, name: name.value, message, doc: required_doc(item) };
    item.finish();
    code
}

fn refusal(item: &Item<'_, '_>) -> Refusal {
    if !item.has("code") {
        item.error(item.at, "`code` is missing");
    }
    let code = item.int("code").map_or(0, |code| code.value);
    let refusal = Refusal { code, message: item.required_text("message").value };
    item.finish();
    refusal
}

fn example(item: &Item<'_, '_>) -> Example {
    let ours: Vec<_> = item.texts("ours").iter().filter_map(|text| word(item, "ours", text, &PARTS)).collect();
    let example = Example {
        request: item.text("request").map(|t| t.value),
        reply: item.text("reply").map(|t| t.value),
        request_is_ours: ours.contains(&PARTS[0].0),
        reply_is_ours: ours.contains(&PARTS[1].0),
    };
    if example.request.is_none() && example.reply.is_none() {
        item.error(item.at, "an example has a `request`, a `reply` or both");
    }
    item.finish();
    example
}

/// The parts of an example.
const PARTS: [(&str, &str); 2] = [("request", "request"), ("reply", "reply")];

//! Packs: what a user's file adds to a spec and changes in it.

mod change;
mod event;
mod module;

use std::collections::BTreeSet;

use self::change::Target;
pub use self::module::Module;
use crate::item::Item;
use crate::model::{Command, ErrorCode, Field, Reply, Request, Spec, Topic, TypeDef, TypeId, TypeKind};
use crate::names::RESERVED_METHODS;
use crate::report::{At, Error, Errors, Report};
use crate::resolve::Index;
use crate::{Source, read, resolve};

/// A spec with what a pack adds to it and changes in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Pack {
    /// All of it: the changed items at their places, and what is new in a last topic, the pack's.
    pub spec: Spec,
    /// Entries of the pack that change nothing, since the spec says the same already.
    pub notes: Vec<Error>,
    /// What is new.
    topic: Topic,
    changed: Changed,
}

/// The items of the spec that a pack changes or repeats.
#[derive(Debug, Clone, Default, PartialEq)]
struct Changed {
    commands: BTreeSet<String>,
    types: BTreeSet<TypeId>,
    repeated_commands: BTreeSet<String>,
    repeated_types: BTreeSet<TypeId>,
}

/// Loads a pack: a file that adds to `base` and changes it.
///
/// # Errors
/// One [`Error`] for each thing that is wrong, at its line and column.
pub fn load_pack(base: &Spec, source: Source<'_>) -> Result<Pack, Errors> {
    let (report, notes) = (Report::default(), Report::default());
    let index = Index::of(base, read::stem(source.path));
    let mut draft = Draft { spec: base.clone(), index, notes: &notes, changed: Changed::default(), edits: Vec::new() };
    let topic = read::file(source, &report, |root, topic| draft.read(root, topic));
    draft.check_optional(&report);
    resolve::check(&draft.index, &report);
    let Draft { mut spec, index, changed, .. } = draft;
    spec.types = index.finish();
    let mut notes = notes.finish().map_or_else(|errors| errors.0, |()| Vec::new());
    if topic.is_empty() && changed.commands.is_empty() && changed.types.is_empty() {
        let message = "this pack no longer changes anything: the spec has all of it, so it can be deleted".to_owned();
        notes.insert(0, Error { path: source.path.to_owned(), line: 1, column: 1, message });
    }
    spec.topics.push(topic.clone());
    let pack = Pack { spec, notes, topic, changed };
    pack.check_methods(source, &report);
    report.finish()?;
    Ok(pack)
}

/// A spec while a pack is being applied.
struct Draft<'s, 'r> {
    spec: Spec,
    index: Index<'s>,
    notes: &'r Report,
    changed: Changed,
    /// Where it is changed: the entries, in the order of the file.
    edits: Vec<(At<'s>, String, Target)>,
}

impl<'s> Draft<'s, '_> {
    fn read(&mut self, root: &Item<'_, 's>, topic: &mut Topic) {
        let commands = root.items("command", "command");
        let types = root.items("type", "type");
        let errors = root.items("error", "error code");
        let events = root.items("event", "event");
        let extensions = root.items("extend", "extension of");
        let overrides = root.items("override", "override of");
        let all = [&commands, &types, &errors, &events, &extensions, &overrides];
        if all.iter().all(|items| items.is_empty()) {
            let message =
                "a pack has `[[command]]`, `[[type]]`, `[[error]]`, `[[event]]`, `[[extend]]` or `[[override]]`";
            root.error(root.at, message);
        }
        topic.types = types.iter().filter_map(|item| self.new_type(item)).collect();
        topic.commands = commands.iter().filter_map(|item| self.new_command(item)).collect();
        topic.errors = errors.iter().filter_map(|item| self.new_error(item)).collect();
        topic.events = events.iter().filter_map(|item| self.new_event(item)).collect();
        for item in &extensions {
            self.extend(item);
        }
        for item in &overrides {
            self.change(item);
        }
    }

    /// Says that an entry changes nothing.
    fn note(&self, item: &Item<'_, 's>, message: &str) {
        self.notes.error(item.at, format!("{}: {message}", item.what));
    }

    fn new_command(&mut self, item: &Item<'_, 's>) -> Option<Command> {
        let known = item.text("wire").and_then(|wire| self.spec.command(&wire.value).cloned());
        let Some(known) = known else {
            if item.has("bare_reply") {
                item.error(item.at, "`bare_reply` is for commands of the built-in spec");
            }
            return Some(read::command(item, &mut self.index));
        };
        if bare_command(&read::command(item, &mut self.index.again())) == bare_command(&known) {
            self.note(item, REPEATED);
            self.changed.repeated_commands.insert(known.wire);
        } else {
            item.error(item.at, DIFFERS);
        }
        None
    }

    fn new_type(&mut self, item: &Item<'_, 's>) -> Option<TypeId> {
        let Some(known) = item.text("name").and_then(|name| self.spec.type_id(&name.value)) else {
            return Some(read::type_def(item, &mut self.index));
        };
        let mut again = self.index.again();
        let new = read::type_def(item, &mut again);
        if new == known && bare_type(again.definition(new)) == bare_type(&self.spec[known]) {
            self.note(item, REPEATED);
            self.changed.repeated_types.insert(known);
        } else {
            item.error(item.at, DIFFERS);
        }
        None
    }

    fn new_error(&mut self, item: &Item<'_, 's>) -> Option<ErrorCode> {
        let known = item.int("wire").and_then(|wire| self.spec.errors().find(|code| code.wire == wire.value).cloned());
        let Some(known) = known else { return Some(read::error_code(item, &mut self.index)) };
        if read::error_code(item, &mut self.index.again()).name == known.name {
            self.note(item, REPEATED);
        } else {
            item.error(item.at, &format!("the spec has the code {} already, as `{}`", known.wire, known.name));
        }
        None
    }
}

impl Pack {
    /// The methods of changed commands bear the pack's name; nothing else may.
    fn check_methods(&self, source: Source<'_>, report: &Report) {
        let module = self.module();
        let changed = module.topic.commands.iter().filter(|command| module.changed.contains(&command.wire));
        for name in changed.map(|command| module.method(command)) {
            if self.spec.commands().any(|command| command.name == name) || RESERVED_METHODS.contains(&name.as_str()) {
                let message = format!("the method name `{name}` is that of a changed command in this pack");
                report.error(At { source, offset: 0 }, message + ", and of another; rename the file");
            }
        }
    }
}

const REPEATED: &str = "the spec has the same already; this entry changes nothing and can be deleted";
const DIFFERS: &str =
    "the spec has one of this name already, with another content; change it with `[[extend]]` and `[[override]]`";

/// The command without what is for readers alone.
fn bare_command(command: &Command) -> Command {
    let mut bare = command.clone();
    bare.doc.clear();
    bare.errata.clear();
    bare.examples.clear();
    (bare.section, bare.reconstructed, bare.title_zh) = (None, None, None);
    (bare.evidence, bare.requires_source) = (None, None);
    match &mut bare.request {
        Request::Fields(fields) => bare_fields(fields),
        Request::Choice(choice) => choice.variants.iter_mut().for_each(|variant| {
            variant.doc.clear();
            bare_fields(&mut variant.fields);
        }),
    }
    if let Reply::Fields(fields) = &mut bare.reply {
        bare_fields(fields);
    }
    bare
}

fn bare_type(def: &TypeDef) -> TypeKind {
    let mut kind = def.kind.clone();
    match &mut kind {
        TypeKind::Object(fields) | TypeKind::Array { fields, .. } => bare_fields(fields),
        TypeKind::IntEnum(values) => values.iter_mut().for_each(|value| value.doc.clear()),
        TypeKind::TextEnum(values) => values.iter_mut().for_each(|value| value.doc.clear()),
        TypeKind::Choice(choice) => choice.variants.iter_mut().for_each(|variant| {
            variant.doc.clear();
            bare_fields(&mut variant.fields);
        }),
        TypeKind::Wrapper(..) => {}
    }
    kind
}

fn bare_fields(fields: &mut [Field]) {
    for field in fields {
        field.doc.clear();
    }
}

fn bare_field(field: &Field) -> Field {
    Field { doc: String::new(), ..field.clone() }
}

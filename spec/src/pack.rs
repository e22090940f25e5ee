//! Packs: what a user's file adds to a spec and changes in it.

mod change;
mod covers;
mod module;
mod robot_status;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use self::change::Target;
pub use self::module::Module;
use crate::item::Item;
use crate::model::{Command, ErrorCode, Event, Topic, TypeId, Variant};
use crate::names::RESERVED_METHODS;
use crate::report::{At, Error, Errors, Report};
use crate::resolve::{self, Index};
use crate::spec::Spec;
use crate::words::event_code;
use crate::{Source, read};

/// A spec with what a pack adds to it and changes in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Pack {
    /// All of it: the changed items at their places, and what is new in a last topic, the pack's.
    pub spec: Spec,
    /// Entries of the pack that change nothing, since the spec has by now what they say.
    pub notes: Vec<Error>,
    /// Why no module can be made of the pack: its file's name, which that of the module would be. It can be used at run
    /// time all the same.
    pub module_errors: Vec<Error>,
    /// What is new.
    topic: Topic,
    /// All error codes of the file, also those that the spec has by now.
    codes: Vec<ErrorCode>,
    /// All events of the file, likewise.
    events: Vec<Event>,
    changed: Changed,
    /// What the spec has by now.
    covered: Covered,
}

/// The items of the spec that entries of a pack name: commands by `cmdName`, and types.
#[derive(Debug, Clone, Default, PartialEq)]
struct Changed {
    commands: BTreeSet<String>,
    types: BTreeSet<TypeId>,
}

/// The items of the spec that a pack had before the spec.
#[derive(Debug, Clone, Default, PartialEq)]
struct Covered {
    /// Commands, each with its name in the pack.
    commands: BTreeMap<String, String>,
    types: BTreeSet<TypeId>,
    /// What extensions and overrides name that change nothing.
    changes: Changed,
}

/// Loads a pack: a file that adds to `base` and changes it.
///
/// # Errors
/// One [`Error`] for each thing that is wrong, at its line and column.
pub fn load_pack(base: &Spec, source: Source<'_>) -> Result<Pack, Errors> {
    let (report, notes) = (Report::default(), Report::default());
    let index = Index::of(base, read::stem(source.path));
    let mut draft = Draft {
        spec: base.clone(),
        index,
        notes: &notes,
        codes: Vec::new(),
        events: Vec::new(),
        changed: Changed::default(),
        covered: Covered::default(),
        motions: BTreeSet::new(),
        edits: Vec::new(),
        status: robot_status::Lines::default(),
    };
    draft.spec.built_in.get_or_insert_with(|| Arc::new(Spec { topics: Vec::new(), ..base.clone() }));
    let mut topic = read::file(source, &report, |root, topic| draft.read(root, topic));
    topic.is_pack = true;
    draft.check_optional(&report);
    draft.check_motions(base, source, &report);
    resolve::check(&draft.index, &report);
    let Draft { mut spec, index, codes, events, changed, covered, edits, status, .. } = draft;
    spec.types = index.finish();
    let edits = edits.into_iter().map(|(at, what, target)| (at, what, target.type_id()));
    status.check(&spec, source, edits, &report);
    let mut notes = notes.finish().map_or_else(Errors::into_list, |()| Vec::new());
    if topic.is_empty() && changed.commands.is_empty() && changed.types.is_empty() {
        let message = "this pack no longer changes anything: the spec has all of it by now".to_owned();
        notes.insert(0, Error { path: source.path.to_owned(), line: 1, column: 1, message });
    }
    spec.topics.push(topic.clone());
    report.finish()?;
    let mut pack = Pack { spec, notes, module_errors: Vec::new(), topic, codes, events, changed, covered };
    let report = Report::default();
    read::check_name(source, &report);
    pack.check_methods(source, &report);
    pack.check_robot_status(source, &report);
    pack.module_errors = report.finish().map_or_else(Errors::into_list, |()| Vec::new());
    Ok(pack)
}

/// A spec while a pack is being applied.
struct Draft<'s, 'r> {
    spec: Spec,
    index: Index<'s>,
    notes: &'r Report,
    codes: Vec<ErrorCode>,
    events: Vec<Event>,
    changed: Changed,
    covered: Covered,
    /// Commands of the spec to which it gives another motion.
    motions: BTreeSet<String>,
    /// Where it is changed: the entries, in the order of the file.
    edits: Vec<(At<'s>, String, Target)>,
    /// Its lines and entries for what a robot needs.
    status: robot_status::Lines<'s>,
}

impl<'s> Draft<'s, '_> {
    fn read(&mut self, root: &Item<'_, 's>, topic: &mut Topic) {
        let commands = root.items("command", "command");
        let types = root.items("type", "type");
        let errors = root.items("error", "error code");
        let events = root.items("event", "event");
        let extensions = root.items("extend", "extension of");
        let overrides = root.items("override", "override of");
        let robot_status = root.item("robot_status", "`[robot_status]`");
        let all = [&commands, &types, &errors, &events, &extensions, &overrides];
        if all.iter().all(|items| items.is_empty()) && robot_status.is_none() {
            let message = "a pack has `[[command]]`, `[[type]]`, `[[error]]`, `[[event]]`, `[[extend]]`, \
                           `[[override]]` or `[robot_status]`";
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
        if let Some(item) = &robot_status {
            self.robot_status(item);
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
            let command = read::command(item, &mut self.index);
            no_roles_of_variants(item, command.variants());
            return Some(command);
        };
        let new = read::command(item, &mut self.index.again());
        match covers::command(&self.spec, &known, &new) {
            Ok(()) => {
                self.note(item, COVERED);
                self.covered.commands.insert(known.wire, new.name);
            }
            Err(difference) => differs(item, &difference),
        }
        None
    }

    fn new_type(&mut self, item: &Item<'_, 's>) -> Option<TypeId> {
        let Some(known) = item.text("name").and_then(|name| self.spec.type_id(&name.value)) else {
            return Some(read::type_def(item, &mut self.index));
        };
        let mut again = self.index.again();
        let new = read::type_def(item, &mut again);
        match covers::type_def(&self.spec, known, again.definition(new)) {
            Ok(()) => {
                self.note(item, COVERED);
                self.covered.types.insert(known);
            }
            Err(difference) => differs(item, &difference),
        }
        None
    }

    fn new_error(&mut self, item: &Item<'_, 's>) -> Option<ErrorCode> {
        let is_known = item.int("wire").is_some_and(|wire| self.spec.errors().any(|code| code.wire == wire.value));
        let new = if is_known {
            self.note(item, COVERED);
            read::error_code(item, &mut self.index.again())
        } else {
            read::error_code(item, &mut self.index)
        };
        self.codes.push(new.clone());
        (!is_known).then_some(new)
    }

    /// The event without the codes of which the spec says as much. Codes of which it says less, the spec then leaves to the pack.
    fn new_event(&mut self, item: &Item<'_, 's>) -> Option<Event> {
        let mut event = read::event(item, &mut self.index);
        for code in event.codes() {
            if let Some(known) = self.spec.event(code).filter(|known| known.severity != event.severity) {
                let (code, severity) = (event_code(code), known.severity.word());
                item.error(item.at, &format!("the spec has the code {code} already, with the severity `{severity}`"));
            }
        }
        self.events.push(event.clone());
        let adds = event.meaning.is_some();
        let says_as_much = |known: &Event| known.meaning.is_some() || !adds;
        let spec = &self.spec;
        event.retain(|code| !spec.event(code).is_some_and(says_as_much));
        if event.codes.is_empty() {
            self.note(item, COVERED);
            return None;
        }
        for topic in &mut self.spec.topics {
            topic.events.iter_mut().for_each(|known| known.retain(|code| !event.has(code)));
            topic.events.retain(|known| !known.codes.is_empty());
        }
        Some(event)
    }
}

/// Refuses roles of variants, since a variant has parameters: a pack's stop has none.
fn no_roles_of_variants(item: &Item<'_, '_>, variants: &[Variant]) {
    if variants.iter().any(|variant| variant.role.is_some()) {
        item.error(item.at, "`role` of a variant is for the built-in spec");
    }
}

fn differs(item: &Item<'_, '_>, difference: &str) {
    let message =
        format!("the spec has one of this name by now, and there {difference}, which your program would notice");
    item.error(item.at, &(message + "; delete the entry, and change the rest with `[[extend]]` and `[[override]]`"));
}

impl Pack {
    /// The methods of changed commands bear the pack's name; nothing else may.
    fn check_methods(&self, source: Source<'_>, report: &Report) {
        let module = self.module();
        let changed = self.spec.commands().filter(|command| module.changed.contains(&command.wire));
        for name in changed.map(|command| module.method(command)) {
            if self.spec.commands().any(|command| command.name == name) || RESERVED_METHODS.contains(&name.as_str()) {
                let message = format!("the method name `{name}` is that of a changed command in this pack");
                report.error(At { source, offset: 0 }, message + ", and of another; rename the file");
            }
        }
    }
}

const COVERED: &str =
    "the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives";

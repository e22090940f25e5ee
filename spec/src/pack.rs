//! Packs: additions and changes of a user's file to a spec.

mod covers;
mod draft;
mod robot_status;
mod target;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use self::draft::Draft;
use self::target::Target;
use crate::model::{Command, ErrorCode, Event, Topic, TypeDef, TypeId};
use crate::names::{RESERVED_METHODS, trait_name};
use crate::report::{At, Error, Errors, Report};
use crate::resolve::Index;
use crate::spec::Spec;
use crate::{Source, read, resolve};

/// A spec with the additions and changes of a pack.
#[derive(Debug, Clone, PartialEq)]
pub struct Pack {
    /// All of it: the changed items at their places, and new items in a last topic, the pack's.
    pub spec: Spec,
    /// Entries of the pack that change nothing, because the spec already has them.
    pub notes: Vec<Error>,
    /// Errors that keep the pack from being a module, such as a file name that no module can have. The pack can still
    /// be used at run time.
    pub module_errors: Vec<Error>,
    /// Items that are new.
    topic: Topic,
    /// All error codes of the file, also those that the spec already has.
    codes: Vec<ErrorCode>,
    /// All events of the file, likewise.
    events: Vec<Event>,
    changed: Changed,
    /// Items that the spec has by now.
    covered: Covered,
}

/// A pack as a module of generated code.
#[derive(Debug, Clone, PartialEq)]
pub struct Module {
    /// Items of the module: the new ones, the changed ones, and those made of changed types.
    pub topic: Topic,
    /// The spec with the pack. Its other topics have what is as in the spec that the pack adds to.
    pub spec: Spec,
    /// The error codes that the module names.
    pub codes: Vec<ErrorCode>,
    /// The events of which the module tells.
    pub events: Vec<Event>,
    /// The `cmdName`s of the commands whose methods bear the module's name: those that the pack changes, also if the
    /// spec has the change by now.
    pub changed: BTreeSet<String>,
    /// The `cmdName`s of the commands that the spec has by now as the pack has them, each with its name in the pack.
    pub covered_commands: BTreeMap<String, String>,
    /// The types that the spec has by now as the pack has them.
    pub covered_types: BTreeSet<TypeId>,
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
    /// Targets of extensions and overrides that change nothing.
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
    robot_status::check_module(&pack.module(), source, &report);
    pack.module_errors = report.finish().map_or_else(Errors::into_list, |()| Vec::new());
    Ok(pack)
}

impl Pack {
    /// Returns the module for which code is generated.
    pub fn module(&self) -> Module {
        let own = self.affected(&self.changed);
        let Changed { commands, types } = &self.covered.changes;
        let all =
            self.affected(&Changed { commands: commands | &self.changed.commands, types: types | &self.changed.types });
        let mut topics = self.spec.topics.clone();
        topics.pop();
        let mut topic = self.topic.clone();
        for other in &mut topics {
            let (commands, kept): (Vec<_>, _) =
                other.commands.drain(..).partition(|command| own.commands.contains(&command.wire));
            other.commands = kept;
            topic.commands.extend(commands);
            let (types, kept): (Vec<_>, _) = other.types.drain(..).partition(|id| own.types.contains(id));
            other.types = kept;
            topic.types.extend(types);
        }
        topics.push(topic.clone());
        let mut covered_commands = self.covered.commands.clone();
        let is_suffixed = |wire: &String| !covered_commands.contains_key(wire) || self.changed.commands.contains(wire);
        let changed: BTreeSet<_> = all.commands.into_iter().filter(is_suffixed).collect();
        let names = changed.iter().filter_map(|wire| Some((wire.clone(), self.spec.command(wire)?.name.clone())));
        covered_commands.extend(names);
        // What is changed as well is the module's own.
        covered_commands.retain(|wire, _| !own.commands.contains(wire));
        let covered_types = &(&all.types | &self.covered.types) - &own.types;
        let spec = Spec { topics, ..self.spec.clone() };
        Module {
            topic,
            spec,
            codes: self.codes.clone(),
            events: self.events.clone(),
            changed,
            covered_commands,
            covered_types,
        }
    }

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

    /// The items of the spec that are changed with these, since they are made of them.
    fn affected(&self, changed: &Changed) -> Changed {
        let mut affected = changed.clone();
        loop {
            let is_new = |(id, def): &(TypeId, &TypeDef)| {
                !affected.types.contains(id) && def.kind.parts().any(|part| affected.types.contains(&part))
            };
            let more: Vec<_> = self.spec.types().filter(is_new).map(|(id, _)| id).collect();
            if more.is_empty() {
                break;
            }
            affected.types.extend(more);
        }
        let known = &self.spec.topics[..self.spec.topics.len() - 1];
        let commands = known.iter().flat_map(|topic| &topic.commands);
        let made = commands.filter(|command| command.parts().any(|id| affected.types.contains(&id)));
        affected.commands.extend(made.map(|command| command.wire.clone()));
        affected
    }
}

impl Module {
    /// The name of the method of a command. That of a changed command bears the module's name, since the client has a
    /// method of the plain name.
    pub fn method(&self, command: &Command) -> String {
        let name = self.covered_commands.get(&command.wire).unwrap_or(&command.name);
        if self.changed.contains(&command.wire) { format!("{name}_{}", self.topic.name) } else { name.clone() }
    }

    /// The name of the trait with the methods.
    pub fn trait_name(&self) -> String {
        trait_name(&self.topic.name)
    }
}

impl Changed {
    fn add(&mut self, target: &Target) {
        match target {
            Target::Command(wire) => self.commands.insert(wire.clone()),
            Target::Type(id) => self.types.insert(*id),
        };
    }
}

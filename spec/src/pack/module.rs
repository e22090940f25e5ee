//! What code is generated for a pack.

use std::collections::{BTreeMap, BTreeSet};

use super::{Changed, Pack};
use crate::model::{Command, ErrorCode, Event, Topic, TypeDef, TypeId};
use crate::names::trait_name;
use crate::spec::Spec;

/// A pack as a module of generated code.
#[derive(Debug, Clone, PartialEq)]
pub struct Module {
    /// What the module has: what is new, what is changed, and what is made of changed types.
    pub topic: Topic,
    /// The spec with the pack. Its other topics have what is as in the spec that the pack adds to.
    pub spec: Spec,
    /// The error codes that the module names.
    pub codes: Vec<ErrorCode>,
    /// The events of which the module tells.
    pub events: Vec<Event>,
    /// The `cmdName`s of the commands whose methods bear the module's name: those that the pack changes, also where the
    /// spec has the change by now.
    pub changed: BTreeSet<String>,
    /// The `cmdName`s of the commands that the spec has by now as the pack has them, each with its name in the pack.
    pub covered_commands: BTreeMap<String, String>,
    /// The types that the spec has by now as the pack has them.
    pub covered_types: BTreeSet<TypeId>,
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

impl Pack {
    /// What code is generated for the pack.
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

//! What code is generated for a pack.

use std::collections::BTreeSet;

use super::Pack;
use crate::model::{Command, Spec, Topic, TypeDef, TypeId};
use crate::names::trait_name;

/// A pack as a module of generated code.
#[derive(Debug, Clone, PartialEq)]
pub struct Module {
    /// What the module has: what is new, what is changed, and what is made of changed types.
    pub topic: Topic,
    /// The spec with the pack. Its other topics have what is as in the spec that the pack adds to.
    pub spec: Spec,
    /// The `cmdName`s of the commands of the module that the spec has in another form.
    pub changed: BTreeSet<String>,
    /// The `cmdName`s of the commands that the pack repeats as the spec has them.
    pub repeated_commands: BTreeSet<String>,
    /// The types that the pack repeats as the spec has them.
    pub repeated_types: BTreeSet<TypeId>,
}

impl Module {
    /// The name of the method of a command. That of a changed command bears the module's name, since the client has a method
    /// of the plain name.
    pub fn method(&self, command: &Command) -> String {
        if self.changed.contains(&command.wire) {
            method(&command.name, &self.topic.name)
        } else {
            command.name.clone()
        }
    }

    /// The name of the trait with the methods.
    pub fn trait_name(&self) -> String {
        trait_name(&self.topic.name)
    }
}

pub(super) fn method(command: &str, module: &str) -> String {
    format!("{command}_{module}")
}

impl Pack {
    /// What code is generated for the pack.
    pub fn module(&self) -> Module {
        let types = self.affected_types();
        let is_affected = |command: &Command| {
            self.changed.commands.contains(&command.wire) || command.parts().any(|id| types.contains(&id))
        };
        let mut own = self.topic.clone();
        let mut topics = self.spec.topics.clone();
        topics.pop();
        let mut changed = BTreeSet::new();
        for topic in &mut topics {
            let (commands, kept): (Vec<_>, _) = topic.commands.drain(..).partition(is_affected);
            topic.commands = kept;
            changed.extend(commands.iter().map(|command| command.wire.clone()));
            own.commands.extend(commands);
            let (affected, kept): (Vec<_>, _) = topic.types.drain(..).partition(|id| types.contains(id));
            topic.types = kept;
            own.types.extend(affected);
        }
        topics.push(own.clone());
        // What is both repeated and changed is changed.
        let repeated_commands = &self.changed.repeated_commands - &changed;
        let repeated_types = &self.changed.repeated_types - &types;
        Module {
            topic: own,
            spec: Spec { topics, types: self.spec.types.clone() },
            changed,
            repeated_commands,
            repeated_types,
        }
    }

    /// The types that the pack changes, and those that are made of them.
    fn affected_types(&self) -> BTreeSet<TypeId> {
        let mut affected = self.changed.types.clone();
        loop {
            let is_new = |(id, def): &(TypeId, &TypeDef)| {
                !affected.contains(id) && def.kind.parts().any(|part| affected.contains(&part))
            };
            let more: Vec<_> = self.spec.types().filter(is_new).map(|(id, _)| id).collect();
            if more.is_empty() {
                return affected;
            }
            affected.extend(more);
        }
    }
}

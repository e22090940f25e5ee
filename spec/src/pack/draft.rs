//! A spec while a pack is being applied: new items, `[[extend]]` and `[[override]]`.

use std::collections::BTreeSet;
use std::fmt::Display;

use super::robot_status::Lines;
use super::target::{Part, Place, Target, choice, command_mut, list};
use super::{Changed, Covered, covers};
use crate::item::{Item, Placed};
use crate::keys::COMMAND_NAME;
use crate::model::{Command, EnumValue, ErrorCode, Event, Field, Topic, Type, TypeId, TypeKind, Variant};
use crate::report::{At, Report};
use crate::resolve::Index;
use crate::role::MotionMode;
use crate::spec::Spec;
use crate::words::event_code;
use crate::{Source, meaning, read};

/// A spec while a pack is being applied.
pub(super) struct Draft<'s, 'r> {
    pub(super) spec: Spec,
    pub(super) index: Index<'s>,
    pub(super) notes: &'r Report,
    pub(super) codes: Vec<ErrorCode>,
    pub(super) events: Vec<Event>,
    pub(super) changed: Changed,
    pub(super) covered: Covered,
    /// Commands of the spec to which it gives another motion.
    pub(super) motions: BTreeSet<String>,
    /// Entries that change the spec, each with its position, its name and its target, in the order of the file.
    pub(super) edits: Vec<(At<'s>, String, Target)>,
    /// Its lines and entries for what a robot needs.
    pub(super) status: Lines<'s>,
}

const COVERED: &str =
    "the spec has this by now, so the entry changes nothing; delete it once no program uses the names that it gives";

const OPTIONAL_STATUS: &str = "a field of the status packet must be optional: its key may not come, or not fit";

const UNDISPUTED: &str = "`settled` is for a disputed field, and no source disputes this one; it can be deleted";

impl<'s> Draft<'s, '_> {
    /// Adds fields, or values of an enum.
    fn extend(&mut self, item: &Item<'_, 's>) {
        let Some(target) = Target::of(item, &self.spec) else { return };
        let variant = if item.is_text("variant") { item.text("variant") } else { None };
        let mut added = Vec::new();
        for part in target.parts() {
            let fields = item.items(part.key(), "field");
            added.extend(fields.iter().map(|field| self.add_field(item, field, (&target, variant.as_ref(), *part))));
        }
        if variant.is_none() {
            let variants = item.items("variant", "variant");
            added.extend(variants.iter().map(|variant| self.add_variant(variant, &target)));
        }
        if let Target::Type(id) = target {
            added.extend(item.items("value", "value").iter().map(|value| self.add_value(value, id)));
        }
        if added.is_empty() {
            item.error(
                item.at,
                "an extension has fields, `request` or `reply` of a command or `field` of a type, or a `value` or `variant`",
            );
        }
        item.finish();
        if added.contains(&true) {
            self.changed(item, &target);
        } else {
            self.covered.changes.add(&target);
        }
    }

    /// Changes one field or one value, or a fact of a command.
    fn change(&mut self, item: &Item<'_, 's>) {
        let Some(target) = Target::of(item, &self.spec) else { return };
        let variant = item.text("variant");
        if let (Target::Type(id), true) = (&target, item.has("value")) {
            return self.change_value(item, *id);
        }
        let named: Vec<_> = target.parts().iter().filter_map(|part| Some((*part, item.text(part.key())?))).collect();
        match (named.as_slice(), &target) {
            ([(part, name)], _) => self.change_field(item, name, (&target, variant.as_ref(), *part)),
            ([], Target::Command(wire)) => self.change_command(item, wire),
            ([], Target::Type(_)) => item.error(item.at, "`field` or `value` says what is overridden, and is missing"),
            _ => item.error(item.at, "an override is of one field: `request` or `reply`, not both"),
        }
    }

    /// Checks the roles and motions of the spec's commands, of which an entry may have changed the fields or the types.
    pub(super) fn check_motions(&self, base: &Spec, source: Source<'_>, report: &Report) {
        for command in self.spec.commands() {
            let changed = || base.command(&command.wire).and_then(|old| self.changed_field(base, old, command));
            let Some(problem) = meaning::problem(command, self.index.types()).or_else(changed) else { continue };
            let of_command = |target: &Target| matches!(target, Target::Command(wire) if *wire == command.wire);
            let entry = self.edits.iter().find(|(_, _, target)| of_command(target)).or_else(|| self.edits.first());
            let at = entry.map_or(At { source, offset: 0 }, |(at, ..)| *at);
            let hint = match command.motion {
                Some(_) => "; give it another `motion` in an `[[override]]`, or `motion = \"unknown\"`",
                None => "",
            };
            report.error(at, format!("`{}`: {problem}{hint}", command.wire));
        }
    }

    /// Checks which fields are optional, now that all of them are known.
    pub(super) fn check_optional(&self, report: &Report) {
        for (at, what, target) in &self.edits {
            if let Some(problem) = self.optional_problem(target) {
                report.error(*at, format!("{what}: {problem}"));
            }
        }
    }

    /// Reads a file into a separate topic.
    pub(super) fn read(&mut self, root: &Item<'_, 's>, topic: &mut Topic) {
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
            let changed = self.status.read(item, &mut self.spec);
            self.changed.types.extend(changed);
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

    /// The event without the codes of which the spec says as much. Codes of which it says less, the spec then leaves to
    /// the pack.
    fn new_event(&mut self, item: &Item<'_, 's>) -> Option<Event> {
        let mut event = read::event(item, &mut self.index);
        for code in event.codes() {
            if let Some(known) = self.spec.event(code).filter(|known| known.severity != event.severity) {
                let (code, severity) = (event_code(code), known.severity.word());
                item.error(item.at, &format!("the spec has the code {code} already, with the severity `{severity}`"));
            }
        }
        self.events.push(event.clone());
        let adds = event.texts.meaning.is_some();
        let says_as_much = |known: &Event| known.texts.meaning.is_some() || !adds;
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

    /// Adds a field; false if nothing changes.
    fn add_field(&mut self, outer: &Item<'_, 's>, item: &Item<'_, 's>, place: Place<'_, 's>) -> bool {
        let Self { spec, index, .. } = self;
        let Some(list) = list(outer, spec, place) else { return false };
        let new = read::field(item, list.taken.as_deref(), index);
        let keyed = list.taken.is_some();
        let same = list.fields.iter().find(|old| (keyed && old.wire == new.wire) || old.name == new.name);
        match same.map(|old| (old, covers::field(old, &new))) {
            Some((_, Ok(()))) => {
                self.note(item, COVERED);
                return false;
            }
            Some((old, Err(difference))) => item.error(item.at, &taken(old, &new, &difference)),
            None => {}
        }
        list.fields.push(new);
        index.advised(item, list.fields);
        true
    }

    /// Adds a variant to a choice; false if nothing changes.
    fn add_variant(&mut self, item: &Item<'_, 's>, target: &Target) -> bool {
        let Self { spec, index, .. } = self;
        let Some(choice) = choice(spec, target) else {
            item.error(item.at, "`variant` is for a command or a type with variants");
            return false;
        };
        let new = match target {
            Target::Command(_) => {
                let taken = [COMMAND_NAME, &choice.tag];
                read::variant(item, |item| read::fields(item, ("field", "field"), Some(&taken), index))
            }
            Target::Type(_) => read::array_variant(item, index),
        };
        no_roles_of_variants(item, std::slice::from_ref(&new));
        let same = choice.variants.iter().find(|old| old.wire == new.wire || old.name == new.name);
        match same.map(|old| covers::variant(old, &new)) {
            Some(Ok(())) => {
                self.note(item, COVERED);
                return false;
            }
            Some(Err(difference)) => differs(item, &difference),
            None => choice.variants.push(new),
        }
        true
    }

    /// Adds a value to an enum; false if nothing changes.
    fn add_value(&mut self, item: &Item<'_, 's>, id: TypeId) -> bool {
        let repeated = match &mut self.spec.types[id.0].kind {
            TypeKind::IntEnum(values) => {
                let wire = read::wire_int(item).value;
                add_value(item, values, read::enum_value(item, wire))
            }
            TypeKind::TextEnum(values) => {
                let wire = item.required_text("wire").value;
                add_value(item, values, read::enum_value(item, wire))
            }
            _ => {
                item.error(item.at, "`value` is for an enum");
                false
            }
        };
        if repeated {
            self.note(item, COVERED);
        }
        !repeated
    }

    fn change_field(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>, place: Place<'_, 's>) {
        let spec_status = self.spec.status_type();
        let Self { spec, index, .. } = self;
        let Some(mut list) = list(item, spec, place) else { return };
        let fields = &mut *list.fields;
        let renamed = item.text("wire").filter(|_| list.taken.is_some());
        let found = |key: &str| fields.iter().position(|field| is_called(field, key));
        let Some(at) = found(&name.value).or_else(|| found(&renamed.as_ref()?.value)) else {
            let known = fields.iter().map(|field| if field.wire.is_empty() { &*field.name } else { &*field.wire });
            let known: Vec<_> = known.collect();
            item.error(name.at, &format!("there is no field `{}`; there are {}", name.value, known.join(", ")));
            return;
        };
        let new = read::changed_field(item, &fields[at], list.taken.as_deref().unwrap_or_default(), index);
        let mut others = fields.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, other)| other);
        if let Some(other) =
            others.find(|other| other.name == new.name || list.taken.is_some() && other.wire == new.wire)
        {
            let what =
                if other.name == new.name { format!("name `{}`", new.name) } else { format!("key `{}`", new.wire) };
            item.error(item.at, &format!("another field has the {what}"));
        }
        let old = &fields[at];
        if new == *old {
            self.note(item, COVERED);
            return self.covered.changes.add(place.0);
        }
        if place.0.type_id().is_some_and(|id| spec_status == Some(id)) {
            self.status.note(&old.name, item);
        }
        let is_undisputed = old.disputed.is_empty();
        let (old_name, new_name) = (list.fields[at].name.clone(), new.name.clone());
        list.replace(at, new);
        index.advised(item, list.fields);
        if item.has("settled") && is_undisputed {
            self.note(item, UNDISPUTED);
        }
        if let (Target::Command(wire), Part::Request) = (place.0, place.2) {
            let motion = command_mut(&mut self.spec.topics, wire).and_then(|command| command.motion.as_mut());
            if let Some(motion) = motion {
                motion.rename(&old_name, &new_name);
            }
        }
        self.changed(item, place.0);
    }

    fn change_value(&mut self, item: &Item<'_, 's>, id: TypeId) {
        let name = self.spec[id].name.clone();
        let changed = match &mut self.spec.types[id.0].kind {
            TypeKind::IntEnum(values) => item.int("value").and_then(|wire| changed_value(item, values, &wire)),
            TypeKind::TextEnum(values) => item.text("value").and_then(|wire| changed_value(item, values, &wire)),
            _ => return item.error(item.at, &format!("`{name}` is not an enum")),
        };
        match changed {
            Some(true) => self.changed(item, &Target::Type(id)),
            Some(false) => {
                self.note(item, COVERED);
                self.covered.changes.add(&Target::Type(id));
            }
            None => {}
        }
    }

    fn change_command(&mut self, item: &Item<'_, 's>, wire: &str) {
        let Some(command) = command_mut(&mut self.spec.topics, wire) else { return };
        let before = command.clone();
        command.deadline = read::deadline(item).or(command.deadline);
        command.versions = read::versions(item, &before.versions);
        if item.is_text("motion") {
            let word = item.text("motion").filter(|word| word.value != "unknown");
            if let Some(word) = word {
                item.error(
                    word.at,
                    "`motion` is a table, or `unknown` where the command's motion cannot be told any more",
                );
            }
            command.motion = None;
        } else if item.has("motion") {
            command.motion = read::motion(item);
            self.motions.insert(wire.to_owned());
        }
        if item.has("doc") {
            command.doc = read::required_doc(item);
        }
        let same = *command == before;
        item.finish();
        let target = Target::Command(wire.to_owned());
        if same {
            self.note(item, COVERED);
            self.covered.changes.add(&target);
        } else {
            self.changed(item, &target);
        }
    }

    fn changed(&mut self, item: &Item<'_, 's>, target: &Target) {
        self.edits.push((item.at, item.what.clone(), target.clone()));
        if let Target::Type(id) = target {
            self.index.define(self.spec[*id].clone());
        }
        self.changed.add(target);
    }

    /// The field of a motion that means something else than in the base, where the pack says nothing of the motion.
    fn changed_field(&self, base: &Spec, old: &Command, command: &Command) -> Option<String> {
        let motion = command.motion.as_ref().filter(|_| !self.motions.contains(&command.wire))?;
        // Fields keep their places; those that a pack adds come after them.
        let mut pairs = old.request.fields().zip(command.request.fields());
        let is_alike = |new: &Field| match motion.mode.as_ref().filter(|mode| mode.field == new.name) {
            Some(mode) => same_values(base, &self.spec, &new.ty, mode),
            None => self.spec.defines_as(base, &new.ty),
        };
        let is_changed = |old: &Field, new: &Field| old.ty != new.ty || old.unit != new.unit || !is_alike(new);
        let (_, new) = pairs.find(|(old, new)| motion.names(&new.name) && is_changed(old, new))?;
        Some(format!("its motion names the field `{}`, whose type or unit this pack changes", new.name))
    }

    fn optional_problem(&self, target: &Target) -> Option<&'static str> {
        let in_order = |fields: &[Field]| fields.windows(2).all(|pair| !pair[0].optional || pair[1].optional);
        let is_right = match target {
            Target::Command(wire) => {
                let command = self.spec.command(wire)?;
                let is_wrong = !command.reply_certain && command.reply.own_fields().iter().any(|field| !field.optional);
                return is_wrong.then_some(read::OPTIONAL_ONLY);
            }
            Target::Type(id) => match &self.spec[*id].kind {
                // One that does not fit is left out of the packet.
                TypeKind::Object(fields) if self.spec.status_type() == Some(*id) => {
                    return fields.iter().any(|field| !field.optional).then_some(OPTIONAL_STATUS);
                }
                TypeKind::Array { fields, .. } => in_order(fields),
                TypeKind::Choice(choice) => choice.variants.iter().all(|variant| in_order(&variant.fields)),
                _ => true,
            },
        };
        (!is_right).then_some(read::OPTIONAL_LAST)
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

/// True if the values of a motion's mode have the names in Rust that they have in the base. There may be others by now.
fn same_values(base: &Spec, spec: &Spec, ty: &Type, mode: &MotionMode) -> bool {
    let Some(id) = ty.named() else { return false };
    let name = |spec: &Spec, wire: i64| match &spec[id].kind {
        TypeKind::IntEnum(values) => values.iter().find(|value| value.wire == wire).map(|value| value.name.clone()),
        _ => None,
    };
    [Some(mode.absolute), mode.offset].into_iter().flatten().all(|wire| name(base, wire) == name(spec, wire))
}

fn taken(old: &Field, new: &Field, difference: &str) -> String {
    if old.wire == new.wire {
        format!(
            "the spec has it by now, and there {difference}; delete the entry, and change the rest with `[[override]]`"
        )
    } else {
        format!("the name `{}` is that of the key `{}`; give another as `name`", old.name, old.wire)
    }
}

fn is_called(field: &Field, name: &str) -> bool {
    if field.wire.is_empty() { field.name == name } else { field.wire == name }
}

/// Changes a value of an enum: whether it is another now, or nothing after an error.
fn changed_value<'s, T: PartialEq + Clone + Display>(
    item: &Item<'_, 's>,
    values: &mut [EnumValue<T>],
    wire: &Placed<'s, T>,
) -> Option<bool> {
    let known: Vec<_> = values.iter().map(|value| value.wire.to_string()).collect();
    let Some(at) = values.iter().position(|value| value.wire == wire.value) else {
        item.error(wire.at, &format!("there is no value `{}`; there are {}", wire.value, known.join(", ")));
        return None;
    };
    let new = read::changed_value(item, &values[at]);
    if values.iter().enumerate().any(|(i, other)| i != at && other.name == new.name) {
        item.error(item.at, &format!("another value has the name `{}`", new.name));
    }
    let is_other = new != values[at];
    values[at] = new;
    Some(is_other)
}

/// Adds a value; true if it is there already.
fn add_value<T: PartialEq>(item: &Item<'_, '_>, values: &mut Vec<EnumValue<T>>, new: EnumValue<T>) -> bool {
    let old = values.iter().find(|old| old.wire == new.wire || old.name == new.name);
    match old {
        Some(old) if old.wire == new.wire && old.name == new.name => return true,
        Some(_) => item.error(item.at, "the spec has a value of this name or number already"),
        None => values.push(new),
    }
    false
}

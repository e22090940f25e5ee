//! The checks that need all files: references between them, and unique names.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use crate::item::{Item, Placed, Unique};
use crate::keys::ENVELOPE;
use crate::model::{Command, Effect, Field, Request, Type, TypeDef, TypeId, TypeKind};
use crate::names::{RESERVED_METHODS, RESERVED_TYPES, to_camel, to_screaming, trait_name};
use crate::report::{At, Report};
use crate::spec::Spec;
use crate::type_text::notation;
use crate::words::event_code;
use crate::{advice, meaning};

/// Message for a field that cannot have `constructors`.
pub(crate) const NO_ENUM: &str = "`constructors` is for a field whose type is an enum";

/// Index of the definitions and uses in the files, gathered while they are read.
#[derive(Debug, Default)]
pub(crate) struct Index<'s> {
    commands: Unique<'s, String>,
    sections: Unique<'s, String>,
    methods: Unique<'s, String>,
    type_names: Unique<'s, String>,
    error_wires: Unique<'s, i64>,
    error_names: Unique<'s, String>,
    /// Ranges of codes of events by their first code, each with its last one and its place.
    event_codes: BTreeMap<u32, (u32, At<'s>)>,
    event_families: Unique<'s, String>,
    /// All types that are defined or used, each at the place of its id; without content as long as it is not defined.
    types: Vec<TypeDef>,
    defined: BTreeSet<TypeId>,
    needs: Vec<(String, Placed<'s, Need>)>,
    /// Settings that queries may remember.
    settings: BTreeMap<String, Command>,
    /// The trait with a pack's methods.
    own_trait: Option<String>,
}

/// Condition that must hold once all files are read.
#[derive(Debug)]
pub(crate) enum Need {
    /// The type exists, and is not too large.
    Type(Type),
    /// The type is an enum.
    Enum(TypeId),
    /// The type is an object whose keys may be next to the keys of every reply.
    Reply(TypeId),
    /// The advised limits of these fields, which stand next to each other, make sense.
    Advised(Vec<Field>),
    /// The setting that the query remembers has fields of its reply.
    Remembers(Box<Command>),
    /// The command's role and motion fit its fields.
    Meaning(Box<Command>),
    /// The family of events exists.
    EventFamily(String),
}

impl<'s> Index<'s> {
    /// Index of a spec to which the pack `module` adds.
    pub(crate) fn of(base: &Spec, module: &str) -> Self {
        let commands = || base.commands();
        let messages = commands().flat_map(|command| message_types(&command.name));
        let mut index = Self {
            commands: Unique::taken(commands().map(|command| command.wire.clone())),
            sections: Unique::taken(commands().filter_map(|command| command.section.clone())),
            methods: Unique::taken(commands().map(|command| command.name.clone())),
            type_names: Unique::taken(messages.chain(base.types.iter().map(|def| def.name.clone()))),
            error_wires: Unique::taken(base.errors().map(|code| code.wire)),
            error_names: Unique::taken(base.errors().map(|code| code.name.clone())),
            event_families: Unique::taken(base.event_families().map(|family| family.name.clone())),
            own_trait: Some(trait_name(module)),
            settings: commands()
                .filter(|command| is_setting(command))
                .map(|command| (command.wire.clone(), command.clone()))
                .collect(),
            ..Self::default()
        };
        for def in &base.types {
            index.define(def.clone());
        }
        index
    }

    /// An index for reading again what the spec has, in which no other name is taken. Types have the same ids.
    pub(crate) fn again(&self) -> Self {
        Self { types: self.types.clone(), ..Self::default() }
    }

    /// The types, each at the place of its id. After [`check`], all that are used are defined.
    pub(crate) fn finish(self) -> Vec<TypeDef> {
        self.types
    }

    pub(crate) fn command(
        &mut self,
        item: &Item<'_, 's>,
        wire: &Placed<'s, String>,
        section: Option<&Placed<'s, String>>,
    ) {
        self.commands.add(item, "cmdName", wire);
        if let Some(section) = section {
            self.sections.add(item, "section", section);
        }
    }

    /// Takes note of a command that a query may remember.
    pub(crate) fn setting(&mut self, command: &Command) {
        if is_setting(command) {
            self.settings.insert(command.wire.clone(), command.clone());
        }
    }

    /// A command's method, and the types that come with it.
    pub(crate) fn method(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>) {
        self.methods.add(item, "method name", name);
        if RESERVED_METHODS.contains(&name.value.as_str()) {
            item.error(name.at, &format!("clients and robots have a method `{}`; give another as `name`", name.value));
        }
        for value in message_types(&name.value) {
            self.type_name(item, &Placed { at: name.at, value });
        }
    }

    pub(crate) fn type_name(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>) {
        let is_own_trait = self.own_trait.as_ref() == Some(&name.value);
        if is_own_trait || RESERVED_TYPES.contains(&name.value.as_str()) {
            item.error(
                name.at,
                &format!("`{}` is a name of Rust or of the generated code; take another `name`", name.value),
            );
        }
        self.type_names.add(item, "type name", name);
    }

    /// The id of a type, also before it is defined.
    pub(crate) fn type_id(&mut self, name: &str) -> TypeId {
        let found = self.types.iter().position(|known| known.name == name);
        TypeId(found.unwrap_or_else(|| {
            let kind = TypeKind::Object(Vec::new());
            self.types.push(TypeDef { name: name.to_owned(), doc: String::new(), kind });
            self.types.len() - 1
        }))
    }

    /// Takes the definition of a type.
    pub(crate) fn define(&mut self, def: TypeDef) -> TypeId {
        let id = self.type_id(&def.name);
        self.types[id.0] = def;
        self.defined.insert(id);
        id
    }

    /// All types that are defined or used, each at the place of its id.
    pub(crate) fn types(&self) -> &[TypeDef] {
        &self.types
    }

    pub(crate) fn definition(&self, id: TypeId) -> &TypeDef {
        &self.types[id.0]
    }

    pub(crate) fn needs(&mut self, item: &Item<'_, 's>, at: At<'s>, value: Need) {
        self.needs.push((item.what.clone(), Placed { at, value }));
    }

    pub(crate) fn advised(&mut self, item: &Item<'_, 's>, fields: &[Field]) {
        if fields.iter().any(|field| !field.advised.is_empty()) {
            self.needs(item, item.at, Need::Advised(fields.to_vec()));
        }
    }

    pub(crate) fn error_code(&mut self, item: &Item<'_, 's>, wire: &Placed<'s, i64>, name: &Placed<'s, String>) {
        self.error_wires.add(item, "code", wire);
        // A pack's module has a constant of this name next to its types.
        let constant = Placed { at: name.at, value: to_screaming(&name.value) };
        if self.error_names.add(item, "name", name) {
            self.type_names.add(item, "constant", &constant);
        }
    }

    /// A family of events, none of which has another's name.
    pub(crate) fn event_family(&mut self, item: &Item<'_, 's>, name: &Placed<'s, String>) {
        self.event_families.add(item, "family", name);
    }

    /// The codes of an event, none of which another event may have.
    pub(crate) fn event_codes(&mut self, item: &Item<'_, 's>, codes: &Placed<'s, RangeInclusive<u32>>) {
        let (first, last) = (*codes.value.start(), *codes.value.end());
        // Ranges that were added do not overlap, so the last one that begins before the end is the one to look at.
        match self.event_codes.range(..=last).next_back() {
            Some((begin, (end, at))) if *end >= first => {
                let code = event_code(first.max(*begin));
                item.error(codes.at, &format!("the code {code} is taken already, at {at}"));
            }
            _ => {
                self.event_codes.insert(first, (last, codes.at));
            }
        }
    }
}

/// True for a setting whose requests have the same fields each time.
fn is_setting(command: &Command) -> bool {
    command.effect == Effect::Setting && matches!(command.request, Request::Fields(_))
}

/// The types that come with the command of this name: its request and, if it has one, its reply.
fn message_types(command: &str) -> [String; 2] {
    let request = to_camel(command);
    [request.clone() + "Reply", request]
}

/// Runs the checks that need all files.
pub(crate) fn check(index: &Index<'_>, report: &Report) {
    // What goes through the parts of types would not end on one that contains itself, which is an error of its own.
    let has_ends = (0..index.types.len()).all(|id| !reaches_itself(index, TypeId(id)));
    for (what, Placed { at, value }) in &index.needs {
        let problem = match value {
            Need::Type(ty) => type_problem(index, ty),
            Need::Enum(id) => (!is_enum(&index.types[id.0].kind)).then(|| NO_ENUM.to_owned()),
            Need::Reply(id) if !index.defined.contains(id) => None,
            Need::Reply(id) => (!can_be_reply(&index.types[id.0].kind)).then(|| NO_REPLY.to_owned()),
            Need::Advised(fields) if has_ends => advice::problem(fields, &index.types),
            Need::Advised(_) => None,
            Need::Remembers(query) => meaning::remembers_problem(query, &index.settings, &index.types),
            Need::Meaning(command) => meaning::problem(command, &index.types),
            Need::EventFamily(name) => {
                (!index.event_families.has(name)).then(|| format!("there is no `[[event_family]]` named `{name}`"))
            }
        };
        if let Some(problem) = problem {
            report.error(*at, format!("{what}: {problem}"));
        }
    }
}

fn type_problem(index: &Index<'_>, ty: &Type) -> Option<String> {
    if let Some(id) = ty.named() {
        let name = &index.types[id.0].name;
        if !index.defined.contains(&id) {
            return Some(format!("there is no `[[type]]` named `{name}`"));
        }
        if reaches_itself(index, id) {
            return Some(format!("the type `{name}` contains itself"));
        }
    }
    weight(index, ty, 0).is_none().then(|| {
        let ty = notation(ty, &|id| &index.types[id.0].name);
        format!("the type `{ty}` holds more than {MOST_VALUES} values, or more than {MOST_LEVELS} types in each other")
    })
}

fn is_enum(kind: &TypeKind) -> bool {
    matches!(kind, TypeKind::IntEnum(_) | TypeKind::TextEnum(_))
}

const NO_REPLY: &str = "a reply is fields, or an object without the keys that every reply has";

fn can_be_reply(kind: &TypeKind) -> bool {
    matches!(kind, TypeKind::Object(fields) if fields.iter().all(|field| !ENVELOPE.contains(&&*field.wire)))
}

fn reaches_itself(index: &Index<'_>, id: TypeId) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![id];
    while let Some(next) = open.pop() {
        for part in index.types[next.0].kind.parts() {
            if part == id {
                return true;
            }
            if seen.insert(part) {
                open.push(part);
            }
        }
    }
    false
}

/// Greatest number of values in a type: they lie side by side in memory.
const MOST_VALUES: usize = 4096;

/// Greatest depth to which types may nest.
const MOST_LEVELS: usize = 32;

/// Number of values in the type, an array of any length counted as one element; none if there are too many.
fn weight(index: &Index<'_>, ty: &Type, level: usize) -> Option<usize> {
    if level > MOST_LEVELS {
        return None;
    }
    let weight = match ty {
        Type::List(element) | Type::Python(element) => weight(index, element, level + 1)?,
        Type::Array(element, len) => weight(index, element, level + 1)? * len,
        Type::Named(id) => {
            let mut sum = 0;
            for part in index.types[id.0].kind.types() {
                sum += weight(index, part, level + 1)?;
                if sum > MOST_VALUES {
                    return None;
                }
            }
            sum.max(1)
        }
        Type::Scalar(_) => 1,
    };
    Some(weight).filter(|weight| *weight <= MOST_VALUES)
}

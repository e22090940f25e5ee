//! Target of an entry of a pack, and the fields there.

use crate::advice;
use crate::item::{Item, Placed};
use crate::keys::{COMMAND_NAME, ENVELOPE};
use crate::model::{Choice, Command, Field, Reply, Request, Topic, TypeDef, TypeId, TypeKind};
use crate::names::nearest;
use crate::spec::Spec;

/// Target of an entry: a command by its `cmdName`, or a type by its name.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Target {
    Command(String),
    Type(TypeId),
}

/// Part of a target that has the fields that an entry names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Request,
    Reply,
    Type,
}

/// The target of an entry, its `variant`, and the part of the target that is changed.
pub(super) type Place<'p, 's> = (&'p Target, Option<&'p Placed<'s, String>>, Part);

/// Fields that a pack changes.
pub(super) struct List<'f> {
    pub(super) fields: &'f mut Vec<Field>,
    /// Keys that no field may have; elements of an array have no keys.
    pub(super) taken: Option<Vec<&'f str>>,
    /// The name of the field that a bare reply stands for.
    bare_reply: Option<&'f mut String>,
}

impl Target {
    /// The target of an entry, or an error if the spec does not have it.
    pub(super) fn of(item: &Item<'_, '_>, spec: &Spec) -> Option<Self> {
        let name = item.required_text("target");
        if spec.command(&name.value).is_some() {
            return Some(Self::Command(name.value));
        }
        if let Some(id) = spec.type_id(&name.value) {
            return Some(Self::Type(id));
        }
        let known = spec.commands().map(|command| &*command.wire).chain(spec.types.iter().map(|def| &*def.name));
        let hint = nearest(&name.value, known).map(|near| format!("; there is `{near}`")).unwrap_or_default();
        if !name.value.is_empty() {
            item.error(name.at, &format!("the spec has no command and no type `{}`{hint}", name.value));
        }
        None
    }

    /// The type that it is.
    pub(super) fn type_id(&self) -> Option<TypeId> {
        if let Self::Type(id) = self { Some(*id) } else { None }
    }

    /// Parts that have fields.
    pub(super) fn parts(&self) -> &'static [Part] {
        match self {
            Self::Command(_) => &[Part::Request, Part::Reply],
            Self::Type(_) => &[Part::Type],
        }
    }
}

impl Part {
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Request => "request",
            Self::Reply => "reply",
            Self::Type => "field",
        }
    }
}

impl<'f> List<'f> {
    fn object(fields: &'f mut Vec<Field>, taken: &[&'f str]) -> Self {
        Self { fields, taken: Some(taken.to_vec()), bare_reply: None }
    }

    fn array(fields: &'f mut Vec<Field>) -> Self {
        Self { fields, taken: None, bare_reply: None }
    }

    fn reply(fields: &'f mut Vec<Field>, bare_reply: Option<&'f mut String>) -> Self {
        Self { bare_reply, ..Self::object(fields, ENVELOPE) }
    }

    /// Puts a field in another's place.
    pub(super) fn replace(&mut self, at: usize, new: Field) {
        if let Some(name) = self.bare_reply.as_mut().filter(|name| ***name == self.fields[at].name) {
            new.name.clone_into(name);
        }
        let old = std::mem::replace(&mut self.fields[at], new);
        let new = self.fields[at].name.clone();
        advice::rename(self.fields, &old.name, &new);
    }
}

/// The fields at a place, or an error if there can be none.
pub(super) fn list<'f, 's>(
    item: &Item<'_, 's>,
    spec: &'f mut Spec,
    (target, variant, part): Place<'_, 's>,
) -> Option<List<'f>> {
    let (choice, keyed) = match target {
        Target::Command(wire) => {
            let Command { request, reply, bare_reply, .. } = command_mut(&mut spec.topics, wire)?;
            if part == Part::Reply {
                return match reply {
                    Reply::Fields(fields) => Some(List::reply(fields, bare_reply.as_mut())),
                    Reply::Object(id) => {
                        let name = &spec.types[id.0].name;
                        item.error(item.at, &format!("the reply is a `{name}`; change that type"));
                        None
                    }
                    Reply::Raw => {
                        item.error(item.at, "the reply is raw JSON, without fields");
                        None
                    }
                };
            }
            match request {
                Request::Fields(fields) => return Some(List::object(fields, &[COMMAND_NAME])),
                Request::Choice(choice) => (choice, true),
            }
        }
        Target::Type(id) => match &mut spec.types[id.0] {
            TypeDef { kind: TypeKind::Object(fields), .. } => {
                let is_reply =
                    spec.topics.iter().flat_map(|topic| &topic.commands).any(|c| c.reply == Reply::Object(*id));
                return Some(List::object(fields, if is_reply { ENVELOPE } else { &[] }));
            }
            TypeDef { kind: TypeKind::Array { fields, .. }, .. } => return Some(List::array(fields)),
            TypeDef { kind: TypeKind::Choice(choice), .. } => (choice, false),
            TypeDef { name, .. } => {
                item.error(item.at, &format!("`{name}` has no fields"));
                return None;
            }
        },
    };
    let Choice { tag, variants } = choice;
    let known: Vec<_> = variants.iter().map(|variant| variant.name.clone()).collect();
    let found = variant.and_then(|name| variants.iter_mut().find(|variant| variant.name == name.value));
    if found.is_none() {
        let at = variant.map_or(item.at, |variant| variant.at);
        item.error(at, &format!("`variant` says which variant is meant: one of {}", known.join(", ")));
    }
    let fields = &mut found?.fields;
    Some(if keyed { List::object(fields, &[COMMAND_NAME, tag]) } else { List::array(fields) })
}

/// The choice that a target is.
pub(super) fn choice<'s>(spec: &'s mut Spec, target: &Target) -> Option<&'s mut Choice> {
    match target {
        Target::Command(wire) => match &mut command_mut(&mut spec.topics, wire)?.request {
            Request::Choice(choice) => Some(choice),
            Request::Fields(_) => None,
        },
        Target::Type(id) => match &mut spec.types[id.0].kind {
            TypeKind::Choice(choice) => Some(choice),
            _ => None,
        },
    }
}

pub(super) fn command_mut<'t>(topics: &'t mut [Topic], wire: &str) -> Option<&'t mut Command> {
    topics.iter_mut().flat_map(|topic| &mut topic.commands).find(|command| command.wire == wire)
}

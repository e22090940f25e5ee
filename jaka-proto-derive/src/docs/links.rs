//! What docs link to.

use jaka_spec::{Command, Module, Reply, Spec, Topic};

/// The place of docs: what they link the names of commands to.
#[derive(Clone, Copy)]
pub(crate) struct Docs<'s> {
    pub(super) spec: &'s Spec,
    place: Place<'s>,
    /// The command whose docs they are. There, its own name is not a link.
    command: Option<&'s Command>,
}

/// Where docs stand.
#[derive(Clone, Copy)]
pub(crate) enum Place<'s> {
    /// `messages` of jaka-proto, or the module of a topic in it: links lead to requests.
    Messages(Option<&'s Topic>),
    /// The module of a pack: the same, and requests link to their methods.
    Pack(&'s Module),
    /// jaka-sync: links lead to methods of the client.
    Client,
    /// The user's own type: no links.
    User,
}

impl<'s> Docs<'s> {
    pub(crate) fn new(spec: &'s Spec, place: Place<'s>) -> Self {
        Self { spec, place, command: None }
    }

    /// The docs of this command.
    pub(crate) fn of_command(self, command: &'s Command) -> Self {
        Self { command: Some(command), ..self }
    }

    /// What the name of a command is linked to.
    pub(super) fn target(self, name: &str) -> Option<String> {
        let command = self.spec.command_called(name)?;
        if self.command.is_some_and(|own| own.wire == command.wire) {
            return None;
        }
        match self.place {
            Place::Messages(_) | Place::Pack(_) => Some(self.request(command)),
            Place::Client => Some(format!("crate::Client::{}", command.name)),
            Place::User => None,
        }
    }

    /// The path of a command's request, as a link.
    pub(super) fn request(self, command: &Command) -> String {
        let is_there = |topic: &Topic| topic.commands.iter().any(|other| other.wire == command.wire);
        self.path(is_there, &command.request_type())
    }

    /// A link to the type of a command's reply, if the reply carries data.
    pub(super) fn reply(self, command: &Command) -> Option<String> {
        let Reply::Object(id) = &command.reply else {
            return command.reply_type().map(|reply| format!("[`{reply}`]"));
        };
        let name = &self.spec[*id].name;
        let path = self.path(|topic| topic.types.contains(id), name);
        Some(if path.contains("::") { format!("[`{name}`]({path})") } else { format!("[`{path}`]") })
    }

    /// The path of a type, as a link. A derive macro may have the name too.
    fn path(self, is_there: impl Fn(&Topic) -> bool, name: &str) -> String {
        let (own, elsewhere) = match self.place {
            Place::Messages(topic) => (topic, "crate::messages"),
            Place::Pack(module) => (Some(&module.topic), "proto::messages"),
            Place::Client | Place::User => (None, "crate"),
        };
        match self.spec.topics.iter().find(|topic| is_there(topic)) {
            Some(topic) if !own.is_some_and(is_there) => {
                // The modules of packs stand next to each other.
                let elsewhere = if topic.is_pack { "super" } else { elsewhere };
                format!("{elsewhere}::{}::{name}", topic.name)
            }
            _ => format!("type@{name}"),
        }
    }

    /// The method of a pack's command, where its trait stands in the same module.
    pub(super) fn trait_method(self, command: &Command) -> Option<String> {
        let Place::Pack(module) = self.place else { return None };
        Some(format!("{}::{}", module.trait_name(), module.method(command)))
    }

    /// The type that has the ranges that can be switched off.
    pub(super) fn advisory_ranges(self) -> &'static str {
        match self.place {
            Place::User => "`AdvisoryRanges`",
            Place::Messages(_) | Place::Pack(_) | Place::Client => "[`AdvisoryRanges`](check::AdvisoryRanges)",
        }
    }
}

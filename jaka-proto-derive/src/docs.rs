//! The documentation of the generated items.
//!
//! Text of the spec or of a pack is prose alone: rustdoc would test code, and pass on HTML. In it, commands are links
//! to their items.

use jaka_spec::prose::{code_span, linked_prose, shown};
use jaka_spec::words::{self, first_sentence};
use jaka_spec::{Command, Effect, Field, Module, Reply, Spec, Topic, TypeKind, evidence_sentence};
use proc_macro2::TokenStream;
use quote::quote;

/// The place of docs, and the targets of their links for names of commands.
#[derive(Clone, Copy)]
pub(crate) struct Docs<'s> {
    spec: &'s Spec,
    place: Place<'s>,
    /// The command of the docs. There, its own name is not a link.
    command: Option<&'s Command>,
}

/// Place of the docs, which decides the items that their links lead to.
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

const OR_RAW: &str = "\n\nThe sources leave doubt about the shape: a value of another shape is kept as raw JSON.";

impl<'s> Docs<'s> {
    pub(crate) fn new(spec: &'s Spec, place: Place<'s>) -> Self {
        Self { spec, place, command: None }
    }

    /// The docs of this command.
    pub(crate) fn of_command(self, command: &'s Command) -> Self {
        Self { command: Some(command), ..self }
    }

    /// Text of the spec or of a pack as doc attributes.
    pub(crate) fn attributes(self, text: &str) -> TokenStream {
        own(&self.prose(text))
    }

    /// Docs of a topic, as inner attributes of its module: rustdoc looks up their links inside the module.
    pub(crate) fn topic(self, topic: &Topic) -> TokenStream {
        let text = self.prose(&format!("{}.\n\n{}", topic.title, topic.doc));
        let lines = lines(&text);
        quote!(#(#![doc = #lines])*)
    }

    /// The heading over the methods of a topic's commands.
    pub(crate) fn heading(self, topic: &Topic) -> TokenStream {
        let (title, name) = (self.prose(&topic.title), &topic.name);
        own(&format!("# {title}\n\nWith the messages of [`{name}`](crate::{name})."))
    }

    /// Docs of a field: its meaning, its unit and range, its spelling on the wire, and the points on which sources
    /// disagree.
    pub(crate) fn field(self, fields: &[Field], field: &Field) -> TokenStream {
        let (_, rest) = first_sentence(&field.doc);
        let (paragraph, others) = rest.split_at(rest.find("\n\n").unwrap_or(rest.len()));
        let text = self.summary(field, paragraph) + &self.prose(others);
        let advisory = field.range.advisory.then(|| {
            let ranges = self.advisory_ranges();
            format!("\n\nNewer firmware takes more than this range, which can be switched off: see {ranges}.")
        });
        let advised = words::advised(self.spec, fields, field, |other| other.name.clone()).map(|advised| {
            let ranges = self.advisory_ranges();
            let advised = self.prose(&format!("Advised: {advised}."));
            format!("\n\n{advised} Anything else is refused unless that is left to the controller: see {ranges}.")
        });
        let ascii = field.ascii.then(|| "\n\nPrintable ASCII only.".to_owned());
        let disputed = (!field.disputed.is_empty()).then(|| {
            let readings = list(&field.disputed);
            format!(
                "\n\nSources contradict each other on the meaning, so the value is passed on as it is:\n\n{readings}"
            )
        });
        let or_raw = field.or_raw.then(|| OR_RAW.to_owned());
        let more: String = [ascii, disputed, or_raw, versions(&field.versions)].into_iter().flatten().collect();
        let docs = own(&(text + &advisory.unwrap_or_default() + &advised.unwrap_or_default() + &self.prose(&more)));
        let alias = alias(&field.wire, &field.name);
        quote!(#docs #alias)
    }

    /// Docs of a setter: a summary of its field, which has the full docs.
    pub(crate) fn setter(self, field: &Field) -> TokenStream {
        let docs = own(&self.summary(field, ""));
        let alias = alias(&field.wire, &field.name);
        quote!(#docs #alias)
    }

    /// Docs of a constructor: the value that it makes, and the units of its arguments, which are the required fields.
    pub(crate) fn constructor(self, doc: &str, fields: &[Field]) -> TokenStream {
        let first = self.attributes(first_sentence(doc).0);
        let required = fields.iter().filter(|field| !field.optional);
        let measured = required.filter_map(|field| {
            let measure = self.measure(field)?;
            Some(format!("`{}`: {}{}", field.name, measure[..1].to_lowercase(), measure[1..].trim_end_matches('.')))
        });
        let measured: Vec<_> = measured.collect();
        let list = (!measured.is_empty()).then(|| self.attributes(&format!("\n{}", list(&measured))));
        quote!(#first #list)
    }

    /// Docs of a request: its effect, the message that is sent, the requirements and the reply.
    pub(crate) fn request_type(self, command: &'s Command) -> TokenStream {
        let reply = self.reply(command).map(|reply| format!(" The reply is {reply}."));
        let method = self.trait_method(command).map(|method| format!(" The method is [`{method}`]."));
        let links = reply.unwrap_or_default() + &method.unwrap_or_default();
        own(&self.about(command, &code_span(&command.wire), &links))
    }

    /// Docs of a reply: the request that it answers.
    pub(crate) fn reply_type(self, command: &Command) -> TokenStream {
        own(&format!("What the controller answers to [`{}`].", self.request(command)))
    }

    /// Docs of a method: those of its request, with examples, and with errors that refer to those of `call`. `code`
    /// returns the lines of a program that send the message of an example.
    pub(crate) fn method(self, command: &'s Command, call: &str, code: impl Fn(&str) -> Option<String>) -> TokenStream {
        let (path, name) = (self.request(command), code_span(&command.wire));
        let sent =
            if command.wire == command.request_type() { format!("[`{path}`]") } else { format!("[{name}]({path})") };
        let about = self.about(command, &sent, "");
        let examples = examples(command, code);
        own(&format!("{about}{examples}\n\n# Errors\nAs {call}.{}", refusal(command)))
    }

    fn prose(self, text: &str) -> String {
        linked_prose(text, |name| self.target(name))
    }

    /// The first sentence, unit and range, the rest of the paragraph, and the spelling on the wire, without commands.
    fn summary(self, field: &Field, rest: &str) -> String {
        let measure = self.measure(field).map(|measure| format!(" {measure}")).unwrap_or_default();
        let text = self.prose(&format!("{}{measure}{rest}", first_sentence(&field.doc).0));
        if field.wire == field.name || field.wire.is_empty() {
            return text;
        }
        format!("{text} {} on the wire.", code_span(&field.wire))
    }

    /// `In deg/s, at least 0.`
    fn measure(self, field: &Field) -> Option<String> {
        let unit = field.unit.as_deref().or_else(|| self.unit_of_type(field));
        match (unit, words::range(field.range)) {
            (Some(unit), Some(range)) => Some(format!("In {unit}, {range}.")),
            (Some(unit), None) => Some(format!("In {unit}.")),
            (None, Some(range)) => Some(capitalised(&range) + "."),
            (None, None) => None,
        }
    }

    /// The unit of all numbers of the field's type, where that has one.
    fn unit_of_type(self, field: &Field) -> Option<&'s str> {
        match &self.spec[field.ty.named()?].kind {
            TypeKind::Wrapper(_, unit) => unit.as_deref(),
            _ => None,
        }
    }

    /// Link target for the name of a command; `None` for a name without a link.
    fn target(self, name: &str) -> Option<String> {
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
    fn request(self, command: &Command) -> String {
        let is_there = |topic: &Topic| topic.commands.iter().any(|other| other.wire == command.wire);
        self.path(is_there, &command.request_type())
    }

    /// A link to the type of a command's reply, if the reply carries data.
    fn reply(self, command: &Command) -> Option<String> {
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

    /// The method of a pack's command, if its trait is in the same module.
    fn trait_method(self, command: &Command) -> Option<String> {
        let Place::Pack(module) = self.place else { return None };
        Some(format!("{}::{}", module.trait_name(), module.method(command)))
    }

    /// The type that has the ranges that can be switched off.
    fn advisory_ranges(self) -> &'static str {
        match self.place {
            Place::User => "`AdvisoryRanges`",
            Place::Messages(_) | Place::Pack(_) | Place::Client => "[`AdvisoryRanges`](check::AdvisoryRanges)",
        }
    }

    /// Effect of a command, with its message and its requirements. `sent` names the message; `links` lead to related
    /// items.
    fn about(self, command: &'s Command, sent: &str, links: &str) -> String {
        let docs = self.of_command(command);
        let section = command.section.as_ref().map(|section| format!(" ({section})")).unwrap_or_default();
        let changes = if command.effect == Effect::Query { " Changes nothing on the robot." } else { "" };
        let needs = words::requirements(&command.requires).map(|needs| format!(" The robot must be {needs}."));
        let sends = format!("\n\nSends {sent}{section}.{changes}{}{links}", needs.unwrap_or_default());
        docs.prose(&command.doc) + &sends + &docs.prose(&remarks(command))
    }
}

/// Text of our own, which may have links, as doc attributes, one for each line. What it has of the spec's is a name in
/// Rust or a code span.
pub(crate) fn own(text: &str) -> TokenStream {
    let lines = lines(text);
    quote!(#(#[doc = #lines])*)
}

fn lines(text: &str) -> impl Iterator<Item = String> {
    text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") })
}

/// An alias under which rustdoc's search finds the item `name` by its spelling on the wire, where rustdoc takes that.
pub(crate) fn alias(wire: &str, name: &str) -> TokenStream {
    let is_alias =
        wire.trim() == wire && !wire.contains(|c: char| matches!(c, '"' | '\'') || c.is_whitespace() && c != ' ');
    if wire == name || wire.is_empty() || !is_alias { TokenStream::new() } else { quote!(#[doc(alias = #wire)]) }
}

/// Aliases of a command for rustdoc's search: names in the vendor's SDK.
pub(crate) fn sdk_aliases(command: &Command) -> TokenStream {
    let aliases = &command.aliases;
    quote!(#(#[doc(alias = #aliases)])*)
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

fn versions(versions: &jaka_spec::Versions) -> Option<String> {
    words::versions(versions).map(|known| format!("\n\nKnown to firmware {known}."))
}

/// A list, with an item for each text.
fn list(items: &[String]) -> String {
    items.iter().map(|item| format!("- {item}")).collect::<Vec<_>>().join("\n")
}

fn remarks(command: &Command) -> String {
    let withdrawn = command.deprecated.as_ref().map(|instead| format!("\n\nWithdrawn by the vendor: {instead}."));
    let evidence = evidence_sentence(&command.evidence).map(|evidence| format!("\n\nNot in the document. {evidence}"));
    let reconstructed = command.reconstructed.as_ref();
    let reconstructed =
        reconstructed.map(|evidence| format!("\n\nReconstructed, since the document's page is lost: {evidence}"));
    let refused = (!command.refused_because.is_empty())
        .then(|| format!("\n\n# Refusals\n\nKnown causes of a refusal:\n\n{}", list(&command.refused_because)));
    let errata = (!command.errata.is_empty()).then(|| format!("\n\n# Errata\n\n{}", list(&command.errata)));
    let known = words::known_to(command).map(|known| format!("\n\n{known}"));
    [known, withdrawn, evidence, reconstructed, refused, errata].into_iter().flatten().collect()
}

/// Section with the examples of a command: the code that sends the request, if there is some, then the request and the
/// reply on the wire.
fn examples(command: &Command, code: impl Fn(&str) -> Option<String>) -> String {
    let examples = command.examples.iter().enumerate().map(|(at, example)| {
        let request = example.request.as_deref();
        let code = request.and_then(&code).map(|code| format!("\n\n```rust,no_run\n{code}\n```")).unwrap_or_default();
        let sent = request.map(|request| message("Request", "->", request)).unwrap_or_default();
        let title = if at > 0 && request.is_none() { "Another reply" } else { "Reply" };
        let reply = example.reply.as_deref().map(|reply| message(title, "<-", reply)).unwrap_or_default();
        code + &sent + &reply
    });
    let examples: String = examples.collect();
    if examples.is_empty() { examples } else { format!("\n\n# Examples{examples}") }
}

/// A message of an example as a block. A message that is no object follows an arrow, so that no message of a pack ends
/// the block.
fn message(title: &str, arrow: &str, message: &str) -> String {
    let message = shown(message);
    if message.starts_with('{') {
        return format!("\n\n{title}:\n\n```json\n{message}\n```");
    }
    format!("\n\n{title}:\n\n```text\n{arrow} {message}\n```")
}

/// Sentence about the controller's refusal of a requirement that is not met; empty for a command without requirements.
fn refusal(command: &Command) -> String {
    match &command.refusal {
        _ if command.requires.is_empty() => String::new(),
        None => " In another state than the one it needs, expect a refusal.".to_owned(),
        Some(refusal) => format!(
            " In another state than the one it needs, the controller refuses with code {}, {}.",
            refusal.code,
            code_span(&refusal.message)
        ),
    }
}

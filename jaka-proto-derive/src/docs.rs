//! The documentation of the generated items.
//!
//! Text of the spec or of a pack is prose alone: rustdoc would test code, and pass on HTML. In it, commands are links
//! to their items.

mod command;
mod links;

use jaka_spec::prose::{code_span, linked_prose};
use jaka_spec::words::{self, first_sentence};
use jaka_spec::{Field, Topic, TypeKind};
use proc_macro2::TokenStream;
use quote::quote;

pub(crate) use links::{Docs, Place};

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

impl<'s> Docs<'s> {
    /// Text of the spec or of a pack as doc attributes.
    pub(crate) fn attributes(self, text: &str) -> TokenStream {
        own(&self.prose(text))
    }

    fn prose(self, text: &str) -> String {
        linked_prose(text, |name| self.target(name))
    }

    /// What a topic is about, for inside its module: there, links are looked up.
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

    /// What a field means, in which unit and range, how it is spelled on the wire, and what sources disagree on.
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
        let forms = (!field.forms.is_empty()).then(|| {
            let forms: Vec<_> = field.forms.iter().map(|form| words::form(self.spec, field, form)).collect();
            format!("\n\nOther forms on the wire:\n\n{}", list(&forms))
        });
        let or_raw = field.or_raw.then(|| OR_RAW.to_owned());
        let more: String = [ascii, forms, disputed, or_raw, versions(&field.versions)].into_iter().flatten().collect();
        let docs = own(&(text + &advisory.unwrap_or_default() + &advised.unwrap_or_default() + &self.prose(&more)));
        let alias = alias(&field.wire, &field.name);
        quote!(#docs #alias)
    }

    /// What a setter sets: the field's docs say more.
    pub(crate) fn setter(self, field: &Field) -> TokenStream {
        let docs = own(&self.summary(field, ""));
        let alias = alias(&field.wire, &field.name);
        quote!(#docs #alias)
    }

    /// The first sentence, unit and range, what follows in the paragraph, and the spelling on the wire, which is not a
    /// command's even where a command has it.
    fn summary(self, field: &Field, rest: &str) -> String {
        let measure = self.measure(field).map(|measure| format!(" {measure}")).unwrap_or_default();
        let text = self.prose(&format!("{}{measure}{rest}", first_sentence(&field.doc).0));
        if field.wire == field.name || field.wire.is_empty() {
            return text;
        }
        format!("{text} {} on the wire.", code_span(&field.wire))
    }

    /// What a constructor makes, and in which units it takes its arguments: those for the required fields.
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
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

const OR_RAW: &str = "\n\nThe sources leave doubt about the shape: a value of another shape is kept as raw JSON.";

fn versions(versions: &jaka_spec::Versions) -> Option<String> {
    words::versions(versions).map(|known| format!("\n\nKnown to firmware {known}."))
}

/// A list, with an item for each text.
fn list(items: &[String]) -> String {
    items.iter().map(|item| format!("- {item}")).collect::<Vec<_>>().join("\n")
}

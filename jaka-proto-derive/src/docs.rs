//! The documentation of the generated items.

use jaka_spec::prose::{code_span, prose};
use jaka_spec::words::{self, first_sentence};
use jaka_spec::{Command, Effect, Field, Range, Topic};
use proc_macro2::TokenStream;
use quote::quote;

/// Text of the spec or of a pack as doc attributes, one for each line, as prose: rustdoc would test code, and pass on HTML.
pub(crate) fn attributes(text: &str) -> TokenStream {
    own(&prose(text))
}

/// Text of our own, which may have links, as doc attributes. What it has of the spec's is a name in Rust or a code span.
pub(crate) fn own(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#[doc = #lines])*)
}

/// What a topic is about.
pub(crate) fn topic(topic: &Topic) -> TokenStream {
    attributes(&format!("{}.\n\n{}", topic.title, topic.doc))
}

/// An alias under which rustdoc's search finds the item `name` by its spelling on the wire, where rustdoc takes that.
pub(crate) fn alias(wire: &str, name: &str) -> TokenStream {
    let is_alias =
        wire.trim() == wire && !wire.contains(|c: char| matches!(c, '"' | '\'') || c.is_whitespace() && c != ' ');
    if wire == name || wire.is_empty() || !is_alias { TokenStream::new() } else { quote!(#[doc(alias = #wire)]) }
}

/// What a field means, in which unit and range, and what sources disagree on.
pub(crate) fn field(field: &Field) -> TokenStream {
    let (first, rest) = first_sentence(&field.doc);
    let mut text = first.to_owned();
    if let Some(measure) = measure(field.unit.as_deref(), field.range) {
        text = format!("{text} {measure}");
    }
    if !rest.is_empty() {
        text = format!("{text}{rest}");
    }
    if field.range.advisory {
        text += "\n\nNewer firmware takes more than this range, which can be switched off: see `AdvisoryRanges`.";
    }
    if field.ascii {
        text += "\n\nPrintable ASCII only.";
    }
    if !field.disputed.is_empty() {
        text += "\n\nSources contradict each other on the meaning, so the value is passed on as it is:\n";
        for reading in &field.disputed {
            text = format!("{text}\n- {reading}");
        }
    }
    if field.or_raw {
        text += "\n\nThe sources leave doubt about the shape: a value of another shape is kept as raw JSON.";
    }
    text += &versions(&field.versions);
    if field.wire != field.name && !field.wire.is_empty() {
        text = format!("{text}\n\n`{}` on the wire.", field.wire);
    }
    let alias = alias(&field.wire, &field.name);
    let text = attributes(&text);
    quote!(#text #alias)
}

/// What a constructor makes, and in which units it takes its arguments: those for the required fields.
pub(crate) fn constructor(doc: &str, fields: &[Field]) -> TokenStream {
    let first = attributes(first_sentence(doc).0);
    let required = fields.iter().filter(|field| !field.optional);
    let measured = required.filter_map(|field| {
        let measure = measure(field.unit.as_deref(), field.range)?;
        Some(format!("- `{}`: {}{}", field.name, measure[..1].to_lowercase(), measure[1..].trim_end_matches('.')))
    });
    let measured: Vec<_> = measured.collect();
    let list = (!measured.is_empty()).then(|| attributes(&format!("\n{}", measured.join("\n"))));
    quote!(#first #list)
}

/// `In deg/s, at least 0.`
fn measure(unit: Option<&str>, range: Range) -> Option<String> {
    let range = words::range(range);
    match (unit, range) {
        (Some(unit), Some(range)) => Some(format!("In {unit}, {range}.")),
        (Some(unit), None) => Some(format!("In {unit}.")),
        (None, Some(range)) => Some(capitalised(&range) + "."),
        (None, None) => None,
    }
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

fn versions(versions: &jaka_spec::Versions) -> String {
    words::versions(versions).map(|known| format!("\n\nKnown to firmware {known}.")).unwrap_or_default()
}

/// The text of a request: what it does, what is sent, what it needs.
pub(crate) fn request(command: &Command) -> String {
    let mut text = command.doc.clone();
    let section = command.section.as_ref().map(|section| format!(" ({section})")).unwrap_or_default();
    text = format!("{text}\n\nSends `{}`{section}.", command.wire);
    if command.effect == Effect::Query {
        text += " Changes nothing on the robot.";
    }
    if let Some(needs) = words::requirements(&command.requires) {
        text = format!("{text} The robot must be {needs}.");
    }
    text += &versions(&command.versions);
    if let Some(instead) = &command.deprecated {
        text = format!("{text}\n\nWithdrawn by the vendor: {instead}.");
    }
    if let Some(evidence) = &command.reconstructed {
        text = format!("{text}\n\nReconstructed, since the document's page is lost: {evidence}");
    }
    if !command.errata.is_empty() {
        text += "\n\n# Errata\n";
        for erratum in &command.errata {
            text = format!("{text}\n- {erratum}");
        }
    }
    text
}

/// The text of a method: that of its request, and how it fails beside as `call` does.
pub(crate) fn method(command: &Command, call: &str) -> TokenStream {
    let request = attributes(&request(command));
    let errors = own(&format!("\n# Errors\nAs {call}.{}", refusal(command)));
    quote!(#request #errors)
}

/// What the controller does where a requirement is not met.
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

//! The documentation of the generated items.

use jaka_spec::{Command, Effect, Field, Range, Requirement, Topic, first_sentence};
use proc_macro2::TokenStream;
use quote::quote;

/// `text` as doc attributes, one for each line.
pub(crate) fn attributes(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#[doc = #lines])*)
}

/// What a topic is about.
pub(crate) fn topic(topic: &Topic) -> TokenStream {
    attributes(&format!("{}.\n\n{}", topic.title, topic.doc))
}

/// An alias under which rustdoc's search finds the item by its spelling on the wire.
pub(crate) fn alias(wire: &str, name: &str) -> TokenStream {
    if wire == name || wire.is_empty() { TokenStream::new() } else { quote!(#[doc(alias = #wire)]) }
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

/// `In deg/s, at least 0.`
fn measure(unit: Option<&str>, range: Range) -> Option<String> {
    let range = match (range.min, range.max) {
        (Some(min), Some(max)) => Some(format!("{min} to {max}")),
        (Some(min), None) => Some(format!("at least {min}")),
        (None, Some(max)) => Some(format!("at most {max}")),
        (None, None) => None,
    };
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
    match (&versions.since, &versions.until) {
        (Some(since), Some(until)) => format!("\n\nKnown to firmware {since} to {until}."),
        (Some(since), None) => format!("\n\nKnown to firmware {since} and later."),
        (None, Some(until)) => format!("\n\nKnown to firmware up to {until}."),
        (None, None) => String::new(),
    }
}

/// The text of a request: what it does, what is sent, what it needs.
pub(crate) fn request(command: &Command) -> String {
    let mut text = command.doc.clone();
    let section = command.section.as_ref().map(|section| format!(" ({section})")).unwrap_or_default();
    text = format!("{text}\n\nSends `{}`{section}.", command.wire);
    if command.effect == Effect::Query {
        text += " Changes nothing on the robot.";
    }
    if let Some(needs) = requirements(&command.requires) {
        text = format!("{text} {needs}");
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
pub(crate) fn method(command: &Command, call: &str) -> String {
    format!("{}\n\n# Errors\nAs {call}.{}", request(command), refusal(command))
}

/// What the controller does where a requirement is not met.
fn refusal(command: &Command) -> String {
    match &command.refusal {
        _ if command.requires.is_empty() => String::new(),
        None => " In another state than the one it needs, expect a refusal.".to_owned(),
        Some(refusal) => format!(
            " In another state than the one it needs, the controller refuses with code {}, `{}`.",
            refusal.code, refusal.message
        ),
    }
}

fn requirements(requires: &[Requirement]) -> Option<String> {
    let words: Vec<_> = requires.iter().map(|requirement| requirement_words(*requirement)).collect();
    let (last, others) = words.split_last()?;
    let others = if others.is_empty() { String::new() } else { others.join(", ") + " and " };
    Some(format!("The robot must be {others}{last}."))
}

fn requirement_words(requirement: Requirement) -> &'static str {
    match requirement {
        Requirement::Powered => "powered",
        Requirement::Enabled => "enabled",
        Requirement::ServoMode => "in servo mode",
        Requirement::NotServoMode => "outside servo mode",
    }
}

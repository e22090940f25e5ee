//! The spec and the generated messages against every message that the vendor's document prints.

use std::collections::{BTreeMap, BTreeSet};

use expect_test::expect;
use jaka_proto::wire::Writer;
use jaka_proto::{Command, Envelope, ErrorCode, Request, Visit, read_payload, write_refusal, write_reply};
use jaka_spec::TypeKind;
use jaka_tests::{Printed, compact, printed, same, spec};
use serde_json::Value;

/// Replies that come out in another form than the document prints, and why.
const EXCEPTIONS: &[(&str, &str)] = &[
    ("4.34", "a Python list inside the string comes out as a tuple: the two are read alike"),
    ("4.41", "the document prints a blank before `wait_complete` in `cmdName`"),
    ("4.42", "the document prints blanks around `set_payload` in `cmdName`"),
];

fn is_exception(section: &str) -> bool {
    EXCEPTIONS.iter().any(|(exception, _)| *exception == section)
}

#[test]
fn the_document_prints_168_messages() {
    let printed = printed();
    assert_eq!(printed.len(), 168);
    assert_eq!(printed.iter().filter(|message| message.is_request).count(), 84);
}

#[test]
fn each_request_comes_out_as_it_went_in() {
    for Printed { section, text, .. } in printed().iter().filter(|message| message.is_request) {
        let request = Request::read(text).unwrap_or_else(|error| panic!("{section}: {error:?}"));
        let mut out = Writer::new();
        request.write(&mut out);
        // Equal as text, except for white space: so the values are the same, and the keys in the document's order.
        assert_eq!(out.as_str(), compact(text), "{section}");
        assert_eq!(request.info().section, section);
    }
}

/// Reads a reply and writes it again.
struct Again<'t>(&'t str);

impl Visit for Again<'_> {
    type Output = String;

    fn visit<C: Command>(self, _command: &C) -> String {
        let mut out = Writer::new();
        let envelope = Envelope::read(self.0).expect("the reply is JSON");
        assert_eq!(envelope.command.as_deref(), Some(C::INFO.name));
        if let Some(refusal) = envelope.refusal() {
            write_refusal(Some(C::INFO.name), refusal.code, &refusal.message, &mut out);
        } else {
            assert_eq!(envelope.code, Ok(ErrorCode(0)));
            let reply: C::Reply = read_payload(C::INFO, self.0).expect("the reply decodes");
            write_reply(C::INFO, &reply, &mut out);
        }
        out.into_string()
    }
}

#[test]
fn each_reply_decodes_and_comes_out_equal() {
    let messages = printed();
    let requests: BTreeMap<_, _> =
        messages.iter().filter(|message| message.is_request).map(|message| (&message.section, &message.text)).collect();
    let mut excepted = BTreeSet::new();
    for Printed { section, text, .. } in messages.iter().filter(|message| !message.is_request) {
        let request = Request::read(requests[section]).expect("read by another test");
        let again: Value = serde_json::from_str(&request.visit(Again(text))).expect("a reply is JSON");
        let printed: Value = serde_json::from_str(text).expect("the document prints JSON");
        if is_exception(section) {
            assert!(!same(&again, &printed), "{section} is not an exception any more");
            excepted.insert(section.as_str());
        } else {
            assert!(same(&again, &printed), "{section}: {again} is not {printed}");
        }
    }
    assert_eq!(excepted, EXCEPTIONS.iter().map(|(section, _)| *section).collect());
}

#[test]
fn the_spec_has_82_commands_of_the_document_one_for_each_section() {
    let spec = spec();
    let sections: Vec<_> = spec.commands().filter_map(|command| command.section.as_deref()).collect();
    assert_eq!(sections.len(), 82);
    for command in spec.commands() {
        let is_of_document = command.section.is_some();
        assert_eq!(command.title_zh.is_some(), is_of_document, "{}", command.wire);
        assert_ne!(!command.evidence.is_empty(), is_of_document, "{}", command.wire);
        assert_eq!(command.requires_source.is_some(), !command.requires.is_empty(), "{}", command.wire);
    }
    let all: BTreeSet<String> = (1..=82).map(|n| format!("4.{n}")).collect();
    assert_eq!(sections.iter().map(|section| (*section).to_owned()).collect::<BTreeSet<_>>(), all);
}

#[test]
fn the_examples_of_the_spec_are_the_documents_messages() {
    let mut examples = examples();
    for Printed { section, text, has_placeholders, is_request } in printed() {
        let at = examples.iter().position(|example| {
            let is_its_own = (&*example.section, example.is_request) == (&*section, is_request);
            // A message of placeholders has values of ours, but for one, which the document gives in its text.
            let is_marked = example.is_ours == (has_placeholders && section != "4.42");
            let is_it = if has_placeholders { same_keys(&example.text, &text) } else { example.text == text };
            is_its_own && is_marked && is_it
        });
        examples.remove(at.unwrap_or_else(|| panic!("{section}: {text}")));
    }
    // What is left is on the page that is lost.
    for Message { section, is_ours, .. } in examples {
        assert!(is_ours && LOST.contains(&&*section), "{section}");
    }
}

/// A message of an example.
struct Message {
    section: String,
    is_request: bool,
    is_ours: bool,
    text: String,
}

/// The messages of the examples of the document's commands.
fn examples() -> Vec<Message> {
    let mut messages = Vec::new();
    for command in spec().commands() {
        let Some(section) = &command.section else { continue };
        for example in &command.examples {
            let parts =
                [(true, &example.request, example.request_is_ours), (false, &example.reply, example.reply_is_ours)];
            for (is_request, text, is_ours) in parts {
                let message =
                    |text: &String| Message { section: section.clone(), is_request, is_ours, text: text.clone() };
                messages.extend(text.as_ref().map(message));
            }
        }
    }
    messages
}

/// Whether both have the same keys in the same order.
fn same_keys(a: &str, b: &str) -> bool {
    let keys = |text: &str| text.split('"').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    keys(a) == keys(b)
}

/// The sections of which text is lost.
const LOST: [&str; 7] = ["4.20", "4.21", "4.22", "4.23", "4.24", "4.25", "4.26"];

#[test]
fn the_examples_of_the_spec_decode() {
    for command in spec().commands() {
        for example in &command.examples {
            let request = example.request.as_ref().map(|text| Request::read(text).expect("the request decodes"));
            if let (Some(request), Some(reply)) = (request, &example.reply) {
                assert_eq!(request.info().name, command.wire);
                request.visit(Again(reply));
            }
        }
    }
}

#[allow(clippy::pedantic, unused_imports, reason = "it is generated")]
mod calls {
    include!("../../../jaka-proto-derive/golden/calls.rs");
}

/// The docs of jaka-sync show a call for each request, whose value only the compiler sees there.
#[test]
fn the_calls_of_the_docs_send_the_examples() {
    let calls = calls::calls();
    for (message, request) in &calls {
        assert_eq!(Request::read(message).as_ref(), Ok(request), "{message}");
    }
    let spec = spec();
    let is_without_call = |command: &&jaka_spec::Command| {
        let mut requests = command.examples.iter().filter_map(|example| example.request.as_deref());
        !command.is_bare() && requests.any(|request| calls.iter().all(|(message, _)| *message != request))
    };
    let without_call: Vec<_> = spec.commands().filter(is_without_call).map(|command| &*command.wire).collect();
    // Its value is any JSON, for which the docs have no code.
    assert_eq!(without_call, ["setOptionalInfoConfig"]);
}

#[test]
fn seven_sections_are_marked_reconstructed() {
    let spec = spec();
    let marked = |command: &&jaka_spec::Command| command.reconstructed.is_some();
    let sections: Vec<_> = spec.commands().filter(marked).filter_map(|command| command.section.as_deref()).collect();
    assert_eq!(sections.iter().collect::<BTreeSet<_>>(), LOST.iter().collect());
}

/// Words in Latin letters of the vendor's document, version 2.0.4: all that its text has.
const WORDS: &str = include_str!("../../data/document-words.txt");

/// Keys of a command or a type that no word of the document is, ranges and values of newer firmware, without evidence
/// of their own. The commands that the document does not have are in another test.
#[test]
fn each_key_beyond_the_document_has_its_evidence() {
    let words: BTreeSet<_> = WORDS.lines().collect();
    let spec = spec();
    let mut without = BTreeSet::new();
    let (mut with, mut newer_values) = (0, Vec::new());
    let mut see = |owner: &str, fields: &mut dyn Iterator<Item = &jaka_spec::Field>| {
        for field in fields {
            if field.range.advisory && field.evidence.is_empty() {
                without.insert(format!("{owner} {}: what newer firmware takes", field.name));
            }
            if field.wire.is_empty() {
                continue;
            }
            // Keys such as `power status` are two words.
            let is_in_document = field.wire.split(' ').all(|word| words.contains(word));
            if !field.evidence.is_empty() {
                with += 1;
            } else if !is_in_document {
                without.insert(format!("{owner} {}", field.wire));
            }
        }
    };
    for command in spec.commands().filter(|command| command.section.is_some()) {
        see(&command.wire, &mut command.request.fields());
        see(&command.wire, &mut spec.reply_fields(command).iter());
    }
    for (_, def) in spec.types() {
        see(&def.name, &mut def.kind.fields());
        let values = |name: &str, is_newer: bool, has_evidence: bool| {
            (is_newer && !has_evidence).then(|| format!("{} {name}: a value of newer firmware", def.name))
        };
        let newer: Vec<_> = match &def.kind {
            TypeKind::IntEnum(all) => {
                all.iter().filter_map(|value| values(&value.name, value.advisory, !value.evidence.is_empty())).collect()
            }
            TypeKind::TextEnum(all) => {
                all.iter().filter_map(|value| values(&value.name, value.advisory, !value.evidence.is_empty())).collect()
            }
            _ => Vec::new(),
        };
        newer_values.extend(newer);
    }
    without.extend(newer_values);
    expect![[r""]].assert_eq(&without.into_iter().map(|key| key + "\n").collect::<String>());
    assert!(with > 25, "{with}");
}

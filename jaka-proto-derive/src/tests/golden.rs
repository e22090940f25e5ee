//! The expansion, as committed for review: the interface of all that is generated with its limits, and the full code
//! with docs for each shape.

mod interface;

use std::thread;

use expect_test::{expect, expect_file};
use jaka_spec::{Module, Source, Spec};
use proc_macro2::TokenStream;
use quote::quote;

use crate::call::Call;
use crate::scope::{ModulePaths, Scope};
use crate::{client, compile_errors, error_codes, pack, topic, word_enums};
use interface::{interface, interface_without};

fn pretty(tokens: TokenStream) -> String {
    let file = syn::parse2(tokens).expect("the expansion is valid Rust");
    prettyplease::unparse(&file)
}

fn builtin() -> Spec {
    jaka_spec::builtin().expect("the built-in spec is correct")
}

#[test]
fn the_interface_of_all_messages() {
    let spec = builtin();
    for topic in spec.topics.iter().filter(|topic| topic::has_module(topic)) {
        let module = topic::module(&spec, topic, &spec.sent_types());
        expect_file![format!("../../golden/{}.rs", topic.name)].assert_eq(&interface(module));
    }
    expect_file!["../../golden/request.rs"].assert_eq(&interface(topic::requests(&spec)));
    expect_file!["../../golden/error_codes.rs"].assert_eq(&interface(error_codes::render(&spec)));
    expect_file!["../../golden/word_enums.rs"].assert_eq(&interface(word_enums::render()));
    expect_file!["../../golden/client.rs"].assert_eq(&interface(client::methods(&spec)));
}

/// The requests of the calls in the docs. A test of the whole project compares them with the messages.
#[test]
fn the_calls_of_the_examples() {
    let spec = builtin();
    let topics = spec.topics.iter().filter(|topic| topic::has_module(topic));
    let modules: Vec<_> = topics.clone().map(|topic| format!("{}::*", topic.name)).collect();
    let commands = topics.flat_map(|topic| topic.commands.iter().map(move |command| (topic, command)));
    let messages = commands.filter(|(_, command)| !command.is_bare()).flat_map(|(topic, command)| {
        let messages = command.examples.iter().filter_map(|example| example.request.as_deref());
        messages.map(move |message| (topic, command, message))
    });
    let rows = messages.filter_map(|(topic, command, message)| {
        let call = Call::new(&spec, topic, command, message)?;
        Some(format!("(r#\"{message}\"#, {}.into()),", call.request()))
    });
    let (rows, modules) = (rows.collect::<String>(), modules.join(", "));
    let text = format!(
        "use jaka_proto::messages::{{Request, {modules}}};
        /// Requests of the calls in the docs of jaka-sync, each after its message.
        pub(super) fn calls() -> Vec<(&'static str, Request)> {{ Vec::from([{rows}]) }}"
    );
    let file = syn::parse_file(&text).expect("the calls are valid Rust");
    expect_file!["../../golden/calls.rs"].assert_eq(&prettyplease::unparse(&file));
}

#[test]
fn the_full_expansion_for_each_shape() {
    let text = include_str!("../../golden/shapes.toml");
    let spec = jaka_spec::load(&[Source { path: "shapes.toml", text }]).expect("the spec is correct");
    let (messages, modules, methods) = (topic::messages(&spec), client::modules(&spec), client::methods(&spec));
    expect_file!["../../golden/shapes.rs"].assert_eq(&pretty(quote!(#messages #modules #methods)));
}

#[test]
fn what_not_all_firmware_has_says_so() {
    let text = r#"
title = "Fan"

[[command]]
wire = "set_fan"
effect = "setting"
since = "1.6.5"
until = "1.7"
doc = "Sets the cabinet's fan."

[[command.request]]
wire = "curve"
type = "FanCurve"
doc = "The speeds."

[[command.request]]
wire = "delay"
type = "float"
unit = "s"
min = 0
optional = true
until = "1.6"
doc = "How long it runs on."

[[type]]
name = "FanCurve"
kind = "object"
doc = "Speeds of the fan."

[[type.field]]
wire = "quiet"
type = "bool"
optional = true
since = "1.7"
doc = "Whether it is quiet."
"#;
    let spec = jaka_spec::load(&[Source { path: "spec/fan.toml", text }]).expect("the spec is correct");
    let impls = impls_of(topic::messages(&spec), &["Validate", "Command"]);
    expect![[r#"
        impl check::Validate for SetFan {
            #[allow(unused_variables)]
            #[inline]
            fn validate(
                &self,
                place: &check::Place<'_>,
                limits: &check::FieldLimits,
            ) -> Result<(), check::NotSent> {
                place.check("curve", &self.curve, &check::FieldLimits::NONE)?;
                place
                    .check(
                        "delay",
                        &self.delay,
                        &check::FieldLimits {
                            min: Some(0f64),
                            unit: "s",
                            firmware: proto::FirmwareRange::ALL.until([1, 6]),
                            ..check::FieldLimits::NONE
                        },
                    )?;
                Ok(())
            }
        }
        impl proto::Command for SetFan {
            type Reply = ();
            const INFO: &'static proto::CommandInfo = &proto::__command_info!(
                "set_fan", "{\"cmdName\":\"set_fan\"", "", Setting, firmware :
                proto::FirmwareRange::ALL.since([1, 6, 5]).until([1, 7]),
            );
        }
        impl check::Validate for FanCurve {
            #[allow(unused_variables)]
            #[inline]
            fn validate(
                &self,
                place: &check::Place<'_>,
                limits: &check::FieldLimits,
            ) -> Result<(), check::NotSent> {
                place
                    .check(
                        "quiet",
                        &self.quiet,
                        &check::FieldLimits {
                            firmware: proto::FirmwareRange::ALL.since([1, 7]),
                            ..check::FieldLimits::NONE
                        },
                    )?;
                Ok(())
            }
        }
    "#]]
    .assert_eq(&impls);
}

/// The implementations of these traits in the modules of an expansion.
fn impls_of(tokens: TokenStream, traits: &[&str]) -> String {
    let mut file: syn::File = syn::parse2(tokens).expect("the expansion is valid Rust");
    let is_wanted = |item: &syn::Item| {
        let syn::Item::Impl(item) = item else { return false };
        let name = item.trait_.as_ref().and_then(|(path, _)| path.segments.last());
        name.is_some_and(|name| traits.iter().any(|wanted| name.ident == wanted))
    };
    let modules = file.items.into_iter().filter_map(|item| match item {
        syn::Item::Mod(module) => module.content,
        _ => None,
    });
    file.items = modules.flat_map(|(_, items)| items).filter(is_wanted).collect();
    prettyplease::unparse(&file)
}

#[test]
fn each_error_of_the_spec_is_a_compiler_error() {
    let text = "title = \"Motion\"\n\n[[command]]\nwire = \"go\"\neffect = \"fly\"\n";
    let errors = jaka_spec::load(&[Source { path: "spec/motion.toml", text }]).expect_err("the spec is wrong");
    expect![[r#"
        ::core::compile_error!("spec/motion.toml:3:1: command `go`: `doc` is missing");
        ::core::compile_error!(
            "spec/motion.toml:5:10: command `go`: `effect` is one of query, setting, motion, power, session, not `fly`"
        );
    "#]]
    .assert_eq(&pretty(compile_errors(&errors)));
}

/// The packs of the crate that shows how packs are used.
const NEWER: Source<'_> = Source { path: "newer.toml", text: include_str!("../../../tests/pack-user/newer.toml") };
const CHANGED: Source<'_> =
    Source { path: "changed.toml", text: include_str!("../../../tests/pack-user/changed.toml") };

fn module(source: Source<'_>) -> Module {
    let spec = builtin();
    jaka_spec::load_pack(&spec, source).expect("the pack is correct").module()
}

#[test]
fn packs() {
    let sync = quote!(::jaka_sync);
    expect_file!["../../golden/pack_newer.rs"].assert_eq(&interface(pack::render(&module(NEWER), &builtin(), &sync)));
    // Of the status packet, which is long and as it was, only what the pack adds.
    let spec = builtin();
    let before: Vec<_> = spec.status_fields().iter().map(|field| field.name.as_str()).collect();
    let changed = interface_without(pack::render(&module(CHANGED), &spec, &sync), "RobotStatus", &before);
    expect_file!["../../golden/pack_changed.rs"].assert_eq(&changed);
}

#[test]
fn commands_in_the_spec_and_in_a_pack_are_the_same() {
    let sources = [jaka_spec::BUILTIN, &[Source { path: "spec/newer.toml", ..NEWER }]].concat();
    let spec = jaka_spec::load(&sources).expect("the spec is correct");
    let topic = spec.topics.last().expect("the spec has topics");
    let paths = ModulePaths::new(quote!(super));
    let items = topic::items(Scope::of_module(&spec, topic, &paths), topic, &spec.sent_types());
    let own = module(NEWER);
    let in_pack = topic::items(Scope::of_module(&own.spec, &own.topic, &paths), &own.topic, &own.spec.sent_types());
    assert_eq!(pretty(items), pretty(in_pack));
    let methods = pretty(client::methods(&spec)).replace("self::newer::", "").replace("pub fn", "fn");
    let in_pack = pretty(pack::render(&own, &builtin(), &quote!(::jaka_sync))).replace("::jaka_sync::Error", "Error");
    for method in ["demo_motion_state(", "demo_stop_state(", "set_demo_period("] {
        let signature = |text: &str| {
            let found = text.split_once(&format!("fn {method}")).and_then(|(_, rest)| rest.split_once('{'));
            let (signature, _) = found.unwrap_or_else(|| panic!("{method} is missing"));
            // Where it takes several lines, a comma is added.
            signature.split_whitespace().collect::<String>().replace(",)", ")")
        };
        assert_eq!(signature(&methods), signature(&in_pack));
    }
}

/// The pack of the same crate that has all that is legal and strange.
const STRANGE: Source<'_> =
    Source { path: "strange.toml", text: include_str!("../../../tests/pack-user/strange.toml") };

/// rustdoc tests what it takes for code, and `cargo test` of this pack's user does so: see there.
#[test]
fn no_text_of_a_pack_becomes_code() {
    let spec = builtin();
    let pack = jaka_spec::load_pack(&spec, STRANGE).expect("the pack is correct");
    let text = pretty(pack::render(&pack.module(), &spec, &quote!(::jaka_sync)));
    let docs = text.lines().filter_map(|line| {
        let line = line.trim_start();
        line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))
    });
    // In an example, each line begins with one of these, and so ends no block.
    let (mut hostile, mut example) = (0, None);
    for line in docs {
        hostile += usize::from(line.contains("compile_error!"));
        assert!(!line.contains(['\t', '\u{1b}', '\u{202e}', '\r']), "{line}");
        match (line, example) {
            (" ```json", None) => example = Some([" {", " {"]),
            (" ```text", None) => example = Some([" -> ", " <- "]),
            (" ```", Some(_)) => example = None,
            (_, Some(starts)) => assert!(starts.iter().any(|start| line.starts_with(start)), "{line}"),
            (_, None) => assert_is_prose(line),
        }
    }
    assert!(hostile > 10, "{hostile}");
}

fn assert_is_prose(line: &str) {
    let content = line.trim_start_matches(|c: char| matches!(c, ' ' | '>' | '-') || c.is_ascii_digit());
    assert!(!content.starts_with("```") && !content.starts_with("~~~"), "{line}");
    assert!(!line.contains("    ") || line.starts_with("    ") && !line.starts_with("     "), "{line}");
    assert!(!line.contains(" <script"), "{line}");
}

/// Each line is left out, or has another value: what loads is rendered, and is Rust.
#[test]
fn what_loads_can_be_rendered() {
    let spec = builtin();
    // Without the changes of the status packet, whose code is long.
    let (new, _) = STRANGE.text.split_once("# What the spec has, changed").expect("the changes stand at the end");
    let lines: Vec<_> = new.lines().collect();
    let values = ["true", "0", "\"x\"", "'\"\\'", "\"text\"", "\"Level\"", "\"array\"", "[]", "[1, 0]"];
    let changes: Vec<_> = (0..lines.len()).zip(values.iter().cycle()).collect();
    let render = |(at, value): (usize, &&str)| {
        let other = lines[at].split_once(" = ").map(|(key, _)| format!("{key} = {value}"));
        let texts = other.into_iter().chain([String::new()]);
        let loads = texts.filter(|line| {
            let text = [&lines[..at], &[line.as_str()], &lines[at + 1..]].concat().join("\n");
            let Ok(pack) = jaka_spec::load_pack(&spec, Source { text: &text, ..STRANGE }) else { return false };
            let parsed = syn::parse2::<syn::File>(pack::render(&pack.module(), &spec, &quote!(::jaka_sync)));
            assert!(parsed.is_ok(), "line {}, `{line}`: {:?}", at + 1, parsed.err());
            true
        });
        loads.count()
    };
    // Four threads share the changes.
    let rendered: usize = thread::scope(|scope| {
        let parts = changes.chunks(changes.len().div_ceil(4));
        let threads: Vec<_> =
            parts.map(|part| scope.spawn(|| part.iter().copied().map(render).sum::<usize>())).collect();
        threads.into_iter().map(|thread| thread.join().expect("no change fails")).sum()
    });
    assert!(rendered > 50, "{rendered}");
}

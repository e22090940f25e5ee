//! Files that somebody damaged: each loads, or has errors at places of it, and what loads can be used.

use std::sync::LazyLock;

use jaka_dynamic::{AdvisoryRanges, Node};
use jaka_spec::{BUILTIN, Errors, Source, Spec, load, load_pack, tools};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use serde_json::{Map, Value};

static SPEC: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the built-in spec is correct"));

const PACKS: &[Source<'_>] = &[
    Source { path: "newer.toml", text: include_str!("../../pack-user/newer.toml") },
    Source { path: "changed.toml", text: include_str!("../../pack-user/changed.toml") },
    Source { path: "strange.toml", text: include_str!("../../pack-user/strange.toml") },
];

/// The values of some lines of some files, and values that make no sense there.
const VALUES: &[&str] = &[
    "",
    "\"\"",
    "\" \"",
    "\"a\\nb\"",
    "'\"\\'",
    "'é'",
    "true",
    "false",
    "0",
    "-1",
    "1e400",
    "inf",
    "nan",
    "9223372036854775807",
    "-9223372036854775808",
    "99999999999999999999",
    "0x_",
    "1979-05-27",
    "[]",
    "[0, 1]",
    "[1, 0]",
    "[\"no\", \"yes\"]",
    "[\"x\", \"X\"]",
    "[[]]",
    "{}",
    "{ wire = 1 }",
    "[{ wire = \"x\" }]",
    "\"bool\"",
    "\"int\"",
    "\"text[2]\"",
    "\"python(float)[]\"",
    "\"python(JointPosition)\"",
    "\"RobotStatus[64][64]\"",
    "\"MoveMode\"",
    "\"Row\"",
    "\"object\"",
    "\"array\"",
    "\"enum\"",
    "\"choice\"",
    "\"wrapper\"",
    "\"joint_move\"",
    "\"jog\"",
    "\"RobotStatus\"",
    "\"cmdName\"",
    "\"errorCode\"",
    "\"self\"",
    "\"Result\"",
    "\"Other\"",
    "\"value\"",
    "\"1.6.5\"",
    "\"1.7.1.46.5\"",
];

/// A change of a file.
#[derive(Debug, Clone)]
enum Mutation {
    Delete(Index),
    Swap(Index, Index),
    /// Replaces the value of a line by that of another.
    SwapValue(Index, Index),
    SetValue(Index, &'static str),
    Copy(Index, Index),
    Truncate(Index),
    Insert(Index, String),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let index = any::<Index>;
    prop_oneof![
        4 => index().prop_map(Mutation::Delete),
        1 => (index(), index()).prop_map(|(a, b)| Mutation::Swap(a, b)),
        4 => (index(), index()).prop_map(|(a, b)| Mutation::SwapValue(a, b)),
        4 => (index(), select(VALUES)).prop_map(|(at, value)| Mutation::SetValue(at, value)),
        1 => (index(), index()).prop_map(|(a, b)| Mutation::Copy(a, b)),
        1 => index().prop_map(Mutation::Truncate),
        1 => (index(), ".{0,3}").prop_map(|(at, text)| Mutation::Insert(at, text)),
    ]
}

fn apply(text: &str, mutation: &Mutation) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let count = lines.len();
    if count == 0 {
        return String::new();
    }
    let place = |at: &Index| text.char_indices().nth(at.index(text.chars().count())).map_or(0, |(at, _)| at);
    let value = |line: &str| line.split_once('=').map(|(_, value)| value.to_owned()).unwrap_or_default();
    let set = |line: &str, value: &str| format!("{}={value}", line.split('=').next().unwrap_or_default());
    match mutation {
        Mutation::Delete(at) => drop(lines.remove(at.index(count))),
        Mutation::Swap(a, b) => lines.swap(a.index(count), b.index(count)),
        Mutation::SwapValue(a, b) => {
            lines[a.index(count)] = set(&lines[a.index(count)], &value(&lines[b.index(count)]));
        }
        Mutation::SetValue(at, value) => lines[at.index(count)] = set(&lines[at.index(count)], value),
        Mutation::Copy(a, b) => lines.insert(b.index(count), lines[a.index(count)].clone()),
        Mutation::Truncate(at) => return text[..place(at)].to_owned(),
        Mutation::Insert(at, new) => return [&text[..place(at)], new, &text[place(at)..]].concat(),
    }
    lines.join("\n")
}

fn damaged(sources: &'static [Source<'static>]) -> impl Strategy<Value = (&'static str, String)> {
    (select(sources), proptest::collection::vec(mutation(), 1..4)).prop_map(|(source, mutations)| {
        let apply = |text: String, mutation: &Mutation| apply(&text, mutation);
        (source.path, mutations.iter().fold(source.text.to_owned(), apply))
    })
}

/// Each error has a place: one of the file where it is of that file.
fn placed(errors: &Errors, (path, text): (&str, &str)) -> Result<(), TestCaseError> {
    let lines = text.split('\n').count();
    prop_assert!(errors.iter().next().is_some());
    for error in errors {
        prop_assert!(error.path != path || error.line <= lines, "{error}");
        prop_assert!(error.line >= 1 && error.column >= 1 && !error.message.is_empty(), "{error}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn topics((path, text) in damaged(BUILTIN)) {
        let source = |old: &Source<'static>| if old.path == path { text.clone() } else { old.text.to_owned() };
        let texts: Vec<_> = BUILTIN.iter().map(|old| (old.path, source(old))).collect();
        let sources: Vec<_> = texts.iter().map(|(path, text)| Source { path, text }).collect();
        match load(&sources) {
            Ok(spec) => used(&spec)?,
            Err(errors) => placed(&errors, (path, &text))?,
        }
    }

    #[test]
    fn packs((path, text) in damaged(PACKS)) {
        match load_pack(&SPEC, Source { path, text: &text }) {
            Ok(pack) => {
                let module = pack.module();
                module.topic.commands.iter().for_each(|command| drop(module.method(command)));
                used(&pack.spec)?;
            }
            Err(errors) => placed(&errors, (path, &text))?,
        }
    }

    #[test]
    fn any_text(text in "(\\[\\[?|\\]\\]?|command|wire|type|field|=|\"|'|\n|[\\PC]|0){0,40}") {
        let loaded = load_pack(&SPEC, Source { path: "any.toml", text: &text });
        placed(&loaded.expect_err("a pack has a title"), ("any.toml", &text))?;
    }
}

/// Uses a loaded spec as the other crates do.
fn used(spec: &Spec) -> Result<(), TestCaseError> {
    for command in spec.commands() {
        let mut reply = jaka_dynamic::sample_reply(spec, command);
        reply.extend([("errorCode".to_owned(), "0".into()), ("cmdName".to_owned(), command.wire.clone().into())]);
        let departures = Node::reply(spec, command, reply.into()).departures();
        let is_readable = departures.iter().all(|departure| departure.reading == jaka_dynamic::Reading::Lenient);
        prop_assert!(is_readable, "{}: {departures:?}", command.wire);
        let fields =
            jaka_dynamic::arguments(spec, command).iter().map(|argument| (argument.field.clone(), 1.into())).collect();
        let _ = jaka_dynamic::request(spec, command, &fields, AdvisoryRanges::Enforced);
        let _ = Node::request(spec, command, Map::new()).problems();
        for field in command.fields() {
            let _ = jaka_dynamic::value(spec, &field.ty, "[1, \"a\"]");
        }
    }
    let _ = Node::status(spec, Value::Null).departures();
    let _ = tools::diff(&SPEC, spec);
    let _ = tools::reference(spec);
    let _ = tools::schema(spec);
    Ok(())
}

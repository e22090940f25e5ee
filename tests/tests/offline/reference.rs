//! The committed reference of the protocol: it is up to date, and its links lead somewhere.

use std::collections::BTreeSet;

use expect_test::{expect, expect_file};
use jaka_spec::prose::prose;
use jaka_spec::tools::{events, events_zh, reference, reference_zh};
use jaka_spec::{Source, evidence_sentence, load};
use jaka_tests::spec;

#[test]
fn the_committed_reference_is_that_of_the_spec() {
    expect_file!["../../../spec/REFERENCE.md"].assert_eq(&reference(&spec()));
    expect_file!["../../../spec/REFERENCE.zh.md"].assert_eq(&reference_zh(&spec()));
    expect_file!["../../../spec/EVENTS.md"].assert_eq(&events(&spec()));
    expect_file!["../../../spec/EVENTS.zh.md"].assert_eq(&events_zh(&spec()));
}

#[test]
fn every_link_leads_to_one_heading() {
    let (english, chinese) = (reference(&spec()), reference_zh(&spec()));
    let (by_code, by_code_zh) = (events(&spec()), events_zh(&spec()));
    let editions = [("REFERENCE.md", &english), ("REFERENCE.zh.md", &chinese)];
    let pages = [editions[0], editions[1], ("EVENTS.md", &by_code), ("EVENTS.zh.md", &by_code_zh)];
    let anchors = pages.map(|(file, text)| (file, anchors(text)));
    for (here, text) in editions {
        let links: Vec<_> = text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
        for link in &links {
            if link.starts_with("https://") {
                continue;
            }
            let (file, target) = link.split_once('#').unwrap_or((link, ""));
            let file = if file.is_empty() { here } else { file };
            let (_, anchors) =
                anchors.iter().find(|(known, _)| *known == file).unwrap_or_else(|| panic!("`{link}` leads out"));
            assert!(target.is_empty() || anchors.contains(target), "nothing has the anchor of `{link}`");
        }
        assert!(links.len() > spec().commands().count(), "{here}: an index links to each command");
    }
}

/// The anchors of a text, each of one heading.
pub(crate) fn anchors(text: &str) -> BTreeSet<String> {
    let mut anchors = BTreeSet::new();
    for heading in headings(text) {
        assert!(anchors.insert(anchor(heading)), "two headings have the anchor of `{heading}`");
    }
    anchors
}

#[test]
fn everything_of_the_spec_is_in_it() {
    let (spec, text) = (spec(), reference(&spec()));
    let headings: Vec<_> = headings(&text).collect();
    for command in spec.commands() {
        let section = command.section.as_deref().unwrap_or("Command");
        assert!(headings.contains(&format!("{section} `{}`", command.wire).as_str()), "{}", command.wire);
        let evidence = evidence_sentence(&command.evidence);
        let facts = [&evidence, &command.requires_source, &command.title_zh];
        assert!(facts.into_iter().flatten().all(|fact| text.contains(&prose(fact))), "{}", command.wire);
        for message in command.examples.iter().flat_map(|example| example.request.iter().chain(&example.reply)) {
            assert!(text.contains(&format!("```json\n{message}\n```")), "{}: {message}", command.wire);
        }
    }
    for (_, def) in spec.types() {
        assert!(headings.contains(&format!("Type `{}`", def.name).as_str()), "{}", def.name);
    }
    for error in spec.errors() {
        assert!(text.contains(&format!("| {} | {} |", error.wire, error.name)), "{}", error.wire);
    }
    assert!(text.contains("\n- Events: 560 errors, 228 warnings and 106 of information, [by code](EVENTS.md)\n"));
}

/// The figures were counted in the vendor's table itself: JakaCobot.github.io, `docs/en/guide/errinfo.md`, February
/// 2024.
#[test]
fn each_event_is_explained_in_both_languages() {
    let (spec, mut codes) = (spec(), 0);
    let pages = [events(&spec), events_zh(&spec)];
    for event in spec.events() {
        let family = spec.family_of(event).unwrap_or_else(|| panic!("{event:?} has no family"));
        for (texts, of_family) in [(&event.texts, &family.texts), (&event.texts_zh, &family.texts_zh)] {
            assert!(texts.meaning.is_some(), "{event:?}");
            // Nothing has a cause that only reports what was done.
            assert!(texts.cause.is_some() || of_family.cause.is_some() || family.name == "notice", "{event:?}");
            assert!(texts.remedy.is_some() || of_family.remedy.is_some(), "{event:?}");
        }
        let [english, chinese] = [&event.texts, &event.texts_zh];
        assert_eq!(english.cause.is_some(), chinese.cause.is_some(), "{event:?}");
        assert_eq!(english.remedy.is_some(), chinese.remedy.is_some(), "{event:?}");
        for code in event.codes() {
            let code = format!("`{}`", jaka_spec::words::event_code(code));
            assert!(pages.iter().all(|page| page.matches(&code).count() == 1), "{code}");
            codes += 1;
        }
    }
    assert_eq!(codes, 894);
}

#[test]
fn the_tables_have_as_many_cells_as_their_heads() {
    let text = [reference(&spec()), events(&spec()), events_zh(&spec())].join("\n");
    let cells = |line: &str| line.replace("\\|", "").matches('|').count();
    let mut head = None;
    for line in text.lines() {
        if !line.starts_with('|') {
            head = None;
            continue;
        }
        let expected = *head.get_or_insert_with(|| cells(line));
        assert_eq!(cells(line), expected, "{line}");
    }
}

/// The headings outside code blocks, without their signs.
fn headings(text: &str) -> impl Iterator<Item = &str> {
    let outside = text.split("```").step_by(2);
    let lines = outside.flat_map(str::lines).filter(|line| line.starts_with('#'));
    lines.map(|line| line.trim_start_matches('#').trim())
}

/// The anchor of a heading, as GitHub makes it.
fn anchor(heading: &str) -> String {
    let dashed = heading.to_lowercase().replace(' ', "-");
    dashed.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect()
}

#[test]
fn most_errata_are_in_chinese() {
    let (spec, text) = (spec(), reference_zh(&spec()));
    let errata: Vec<_> = spec.commands().flat_map(|command| &command.errata).collect();
    let english = errata.iter().filter(|erratum| text.contains(erratum.as_str())).count();
    assert!(english * 10 < errata.len(), "{english} of {} are in English", errata.len());
}

#[test]
fn docs_call_commands_and_fields_as_the_wire_does() {
    let text = r#"
title = "Lamps"
doc = "See `set_lamp`."

[[command]]
wire = "set lamp"
name = "set_lamp"
effect = "setting"
doc = "Sets a lamp to `colour`."
errata = ["The text has the key `colour`."]

[[command.request]]
wire = "col"
name = "colour"
type = "text"
doc = "Colour, which `level` dims. See `set_lamp`, not `set_lamps`."

[[command.request]]
wire = "level"
type = "int"
doc = "Level."
"#;
    let spec = load(&[Source { path: "spec/lamps.toml", text }]).expect("the spec is correct");
    let text = reference(&spec);
    for expected in [
        "See `set lamp`.",
        "Sets a lamp to `col`.",
        "The text has the key `colour`.",
        "Colour, which `level` dims.",
        "See `set lamp`, not `set_lamps`.",
        "`Client::set_lamp`",
    ] {
        assert!(text.contains(expected), "{expected}");
    }
}

#[test]
fn what_the_built_in_spec_does_not_have() {
    let text = r#"
title = "Lamps <new>"
doc = "Lamps a|b and `a<b`."

[[command]]
wire = "set lamp"
name = "set_lamp"
effect = "setting"
requires = ["powered"]
since = "1.6"
reply_certain = false
doc = "Sets a lamp. It glows."

[[command.request]]
wire = "label"
type = "text"
ascii = true
until = "1.7"
doc = "Label, `a|b` or <none>."

[[command.request]]
wire = "levels"
type = "float[3][]"
unit = "%"
max = 100
advisory = true
doc = "Brightness."

[[command.request]]
wire = "colour"
type = "Colour"
optional = true
doc = "Colour."

[[type]]
name = "Colour"
kind = "enum"
doc = "A colour."

[[type.value]]
wire = "red"
name = "Red"
doc = "Red."

[[type.value]]
wire = "blue"
name = "Blue"
doc = "Blue. Rare."
advisory = true
"#;
    let spec = load(&[Source { path: "spec/lamps.toml", text }]).expect("the spec is correct");
    let text = reference(&spec);
    let index = text.find("## Topics").expect("there is an index");
    expect![[r"
        ## Topics

        **[Lamps \<new>](#lamps-new)**

        - [`set lamp`](#command-set-lamp): Sets a lamp.
        - Types: [`Colour`](#type-colour)

        ## Sections of the document

        | command | topic | effect |
        | --- | --- | --- |
        | [`set lamp`](#command-set-lamp) | [Lamps &lt;new>](#lamps-new) | setting |

        ## Lamps \<new>

        Lamps a\|b and `a<b`.

        ### Command `set lamp`

        Sets a lamp. It glows.

        - Effect: setting.
        - In Rust: `Client::set_lamp`.
        - The robot must be powered.
        - The controller may close the connection instead of replying.
        - Known to firmware 1.6 and later.

        **Request**, in addition to `cmdName`:

        | key | type | unit | range | optional | meaning |
        | --- | --- | --- | --- | --- | --- |
        | `label` | string, printable ASCII only |  |  |  | Label, `a\|b` or &lt;none>. Firmware up to 1.7. |
        | `levels` | array of arrays of 3 numbers | % | at most 100; newer firmware takes more |  | Brightness. |
        | `colour` | [`Colour`](#type-colour) (string) |  |  | optional | Colour. |

        **Reply**: `errorCode`, `errorMsg` and `cmdName` alone.

        ### Type `Colour`

        A colour.

        A string:

        | value | name | meaning | firmware |
        | --- | --- | --- | --- |
        | `red` | Red | Red. |  |
        | `blue` | Blue | Blue. | newer only |

        - `blue`: Rare.
    "]]
    .assert_eq(&text[index..]);
}

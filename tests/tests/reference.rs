//! The committed reference of the protocol: it is up to date, and its links lead somewhere.

use std::collections::BTreeSet;

use expect_test::expect_file;
use jaka_spec::tools::reference;
use jaka_tests::spec;

#[test]
fn the_committed_reference_is_that_of_the_spec() {
    expect_file!["../../spec/REFERENCE.md"].assert_eq(&reference(&spec()));
}

#[test]
fn every_link_leads_to_one_heading() {
    let text = reference(&spec());
    let mut anchors = BTreeSet::new();
    for heading in headings(&text) {
        assert!(anchors.insert(anchor(heading)), "two headings have the anchor of `{heading}`");
    }
    let links: Vec<_> = text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    for link in &links {
        let target = link.strip_prefix('#').unwrap_or_else(|| panic!("`{link}` leads out of the reference"));
        assert!(anchors.contains(target), "nothing has the anchor `{target}`");
    }
    let commands = spec().commands().count();
    assert!(links.len() > 2 * commands, "both indexes link to each command");
}

#[test]
fn everything_of_the_spec_is_in_it() {
    let (spec, text) = (spec(), reference(&spec()));
    let headings: Vec<_> = headings(&text).collect();
    for command in spec.commands() {
        let section = command.section.as_deref().expect("the built-in commands have sections");
        assert!(headings.contains(&format!("{section} `{}`", command.wire).as_str()), "{}", command.wire);
        for message in command.examples.iter().flat_map(|example| example.request.iter().chain(&example.reply)) {
            assert!(text.contains(&format!("```json\n{message}\n```")), "{}: {message}", command.wire);
        }
    }
    for def in spec.types() {
        assert!(headings.contains(&format!("Type `{}`", def.name).as_str()), "{}", def.name);
    }
    for error in spec.errors() {
        assert!(text.contains(&format!("| {} | {} |", error.wire, error.name)), "{}", error.wire);
    }
}

#[test]
fn the_tables_have_as_many_cells_as_their_heads() {
    let text = reference(&spec());
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

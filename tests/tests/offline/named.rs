//! Members of types that code spans of pages and comments name, functions that the excuses of mutation testing name,
//! and blocks of code that nothing compiles.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use jaka_tests::spec;

use crate::architecture::{all_files, code, is_word, read, root, tokens};

/// Members of types by the types' names: functions, constants, variants and fields.
type Members = BTreeMap<String, BTreeSet<String>>;

/// The tokens up to the end of the braces that the first one opens, without both.
fn braced<'s, 't>(tokens: &'s [&'t str]) -> &'s [&'t str] {
    let mut depth = 0_usize;
    let end = tokens.iter().position(|token| {
        depth = match *token {
            "{" => depth + 1,
            "}" => depth.saturating_sub(1),
            _ => depth,
        };
        depth == 0
    });
    &tokens[1..end.unwrap_or(tokens.len()).max(1)]
}

/// Words in a body that may name a member: those that begin an entry, and those after `fn`, `const` and `type`.
fn entries<'t>(body: &[&'t str]) -> BTreeSet<&'t str> {
    let (mut depth, mut found, mut before) = (0_i32, BTreeSet::new(), "{");
    for token in body {
        let begins = ["{", ",", ";", "}", "]", ")", "pub"].contains(&before) && depth == 0;
        if is_word(token) && (begins || ["fn", "const", "type"].contains(&before)) {
            found.insert(*token);
        }
        depth += i32::from(["{", "(", "["].contains(token)) - i32::from(["}", ")", "]"].contains(token));
        before = token;
    }
    found
}

/// Code without strings and characters, whose braces open and close nothing.
fn without_literals(code: &str) -> String {
    let mut code = code.to_owned();
    for character in ["{", "}", "[", "]", "(", ")", "\"", "\\\""] {
        code = code.replace(&format!("'{character}'"), "");
    }
    let line = |line: &str| line.replace("\\\"", "").split('"').step_by(2).collect::<String>();
    code.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// Adds the members that a file declares. Those of macros count where the macro's rows look like declarations.
fn declare(text: &str, members: &mut Members) {
    let code = without_literals(&code(text));
    let tokens = tokens(&code);
    for (at, token) in tokens.iter().enumerate() {
        if !["struct", "enum", "trait", "impl"].contains(token) {
            continue;
        }
        let Some(end) = tokens[at..].iter().position(|token| ["{", ";"].contains(token)) else { continue };
        let header = &tokens[at + 1..at + end];
        let names = header.iter().filter(|name| name.starts_with(char::is_uppercase));
        let body = if tokens[at + end] == "{" { entries(braced(&tokens[at + end..])) } else { BTreeSet::new() };
        let only = if *token == "impl" { usize::MAX } else { 1 };
        for name in names.take(only) {
            members.entry((*name).to_owned()).or_default().extend(body.iter().map(|&name| name.to_owned()));
        }
    }
}

fn members() -> Members {
    let mut members = Members::new();
    for path in all_files(root(), "rs") {
        declare(&read(&path), &mut members);
    }
    members.entry("Client".to_owned()).or_default().extend(spec().commands().map(|command| command.name.clone()));
    members
}

/// The type and the member that a code span names: the last two words of a path, without arguments.
fn named(span: &str) -> Option<(&str, &str)> {
    let path = span.split(['(', '<']).next()?;
    let (of, member) = path.rsplit_once("::")?;
    let of = of.rsplit("::").next()?;
    let is_name = |name: &str| !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    (is_name(of) && is_name(member) && of.starts_with(char::is_uppercase)).then_some((of, member))
}

/// The spans of code in a line, without those in links, which rustdoc resolves.
fn spans(line: &str) -> Vec<&str> {
    let parts: Vec<_> = line.split('`').collect();
    (1..parts.len()).step_by(2).filter(|&at| !parts[at - 1].ends_with('[')).map(|at| parts[at]).collect()
}

/// The prose of a page, or of the comments of a source file. A README that is made from an overview has none: its spans
/// are links there.
fn prose(path: &Path) -> String {
    if path.ends_with("README.md") && path.with_file_name("docs/overview.md").exists() {
        return String::new();
    }
    let text = read(path);
    if path.extension().is_some_and(|own| own == "rs") {
        let comments = text.lines().filter_map(|line| line.split_once("//").map(|(_, comment)| comment));
        return comments.map(|comment| comment.trim_start_matches(['/', '!'])).collect::<Vec<_>>().join("\n");
    }
    text.split("```").step_by(2).collect()
}

#[test]
fn each_member_that_a_code_span_names_is_there() {
    let members = members();
    let (mut count, mut dead) = (0, BTreeSet::new());
    for path in all_files(root(), "md").into_iter().chain(all_files(root(), "rs")) {
        for line in prose(&path).lines() {
            for (of, member) in spans(line).into_iter().filter_map(named) {
                count += 1;
                let is_there = members.get(of).is_some_and(|members| members.contains(member));
                if !is_there {
                    dead.insert(format!("{of}::{member} in {}", path.display()));
                }
            }
        }
    }
    assert!(count > 200, "{count} members");
    assert!(dead.is_empty(), "{dead:#?}");
}

#[test]
fn each_function_of_an_excuse_is_there() {
    let members = members();
    let list = read(&root().join(".cargo/mutants.toml"));
    let excuses = list.lines().map(str::trim).filter(|line| line.starts_with("\"replace "));
    // `replace … in Type<…>::function`, or `replace Type<…>::function -> … with …`.
    let functions = excuses.map(|line| match line.rsplit_once(" in ") {
        Some((_, function)) => function.trim_matches(['"', ',']),
        None => line.trim_start_matches("\"replace ").split(" ->").next().unwrap_or(line),
    });
    let methods: Vec<_> = functions.filter_map(|function| Some((function, function.rsplit_once("::")?))).collect();
    assert!(methods.len() > 10, "{methods:?}");
    for (function, (of, name)) in methods {
        let of = of.split('<').next().unwrap_or(of);
        assert!(members.get(of).is_some_and(|members| members.contains(name)), "there is no `{function}`");
    }
}

#[test]
fn each_test_that_writes_is_there() {
    let script = read(&root().join(".ci/regenerate"));
    let (_, list) = script.split_once("writers=(").expect("it lists them");
    let names: Vec<_> = list.split(')').next().unwrap_or_default().split_whitespace().collect();
    assert!(names.len() > 10, "{names:?}");
    // The file of a test ends with the last module of its name.
    let tests: Vec<_> = all_files(root(), "rs").into_iter().map(|path| (read(&path), path)).collect();
    for name in names {
        let mut words = name.rsplit("::");
        let (function, module) = (words.next().unwrap_or(name), words.next().unwrap_or(name));
        let declares = |text: &str| text.contains(&format!("fn {function}("));
        let is_there =
            |(text, path): &(String, PathBuf)| declares(text) && path.file_stem().is_some_and(|stem| stem == module);
        assert!(tests.iter().any(is_there), "there is no test `{name}`");
    }
}

#[test]
fn each_block_of_rust_is_compiled() {
    let comment = |line: &str| line.trim_start().trim_start_matches(['/', '!']).trim_start().to_owned();
    for path in all_files(root(), "md").into_iter().chain(all_files(root(), "rs")) {
        let text = read(&path);
        let left_out = text.lines().map(comment).find(|line| line.starts_with("```") && line.contains("ignore"));
        assert_eq!(left_out, None, "{}", path.display());
    }
}

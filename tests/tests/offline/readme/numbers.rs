//! Numbers of commands in prose that greets a reader: those of the spec.
//!
//! Figures of docs/performance.md belong to the day on which they were measured, and stay as they are.

use expect_test::expect_file;
use jaka_tests::spec;

use super::{read, root};

/// Phrases with numbers of commands: `{document}` for those of the vendor's document, `{beyond}` for the others.
const PHRASES: [(&str, &str); 5] = [
    (
        "README.md",
        "**All {document} commands** of the vendor's TCP protocol 2.0.4, sections 4.1 to 4.{document}, and \
         {beyond} that newer firmware has",
    ),
    (
        "README.zh.md",
        "**全部 {document} 条命令**（厂家 TCP 协议 2.0.4，4.1 至 4.{document} 节）以及较新固件的 {beyond} 条命令",
    ),
    ("jaka-sim/docs/overview.md", "All {document} commands of the document"),
    ("jaka-sync/docs/overview.md", "All {document} commands of the vendor's TCP protocol"),
    ("jaka-sync/Cargo.toml", "all {document} commands of the TCP protocol"),
];

/// Numbers of commands, by their names in phrases.
fn numbers() -> [(&'static str, usize); 2] {
    let spec = spec();
    let of_document = spec.commands().filter(|command| command.section.is_some()).count();
    [("document", of_document), ("beyond", spec.commands().count() - of_document)]
}

/// The text with these numbers in the place where the phrase stands with any; `None` if it does not stand.
fn with_numbers(text: &str, phrase: &str, numbers: &[(&str, usize)]) -> Option<String> {
    let begin = phrase.split('{').next().unwrap_or_default();
    text.match_indices(begin).find_map(|(at, _)| {
        let (mut rest, mut out) = (&text[at..], text[..at].to_owned());
        for (index, part) in phrase.split(['{', '}']).enumerate() {
            if index % 2 == 0 {
                rest = rest.strip_prefix(part)?;
                out += part;
                continue;
            }
            let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
            if after.len() == rest.len() {
                return None;
            }
            let (_, number) = numbers.iter().find(|(name, _)| *name == part)?;
            out += &number.to_string();
            rest = after;
        }
        Some(out + rest)
    })
}

#[test]
fn numbers_of_commands_are_those_of_the_spec() {
    for (page, phrase) in PHRASES {
        let path = root().join(page);
        let text = with_numbers(&read(&path), phrase, &numbers());
        let text =
            text.unwrap_or_else(|| panic!("{page} does not have the phrase `{phrase}`: it is listed in PHRASES"));
        expect_file![path].assert_eq(&text);
    }
}

/// A number that no phrase has would not be kept up to date.
#[test]
fn no_other_number_of_commands_stands_in_the_pages() {
    let crates = std::fs::read_dir(root()).expect("it is there").map(|entry| entry.expect("it can be read").path());
    let files = crates.flat_map(|folder| ["Cargo.toml", "docs/overview.md"].map(|name| folder.join(name)));
    let pages = ["README.md", "README.zh.md", "spec/README.md", "jaka-cli/README.md", "jaka-proto-derive/README.md"];
    let mut files: Vec<_> = files.filter(|path| path.exists()).collect();
    files.extend(pages.map(|page| root().join(page)));
    let mut count = 0;
    for path in files {
        let own = PHRASES.iter().filter(|(page, _)| root().join(page) == path).map(|(_, phrase)| *phrase);
        let own: usize = own.map(counted).sum();
        assert_eq!(counted(&read(&path)), own, "{}: numbers of commands in phrases of PHRASES", path.display());
        count += own;
    }
    assert!(count >= PHRASES.len(), "{count}");
}

/// Number of places in a text that state a number of commands.
fn counted(text: &str) -> usize {
    let is_number = |before: &str| before.trim_end().ends_with(|c: char| c.is_ascii_digit() || c == '}');
    let words = [" commands", " 条命令"];
    words.iter().flat_map(|word| text.match_indices(word)).filter(|(at, _)| is_number(&text[..*at])).count()
}

#[test]
fn a_phrase_takes_numbers_where_it_stands() {
    let put = |text| with_numbers(text, "all {a} of 4.{a} and {b}", &[("a", 9), ("b", 12)]);
    assert_eq!(put("It: all 82 of 4.8 and 3.").as_deref(), Some("It: all 9 of 4.9 and 12."));
    assert_eq!(put("all of, all 1 of 4.2 and 3").as_deref(), Some("all of, all 9 of 4.9 and 12"));
    assert_eq!(put("all 82 of 4. and 3"), None);
}

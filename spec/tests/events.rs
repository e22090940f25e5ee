//! The controller's events: what the built-in table has, and what users read when a table is wrong.

use std::collections::BTreeSet;

use expect_test::{Expect, expect};
use jaka_spec::{Event, Severity, Source, Spec, builtin, load};

fn spec() -> Spec {
    builtin().expect("the built-in spec is correct")
}

/// The figures were taken from the vendor's table itself: JakaCobot.github.io, `docs/en/guide/errinfo.md`, February 2024. The
/// sums tell codes apart that counts do not.
#[test]
fn the_table_has_the_codes_and_severities_of_the_vendors() {
    let spec = spec();
    let of = |severity: Severity| {
        let codes: Vec<_> = spec.events().filter(|event| event.severity == severity).flat_map(Event::codes).collect();
        (codes.len(), codes.iter().map(|code| u64::from(*code)).sum::<u64>())
    };
    assert_eq!(of(Severity::Error), (560, 759_052_835_u64));
    assert_eq!(of(Severity::Warning), (228, 1_010_243_225));
    assert_eq!(of(Severity::Information), (106, 1_865_858_027));
    let codes: BTreeSet<_> = spec.events().flat_map(Event::codes).collect();
    assert_eq!(codes.len(), 894, "no code stands twice");
}

/// Loads `text` as `spec/test.toml` and compares the errors.
fn check(text: &str, expected: &Expect) {
    let text = format!("title = \"Test\"\n{text}");
    let errors = match load(&[Source { path: "spec/test.toml", text: &text }]) {
        Ok(_) => String::new(),
        Err(errors) => errors.to_string() + "\n",
    };
    expected.assert_eq(&errors);
}

#[test]
fn codes_that_are_none() {
    check(
        r#"
[[event]]
severity = "error"
codes = ["0F0034", "0x", "0xG", "0x+1", "0x0", "0x100000000", "0x1-", "-0x1", "0x1-0x2-0x3", "0x1 - 0x2", ""]
"#,
        &expect![[r"
            spec/test.toml:5:10: event: `0F0034` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:20: event: `0x` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:26: event: `0xG` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:33: event: `0x+1` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:41: event: 0 says that there is no event
            spec/test.toml:5:48: event: `0x100000000` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:63: event: `0x1-` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:71: event: `-0x1` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:79: event: `0x1-0x2-0x3` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:94: event: `0x1 - 0x2` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
            spec/test.toml:5:107: event: `` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009
        "]],
    );
}

#[test]
fn ranges_that_go_nowhere_or_too_far() {
    check(
        r#"
[[event]]
severity = "error"
codes = ["0x2-0x1", "0x3-0x3", "0x100-0x1FF", "0x200-0x300", "0x0-0x5"]
"#,
        &expect![[r"
            spec/test.toml:5:10: event: `0x2-0x1` does not go from a code to a greater one
            spec/test.toml:5:21: event: `0x3-0x3` does not go from a code to a greater one
            spec/test.toml:5:47: event: `0x200-0x300` has more than 256 codes
            spec/test.toml:5:62: event: 0 says that there is no event
        "]],
    );
}

#[test]
fn a_code_has_one_severity_and_one_meaning() {
    check(
        r#"
[[event]]
severity = "error"
codes = ["0x10-0x20", "0x15", "0x30"]

[[event]]
severity = "warning"
codes = [
    "0x000030",
    "0x20-0x2F",
    "0x01-0x10",
    "0x05-0x50",
    "0x21-0x2F",
]
meaning = "a warning"
"#,
        &expect![[r"
            spec/test.toml:5:23: event: the code 0x000015 is taken already, at spec/test.toml:5:10
            spec/test.toml:10:5: event: the code 0x000030 is taken already, at spec/test.toml:5:31
            spec/test.toml:11:5: event: the code 0x000020 is taken already, at spec/test.toml:5:10
            spec/test.toml:12:5: event: the code 0x000010 is taken already, at spec/test.toml:5:10
            spec/test.toml:13:5: event: the code 0x000030 is taken already, at spec/test.toml:5:31
        "]],
    );
}

#[test]
fn keys_that_are_missing_unknown_or_of_the_wrong_type() {
    check(
        r#"
[[event]]

[[event]]
severity = "info"
codes = [1, "0x1"]
text = "A text."

[[event]]
severity = "warning"
codes = []
meaning = "A sentence."

[[event]]
severity = "warning"
codes = "0x2"
meaning = "two\nlines"

[[event]]
severity = "warning"
codes = ["0x3"]
meaning = ""
"#,
        &expect![[r"
            spec/test.toml:3:1: event: `codes` is missing or empty
            spec/test.toml:3:1: event: `severity` is missing
            spec/test.toml:6:12: event: `severity` is one of error, warning, information, not `info`
            spec/test.toml:7:10: event: `codes` must be a list of strings
            spec/test.toml:8:1: event: unknown key `text`; the keys are codes, meaning, severity
            spec/test.toml:10:1: event: `codes` is missing or empty
            spec/test.toml:13:11: event: `meaning` is a phrase on one line, without full stop
            spec/test.toml:15:1: event: `codes` is missing or empty
            spec/test.toml:17:9: event: `codes` must be a list of strings
            spec/test.toml:18:11: event: `meaning` is a phrase on one line, without full stop
            spec/test.toml:23:11: event: `meaning` is a phrase on one line, without full stop
        "]],
    );
}

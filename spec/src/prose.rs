//! Text of a spec or of a pack as prose: Markdown in which nothing becomes code, HTML, a link or a table.
//!
//! A pack is somebody else's text, perhaps with a controller's own words in it, and rustdoc runs what it takes for code
//! as a test of the user who compiles the pack. So paragraphs, headings, lists, emphasis and code spans are kept, and
//! what Markdown could take for more loses its meaning by a backslash. Nothing is indented so far that it would be
//! code, and invisible characters are escapes.

use std::fmt::Write;
use std::ops::RangeInclusive;

/// The most blanks at the beginning of a line: with one more it would be code.
const MOST_INDENT: usize = 3;

/// The text as prose, with the same lines.
///
/// ```
/// let hostile = "What `a<b>` is:\n\n```\npanic!()\n```\n    panic!()";
/// assert_eq!(jaka_spec::prose::prose(hostile), "What `a<b>` is:\n\n\\`\\`\\`\npanic!()\n\\`\\`\\`\n   panic!()");
/// ```
pub fn prose(text: &str) -> String {
    linked_prose(text, |_| None)
}

/// The text as prose; a code span becomes a link if its content has a target.
///
/// ```
/// let target = |name: &str| (name == "joint_move").then(|| "JointMove".to_owned());
/// let text = jaka_spec::prose::linked_prose("As `joint_move`, not `jog`.", target);
/// assert_eq!(text, "As [`joint_move`](JointMove), not `jog`.");
/// ```
pub fn linked_prose(text: &str, target: impl Fn(&str) -> Option<String>) -> String {
    let lines: Vec<_> = text.lines().map(|line| prose_line(&shown(line), &target)).collect();
    lines.join("\n")
}

/// The text in one line as a code span.
pub fn code_span(text: &str) -> String {
    let text = shown(text);
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or_default();
    let marks = "`".repeat(longest + 1);
    // A longer mark at the beginning of a line could begin a block of code.
    match longest {
        0 => format!("`{text}`"),
        1 => format!("{marks} {text} {marks}"),
        _ => format!("`{}`", text.replace('`', "'")),
    }
}

/// The text in one line, with escapes for the characters that nobody sees, ends of lines among them. Tabs count as
/// blanks.
pub fn shown(line: &str) -> String {
    let mut out = String::with_capacity(line.len());
    for c in line.chars() {
        match c {
            '\t' => out.push(' '),
            c if is_hidden(c) => {
                // A string takes all that is written.
                let _ = write!(out, "\\u{{{:x}}}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out
}

/// The general categories Cf, Zl and Zp of Unicode: characters that direct the text around them without being seen, and
/// separators of lines and paragraphs. `jaka_proto::text` has them from here.
#[rustfmt::skip]
pub const HIDDEN: &[RangeInclusive<char>] = &[
    '\u{ad}'..='\u{ad}', '\u{600}'..='\u{605}', '\u{61c}'..='\u{61c}', '\u{6dd}'..='\u{6dd}', '\u{70f}'..='\u{70f}',
    '\u{890}'..='\u{891}', '\u{8e2}'..='\u{8e2}', '\u{180e}'..='\u{180e}', '\u{200b}'..='\u{200f}', '\u{2028}'..='\u{202e}',
    '\u{2060}'..='\u{206f}', '\u{feff}'..='\u{feff}', '\u{fff9}'..='\u{fffb}', '\u{110bd}'..='\u{110bd}', '\u{110cd}'..='\u{110cd}',
    '\u{13430}'..='\u{1343f}', '\u{1bca0}'..='\u{1bca3}', '\u{1d173}'..='\u{1d17a}', '\u{e0001}'..='\u{e0001}', '\u{e0020}'..='\u{e007f}',
];

/// True for control characters, and for characters of [`HIDDEN`].
pub(crate) fn is_hidden(c: char) -> bool {
    c.is_control() || HIDDEN.iter().any(|range| range.contains(&c))
}

fn prose_line(line: &str, target: &impl Fn(&str) -> Option<String>) -> String {
    let mut rest = line.trim_start_matches(' ');
    if rest.is_empty() {
        return String::new();
    }
    let mut out = " ".repeat((line.len() - rest.len()).min(MOST_INDENT));
    while let Some(first) = rest.chars().next() {
        rest = match first {
            '`' => push_backticks(&mut out, rest, target),
            '~' => push_run(&mut out, rest, '~', 2),
            '\\' => push_escaped(&mut out, rest),
            ' ' => {
                // After the mark of a list, more of them would begin code.
                out.push(' ');
                rest.trim_start_matches(' ')
            }
            _ => {
                if first == '[' || first == '|' || first == '<' && begins_html(&rest[1..]) {
                    out.push('\\');
                }
                out.push(first);
                &rest[first.len_utf8()..]
            }
        };
    }
    out
}

/// A code span as it is or as a link, or backticks that are not part of one. Gives what follows.
fn push_backticks<'t>(out: &mut String, text: &'t str, target: &impl Fn(&str) -> Option<String>) -> &'t str {
    let len = run(text, '`');
    let rest = &text[len..];
    // A span that ends in another line would have other partners there.
    let end = (len < 3).then(|| closing(rest, len)).flatten();
    let Some(end) = end else { return push_run(out, text, '`', 0) };
    let (span, rest) = text.split_at(len + end);
    // After an exclamation mark a link would be an image.
    let target = (!out.ends_with('!')).then(|| target(span.trim_matches('`'))).flatten();
    *out += &target.map_or_else(|| span.to_owned(), |target| format!("[{span}]({target})"));
    rest
}

/// The end of a code span: after the next run of exactly that many backticks.
fn closing(text: &str, len: usize) -> Option<usize> {
    let mut at = 0;
    while let Some(found) = text[at..].find('`') {
        at += found;
        let found = run(&text[at..], '`');
        at += found;
        if found == len {
            return Some(at);
        }
    }
    None
}

/// Writes a run of a character, each after a backslash where there are more than `most`. Returns the rest.
fn push_run<'t>(out: &mut String, text: &'t str, c: char, most: usize) -> &'t str {
    let len = run(text, c);
    for _ in 0..len {
        if len > most {
            out.push('\\');
        }
        out.push(c);
    }
    &text[len..]
}

/// A backslash with what it escapes. Gives what follows.
fn push_escaped<'t>(out: &mut String, text: &'t str) -> &'t str {
    let escaped = text[1..].chars().next().filter(char::is_ascii_punctuation);
    out.push('\\');
    out.extend(escaped);
    &text[1 + escaped.map_or(0, char::len_utf8)..]
}

fn run(text: &str, c: char) -> usize {
    text.len() - text.trim_start_matches(c).len()
}

fn begins_html(rest: &str) -> bool {
    rest.starts_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '/' | '!' | '?'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_text_stays_as_it_is() {
        let text = "Sets `a[0] | <b>`, ``c`d`` and *e*: x < 5.\n\n# Errata\n\n- one\n  more\n1. two\n\n> said ~~not~~ \\* 关节";
        assert_eq!(prose(text), text);
    }

    #[test]
    fn what_could_be_more_than_prose_is_escaped() {
        for (text, expected) in [
            ("```rust\npanic!()\n```", "\\`\\`\\`rust\npanic!()\n\\`\\`\\`"),
            ("- ~~~\n  panic!()", "- \\~\\~\\~\n  panic!()"),
            ("\tpanic!()\n     panic!()", " panic!()\n   panic!()"),
            ("-     panic!()\n> \t panic!()", "- panic!()\n> panic!()"),
            ("a\r```", "a\\u{d}\\`\\`\\`"),
            ("a ` b\n`<script>`", "a \\` b\n`<script>`"),
            ("<script>x</script> <!-- \\<b>", "\\<script>x\\</script> \\<!-- \\<b>"),
            ("[`Foo`](http://x) ![y](z)\n[a]: b", "\\[`Foo`](http://x) !\\[y](z)\n\\[a]: b"),
            ("| a |\n|---|", "\\| a \\|\n\\|---\\|"),
            ("a\u{1b}[2J\u{202e}b", "a\\u{1b}\\[2J\\u{202e}b"),
            ("\\\\<b>\\", "\\\\\\<b>\\"),
        ] {
            assert_eq!(prose(text), expected, "{text:?}");
        }
    }

    #[test]
    fn a_code_span_with_a_target_is_a_link() {
        let target = |name: &str| (name == "jog").then(|| "Jog".to_owned());
        for (text, expected) in [
            ("`jog`, `Jog` and ``jog``.", "[`jog`](Jog), `Jog` and [``jog``](Jog)."),
            ("[`jog`](x) !`jog`", "\\[[`jog`](Jog)](x) !`jog`"),
            ("a ` jog` `jog", "a ` jog` \\`jog"),
        ] {
            assert_eq!(linked_prose(text, target), expected, "{text:?}");
        }
    }

    #[test]
    fn a_code_span_holds_whatever_it_is_given() {
        for (text, expected) in
            [("a", "`a`"), ("a`b", "`` a`b ``"), ("```a", "`'''a`"), ("a\nb", "`a\\u{a}b`"), ("`", "`` ` ``")]
        {
            assert_eq!(code_span(text), expected);
        }
    }
}

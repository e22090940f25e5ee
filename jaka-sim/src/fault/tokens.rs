//! Tokens of a script.

use std::fmt;

use super::ScriptError;

/// Characters that end a token, in addition to white space.
const MARKS: [char; 5] = [',', ';', '#', '"', ':'];

/// Word in its text form, with its quoted bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Token<'s> {
    pub(super) line: usize,
    pub(crate) text: &'s str,
    /// Bytes between the quotes, with escapes replaced.
    pub(super) quoted: Option<Vec<u8>>,
}

impl Token<'_> {
    pub(super) fn error(&self, reason: impl Into<String>) -> ScriptError {
        ScriptError::new(self.line, self.text, reason)
    }
}

/// Returns the tokens of each line that has any; a line ends at its end or at a semicolon. Commas and colons are
/// tokens.
pub(super) fn lines(script: &str) -> Result<Vec<Vec<Token<'_>>>, ScriptError> {
    let mut lines = Vec::new();
    for (line, text) in (1..).zip(script.lines()) {
        let mut tokens = Vec::new();
        let mut rest = text.trim_start();
        while let Some(word) = next_word(line, rest)? {
            rest = rest[word.text.len()..].trim_start();
            if word.text == ";" {
                lines.push(std::mem::take(&mut tokens));
            } else {
                tokens.push(word);
            }
        }
        lines.push(tokens);
    }
    lines.retain(|tokens| !tokens.is_empty());
    Ok(lines)
}

fn next_word(line: usize, rest: &str) -> Result<Option<Token<'_>>, ScriptError> {
    let (len, quoted) = match rest.bytes().next() {
        None | Some(b'#') => return Ok(None),
        Some(b',' | b';' | b':') => (1, None),
        Some(b'"') => {
            let unfit = |reason| ScriptError::new(line, rest, reason);
            let len = quoted_len(rest).ok_or_else(|| unfit("the quote is not closed"))?;
            let bytes = unescape(&rest[1..len - 1]).ok_or_else(|| unfit("an escape is not one of Rust's for bytes"))?;
            (len, Some(bytes))
        }
        Some(_) => (rest.find(|c: char| c.is_whitespace() || MARKS.contains(&c)).unwrap_or(rest.len()), None),
    };
    Ok(Some(Token { line, text: &rest[..len], quoted }))
}

/// Returns the length of the quoted word at the start of the text, including the quotes.
fn quoted_len(text: &str) -> Option<usize> {
    let mut escaped = false;
    let end = text.bytes().skip(1).position(|byte| {
        let ends = byte == b'"' && !escaped;
        escaped = byte == b'\\' && !escaped;
        ends
    });
    end.map(|at| at + 2)
}

/// Returns the bytes of a text with escapes.
fn unescape(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'\\' => match rest.next()? {
                b'n' => b'\n',
                b'r' => b'\r',
                b't' => b'\t',
                b'0' => 0,
                b'x' => hex_digit(rest.next()?)? << 4 | hex_digit(rest.next()?)?,
                quote @ (b'"' | b'\'' | b'\\') => quote,
                _ => return None,
            },
            plain => plain,
        });
    }
    Some(bytes)
}

fn hex_digit(byte: u8) -> Option<u8> {
    u8::try_from(char::from(byte).to_digit(16)?).ok()
}

/// Name as a word, quoted if necessary.
pub(super) struct Name<'n>(pub(super) &'n str);

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = !self.0.is_empty() && self.0.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        if plain { f.write_str(self.0) } else { write!(f, "\"{}\"", self.0.as_bytes().escape_ascii()) }
    }
}

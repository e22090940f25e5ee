//! Python literals as JSON text and back, so that one decoder reads both.
//!
//! Controllers print some values with Python's `repr`: the string `extio_status`, and the whole reply of
//! `get_extio_status` where no module is fitted (4.34). [`to_json`] reads such text; [`from_json`] writes it,
//! for a simulated controller.

use std::error::Error;
use std::fmt::{self, Write};

/// The most brackets that may be open at once.
const MAX_DEPTH: usize = 64;

/// Turns a Python literal into JSON text, without white space.
///
/// - Tuples and lists become arrays, dicts with string keys become objects, and `(1)` is just `1`.
/// - Strings stand in either quotes, with Python 2's `u` or without. Adjacent `\xNN` are read as UTF-8 where there
///   is no `u` and they are valid: so Python 2 prints a name that is not ASCII. Otherwise each is a code point.
/// - Numbers pass as text, without Python 2's `L`; `nan` and `inf` are refused, for JSON knows neither.
/// - `True`, `False` and `None` become `true`, `false` and `null`.
///
/// ```
/// let json = jaka_proto::python::to_json("(0, [], {'state': 0})")?;
/// assert_eq!(json, r#"[0,[],{"state":0}]"#);
/// # Ok::<(), jaka_proto::python::PythonError>(())
/// ```
pub fn to_json(literal: &str) -> Result<String, PythonError> {
    Transcoder::new(Language::Python, literal).run(Transcoder::python_value)
}

/// Turns JSON text into a Python literal in the controller's style.
///
/// Arrays become tuples, objects become dicts, and strings stand in single quotes.
///
/// ```
/// let literal = jaka_proto::python::from_json(r#"[1, [8], {"on": true}]"#)?;
/// assert_eq!(literal, "(1, (8,), {'on': True})");
/// # Ok::<(), jaka_proto::python::PythonError>(())
/// ```
pub fn from_json(json: &str) -> Result<String, PythonError> {
    Transcoder::new(Language::Json, json).run(Transcoder::json_value)
}

/// Text that cannot be read: where that shows, and what was expected there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PythonError {
    language: Language,
    position: usize,
    expected: &'static str,
}

impl PythonError {
    /// Where, as an offset in bytes.
    pub fn position(&self) -> usize {
        self.position
    }

    /// What was expected there, such as `a value`.
    pub fn expected(&self) -> &'static str {
        self.expected
    }
}

impl fmt::Display for PythonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let language = match self.language {
            Language::Python => "python literal",
            Language::Json => "json text",
        };
        write!(f, "{language}: expected {} at byte {}", self.expected, self.position)
    }
}

impl Error for PythonError {}

/// The language that is read; the other one is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Language {
    Python,
    Json,
}

type Step = Result<(), PythonError>;

/// Reads one language from the front of `text` and writes the other to `out`.
struct Transcoder<'a> {
    language: Language,
    text: &'a str,
    /// Offset of the next byte to read, always between two characters.
    at: usize,
    depth: usize,
    out: String,
}

/// What stood between two brackets.
struct Items {
    count: usize,
    commas: usize,
}

/// Reading Python, writing JSON.
impl Transcoder<'_> {
    fn python_value(&mut self) -> Step {
        match self.token() {
            Some(b'(') => self.python_tuple(),
            Some(b'[') => self.python_items(b']', Self::python_value),
            Some(b'{') => self.python_items(b'}', Self::python_entry),
            Some(b'\'' | b'"' | b'u' | b'U') => self.python_string(),
            Some(b'0'..=b'9' | b'-' | b'+' | b'.') => self.number(),
            _ => self.word([("True", "true"), ("False", "false"), ("None", "null")]),
        }
    }

    /// Reads a tuple, or a value in parentheses: only a comma tells the two apart.
    fn python_tuple(&mut self) -> Step {
        let begin = self.out.len();
        self.out.push('[');
        let items = self.items(b')', Self::python_value)?;
        if items.count == 1 && items.commas == 0 {
            self.out.remove(begin);
        } else {
            self.out.push(']');
        }
        Ok(())
    }

    /// Reads a list or a dict, whose brackets are JSON's.
    fn python_items(&mut self, close: u8, item: fn(&mut Self) -> Step) -> Step {
        self.out.push(if close == b']' { '[' } else { '{' });
        self.items(close, item)?;
        self.out.push(char::from(close));
        Ok(())
    }

    fn python_entry(&mut self) -> Step {
        self.python_string()?;
        self.colon(":")?;
        self.python_value()
    }

    fn python_string(&mut self) -> Step {
        let unicode = self.eat(b'u') || self.eat(b'U');
        let Some(quote @ (b'\'' | b'"')) = self.peek() else { return Err(self.expected("a string")) };
        self.at += 1;
        self.out.push('"');
        while !self.eat(quote) {
            if !unicode && self.rest().starts_with("\\x") {
                self.python_bytes()?;
            } else {
                let c = self.python_char()?;
                self.write_json_char(c);
            }
        }
        self.out.push('"');
        Ok(())
    }

    /// Reads adjacent `\xNN`.
    fn python_bytes(&mut self) -> Step {
        let mut bytes = Vec::new();
        while self.rest().starts_with("\\x") {
            self.at += 2;
            bytes.extend(u8::try_from(self.hex(2)?));
        }
        match std::str::from_utf8(&bytes) {
            Ok(text) => text.chars().for_each(|c| self.write_json_char(c)),
            Err(_) => bytes.into_iter().for_each(|byte| self.write_json_char(char::from(byte))),
        }
        Ok(())
    }

    fn python_char(&mut self) -> Result<char, PythonError> {
        let begin = self.at;
        match self.next_char()? {
            '\\' => {}
            c => return Ok(c),
        }
        match self.next_char()? {
            c @ ('\\' | '\'' | '"') => Ok(c),
            'n' => Ok('\n'),
            't' => Ok('\t'),
            'r' => Ok('\r'),
            'x' => self.hex(2).and_then(|code| self.code_point(code, begin)),
            'u' => self.utf16(begin),
            'U' => self.hex(8).and_then(|code| self.code_point(code, begin)),
            _ => Err(self.expected_at(begin, "an escape")),
        }
    }

    fn write_json_char(&mut self, c: char) {
        match c {
            '"' => self.out.push_str("\\\""),
            '\\' => self.out.push_str("\\\\"),
            '\u{8}' => self.out.push_str("\\b"),
            '\u{c}' => self.out.push_str("\\f"),
            '\n' => self.out.push_str("\\n"),
            '\r' => self.out.push_str("\\r"),
            '\t' => self.out.push_str("\\t"),
            '\0'..' ' => self.write(format_args!("\\u{:04x}", u32::from(c))),
            _ => self.out.push(c),
        }
    }
}

/// Reading JSON, writing Python.
impl Transcoder<'_> {
    fn json_value(&mut self) -> Step {
        match self.token() {
            Some(b'[') => self.json_array(),
            Some(b'{') => self.json_object(),
            Some(b'"') => self.json_string(),
            Some(b'0'..=b'9' | b'-') => self.number(),
            _ => self.word([("true", "True"), ("false", "False"), ("null", "None")]),
        }
    }

    fn json_array(&mut self) -> Step {
        self.out.push('(');
        let items = self.items(b']', Self::json_value)?;
        self.out.push_str(if items.count == 1 { ",)" } else { ")" });
        Ok(())
    }

    fn json_object(&mut self) -> Step {
        self.out.push('{');
        self.items(b'}', Self::json_entry)?;
        self.out.push('}');
        Ok(())
    }

    fn json_entry(&mut self) -> Step {
        self.json_string()?;
        self.colon(": ")?;
        self.json_value()
    }

    fn json_string(&mut self) -> Step {
        if !self.eat(b'"') {
            return Err(self.expected("a string"));
        }
        self.out.push('\'');
        while !self.eat(b'"') {
            let c = self.json_char()?;
            self.write_python_char(c);
        }
        self.out.push('\'');
        Ok(())
    }

    fn json_char(&mut self) -> Result<char, PythonError> {
        let begin = self.at;
        match self.next_char()? {
            '\\' => {}
            '\0'..' ' => return Err(self.expected_at(begin, "an escape")),
            c => return Ok(c),
        }
        match self.next_char()? {
            c @ ('\\' | '/' | '"') => Ok(c),
            'b' => Ok('\u{8}'),
            'f' => Ok('\u{c}'),
            'n' => Ok('\n'),
            'r' => Ok('\r'),
            't' => Ok('\t'),
            'u' => self.utf16(begin),
            _ => Err(self.expected_at(begin, "an escape")),
        }
    }

    fn write_python_char(&mut self, c: char) {
        match c {
            '\'' => self.out.push_str("\\'"),
            '\\' => self.out.push_str("\\\\"),
            '\n' => self.out.push_str("\\n"),
            '\r' => self.out.push_str("\\r"),
            '\t' => self.out.push_str("\\t"),
            '\0'..' ' | '\x7f' => self.write(format_args!("\\x{:02x}", u32::from(c))),
            _ => self.out.push(c),
        }
    }
}

/// What the two languages share.
impl<'a> Transcoder<'a> {
    fn new(language: Language, text: &'a str) -> Self {
        Self { language, text, at: 0, depth: 0, out: String::with_capacity(text.len()) }
    }

    fn run(mut self, value: fn(&mut Self) -> Step) -> Result<String, PythonError> {
        value(&mut self)?;
        match self.token() {
            None => Ok(self.out),
            Some(_) => Err(self.expected("the end")),
        }
    }

    /// Reads an opening bracket and what follows, up to and with `close`; writes only the items and commas.
    fn items(&mut self, close: u8, item: fn(&mut Self) -> Step) -> Result<Items, PythonError> {
        if self.depth == MAX_DEPTH {
            return Err(self.expected("no more than 64 open brackets"));
        }
        self.depth += 1;
        self.at += 1;
        let mut items = Items { count: 0, commas: 0 };
        while !self.closes(close, &items) {
            if items.commas < items.count {
                return Err(self.expected(comma_or(close)));
            }
            if items.count > 0 {
                self.out.push_str(if self.language == Language::Python { "," } else { ", " });
            }
            item(self)?;
            items.count += 1;
            self.token();
            items.commas += usize::from(self.eat(b','));
        }
        self.depth -= 1;
        Ok(items)
    }

    /// Reads `close` if it comes next and may; JSON has no comma before it.
    fn closes(&mut self, close: u8, items: &Items) -> bool {
        self.token();
        let behind_comma = items.count > 0 && items.commas == items.count;
        (self.language == Language::Python || !behind_comma) && self.eat(close)
    }

    fn colon(&mut self, written: &str) -> Step {
        self.token();
        if !self.eat(b':') {
            return Err(self.expected("':'"));
        }
        self.out.push_str(written);
        Ok(())
    }

    /// Reads one of the words on the left and writes its neighbour.
    fn word(&mut self, words: [(&str, &str); 3]) -> Step {
        let Some((read, written)) = words.into_iter().find(|(read, _)| self.rest().starts_with(read)) else {
            return Err(self.expected("a value"));
        };
        self.at += read.len();
        self.out.push_str(written);
        Ok(())
    }

    /// Copies a number, in Python also with `+`, with a bare point at either end, or with a final `L`.
    fn number(&mut self) -> Step {
        let python = self.language == Language::Python;
        if !self.copy(b"-") && python {
            self.eat(b'+');
        }
        self.whole()?;
        let fraction = self.fraction()?;
        let exponent = self.exponent()?;
        if python && !fraction && !exponent && !self.eat(b'L') {
            self.eat(b'l');
        }
        Ok(())
    }

    fn whole(&mut self) -> Step {
        let begin = self.at;
        if self.language == Language::Python && matches!(self.rest().as_bytes(), [b'.', b'0'..=b'9', ..]) {
            self.out.push('0');
            return Ok(());
        }
        let zero = self.peek() == Some(b'0');
        match self.digits() {
            0 => Err(self.expected("a digit")),
            2.. if zero => Err(self.expected_at(begin, "a number without leading zeros")),
            _ => Ok(()),
        }
    }

    /// Copies the point and the digits behind it; false if there is none.
    fn fraction(&mut self) -> Result<bool, PythonError> {
        if !self.copy(b".") {
            return Ok(false);
        }
        if self.digits() == 0 {
            match self.language {
                Language::Python => self.out.push('0'),
                Language::Json => return Err(self.expected("a digit")),
            }
        }
        Ok(true)
    }

    /// Copies the exponent; false if there is none.
    fn exponent(&mut self) -> Result<bool, PythonError> {
        if !self.copy(b"eE") {
            return Ok(false);
        }
        self.copy(b"+-");
        if self.digits() == 0 { Err(self.expected("a digit")) } else { Ok(true) }
    }

    /// Copies decimal digits and counts them.
    fn digits(&mut self) -> usize {
        let begin = self.at;
        while self.copy(b"0123456789") {}
        self.at - begin
    }

    /// Copies the next byte if it is one of these.
    fn copy(&mut self, wanted: &[u8]) -> bool {
        match self.peek() {
            Some(byte) if wanted.contains(&byte) => {
                self.at += 1;
                self.out.push(char::from(byte));
                true
            }
            _ => false,
        }
    }

    fn hex(&mut self, digits: u32) -> Result<u32, PythonError> {
        let mut code = 0;
        for _ in 0..digits {
            let digit = self.peek().and_then(|byte| char::from(byte).to_digit(16));
            code = code << 4 | digit.ok_or_else(|| self.expected("a hexadecimal digit"))?;
            self.at += 1;
        }
        Ok(code)
    }

    /// Reads the digits of `\uNNNN`, and a second escape if the first is half of a pair.
    fn utf16(&mut self, begin: usize) -> Result<char, PythonError> {
        let mut code = self.hex(4)?;
        if (0xd800..0xdc00).contains(&code) && self.rest().starts_with("\\u") {
            self.at += 2;
            let low = self.hex(4)?;
            if (0xdc00..0xe000).contains(&low) {
                code = 0x1_0000 + ((code - 0xd800) << 10) + (low - 0xdc00);
            }
        }
        self.code_point(code, begin)
    }

    fn code_point(&self, code: u32, begin: usize) -> Result<char, PythonError> {
        char::from_u32(code).ok_or_else(|| self.expected_at(begin, "an escape of a character"))
    }

    fn next_char(&mut self) -> Result<char, PythonError> {
        let c = self.rest().chars().next().ok_or_else(|| self.expected("a closing quote"))?;
        self.at += c.len_utf8();
        Ok(c)
    }

    /// Skips white space and looks at what follows.
    fn token(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\t' | b'\r' | b'\n') = self.peek() {
            self.at += 1;
        }
        self.peek()
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn eat(&mut self, byte: u8) -> bool {
        let eaten = self.peek() == Some(byte);
        self.at += usize::from(eaten);
        eaten
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn write(&mut self, text: fmt::Arguments<'_>) {
        // A string takes all that is written.
        let _ = self.out.write_fmt(text);
    }

    fn expected(&self, expected: &'static str) -> PythonError {
        self.expected_at(self.at, expected)
    }

    fn expected_at(&self, position: usize, expected: &'static str) -> PythonError {
        PythonError { language: self.language, position, expected }
    }
}

fn comma_or(close: u8) -> &'static str {
    match close {
        b')' => "',' or ')'",
        b']' => "',' or ']'",
        _ => "',' or '}'",
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::Value;

    use super::*;

    /// The literals of 4.34, with no module and with one.
    const NO_MODULE: &str = "(0, [], {'state': 0})";
    const ONE_MODULE: &str = "(1, [{'setup': (1, 'modbusIoName', ('192.168.2.47', 8888), {'ai': (0, 0), 'do': (0, 0), \
        'ao': (0, 0), 'di': (0, 8)}), 'pinmap': {'ai': 0, 'do': 0, 'ao': 0, 'di': 0}}], \
        {'state': 0, 'di': (0, 0, 0, 0, 0, 0, 0, 0, 0)})";

    #[test]
    fn the_documents_literals_are_read() {
        assert_eq!(to_json(NO_MODULE).as_deref(), Ok(r#"[0,[],{"state":0}]"#));
        let json: String = ONE_MODULE
            .chars()
            .filter(|c| *c != ' ')
            .map(|c| match c {
                '(' => '[',
                ')' => ']',
                '\'' => '"',
                c => c,
            })
            .collect();
        assert_eq!(to_json(ONE_MODULE), Ok(json));
    }

    #[test]
    fn the_documents_literals_are_written() {
        for literal in [NO_MODULE, ONE_MODULE] {
            let json = to_json(literal).expect("the document's");
            let tuples = literal.replace("[]", "()").replace('[', "(").replace(']', ",)");
            assert_eq!(from_json(&json), Ok(tuples));
        }
    }

    #[test]
    fn python_is_read() {
        let cases = [
            ("()", "[]"),
            (" ( 1 , ) ", "[1]"),
            ("(1)", "1"),
            ("((((1, 2))))", "[1,2]"),
            ("[(1), (2,), [3,], ('a')]", r#"[1,[2],[3],"a"]"#),
            ("{}", "{}"),
            ("{'a': 1, \"b\": {u'c': None,},\r\n}\t", r#"{"a":1,"b":{"c":null}}"#),
            ("[True, False, None]", "[true,false,null]"),
            ("[0, -0, +7, 12345678901234567890123L, 8l]", "[0,-0,7,12345678901234567890123,8]"),
            ("[1.5, -0.0, 1e-05, 1E+16, 2.5e3, 5., .5, -.5]", "[1.5,-0.0,1e-05,1E+16,2.5e3,5.0,0.5,-0.5]"),
            (r#"['"', "'", '\'', "\"", '\\', '\n\t\r']"#, r#"["\"","'","'","\"","\\","\n\t\r"]"#),
            (r"['\x00\x1f\x08\x0c\x7f', '/']", "[\"\\u0000\\u001f\\b\\f\u{7f}\",\"/\"]"),
            (r"['\u673a', u'\u673a', '\ud83e\udd16', u'\U0001f916', '机']", r#"["机","机","🤖","🤖","机"]"#),
            (
                r"['\xe6\x9c\xba!', u'\xe9', '\xe9', '\xe6\x9c', u'\xc3\xa9']",
                "[\"机!\",\"é\",\"é\",\"æ\u{9c}\",\"Ã©\"]",
            ),
        ];
        for (literal, json) in cases {
            assert_eq!(to_json(literal).as_deref(), Ok(json), "{literal}");
        }
    }

    #[test]
    fn json_is_read() {
        let cases = [
            ("[]", "()"),
            (" [ 1 ] ", "(1,)"),
            ("[[[]], {}]", "(((),), {})"),
            (r#"{"a":1,"b":[true,false,null]}"#, "{'a': 1, 'b': (True, False, None)}"),
            ("[-0, 1.50, 1e5, 2E-7, 18446744073709551616]", "(-0, 1.50, 1e5, 2E-7, 18446744073709551616)"),
            (r#""it's \"\\\/\"""#, r#"'it\'s "\\/"'"#),
            (r#""\b\f\n\r\t\u0000\u007f""#, r"'\x08\x0c\n\r\t\x00\x7f'"),
            (r#""\u673a\ud83e\uDD16机""#, "'机🤖机'"),
        ];
        for (json, literal) in cases {
            assert_eq!(from_json(json).as_deref(), Ok(literal), "{json}");
        }
    }

    #[test]
    fn malformed_python_is_refused() {
        let cases = [
            ("", "a value at byte 0"),
            ("  ", "a value at byte 2"),
            ("true", "a value at byte 0"),
            ("nan", "a value at byte 0"),
            ("[inf]", "a value at byte 1"),
            ("-inf", "a digit at byte 1"),
            ("(,)", "a value at byte 1"),
            ("(1,,2)", "a value at byte 3"),
            ("(1, 2", "',' or ')' at byte 5"),
            ("(1 2)", "',' or ')' at byte 3"),
            ("[1)", "',' or ']' at byte 2"),
            ("[1, ", "a value at byte 4"),
            ("{'a': 1 'b': 2}", "',' or '}' at byte 8"),
            ("{'a' 1}", "':' at byte 5"),
            ("{'a': }", "a value at byte 6"),
            ("{1: 2}", "a string at byte 1"),
            ("{(): 2}", "a string at byte 1"),
            ("1 2", "the end at byte 2"),
            ("(0, [])]", "the end at byte 7"),
            ("0x10", "the end at byte 1"),
            ("1.5L", "the end at byte 3"),
            ("1j", "the end at byte 1"),
            ("007", "a number without leading zeros at byte 0"),
            ("1e", "a digit at byte 2"),
            (".", "a digit at byte 0"),
            ("b'a'", "a value at byte 0"),
            ("u8", "a string at byte 1"),
            ("'abc", "a closing quote at byte 4"),
            (r"'abc\", "a closing quote at byte 5"),
            (r"'机\q'", "an escape at byte 4"),
            (r"'\x4'", "a hexadecimal digit at byte 4"),
            (r"u'\u12+4'", "a hexadecimal digit at byte 6"),
            (r"'\ud83e'", "an escape of a character at byte 1"),
            (r"'\ud83e\u0041'", "an escape of a character at byte 1"),
            (r"'\UFFFFFFFF'", "an escape of a character at byte 1"),
            ("机", "a value at byte 0"),
        ];
        for (literal, expected) in cases {
            let error = to_json(literal).expect_err(literal);
            assert_eq!(error.to_string(), format!("python literal: expected {expected}"), "{literal}");
        }
    }

    #[test]
    fn malformed_json_is_refused() {
        let cases = [
            ("", "a value at byte 0"),
            ("True", "a value at byte 0"),
            ("(1)", "a value at byte 0"),
            ("[1,]", "a value at byte 3"),
            (r#"{"a":1,}"#, "a string at byte 7"),
            ("{'a': 1}", "a string at byte 1"),
            (r#"{"a" 1}"#, "':' at byte 5"),
            ("[1 2]", "',' or ']' at byte 3"),
            ("+1", "a value at byte 0"),
            (".5", "a value at byte 0"),
            ("5.", "a digit at byte 2"),
            ("01", "a number without leading zeros at byte 0"),
            ("8L", "the end at byte 1"),
            ("\"a\nb\"", "an escape at byte 2"),
            (r#""\x41""#, "an escape at byte 1"),
            (r#""\udd16""#, "an escape of a character at byte 1"),
            (r#""abc"#, "a closing quote at byte 4"),
        ];
        for (json, expected) in cases {
            let error = from_json(json).expect_err(json);
            assert_eq!(error.to_string(), format!("json text: expected {expected}"), "{json}");
        }
    }

    #[test]
    fn depth_is_limited() {
        for (open, close) in [("(", ")"), ("[", "]"), ("{'a': ", "}")] {
            let nested = |depth| format!("{}0{}", open.repeat(depth), close.repeat(depth));
            assert!(to_json(&nested(64)).is_ok());
            let error = to_json(&nested(65)).expect_err("too deep");
            assert_eq!((error.position(), error.expected()), (64 * open.len(), "no more than 64 open brackets"));
            assert!(to_json(&open.repeat(1_000_000)).is_err());
        }
        assert!(from_json(&("[".repeat(64) + &"]".repeat(64))).is_ok());
        assert!(from_json(&("[".repeat(65) + &"]".repeat(65))).is_err());
    }

    fn text() -> impl Strategy<Value = String> {
        let nasty = prop::sample::select("'\"\\()[]{}:,ux0 \0\n\r\t\u{7f}\u{80}é机🤖".chars().collect::<Vec<_>>());
        prop::collection::vec(prop_oneof![3 => nasty, 1 => any::<char>()], 0..10).prop_map(String::from_iter)
    }

    fn value() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::from),
            any::<i64>().prop_map(Value::from),
            any::<u64>().prop_map(Value::from),
            any::<f64>().prop_map(Value::from),
            text().prop_map(Value::from),
        ];
        leaf.prop_recursive(5, 40, 6, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..6).prop_map(Value::from),
                prop::collection::vec((text(), inner), 0..6).prop_map(Value::from_iter),
            ]
        })
    }

    proptest! {
        #[test]
        fn json_survives_the_round_trip_as_text(value in value()) {
            let json = value.to_string();
            let literal = from_json(&json).expect("json");
            prop_assert_eq!(to_json(&literal), Ok(json), "{}", literal);
        }

        #[test]
        fn any_text_is_read_or_refused(
            text in prop::collection::vec(prop::sample::select(
                "()[]{}:,'\"\\uxUL01e.-+ Tru'e机\n".chars().collect::<Vec<_>>()), 0..40).prop_map(String::from_iter),
        ) {
            if let Ok(json) = to_json(&text) {
                prop_assert!(from_json(&json).is_ok(), "{} became {}", text, json);
            }
            if let Ok(literal) = from_json(&text) {
                prop_assert!(to_json(&literal).is_ok(), "{} became {}", text, literal);
            }
        }
    }
}

//! Python literals as JSON, in the forms in which controllers print them, and back.
//!
//! `jaka-proto` has the whole of this as a transcoder of text; it stands above this crate.

use serde_json::{Map, Number, Value};

/// The value that a Python literal stands for.
pub(super) fn read(literal: &str) -> Option<Value> {
    let mut reader = Reader { rest: literal };
    let value = reader.value(0)?;
    reader.blank();
    reader.rest.is_empty().then_some(value)
}

/// The Python literal of a value. Python writes numbers as JSON does, and reads JSON's strings.
pub(super) fn write(value: &Value) -> String {
    let all = |values: Vec<String>| values.join(", ");
    match value {
        Value::Null => "None".to_owned(),
        Value::Bool(true) => "True".to_owned(),
        Value::Bool(false) => "False".to_owned(),
        Value::Array(elements) => format!("[{}]", all(elements.iter().map(write).collect())),
        Value::Object(members) => {
            let member = |(key, value): (&String, &Value)| format!("{}: {}", Value::from(key.as_str()), write(value));
            format!("{{{}}}", all(members.iter().map(member).collect()))
        }
        Value::Number(_) | Value::String(_) => value.to_string(),
    }
}

/// How many brackets may be open at once.
const MAX_DEPTH: usize = 64;

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn value(&mut self, depth: usize) -> Option<Value> {
        self.blank();
        match self.rest.chars().next()? {
            '(' | '[' | '{' if depth == MAX_DEPTH => None,
            '(' => self.tuple(depth),
            '[' => Some(self.items(']', |reader| reader.value(depth + 1))?.0.into()),
            '{' => {
                let entries = self.items('}', |reader| reader.entry(depth))?.0;
                let (len, object) = (entries.len(), entries.into_iter().collect::<Map<_, _>>());
                // Of a key that comes twice, neither value is believed.
                (object.len() == len).then(|| object.into())
            }
            '\'' | '"' | 'u' | 'U' => self.string().map(Value::from),
            _ => self.word(),
        }
    }

    /// A tuple, or a value in parentheses, which has no comma.
    fn tuple(&mut self, depth: usize) -> Option<Value> {
        let (mut items, comma) = self.items(')', |reader| reader.value(depth + 1))?;
        if items.len() == 1 && !comma { items.pop() } else { Some(items.into()) }
    }

    fn entry(&mut self, depth: usize) -> Option<(String, Value)> {
        self.blank();
        let key = self.string()?;
        self.blank();
        self.eat(':').then(|| self.value(depth + 1))?.map(|value| (key, value))
    }

    /// What stands between brackets, and whether a comma came last.
    fn items<T>(&mut self, close: char, mut item: impl FnMut(&mut Self) -> Option<T>) -> Option<(Vec<T>, bool)> {
        self.rest = &self.rest[1..];
        let mut items = Vec::new();
        let mut comma = true;
        loop {
            self.blank();
            if self.eat(close) {
                return Some((items, comma));
            }
            if !comma {
                return None;
            }
            items.push(item(self)?);
            self.blank();
            comma = self.eat(',');
        }
    }

    /// A string in either quotes. Adjacent `\xNN` are read as UTF-8 where there is no `u` and they are valid.
    fn string(&mut self) -> Option<String> {
        let unicode = self.eat('u') || self.eat('U');
        let quote = self.next().filter(|quote| matches!(quote, '\'' | '"'))?;
        let mut text = String::new();
        while !self.eat(quote) {
            if !unicode && self.rest.starts_with("\\x") {
                text.push_str(&self.bytes()?);
            } else {
                text.push(self.char()?);
            }
        }
        Some(text)
    }

    fn bytes(&mut self) -> Option<String> {
        let mut bytes = Vec::new();
        while let Some(rest) = self.rest.strip_prefix("\\x") {
            self.rest = rest;
            bytes.extend(u8::try_from(self.hex(2)?));
        }
        Some(String::from_utf8(bytes).unwrap_or_else(|error| error.as_bytes().iter().map(|b| char::from(*b)).collect()))
    }

    fn char(&mut self) -> Option<char> {
        match self.next()? {
            '\\' => match self.next()? {
                c @ ('\\' | '\'' | '"') => Some(c),
                'n' => Some('\n'),
                't' => Some('\t'),
                'r' => Some('\r'),
                'x' => char::from_u32(self.hex(2)?),
                'u' => self.utf16(),
                'U' => char::from_u32(self.hex(8)?),
                _ => None,
            },
            c => Some(c),
        }
    }

    /// The digits of `\uNNNN`, and a second escape if the first is half of a pair.
    fn utf16(&mut self) -> Option<char> {
        let mut units = vec![self.hex(4)?];
        let is_half = (0xd800..0xdc00).contains(&units[0]);
        if let Some(rest) = self.rest.strip_prefix("\\u").filter(|_| is_half) {
            self.rest = rest;
            units.push(self.hex(4)?);
        }
        char::decode_utf16(units.into_iter().filter_map(|unit| u16::try_from(unit).ok())).next()?.ok()
    }

    fn hex(&mut self, digits: usize) -> Option<u32> {
        let (digits, rest) = self.rest.split_at_checked(digits)?;
        self.rest = rest;
        digits.chars().try_fold(0, |code, digit| Some(code << 4 | digit.to_digit(16)?))
    }

    fn word(&mut self) -> Option<Value> {
        for (word, value) in [("True", true.into()), ("False", false.into()), ("None", Value::Null)] {
            if let Some(rest) = self.rest.strip_prefix(word) {
                self.rest = rest;
                return Some(value);
            }
        }
        let end = self.rest.find(|c: char| !matches!(c, '0'..='9' | '+' | '-' | '.' | 'e' | 'E' | 'l' | 'L'));
        let (number, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        python_number(number)
    }

    fn next(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    fn eat(&mut self, c: char) -> bool {
        let rest = self.rest.strip_prefix(c);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn blank(&mut self) {
        self.rest = self.rest.trim_start_matches([' ', '\t', '\r', '\n']);
    }
}

/// A number, also with a plus or with a bare point at either end, which JSON does not know, or a whole one with Python 2's `L`.
fn python_number(text: &str) -> Option<Value> {
    let (sign, unsigned) = match text.strip_prefix('-') {
        Some(unsigned) => ("-", unsigned),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let long = unsigned.strip_suffix(['L', 'l']);
    let digits = long.unwrap_or(unsigned);
    let is_number = match digits.as_bytes() {
        [b'0', b'0'..=b'9', ..] => false,
        [b'0'..=b'9' | b'.', ..] => long.is_none() || digits.bytes().all(|digit| digit.is_ascii_digit()),
        _ => false,
    };
    let number = format!("{sign}{digits}");
    let float = || number.parse().ok().and_then(Number::from_f64).map(Value::Number);
    if is_number { serde_json::from_str(&number).ok().or_else(float) } else { None }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::{read, write};

    #[test]
    fn literals_in_the_forms_of_controllers_are_read() {
        let same = [
            ("(0, [], {'state': 0})", json!([0, [], {"state": 0}])),
            (" ( 1 , ) ", json!([1])),
            ("(1)", json!(1)),
            ("()", json!([])),
            ("{'a': (True, False, None,), u'b' : -2.5e3}", json!({"a": [true, false, null], "b": -2.5e3})),
            (
                "('it\\'s', \"say \\\"so\\\"\", 'quote \"', '\\x41\\n\\u00e9')",
                json!(["it's", "say \"so\"", "quote \"", "A\né"]),
            ),
            ("(.5, 5., +1, 10L, 0\n)", json!([0.5, 5.0, 1, 10, 0])),
            ("('\\xc3\\xa9', u'\\xc3', '\\ud83d\\ude00', '\n')", json!(["é", "Ã", "😀", "\n"])),
        ];
        for (literal, value) in same {
            assert_eq!(read(literal), Some(value), "{literal}");
        }
    }

    #[test]
    fn what_is_no_literal_is_none() {
        for text in [
            "",
            "(",
            "(1",
            "(1 2)",
            "(,)",
            "[1)",
            "true",
            "nan",
            "x",
            "'a",
            "'\\q'",
            "{1: 2}",
            "{'a' 1}",
            "1 2",
            "é",
            "00",
            "1e999",
            "1.5L",
            "'\\u12'",
            "'\\ud800'",
            "{'a': 1, 'a': 2}",
        ] {
            assert_eq!(read(text), None, "{text}");
        }
        assert_eq!(read(&"(".repeat(100_000)), None);
    }

    #[test]
    fn what_is_written_is_read_again() {
        let value = json!([0, 1.5, "it's \"é\"\n", [true, null], {"a key": [[]]}]);
        assert_eq!(write(&value), r#"[0, 1.5, "it's \"é\"\n", [True, None], {"a key": [[]]}]"#);
        assert_eq!(read(&write(&value)), Some(value));
    }
}

//! Python literals as JSON, in the forms in which controllers print them, and back.
//!
//! `jaka-proto` has the whole of this as a transcoder of text; it stands above this crate.

use serde_json::{Map, Value};

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
        if depth > MAX_DEPTH {
            return None;
        }
        self.blank();
        match self.rest.chars().next()? {
            '(' => self.tuple(depth),
            '[' => Some(self.items(']', |reader| reader.value(depth + 1))?.0.into()),
            '{' => {
                let entries = self.items('}', |reader| reader.entry(depth))?.0;
                Some(entries.into_iter().collect::<Map<_, _>>().into())
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

    /// A string in either quotes, with the escapes that JSON knows too and the plain hexadecimal one.
    fn string(&mut self) -> Option<String> {
        self.rest = self.rest.strip_prefix(['u', 'U']).unwrap_or(self.rest);
        let quote = self.rest.chars().next().filter(|quote| matches!(quote, '\'' | '"'))?;
        let mut chars = self.rest[1..].char_indices();
        let mut json = String::from("\"");
        loop {
            match chars.next()? {
                (end, c) if c == quote => {
                    self.rest = &self.rest[end + 2..];
                    json.push('"');
                    return serde_json::from_str(&json).ok();
                }
                (_, '\\') => match chars.next()?.1 {
                    '\'' => json.push('\''),
                    'x' => json.push_str("\\u00"),
                    c => json.extend(['\\', c]),
                },
                (_, '"') => json.push_str("\\\""),
                (_, c) => json.push(c),
            }
        }
    }

    fn word(&mut self) -> Option<Value> {
        let end = self.rest.find([',', ')', ']', '}', ':', ' ']).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        match word {
            "True" => Some(true.into()),
            "False" => Some(false.into()),
            "None" => Some(Value::Null),
            number => python_number(number.strip_suffix(['L', 'l']).unwrap_or(number)),
        }
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

/// A number, also with a plus or with a bare point at either end, which JSON does not know.
fn python_number(text: &str) -> Option<Value> {
    if !text.ends_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    serde_json::from_str(text).ok().or_else(|| Some(text.parse::<f64>().ok()?.into()))
}

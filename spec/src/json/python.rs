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
            ("{'a': (True, False, None,), u'b' : -2.5e3L}", json!({"a": [true, false, null], "b": -2.5e3})),
            (
                "('it\\'s', \"say \\\"so\\\"\", 'quote \"', '\\x41\\n\\u00e9')",
                json!(["it's", "say \"so\"", "quote \"", "A\né"]),
            ),
            ("(.5, 5., +1, 10L)", json!([0.5, 5.0, 1.0, 10])),
        ];
        for (literal, value) in same {
            assert_eq!(read(literal), Some(value), "{literal}");
        }
    }

    #[test]
    fn what_is_no_literal_is_none() {
        for text in
            ["", "(", "(1", "(1 2)", "(,)", "[1)", "true", "nan", "x", "'a", "'\\q'", "{1: 2}", "{'a' 1}", "1 2", "é"]
        {
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

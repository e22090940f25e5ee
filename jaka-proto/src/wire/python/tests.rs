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
        (r"['\xe6\x9c\xba!', u'\xe9', '\xe9', '\xe6\x9c', u'\xc3\xa9']", "[\"机!\",\"é\",\"é\",\"æ\u{9c}\",\"Ã©\"]"),
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
        ("-+5", "a digit at byte 1"),
        ("+-5", "a digit at byte 1"),
        ("(0, -1e999)", "a finite number at byte 4"),
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
        ("", "a value at byte 0, where the text ends"),
        ("True", "a value at byte 0, found `True`"),
        ("(1)", "a value at byte 0, found `(1)`"),
        ("[1,]", "a value after the comma at byte 3, found `]`"),
        (r#"{"a":1,}"#, "a value after the comma at byte 7, found `}`"),
        ("{'a': 1}", "a key at byte 1, found `'a': 1}`"),
        (r#"{"a" 1}"#, "`:` at byte 5, found `1}`"),
        ("[1 2]", "`,` or `]` at byte 3, found `2]`"),
        ("+1", "a value at byte 0, found `+1`"),
        (".5", "a value at byte 0, found `.5`"),
        ("8L", "the end of the message at byte 1, found `L`"),
        (r#""\x41""#, r#"valid escapes in a string at byte 1, found `\x41"`"#),
        (r#""\udd16""#, r#"valid escapes in a string at byte 1, found `\udd16"`"#),
        (r#""abc"#, "the end of a string at byte 4, where the text ends"),
    ];
    for (json, expected) in cases {
        let error = from_json(json).expect_err(json);
        assert_eq!(error.to_string(), format!("not JSON: expected {expected}"), "{json}");
    }
    for number in ["1e999", "5.", "01"] {
        let error = from_json(&format!("[{number}]")).expect_err(number);
        assert_eq!(error.to_string(), format!("expected a finite number, found `{number}`"));
    }
}

#[test]
fn depth_is_limited() {
    for (open, close) in [("(", ")"), ("[", "]"), ("{'a': ", "}")] {
        let nested = |depth| format!("{}0{}", open.repeat(depth), close.repeat(depth));
        assert!(to_json(&nested(64)).is_ok());
        let error = to_json(&nested(65)).expect_err("too deep");
        let place = 64 * open.len();
        let expected = format!("python literal: expected no more than 64 open brackets at byte {place}");
        assert_eq!(error.to_string(), expected);
        assert!(to_json(&open.repeat(1_000_000)).is_err());
    }
    assert!(from_json(&("[".repeat(64) + &"]".repeat(64))).is_ok());
    assert!(from_json(&("[".repeat(65) + &"]".repeat(65))).is_err());
}

#[test]
fn brackets_that_are_closed_do_not_count() {
    let modules = vec!["(), [], {'a': [()]}"; 40].join(", ");
    let json = to_json(&format!("[{modules}]")).expect("four are open at most");
    assert!(from_json(&json).is_ok());
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

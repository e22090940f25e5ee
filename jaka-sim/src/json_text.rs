//! Splitting and formatting of JSON text.

use jaka_proto::wire::Reader;

/// Returns the members of an object, with unchanged values; `None` for text other than an object.
pub(crate) fn members(json: &str) -> Option<Vec<(String, &str)>> {
    let mut reader = Reader::new(json);
    let mut members = Vec::new();
    reader.begin_object().ok()?;
    while let Some(key) = reader.next_key().ok()? {
        members.push((key.into_owned(), reader.raw().ok()?));
    }
    reader.end().ok()?;
    Some(members)
}

/// Returns the elements of an array, unchanged; `None` for text other than an array.
pub(crate) fn elements(json: &str) -> Option<Vec<&str>> {
    let mut reader = Reader::new(json);
    let mut elements = Vec::new();
    reader.begin_array().ok()?;
    while reader.next_element().ok()? {
        elements.push(reader.raw().ok()?);
    }
    reader.end().ok()?;
    Some(elements)
}

/// Replaces the blanks between the parts of a JSON text by `blank`, after each comma and colon. Strings stay as they
/// are.
pub(crate) fn respace(json: &str, blank: &str) -> String {
    let mut out = String::with_capacity(json.len() * 3 / 2);
    let mut rest = json;
    // Searches bytes for speed, since it goes through every packet; each of these characters is one byte.
    while let Some(at) = rest.bytes().position(|byte| matches!(byte, b'"' | b',' | b':' | b' ' | b'\t' | b'\r' | b'\n'))
    {
        out.push_str(&rest[..at]);
        let end = at + if rest[at..].starts_with('"') { string(&rest[at..]) } else { 1 };
        let part = &rest[at..end];
        out.push_str(part.trim_ascii());
        if matches!(part, "," | ":") {
            out.push_str(blank);
        }
        rest = &rest[end..];
    }
    out.push_str(rest);
    out
}

/// Returns the length of the string at the start of `json`, with its quotes; all of `json` if the string does not end.
fn string(json: &str) -> usize {
    let mut at = 1;
    while let Some(found) = json[at..].bytes().position(|byte| matches!(byte, b'"' | b'\\')) {
        at += found + 1;
        if json.as_bytes()[at - 1] == b'"' {
            return at;
        }
        // The escaped character may have several bytes.
        at += json[at..].chars().next().map_or(0, char::len_utf8);
    }
    json.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanks_stand_where_they_should() {
        let json = " {\"a\" : [1 ,2,\t{}],\r\n\"b, c: \\\" d:e\" :\"\\\\\",\"f\":\"x , y:z\"}\n";
        let compact = r#"{"a":[1,2,{}],"b, c: \" d:e":"\\","f":"x , y:z"}"#;
        let spaced = r#"{"a": [1, 2, {}], "b, c: \" d:e": "\\", "f": "x , y:z"}"#;
        for text in [json, compact, spaced] {
            assert_eq!(respace(text, ""), compact);
            assert_eq!(respace(text, " "), spaced);
        }
    }

    #[test]
    fn text_that_is_not_json_does_no_harm() {
        for text in ["", "\"", "\"\\", "\"\\é", "é,é", "\"é", ",", "(1, 2)", "\\\"", "\u{a0},"] {
            respace(text, " ");
            assert_eq!((members(text), elements(text)), (None, None), "{text}");
        }
        assert_eq!(respace("\"a, b", " "), "\"a, b");
    }
}

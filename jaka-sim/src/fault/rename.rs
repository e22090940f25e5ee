//! Replies under another name.

use jaka_proto::wire::{DecodeError, Reader, Writer};

/// The key of the envelope that says which command a reply answers.
const NAME: &str = "cmdName";

/// The reply with another name, or with none. What is no JSON object has no name, and stays as it is.
pub(super) fn rename(reply: &str, name: Option<&str>) -> String {
    try_rename(reply, name).unwrap_or_else(|_| reply.to_owned())
}

fn try_rename(reply: &str, name: Option<&str>) -> Result<String, DecodeError> {
    let mut reader = Reader::new(reply);
    let mut out = Writer::new();
    out.raw("{");
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        let value = reader.raw()?;
        if key != NAME {
            entry(&key, &mut out);
            out.raw(value);
        }
    }
    if let Some(name) = name {
        entry(NAME, &mut out);
        out.text(name);
    }
    out.raw("}");
    Ok(out.into_string())
}

fn entry(key: &str, out: &mut Writer) {
    out.comma();
    out.text(key);
    out.raw(":");
}

#[cfg(test)]
mod tests {
    use super::rename;

    #[test]
    fn only_the_name_changes() {
        let reply = r#"{"errorCode": "0", "cmdName": "jog", "joint_pos": [1, 2], "a\"b": "}"}"#;
        assert_eq!(rename(reply, None), r#"{"errorCode":"0","joint_pos":[1, 2],"a\"b":"}"}"#);
        assert_eq!(rename(reply, Some("q\"")), r#"{"errorCode":"0","joint_pos":[1, 2],"a\"b":"}","cmdName":"q\""}"#);
        assert_eq!(rename("(0, [])", Some("jog")), "(0, [])");
    }
}

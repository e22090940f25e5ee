//! Renamed replies.

use jaka_proto::wire::Writer;
use jaka_spec::COMMAND_NAME;

use crate::json_text::members;

/// Returns the reply with another name, or without one. Text other than a JSON object has no name, and stays unchanged.
pub(super) fn rename(reply: &str, name: Option<&str>) -> String {
    let Some(members) = members(reply) else { return reply.to_owned() };
    let mut out = Writer::new();
    out.raw("{");
    for (key, value) in members.iter().filter(|(key, _)| key != COMMAND_NAME) {
        out.comma();
        out.text(key);
        out.raw(":");
        out.raw(value);
    }
    if let Some(name) = name {
        out.comma();
        out.text(COMMAND_NAME);
        out.raw(":");
        out.text(name);
    }
    out.raw("}");
    out.into_string()
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

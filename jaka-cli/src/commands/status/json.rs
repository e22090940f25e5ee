//! Packets as lines of JSON.

use jaka_sync::proto::text::visible_json;
use serde_json::Value;

use super::packets::Packet;
use crate::event;
use crate::fields::Field;

/// A packet as one line, its fields in the order in which they are asked for. A field that it does not have is null.
///
/// The code of an event is followed by its severity and meaning, which are null where there is no event or no meaning.
pub(super) fn line(fields: &[Field], packet: &Packet) -> String {
    let time = format!("\"time_s\":{}", packet.time);
    let mut entries = vec![time];
    for field in fields {
        let value = field.named_value(&packet.json);
        let code = (field.name == event::CODE).then(|| event::read(value.as_ref()));
        entries.push(entry(&field.name, value));
        if let Some(event) = code {
            entries.push(entry("event_severity", event::severity(&event).map(|severity| severity.to_string().into())));
            entries.push(entry("event_meaning", event::meaning(&event).map(Value::from)));
        }
    }
    visible_json(&format!("{{{}}}\n", entries.join(","))).into_owned()
}

fn entry(name: &str, value: Option<Value>) -> String {
    format!("{}:{}", Value::from(name), value.unwrap_or_default())
}

//! Messages of the built-in spec in terms of packs.

use jaka_dynamic::{Message, Translation};
use jaka_spec::{Source, load_pack};
use serde_json::{Value, json};

use super::{SPEC, object};

/// A pack gives enums other names; what is written alike stays, and a number stands for itself.
#[test]
fn enums_are_translated_by_name_and_else_as_they_are_written() {
    let pack = "title = 'T'\n[[override]]\ntarget = 'TaskState'\nvalue = 4\nname = 'Ready'\n\
                [[type]]\nname = 'Link'\nkind = 'enum'\ndoc = 'D.'\n\
                [[type.value]]\nwire = 0\nname = 'Down'\ndoc = 'D.'\n\
                [[override]]\ntarget = 'RobotStatus'\nfield = 'netState'\ntype = 'Link'\n";
    let pack = load_pack(&SPEC, Source { path: "t.toml", text: pack }).expect("the pack is correct").spec;
    let packet = json!({"task_state": 4, "netState": 1});
    let translated = Translation::new(&SPEC, &pack).message(Message::Status, &object(packet.clone()));
    assert_eq!(Value::from(translated.members), packet);
    assert_eq!(Translation::new(&SPEC, &pack).lost(Message::Status), Vec::<String>::new());
}

//! The JSON Schema as programs find it that make types of it. `tests/json-schema` compares it with the standard.

use jaka_spec::tools::schema;
use jaka_spec::{Source, load};
use jaka_tests::spec;
use serde_json::{Value, json};

#[test]
fn each_command_and_each_type_is_defined() {
    let (spec, schema) = (spec(), schema(&spec()));
    let commands =
        spec.commands().flat_map(|command| ["request", "reply", "accepted"].map(|of| format!("{of}.{}", command.wire)));
    for name in commands.chain(spec.types().map(|(_, def)| format!("lenient.{}", def.name))) {
        assert!(schema["$defs"][&name].is_object(), "{name}");
    }
}

/// Programs that make types take `allOf` for parts of a type, of which one without a type hides that of another.
#[test]
fn ranges_stand_beside_types() {
    fn assert_plain(schema: &Value) {
        match schema {
            Value::Object(keywords) => {
                assert!(!keywords.contains_key("allOf"), "{schema}");
                // A rule that depends on another field is no part of a type.
                keywords
                    .iter()
                    .filter(|(key, _)| *key != "dependentSchemas")
                    .for_each(|(_, value)| assert_plain(value));
            }
            Value::Array(values) => values.iter().for_each(assert_plain),
            _ => {}
        }
    }
    let schema = schema(&spec());
    assert_plain(&schema);
    let joint_move = &schema["$defs"]["request.joint_move"];
    let speed = &joint_move["properties"]["speed"];
    let bounds = ["type", "minimum", "maximum", "not"].map(|keyword| speed[keyword].clone());
    assert_eq!(bounds, [json!("number"), json!(0), json!(265), json!({ "const": 0 })]);
    assert_eq!(joint_move["properties"]["jointPosition"]["$ref"], "#/$defs/JointPosition");
    assert_eq!(joint_move["dependentSchemas"]["jointPosition"]["allOf"].as_array().map(Vec::len), Some(2));
}

#[test]
fn names_that_are_no_part_of_an_address_are_escaped() {
    let text = "title = \"Test\"\n\n[[command]]\nwire = \"get 50% of/it ~now?\"\nname = \"get_half\"\neffect = \"query\"\n\
                doc = \"Reads half of it.\"\n";
    let spec = load(&[Source { path: "spec/test.toml", text }]).expect("the spec is correct");
    let requests = &schema(&spec)["$defs"]["request"]["oneOf"];
    assert_eq!(*requests, json!([{ "$ref": "#/$defs/request.get%2050%25%20of~1it%20~0now%3F" }]));
}

//! Requests, written and checked by the model.

use expect_test::expect;
use jaka_dynamic::{AdvisoryRanges, Node, Problem};
use jaka_proto::Request;
use jaka_proto::check::NotSent;
use jaka_proto::wire::Writer;
use jaka_spec::{Field, Scalar, Shape, Type};
use jaka_tests::{any_request, any_request_of, printed};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

use super::{SPEC, command, command_of, damaged, lines, object, pack};

/// The request with these fields, which may have `cmdName` among them.
fn by_model(message: &Value, ranges: AdvisoryRanges) -> Result<String, Vec<Problem>> {
    let mut fields = object(message.clone());
    fields.remove("cmdName");
    jaka_dynamic::request(&SPEC, command_of(message), &fields, ranges)
}

fn written(request: &Request) -> String {
    let mut out = Writer::new();
    request.write(&mut out);
    out.into_string()
}

#[test]
fn requests_are_those_of_the_generated_code_and_what_it_refuses_is_refused() {
    for command in SPEC.commands() {
        let requests = any_request_of(&SPEC, command).prop_flat_map(|wild| {
            let tame = tamed(&wild);
            prop_oneof![Just(wild), Just(tame)]
        });
        let mut runner = TestRunner::new(ProptestConfig::with_cases(100));
        runner.run(&requests, |message| same_as_generated(&message)).unwrap_or_else(|error| panic!("{error}"));
    }
}

fn same_as_generated(message: &Value) -> Result<(), TestCaseError> {
    let request = Request::read(&message.to_string()).expect("a random request decodes");
    for ranges in [AdvisoryRanges::Enforced, AdvisoryRanges::Ignored] {
        match (request.check(ranges), by_model(message, ranges)) {
            (Ok(()), by_model) => prop_assert_eq!(by_model, Ok(written(&request))),
            (Err(other @ NotSent::NotInFirmware(_)), _) => {
                prop_assert!(false, "no firmware is known, but {other}");
            }
            (Err(invalid), Ok(text)) => prop_assert!(false, "{invalid}, but the model wrote {text}"),
            (Err(NotSent::InvalidArgument(invalid)), Err(problems)) => {
                let found = problems.iter().find(|problem| problem.field == invalid.field);
                prop_assert!(found.is_some_and(|found| found.advisory == invalid.advisory), "{invalid}: {problems:?}");
            }
        }
    }
    Ok(())
}

/// Returns the request with all numbers in range, all values from their lists, and all texts in ASCII.
fn tamed(message: &Value) -> Value {
    let command = command_of(message);
    let mut message = object(message.clone());
    let fields = match &command.request {
        jaka_spec::Request::Fields(fields) => fields,
        jaka_spec::Request::Choice(choice) => {
            let tag = message[&choice.tag].as_i64();
            &choice.variants.iter().find(|variant| Some(variant.wire) == tag).expect("a tag of the spec").fields
        }
    };
    for field in fields {
        if let Some(value) = message.get_mut(&field.wire) {
            tame(field, &field.ty, value);
        }
    }
    message.into()
}

fn tame(field: &Field, ty: &Type, value: &mut Value) {
    let advised = field.advised.iter().map(|advice| advice.max).fold(f64::MAX, f64::min);
    let min = field.range.min.unwrap_or(f64::MIN).max(-advised);
    let max = field.range.max.unwrap_or(f64::MAX).min(advised);
    match SPEC.shape(ty) {
        #[expect(clippy::cast_possible_truncation, reason = "any whole number in range will do")]
        Shape::Scalar(Scalar::Int) => *value = (value.as_f64().expect("a number").clamp(min, max) as i64).into(),
        Shape::Scalar(Scalar::Float) => *value = value.as_f64().expect("a number").clamp(min, max).into(),
        Shape::Scalar(Scalar::Text) => {
            *value = value.as_str().expect("a text").replace(|c: char| !(' '..='~').contains(&c), "?").into();
        }
        Shape::IntEnum(values) if values.iter().all(|listed| *value != listed.wire) => *value = values[0].wire.into(),
        Shape::TextEnum(values) if values.iter().all(|listed| *value != listed.wire) => {
            *value = values[0].wire.clone().into();
        }
        Shape::Tuple { fields, .. } => {
            let elements = value.as_array_mut().expect("an array");
            fields.iter().zip(elements).for_each(|(field, element)| tame(field, &field.ty, element));
        }
        _ => {}
    }
}

#[test]
fn the_documents_requests_are_those_of_the_generated_code() {
    for message in printed().iter().filter(|message| message.is_request) {
        let request = Request::read(&message.text).expect("the document's requests decode");
        let fields = serde_json::from_str(&message.text).expect("the document prints JSON");
        assert_eq!(by_model(&fields, AdvisoryRanges::Enforced), Ok(written(&request)), "{}", message.section);
    }
}

#[test]
fn names_serve_as_keys_values_and_tags() {
    let by_name = |wire: &str, fields: Value| {
        jaka_dynamic::request(&SPEC, command(wire), &object(fields), AdvisoryRanges::Enforced)
    };
    let pose = json!({"x": 1, "y": 2.5, "z": -0.0, "rx": 0, "ry": 1e21, "rz": 180});
    let text = by_name("moveL", json!({"mode": "relative", "pose": pose, "speed": 20, "accel": null, "tolerance": 0}));
    assert_eq!(
        text.as_deref(),
        Ok(r#"{"cmdName":"moveL","relFlag":1,"cartPosition":[1,2.5,-0,0,1e+21,180],"speed":20,"tol":0}"#)
    );
    let text =
        by_name("jog", json!({"jog_mode": "increment", "frame": "Joint", "axis": 0, "jogvel": 30, "distance": -5}));
    assert_eq!(text.as_deref(), Ok(r#"{"cmdName":"jog","jog_mode":2,"coord_map":1,"jnum":0,"jogvel":30,"poscmd":-5}"#));
    let text = by_name("set_servo_move_filter", json!({"filter_type": "joint-low-pass", "cutoff_frequency": 0.5}));
    assert_eq!(text.as_deref(), Ok(r#"{"cmdName":"set_servo_move_filter","filter_type":1,"lpf_cf":0.5}"#));
}

#[test]
fn commands_that_were_not_compiled_in_are_written() {
    let pack = pack();
    let everything = pack.command("everything").expect("the pack has it");
    let fields = json!({
        "flag": true, "limited": 4, "tool": "gripper", "size": {"a": [1, 2, 3]}, "rest": {"b": [1.0], "a": null},
        "pairs": [[false], [true, "slow", "\u{1}\"\u{8}é"], {"on": true}], "link": ["net", "host"], "note": "(True,)",
    });
    let text = jaka_dynamic::request(&pack, everything, &object(fields.clone()), AdvisoryRanges::Ignored)
        .expect("it is allowed");
    expect![[r#"{"cmdName":"everything","flag":"in","Limited Int":4,"tool":"grip","size":{"a":[1,2,3]},"pairs":[[false],[true,0,"\u0001\"\u0008é"],[true]],"link":[1,"host"],"note":"(True,)","rest":{"a":null,"b":[1.0]}}"#]].assert_eq(&text);

    let message = object(serde_json::from_str(&text).expect("a request is JSON"));
    assert_eq!(Node::request(&pack, everything, message).problems(), []);

    let mut wrong = object(fields);
    for (key, value) in [
        ("flag", json!("inside")),
        ("tool", json!("hammer")),
        ("size", json!({"a": [1, 2], "b": 0})),
        ("pairs", json!([[], [true, 5], {"on": true, "text": "a"}, [1, 2, 3, 4]])),
        ("link", json!([0, 1, 2])),
        ("note", json!([true])),
    ] {
        wrong.insert(key.to_owned(), value);
    }
    let problems =
        jaka_dynamic::request(&pack, everything, &wrong, AdvisoryRanges::Enforced).expect_err("it is forbidden");
    expect![[r#"
        field `flag` is "inside"; allowed is "out" or "in"
        field `limited` is 4; allowed is a whole number, 1 to 3; this is advisory
        field `tool` is "hammer"; allowed is `grip`
        there is no field `size.b`; the fields are `a`
        field `size.a` is [1,2]; allowed is an array of 3, each a whole number (in mm)
        field `pairs[0]` is []; allowed is an array [on, mode, text]
        field `pairs[1].mode` is 5; allowed is 0 (Slow) or 1 (VeryFast)
        field `pairs[2].mode` is missing; allowed is 0 (Slow) or 1 (VeryFast)
        field `pairs[3]` is [1,2,3,4]; allowed is an array [on, mode, text]
        field `link` is [0,1,2]; allowed is an array that begins with 0 (Serial) or 1 (Net)
        field `note` is [true]; allowed is text with a Python literal
    "#]]
    .assert_eq(&lines(&problems));
    let problems = Node::request(&pack, everything, wrong).problems();
    expect![[r#"
        field `flag` is "inside"; allowed is "out" or "in"
        field `Limited Int` is missing; allowed is a whole number, 1 to 3
        field `tool` is "hammer"; allowed is `grip`
        field `size.a` is [1,2]; allowed is an array of 3, each a whole number (in mm)
        field `pairs[0].on` is missing; allowed is false or true
        field `pairs[1].mode` is 5; allowed is 0 (Slow) or 1 (VeryFast)
        field `pairs[2]` is {"on":true,"text":"a"}; allowed is an array [on, mode, text]
        field `pairs[3].text` is 3; allowed is text
        field `note` is [true]; allowed is text with a Python literal
    "#]]
    .assert_eq(&lines(&problems));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    #[test]
    fn requests_off_the_wire_are_refused_where_the_generated_code_refuses_them(
        message in any_request(&SPEC).prop_map(|message| tamed(&message)).prop_flat_map(damaged)
    ) {
        let generated = Request::read(&message.to_string()).map(|request| request.check(AdvisoryRanges::Ignored));
        let problems = Node::request(&SPEC, command_of(&message), object(message)).problems();
        prop_assert_eq!(problems.is_empty(), matches!(generated, Ok(Ok(()))), "{:?} {:?}", problems, generated);
    }
}

//! Objects by the keys of their type, and arrays by the places of their elements, as generated code reads them.

use jaka_proto::messages::io::ExtioTcp;
use jaka_proto::messages::motion::Jog;
use jaka_proto::messages::status::JointMonitor;
use jaka_proto::messages::types::Pose;
use jaka_proto::wire::{Decode, DecodeError, Fields, Keys, Reader};

fn decode<T: Decode>(json: &str) -> Result<T, DecodeError> {
    T::decode(&mut Reader::new(json))
}

fn words<T: Decode + std::fmt::Debug>(json: &str) -> String {
    decode::<T>(json).expect_err(json).to_string()
}

/// The places and values of `"a"` and `"b"`; other keys with `other`.
fn a_and_b<'a>(
    json: &'a str,
    next: fn(&mut Reader<'a>, &mut Keys) -> Result<Option<usize>, DecodeError>,
) -> Result<Vec<(usize, Option<i64>)>, DecodeError> {
    let mut reader = Reader::new(json);
    let mut keys = reader.begin_fields(&["\"a\":", "\"b\":"])?;
    let mut found = Vec::new();
    while let Some(place) = next(&mut reader, &mut keys)? {
        let value = if place < 2 { Some(i64::decode(&mut reader)?) } else { reader.skip().map(|()| None)? };
        found.push((place, value));
    }
    reader.end()?;
    Ok(found)
}

#[test]
fn keys_are_found_in_any_order_and_in_any_form() {
    let all = |json| a_and_b(json, Reader::next_field).expect(json);
    assert_eq!(all(r#"{"a": 1, "b": 2}"#), [(0, Some(1)), (1, Some(2))]);
    assert_eq!(all(r#"{"b":1,"new":{"a":7},"a":2}"#), [(1, Some(1)), (2, None), (0, Some(2))]);
    assert_eq!(
        all(r#"{"n\u0065w" : 7, "\u0061" : 1, "b\n": 7, "b" :2}"#),
        [(2, None), (0, Some(1)), (2, None), (1, Some(2))]
    );
    assert_eq!(all("{}"), []);
}

#[test]
fn keys_that_are_not_wanted_are_passed_over_with_what_they_hold() {
    let wanted = |json| a_and_b(json, Reader::next_wanted).expect(json);
    assert_eq!(
        wanted(r#"{"new": [1, {"a": 2}], "a": 1, "x": "b", "y" : -1.5e3, "z": null, "b": 2}"#),
        [(0, Some(1)), (1, Some(2))]
    );
    assert_eq!(wanted(r#"{"b": 2, "new": 7}"#), [(1, Some(2))]);
    assert_eq!(wanted(r#"{"new": 7}"#), []);
    for broken in [r#"{"new": [1"#, r#"{"new": {"a": 1}"#, r#"{"new": "a"#, r#"{"new" 1}"#, r#"{"new": 1 "a": 1}"#] {
        assert!(a_and_b(broken, Reader::next_wanted).is_err_and(|error| error.is_malformed()), "{broken}");
    }
}

#[test]
fn what_is_passed_over_is_looked_at_for_quotes_and_brackets_alone() {
    for value in ["[tru, 1 2]", r#"{"a" 1,, b}"#, r#""\x""#, "0-1e"] {
        let mut reader = Reader::new(value);
        reader.pass().expect(value);
        reader.end().expect(value);
        assert!(Reader::new(value).skip().is_err_and(|error| error.is_malformed()), "{value}");
    }
}

#[test]
fn values_nest_64_levels_deep_and_no_deeper() {
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        let nested = |depth| format!("{}1{}", open.repeat(depth), close.repeat(depth));
        assert_eq!(Reader::new(&nested(64)).skip(), Ok(()));
        let error = Reader::new(&nested(65)).skip().expect_err("it is too deep");
        assert!(error.is_malformed() && error.to_string().contains("at most 64 levels of nesting"), "{error}");
    }
}

#[test]
fn an_array_with_places_has_neither_fewer_nor_more_elements() {
    let pose = Pose { x: 1.0, y: 2.0, z: 3.0, rx: 4.0, ry: 5.0, rz: 6.0 };
    assert_eq!(decode("[[1,2,3,4,5,6] , [1,2,3,4,5,\"6\"]]"), Ok(vec![pose, pose]));
    assert_eq!(words::<Pose>("[1,2,3,4,5]"), "field `rz`: the element is missing");
    assert_eq!(words::<Pose>("[1,2,3,4,5,null]"), "field `rz`: the element is missing");
    assert_eq!(words::<Pose>("[1,2,3,4,5,6,7]"), "expected the end of the array, found `7`");
    assert_eq!(words::<Pose>("[1,2,3,4,5,6 7]"), "not JSON: expected `,` or `]` at byte 13, found `7]`");
}

#[test]
fn the_last_elements_may_be_absent_or_null_and_new_ones_may_follow() {
    let ten = "1,2,3,4,5,6,7,8,9,10";
    let model_torque = |end: &str| decode::<JointMonitor>(&format!("[{ten}{end}]")).expect(end).model_torque;
    assert_eq!(
        [model_torque(""), model_torque(",null"), model_torque(",11"), model_torque(", 11, \"new\", [12]")],
        [None, None, Some(11.0), Some(11.0)]
    );
    assert_eq!(words::<JointMonitor>("[1,2,3,4,5,6,7,8,9]"), "field `torque`: the element is missing");
}

#[test]
fn elements_over_earlier_ones_are_those_of_the_text() {
    let texts = [r#"["10.5.5.1", 502]"#, r#"["10.5.5.2", 503, 7]"#, r#"["", 1, null]"#, r#"["10.5.5.3", 2, 3, "new"]"#];
    let slaves = texts.map(|text| decode::<ExtioTcp>(text).expect(text).slave_id);
    assert_eq!(slaves, [None, Some(7), None, Some(3)]);
    for before in texts {
        for text in texts {
            let mut address: ExtioTcp = decode(before).expect(before);
            address.decode_into(&mut Reader::new(text)).expect(text);
            assert_eq!(Ok(address), decode(text), "{text} over {before}");
        }
        for broken in ["[]", r#"["10.5.5.1"]"#, r#"["10.5.5.1", null]"#, r"[null, 502]", r#"["10.5.5.1", 502, "x"]"#] {
            let mut address: ExtioTcp = decode(before).expect(before);
            let error = address.decode_into(&mut Reader::new(broken)).expect_err(broken);
            assert_eq!(Err(error), decode::<ExtioTcp>(broken), "{broken}");
        }
    }
    assert_eq!(words::<ExtioTcp>("[null, 502]"), "field `address`: the element is missing");
}

#[test]
fn a_tag_tells_which_variant_the_other_keys_are_of() {
    let jog = |json: &str| Jog::read_fields(&mut Reader::new(json));
    let stop = jog(r#"{"new": [1], "coord_map": 0, "jnum": 1, "jog_mode": 0}"#).expect("it is a stop");
    assert!(matches!(stop, Jog::Stop { .. }), "{stop:?}");
    let on = jog(r#"{"jog_mode": "1", "coord_map": 0, "jnum": 1, "jogvel": 5}"#).expect("it goes on");
    assert!(matches!(on, Jog::Continuous { velocity: 5.0, .. }), "{on:?}");
    let error = |json| jog(json).expect_err(json).to_string();
    assert_eq!(error(r#"{"coord_map": 0, "jnum": 1}"#), "field `jog_mode`: the key `jog_mode` is missing");
    assert_eq!(
        error(r#"{"jog_mode": 9, "coord_map": 0, "jnum": 1}"#),
        "field `jog_mode`: expected one of 0, 1, 2, 3, found `9`"
    );
    assert_eq!(
        error(r#"{"jog_mode": 1, "jog_mode": 1, "coord_map": 0, "jnum": 1, "jogvel": 5}"#),
        "field `jog_mode`: the key appears twice"
    );
}

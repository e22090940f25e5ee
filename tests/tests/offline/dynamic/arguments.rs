//! Commands as command lines.

use expect_test::{Expect, expect};
use jaka_dynamic::{AdvisoryRanges, Argument};
use jaka_proto::Request;
use jaka_proto::wire::Writer;
use jaka_spec::{Scalar, Type};
use serde_json::{Map, Value};

use super::{SPEC, command, object, pack};

fn check_arguments(wire: &str, expected: &Expect) {
    let line = |argument: &Argument| {
        let Argument { name, wire, field, hint, help, required, values, variants, .. } = argument;
        let flags = if *required { "" } else { " (optional)" };
        let values: Vec<_> =
            values.iter().map(|value| format!("\n    {} = {}: {}", value.name, value.wire, value.help)).collect();
        format!("--{name} {hint}{flags} [{wire}, {field}] {variants:?}\n  {help}{}\n", values.concat())
    };
    let text: String = jaka_dynamic::arguments(&SPEC, command(wire)).iter().map(line).collect();
    expected.assert_eq(&text);
}

#[test]
fn each_field_is_an_argument() {
    check_arguments(
        "joint_move",
        &expect![[r#"
            --mode absolute|relative [relFlag, mode] []
              Whether `joint_position` is a target or an offset.
                absolute = 0: The coordinates are the target.
                relative = 1: The coordinates are an offset.
            --joint-position [NUMBER; 6] [jointPosition, joint_position] []
              Target or offset of the six joints. In deg. Advised: -360 to 360, where `mode` is 0 (Absolute); -720 to 720, where `mode` is 1 (Relative).
            --speed NUMBER [speed, speed] []
              Joint speed; the direction comes from `joint_position` alone. In deg/s. Allowed: at least 0. Advised: more than 0, at most 265.
            --acceleration NUMBER (optional) [accel, acceleration] []
              Joint acceleration. In deg/s². Allowed: at least 0. Advised: more than 0, at most 720.
            --tolerance NUMBER (optional) [tol, tolerance] []
              Distance from its end at which the motion may blend into the next one: 0 reaches the end. Allowed: at least 0.
            --executing-line-id INTEGER (optional) [executing_line_id, executing_line_id] []
              Id of the line that the motion belongs to, by the name.
        "#]],
    );
    check_arguments(
        "set_tio_vout_param",
        &expect![[r#"
            --output-enable INTEGER [tio_vout_ena, output_enable] []
              Raw switch of the voltage output. Allowed: 0 to 1. Sources disagree: document 2.0.4 alone: 0 = enabled, 1 = not enabled; bytes of the vendor's SDK 2.1.14, its headers (SDK 2.2.2 and another), its manual, six users, one program on port 10001: 0 = off, 1 = on.
            --output-voltage INTEGER [tio_vout_vol, output_voltage] []
              Raw choice of the voltage. Allowed: 0 to 1. Sources disagree: document 2.0.4 alone: 0 = 12 V, 1 = 24 V; bytes of the vendor's SDK 2.1.14, its headers (SDK 2.2.2 and another), its manual, six users, one program on port 10001: 0 = 24 V, 1 = 12 V.
        "#]],
    );
    check_arguments(
        "moveL",
        &expect![[r#"
            --mode absolute|relative|relative-to-tool [relFlag, mode] []
              Whether `pose` is a target or an offset, and along which axes an offset goes.
                absolute = 0: The pose is the target.
                relative = 1: The pose is an offset from the present one along the axes of the selected user frame.
                relative-to-tool = 2: The pose is an offset along the axes of the tool frame, on controllers from 1.5.13.09 on (vendor's texts). Taken by newer firmware only.
            --pose [X,Y,Z,RX,RY,RZ] [cartPosition, pose] []
              Target pose, or offset, of the tool centre point.
            --speed NUMBER [speed, speed] []
              Speed of the tool centre point along the line. In mm/s. Allowed: at least 0. Advised: more than 0, at most 10000.
            --acceleration NUMBER (optional) [accel, acceleration] []
              Acceleration of the tool centre point along the line. In mm/s². Allowed: at least 0. Advised: more than 0, at most 8000.
            --tolerance NUMBER (optional) [tol, tolerance] []
              Distance from its end at which the motion may blend into the next one: 0 reaches the end. In mm. Allowed: at least 0.
            --orientation-speed NUMBER (optional) [ori_vel, orientation_speed] []
              Speed of the orientation. In deg/s. Allowed: at least 0.
            --orientation-acceleration NUMBER (optional) [ori_acc, orientation_acceleration] []
              Acceleration of the orientation; see `orientation_speed`. In deg/s². Allowed: at least 0.
        "#]],
    );
    check_arguments("power_on", &expect![[""]]);
}

#[test]
fn a_tag_says_which_arguments_there_are() {
    check_arguments(
        "jog",
        &expect![[r#"
            --jog-mode stop|continuous|increment|absolute [jog_mode, jog_mode] []
              What is asked for, and so which further arguments there are.
                stop = 0: Stops the jog of one axis.
                continuous = 1: Moves on and on.
                increment = 2: Moves by a distance from the present position.
                absolute = 3: Moves to a position of the axis.
            --frame world|joint|tool [coord_map, frame] ["stop", "continuous", "increment", "absolute"]
              Frame of the motion to stop. With `continuous`: Frame of the motion.
                world = 0: The axes of the robot's base, or of the selected user frame (vendor's texts).
                joint = 1: A joint.
                tool = 2: The axes of the tool frame.
            --axis INTEGER [jnum, axis] ["stop", "continuous", "increment", "absolute"]
              Index of joint 1 to 6, or of x, y, z, rx, ry, rz. Allowed: 0 to 5.
            --velocity NUMBER [jogvel, velocity] ["continuous", "increment", "absolute"]
              Velocity; its sign is the direction. In deg/s for a joint or a rotation, mm/s for a translation. Advised: -10000 to 10000, not 0, where `frame` is 0 (World); -265 to 265, not 0, where `frame` is 1 (Joint); -10000 to 10000, not 0, where `frame` is 2 (Tool). With `increment`: Velocity. In deg/s for a joint or a rotation, mm/s for a translation. Advised: -10000 to 10000, not 0, where `frame` is 0 (World); -265 to 265, not 0, where `frame` is 1 (Joint); -10000 to 10000, not 0, where `frame` is 2 (Tool).
            --distance NUMBER [poscmd, distance] ["increment"]
              Distance to move; its sign is the direction. In deg for a joint or a rotation, mm for a translation. Advised: -720 to 720, where `frame` is 1 (Joint).
            --position NUMBER [poscmd, position] ["absolute"]
              Position to move to. In deg for a joint or a rotation, mm for a translation. Advised: -360 to 360, where `frame` is 1 (Joint).
        "#]],
    );
}

#[test]
fn fields_of_variants_with_one_name_and_two_types_are_two_arguments() {
    let pack = pack();
    let arguments = jaka_dynamic::arguments(&pack, pack.command("choose").expect("the pack has it"));
    let names: Vec<_> = arguments.iter().map(|argument| (argument.name.as_str(), argument.hint.as_str())).collect();
    assert_eq!(names, [("kind", "first|second"), ("size", "INTEGER"), ("second-size", "TEXT")]);
    let tag = |text| arguments[0].value(&pack, text);
    assert_eq!(tag("Second"), Ok(1.into()));
    assert_eq!(tag("1"), Ok(1.into()));
    assert_eq!(tag("third"), Err("`third` is not first|second".to_owned()));
}

#[test]
fn names_of_arguments_are_unique() {
    for command in SPEC.commands() {
        let mut names: Vec<_> =
            jaka_dynamic::arguments(&SPEC, command).into_iter().map(|argument| argument.name).collect();
        let len = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), len, "{}", command.wire);
    }
}

/// The field of a message that an argument gives, as it would be typed.
fn typed(argument: &Argument, message: &Map<String, Value>) -> Option<String> {
    let value = message.get(&argument.wire)?;
    Some(match (argument.values.iter().find(|listed| listed.wire == *value), value) {
        (Some(listed), _) => listed.name.clone(),
        (None, Value::String(_)) if argument.hint == "JSON" => value.to_string(),
        (None, Value::String(text)) => text.clone(),
        (None, Value::Array(_)) => value.to_string().trim_matches(['[', ']']).to_owned(),
        (None, value) => value.to_string(),
    })
}

#[test]
fn the_examples_can_be_typed() {
    for command in SPEC.commands() {
        let arguments = jaka_dynamic::arguments(&SPEC, command);
        for text in command.examples.iter().filter_map(|example| example.request.as_ref()) {
            let message = object(serde_json::from_str(text).expect("the examples are JSON"));
            let tag = arguments.first().and_then(|tag| typed(tag, &message));
            let applies = |argument: &&Argument| {
                argument.variants.is_empty() || tag.as_ref().is_some_and(|tag| argument.variants.contains(tag))
            };
            let mut fields = Map::new();
            for argument in arguments.iter().filter(applies) {
                if let Some(text) = typed(argument, &message) {
                    let value = argument.value(&SPEC, &text).expect("the examples have values of their types");
                    fields.insert(argument.field.clone(), value);
                }
            }
            let mut out = Writer::new();
            Request::read(text).expect("the examples decode").write(&mut out);
            let request = jaka_dynamic::request(&SPEC, command, &fields, AdvisoryRanges::Enforced);
            assert_eq!(request.as_deref(), Ok(out.as_str()));
        }
    }
}

#[test]
fn values_are_read_by_their_types() {
    let spec = pack();
    let named = |name: &str| Type::Named(spec.type_id(name).expect("the pack has it"));
    let flag = || Type::Scalar(Scalar::Bool { off: "\"out\"".to_owned(), on: "\"in\"".to_owned() });
    let list = |element: Type| Type::List(Box::new(element));
    let read = [
        (Type::Scalar(Scalar::Float), "20"),
        (Type::Scalar(Scalar::Float), "-2.5e1"),
        (Type::Scalar(Scalar::Float), "nan"),
        (Type::Scalar(Scalar::Float), "1e999"),
        (Type::Scalar(Scalar::Float), "fast"),
        (Type::Scalar(Scalar::Int), "20"),
        (Type::Scalar(Scalar::Int), "20.0"),
        (Type::Scalar(Scalar::Int), "20.5"),
        (flag(), "on"),
        (flag(), "True"),
        (flag(), "0"),
        (flag(), "in"),
        (flag(), "2"),
        (Type::Scalar(Scalar::Text), " a,b "),
        (Type::Scalar(Scalar::Json), "{\"a\": [1]}"),
        (Type::Scalar(Scalar::Json), "a b"),
        (named("Mode"), "very-fast"),
        (named("Mode"), "1"),
        (named("Mode"), "7"),
        (named("Mode"), "fast"),
        (named("Tool"), "GRIPPER"),
        (named("Tool"), "grip"),
        (named("Tool"), "hammer"),
        (list(Type::Scalar(Scalar::Float)), "0,90, -90.5"),
        (list(Type::Scalar(Scalar::Float)), "[0, 90]"),
        (list(Type::Scalar(Scalar::Float)), ""),
        (list(Type::Scalar(Scalar::Float)), "0,,1"),
        (list(flag()), "[on, off]"),
        (list(list(Type::Scalar(Scalar::Int))), "[[1],[2]]"),
        (named("Pair"), "on,slow"),
        (named("Pair"), "{\"on\": true, \"mode\": 0}"),
        (named("Pair"), "on,slow,3"),
        (named("Size"), "{\"a\": [1, 2, 3]}"),
        (named("Size"), "1,2,3"),
    ];
    let lines = read.map(|(ty, text)| match jaka_dynamic::value(&spec, &ty, text) {
        Ok(value) => format!("{text:?} is {value}\n"),
        Err(error) => format!("error: {error}\n"),
    });
    expect![[r#"
        "20" is 20.0
        "-2.5e1" is -25.0
        error: `nan` is not a number
        error: `1e999` is not a number
        error: `fast` is not a number
        "20" is 20
        "20.0" is 20
        error: `20.5` is not a whole number
        "on" is true
        "True" is true
        "0" is false
        "in" is true
        error: `2` is not on or off
        " a,b " is " a,b "
        "{\"a\": [1]}" is {"a":[1]}
        "a b" is "a b"
        "very-fast" is 1
        "1" is 1
        "7" is 7
        error: `fast` is not 0 (Slow) or 1 (VeryFast)
        "GRIPPER" is "grip"
        "grip" is "grip"
        "hammer" is "hammer"
        "0,90, -90.5" is [0.0,90.0,-90.5]
        "[0, 90]" is [0,90]
        "" is []
        error: `0,,1` is not an array, each a number
        "[on, off]" is [true,false]
        "[[1],[2]]" is [[1],[2]]
        "on,slow" is [true,0]
        "{\"on\": true, \"mode\": 0}" is {"mode":0,"on":true}
        "on,slow,3" is [true,0,"3"]
        "{\"a\": [1, 2, 3]}" is {"a":[1,2,3]}
        error: `1,2,3` is not an object
    "#]]
    .assert_eq(&lines.concat());
}

//! Queries whose replies have what a setting has set: the spec says which, and the simulator follows it.

use std::sync::LazyLock;

use jaka_spec::{Command, Field, Request as Body, Scalar, Shape, Spec};
use serde_json::Value;

use super::arm::Arm;

/// The settings and queries that are tested here.
pub(crate) fn covered() -> Vec<&'static str> {
    pairs().iter().flat_map(|(setting, query)| [&*setting.wire, &*query.wire]).collect()
}

fn spec() -> &'static Spec {
    static SPEC: LazyLock<Spec> = LazyLock::new(jaka_tests::spec);
    &SPEC
}

fn pairs() -> Vec<(&'static Command, &'static Command)> {
    let pair = |query: &'static Command| Some((spec().command(query.remembers.as_ref()?)?, query));
    spec().commands().filter_map(pair).collect()
}

/// One of the values that a field may have: its bounds, or the listed values of an enum, by turns.
fn allowed(field: &Field, turn: usize) -> Value {
    match spec().shape(&field.ty) {
        Shape::IntEnum(values) => values[turn % values.len()].wire.into(),
        Shape::Scalar(Scalar::Int) => {
            let bound = [field.range.min.unwrap_or(0.0), field.range.max.unwrap_or(7.0)][turn % 2];
            // Rust prints a whole number without a fraction.
            serde_json::from_str(&bound.to_string()).expect("it is a number")
        }
        Shape::Scalar(Scalar::Float) => {
            [field.range.min.unwrap_or(-2.5), field.range.max.unwrap_or(12.25)][turn % 2].into()
        }
        Shape::Scalar(Scalar::Text) => format!("text {turn}").into(),
        other => panic!("`{}` is {other:?}: say here which values it may have", field.name),
    }
}

fn number(value: &Value) -> Value {
    value.as_f64().map_or_else(|| value.clone(), Value::from)
}

#[test]
fn a_query_answers_what_was_last_set() {
    assert!(pairs().len() >= 3);
    for (setting, query) in pairs() {
        let mut arm = Arm::ready();
        let mut seen = Vec::new();
        for turn in 0..4 {
            let Body::Fields(sent) = &setting.request else { panic!("`{}` has a choice", setting.wire) };
            let message = sent.iter().enumerate().map(|(at, field)| (field.wire.clone(), allowed(field, turn + at)));
            let message = Value::Object(message.collect());
            arm.client.call_raw(&setting.wire, &message).expect("it is accepted");
            let reply = arm.client.call_raw(&query.wire, &Value::Null).expect("it is answered");
            for field in spec().reply_fields(query) {
                let Some(source) = sent.iter().find(|other| other.name == field.name) else { continue };
                let expected = number(message.get(&source.wire).unwrap_or(&Value::Null));
                assert_eq!(number(&reply[&field.wire]), expected, "{}: `{}`", query.wire, field.name);
                seen.push(expected.to_string());
            }
        }
        seen.sort();
        seen.dedup();
        assert!(seen.len() > 1, "`{}` sets nothing that its query answers", setting.wire);
    }
}

/// Before anything is set, the reply is that of the document; a program may set it, too.
#[test]
fn a_test_sets_what_is_remembered() {
    let mut arm = Arm::ready();
    let before = arm.client.get_traj_config().expect("it answers");
    arm.controller.set_state(|state| {
        let fields = state.remembered.entry("set_traj_config".to_owned()).or_default();
        fields.insert("speed".to_owned(), 45.into());
    });
    let reply = arm.client.get_traj_config().expect("it answers");
    assert!((reply.speed - 45.0).abs() < 1e-12 && (before.speed - 45.0).abs() > 1.0);
    assert!((reply.acceleration - before.acceleration).abs() < 1e-12);
}

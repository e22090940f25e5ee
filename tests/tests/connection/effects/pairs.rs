//! Settings are shown: by the query that the spec pairs with each, by others, and by packets.

use std::sync::LazyLock;

use jaka_spec::{Command, Field, Request as Body, Scalar, Shape, Spec, Type};
use jaka_sync::{AdvisoryRanges, Client};
use jaka_tests::Arm;
use serde_json::{Map, Value};

use super::call;

/// The key of a setting's field, and a place where it is shown: the name of a query, or nothing for a packet of port
/// 10000, and the keys and indices that lead to it there. A key in braces stands for the value of a field.
const SHOWN: [(&str, &str, &str); 19] = [
    ("rapid_rate", "rate_value", "get_rapid_rate/value"),
    ("rapid_rate", "rate_value", "/rapidrate"),
    ("servo_move", "relFlag", "is_in_servomove/in_servomove"),
    ("torque_control_enable", "enable_flag", "drag_status/drag_status"),
    ("torque_control_enable", "enable_flag", "get_drag_status/status"),
    ("torque_control_enable", "enable_flag", "/drag_status"),
    ("set_tool_offsets", "tooloffset", "get_tool_offsets/tool_offsets/{id}"),
    ("set_tool_id", "tool_id", "get_curr_tool_id/id"),
    ("set_tool_id", "tool_id", "/current_tool_id"),
    ("set_user_offsets", "userffset", "get_user_offsets/user_offsets/{id}"),
    ("set_user_id", "user_frame_id", "get_curr_user_id/id"),
    ("set_user_id", "user_frame_id", "/current_user_id"),
    ("set_traj_sample_mode", "mode", "get_traj_sample_status/sampleStatus"),
    ("set_tool_payload", "mass", "/torqsensor/0/2/0"),
    ("set_admit_ctrl_config", "opt", "get_admit_ctrl_config/admitConfig/0/{axis}/0"),
    ("set_admit_ctrl_config", "ftUser", "get_admit_ctrl_config/admitConfig/0/{axis}/1"),
    ("set_admit_ctrl_config", "ftReboundFK", "get_admit_ctrl_config/admitConfig/0/{axis}/2"),
    ("set_admit_ctrl_config", "ftConstant", "get_admit_ctrl_config/admitConfig/0/{axis}/3"),
    ("set_admit_ctrl_config", "ftNnormalTrack", "get_admit_ctrl_config/admitConfig/0/{axis}/4"),
];

fn spec() -> &'static Spec {
    static SPEC: LazyLock<Spec> = LazyLock::new(jaka_tests::spec);
    &SPEC
}

/// A setting, with the keys and places of its fields.
type Setting = (&'static Command, Vec<(String, String)>);

/// The setting that a query gives back: the one that the spec names, or for a command of the document that of its name.
fn setting_of(query: &Command) -> Option<&'static Command> {
    let own = query.section.as_ref().and_then(|_| query.wire.strip_prefix("get_")).map(|name| format!("set_{name}"));
    spec().command(query.remembers.as_ref().or(own.as_ref())?)
}

/// All settings that are shown.
fn settings() -> Vec<Setting> {
    let shown = |setting: &'static Command| {
        let listed = SHOWN.iter().filter(|(wire, ..)| *wire == setting.wire);
        let mut shown: Vec<_> = listed.map(|(_, key, place)| ((*key).to_owned(), (*place).to_owned())).collect();
        for query in spec().commands().filter(|query| setting_of(query).is_some_and(|of| of.wire == setting.wire)) {
            for field in spec().reply_fields(query) {
                let sent = setting.request.fields().find(|sent| sent.name == field.name);
                shown.extend(sent.map(|sent| (sent.wire.clone(), format!("{}/{}", query.wire, field.wire))));
            }
        }
        (setting, shown)
    };
    spec().commands().map(shown).filter(|(_, shown)| !shown.is_empty()).collect()
}

/// The settings and queries that are tested here.
pub(super) fn covered() -> Vec<String> {
    let names = |(setting, shown): &Setting| {
        let queries = shown.iter().filter_map(|(_, place)| place.split('/').next()).map(str::to_owned);
        queries.chain([setting.wire.clone()]).collect::<Vec<_>>()
    };
    settings().iter().flat_map(names).collect()
}

/// One of the values that a field may have: its bounds, or the listed values of an enum, by turns.
fn allowed(field: &Field, ty: &Type, turn: usize) -> Value {
    match spec().shape(ty) {
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
        Shape::List(element, Some(length)) => (0..length).map(|at| allowed(field, element, turn + at)).collect(),
        Shape::Tuple { fields, .. } => {
            fields.iter().enumerate().map(|(at, field)| allowed(field, &field.ty, turn + at)).collect()
        }
        other => panic!("`{}` is {other:?}: say here which values it may have", field.name),
    }
}

/// The value at a place of a reply or a packet. Truth values, however they are written, are numbers.
fn at(root: &Value, place: &str, sent: &Map<String, Value>) -> Value {
    let found = place.split('/').skip(1).fold(root, |found, key| {
        let key = key
            .strip_prefix('{')
            .and_then(|key| key.strip_suffix('}'))
            .map_or(key.to_owned(), |key| sent[key].to_string());
        key.parse::<usize>().map_or(&found[key], |index| &found[index])
    });
    plain(found)
}

fn plain(value: &Value) -> Value {
    match value {
        Value::Bool(is_on) => f64::from(*is_on).into(),
        Value::String(text) if ["True", "False"].contains(&&**text) => f64::from(text == "True").into(),
        Value::Array(elements) => elements.iter().map(plain).collect(),
        _ => value.as_f64().map_or_else(|| value.clone(), Value::from),
    }
}

/// The reply to a query; without a name, the packet that a reader gets at once.
fn shown_by(arm: &Arm, client: &mut Client, query: &str) -> Value {
    if query.is_empty() {
        let mut stream = arm.stream();
        stream.next_packet().expect("the first packet comes at once");
        return serde_json::from_str(stream.packet_text().expect("it is kept")).expect("a packet is JSON");
    }
    call(client, &format!(r#"{{"cmdName":"{query}"}}"#)).unwrap_or_else(|error| panic!("{query}: {error}"))
}

#[test]
fn what_is_set_is_shown() {
    let settings = settings();
    assert!(settings.len() >= 17, "{}", settings.len());
    for (setting, shown) in settings {
        let arm = Arm::stepped().no_packets().config(|config| config.advisory_ranges(AdvisoryRanges::Ignored));
        let (arm, mut client) = arm.with_client();
        // A firmware that has all of the queries.
        arm.set_state(|state| "1.7.2".clone_into(&mut state.version));
        let Body::Fields(fields) = &setting.request else { panic!("`{}` has a choice", setting.wire) };
        let mut seen = Vec::new();
        for turn in 0..4 {
            let value = |(at, field): (usize, &Field)| (field.wire.clone(), allowed(field, &field.ty, turn + at));
            let mut sent: Map<_, _> = fields.iter().enumerate().map(value).collect();
            sent.insert("cmdName".to_owned(), setting.wire.clone().into());
            let request = Value::from(sent.clone()).to_string();
            call(&mut client, &request).unwrap_or_else(|error| panic!("{request}: {error}"));
            for (key, place) in &shown {
                let query = place.split('/').next().unwrap_or_default();
                let found = at(&shown_by(&arm, &mut client, query), place, &sent);
                assert_eq!(found, plain(&sent[key]), "{request}: {place}");
                seen.push(found.to_string());
            }
        }
        seen.sort();
        seen.dedup();
        assert!(seen.len() > 1, "`{}` sets nothing that is shown", setting.wire);
    }
}

/// Before anything is set, the reply is that of the document; a program may set it, too.
#[test]
fn a_test_sets_what_is_remembered() {
    let (arm, mut client) = Arm::stepped().no_packets().with_client();
    let before = client.get_traj_config().expect("it answers");
    arm.set_state(|state| {
        let fields = state.remembered.entry("set_traj_config".to_owned()).or_default();
        fields.insert("speed".to_owned(), 45.into());
    });
    let reply = client.get_traj_config().expect("it answers");
    assert!((reply.speed - 45.0).abs() < 1e-12 && (before.speed - 45.0).abs() > 1.0);
    assert!((reply.acceleration - before.acceleration).abs() < 1e-12);
}

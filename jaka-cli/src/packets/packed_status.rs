//! Status packets read with packs.

use std::sync::OnceLock;

use jaka_dynamic::{Node, Reading, Translation};
use jaka_robot::{MotionStatus, Robot};
use jaka_spec::{Field, FieldSource, NeededSource, Spec};
use jaka_sync::proto::wire::{Decode, DecodeError, Reader};
use jaka_sync::status::RobotStatus;
use serde_json::{Map, Value};

use crate::builtin;
use crate::failure::Failure;
use crate::packets::fields;

/// Status packet with the fields of the built-in type, and those that only packs have.
#[derive(Debug, Clone, Default)]
pub(crate) struct PackedStatus {
    /// Packet in terms of the built-in type, also if a pack has another key or other words for the same value.
    pub(crate) status: RobotStatus,
    /// Values of fields that packs add or change, by their keys, as received.
    own: Map<String, Value>,
    /// Fields that do not fit, by names in Rust, in addition to those reported by the reader.
    pub(crate) unfit: Vec<DecodeError>,
    /// Whether packs apply. False for a packet in odd JSON, in which a key may have another meaning.
    is_by_packs: bool,
}

impl PackedStatus {
    /// Returns the packet by the spec with its packs.
    pub(crate) fn tree(&self) -> Result<Node<'static>, Failure> {
        let written = serde_json::to_value(&self.status);
        let mut json = written.map_err(|error| Failure::local("the packet cannot be written as JSON", error.into()))?;
        if let Value::Object(packet) = &mut json {
            packet.retain(|key, _| layout().own.iter().all(|field| field.wire != *key));
            packet.extend(self.own.clone());
        }
        Ok(Node::status(builtin::of_status(), json))
    }

    /// Returns the packet with only the fields that packs add or change.
    pub(crate) fn own(&self) -> Node<'static> {
        Node::status(builtin::of_status(), self.own.clone().into())
    }
}

/// Returns the fields that packs add or change.
pub(crate) fn own_fields() -> Vec<fields::Field> {
    let is_own = |field: &fields::Field| layout().own.iter().any(|own| own.name == field.name);
    fields::Field::all().into_iter().filter(is_own).collect()
}

/// Robot with status packets read by the packs of the command line.
pub(crate) type PackedRobot = Robot<PackedStatus>;

impl MotionStatus for PackedStatus {
    /// Returns no values for a packet too odd for packs.
    fn robot_status(&self) -> RobotStatus {
        if self.is_by_packs { self.status.clone() } else { RobotStatus::default() }
    }

    fn absent() -> &'static [&'static str] {
        &layout().absent
    }

    fn expected() -> &'static [[&'static str; 2]] {
        &layout().expected
    }

    fn unfit(&self) -> Vec<DecodeError> {
        self.unfit.clone()
    }
}

impl Decode for PackedStatus {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let start = reader.mark();
        if !layout().is_built_in {
            if let Ok(Value::Object(packet)) = Value::decode(reader) {
                return packed(packet, builtin::of_status(), layout());
            }
            reader.go_back(start);
        }
        // Reads odd JSON as far as possible, and without packs.
        let is_by_packs = layout().is_built_in;
        RobotStatus::decode(reader).map(|status| Self { status, is_by_packs, ..Self::default() })
    }
}

/// Difference between status packets of packs and built-in ones.
#[derive(Debug)]
struct Layout {
    /// Fields that packs add or change.
    own: Vec<&'static Field>,
    /// Names of fields that a robot needs and packets do not contain.
    absent: Vec<&'static str>,
    /// Names of required fields that a robot needs, and of their sources.
    expected: Vec<[&'static str; 2]>,
    /// Whether there is no difference.
    is_built_in: bool,
}

fn layout() -> &'static Layout {
    static LAYOUT: OnceLock<Layout> = OnceLock::new();
    LAYOUT.get_or_init(|| Layout::of(builtin::of_status()))
}

impl Layout {
    fn of(spec: &'static Spec) -> Self {
        let built_in = builtin::spec().status_fields();
        let is_own = |field: &&Field| {
            let known: Vec<_> = built_in.iter().filter(|known| spec.status_field_as(known) == Some(*field)).collect();
            !matches!(known[..], [known] if is_as_built_in(spec, field, known))
        };
        let own: Vec<_> = spec.status_fields().iter().filter(is_own).collect();
        let has_all = built_in.iter().all(|known| spec.status_field_as(known).is_some());
        let is_built_in = own.is_empty() && has_all;
        let mut layout = Self { own, absent: Vec::new(), expected: Vec::new(), is_built_in };
        for NeededSource { needed, source, is_changed } in spec.robot_status() {
            match source {
                FieldSource::Field(field) if is_changed => layout.expected.push([needed.name, &field.name]),
                FieldSource::Field(_) => {}
                FieldSource::Absent => layout.absent.push(needed.name),
                // This program does not supply these fields: each packet reports that.
                FieldSource::Program => layout.expected.push([needed.name; 2]),
            }
        }
        layout
    }
}

fn packed(mut packet: Map<String, Value>, spec: &'static Spec, layout: &Layout) -> Result<PackedStatus, DecodeError> {
    let mut unfit = Vec::new();
    for field in &layout.own {
        let node = Node::field(spec, field, packet.get(&field.wire).cloned());
        for misfit in node.departures().iter().filter(|found| found.reading == Reading::Unreadable) {
            packet.remove(&field.wire);
            unfit.push(misfit.error());
        }
    }
    unfit.extend(of_program(spec));
    let text = Value::Object(as_built_in(spec, &packet)).to_string();
    let mut reader = Reader::new(&text);
    let status = RobotStatus::decode(&mut reader)?;
    unfit.extend(reader.take_unfit());
    packet.retain(|key, _| layout.own.iter().any(|field| field.wire == *key));
    Ok(PackedStatus { status, own: packet, unfit, is_by_packs: true })
}

/// Returns errors for the fields that packs leave to a program, since this program supplies none.
fn of_program(spec: &Spec) -> impl Iterator<Item = DecodeError> {
    let sources = spec.robot_status().filter(|needed| needed.source == FieldSource::Program);
    sources.map(|NeededSource { needed, .. }| {
        let expected = "a field that the pack names in `[robot_status]`";
        DecodeError::unfit(expected, "program").in_field(needed.name)
    })
}

/// Returns the packet with the keys, words and units of the built-in type. Omits a value to which packs give another
/// type, or a unit that does not convert.
fn as_built_in(spec: &Spec, packet: &Map<String, Value>) -> Map<String, Value> {
    let translation = Translation::new(spec, builtin::spec());
    let member = |known: &Field| {
        let field = spec.status_field_as(known)?;
        Some((known.wire.clone(), translation.field(field, known, packet.get(&field.wire)?)?))
    };
    builtin::spec().status_fields().iter().filter_map(member).collect()
}

/// True if a field is read as the built-in one: key, type, unit, and all parts of the type.
fn is_as_built_in(spec: &Spec, field: &Field, known: &Field) -> bool {
    let is_same = (&known.wire, &known.ty, &known.unit) == (&field.wire, &field.ty, &field.unit);
    is_same && spec.defines_as(builtin::spec(), &field.ty)
}

#[cfg(test)]
mod tests {
    use jaka_sync::proto::wire::Decode as _;

    use super::*;

    fn spec(pack: &str) -> &'static Spec {
        let pack = format!("title = 'T'\n{pack}");
        let pack = jaka_spec::load_pack(builtin::spec(), jaka_spec::Source { path: "pack.toml", text: &pack });
        Box::leak(Box::new(pack.unwrap_or_else(|errors| panic!("{errors}")).spec))
    }

    /// Returns a packet as read by a robot with a pack of this text.
    fn read(pack: &str, packet: &str) -> PackedStatus {
        let spec = spec(pack);
        let Ok(Value::Object(packet)) = Value::decode(&mut Reader::new(packet)) else {
            panic!("{packet} is no object")
        };
        packed(packet, spec, &Layout::of(spec)).expect("it can be read")
    }

    const NEW_KEY: &str = "[[extend]]\ntarget = 'RobotStatus'\n[[extend.field]]\nwire = 'mood'\ntype = 'text'\n\
                           optional = true\ndoc = 'D.'\n";

    fn renamed(field: &str, more: &str) -> String {
        format!("[[override]]\ntarget = 'RobotStatus'\nfield = '{field}'\n{more}\n")
    }

    #[test]
    fn a_stop_that_does_not_fit_is_told_of_next_to_a_new_key() {
        let status = read(NEW_KEY, r#"{"mood": "calm", "protective_stop": "perhaps", "enabled": true}"#);
        assert_eq!(status.robot_status().protective_stop, None);
        assert!(status.unfit().iter().any(|error| error.is_in("protective_stop")), "{:?}", status.unfit());
    }

    #[test]
    fn a_changed_field_that_does_not_fit_is_told_of_by_its_name() {
        let pack = renamed("protective_stop", "wire = 'halted'");
        let status = read(&pack, r#"{"halted": "perhaps", "enabled": true}"#);
        assert!(status.unfit().iter().any(|error| error.is_in("protective_stop")), "{:?}", status.unfit());
        let status = read(&pack, r#"{"halted": 1, "enabled": true}"#);
        assert_eq!((status.robot_status().protective_stop, status.unfit().len()), (Some(true), 0));
    }

    /// Tests a circuit that is closed if no button is pressed.
    #[test]
    fn a_truth_value_is_read_as_its_pack_writes_it() {
        let pack = renamed("emergency_stop", "written = ['on', 'off']");
        for (word, expected) in [("off", Some(true)), ("on", Some(false)), ("perhaps", None)] {
            let status = read(&pack, &format!(r#"{{"emergency_stop": "{word}"}}"#));
            assert_eq!(status.robot_status().emergency_stop, expected, "{word}");
        }
    }

    #[test]
    fn a_key_can_be_that_of_another_field() {
        let pack = renamed("protective_stop", "wire = 'other'") + &renamed("drag_status", "wire = 'protective_stop'");
        for (stop, drag) in [(1, 0), (0, 1)] {
            let status = read(&pack, &format!(r#"{{"other": {stop}, "protective_stop": {drag}}}"#)).robot_status();
            assert_eq!((status.protective_stop, status.drag_status), (Some(stop == 1), Some(drag == 1)));
        }
    }

    /// Pack with a new key for the protective stop, which makes the built-in one a text.
    const MAPPED: &str = "[[extend]]\ntarget = 'RobotStatus'\n[[extend.field]]\nwire = 'halt'\nname = 'safety_halt'\n\
                          type = 'bool'\nwritten = ['free', 'halted']\noptional = true\ndoc = 'D.'\n\
                          [[override]]\ntarget = 'RobotStatus'\nfield = 'protective_stop'\ntype = 'text'\nunit = ''\n\
                          [robot_status]\nprotective_stop = 'safety_halt'\n";

    #[test]
    fn a_mapped_field_is_read_in_the_place_of_the_built_in_one() {
        for (packet, expected) in [
            (r#"{"halt": "halted", "protective_stop": "0"}"#, Some(true)),
            (r#"{"halt": "free", "protective_stop": 1}"#, Some(false)),
            (r#"{"halt": "perhaps", "protective_stop": 1}"#, None),
            (r#"{"protective_stop": 1}"#, None),
        ] {
            assert_eq!(read(MAPPED, packet).robot_status().protective_stop, expected, "{packet}");
        }
    }

    #[test]
    fn one_field_can_be_the_source_of_two() {
        let pack = renamed("powered_on", "type = 'text'\nunit = ''") + "[robot_status]\npowered_on = 'enabled'\n";
        let status = read(&pack, r#"{"enabled": true, "powered_on": "perhaps"}"#).robot_status();
        assert_eq!((status.enabled, status.powered_on), (Some(true), Some(true)));
    }

    #[test]
    fn what_is_declared_absent_or_left_to_a_program_is_not_read() {
        for word in ["absent", "program"] {
            let status = read(&format!("[robot_status]\nerror_code = '{word}'\n"), r#"{"errcode": "0x1"}"#);
            assert_eq!(status.robot_status().error_code, None, "{word}");
            let is_told = status.unfit().iter().any(|error| error.is_in("error_code"));
            assert_eq!(is_told, word == "program");
        }
        let pack =
            renamed("protective_stop", "name = 'other'\nwire = 'o'") + "[robot_status]\nprotective_stop = 'program'\n";
        assert_eq!(read(&pack, r#"{"o": 1, "protective_stop": 1}"#).robot_status().protective_stop, None);
    }

    #[test]
    fn a_packet_must_have_what_packs_map_or_change() {
        let changed = renamed("inpos", "wire = 'at_target'");
        let pack = format!("{changed}{MAPPED}error_code = 'absent'\npaused = 'program'\n");
        let layout = Layout::of(spec(&pack));
        assert_eq!(layout.absent, ["error_code"]);
        let expected = [["protective_stop", "safety_halt"], ["in_position"; 2], ["paused"; 2]];
        assert_eq!(layout.expected, expected);
    }

    #[test]
    fn a_value_in_another_unit_is_left_out() {
        let position = r#"{"joint_actual_position": [1, 2, 3, 4, 5, 6], "rapidrate": 0.5}"#;
        assert!(read(NEW_KEY, position).robot_status().joint_actual_position.is_some());
        assert_eq!(read(NEW_KEY, position).robot_status().rapid_rate, Some(0.5));
        let pack = renamed("rapidrate", "unit = '%'");
        assert_eq!(read(&pack, position).robot_status().rapid_rate, None);
    }
}

//! Status packets as packs have them.

use std::sync::OnceLock;

use jaka_dynamic::{Reading, status_departures, value};
use jaka_robot::{MotionStatus, Robot};
use jaka_spec::{Field, Scalar, Spec, Type};
use jaka_sync::proto::wire::{Decode, DecodeError, Reader};
use jaka_sync::status::RobotStatus;
use serde_json::{Map, Value};

use crate::failure::Failure;
use crate::packs;

/// A status packet: what the built-in type has, and what only packs have.
#[derive(Debug, Clone, Default)]
pub(crate) struct PackedStatus {
    /// The packet in terms of the built-in type, also where a pack has another key or other words for the same.
    pub(crate) status: RobotStatus,
    /// The keys that packs add or change, with what came.
    pub(crate) own: Map<String, Value>,
    /// What does not fit, in addition to what the reader tells.
    pub(crate) unfit: Vec<DecodeError>,
}

impl PackedStatus {
    /// The packet as JSON: as the codec writes it, whatever form the controller used, and what packs have as it came.
    pub(crate) fn json(&self) -> Result<Value, Failure> {
        let written = serde_json::to_value(&self.status);
        let mut json = written.map_err(|error| Failure::local("the packet cannot be written as JSON", error.into()))?;
        if let Value::Object(packet) = &mut json {
            packet.extend(self.own.clone());
        }
        Ok(json)
    }

    /// The fields that packs add or change, by their names, with what came.
    pub(crate) fn own_fields(&self) -> impl Iterator<Item = (&'static str, &Value)> {
        let fields = packs::of_status().status_fields().iter();
        fields.filter_map(|field| Some((&*field.name, self.own.get(&field.wire)?)))
    }
}

/// Robot whose status packets are read by the packs of the command line.
pub(crate) type PackedRobot = Robot<PackedStatus>;

impl MotionStatus for PackedStatus {
    fn robot_status(&self) -> RobotStatus {
        self.status.clone()
    }
}

impl Decode for PackedStatus {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let start = reader.mark();
        if !changed().is_empty() {
            if let Ok(Value::Object(packet)) = Value::decode(reader) {
                return packed(packet);
            }
            reader.go_back(start);
        }
        // What is odd JSON is read as far as it can be, and not by packs.
        RobotStatus::decode(reader).map(|status| Self { status, ..Self::default() })
    }
}

/// A field of the packet that is not as built in, and the built-in one of that name.
type Changed = (&'static Field, Option<Field>);

/// The fields that packs add or change.
fn changed() -> &'static [Changed] {
    static CHANGED: OnceLock<Vec<Changed>> = OnceLock::new();
    CHANGED.get_or_init(|| {
        let built_in = packs::builtin();
        let changed = packs::of_status().status_fields().iter().filter_map(|field| {
            let known = built_in.status_fields().iter().find(|known| known.name == field.name);
            let is_same = known.is_some_and(|known| known.wire == field.wire && known.ty == field.ty);
            (!is_same).then(|| (field, known.cloned()))
        });
        changed.collect()
    })
}

fn packed(packet: Map<String, Value>) -> Result<PackedStatus, DecodeError> {
    let spec = packs::of_status();
    let is_own = |key: &str| changed().iter().any(|(field, _)| field.wire == key);
    let mut own: Map<_, _> =
        packet.iter().filter(|(key, _)| is_own(key)).map(|(k, v)| (k.clone(), v.clone())).collect();
    let mut unfit = Vec::new();
    for departure in status_departures(spec, &Value::Object(packet.clone())) {
        let key = departure.field.split(['.', '[']).next().unwrap_or_default();
        if departure.reading == Reading::Unreadable && is_own(key) {
            own.remove(key);
            unfit.push(DecodeError::unfit(departure.expected, &departure.found).in_field(&departure.field));
        }
    }
    let text = Value::Object(as_built_in(spec, packet, &own)).to_string();
    let mut reader = Reader::new(&text);
    let status = RobotStatus::decode(&mut reader)?;
    unfit.extend(reader.take_unfit());
    Ok(PackedStatus { status, own, unfit })
}

/// The packet with the keys and words of the built-in type. What packs give another type is left out.
fn as_built_in(spec: &Spec, mut packet: Map<String, Value>, own: &Map<String, Value>) -> Map<String, Value> {
    for (field, known) in changed() {
        packet.remove(&field.wire);
        let Some(known) = known else { continue };
        packet.remove(&known.wire);
        let Some(found) = own.get(&field.wire) else { continue };
        if let Some(value) = same(spec, &field.ty, &known.ty, found) {
            packet.insert(known.wire.clone(), value);
        }
    }
    packet
}

/// A value in the form of another type that is the same in Rust; none of a type that is not.
fn same(spec: &Spec, ty: &Type, known: &Type, found: &Value) -> Option<Value> {
    match (ty, known) {
        (Type::Scalar(Scalar::Bool { .. }), Type::Scalar(Scalar::Bool { .. })) => {
            let text = found.as_str().map_or_else(|| found.to_string(), str::to_owned);
            value(spec, ty, &text).ok()
        }
        _ => (ty == known).then(|| found.clone()),
    }
}

//! The fields of status packets: found by name, as the spec has them, in a packet's JSON.

mod path;

use jaka_spec::{Scalar, Shape as Wire, Type};
use serde_json::{Map, Value};

use crate::builtin::of_status;
use crate::failure::Failure;

/// The fields that are shown by default.
const USUAL: &str = "powered_on,enabled,in_position,protective_stop,emergency_stop,drag_status,task_mode,\
                     interpreter_state,rapid_rate,error_code,error_message,joint_actual_position,actual_position,\
                     tcp_speed,current_tool_id,current_user_frame_id";

/// A field of the status packet, or a part of one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Field {
    /// Where it is, by the names of Rust, such as `actual_position.x`.
    pub(crate) name: String,
    /// Unit of its number or numbers, where the spec states one.
    pub(crate) unit: Option<String>,
    wire: Wire<'static>,
    steps: Vec<Step>,
}

/// A step into a packet's JSON.
#[derive(Debug, Clone, PartialEq)]
enum Step {
    Key(String),
    Index(usize),
}

/// What a field's value is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// One value.
    Single,
    /// A list of single values.
    List,
    /// Parts with names, or a list of such.
    Nested,
}

/// What a condition can do with a field's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Truth,
    Number,
    Other,
}

impl Field {
    /// The packet as a whole.
    fn packet() -> Self {
        Self { name: String::new(), unit: None, wire: Wire::Object(of_status().status_fields()), steps: Vec::new() }
    }

    /// All fields of the packet, in the order of the spec.
    pub(crate) fn all() -> Vec<Self> {
        Self::packet().members()
    }

    /// The fields that are named, with commas between them: the usual ones where none are, and all of them for `all`.
    ///
    /// # Errors
    /// There is no field of a name; the message has similar ones.
    pub(crate) fn named(names: Option<&str>) -> Result<Vec<Self>, Failure> {
        match names.unwrap_or(USUAL) {
            "all" => Ok(Self::all()),
            names => names.split(',').map(|name| Self::find(name).map_err(Failure::Usage)).collect(),
        }
    }

    /// The field at a path of names, in Rust or on the wire, and indices: `joint_actual_position[0]`.
    ///
    /// # Errors
    /// No field has this path; the message has similar names.
    pub(crate) fn find(path: &str) -> Result<Self, String> {
        path::find(Self::packet(), path)
    }

    /// Its value in a packet's JSON; `None` where the packet has none, or one of another shape.
    pub(crate) fn value<'v>(&self, packet: &'v Value) -> Option<&'v Value> {
        let step = |value: &'v Value, step: &Step| match step {
            Step::Key(key) => value.get(key),
            Step::Index(index) => value.get(index),
        };
        self.steps.iter().try_fold(packet, step).filter(|value| !value.is_null())
    }

    /// What its value is made of.
    pub(crate) fn shape(&self) -> Shape {
        match self.wire {
            Wire::List(..) if self.element(0).shape() == Shape::Single => Shape::List,
            Wire::List(..) => Shape::Nested,
            _ if !self.members().is_empty() => Shape::Nested,
            _ => Shape::Single,
        }
    }

    /// What a condition can do with its value.
    pub(crate) fn kind(&self) -> Kind {
        match self.wire {
            Wire::Scalar(Scalar::Bool { .. }) => Kind::Truth,
            Wire::Scalar(scalar) if scalar.is_number() => Kind::Number,
            Wire::IntEnum(_) => Kind::Number,
            _ => Kind::Other,
        }
    }

    /// Its parts: those of its type, and as many elements as the packet has where the type leaves that open.
    pub(crate) fn parts(&self, packet: &Value) -> Vec<Self> {
        let count = match self.wire {
            Wire::List(_, Some(count)) => count,
            Wire::List(_, None) => self.value(packet).and_then(Value::as_array).map_or(0, Vec::len),
            _ => return self.members(),
        };
        (0..count).map(|index| self.element(index)).collect()
    }

    /// Its parts all the way down.
    pub(crate) fn leaves(self, packet: &Value) -> Vec<Self> {
        let parts = self.parts(packet);
        if parts.is_empty() || self.is_other(packet) {
            return vec![self];
        }
        parts.into_iter().flat_map(|part| part.leaves(packet)).collect()
    }

    /// True where the packet has a value that cannot have the parts of the type.
    pub(crate) fn is_other(&self, packet: &Value) -> bool {
        self.value(packet).is_some_and(|value| !value.is_object() && !value.is_array())
    }

    /// Its value in a packet's JSON with the names of Rust, and truth values as `true` and `false`.
    pub(crate) fn named_value(&self, packet: &Value) -> Option<Value> {
        let value = self.value(packet)?;
        let members = self.members();
        if !members.is_empty() && !self.is_other(packet) {
            let prefix = self.name.len() + 1;
            let entries =
                members.iter().filter_map(|part| Some((part.name[prefix..].to_owned(), part.named_value(packet)?)));
            return Some(Value::Object(entries.collect::<Map<_, _>>()));
        }
        match self.wire {
            Wire::List(..) if value.is_array() => {
                let elements = self.parts(packet).into_iter();
                Some(elements.map(|part| part.named_value(packet).unwrap_or_default()).collect())
            }
            Wire::Scalar(Scalar::Bool { on, off }) => {
                let text = value.to_string();
                let truth = [(on, true), (off, false)].into_iter().find(|(wire, _)| **wire == text);
                Some(truth.map_or_else(|| value.clone(), |(_, truth)| truth.into()))
            }
            _ => Some(value.clone()),
        }
    }

    /// The name of its value, if its type is an enum that knows it.
    pub(crate) fn value_name(&self, value: &Value) -> Option<&'static str> {
        value_name(self.wire, value)
    }

    /// True for floating-point numbers.
    pub(crate) fn is_float(&self) -> bool {
        self.wire == Wire::Scalar(&Scalar::Float)
    }

    /// The parts that its type names.
    fn members(&self) -> Vec<Self> {
        let (Wire::Object(fields) | Wire::Tuple { fields, .. }) = self.wire else { return Vec::new() };
        let dot = if self.name.is_empty() { "" } else { "." };
        let member = |(index, field): (usize, &'static jaka_spec::Field)| {
            let is_keyed = matches!(self.wire, Wire::Object(_));
            let step = if is_keyed { Step::Key(field.wire.clone()) } else { Step::Index(index) };
            self.part(format!("{}{dot}{}", self.name, field.name), field.unit.as_deref(), &field.ty, step)
        };
        fields.iter().enumerate().map(member).collect()
    }

    /// An element of a list.
    fn element(&self, index: usize) -> Self {
        let Wire::List(element, _) = self.wire else { return self.clone() };
        self.part(format!("{}[{index}]", self.name), self.unit.as_deref(), element, Step::Index(index))
    }

    fn part(&self, name: String, unit: Option<&str>, ty: &'static Type, step: Step) -> Self {
        let unit = unit.or_else(|| of_status().unit(ty)).map(str::to_owned);
        Self { name, unit, wire: of_status().shape(ty), steps: self.steps.iter().cloned().chain([step]).collect() }
    }
}

/// The name of a value, if it is one of an enum that knows it.
pub(crate) fn value_name<'s>(shape: Wire<'s>, value: &Value) -> Option<&'s str> {
    match shape {
        Wire::IntEnum(known) => known.iter().find(|known| Some(known.wire) == value.as_i64()).map(|known| &*known.name),
        Wire::TextEnum(known) => {
            known.iter().find(|known| Some(&*known.wire) == value.as_str()).map(|known| &*known.name)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;

    #[test]
    fn values_are_found_by_either_name() {
        let packet = json!({"joint_actual_position": [1.5, 2, 3, 4, 5, 6], "din": [0, 1], "task_state": 4});
        let value = |path| Field::find(path).unwrap().named_value(&packet);
        assert_eq!(value("joint_actual_position[0]"), Some(json!(1.5)));
        assert_eq!(value("din[1]"), Some(json!(true)));
        assert_eq!(value("digital_inputs"), Some(json!([false, true])));
        assert_eq!(value("digital_inputs[2]"), None);
        assert_eq!(value("actual_position.x"), None);
        let state = Field::find("task_state").unwrap();
        assert_eq!(state.value(&packet).and_then(|value| state.value_name(value)), Some("Enabled"));
    }

    #[test]
    fn structs_have_their_names_whatever_their_json() {
        let packet = json!({"actual_position": [1, 2, 3, 4, 5, 6]});
        let pose = Field::find("actual_position").unwrap();
        expect![[r#"{"rx":4,"ry":5,"rz":6,"x":1,"y":2,"z":3}"#]]
            .assert_eq(&pose.named_value(&packet).unwrap().to_string());
        let leaves: Vec<_> = pose.leaves(&packet).iter().map(|leaf| (leaf.name.clone(), leaf.unit.clone())).collect();
        assert_eq!(leaves[0], ("actual_position.x".to_owned(), Some("mm".to_owned())));
        assert_eq!(leaves.len(), 6);
    }

    #[test]
    fn a_value_of_another_shape_is_passed_on() {
        let packet = json!({"monitor_data": "none", "powered_on": 7});
        assert_eq!(Field::find("monitor_data").unwrap().named_value(&packet), Some(json!("none")));
        assert_eq!(Field::find("monitor_data.joints").unwrap().named_value(&packet), None);
        assert_eq!(Field::find("powered_on").unwrap().named_value(&packet), Some(json!(7)));
    }
}

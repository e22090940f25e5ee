//! Fields of status packets, by name, and values as text.

mod path;

use jaka_dynamic::{Label, Node};
use jaka_robot::proto::text::visible_json;
use jaka_spec::{Scalar, Shape};
use serde_json::{Map, Value};

use crate::builtin::of_status;
use crate::failure::Failure;
use crate::terminal::output;

/// Default fields.
const USUAL: &str = "powered_on,enabled,in_position,protective_stop,emergency_stop,drag_status,task_mode,\
                     interpreter_state,rapid_rate,error_code,error_message,joint_actual_position,actual_position,\
                     tcp_speed,current_tool_id,current_user_frame_id";

/// Field of status packets, or a part of one.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    /// Path by the names in Rust, such as `actual_position.x`.
    pub(crate) name: String,
    /// Field without a value.
    place: Node<'static>,
    path: Vec<Label<'static>>,
}

/// Use of a field's value in a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Truth,
    Number,
    Other,
}

impl Field {
    /// Returns the packet as a whole.
    fn packet() -> Self {
        let place = Node::status(of_status(), Map::new().into());
        Self { name: String::new(), place, path: Vec::new() }
    }

    /// Returns all fields of the packet, in the order of the spec.
    pub(crate) fn all() -> Vec<Self> {
        Self::packet().members()
    }

    /// Returns the named fields, separated by commas; without names the default fields, and for `all` all fields.
    ///
    /// # Errors
    /// A name has no field; the message has similar ones.
    pub(crate) fn named(names: Option<&str>) -> Result<Vec<Self>, Failure> {
        match names.unwrap_or(USUAL) {
            "all" => Ok(Self::all()),
            names => names.split(',').map(|name| Self::find(name).map_err(Failure::Usage)).collect(),
        }
    }

    /// Returns the field at a path of names, in Rust or on the wire, and indices: `joint_actual_position[0]`.
    ///
    /// # Errors
    /// No field has this path; the message has similar names.
    pub(crate) fn find(path: &str) -> Result<Self, String> {
        path::find(Self::packet(), path)
    }

    /// Returns the unit of its number or numbers, if the spec states one.
    pub(crate) fn unit(&self) -> Option<&'static str> {
        self.place.unit()
    }

    /// Returns its node in a packet, unless it is missing or null.
    pub(crate) fn value<'p>(&self, packet: &'p Node<'_>) -> Option<&'p Node<'p>> {
        packet.at(&self.path)
    }

    /// Returns its value in a packet by the names in Rust, and with truth values as `true` and `false`.
    pub(crate) fn named_value(&self, packet: &Node<'_>) -> Option<Value> {
        self.value(packet).map(Node::named)
    }

    /// Returns the use of its value in a condition.
    pub(crate) fn kind(&self) -> Kind {
        match self.place.shape() {
            Some(Shape::Scalar(Scalar::Bool { .. })) => Kind::Truth,
            Some(Shape::Scalar(scalar)) if scalar.is_number() => Kind::Number,
            Some(Shape::IntEnum(_)) => Kind::Number,
            _ => Kind::Other,
        }
    }

    /// Returns its parts, recursively: those of its type, and as many elements as the packet has if the type leaves the
    /// number open.
    pub(crate) fn leaves(self, packet: &Node<'_>) -> Vec<Self> {
        let value = self.value(packet);
        let parts = match self.place.shape() {
            _ if value.is_some_and(Node::is_leaf) => Vec::new(),
            Some(Shape::List(_, count)) => {
                let count = count.unwrap_or_else(|| value.map_or(0, |value| value.parts().len()));
                (0..count).filter_map(|index| self.element(index)).collect()
            }
            _ => self.members(),
        };
        if parts.is_empty() { vec![self] } else { parts.into_iter().flat_map(|part| part.leaves(packet)).collect() }
    }

    /// Returns the named parts of its type.
    fn members(&self) -> Vec<Self> {
        self.place.members().into_iter().map(|member| self.part(member)).collect()
    }

    /// Returns an element, if the field is an array.
    fn element(&self, index: usize) -> Option<Self> {
        self.place.element(index).map(|element| self.part(element))
    }

    fn part(&self, place: Node<'static>) -> Self {
        let name = place.label().path(&self.name);
        Self { name, path: self.path.iter().chain([place.label()]).cloned().collect(), place }
    }
}

/// Formats a value without parts, with the name of an enum value; formats floating-point numbers with `float`.
pub(crate) fn leaf_text(node: &Node<'_>, float: impl Fn(f64) -> String) -> String {
    let value = node.value();
    let number = value.as_f64().filter(|_| node.shape() == Some(Shape::Scalar(&Scalar::Float)));
    match (number, node.value_name()) {
        (Some(number), _) => float(number),
        (None, Some(name)) => format!("{name} ({})", plain(&value)),
        (None, None) => plain(&value),
    }
}

/// Formats a value unchanged, except for control characters of a terminal.
pub(crate) fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => output::cell(text).into_owned(),
        _ => visible_json(&value.to_string()).into_owned(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;
    use crate::tests::packet;

    #[test]
    fn values_are_found_by_either_name() {
        let packet = packet(json!({"joint_actual_position": [1.5, 2, 3, 4, 5, 6], "din": [0, 1], "task_state": 4}));
        let value = |path| Field::find(path).unwrap().named_value(&packet);
        assert_eq!(value("joint_actual_position[0]"), Some(json!(1.5)));
        assert_eq!(value("din[1]"), Some(json!(true)));
        assert_eq!(value("digital_inputs"), Some(json!([false, true])));
        assert_eq!(value("digital_inputs[2]"), None);
        assert_eq!(value("actual_position.x"), None);
        let state = Field::find("task_state").unwrap();
        assert_eq!(state.value(&packet).and_then(Node::value_name), Some("Enabled"));
    }

    #[test]
    fn structs_have_their_names_whatever_their_json() {
        let packet = packet(json!({"actual_position": [1, 2, 3, 4, 5, 6]}));
        let pose = Field::find("actual_position").unwrap();
        expect![[r#"{"rx":4,"ry":5,"rz":6,"x":1,"y":2,"z":3}"#]]
            .assert_eq(&pose.named_value(&packet).unwrap().to_string());
        let leaves: Vec<_> = pose.leaves(&packet).iter().map(|leaf| (leaf.name.clone(), leaf.unit())).collect();
        assert_eq!(leaves[0], ("actual_position.x".to_owned(), Some("mm")));
        assert_eq!(leaves.len(), 6);
    }

    #[test]
    fn a_value_of_another_shape_is_passed_on() {
        let packet = packet(json!({"monitor_data": "none", "powered_on": 7}));
        assert_eq!(Field::find("monitor_data").unwrap().named_value(&packet), Some(json!("none")));
        assert_eq!(Field::find("monitor_data.joints").unwrap().named_value(&packet), None);
        assert_eq!(Field::find("powered_on").unwrap().named_value(&packet), Some(json!(7)));
    }
}

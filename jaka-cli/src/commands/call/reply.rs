//! Replies as a table: the fields by their names in Rust, with units.

use itertools::Itertools as _;
use jaka_dynamic::value as read;
use jaka_spec::{COMMAND_NAME, Choice, Command, ENVELOPE, Field, Request, Scalar, Shape, Spec, Type};
use jaka_sync::proto::python;
use jaka_sync::proto::text::{visible, visible_json};
use jaka_sync::proto::wire::{Decode, Reader};
use serde_json::{Map, Value};

use crate::fields::value_name;
use crate::number::fixed;
use crate::output;

/// A reply's JSON; its text as a JSON string where it is not JSON, as a bare Python tuple, or where a key comes twice.
pub(crate) fn json(text: &str) -> Value {
    let mut reader = Reader::new(text);
    let value = Value::decode(&mut reader).and_then(|value| reader.end().map(|()| value));
    value.unwrap_or_else(|_| text.trim().into())
}

/// A row for each field that the reply has; `accepted` where it has none.
pub(super) fn table(spec: &Spec, command: Option<&Command>, text: &str) -> String {
    let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
    let mut table = ReplyTable { spec, rows: Vec::new() };
    match json(text) {
        Value::Object(reply) => {
            let payload = reply.into_iter().filter(|(key, _)| !ENVELOPE.contains(&key.as_str())).collect();
            table.object("", fields, &payload);
        }
        bare => {
            let name = command.and_then(|command| command.bare_reply.as_ref());
            match fields.iter().find(|field| Some(&field.name) == name) {
                Some(field) => table.field("", field, &bare),
                None => table.add("reply", plain(&bare)),
            }
        }
    }
    table.text()
}

/// A row for each field of a request.
pub(super) fn of_request(spec: &Spec, command: &Command, text: &str) -> String {
    let (mut table, Value::Object(mut request)) = (ReplyTable { spec, rows: Vec::new() }, json(text)) else {
        return String::new();
    };
    request.remove(COMMAND_NAME);
    match &command.request {
        Request::Fields(fields) => table.object("", fields, &request),
        Request::Choice(choice) => {
            let tag = request.remove(&choice.tag);
            let variant = choice.variants.iter().find(|variant| tag == Some(variant.wire.into()));
            if let Some(variant) = variant {
                table.add(&choice.tag, format!("{} ({})", variant.name, variant.wire));
            }
            table.object("", variant.map_or(&[], |variant| &variant.fields), &request);
        }
    }
    if table.rows.is_empty() { String::new() } else { table.text() }
}

struct ReplyTable<'s> {
    spec: &'s Spec,
    rows: Vec<(String, String)>,
}

impl ReplyTable<'_> {
    fn text(self) -> String {
        if self.rows.is_empty() {
            return "accepted\n".to_owned();
        }
        // Names may come from the controller, too.
        let rows: Vec<_> = self.rows.iter().map(|(name, value)| (visible(name), visible(value))).collect();
        output::aligned(&rows)
    }

    fn add(&mut self, name: impl Into<String>, value: String) {
        self.rows.push((name.into(), value));
    }

    fn object(&mut self, place: &str, fields: &[Field], object: &Map<String, Value>) {
        for field in fields {
            object.get(&field.wire).into_iter().for_each(|value| self.field(place, field, value));
        }
        for (key, value) in object.iter().filter(|(key, _)| fields.iter().all(|field| field.wire != **key)) {
            self.add(member(place, key), format!("{} (not in the spec)", plain(value)));
        }
    }

    fn field(&mut self, place: &str, field: &Field, value: &Value) {
        self.value(&member(place, &field.name), &field.ty, field.unit.as_deref(), value);
    }

    fn elements(&mut self, place: &str, fields: &[Field], elements: &[Value]) {
        for (index, value) in elements.iter().enumerate() {
            match fields.get(index) {
                Some(field) => self.field(place, field, value),
                None => self.add(format!("{place}[{index}]"), format!("{} (not in the spec)", plain(value))),
            }
        }
    }

    fn value(&mut self, place: &str, ty: &Type, unit: Option<&str>, value: &Value) {
        let unit = self.spec.unit(ty).or(unit);
        match (self.spec.shape(ty), value) {
            (Shape::Python(inner), Value::String(literal)) => match python::to_json(literal) {
                Ok(text) => self.value(place, inner, unit, &json(&text)),
                Err(_) => self.add(place, plain(value)),
            },
            (Shape::List(element, _), Value::Array(items)) if self.has_parts(element) => {
                if items.is_empty() {
                    self.add(place, "none".to_owned());
                }
                for (index, item) in items.iter().enumerate() {
                    self.value(&format!("{place}[{index}]"), element, unit, item);
                }
            }
            (Shape::List(element, _), Value::Array(items)) => {
                let texts = items.iter().map(|item| self.scalar(element, item)).join(", ");
                self.add(place, if items.is_empty() { "none".to_owned() } else { with_unit(&texts, unit) });
            }
            (Shape::Object(fields), Value::Object(object)) => self.object(place, fields, object),
            (Shape::Tuple { fields, .. }, Value::Array(elements)) => self.elements(place, fields, elements),
            (Shape::Choice(choice), Value::Array(elements)) => self.choice(place, choice, elements),
            (shape, _) => {
                let text = self.scalar(ty, value);
                // Only numbers have units, not a word in place of a list.
                let is_number = matches!(shape, Shape::Scalar(scalar) if scalar.is_number());
                self.add(place, with_unit(&text, unit.filter(|_| is_number)));
            }
        }
    }

    fn choice(&mut self, place: &str, choice: &Choice, elements: &[Value]) {
        let variant = choice.variants.iter().find(|variant| elements.first() == Some(&variant.wire.into()));
        match variant {
            Some(variant) => {
                self.add(place, format!("{} ({})", variant.name, variant.wire));
                self.elements(place, &variant.fields, &elements[1..]);
            }
            None => self.add(place, plain(&elements.into())),
        }
    }

    /// True for a type whose parts have rows of their own.
    fn has_parts(&self, ty: &Type) -> bool {
        match self.spec.shape(ty) {
            Shape::List(..) | Shape::Python(_) | Shape::Object(_) | Shape::Tuple { .. } | Shape::Choice(_) => true,
            Shape::Scalar(_) | Shape::IntEnum(_) | Shape::TextEnum(_) => false,
        }
    }

    /// A single value in the spec's form, whatever form the controller used.
    fn scalar(&self, ty: &Type, value: &Value) -> String {
        let text = plain(value);
        let is_as_it_is = matches!(self.spec.shape(ty), Shape::Scalar(Scalar::Json | Scalar::Text));
        if is_as_it_is || value.is_array() || value.is_object() || value.is_null() {
            return text;
        }
        let Ok(value) = read(self.spec, ty, value.as_str().unwrap_or(&text)) else { return text };
        if let (true, Some(number)) = (value.is_f64(), value.as_f64()) {
            return decimals(number);
        }
        let name = value_name(self.spec.shape(ty), &value);
        name.map_or_else(|| plain(&value), |name| format!("{name} ({})", plain(&value)))
    }
}

fn member(outer: &str, name: &str) -> String {
    if outer.is_empty() { name.to_owned() } else { format!("{outer}.{name}") }
}

fn with_unit(text: &str, unit: Option<&str>) -> String {
    unit.map_or_else(|| text.to_owned(), |unit| format!("{text} {unit}"))
}

/// A number for people, with up to six decimals.
fn decimals(number: f64) -> String {
    let text = fixed(number, 6);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A value as it came, except for characters on which a terminal would act.
fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => output::cell(text).into_owned(),
        _ => visible_json(&value.to_string()).into_owned(),
    }
}

//! Values of replies in other forms than the document's, by what the spec says they are.

use jaka_proto::wire::{Decode, Reader, Writer};
use jaka_spec::{Field, Scalar, Shape, Spec, Type};

use super::{NumberStyle, ReplyStyle, TruthStyle};
use crate::json_text::{elements, members};

/// Writes values in a style. What does not fit its type stays as it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Values<'s> {
    pub(super) spec: &'s Spec,
    pub(super) style: ReplyStyle,
}

impl Values<'_> {
    /// Writes the value of a field, given as JSON.
    pub(super) fn field(self, field: &Field, json: &str, out: &mut Writer) {
        self.value(&field.name, &field.ty, json, out);
    }

    fn value(self, name: &str, ty: &Type, json: &str, out: &mut Writer) {
        match self.spec.shape(ty) {
            Shape::Scalar(Scalar::Bool { off, on }) => self.truth(name, [off, on], json, out),
            Shape::Scalar(Scalar::Int | Scalar::Float) | Shape::IntEnum(_) => self.number(json, out),
            Shape::List(element, _) => self.list(name, element, json, out),
            Shape::Object(fields) => self.object(fields, json, out),
            Shape::Tuple { fields, .. } => self.array(fields, json, out),
            // Choices stand only in Python literals.
            Shape::Scalar(Scalar::Text | Scalar::Json) | Shape::Python(_) | Shape::TextEnum(_) | Shape::Choice(_) => {
                out.raw(json);
            }
        }
    }

    fn list(self, name: &str, element: &Type, json: &str, out: &mut Writer) {
        match elements(json) {
            Some(list) => out.array(&list, |out, json| self.value(name, element, json, out)),
            None => out.raw(json),
        }
    }

    fn object(self, fields: &[Field], json: &str, out: &mut Writer) {
        let Some(members) = members(json) else { return out.raw(json) };
        out.raw("{");
        for (key, json) in members {
            out.comma();
            out.text(&key);
            out.raw(":");
            match fields.iter().find(|field| field.wire == key) {
                Some(field) => self.field(field, json, out),
                None => out.raw(json),
            }
        }
        out.raw("}");
    }

    /// Elements beyond the fields stay as they are.
    fn array(self, fields: &[Field], json: &str, out: &mut Writer) {
        let Some(elements) = elements(json) else { return out.raw(json) };
        out.raw("[");
        for (i, json) in elements.into_iter().enumerate() {
            out.comma();
            match fields.get(i) {
                Some(field) => self.field(field, json, out),
                None => out.raw(json),
            }
        }
        out.raw("]");
    }

    fn truth(self, name: &str, printed: [&str; 2], json: &str, out: &mut Writer) {
        let value = printed.iter().position(|form| *form == json).map(|at| at == 1);
        let value = value.or_else(|| bool::decode(&mut Reader::new(json)).ok());
        let [off, on] = self.forms(name, printed);
        match value {
            Some(value) => out.choose(value, off, on),
            None => out.raw(json),
        }
    }

    /// How false and true are written.
    fn forms<'f>(&'f self, name: &str, printed: [&'f str; 2]) -> [&'f str; 2] {
        match self.style.truths {
            TruthStyle::Document => printed,
            TruthStyle::Packet => match self.packet_forms(name) {
                Some(forms) => forms,
                None if printed[1].starts_with('"') => ["false", "true"],
                None => printed,
            },
            TruthStyle::Literals => ["false", "true"],
            TruthStyle::Numbers => ["0", "1"],
            TruthStyle::NumberTexts => ["\"0\"", "\"1\""],
            TruthStyle::Words => ["\"False\"", "\"True\""],
        }
    }
    /// How status packets write false and true of the value with this name, if they have it.
    fn packet_forms(&self, name: &str) -> Option<[&str; 2]> {
        match &self.spec.status_fields().iter().find(|field| field.name == name)?.ty {
            Type::Scalar(Scalar::Bool { off, on }) => Some([off, on]),
            _ => None,
        }
    }

    fn number(self, json: &str, out: &mut Writer) {
        let is_number = json.starts_with(|c: char| c == '-' || c.is_ascii_digit());
        match self.style.numbers {
            NumberStyle::Texts if is_number => out.text(json),
            NumberStyle::Fractions if is_number && !json.contains(['.', 'e', 'E']) => {
                out.raw(json);
                out.raw(".0");
            }
            _ => out.raw(json),
        }
    }
}

//! Conversion of replies, and of values in replies and packets, to other forms than the document's, by their types in
//! the spec.

use std::iter::{once, repeat};

use jaka_proto::Envelope;
use jaka_proto::wire::{Decode, Reader, Writer};
use jaka_spec::{Field, Scalar, Shape, Spec, Type};

use super::Writing;
use super::shape::Shape as FirmwareShape;
use crate::json_text::{elements, members, respace};

/// Writer of values in the form of a firmware. A value that does not fit its type stays unchanged.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Values<'s> {
    spec: &'s Spec,
    writing: Writing,
    /// Number of decimals of joint positions.
    joint_decimals: usize,
    /// Number of decimals of poses.
    pose_decimals: usize,
    /// Number of decimals of the present position; `None` outside positions.
    decimals: Option<usize>,
}

impl<'s> Values<'s> {
    pub(crate) fn of_replies(spec: &'s Spec, writing: Writing) -> Self {
        Self { spec, writing, joint_decimals: 6, pose_decimals: 6, decimals: None }
    }

    pub(crate) fn of_packets(spec: &'s Spec, shape: &FirmwareShape) -> Self {
        Self { joint_decimals: 5, pose_decimals: shape.pose_decimals, ..Self::of_replies(spec, shape.writing) }
    }

    /// Rewrites a reply in the document's form. Text other than a JSON object stays unchanged.
    pub(crate) fn rewrite(self, reply: &mut Writer) {
        if self.writing == Writing::Document {
            return;
        }
        if let Some(text) = self.rewritten(reply.as_str()) {
            reply.clear();
            reply.raw(&text);
        }
    }

    fn rewritten(self, reply: &str) -> Option<String> {
        let envelope = Envelope::read(reply).ok()?;
        let command = envelope.command.as_deref().and_then(|name| self.spec.command(name));
        let fields = command.map_or(&[][..], |command| self.spec.reply_fields(command));
        let mut rewritten = Vec::new();
        for (key, json) in members(reply)? {
            let mut out = Writer::new();
            out.text(&key);
            out.raw(":");
            match fields.iter().find(|field| field.wire == key) {
                Some(field) => self.field(field, json, &mut out),
                None => out.raw(json),
            }
            rewritten.push(out.into_string());
        }
        Some(respace(&format!("{{{}}}", rewritten.join(",")), self.writing.blank()))
    }

    /// Writes the value of a field, given as JSON.
    pub(crate) fn field(self, field: &Field, json: &str, out: &mut Writer) {
        self.value(&field.name, &field.ty, json, out);
    }

    fn value(self, name: &str, ty: &Type, json: &str, out: &mut Writer) {
        if let Some(decimals) = self.decimals_of(ty).filter(|_| self.decimals.is_none()) {
            return Self { decimals: Some(decimals), ..self }.value(name, ty, json, out);
        }
        if self.restyled(name, ty, json, out).is_none() {
            out.raw(json);
        }
    }

    /// Writes the value in the form of the firmware; returns `None` if it stays unchanged.
    fn restyled(self, name: &str, ty: &Type, json: &str, out: &mut Writer) -> Option<()> {
        match self.spec.shape(ty) {
            Shape::Scalar(Scalar::Bool { off, on }) => self.truth(name, [off, on], json, out)?,
            Shape::Scalar(Scalar::Float) => self.float(json, out),
            Shape::List(element, _) => {
                out.array(&elements(json)?, |out, json| self.value(name, element, json, out));
            }
            Shape::Object(fields) => self.object(fields, members(json)?, out),
            // Elements beyond the fields stay unchanged.
            Shape::Tuple { fields, .. } => self.elements(fields.iter().map(Some), &elements(json)?, out),
            Shape::Choice(choice) => {
                let elements = elements(json)?;
                let tag = elements.first()?;
                let variant = choice.variants.iter().find(|variant| variant.wire.to_string() == *tag)?;
                self.elements(once(None).chain(variant.fields.iter().map(Some)), &elements, out);
            }
            Shape::Scalar(Scalar::Int | Scalar::Text | Scalar::Json)
            | Shape::Python(_)
            | Shape::IntEnum(_)
            | Shape::TextEnum(_) => return None,
        }
        Some(())
    }

    fn object(self, fields: &[Field], members: Vec<(String, &str)>, out: &mut Writer) {
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

    fn elements<'f>(self, fields: impl Iterator<Item = Option<&'f Field>>, elements: &[&str], out: &mut Writer) {
        out.raw("[");
        for (json, field) in elements.iter().zip(fields.chain(repeat(None))) {
            out.comma();
            match field {
                Some(field) => self.field(field, json, out),
                None => out.raw(json),
            }
        }
        out.raw("]");
    }

    fn truth(self, name: &str, printed: [&str; 2], json: &str, out: &mut Writer) -> Option<()> {
        let value = printed.iter().position(|form| *form == json).map(|at| at == 1);
        let value = value.or_else(|| bool::decode(&mut Reader::new(json)).ok())?;
        let [off, on] = self.forms(name, printed);
        out.choose(value, off, on);
        Some(())
    }

    /// Returns the forms of false and true.
    fn forms<'f>(&'f self, name: &str, printed: [&'f str; 2]) -> [&'f str; 2] {
        match self.writing {
            Writing::Document | Writing::Capture => printed,
            // For the document's words, such as `robot_enabled`, a real reply has these forms.
            Writing::AsPackets if printed[1].contains('_') => ["\"False\"", "\"True\""],
            Writing::AsPackets => match self.packet_forms(name) {
                Some(forms) => forms,
                None if printed[1].starts_with('"') => ["false", "true"],
                None => printed,
            },
        }
    }

    /// Returns the forms of false and true for the value of this name in status packets, if packets have it.
    fn packet_forms(&self, name: &str) -> Option<[&str; 2]> {
        match &self.spec.status_fields().iter().find(|field| field.name == name)?.ty {
            Type::Scalar(Scalar::Bool { off, on }) => Some([off, on]),
            _ => None,
        }
    }

    /// Writes a number that may have a fraction.
    fn float(self, json: &str, out: &mut Writer) {
        let Ok(number) = json.parse::<f64>() else { return out.raw(json) };
        match (self.writing, self.decimals) {
            (Writing::Document, _) => out.float(number),
            (Writing::Capture | Writing::AsPackets, Some(decimals)) => {
                let text = format!("{number:.decimals$}");
                let short = text.trim_end_matches('0');
                out.raw(short);
                out.raw(if short.ends_with('.') { "0" } else { "" });
            }
            (Writing::Capture | Writing::AsPackets, None) => with_fraction(json, out),
        }
    }

    /// Returns the number of decimals of a joint position or a pose; `None` for any other type.
    fn decimals_of(self, ty: &Type) -> Option<usize> {
        let Type::Named(id) = ty else { return None };
        match &*self.spec[*id].name {
            jaka_spec::JOINT_POSITION => Some(self.joint_decimals),
            jaka_spec::POSE => Some(self.pose_decimals),
            _ => None,
        }
    }
}

fn with_fraction(json: &str, out: &mut Writer) {
    let is_whole = json.starts_with(|c: char| c == '-' || c.is_ascii_digit()) && !json.contains(['.', 'e', 'E']);
    out.raw(json);
    out.raw(if is_whole { ".0" } else { "" });
}

//! Values into JSON.

use serde_json::Value;

use super::{Encoder, is_value};
use crate::json::limits::{AdvisoryRanges, Slot};
use crate::json::names::same;
use crate::json::problem::element;
use crate::json::scalar::{self, Form};
use crate::json::text;
use crate::{EnumValue, Type, TypeKind};

impl Encoder<'_> {
    pub(super) fn value(&mut self, slot: &Slot<'_>, value: &Value) {
        match slot.ty {
            Type::Bool { off, on } => match scalar::truth(value, off, on) {
                Some((is_on, form)) if form == Form::Plain || value.is_boolean() => {
                    self.out.push_str(if is_on { on } else { off });
                }
                _ => self.forbidden(slot, value),
            },
            Type::Int => match value.as_i64() {
                #[expect(clippy::cast_precision_loss, reason = "limits are small; rounding moves none across them")]
                Some(int) => self.number(slot, value, int as f64, &int.to_string()),
                None => self.forbidden(slot, value),
            },
            Type::Float => match scalar::float(value) {
                Some((float, Form::Plain)) => self.number(slot, value, float, &text::float(float)),
                _ => self.forbidden(slot, value),
            },
            Type::Text | Type::Python(_) => match value.as_str() {
                Some(text) if slot.limits.allow_text(text) => text::push_string(&mut self.out, text),
                _ => self.forbidden(slot, value),
            },
            Type::Json => self.out.push_str(&value.to_string()),
            Type::List(element) => self.list(slot, element, value, None),
            Type::Array(element, len) => self.list(slot, element, value, Some(*len)),
            Type::Named(name) => self.named(slot, name, value),
        }
    }

    fn named(&mut self, slot: &Slot<'_>, name: &str, value: &Value) {
        let spec = self.spec;
        match spec.type_def(name).map(|def| &def.kind) {
            Some(TypeKind::Object(fields)) => match value.as_object() {
                Some(given) => {
                    self.out.push('{');
                    self.object(slot.place, fields, given, "");
                    self.out.push('}');
                }
                None => self.forbidden(slot, value),
            },
            Some(TypeKind::Array { fields, .. }) => self.array(slot, fields, value),
            Some(TypeKind::IntEnum(values)) => {
                let listed = values.iter().find(|listed| is_value(value, listed.wire, &listed.name));
                self.listed(slot, value, listed, |out, wire| out.push_str(&wire.to_string()));
            }
            Some(TypeKind::TextEnum(values)) => {
                let text = value.as_str().unwrap_or_default();
                let listed = values.iter().find(|listed| listed.wire == text);
                let listed = listed.or_else(|| values.iter().find(|listed| same(&listed.name, text)));
                self.listed(slot, value, listed, |out, wire| text::push_string(out, wire));
            }
            Some(TypeKind::Choice(choice)) => self.array_choice(slot, choice, value),
            Some(TypeKind::Wrapper(ty, unit)) => {
                self.value(&slot.unwrapped(ty, unit.as_deref()), value);
            }
            None => self.out.push_str(&value.to_string()),
        }
    }

    fn number(&mut self, slot: &Slot<'_>, value: &Value, number: f64, text: &str) {
        let advisory = slot.limits.range.advisory;
        if slot.limits.allow(number) || advisory && self.ranges == AdvisoryRanges::Ignored {
            return self.out.push_str(text);
        }
        self.forbidden(slot, value);
        self.mark(advisory);
    }

    fn list(&mut self, slot: &Slot<'_>, ty: &Type, value: &Value, len: Option<usize>) {
        let Some(items) = value.as_array().filter(|items| len.is_none_or(|len| items.len() == len)) else {
            return self.forbidden(slot, value);
        };
        self.out.push('[');
        for (index, item) in items.iter().enumerate() {
            self.comma();
            let place = element(slot.place, index);
            self.value(&slot.inner(&place, ty), item);
        }
        self.out.push(']');
    }

    fn listed<T>(
        &mut self,
        slot: &Slot<'_>,
        value: &Value,
        listed: Option<&EnumValue<T>>,
        write: impl FnOnce(&mut String, &T),
    ) {
        match listed {
            Some(listed) if listed.advisory && self.ranges == AdvisoryRanges::Enforced => {
                self.forbidden(slot, value);
                self.mark(true);
            }
            Some(listed) => write(&mut self.out, &listed.wire),
            None => self.forbidden(slot, value),
        }
    }
}

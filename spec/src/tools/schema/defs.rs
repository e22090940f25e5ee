//! Types.

use std::fmt::Display;

use serde_json::{Map, Value, json};

use super::parts::{Form, alternatives, number, reference, with};
use super::{advice, describe, lenient, scalar};
use crate::{Choice, EnumValue, Field, Spec, Type, TypeDef, TypeId, TypeKind};

/// The definitions made so far.
pub(super) struct Defs<'s> {
    pub(super) spec: &'s Spec,
    defs: Map<String, Value>,
}

impl<'s> Defs<'s> {
    pub(super) fn new(spec: &'s Spec) -> Self {
        Self { spec, defs: lenient::definitions() }
    }

    pub(super) fn finish(self) -> Map<String, Value> {
        self.defs
    }

    /// Adds a definition, and gives the reference to it.
    pub(super) fn add(&mut self, name: &str, schema: Value) -> Value {
        self.defs.insert(name.to_owned(), schema);
        reference(name)
    }

    /// The reference to a named type, which is defined if it is not yet.
    pub(super) fn named(&mut self, id: TypeId, form: Form) -> Value {
        let def = &self.spec[id];
        let key = match form {
            Form::Sent => def.name.clone(),
            Form::Received => format!("lenient.{}", def.name),
        };
        if !self.defs.contains_key(&key) {
            let schema = self.definition(def, form);
            self.add(&key, schema);
        }
        reference(&key)
    }

    fn definition(&mut self, def: &TypeDef, form: Form) -> Value {
        let (schema, more) = match &def.kind {
            TypeKind::Object(fields) => (self.object(fields, form), String::new()),
            TypeKind::Array { fields, exact } => (self.array(None, fields, *exact, form), String::new()),
            TypeKind::Choice(choice) => (self.array_choice(choice, form), String::new()),
            TypeKind::Wrapper(ty, unit) => (self.value(ty, form), describe::unit(unit.as_deref())),
            TypeKind::IntEnum(values) => enumeration(values, form, lenient::integer()),
            TypeKind::TextEnum(values) => enumeration(values, form, json!({ "type": "string" })),
        };
        with(schema, "description", describe::join(&[&def.doc, &more]))
    }

    /// An object with these keys; in a request, with no others.
    pub(super) fn object(&mut self, fields: &[Field], form: Form) -> Value {
        let properties: Map<_, _> =
            fields.iter().map(|field| (field.wire.clone(), self.field(fields, field, form))).collect();
        let required: Vec<_> = fields.iter().filter(|field| !field.optional).map(|field| &field.wire).collect();
        let object = json!({ "type": "object", "properties": properties, "required": required });
        let rules = if form == Form::Sent { advice::rules(self.spec, fields) } else { Vec::new() };
        let object = if rules.is_empty() { object } else { with(object, "allOf", rules) };
        match form {
            Form::Sent => with(object, "additionalProperties", false),
            Form::Received => object,
        }
    }

    /// An array that begins with the tag, if there is one, and these elements.
    fn array(&mut self, tag: Option<Value>, fields: &[Field], exact: bool, form: Form) -> Value {
        let least = tag.iter().count() + fields.iter().filter(|field| !field.optional).count();
        let mut items: Vec<_> = tag.into_iter().collect();
        items.extend(fields.iter().map(|field| self.field(fields, field, form)));
        let array = json!({ "type": "array", "minItems": least });
        // A schema may not have an empty list of them.
        let array = if items.is_empty() { array } else { with(array, "prefixItems", items) };
        if exact || form == Form::Sent { with(array, "items", false) } else { array }
    }

    fn array_choice(&mut self, choice: &Choice, form: Form) -> Value {
        let mut variants = Vec::new();
        for variant in &choice.variants {
            let tag = match form {
                Form::Sent => json!({ "const": variant.wire }),
                Form::Received => lenient::tag(variant.wire),
            };
            let array = self.array(Some(tag), &variant.fields, false, form);
            let array = with(array, "title", variant.name.clone());
            variants.push(with(array, "description", variant.doc.clone()));
        }
        if form == Form::Received {
            variants.push(lenient::other_variant(&choice.variants));
        }
        json!({ "oneOf": variants })
    }

    /// A field's value, with what the field adds to its type.
    pub(super) fn field(&mut self, fields: &[Field], field: &Field, form: Form) -> Value {
        let mut schema = self.value(&field.ty, form);
        if form == Form::Sent {
            limit(&mut schema, field);
        }
        if field.or_raw {
            schema = json!({ "anyOf": [schema, true] });
        } else if field.optional && form == Form::Received {
            schema = json!({ "anyOf": [schema, { "type": "null" }] });
        }
        // Texts call the field by its name.
        if field.name != field.wire {
            schema = with(schema, "title", field.name.clone());
        }
        with(schema, "description", describe::field(self.spec, fields, field))
    }

    fn value(&mut self, ty: &Type, form: Form) -> Value {
        match ty {
            Type::List(element) => json!({ "type": "array", "items": self.value(element, form) }),
            Type::Array(element, len) => {
                json!({ "type": "array", "items": self.value(element, form), "minItems": len, "maxItems": len })
            }
            Type::Named(id) => self.named(*id, form),
            Type::Python(_) => json!({ "type": "string" }),
            Type::Scalar(scalar) => scalar::schema(scalar, form),
        }
    }
}

/// Adds the field's limits to the number or text at the heart of the schema.
fn limit(schema: &mut Value, field: &Field) {
    if schema.get("items").is_some_and(Value::is_object) {
        return limit(&mut schema["items"], field);
    }
    if let Some(min) = field.range.min {
        schema["minimum"] = number(min);
    }
    if let Some(max) = field.range.max {
        schema["maximum"] = number(max);
    }
    if field.ascii {
        schema["pattern"] = json!("^[ -~]*$");
    }
}

/// The schema of an enum, and what its description adds.
fn enumeration<T: Display + Clone + Into<Value>>(values: &[EnumValue<T>], form: Form, any: Value) -> (Value, String) {
    let listed = values.iter().filter(|value| !value.advisory);
    let constants: Vec<_> = listed
        .map(|value| json!({ "const": value.wire.clone().into(), "title": value.name, "description": value.doc }))
        .collect();
    match form {
        Form::Sent => (alternatives("oneOf", &constants), describe::newer_values(values)),
        Form::Received => (any, describe::known_values(values)),
    }
}

//! Types.

use std::fmt::Display;

use serde_json::{Map, Value, json};

use super::{Direction, alternatives, describe, lenient, number, reference, with};
use crate::{Advice, Choice, EnumValue, Field, Shape, Spec, Type, TypeDef, TypeId, TypeKind};

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
    pub(super) fn named(&mut self, id: TypeId, direction: Direction) -> Value {
        let def = &self.spec[id];
        let key = match direction {
            Direction::Sent => def.name.clone(),
            Direction::Received => format!("lenient.{}", def.name),
        };
        if !self.defs.contains_key(&key) {
            let schema = self.definition(def, direction);
            self.add(&key, schema);
        }
        reference(&key)
    }

    fn definition(&mut self, def: &TypeDef, direction: Direction) -> Value {
        let (schema, more) = match &def.kind {
            TypeKind::Object(fields) => (self.object(fields, direction), String::new()),
            TypeKind::Array { fields, exact } => (self.array(None, fields, *exact, direction), String::new()),
            TypeKind::Choice(choice) => (self.array_choice(choice, direction), String::new()),
            TypeKind::Wrapper(ty, unit) => (self.value(ty, direction), describe::unit(unit.as_deref())),
            TypeKind::IntEnum(values) => enumeration(values, direction, lenient::integer()),
            TypeKind::TextEnum(values) => enumeration(values, direction, json!({ "type": "string" })),
        };
        with(schema, "description", describe::join(&[&def.doc, &more]))
    }

    /// An object with these keys; in a request, with no others.
    pub(super) fn object(&mut self, fields: &[Field], direction: Direction) -> Value {
        let properties: Map<_, _> =
            fields.iter().map(|field| (field.wire.clone(), self.field(fields, field, direction))).collect();
        let required: Vec<_> = fields.iter().filter(|field| !field.optional).map(|field| &field.wire).collect();
        let object = json!({ "type": "object", "properties": properties, "required": required });
        match direction {
            Direction::Sent => with(advised(self.spec, fields, object), "additionalProperties", false),
            Direction::Received => object,
        }
    }

    /// An array that begins with the tag, if there is one, and these elements.
    fn array(&mut self, tag: Option<Value>, fields: &[Field], exact: bool, direction: Direction) -> Value {
        let least = tag.iter().count() + fields.iter().filter(|field| !field.optional).count();
        let mut items: Vec<_> = tag.into_iter().collect();
        items.extend(fields.iter().map(|field| self.field(fields, field, direction)));
        let array = json!({ "type": "array", "minItems": least });
        // A schema may not have an empty list of them.
        let array = if items.is_empty() { array } else { with(array, "prefixItems", items) };
        if exact || direction == Direction::Sent { with(array, "items", false) } else { array }
    }

    fn array_choice(&mut self, choice: &Choice, direction: Direction) -> Value {
        let mut variants = Vec::new();
        for variant in &choice.variants {
            let tag = match direction {
                Direction::Sent => json!({ "const": variant.wire }),
                Direction::Received => lenient::tag(variant.wire),
            };
            let array = self.array(Some(tag), &variant.fields, false, direction);
            let array = with(array, "title", variant.name.clone());
            variants.push(with(array, "description", variant.doc.clone()));
        }
        if direction == Direction::Received {
            variants.push(lenient::other_variant(&choice.variants));
        }
        json!({ "oneOf": variants })
    }

    /// A field's value, with what the field adds to its type.
    pub(super) fn field(&mut self, fields: &[Field], field: &Field, direction: Direction) -> Value {
        let mut schema = self.value(&field.ty, direction);
        if direction == Direction::Sent {
            limit(&mut schema, field);
        }
        if field.or_raw {
            schema = json!({ "anyOf": [schema, true] });
        } else if field.optional && direction == Direction::Received {
            schema = json!({ "anyOf": [schema, { "type": "null" }] });
        }
        // Texts call the field by its name.
        if field.name != field.wire {
            schema = with(schema, "title", field.name.clone());
        }
        with(schema, "description", describe::field(self.spec, fields, field))
    }

    fn value(&mut self, ty: &Type, direction: Direction) -> Value {
        match ty {
            Type::List(element) => json!({ "type": "array", "items": self.value(element, direction) }),
            Type::Array(element, len) => {
                json!({ "type": "array", "items": self.value(element, direction), "minItems": len, "maxItems": len })
            }
            Type::Named(id) => self.named(*id, direction),
            Type::Python(_) => json!({ "type": "string" }),
            Type::Scalar(scalar) => lenient::scalar(scalar, direction),
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

/// The schema of an enum, and its additions to a description.
fn enumeration<T: Display + Clone + Into<Value>>(
    values: &[EnumValue<T>],
    direction: Direction,
    any: Value,
) -> (Value, String) {
    let listed = values.iter().filter(|value| !value.advisory);
    let constants: Vec<_> = listed
        .map(|value| json!({ "const": value.wire.clone().into(), "title": value.name, "description": value.doc }))
        .collect();
    match direction {
        Direction::Sent => (alternatives("oneOf", &constants), describe::newer_values(values)),
        Direction::Received => (any, describe::known_values(values)),
    }
}

/// Adds what is advised of the fields of an object. What always holds stands in the schema of the field, beside its
/// type. What depends on another field stands in `dependentSchemas`: programs that make types of a schema take `allOf`
/// for parts of a type.
///
/// A bound that grows with a count is exact where the count is left out; otherwise it is that of the greatest count.
fn advised(spec: &Spec, fields: &[Field], mut object: Value) -> Value {
    for field in fields {
        let rows = field.advised.iter().flat_map(|advice| advised_row(spec, fields, field, advice));
        let (conditional, always): (Vec<_>, Vec<_>) = rows.partition(|rule| rule.get("if").is_some());
        for rule in always {
            narrow(&mut object["properties"], &rule["properties"]);
        }
        if !conditional.is_empty() {
            object["dependentSchemas"][&field.wire] = json!({ "allOf": conditional });
        }
    }
    object
}

/// Adds the keywords of a bound to a schema, and takes the narrower of two ranges.
fn narrow(schema: &mut Value, bound: &Value) {
    for (keyword, value) in bound.as_object().into_iter().flatten() {
        let own = &mut schema[keyword];
        match (own.as_f64(), value.as_f64()) {
            (Some(least), Some(min)) if keyword == "minimum" && least >= min => {}
            (Some(most), Some(max)) if keyword == "maximum" && most <= max => {}
            _ if own.is_object() => narrow(own, value),
            _ => *own = value.clone(),
        }
    }
}

fn advised_row(spec: &Spec, fields: &[Field], field: &Field, advice: &Advice) -> Vec<Value> {
    let sibling = |name: &String| fields.iter().find(|other| other.name == *name);
    let rule = |times: f64, mut conditions: Vec<Value>| {
        if let Some((when, selector)) = advice.when.as_ref().and_then(|when| Some((when, sibling(&when.field)?))) {
            conditions.push(json!({ "properties": { (&selector.wire): { "const": when.value } } }));
        }
        let bound = bound(spec, &field.ty, field.unit.as_deref(), (advice, advice.max * times));
        let rule = json!({ "properties": { (&field.wire): bound } });
        if conditions.is_empty() { rule } else { json!({ "if": { "allOf": conditions }, "then": rule }) }
    };
    let Some(count) = advice.per.as_ref().and_then(sibling) else { return vec![rule(1.0, Vec::new())] };
    let given = json!({ "required": [count.wire] });
    let greatest = count.advised.iter().map(|advice| advice.max).chain(count.range.max).reduce(f64::min);
    let left_out = count.optional.then(|| rule(1.0, vec![json!({ "not": given })]));
    left_out.into_iter().chain(greatest.map(|greatest| rule(greatest, vec![given.clone()]))).collect()
}

/// A value of the type whose numbers of the row's unit are within its bound.
fn bound(spec: &Spec, ty: &Type, unit: Option<&str>, (advice, max): (&Advice, f64)) -> Value {
    let inner = |field: &Field| bound(spec, &field.ty, field.unit.as_deref(), (advice, max));
    let unit = spec.unit(ty).or(unit);
    match spec.shape(ty) {
        Shape::Scalar(scalar) if scalar.is_number() && (advice.unit.is_none() || unit == advice.unit.as_deref()) => {
            let bound = json!({ "minimum": number(-max), "maximum": number(max) });
            if advice.nonzero { with(bound, "not", json!({ "const": 0 })) } else { bound }
        }
        Shape::List(element, _) => json!({ "items": bound(spec, element, unit, (advice, max)) }),
        Shape::Tuple { fields, .. } => json!({ "prefixItems": fields.iter().map(inner).collect::<Vec<_>>() }),
        Shape::Object(fields) => {
            let properties: Map<_, _> = fields.iter().map(|field| (field.wire.clone(), inner(field))).collect();
            json!({ "properties": properties })
        }
        _ => json!(true),
    }
}

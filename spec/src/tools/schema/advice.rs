//! What is advised of numbers in a request.

use serde_json::{Map, Value, json};

use super::parts::{number, with};
use crate::{Advice, Field, Shape, Spec, Type};

/// A schema of the whole object for each row that is advised of one of its fields.
///
/// A bound that grows with a count is exact where the count is left out; otherwise it is that of the greatest count.
pub(super) fn rules(spec: &Spec, fields: &[Field]) -> Vec<Value> {
    let rows = fields.iter().flat_map(|field| field.advised.iter().map(move |advice| (field, advice)));
    rows.flat_map(|(field, advice)| of_row(spec, fields, field, advice)).collect()
}

fn of_row(spec: &Spec, fields: &[Field], field: &Field, advice: &Advice) -> Vec<Value> {
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

//! Random messages made from a spec, as the wire has them.

use jaka_spec::{Command, Field, Request, Scalar, Shape, Spec, Type};
use proptest::prelude::*;
use serde_json::{Map, Value};

/// Random requests, for each command of the spec.
pub fn any_request(spec: &'static Spec) -> BoxedStrategy<Value> {
    let commands: Vec<_> = spec.commands().collect();
    proptest::sample::select(commands).prop_flat_map(move |command| any_request_of(spec, command)).boxed()
}

/// Random requests for one command.
pub fn any_request_of(spec: &'static Spec, command: &'static Command) -> BoxedStrategy<Value> {
    let body = match &command.request {
        Request::Fields(fields) => any_object(spec, fields),
        Request::Choice(choice) => {
            let variants = choice.variants.iter().map(move |variant| {
                let (tag, value) = (choice.tag.clone(), variant.wire);
                let with_tag = move |mut object: Map<String, Value>| {
                    object.insert(tag.clone(), value.into());
                    object
                };
                any_object(spec, &variant.fields).prop_map(with_tag).boxed()
            });
            proptest::strategy::Union::new(variants).boxed()
        }
    };
    let with_name = move |mut object: Map<String, Value>| {
        object.insert("cmdName".to_owned(), command.wire.clone().into());
        Value::Object(object)
    };
    body.prop_map(with_name).boxed()
}

/// Random objects with these fields.
pub fn any_object(spec: &'static Spec, fields: &'static [Field]) -> BoxedStrategy<Map<String, Value>> {
    let fields: Vec<_> = fields.iter().map(|field| any_field(spec, field)).collect();
    fields.prop_map(|fields| fields.into_iter().flatten().collect()).boxed()
}

fn any_field(spec: &'static Spec, field: &'static Field) -> BoxedStrategy<Option<(String, Value)>> {
    let value = any_value(spec, &field.ty).prop_map(|value| (field.wire.clone(), value));
    if field.optional { proptest::option::of(value).boxed() } else { value.prop_map(Some).boxed() }
}

/// Random values of a type, in the form in which the wire has them.
///
/// # Panics
/// The spec holds what is not JSON.
fn any_value(spec: &'static Spec, ty: &'static Type) -> BoxedStrategy<Value> {
    match spec.shape(ty) {
        Shape::Scalar(scalar) => any_scalar(scalar),
        Shape::List(element, len) => {
            let lens = len.map_or(0..=3, |len| len..=len);
            proptest::collection::vec(any_value(spec, element), lens).prop_map(Value::from).boxed()
        }
        Shape::Python(inner) => any_value(spec, inner)
            .prop_map(|value| jaka_proto::python::from_json(&value.to_string()).expect("a value is JSON").into())
            .boxed(),
        Shape::Object(fields) => any_object(spec, fields).prop_map(Value::Object).boxed(),
        Shape::Tuple { fields, .. } => any_elements(spec, fields),
        Shape::IntEnum(values) => {
            let listed: Vec<_> = values.iter().map(|value| value.wire).collect();
            prop_oneof![3 => proptest::sample::select(listed), 1 => any::<i64>()].prop_map(Value::from).boxed()
        }
        Shape::TextEnum(values) => {
            let listed: Vec<_> = values.iter().map(|value| value.wire.clone()).collect();
            prop_oneof![3 => proptest::sample::select(listed), 1 => any_text()].prop_map(Value::from).boxed()
        }
        Shape::Choice(choice) => {
            let variants = choice.variants.iter().map(move |variant| {
                let tag = Value::from(variant.wire);
                let with_tag = move |elements: Value| match elements {
                    Value::Array(rest) => std::iter::once(tag.clone()).chain(rest).collect(),
                    other => other,
                };
                any_elements(spec, &variant.fields).prop_map(with_tag).boxed()
            });
            proptest::strategy::Union::new(variants).boxed()
        }
    }
}

fn any_scalar(scalar: &Scalar) -> BoxedStrategy<Value> {
    match scalar {
        Scalar::Bool { off, on } => {
            let form = |json: &str| serde_json::from_str::<Value>(json).expect("the spec holds JSON");
            proptest::sample::select(vec![form(off), form(on)]).boxed()
        }
        Scalar::Int => any::<i64>().prop_map(Value::from).boxed(),
        Scalar::Float => any_float().prop_map(Value::from).boxed(),
        Scalar::Text => any_text().prop_map(Value::from).boxed(),
        Scalar::Json => prop_oneof![any::<i64>().prop_map(Value::from), any_text().prop_map(Value::from)].boxed(),
    }
}

/// An array of these elements; the optional ones at the end may be left out from some place on.
fn any_elements(spec: &'static Spec, fields: &'static [Field]) -> BoxedStrategy<Value> {
    let required = fields.iter().filter(|field| !field.optional).count();
    let elements: Vec<_> = fields.iter().map(|field| any_value(spec, &field.ty)).collect();
    (elements, required..=fields.len())
        .prop_map(|(mut elements, len)| {
            elements.truncate(len);
            Value::Array(elements)
        })
        .boxed()
}

fn any_float() -> impl Strategy<Value = f64> {
    let finite = any::<f64>().prop_filter("JSON has finite numbers only", |float| float.is_finite());
    prop_oneof![finite, (-1000i32..1000).prop_map(f64::from), -720.0..720.0]
}

fn any_text() -> impl Strategy<Value = String> {
    proptest::string::string_regex("[a-zA-Z0-9 {}\\[\\]\"'\\\\/_.,:é中\n]{0,12}").expect("the pattern is correct")
}

//! Replies for a simulated controller.

use serde_json::{Map, Value};

use super::scalar;
use super::tree::{Node, is_success};
use jaka_spec::{Command, ENVELOPE, EnumValue, Field, Shape, Spec, Type, Variant};

/// Returns the fields of a successful reply, without the three keys that every reply has.
///
/// They are those of the first successful reply in the spec's examples, completed by [`complete_reply`].
pub fn sample_reply(spec: &Spec, command: &Command) -> Map<String, Value> {
    let replies = command.examples.iter().filter_map(|example| example.reply.as_deref());
    let mut objects = replies.filter_map(|reply| serde_json::from_str::<Map<_, _>>(reply).ok());
    let mut reply = objects.find(is_success).unwrap_or_default();
    reply.retain(|key, _| !ENVELOPE.contains(&key.as_str()));
    complete_reply(spec, command, &mut reply);
    reply
}

/// Removes the fields of a reply that cannot be read, and adds the required ones that are missing.
///
/// The added values are false, 0 (or the number nearest to it in range), empty text, the first value of an enum, an
/// empty array, an array of the fixed length, or an object of such values.
pub fn complete_reply(spec: &Spec, command: &Command, reply: &mut Map<String, Value>) {
    for field in spec.reply_fields(command) {
        if reply.get(&field.wire).is_some_and(|value| !Node::field(spec, field, value.clone()).is_readable()) {
            reply.remove(&field.wire);
        }
    }
    complete(spec, spec.reply_fields(command), reply);
}

fn complete(spec: &Spec, fields: &[Field], object: &mut Map<String, Value>) {
    for field in fields.iter().filter(|field| !field.optional) {
        object.entry(field.wire.clone()).or_insert_with(|| sample_value(spec, field));
    }
}

/// Returns a value for a field, of the kind that [`complete_reply`] adds.
pub fn sample_value(spec: &Spec, field: &Field) -> Value {
    let (min, max) = (field.range.min.unwrap_or(f64::MIN), field.range.max.unwrap_or(f64::MAX));
    let nearest = 0_f64.max(min).min(max);
    if nearest != 0.0 && matches!(&field.ty, Type::Scalar(scalar) if scalar.is_number()) {
        // Rust prints a whole number without a fraction.
        return serde_json::from_str(&nearest.to_string()).unwrap_or_default();
    }
    of_type(spec, &field.ty)
}

fn of_type(spec: &Spec, ty: &Type) -> Value {
    match spec.shape(ty) {
        Shape::Scalar(scalar) => scalar::zero(scalar),
        Shape::List(element, len) => vec![of_type(spec, element); len.unwrap_or_default()].into(),
        Shape::Python(inner) => literal(&of_type(spec, inner)),
        Shape::Object(fields) => {
            let mut object = Map::new();
            complete(spec, fields, &mut object);
            object.into()
        }
        Shape::Tuple { fields, .. } => elements(spec, fields).collect(),
        Shape::IntEnum(values) => first(values, |value| value.wire.into()),
        Shape::TextEnum(values) => first(values, |value| value.wire.clone().into()),
        Shape::Choice(choice) => {
            let tagged = |variant: &Variant| {
                std::iter::once(variant.wire.into()).chain(elements(spec, &variant.fields)).collect()
            };
            choice.variants.first().map(tagged).unwrap_or_default()
        }
    }
}

/// Returns the value as a Python literal in a string.
fn literal(value: &Value) -> Value {
    jaka_proto::python::from_json(&value.to_string()).unwrap_or_default().into()
}

fn elements(spec: &Spec, fields: &[Field]) -> impl Iterator<Item = Value> {
    fields.iter().filter(|field| !field.optional).map(|field| sample_value(spec, field))
}

fn first<T>(values: &[EnumValue<T>], wire: impl Fn(&EnumValue<T>) -> Value) -> Value {
    values.first().map(wire).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::sample_reply;
    use jaka_spec::{Source, load_pack};

    /// Checks the sample value of a reply's field, given its type and other properties.
    fn check(field: &str, expected: &serde_json::Value) {
        let text = format!(
            "title = 'T'\n[[command]]\nwire = 'c'\neffect = 'query'\ndoc = 'D.'\n[[command.reply]]\nwire = 'f'\ndoc = 'D.'\n{field}"
        );
        let base = jaka_spec::builtin().expect("the spec is correct");
        let pack = load_pack(&base, Source { path: "t.toml", text: &text }).expect("the pack is correct");
        let reply = sample_reply(&pack.spec, pack.spec.command("c").expect("it is added"));
        assert_eq!(reply["f"].to_string(), expected.to_string(), "{field}");
    }

    #[test]
    fn values_are_zero_or_what_is_nearest_in_range() {
        check("type = 'bool'\nwritten = [0, 1]", &json!(0));
        check("type = 'int'", &json!(0));
        check("type = 'int'\nmin = 2", &json!(2));
        check("type = 'float'\nmax = -0.5", &json!(-0.5));
        check("type = 'float[2]'", &json!([0, 0]));
    }
}

//! Arguments of a command on a command line.

use serde_json::Value;

use super::names::{kebab, same};
use super::scalar;
use super::value::value;
use jaka_spec::words::{self, first_sentence};
use jaka_spec::{Choice, Command, EnumValue, Field, Request, Scalar, Shape, Spec, Type, Variant};

/// Argument of a command: a field of its request, or the tag that selects the fields.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Argument {
    /// Name in kebab-case, such as `joint-position`; no other argument of the command has it.
    pub name: String,
    /// Key on the wire, such as `jointPosition`, which may serve as an alias.
    pub wire: String,
    /// Key under which [`request`](super::request) takes its value: the field's Rust name, or the tag's key.
    pub field: String,
    /// Placeholder for the value, such as `NUMBER`, `on|off` or `[X,Y,Z,RX,RY,RZ]`.
    pub hint: String,
    /// Meaning of the value, its unit and range, and the points on which sources disagree.
    pub help: String,
    /// Whether it is required; with a tag, in the variants that have it.
    pub required: bool,
    /// Values of an enum or a tag; empty for any other type.
    pub values: Vec<PossibleValue>,
    /// Variants that have the field, by their names in kebab-case; empty if all requests have it.
    pub variants: Vec<String>,
    ty: Type,
}

/// Possible value of an argument.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct PossibleValue {
    /// Name in kebab-case.
    pub name: String,
    /// Form on the wire, such as `0`.
    pub wire: Value,
    /// Meaning of the value, in one sentence.
    pub help: String,
}

impl Argument {
    /// Reads the text typed for the argument, as [`value`] does.
    ///
    /// # Errors
    /// The text is not a value of the argument's type; the message describes the type.
    pub fn value(&self, spec: &Spec, text: &str) -> Result<Value, String> {
        let is_value = |listed: &&PossibleValue| same(&listed.name, text) || listed.wire == text;
        match self.values.iter().find(is_value) {
            Some(listed) => Ok(listed.wire.clone()),
            None => value(spec, &self.ty, text).map_err(|error| match self.values.len() {
                0 => error,
                _ => format!("`{text}` is not {}", self.hint),
            }),
        }
    }
}

/// Returns the arguments of a command, in the order of the spec; the tag of a choice comes first.
///
/// Fields of several variants with the same name and type are one argument.
pub fn arguments(spec: &Spec, command: &Command) -> Vec<Argument> {
    match &command.request {
        Request::Fields(fields) => fields.iter().map(|field| argument(spec, fields, field)).collect(),
        Request::Choice(choice) => choice_arguments(spec, choice),
    }
}

fn choice_arguments(spec: &Spec, choice: &Choice) -> Vec<Argument> {
    let mut arguments = vec![tag(choice)];
    for variant in &choice.variants {
        let variant_name = kebab(&variant.name);
        for field in &variant.fields {
            let mut new = argument(spec, &variant.fields, field);
            new.variants.push(variant_name.clone());
            match arguments.iter_mut().find(|old| old.name == new.name) {
                Some(old) if old.wire == new.wire && old.ty == new.ty => merge(old, new),
                Some(_) => {
                    new.name = format!("{variant_name}-{}", new.name);
                    arguments.push(new);
                }
                None => arguments.push(new),
            }
        }
    }
    arguments
}

/// Adds a variant to an argument. Adds its text about the field unless another variant has the same.
fn merge(old: &mut Argument, new: Argument) {
    if !old.help.contains(&new.help) {
        old.help = format!("{} With `{}`: {}", old.help, new.variants.join("`, `"), new.help);
    }
    old.variants.extend(new.variants);
    old.required &= new.required;
}

fn tag(choice: &Choice) -> Argument {
    let listed = |variant: &Variant| possible(&variant.name, variant.wire.into(), &variant.doc);
    let values: Vec<_> = choice.variants.iter().map(listed).collect();
    Argument {
        name: kebab(&choice.tag),
        wire: choice.tag.clone(),
        field: choice.tag.clone(),
        hint: alternatives(&values),
        help: "What is asked for, and so which further arguments there are.".to_owned(),
        required: true,
        values,
        variants: Vec::new(),
        ty: Type::Scalar(Scalar::Int),
    }
}

fn argument(spec: &Spec, fields: &[Field], field: &Field) -> Argument {
    Argument {
        name: kebab(&field.name),
        wire: field.wire.clone(),
        field: field.name.clone(),
        hint: hint(spec, &field.ty),
        help: help(spec, fields, field),
        required: !field.optional,
        values: values(spec, &field.ty),
        variants: Vec::new(),
        ty: field.ty.clone(),
    }
}

fn values(spec: &Spec, ty: &Type) -> Vec<PossibleValue> {
    match spec.shape(ty) {
        Shape::IntEnum(values) => listed(values, |wire| (*wire).into()),
        Shape::TextEnum(values) => listed(values, |wire| wire.as_str().into()),
        _ => Vec::new(),
    }
}

fn listed<T>(values: &[EnumValue<T>], wire: impl Fn(&T) -> Value) -> Vec<PossibleValue> {
    let one = |value: &EnumValue<T>| {
        let mut one = possible(&value.name, wire(&value.wire), &value.doc);
        if value.advisory {
            one.help += " Taken by newer firmware only.";
        }
        if let Some(versions) = words::versions(&value.versions) {
            one.help = format!("{} Known to firmware {versions}.", one.help);
        }
        one
    };
    values.iter().map(one).collect()
}

fn possible(name: &str, wire: Value, doc: &str) -> PossibleValue {
    PossibleValue { name: kebab(name), wire, help: first_sentence(doc).0.to_owned() }
}

fn alternatives(values: &[PossibleValue]) -> String {
    values.iter().map(|value| value.name.as_str()).collect::<Vec<_>>().join("|")
}

fn hint(spec: &Spec, ty: &Type) -> String {
    match spec.shape(ty) {
        Shape::Scalar(scalar) => scalar::hint(scalar).to_owned(),
        Shape::Python(_) => "TEXT".to_owned(),
        Shape::Object(_) | Shape::Choice(_) => "JSON".to_owned(),
        Shape::List(element, None) => format!("[{},…]", hint(spec, element)),
        Shape::List(element, Some(len)) => format!("[{}; {len}]", hint(spec, element)),
        Shape::Tuple { fields, .. } => {
            let names: Vec<_> = fields.iter().map(|field| field.name.to_uppercase()).collect();
            format!("[{}]", names.join(","))
        }
        Shape::IntEnum(_) | Shape::TextEnum(_) => alternatives(&values(spec, ty)),
    }
}

fn help(spec: &Spec, fields: &[Field], field: &Field) -> String {
    let advised = words::advised(spec, fields, field, |other| kebab(&other.name));
    let readings = (!field.disputed.is_empty()).then(|| field.disputed.join("; "));
    let parts = [
        Some(first_sentence(&field.doc).0.to_owned()),
        field.unit.as_deref().or_else(|| spec.unit(&field.ty)).map(|unit| format!("In {unit}.")),
        words::range(field.range).map(|range| format!("Allowed: {range}.")),
        advised.map(|advised| format!("Advised: {advised}.")),
        field.ascii.then(|| "Printable ASCII only.".to_owned()),
        readings.map(|readings| format!("Sources disagree: {readings}.")),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

//! Prints a program with all commands of the spec as structs with serde's derives, as one would write them by hand.
//!
//! For `benches/build-time` alone. It asks less of these types than of ours: no lenient forms, no checks, no docs.

use jaka_spec::{Choice, Field, Request, Scalar, Spec, Type, TypeDef, TypeKind};

const DERIVE: &str = "#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]";

const HEAD: &str = "use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for line in std::io::stdin().lines() {
        let line = line?;
        let request: Request = serde_json::from_str(&line)?;
        println!(\"{} {}\", serde_json::to_string(&request)?, reply(&request, &line)?);
    }
    Ok(())
}

fn again<T: Serialize + DeserializeOwned>(json: &str) -> serde_json::Result<String> {
    serde_json::to_string(&serde_json::from_str::<T>(json)?)
}
";

fn main() -> Result<(), jaka_spec::Errors> {
    let spec = jaka_spec::builtin()?;
    println!("{HEAD}");
    let (mut variants, mut replies) = (Vec::new(), Vec::new());
    for command in spec.commands() {
        let request = command.request_type();
        match &command.request {
            Request::Fields(fields) => object(&spec, &request, fields),
            Request::Choice(choice) => tagged(&spec, &request, choice),
        }
        let reply = command.reply_type();
        if let Some(reply) = &reply {
            object(&spec, reply, spec.reply_fields(command));
        }
        let reply = reply.unwrap_or_else(|| "Value".to_owned());
        variants.push(format!("#[serde(rename = {:?})] {request}({request})", command.wire));
        replies.push(format!("Request::{request}(_) => again::<{reply}>(json)"));
    }
    spec.types().for_each(|(_, def)| named(&spec, def));
    println!("{DERIVE}\n#[serde(tag = \"cmdName\")]\nenum Request {{ {} }}", variants.join(", "));
    println!("fn reply(request: &Request, json: &str) -> serde_json::Result<String> {{");
    println!("    match request {{ {} }}\n}}", replies.join(", "));
    Ok(())
}

fn named(spec: &Spec, def: &TypeDef) {
    let name = &def.name;
    match &def.kind {
        TypeKind::Object(fields) => object(spec, name, fields),
        TypeKind::Array { fields, .. } => println!("{DERIVE}\nstruct {name}({});", elements(spec, fields)),
        TypeKind::Wrapper(ty, _) => println!("{DERIVE}\nstruct {name}({});", rust(spec, ty)),
        TypeKind::Choice(choice) => {
            let variant = |(name, fields): (&str, &[Field])| format!("{name}(i64, {})", elements(spec, fields));
            let variants = choice.variants.iter().map(|v| variant((&v.name, &v.fields)));
            println!("{DERIVE}\n#[serde(untagged)]\nenum {name} {{ {} }}", joined(variants));
        }
        TypeKind::IntEnum(values) => {
            let names = joined(values.iter().map(|value| value.name.clone()));
            let read = joined(values.iter().map(|v| format!("{} => Self::{}", v.wire, v.name)));
            let write = joined(values.iter().map(|v| format!("{name}::{} => {}", v.name, v.wire)));
            println!("{DERIVE}\n#[serde(from = \"i64\", into = \"i64\")]\nenum {name} {{ {names}, Other(i64) }}");
            println!("impl From<i64> for {name} {{ fn from(value: i64) -> Self {{");
            println!("    match value {{ {read}, other => Self::Other(other) }}\n}} }}");
            println!("impl From<{name}> for i64 {{ fn from(value: {name}) -> Self {{");
            println!("    match value {{ {write}, {name}::Other(other) => other }}\n}} }}");
        }
        TypeKind::TextEnum(values) => {
            let names = joined(values.iter().map(|v| format!("#[serde(rename = {:?})] {}", v.wire, v.name)));
            println!("{DERIVE}\nenum {name} {{ {names}, #[serde(untagged)] Other(String) }}");
        }
    }
}

fn object(spec: &Spec, name: &str, fields: &[Field]) {
    println!("{DERIVE}\nstruct {name} {{ {} }}", members(spec, fields));
}

/// A request with variants: serde's derives know no tags that are numbers.
fn tagged(spec: &Spec, name: &str, choice: &Choice) {
    let tag = format!("#[serde(rename = {:?})] tag: i64", choice.tag);
    let variants = choice.variants.iter().map(|v| format!("{} {{ {tag}, {} }}", v.name, members(spec, &v.fields)));
    println!("{DERIVE}\n#[serde(untagged)]\nenum {name} {{ {} }}", joined(variants));
}

fn members(spec: &Spec, fields: &[Field]) -> String {
    joined(fields.iter().map(|field| {
        let skip = if field.optional { "#[serde(skip_serializing_if = \"Option::is_none\")] " } else { "" };
        format!("#[serde(rename = {:?})] {skip}{}: {}", field.wire, field.name, field_type(spec, field))
    }))
}

fn elements(spec: &Spec, fields: &[Field]) -> String {
    joined(fields.iter().map(|field| field_type(spec, field)))
}

fn field_type(spec: &Spec, field: &Field) -> String {
    let ty = rust(spec, &field.ty);
    if field.optional { format!("Option<{ty}>") } else { ty }
}

fn rust(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Scalar(Scalar::Bool { off, .. }) if off == "false" => "bool".to_owned(),
        Type::Scalar(Scalar::Bool { off, .. }) if off.starts_with('"') => "String".to_owned(),
        Type::Scalar(Scalar::Bool { .. } | Scalar::Int) => "i64".to_owned(),
        Type::Scalar(Scalar::Float) => "f64".to_owned(),
        Type::Scalar(Scalar::Text) | Type::Python(_) => "String".to_owned(),
        Type::Scalar(Scalar::Json) => "Value".to_owned(),
        Type::List(element) => format!("Vec<{}>", rust(spec, element)),
        Type::Array(element, len) => format!("[{}; {len}]", rust(spec, element)),
        Type::Named(id) => spec[*id].name.clone(),
    }
}

fn joined(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}

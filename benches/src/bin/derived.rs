//! Prints a program with all commands of the spec as structs with serde's derives, as one would write them by hand.
//!
//! For `benches/build-time` alone. It asks less of these types than of ours: no lenient forms, no checks, no docs.

use jaka_spec::{Choice, Field, Request, Type, TypeDef, TypeKind};

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
            Request::Fields(fields) => object(&request, fields),
            Request::Choice(choice) => tagged(&request, choice),
        }
        let reply = command.reply_type();
        if let Some(reply) = &reply {
            object(reply, &command.reply);
        }
        let reply = reply.unwrap_or_else(|| "Value".to_owned());
        variants.push(format!("#[serde(rename = {:?})] {request}({request})", command.wire));
        replies.push(format!("Request::{request}(_) => again::<{reply}>(json)"));
    }
    spec.types().for_each(named);
    println!("{DERIVE}\n#[serde(tag = \"cmdName\")]\nenum Request {{ {} }}", variants.join(", "));
    println!("fn reply(request: &Request, json: &str) -> serde_json::Result<String> {{");
    println!("    match request {{ {} }}\n}}", replies.join(", "));
    Ok(())
}

fn named(def: &TypeDef) {
    let name = &def.name;
    match &def.kind {
        TypeKind::Object(fields) => object(name, fields),
        TypeKind::Array { fields, .. } => println!("{DERIVE}\nstruct {name}({});", elements(fields)),
        TypeKind::Wrapper(ty, _) => println!("{DERIVE}\nstruct {name}({});", rust(ty)),
        TypeKind::Choice(choice) => {
            let variant = |(name, fields): (&str, &[Field])| format!("{name}(i64, {})", elements(fields));
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

fn object(name: &str, fields: &[Field]) {
    println!("{DERIVE}\nstruct {name} {{ {} }}", members(fields));
}

/// A request with variants: serde's derives know no tags that are numbers.
fn tagged(name: &str, choice: &Choice) {
    let tag = format!("#[serde(rename = {:?})] tag: i64", choice.tag);
    let variants = choice.variants.iter().map(|v| format!("{} {{ {tag}, {} }}", v.name, members(&v.fields)));
    println!("{DERIVE}\n#[serde(untagged)]\nenum {name} {{ {} }}", joined(variants));
}

fn members(fields: &[Field]) -> String {
    joined(fields.iter().map(|field| {
        let skip = if field.optional { "#[serde(skip_serializing_if = \"Option::is_none\")] " } else { "" };
        format!("#[serde(rename = {:?})] {skip}{}: {}", field.wire, field.name, field_type(field))
    }))
}

fn elements(fields: &[Field]) -> String {
    joined(fields.iter().map(field_type))
}

fn field_type(field: &Field) -> String {
    let ty = rust(&field.ty);
    if field.optional { format!("Option<{ty}>") } else { ty }
}

fn rust(ty: &Type) -> String {
    match ty {
        Type::Bool { off, .. } if off == "false" => "bool".to_owned(),
        Type::Bool { off, .. } if off.starts_with('"') => "String".to_owned(),
        Type::Bool { .. } | Type::Int => "i64".to_owned(),
        Type::Float => "f64".to_owned(),
        Type::Text | Type::Python(_) => "String".to_owned(),
        Type::Json => "Value".to_owned(),
        Type::List(element) => format!("Vec<{}>", rust(element)),
        Type::Array(element, len) => format!("[{}; {len}]", rust(element)),
        Type::Named(name) => name.clone(),
    }
}

fn joined(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}

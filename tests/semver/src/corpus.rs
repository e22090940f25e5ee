//! Programs of users: every item of a spec's Rust interface, used in each way in which a program can use it.
//!
//! The programs follow from the documentation of the generated code and from the model, and use nothing of
//! `jaka_spec::tools::diff`.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use jaka_spec::{
    Command, EnumValue, Field, Reply, Request, Scalar, Spec, Type, TypeDef, TypeId, TypeKind, Variant, is_floats,
    is_snake, to_screaming, to_snake,
};

/// Helper functions of each program.
const HEAD: &str = "\
//! A program of a user.

use jaka_proto::messages as m;

fn any<T>() -> T {
    loop {}
}
fn common<T: std::fmt::Debug + Clone + PartialEq + Send + Sync + serde::Serialize + for<'a> serde::Deserialize<'a>>() {}
fn copy<T: Copy>() {}
fn default<T: Default>() {}
fn hash<T: Eq + std::hash::Hash + std::fmt::Display>() {}
fn motion<T: jaka_proto::Motion>() {}
fn command<T: jaka_proto::Command<Reply = R>, R>() {}
";

/// The whole program.
pub(crate) fn program(spec: &Spec) -> String {
    let mut corpus = Corpus { spec, sent: spec.sent_types(), code: HEAD.to_owned(), functions: 0 };
    for topic in &spec.topics {
        for command in &topic.commands {
            corpus.command(&format!("m::{}", topic.name), command);
        }
        for (id, def) in spec.types_of(topic) {
            corpus.type_def(&format!("m::{}::{}", topic.name, def.name), id, def);
        }
    }
    for error in spec.errors() {
        let name = to_screaming(&error.name);
        corpus.function(
            "",
            &[
                format!("const CODE: jaka_proto::ErrorCode = jaka_proto::ErrorCode::{name};"),
                format!("match CODE {{ jaka_proto::ErrorCode::{name} => {{}} _ => {{}} }}"),
            ],
        );
    }
    corpus.code
}

struct Corpus<'s> {
    spec: &'s Spec,
    sent: BTreeSet<TypeId>,
    code: String,
    functions: usize,
}

impl Corpus<'_> {
    fn function(&mut self, parameters: &str, lines: &[String]) {
        self.functions += 1;
        let _ = writeln!(self.code, "pub fn f{}({parameters}) {{", self.functions);
        for line in lines {
            let _ = writeln!(self.code, "    {line}");
        }
        self.code += "}\n";
    }

    /// A constant function that returns what a constructor makes.
    fn constant(&mut self, path: &str, constructor: &str, fields: &[&Field]) {
        if fields.iter().any(|field| self.is_converted(field)) {
            return;
        }
        self.functions += 1;
        let typed = fields.iter().map(|field| format!("{}: {}", field.name, self.required(field)));
        let (parameters, names) = (list(typed), list(fields.iter().map(|field| field.name.clone())));
        let _ = writeln!(
            self.code,
            "pub const fn f{}({parameters}) -> {path} {{ {path}::{constructor}({names}) }}",
            self.functions
        );
    }

    fn command(&mut self, module: &str, command: &Command) {
        let path = format!("{module}::{}", command.request_type());
        let reply = match (&command.reply, command.reply_type()) {
            (Reply::Object(id), _) => self.path(*id),
            (Reply::Raw, _) => VALUE.to_owned(),
            (Reply::Fields(_), Some(name)) => format!("{module}::{name}"),
            (Reply::Fields(_), None) => "()".to_owned(),
        };
        match &command.request {
            Request::Fields(fields) => {
                self.made(&path, fields);
                self.structure(&path, fields);
            }
            Request::Choice(choice) => {
                self.variants_made(&path, &choice.variants);
                self.variants(&path, &choice.variants, None);
                let all: Vec<_> = command.request.fields().cloned().collect();
                self.traits(&path, self.spec.all_copy(&all), false);
            }
        }
        if let Some(name) = command.reply_type() {
            self.structure(&format!("{module}::{name}"), command.reply.own_fields());
        }
        let (variant, method) = (command.request_type(), &command.name);
        let mut lines = vec![
            format!("command::<{path}, {reply}>();"),
            format!("let request = m::Request::from(any::<{path}>());"),
            format!("match request {{ m::Request::{variant}(request) => {{ let _: {path} = request; }} _ => {{}} }}"),
        ];
        lines.extend(command.motion.is_some().then(|| format!("motion::<{path}>();")));
        for arguments in self.method_arguments(command, &path) {
            lines.push(format!("let _: {reply} = client.{method}({arguments}).unwrap();"));
        }
        self.function("client: &mut m::Client", &lines);
    }

    /// Arguments of the client's method: none, the one required field, or the request.
    fn method_arguments(&self, command: &Command, path: &str) -> Vec<String> {
        let request = vec![format!("&any::<{path}>()")];
        let Request::Fields(fields) = &command.request else { return request };
        let required: Vec<_> = fields.iter().filter(|field| !field.optional).collect();
        let is_argument = |field: &Field| {
            let is_one = match &field.ty {
                Type::Scalar(Scalar::Int | Scalar::Float | Scalar::Text) | Type::Named(_) => true,
                Type::Scalar(Scalar::Bool { .. } | Scalar::Json)
                | Type::List(_)
                | Type::Array(..)
                | Type::Python(_) => false,
            };
            is_one && !field.or_raw
        };
        match required.as_slice() {
            [] => vec![String::new()],
            [field] if is_argument(field) => self.values(field),
            _ => request,
        }
    }

    fn type_def(&mut self, path: &str, id: TypeId, def: &TypeDef) {
        let is_copy = self.spec.is_copy(&Type::Named(id));
        match &def.kind {
            TypeKind::Array { fields, .. } if is_floats(fields) => self.floats(path, fields),
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => {
                self.structure(path, fields);
                if self.sent.contains(&id) {
                    self.made(path, fields);
                }
            }
            TypeKind::Wrapper(inner, _) => {
                let inner = self.rust(inner);
                self.traits(path, is_copy, false);
                self.function(
                    "",
                    &[
                        format!("let value = {path}::from(any::<{inner}>());"),
                        format!("let {path}(inner) = value;"),
                        format!("let mut value = {path}(inner);"),
                        format!("value.0 = any::<{inner}>();"),
                        format!("let _: {inner} = value.into();"),
                    ],
                );
            }
            TypeKind::IntEnum(values) => {
                self.values_of(path, values, "i64");
                self.traits(path, true, false);
                self.function(
                    "",
                    &[
                        format!("hash::<{path}>();"),
                        format!("let value = {path}::from(1_i64);"),
                        "let _ = i64::from(value);".to_owned(),
                    ],
                );
            }
            TypeKind::TextEnum(values) => {
                self.values_of(path, values, "String");
                self.traits(path, false, false);
                self.function(
                    "",
                    &[
                        format!("hash::<{path}>();"),
                        format!("let value = {path}::from(\"text\");"),
                        "let _: &str = value.as_ref();".to_owned(),
                    ],
                );
            }
            TypeKind::Choice(choice) => {
                self.variants(path, &choice.variants, Some(VALUE));
                self.traits(path, false, false);
                if self.sent.contains(&id) {
                    self.variants_made(path, &choice.variants);
                }
            }
        }
    }

    /// A struct of numbers alone, which grows in no other way than with a new major version.
    fn floats(&mut self, path: &str, fields: &[Field]) {
        let (len, names) = (fields.len(), list(fields.iter().map(|field| field.name.clone())));
        self.traits(path, true, fields.is_empty());
        self.function(
            "",
            &[
                format!("let value = {path}::from([1.0; {len}]);"),
                format!("let {path} {{ {names} }} = value;"),
                format!("let value = {path} {{ {names} }};"),
                format!("let _: [f64; {len}] = value.into();"),
            ],
        );
        self.fields(path, fields);
    }

    /// A struct that may get further fields.
    fn structure(&mut self, path: &str, fields: &[Field]) {
        self.traits(path, self.spec.all_copy(fields), fields.iter().all(|field| field.optional));
        self.fields(path, fields);
    }

    fn traits(&mut self, path: &str, is_copy: bool, has_default: bool) {
        let mut lines = vec![format!("common::<{path}>();")];
        lines.extend(is_copy.then(|| format!("copy::<{path}>();")));
        lines.extend(has_default.then(|| format!("default::<{path}>();")));
        self.function("", &lines);
    }

    /// Reads each field with its type, writes it, and takes the struct apart.
    fn fields(&mut self, path: &str, fields: &[Field]) {
        let mut lines = Vec::new();
        for field in fields {
            let (name, ty) = (&field.name, self.whole(field));
            lines.push(format!("let _: &{ty} = &value.{name};"));
            lines.push(format!("value.{name} = any::<{ty}>();"));
        }
        lines.push(format!("let {path} {{ {} .. }} = value;", names(fields)));
        lines.extend(self.typed(fields));
        self.function(&format!("mut value: {path}"), &lines);
    }

    /// Says the types of fields that a pattern has bound.
    fn typed(&self, fields: &[Field]) -> Vec<String> {
        fields.iter().map(|field| format!("let _: {} = {};", self.whole(field), field.name)).collect()
    }

    /// A struct by its constructors, and with its setters.
    fn made(&mut self, path: &str, fields: &[Field]) {
        let required: Vec<_> = fields.iter().filter(|field| !field.optional).collect();
        self.constant(path, "new", &required);
        let mut lines = self.calls(path, "new", &required);
        for field in required.iter().filter(|field| field.constructors) {
            let others: Vec<_> = required.iter().filter(|other| other.name != field.name).copied().collect();
            for value in self.value_names(field) {
                let is_setter = fields.iter().any(|field| field.optional && field.name == value);
                let function = if is_setter { format!("{value}_") } else { function_name(&value) };
                lines.extend(self.calls(path, &function, &others));
            }
        }
        for field in fields.iter().filter(|field| field.optional) {
            let setter = if field.name == "new" { "new_" } else { &field.name };
            for value in self.values(field) {
                lines.push(format!("let _: {path} = any::<{path}>().{setter}({value});"));
            }
        }
        self.function("", &lines);
    }

    /// Variants by their constructors.
    fn variants_made(&mut self, path: &str, variants: &[Variant]) {
        for variant in variants {
            let required: Vec<_> = variant.fields.iter().filter(|field| !field.optional).collect();
            let function = function_name(&to_snake(&variant.name));
            self.constant(path, &function, &required);
            let lines = self.calls(path, &function, &required);
            self.function("", &lines);
        }
    }

    /// Takes each variant apart; `other` is the content of that for what the spec does not list.
    fn variants(&mut self, path: &str, variants: &[Variant], other: Option<&str>) {
        let mut lines = vec!["match value {".to_owned()];
        for variant in variants {
            let typed = self.typed(&variant.fields).concat();
            lines.push(format!("    {path}::{} {{ {} .. }} => {{ {typed} }}", variant.name, names(&variant.fields)));
        }
        lines.extend(other.map(|other| format!("    {path}::Other(other) => {{ let _: {other} = other; }}")));
        lines.push("    _ => {}".to_owned());
        lines.push("}".to_owned());
        self.function(&format!("value: {path}"), &lines);
    }

    /// Names each value of an enum, as a value and as a pattern.
    fn values_of<T>(&mut self, path: &str, values: &[EnumValue<T>], other: &str) {
        let mut lines: Vec<_> =
            values.iter().map(|value| format!("const _: {path} = {path}::{};", value.name)).collect();
        lines.push("match value {".to_owned());
        lines.extend(values.iter().map(|value| format!("    {path}::{} => {{}}", value.name)));
        lines.push(format!("    {path}::Other(other) => {{ let _: {other} = other; }}"));
        lines.push("    _ => {}".to_owned());
        lines.push("}".to_owned());
        self.function(&format!("value: {path}"), &lines);
    }

    /// The names that constructors have for the values of an enum.
    fn value_names(&self, field: &Field) -> Vec<String> {
        match field.ty.named().map(|id| &self.spec[id].kind) {
            Some(TypeKind::IntEnum(values)) => values.iter().map(|value| to_snake(&value.name)).collect(),
            Some(TypeKind::TextEnum(values)) => values.iter().map(|value| to_snake(&value.name)).collect(),
            _ => Vec::new(),
        }
    }

    /// A constructor with values of the fields' types, and with what converts into them.
    fn calls(&self, path: &str, function: &str, fields: &[&Field]) -> Vec<String> {
        let most = fields.iter().map(|field| self.values(field).len()).max().unwrap_or(1);
        let call = |turn: usize| {
            let value = |field: &&Field| {
                let values = self.values(field);
                values[turn.min(values.len() - 1)].clone()
            };
            format!("let _: {path} = {path}::{function}({});", list(fields.iter().map(value)))
        };
        (0..most).map(call).collect()
    }

    /// Values for a field: one of its type, and what converts into it.
    fn values(&self, field: &Field) -> Vec<String> {
        let mut types = vec![self.required(field)];
        if field.or_raw {
            types.push(self.rust(&field.ty));
        } else {
            types.extend(self.convertible(field));
        }
        types.iter().map(|ty| format!("any::<{ty}>()")).collect()
    }

    /// The type that converts into that of the field, where a function takes it.
    fn convertible(&self, field: &Field) -> Option<String> {
        match &field.ty {
            Type::Scalar(Scalar::Text) => Some("&str".to_owned()),
            Type::Named(id) => match &self.spec[*id].kind {
                TypeKind::Wrapper(inner, _) => Some(self.rust(inner)),
                TypeKind::Array { fields, .. } if is_floats(fields) => Some(format!("[f64; {}]", fields.len())),
                _ => None,
            },
            _ => None,
        }
    }

    fn is_converted(&self, field: &Field) -> bool {
        field.or_raw || self.convertible(field).is_some()
    }

    /// The type of the field.
    fn whole(&self, field: &Field) -> String {
        let ty = self.required(field);
        if field.optional { format!("Option<{ty}>") } else { ty }
    }

    /// The type of the field's value, where it is there.
    fn required(&self, field: &Field) -> String {
        let ty = self.rust(&field.ty);
        if field.or_raw { format!("jaka_proto::wire::Typed<{ty}>") } else { ty }
    }

    fn rust(&self, ty: &Type) -> String {
        match ty {
            Type::Scalar(Scalar::Bool { .. }) => "bool".to_owned(),
            Type::Scalar(Scalar::Int) => "i64".to_owned(),
            Type::Scalar(Scalar::Float) => "f64".to_owned(),
            Type::Scalar(Scalar::Text) => "String".to_owned(),
            Type::Scalar(Scalar::Json) => VALUE.to_owned(),
            Type::List(element) => format!("Vec<{}>", self.rust(element)),
            Type::Array(element, len) => format!("[{}; {len}]", self.rust(element)),
            Type::Named(id) => self.path(*id),
            Type::Python(inner) => self.rust(inner),
        }
    }

    fn path(&self, id: TypeId) -> String {
        let topic = self.spec.topic_of(id).expect("a type is in a topic");
        format!("m::{}::{}", topic.name, self.spec[id].name)
    }
}

/// The type of raw JSON.
const VALUE: &str = "jaka_proto::wire::Value";

fn list(items: impl Iterator<Item = String>) -> String {
    items.collect::<Vec<_>>().join(", ")
}

/// The names of fields in a pattern, each with a comma.
fn names(fields: &[Field]) -> String {
    fields.iter().flat_map(|field| [&*field.name, ", "]).collect()
}

/// The name of a constructor, after which an underscore follows where Rust or another constructor has the name.
fn function_name(name: &str) -> String {
    if name == "new" || !is_snake(name) { format!("{name}_") } else { name.to_owned() }
}

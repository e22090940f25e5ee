//! Calls of a client: the parameter of a command's method, and code that sends the message of an example.
//!
//! A JSON text without escapes is Rust tokens, too, and is read as such.

use std::collections::BTreeSet;
use std::iter;

use jaka_spec::{COMMAND_NAME, Command, Field, Reply, Request, Scalar, Spec, Topic, Type, TypeId, TypeKind, is_floats};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::construct;

/// Longest line of the code, for which a page of rustdoc has room.
const LINE: usize = 80;

/// Parameter of a method, which follows from the fields that its request requires.
pub(crate) enum Parameter<'f> {
    /// Nothing: no field is required.
    None,
    /// The value of the one field that is required: a number, a text or a named type.
    Value(&'f Field),
    /// The request itself.
    Request,
}

/// The parameter of the method that sends a request.
///
/// Optional fields do not count, so that a method stays as it is where one comes: a request with some of them is sent
/// by `call`.
pub(crate) fn parameter(request: &Request) -> Parameter<'_> {
    let Request::Fields(fields) = request else { return Parameter::Request };
    let required: Vec<_> = fields.iter().filter(|field| !field.optional).collect();
    match required.as_slice() {
        [] => Parameter::None,
        [field] if field.is_argument() => Parameter::Value(field),
        _ => Parameter::Request,
    }
}

/// A request with the values of an example, as code.
pub(crate) struct Call {
    /// Paths of the types in the code, from the root of jaka-sync.
    imports: BTreeSet<String>,
    request: Made,
    /// Name of the method that sends it.
    method: String,
    /// The argument of the method, if it is not the request; empty without one.
    value: Option<String>,
    /// Binding for the reply where that carries data.
    reply: &'static str,
}

impl Call {
    /// The call that sends a message; `None` if the spec tells no form in Rust for a value of the message.
    pub(crate) fn new(spec: &Spec, topic: &Topic, command: &Command, message: &str) -> Option<Self> {
        let tokens: Vec<_> = message.parse::<TokenStream>().ok()?.into_iter().collect();
        let members = members(&tokens)?;
        let get = |wire: &str| members.iter().find(|(key, _)| key == wire).map(|(_, value)| value.as_slice());
        let mut code = Code { spec, imports: BTreeSet::new() };
        let name = command.request_type();
        let (fields, tag, request) = match &command.request {
            Request::Fields(fields) => (fields, None, code.made(&name, &with_values(fields, get))?),
            Request::Choice(choice) => {
                let tag = number(get(&choice.tag)?)?;
                let variant = choice.variants.iter().find(|variant| variant.wire.to_string() == tag)?;
                let function = format!("{name}::{}", construct::function_name(&variant.name, &[]));
                let arguments = code.arguments(&with_values(&variant.fields, get))?;
                (&variant.fields, Some(&choice.tag), Made { function, arguments, setters: Vec::new() })
            }
        };
        let is_known =
            |key: &String| key == COMMAND_NAME || Some(key) == tag || fields.iter().any(|field| field.wire == *key);
        if !members.iter().all(|(key, _)| is_known(key)) {
            return None;
        }
        let has_optional = fields.iter().any(|field| field.optional && get(&field.wire).is_some());
        let (method, value) = match parameter(&command.request) {
            Parameter::Request => (&*command.name, None),
            _ if has_optional => ("call", None),
            Parameter::Value(field) => (&*command.name, Some(code.argument(field, get(&field.wire)?)?)),
            Parameter::None => (&*command.name, Some(String::new())),
        };
        if value.is_none() {
            code.imports.insert(format!("{}::{name}", topic.name));
        }
        let is_empty = matches!(&command.reply, Reply::Fields(fields) if fields.is_empty());
        let reply = if is_empty { "" } else { "let reply = " };
        Some(Self { imports: code.imports, request, method: method.to_owned(), value, reply })
    }

    /// Expression for the request, which needs the types of all topics.
    #[cfg(test)]
    pub(crate) fn request(&self) -> String {
        self.request.line()
    }

    /// Program that imports the types and calls the method. Its first and last line are those of a test.
    pub(crate) fn code(&self) -> String {
        let Self { imports, request, method, value, reply } = self;
        let mut lines = vec!["# let mut robot = jaka_sync::Client::connect(\"10.5.5.100\")?;".to_owned()];
        lines.extend(imports.iter().map(|path| format!("use jaka_sync::{path};")));
        if !imports.is_empty() {
            lines.push(String::new());
        }
        let argument = value.clone().unwrap_or_else(|| format!("&{}", request.line()));
        let call = format!("{reply}robot.{method}({argument})?;");
        if call.len() <= LINE || value.is_some() {
            lines.push(call);
        } else {
            lines.push(request.binding());
            lines.push(format!("{reply}robot.{method}(&request)?;"));
        }
        lines.push("# Ok::<(), jaka_sync::Error>(())".to_owned());
        lines.join("\n")
    }
}

/// A constructor with its setters, as code.
struct Made {
    /// Path of the constructor.
    function: String,
    arguments: Vec<String>,
    /// Calls of setters, each with its dot.
    setters: Vec<String>,
}

impl Made {
    fn line(&self) -> String {
        format!("{}({}){}", self.function, self.arguments.join(", "), self.setters.concat())
    }

    /// Statement that names it `request`, in several lines if one is too long.
    fn binding(&self) -> String {
        let line = format!("let request = {};", self.line());
        if line.len() <= LINE {
            return line;
        }
        let Self { function, arguments, setters } = self;
        let made = format!("let request = {function}({})", arguments.join(", "));
        if made.len() <= LINE {
            return format!("{made}\n    {};", setters.join("\n    "));
        }
        format!("let request = {function}(\n    {},\n){};", arguments.join(",\n    "), setters.join("\n"))
    }
}

/// A field, with the tokens of its value if the message has it.
type WithValue<'t> = (&'t Field, Option<&'t [TokenTree]>);

fn with_values<'t>(fields: &'t [Field], get: impl Fn(&str) -> Option<&'t [TokenTree]>) -> Vec<WithValue<'t>> {
    fields.iter().map(|field| (field, get(&field.wire))).collect()
}

/// Translation of one message.
struct Code<'s> {
    spec: &'s Spec,
    imports: BTreeSet<String>,
}

impl Code<'_> {
    fn made(&mut self, name: &str, fields: &[WithValue<'_>]) -> Option<Made> {
        let (mut function, mut fields) = (format!("{name}::new"), fields.to_vec());
        if let Some(at) = fields.iter().position(|(field, _)| field.constructors && !field.optional) {
            let all: Vec<_> = fields.iter().map(|(field, _)| (*field).clone()).collect();
            let (selector, value) = fields.remove(at);
            let variant = self.variant(selector.ty.named()?, value?)?;
            function = format!("{name}::{}", construct::function_name(&variant, &all));
        }
        let arguments = self.arguments(&fields)?;
        let optional = fields.iter().filter(|(field, _)| field.optional);
        let given = optional.filter_map(|(field, value)| Some((*field, (*value)?)));
        let set =
            |(field, value)| Some(format!(".{}({})", construct::setter_name(field), self.argument(field, value)?));
        let setters = given.map(set).collect::<Option<_>>()?;
        Some(Made { function, arguments, setters })
    }

    /// Arguments for the required fields.
    fn arguments(&mut self, fields: &[WithValue<'_>]) -> Option<Vec<String>> {
        let required = fields.iter().filter(|(field, _)| !field.optional);
        required.map(|(field, value)| self.argument(field, (*value)?)).collect()
    }

    /// The argument of a constructor, a setter or a method for a field.
    fn argument(&mut self, field: &Field, value: &[TokenTree]) -> Option<String> {
        match &field.ty {
            // The argument converts from an array.
            Type::Named(id) if !field.or_raw => match &self.spec[*id].kind {
                TypeKind::Wrapper(ty, _) => self.value(ty, value),
                TypeKind::Array { fields, .. } if is_floats(fields) => self.floats(fields.len(), value),
                _ => self.value(&field.ty, value),
            },
            _ => self.value(&field.ty, value),
        }
    }

    /// A value of exactly this type.
    fn value(&mut self, ty: &Type, value: &[TokenTree]) -> Option<String> {
        match ty {
            Type::Scalar(Scalar::Bool { off, on }) => {
                let text = text(value);
                if text == *on { Some("true".to_owned()) } else { (text == *off).then(|| "false".to_owned()) }
            }
            Type::Scalar(Scalar::Int) => number(value).filter(|number| number.parse::<i64>().is_ok()),
            Type::Scalar(Scalar::Float) => {
                let number = number(value)?;
                Some(if number.contains(['.', 'e', 'E']) { number } else { number + ".0" })
            }
            Type::Scalar(Scalar::Text) => string(value),
            Type::Scalar(Scalar::Json) | Type::Python(_) => None,
            Type::List(element) => Some(format!("vec![{}]", self.elements(element, value)?.join(", "))),
            Type::Array(element, len) => {
                let elements = self.elements(element, value)?;
                (elements.len() == *len).then(|| format!("[{}]", elements.join(", ")))
            }
            Type::Named(id) => self.named(*id, value),
        }
    }

    fn named(&mut self, id: TypeId, value: &[TokenTree]) -> Option<String> {
        let def = &self.spec[id];
        let code = match &def.kind {
            TypeKind::IntEnum(_) | TypeKind::TextEnum(_) => format!("{}::{}", def.name, self.variant(id, value)?),
            TypeKind::Wrapper(ty, _) => format!("{}({})", def.name, self.value(ty, value)?),
            TypeKind::Array { fields, .. } if is_floats(fields) => {
                format!("{}::from({})", def.name, self.floats(fields.len(), value)?)
            }
            TypeKind::Array { fields, .. } => {
                let elements = elements(value)?;
                if elements.len() > fields.len() {
                    return None;
                }
                let values = elements.iter().map(|element| Some(element.as_slice())).chain(iter::repeat(None));
                self.made(&def.name, &fields.iter().zip(values).collect::<Vec<_>>())?.line()
            }
            TypeKind::Object(_) | TypeKind::Choice(_) => return None,
        };
        let module = &self.spec.topic_of(id)?.name;
        self.imports.insert(format!("{module}::{}", def.name));
        Some(code)
    }

    /// The name of an enum's variant.
    fn variant(&self, id: TypeId, value: &[TokenTree]) -> Option<String> {
        match &self.spec[id].kind {
            TypeKind::IntEnum(values) => {
                let number = number(value)?;
                values.iter().find(|value| value.wire.to_string() == number).map(|value| value.name.clone())
            }
            TypeKind::TextEnum(values) => {
                let text = string(value)?;
                values.iter().find(|value| text.trim_matches('"') == value.wire).map(|value| value.name.clone())
            }
            _ => None,
        }
    }

    fn floats(&mut self, len: usize, value: &[TokenTree]) -> Option<String> {
        self.value(&Type::Array(Box::new(Type::Scalar(Scalar::Float)), len), value)
    }

    fn elements(&mut self, element: &Type, value: &[TokenTree]) -> Option<Vec<String>> {
        elements(value)?.iter().map(|value| self.value(element, value)).collect()
    }
}

/// The members of a JSON object.
fn members(value: &[TokenTree]) -> Option<Vec<(String, Vec<TokenTree>)>> {
    let member = |member: &Vec<TokenTree>| {
        let [TokenTree::Literal(key), TokenTree::Punct(colon), value @ ..] = member.as_slice() else { return None };
        (colon.as_char() == ':').then(|| (key.to_string().trim_matches('"').to_owned(), value.to_vec()))
    };
    parts(value, Delimiter::Brace)?.iter().map(member).collect()
}

/// The elements of a JSON array.
fn elements(value: &[TokenTree]) -> Option<Vec<Vec<TokenTree>>> {
    parts(value, Delimiter::Bracket)
}

/// The parts between the commas inside of brackets.
fn parts(value: &[TokenTree], delimiter: Delimiter) -> Option<Vec<Vec<TokenTree>>> {
    let [TokenTree::Group(group)] = value else { return None };
    let inside: Vec<_> = group.stream().into_iter().collect();
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let parts = inside.split(is_comma).map(<[_]>::to_vec).filter(|part| !part.is_empty());
    (group.delimiter() == delimiter).then(|| parts.collect())
}

/// A JSON number, which Rust writes in the same way.
fn number(value: &[TokenTree]) -> Option<String> {
    Some(text(value)).filter(|text| text.parse::<f64>().is_ok())
}

/// A JSON string without escapes, with its quotes.
fn string(value: &[TokenTree]) -> Option<String> {
    Some(text(value)).filter(|text| text.starts_with('"') && !text.contains('\\'))
}

fn text(value: &[TokenTree]) -> String {
    value.iter().map(ToString::to_string).collect()
}

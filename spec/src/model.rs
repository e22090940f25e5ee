//! The spec as plain data, after every check has passed.

use std::ops::RangeInclusive;
use std::time::Duration;

use crate::evidence::Evidence;
use crate::keys::{COMMAND_NAME, key, push_string};

use crate::names::to_camel;
use crate::range::{Advice, Range};
use crate::role::{Change, Motion, Role};
use crate::scalar::Scalar;
use crate::version::Versions;

/// A named type of a spec, and of all specs that packs make of it: `spec[id]` is its definition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TypeId(pub(crate) usize);

/// One source file: a module of the generated code.
#[derive(Debug, Clone, PartialEq)]
pub struct Topic {
    /// Module name, which is the file's stem.
    pub name: String,
    /// True for a pack's topic: its module is in the crate of the pack's user.
    pub is_pack: bool,
    /// Subject of the topic, in one line.
    pub title: String,
    /// Title in Chinese: the document's title for a chapter of the document.
    pub title_zh: Option<String>,
    /// The text below the title.
    pub doc: String,
    /// Types defined in this file.
    pub types: Vec<TypeId>,
    /// Commands defined in this file.
    pub commands: Vec<Command>,
    /// Error codes defined in this file.
    pub errors: Vec<ErrorCode>,
    /// Events of the controller defined in this file.
    pub events: Vec<Event>,
    /// Families of events defined in this file.
    pub event_families: Vec<EventFamily>,
}

impl Topic {
    /// True for a topic without types, commands, error codes and events.
    pub fn is_empty(&self) -> bool {
        self.types.is_empty() && self.commands.is_empty() && self.errors.is_empty() && self.events.is_empty()
    }
}

/// One command of port 10001.
#[derive(Debug, Clone, PartialEq)]
pub struct Command {
    /// `cmdName` on the wire.
    pub wire: String,
    /// Method name in Rust.
    pub name: String,
    /// Functions of the vendor's SDK with the same purpose.
    pub aliases: Vec<String>,
    /// Section of the vendor's document, such as `4.7`.
    pub section: Option<String>,
    /// The section's title in the document, which is Chinese.
    pub title_zh: Option<String>,
    /// Sources of a command that the document does not have.
    pub evidence: Vec<Evidence>,
    /// Effect of the command on the robot.
    pub effect: Effect,
    /// Role of the command to the arm.
    pub role: Option<Role>,
    /// Properties of the arm that it changes.
    pub changes: Vec<Change>,
    /// Motion that it starts, if its end can be waited for.
    pub motion: Option<Motion>,
    /// `cmdName` of the setting whose fields its reply has as they were last set.
    pub remembers: Option<String>,
    /// States without which the controller refuses.
    pub requires: Vec<Requirement>,
    /// Source of the requirements.
    pub requires_source: Option<String>,
    /// Longest time for a reply, if the client's default does not fit.
    pub deadline: Option<Duration>,
    /// False if the controller may go away instead of replying.
    pub reply_certain: bool,
    /// True if the connection is useless after the reply.
    pub ends_session: bool,
    /// The evidence, if the vendor's text for this command is lost.
    pub reconstructed: Option<String>,
    /// Replacement for the command, if the vendor has withdrawn it.
    pub deprecated: Option<String>,
    /// First and last firmware that has the command.
    pub versions: Versions,
    /// Description of the command. The first sentence stands alone.
    pub doc: String,
    /// Contradictions in the document, or between the document and the controllers.
    pub errata: Vec<String>,
    /// Content of the request in addition to `cmdName`.
    pub request: Request,
    /// Content of the reply in addition to `cmdName`, `errorCode` and `errorMsg`; its fields are
    /// [`Spec::reply_fields`](crate::Spec::reply_fields).
    pub reply: Reply,
    /// The reply field (Rust name) that a bare Python tuple in place of a JSON reply stands for.
    pub bare_reply: Option<String>,
    /// The controller's answer to a requirement that is not met, if it is not the usual refusal.
    pub refusal: Option<Refusal>,
    /// Known causes of refusals, each with its source, other than the states that it requires.
    pub refused_because: Vec<String>,
    /// The document's own messages, as far as it prints them.
    pub examples: Vec<Example>,
}

impl Command {
    /// Name of the request's type in Rust, such as `JointMove`.
    pub fn request_type(&self) -> String {
        to_camel(&self.name)
    }

    /// Name of the type in Rust that the reply has for itself, such as `GetJointPosReply`, if its fields are its own.
    pub fn reply_type(&self) -> Option<String> {
        (!self.reply.own_fields().is_empty()).then(|| self.request_type() + "Reply")
    }

    /// The fields of its request, of all variants where there are some, and those that its reply has for itself.
    pub fn fields(&self) -> impl Iterator<Item = &Field> {
        self.request.fields().chain(self.reply.own_fields())
    }

    /// The named types of its fields, and the one that its reply is.
    pub fn parts(&self) -> impl Iterator<Item = TypeId> {
        self.fields().filter_map(|field| field.ty.named()).chain(self.reply.object())
    }

    /// The beginning of each request as JSON text: the brace, and `cmdName` with its value.
    pub fn head(&self) -> String {
        let mut head = format!("{{{}", key(COMMAND_NAME));
        push_string(&mut head, &self.wire);
        head
    }

    /// Variants of the request; `None` if all requests have the same fields.
    pub fn variants(&self) -> &[Variant] {
        if let Request::Choice(choice) = &self.request { &choice.variants } else { &[] }
    }

    /// True if nothing is sent but `cmdName`.
    pub fn is_bare(&self) -> bool {
        matches!(&self.request, Request::Fields(fields) if fields.is_empty())
    }
}

impl Command {
    /// Role of the request; a variant may have its own.
    pub fn role_of_variant(&self, tag: Option<i64>) -> Option<Role> {
        let variant = self.variants().iter().find(|variant| Some(variant.wire) == tag);
        variant.and_then(|variant| variant.role).or(self.role)
    }

    /// Field of the request that says by its value whether a command with the role `servo_mode` enters servo mode or
    /// leaves it (0, or false); `None` if no value of its request leaves it for certain.
    pub fn servo_mode_field(&self) -> Option<&Field> {
        match &self.request {
            Request::Fields(fields) if self.role == Some(Role::ServoMode) => match fields.as_slice() {
                [field] if !field.optional && !field.or_raw => Some(field),
                _ => None,
            },
            Request::Fields(_) | Request::Choice(_) => None,
        }
    }

    /// Field of the request, by its Rust name, where all requests have the same fields.
    pub fn request_field(&self, name: &str) -> Option<&Field> {
        match &self.request {
            Request::Fields(fields) => fields.iter().find(|field| field.name == name),
            Request::Choice(_) => None,
        }
    }
}

toml_words! {
    /// Effect of a command on the robot.
    pub enum Effect {
        /// Reads; changes nothing.
        Query: "query",
        /// Changes a setting or an output.
        Setting: "setting",
        /// Starts, stops or continues a motion or a program.
        Motion: "motion",
        /// Switches power, brakes or the controller itself.
        Power: "power",
        /// Concerns the connection alone.
        Session: "session",
    }
}

toml_words! {
    /// A state that a command needs.
    pub enum Requirement {
        /// The arm has power.
        Powered: "powered",
        /// The arm is enabled.
        Enabled: "enabled",
        /// Servo mode is on.
        ServoMode: "servo_mode",
        /// Servo mode is off.
        NotServoMode: "not_servo_mode",
    }
}

/// The body of a request.
#[derive(Debug, Clone, PartialEq)]
pub enum Request {
    /// Fields that are the same each time; possibly none.
    Fields(Vec<Field>),
    /// Different fields for each value of a tag.
    Choice(Choice),
}

impl Request {
    /// Its fields, of all variants where there are some.
    pub fn fields(&self) -> impl Iterator<Item = &Field> {
        let (fields, variants) = match self {
            Self::Fields(fields) => (fields.as_slice(), &[][..]),
            Self::Choice(choice) => (&[][..], choice.variants.as_slice()),
        };
        fields.iter().chain(variants.iter().flat_map(|variant| &variant.fields))
    }
}

/// The body of a reply.
#[derive(Debug, Clone, PartialEq)]
pub enum Reply {
    /// Fields of its own; possibly none.
    Fields(Vec<Field>),
    /// The keys of a named type, which is an object.
    Object(TypeId),
    /// Keys that are not documented: raw JSON.
    Raw,
}

impl Reply {
    /// The fields that no named type has; `None` if the reply is an object of a named type.
    pub fn own_fields(&self) -> &[Field] {
        if let Self::Fields(fields) = self { fields } else { &[] }
    }

    /// The named type whose keys the reply has, if it is an object of one.
    pub fn object(&self) -> Option<TypeId> {
        if let Self::Object(id) = self { Some(*id) } else { None }
    }
}

/// Variants with an integer tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Key of the tag on the wire; empty if the tag is the first element of an array.
    pub tag: String,
    /// The variants, in the order of the file.
    pub variants: Vec<Variant>,
}

impl Choice {
    /// The tag's key as JSON text, with its quotes and colon.
    pub fn key(&self) -> String {
        key(&self.tag)
    }
}

/// One variant of a [`Choice`].
#[derive(Debug, Clone, PartialEq)]
pub struct Variant {
    /// Value of the tag.
    pub wire: i64,
    /// Variant name in Rust.
    pub name: String,
    /// Description of the variant.
    pub doc: String,
    /// Role of requests of this variant.
    pub role: Option<Role>,
    /// The fields sent with it.
    pub fields: Vec<Field>,
}

/// One field of a request, a reply or a type.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a key of its own in the TOML files")]
pub struct Field {
    /// Key on the wire; empty for an element of an array.
    pub wire: String,
    /// Field name in Rust.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Unit of its number or numbers, such as `deg/s`.
    pub unit: Option<String>,
    /// Least and greatest value allowed.
    pub range: Range,
    /// Advised limits of its numbers, in addition to the range.
    pub advised: Vec<Advice>,
    /// True for text that may hold printable ASCII only.
    pub ascii: bool,
    /// True if the key may be absent.
    pub optional: bool,
    /// True for an enum that selects a kind of message: Rust gets a constructor for each of its values.
    pub constructors: bool,
    /// True if sources allow another shape: a value that does not fit the type is kept as raw JSON.
    pub or_raw: bool,
    /// Meaning of the field. The first sentence stands alone.
    pub doc: String,
    /// The readings of sources that contradict each other; the value stays raw.
    pub disputed: Vec<String>,
    /// First and last firmware that has the field.
    pub versions: Versions,
    /// Sources of what the document does not say.
    pub evidence: Vec<Evidence>,
}

impl Field {
    /// Its key as JSON text, with its quotes and colon.
    pub fn key(&self) -> String {
        key(&self.wire)
    }

    /// True for a field that a command's method takes in place of the request, if no other field is required.
    pub fn is_argument(&self) -> bool {
        match &self.ty {
            Type::Scalar(Scalar::Text | Scalar::Float | Scalar::Int) | Type::Named(_) => !self.or_raw,
            Type::Scalar(Scalar::Bool { .. } | Scalar::Json) | Type::List(_) | Type::Array(..) | Type::Python(_) => {
                false
            }
        }
    }
}

/// The type of a field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Type {
    /// One value that has no parts.
    Scalar(Scalar),
    /// An array of some length.
    List(Box<Type>),
    /// An array of a length fixed by the protocol.
    Array(Box<Type>, usize),
    /// A named type.
    Named(TypeId),
    /// A value written as a Python literal inside a JSON string.
    Python(Box<Type>),
}

impl Type {
    /// The innermost scalar or named type: of its elements, or of the value of its literal.
    pub fn innermost(&self) -> &Self {
        match self {
            Self::List(inner) | Self::Array(inner, _) | Self::Python(inner) => inner.innermost(),
            Self::Scalar(_) | Self::Named(_) => self,
        }
    }

    /// True for what is read in a way of its own, and so only where the field's key is read.
    pub(crate) fn needs_key(&self) -> bool {
        match self {
            Self::Python(_) => true,
            Self::List(element) | Self::Array(element, _) => element.needs_key(),
            Self::Scalar(scalar) => scalar.truth_words().is_some(),
            Self::Named(_) => false,
        }
    }

    /// The scalar at its heart, if that is one.
    pub fn scalar(&self) -> Option<&Scalar> {
        if let Self::Scalar(scalar) = self.innermost() { Some(scalar) } else { None }
    }

    /// True for types that are the same in Rust, however truth values are written.
    pub(crate) fn is_alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Scalar(Scalar::Bool { .. }), Self::Scalar(Scalar::Bool { .. })) => true,
            (Self::List(one), Self::List(other)) | (Self::Python(one), Self::Python(other)) => one.is_alike(other),
            (Self::Array(one, length), Self::Array(other, other_length)) => {
                length == other_length && one.is_alike(other)
            }
            (one, other) => one == other,
        }
    }

    /// The named type at its heart, if that is one.
    pub fn named(&self) -> Option<TypeId> {
        if let Self::Named(id) = self.innermost() { Some(*id) } else { None }
    }
}

/// A named type.
#[derive(Debug, Clone, PartialEq)]
pub struct TypeDef {
    /// Type name in Rust.
    pub name: String,
    /// Meaning of the type. The first sentence stands alone.
    pub doc: String,
    /// Kind of the type, with its parts.
    pub kind: TypeKind,
}

impl TypeDef {
    /// True for a type that is made from another: a wrapper, and an array of numbers.
    pub fn converts(&self) -> bool {
        match &self.kind {
            TypeKind::Wrapper(..) => true,
            TypeKind::Array { fields, .. } => is_floats(fields),
            TypeKind::Object(_) | TypeKind::IntEnum(_) | TypeKind::TextEnum(_) | TypeKind::Choice(_) => false,
        }
    }
}

/// Kind of a [`TypeDef`], with its parts.
#[derive(Debug, Clone, PartialEq)]
pub enum TypeKind {
    /// A struct, written as a JSON object.
    Object(Vec<Field>),
    /// A struct, written as a JSON array.
    Array {
        /// The elements, in order.
        fields: Vec<Field>,
        /// True if an array with further elements is an error; otherwise they are ignored.
        exact: bool,
    },
    /// An open set of named integers.
    IntEnum(Vec<EnumValue<i64>>),
    /// An open set of named strings.
    TextEnum(Vec<EnumValue<String>>),
    /// Variants written as a JSON array that begins with the tag.
    Choice(Choice),
    /// A struct around one value: the wrapped type and its unit.
    Wrapper(Type, Option<String>),
}

impl TypeKind {
    /// Kind without docs, ranges and versions.
    pub(crate) fn undescribed(&self) -> Self {
        let mut kind = self.clone();
        let plain = |fields: &mut Vec<Field>| {
            for field in fields {
                (field.doc, field.range, field.versions) = (String::new(), Range::default(), Versions::default());
                (field.advised, field.disputed) = (Vec::new(), Vec::new());
                field.evidence.clear();
            }
        };
        match &mut kind {
            Self::Object(fields) | Self::Array { fields, .. } => plain(fields),
            Self::Choice(choice) => {
                for variant in &mut choice.variants {
                    variant.doc.clear();
                    plain(&mut variant.fields);
                }
            }
            Self::IntEnum(values) => values.iter_mut().for_each(EnumValue::undescribe),
            Self::TextEnum(values) => values.iter_mut().for_each(EnumValue::undescribe),
            Self::Wrapper(..) => {}
        }
        kind
    }

    /// The named types that it is made of.
    pub fn parts(&self) -> impl Iterator<Item = TypeId> {
        self.types().filter_map(Type::named)
    }

    /// The types of all its fields, or the wrapped type.
    pub(crate) fn types(&self) -> impl Iterator<Item = &Type> {
        let wrapped = if let Self::Wrapper(ty, _) = self { Some(ty) } else { None };
        self.fields().map(|field| &field.ty).chain(wrapped)
    }

    /// Its fields, of all variants where there are some.
    pub fn fields(&self) -> impl Iterator<Item = &Field> {
        let (fields, variants) = match self {
            Self::Object(fields) | Self::Array { fields, .. } => (fields.as_slice(), &[][..]),
            Self::Choice(choice) => (&[][..], choice.variants.as_slice()),
            Self::Wrapper(..) | Self::IntEnum(_) | Self::TextEnum(_) => (&[][..], &[][..]),
        };
        fields.iter().chain(variants.iter().flat_map(|variant| &variant.fields))
    }
}

/// One value of an enum.
#[derive(Debug, Clone, PartialEq)]
pub struct EnumValue<T> {
    /// The value on the wire.
    pub wire: T,
    /// Variant name in Rust.
    pub name: String,
    /// Meaning of the value.
    pub doc: String,
    /// True if only newer firmware takes it.
    pub advisory: bool,
    /// First and last firmware that takes it.
    pub versions: Versions,
    /// Sources of what the document does not say.
    pub evidence: Vec<Evidence>,
}

impl<T> EnumValue<T> {
    fn undescribe(&mut self) {
        self.doc.clear();
        self.evidence.clear();
        (self.advisory, self.versions) = (false, Versions::default());
    }
}

/// A code that the controller answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ErrorCode {
    /// The number.
    pub wire: i64,
    /// Name in Rust.
    pub name: String,
    /// The message seen with it, if it is always the same.
    pub message: Option<String>,
    /// Meaning of the code.
    pub doc: String,
}

/// Events of the controller, as `errcode` reports them: codes of one severity that are explained alike.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Event {
    /// Severity of the events.
    pub severity: Severity,
    /// The codes, in the order of the file. No code is in two events.
    pub codes: Vec<RangeInclusive<u32>>,
    /// Explanation in English, from sources about these codes.
    pub texts: EventTexts,
    /// Explanation in Chinese. It has no text that the English one lacks.
    pub texts_zh: EventTexts,
    /// Name of the family whose cause and remedy hold where no source about the codes states them.
    pub family: Option<String>,
}

/// Explanation of events, or of a family of events. Each text is phrases on one line, without full stop.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct EventTexts {
    /// Description of the event.
    pub meaning: Option<String>,
    /// Possible causes of the event.
    pub cause: Option<String>,
    /// Remedies. None of them acts on the arm before somebody has looked at it.
    pub remedy: Option<String>,
}

/// Family of events, such as brakes: causes and remedies for events without a source of their own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EventFamily {
    /// Name of the family in the spec.
    pub name: String,
    /// Texts in English. The family has a meaning, which is its title, and a remedy.
    pub texts: EventTexts,
    /// Texts in Chinese.
    pub texts_zh: EventTexts,
}

impl Event {
    /// True if the code is one of its codes.
    pub fn has(&self, code: u32) -> bool {
        self.codes.iter().any(|range| range.contains(&code))
    }

    /// Joint of the code, counted from 1, if the event has one code for each of six joints.
    pub fn joint(&self, code: u32) -> Option<usize> {
        let joints: Vec<_> = self.codes().collect();
        let is_of_joints =
            joints.len() == 6 && joints.windows(2).all(|pair| pair[1].checked_sub(pair[0]) == Some(0x1_0000));
        joints.iter().position(|of_joint| *of_joint == code).filter(|_| is_of_joints).map(|index| index + 1)
    }

    /// Its codes, one by one.
    pub fn codes(&self) -> impl Iterator<Item = u32> {
        self.codes.iter().cloned().flatten()
    }

    /// Leaves it these of its codes.
    pub(crate) fn retain(&mut self, keep: impl Fn(u32) -> bool) {
        let mut ranges: Vec<RangeInclusive<u32>> = Vec::new();
        for code in self.codes().filter(|code| keep(*code)) {
            match ranges.last_mut() {
                Some(range) if range.end().checked_add(1) == Some(code) => *range = *range.start()..=code,
                _ => ranges.push(code..=code),
            }
        }
        self.codes = ranges;
    }
}

toml_words! {
    /// Severity of a controller's event.
    ///
    /// The severity is the vendor's and does not say whether the arm moves: an emergency stop is information. The
    /// other fields of the status packet say whether the arm is stopped. For a program that waits for the end of a
    /// motion the rule is: an error ends the wait; a warning and information are reported and end nothing; an unknown
    /// event ends the wait only together with an arm at rest or a stop that the status packet shows.
    pub enum Severity {
        /// Something failed.
        Error: "error",
        /// Something may fail, or was not done.
        Warning: "warning",
        /// Something happened.
        Information: "information",
    }
}

/// A refusal in the controller's own words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// `errorCode`.
    pub code: i64,
    /// `errorMsg`.
    pub message: String,
}

/// A request and its reply, as JSON text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Example {
    /// The request, if the document prints it.
    pub request: Option<String>,
    /// The reply, if the document prints it.
    pub reply: Option<String>,
    /// True if values of the request are ours: the document prints placeholders, or nothing.
    pub request_is_ours: bool,
    /// True if values of the reply are ours.
    pub reply_is_ours: bool,
}

/// True for fields that are nothing but floats: a struct of them converts from and into an array.
pub fn is_floats(fields: &[Field]) -> bool {
    fields.iter().all(|field| field.ty == Type::Scalar(Scalar::Float) && !field.optional && !field.or_raw)
}

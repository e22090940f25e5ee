//! Compares what `diff` says with what the compiler says.

use jaka_spec::tools::{Difference, Impact};
use jaka_spec::{EnumValue, Field, Request, Spec, Type, TypeKind, Variant, is_floats};

/// Moment at which a major change is noticed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Noticed {
    /// A program does not compile any more.
    Compiling,
    /// A program compiles, and acts otherwise.
    Running,
}

/// Impact of the changes in one direction, and the compiler's verdict on programs of the older spec.
#[derive(Debug)]
pub(crate) struct Verdict {
    pub(crate) impact: Option<Impact>,
    pub(crate) compiles: bool,
    /// Texts of the changes that are major for the compiler.
    breaking: Vec<String>,
}

impl Verdict {
    pub(crate) fn new(old: &Spec, new: &Spec, changes: &[Difference], compiles: bool) -> Self {
        let is_breaking =
            |change: &&Difference| change.impact == Impact::Major && noticed(old, new, change) == Noticed::Compiling;
        let breaking = changes.iter().filter(is_breaking).map(ToString::to_string).collect();
        Self { impact: jaka_spec::tools::impact(changes), compiles, breaking }
    }

    /// Disagreement of `diff` and the compiler, if there is one.
    pub(crate) fn problem(&self) -> Option<String> {
        match (self.compiles, self.breaking.is_empty()) {
            (true, true) | (false, false) => None,
            (true, false) => Some(format!("every program compiles, in spite of {}", self.breaking.join("; "))),
            (false, true) => Some("a program does not compile, and no change says why".to_owned()),
        }
    }

    /// `major, does not compile`, or the like.
    pub(crate) fn words(&self) -> String {
        let impact = self.impact.map_or_else(|| "no difference".to_owned(), |impact| impact.to_string());
        match (self.impact, self.compiles) {
            (Some(Impact::Major), true) => format!("{impact} at run time, compiles"),
            (_, true) => format!("{impact}, compiles"),
            (_, false) => format!("{impact}, does not compile"),
        }
    }
}

/// Disagreement on additions, if there is one, by the compiler's verdict on programs of the newer spec with the crate
/// of the older one.
pub(crate) fn addition_problem(
    old: &Spec,
    new: &Spec,
    changes: &[Difference],
    new_with_old_compiles: bool,
) -> Option<String> {
    let impact = jaka_spec::tools::impact(changes);
    let adds = changes.iter().find(|change| is_seen_addition(old, new, change));
    match (new_with_old_compiles, impact, adds) {
        (false, None | Some(Impact::Patch), _) => {
            Some("a program uses what the older spec does not have, and no change says so".to_owned())
        }
        (true, _, Some(adds)) => {
            Some(format!("a program of the newer spec compiles with the older one, in spite of {adds}"))
        }
        _ => None,
    }
}

/// True for something that is there after the change alone, and that programs can name.
fn is_seen_addition(old: &Spec, new: &Spec, change: &Difference) -> bool {
    let is_event = change.place.starts_with("event `");
    match &*change.what {
        _ if change.impact == Impact::Patch => false,
        // What has another key or number on the wire was there before under the same name.
        "added" => !is_event && !is_other_on_wire(new, old, &change.place),
        "becomes `Copy`" | "gets a constructor for each value" => true,
        _ => false,
    }
}

/// Beginnings of the texts of changes that are major, and when each is noticed.
///
/// The list is complete: a text that is missing here ends the program.
const NOTICED: &[(&str, Noticed)] = &[
    ("name changed", Noticed::Compiling),
    ("topic changed", Noticed::Compiling),
    ("type changed", Noticed::Compiling),
    ("type of the reply", Noticed::Compiling),
    ("becomes optional", Noticed::Compiling),
    ("is no longer optional", Noticed::Compiling),
    ("may have another shape", Noticed::Compiling),
    ("can no longer have another shape", Noticed::Compiling),
    ("no longer has constructors", Noticed::Compiling),
    ("is no longer `Copy`", Noticed::Compiling),
    ("motion removed", Noticed::Compiling),
    ("the request becomes a choice", Noticed::Compiling),
    ("the request is no longer a choice", Noticed::Compiling),
    // Or, between an object and an array with the same fields, a reply that was read is an error.
    ("kind changed", Noticed::Compiling),
    ("added", Noticed::Compiling),
    ("removed", Noticed::Compiling),
    // Constructors take their arguments in this order, which only types that differ show.
    ("order of the", Noticed::Compiling),
    ("its setter takes the name of the constructor", Noticed::Compiling),
    ("functions take nothing that converts into it", Noticed::Compiling),
    ("constructors are no longer `const`", Noticed::Compiling),
    ("the method takes", Noticed::Compiling),
    // A number that was sent or read means something else.
    ("unit changed", Noticed::Running),
    // A request that was sent is refused.
    ("range ", Noticed::Running),
    ("advised range ", Noticed::Running),
    ("takes printable ASCII only", Noticed::Running),
    ("only newer firmware takes it", Noticed::Running),
    // The module of a pack, which is not compiled here, has another trait.
    ("source for a robot", Noticed::Running),
    // A reply that was read is an error.
    ("the reply is certain now", Noticed::Running),
    ("the session ends with it", Noticed::Running),
    ("bare reply ", Noticed::Running),
    ("an array with further elements becomes an error", Noticed::Running),
];

fn noticed(old: &Spec, new: &Spec, change: &Difference) -> Noticed {
    let listed = NOTICED.iter().find(|(text, _)| change.what.starts_with(text));
    let (text, noticed) = listed.unwrap_or_else(|| panic!("`{change}` is not in the list of major changes"));
    let is_noticed_running = match *text {
        "removed" => is_other_on_wire(old, new, &change.place),
        "added" => is_other_on_wire(new, old, &change.place),
        "kind changed" => is_same_struct(old, new, &change.place),
        "order of the" => required_types(old, &change.place) == required_types(new, &change.place),
        _ => false,
    };
    if is_noticed_running { Noticed::Running } else { *noticed }
}

/// True for an item of a spec that has another key or number on the wire in another spec, under the same name and with
/// the same type in Rust. The place is that of a change such as ``command `joint_move`, request field `speed` ``.
fn is_other_on_wire(spec: &Spec, other: &Spec, place: &str) -> bool {
    let Some((_, last)) = steps(place).pop() else { return false };
    let items = wires(spec, place);
    let item = items.iter().find(|(wire, _)| *wire == last);
    item.is_some_and(|(_, item)| wires(other, place).iter().any(|(wire, rust)| *wire != last && rust == item))
}

/// True for a struct that becomes an array or an object, and stays the same in Rust. Arrays of nothing but numbers are
/// made and converted in ways of their own.
fn is_same_struct(old: &Spec, new: &Spec, place: &str) -> bool {
    let steps = steps(place);
    let [(_, name)] = steps.as_slice() else { return false };
    let fields = |spec: &Spec| match &spec[spec.type_id(name)?].kind {
        TypeKind::Object(fields) => Some((fields.clone(), false)),
        TypeKind::Array { fields, .. } => Some((fields.clone(), is_floats(fields))),
        _ => None,
    };
    let (Some((was, was_numbers)), Some((is, is_numbers))) = (fields(old), fields(new)) else { return false };
    let is_made = old.type_id(name).is_some_and(|id| old.is_sent(id));
    let names = |spec, fields: &[Field]| fields.iter().map(|field| rust(spec, field)).collect::<Vec<_>>();
    names(old, &was) == names(new, &is) && !was_numbers && !(is_numbers && is_made)
}

/// The types that the constructors of what stands at a place take, in their order.
fn required_types(spec: &Spec, place: &str) -> Vec<String> {
    let steps = steps(place);
    let steps: Vec<_> = steps.iter().map(|(noun, name)| (&**noun, &**name)).collect();
    let kind = |name| spec.type_id(name).map(|id| &spec[id].kind);
    let variant = |variants: &[Variant], tag: &str| {
        let found = variants.iter().find(|variant| variant.wire.to_string() == tag);
        found.map(|variant| variant.fields.clone())
    };
    let fields = match steps.as_slice() {
        [("command", wire)] => match spec.command(wire).map(|command| &command.request) {
            Some(Request::Fields(fields)) => Some(fields.clone()),
            _ => None,
        },
        [("command", wire), ("variant", tag)] => {
            spec.command(wire).and_then(|command| variant(command.variants(), tag))
        }
        [("type", name)] => match kind(name) {
            Some(TypeKind::Object(fields) | TypeKind::Array { fields, .. }) => Some(fields.clone()),
            _ => None,
        },
        [("type", name), ("variant", tag)] => match kind(name) {
            Some(TypeKind::Choice(choice)) => variant(&choice.variants, tag),
            _ => None,
        },
        _ => None,
    };
    let fields = fields.unwrap_or_else(|| panic!("`{place}` has no fields"));
    let required = fields.iter().filter(|field| !field.optional);
    required.map(|field| format!("{} {}", rust_type(spec, field), field.or_raw)).collect()
}

/// Items at a place: the key or number of each on the wire, and its name and type in Rust.
fn wires(spec: &Spec, place: &str) -> Vec<(String, String)> {
    let steps = steps(place);
    let steps: Vec<_> = steps.iter().map(|(noun, name)| (&**noun, &**name)).collect();
    let fields = |fields: &[Field]| fields.iter().map(|field| (field.wire.clone(), rust(spec, field))).collect();
    let variants = |variants: &[Variant]| {
        let pair = |variant: &Variant| {
            let fields: Vec<_> = variant.fields.iter().map(|field| rust(spec, field)).collect();
            (variant.wire.to_string(), format!("{} {fields:?}", variant.name))
        };
        variants.iter().map(pair).collect()
    };
    match steps.as_slice() {
        [("command", _)] => {
            let commands = spec.topics.iter().flat_map(|topic| {
                topic.commands.iter().map(move |command| {
                    let fields: Vec<_> = command.fields().map(|field| rust(spec, field)).collect();
                    (command.wire.clone(), format!("{}::{} {fields:?}", topic.name, command.name))
                })
            });
            commands.collect()
        }
        [("error code", _)] => spec.errors().map(|error| (error.wire.to_string(), error.name.clone())).collect(),
        [("command", wire), rest @ ..] => {
            let Some(command) = spec.command(wire) else { return Vec::new() };
            match (rest, &command.request) {
                ([("request field", _)], Request::Fields(list)) => fields(list),
                ([("reply field", _)], _) => fields(command.reply.own_fields()),
                ([("variant", _)], Request::Choice(choice)) => variants(&choice.variants),
                ([("variant", tag), ("field", _)], Request::Choice(choice)) => {
                    of_variant(&choice.variants, tag, fields)
                }
                _ => Vec::new(),
            }
        }
        [("type", name), rest @ ..] => {
            let Some(id) = spec.type_id(name) else { return Vec::new() };
            match (rest, &spec[id].kind) {
                ([("field", _)], TypeKind::Object(list)) => fields(list),
                ([("variant", _)], TypeKind::Choice(choice)) => variants(&choice.variants),
                ([("value", _)], TypeKind::IntEnum(values)) => self::values(values),
                ([("value", _)], TypeKind::TextEnum(values)) => self::values(values),
                _ => Vec::new(),
            }
        }
        _ => Vec::new(),
    }
}

fn values<T: std::fmt::Display>(values: &[EnumValue<T>]) -> Vec<(String, String)> {
    values.iter().map(|value| (value.wire.to_string(), value.name.clone())).collect()
}

fn of_variant(
    variants: &[Variant],
    tag: &str,
    fields: impl Fn(&[Field]) -> Vec<(String, String)>,
) -> Vec<(String, String)> {
    let variant = variants.iter().find(|variant| variant.wire.to_string() == tag);
    variant.map(|variant| fields(&variant.fields)).unwrap_or_default()
}

/// A field as Rust sees it: its name and type, and whether it may be left out.
fn rust(spec: &Spec, field: &Field) -> String {
    let ty = rust_type(spec, field);
    format!("{}: {ty} {} {} {}", field.name, field.optional, field.or_raw, field.constructors)
}

fn rust_type(spec: &Spec, field: &Field) -> String {
    match &field.ty {
        Type::Python(inner) => spec.notation(inner),
        ty => spec.notation(ty),
    }
}

/// The nouns and names of a place.
fn steps(place: &str) -> Vec<(String, String)> {
    let mut parts = place.split('`');
    let mut steps = Vec::new();
    while let (Some(noun), Some(name)) = (parts.next(), parts.next()) {
        steps.push((noun.trim_matches([',', ' ']).to_owned(), name.to_owned()));
    }
    steps
}

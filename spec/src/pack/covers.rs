//! Comparison of a pack's items with the spec's present ones.
//!
//! A program that uses the pack can use the spec's item in its place where the spec's item covers the pack's: the
//! program's code compiles as before and means the same. That is so where the spec has all names, types and units of
//! the pack, and no further argument. Other facts of the spec, such as another range, apply then.

use crate::model::{Choice, Command, EnumValue, Field, Reply, Request, TypeDef, TypeId, TypeKind, Variant};
use crate::spec::Spec;

/// Nothing, or what the spec has otherwise, to be read after "there".
type Covers = Result<(), String>;

/// Checks that the command `known` of the spec covers the pack's.
pub(super) fn command(spec: &Spec, known: &Command, new: &Command) -> Covers {
    match (&known.request, &new.request) {
        (Request::Fields(known), Request::Fields(new)) => made(known, new)?,
        (Request::Choice(known), Request::Choice(new)) => choice(known, new)?,
        _ => return Err("its request has another form".to_owned()),
    }
    match (&known.reply, &new.reply) {
        (known, new) if known == new => Ok(()),
        (Reply::Fields(known), Reply::Fields(new)) => received(known, new),
        (Reply::Object(id), _) => Err(format!("its reply is a `{}`", spec[*id].name)),
        (Reply::Raw, _) => Err("its reply is raw JSON".to_owned()),
        (Reply::Fields(_), _) => Err("its reply has fields of its own".to_owned()),
    }
}

/// Checks that the type `known` of the spec covers the pack's.
pub(super) fn type_def(spec: &Spec, known: TypeId, new: &TypeDef) -> Covers {
    let fields = if spec.is_sent(known) { made } else { received };
    match (&spec[known].kind, &new.kind) {
        (TypeKind::Object(known), TypeKind::Object(new)) => fields(known, new),
        (TypeKind::Array { fields: known, .. }, TypeKind::Array { fields: new, .. }) => {
            let is_begun = known.iter().map(|field| &field.name).zip(new).all(|(known, new)| *known == new.name);
            if is_begun { fields(known, new) } else { Err("its elements have another order".to_owned()) }
        }
        (TypeKind::IntEnum(known), TypeKind::IntEnum(new)) => values(known, new),
        (TypeKind::TextEnum(known), TypeKind::TextEnum(new)) => values(known, new),
        (TypeKind::Choice(known), TypeKind::Choice(new)) => choice(known, new),
        (TypeKind::Wrapper(known, known_unit), TypeKind::Wrapper(new, new_unit)) => {
            let is_same = known.is_alike(new) && same_unit(known_unit.as_ref(), new_unit.as_ref());
            if is_same { Ok(()) } else { Err("it is around something else".to_owned()) }
        }
        _ => Err("it is of another kind".to_owned()),
    }
}

/// Fields of what a program makes by a constructor of those that are required.
fn made(known: &[Field], new: &[Field]) -> Covers {
    let required = |fields: &[Field]| -> Vec<String> {
        fields.iter().filter(|field| !field.optional).map(|field| field.name.clone()).collect()
    };
    if required(known) != required(new) {
        return Err(format!("the required fields are {}", quoted(&required(known))));
    }
    received(known, new)
}

/// Fields of what a program only receives.
fn received(known: &[Field], new: &[Field]) -> Covers {
    new.iter().try_for_each(|new| {
        let same = known.iter().find(|known| known.name == new.name);
        match same {
            Some(known) => field(known, new),
            None => Err(format!("it has no field `{}`", new.name)),
        }
    })
}

/// Checks that a field of the spec covers the pack's field of the same name in Rust.
pub(super) fn field(known: &Field, new: &Field) -> Covers {
    let name = &new.name;
    if known.wire != new.wire {
        Err(format!("`{name}` is the key `{}`", known.wire))
    } else if !known.ty.is_alike(&new.ty) || known.or_raw != new.or_raw {
        Err(format!("its field `{name}` has another type"))
    } else if known.optional != new.optional {
        Err(format!("its field `{name}` is {}", if known.optional { "optional" } else { "always there" }))
    } else if !same_unit(known.unit.as_ref(), new.unit.as_ref()) {
        Err(format!("its field `{name}` has another unit"))
    } else if new.constructors && !known.constructors {
        Err(format!("its field `{name}` has no constructors"))
    } else {
        Ok(())
    }
}

fn choice(known: &Choice, new: &Choice) -> Covers {
    new.variants.iter().try_for_each(|new| {
        let same = known.variants.iter().find(|known| known.name == new.name);
        same.map_or_else(|| Err(format!("it has no variant `{}`", new.name)), |known| variant(known, new))
    })
}

/// Checks that a variant of the spec covers the pack's variant of the same name.
pub(super) fn variant(known: &Variant, new: &Variant) -> Covers {
    if known.wire != new.wire {
        return Err(format!("`{}` stands for {}", new.name, known.wire));
    }
    made(&known.fields, &new.fields)
}

fn values<T: PartialEq>(known: &[EnumValue<T>], new: &[EnumValue<T>]) -> Covers {
    let is_there = |new: &EnumValue<T>| known.iter().any(|known| known.name == new.name && known.wire == new.wire);
    new.iter().find(|new| !is_there(new)).map_or(Ok(()), |new| Err(format!("`{}` is not that value", new.name)))
}

/// True unless the same number means something else.
fn same_unit(known: Option<&String>, new: Option<&String>) -> bool {
    known.is_none() || new.is_none() || known == new
}

fn quoted(names: &[String]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

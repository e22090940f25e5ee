//! Advised limits of a field's numbers, in addition to its range.

use crate::item::Item;
use crate::model::{Field, Type, TypeDef, TypeKind};
use crate::range::{Advice, Condition};
use crate::scalar::Scalar;

/// The rows of `advised`.
pub(crate) fn read(item: &Item<'_, '_>) -> Vec<Advice> {
    item.items("advised", "`advised`").iter().map(row).collect()
}

fn row(item: &Item<'_, '_>) -> Advice {
    let max = item.number("max").filter(|max| max.value > 0.0);
    if max.is_none() {
        item.error(item.at, "`max` is the greatest magnitude, a number over 0");
    }
    let text = |key| item.text(key).map(|text| text.value);
    let when = match (text("when"), item.int("is").map(|is| is.value)) {
        (Some(field), Some(value)) => Some(Condition { field, value }),
        (None, None) => None,
        _ => {
            item.error(item.at, "`when` names a field and `is` its value: give both or neither");
            None
        }
    };
    let advice = Advice {
        max: max.map_or(1.0, |max| max.value),
        nonzero: item.flag("nonzero").is_some_and(|flag| flag.value),
        unit: text("unit"),
        when,
        per: text("per"),
    };
    item.finish();
    advice
}

/// Mistake in the advised limits of these neighbouring fields; `types` are all types.
pub(crate) fn problem(fields: &[Field], types: &[TypeDef]) -> Option<String> {
    fields.iter().find_map(|field| {
        let problem = field.advised.iter().enumerate().find_map(|(index, advice)| {
            let mut before = field.advised[..index].iter().filter(|other| meet(other, advice));
            let problem = before.find_map(|other| clash(other, advice));
            problem.or_else(|| row_problem(field, advice, fields, types))
        });
        problem.map(|problem| format!("`advised` of `{}`: {problem}", field.name))
    })
}

/// True if both can hold at the same time.
fn meet(a: &Advice, b: &Advice) -> bool {
    a.when == b.when || a.when.is_none() || b.when.is_none()
}

/// Reason why two rows cannot hold at the same time.
fn clash(a: &Advice, b: &Advice) -> Option<String> {
    if a.when.is_some() != b.when.is_some() {
        return Some("all rows have a `when`, or none".to_owned());
    }
    if a.per != b.per {
        return Some("rows that hold at the same time have the same `per`".to_owned());
    }
    let is_apart = a.unit.is_some() && b.unit.is_some() && a.unit != b.unit;
    (!is_apart).then(|| "rows that hold at the same time have each a `unit` of their own".to_owned())
}

fn row_problem(field: &Field, advice: &Advice, fields: &[Field], types: &[TypeDef]) -> Option<String> {
    let mut units = Vec::new();
    numbers(&field.ty, field.unit.as_deref(), types, &mut units);
    if !units.iter().any(|unit| advice.unit.is_none() || *unit == advice.unit.as_deref()) {
        let unit = advice.unit.as_ref().map(|unit| format!(" in {unit}")).unwrap_or_default();
        return Some(format!("the field has no number{unit}"));
    }
    if field.wire.is_empty() {
        return Some("it is for fields that have a key".to_owned());
    }
    let condition = field.advised.iter().find_map(|first| first.when.as_ref());
    let other =
        advice.when.as_ref().zip(condition).and_then(|(when, first)| {
            (when.field != first.field).then(|| "all rows depend on the same field".to_owned())
        });
    let sibling = |name: &str| fields.iter().find(|other| other.name == name && !other.or_raw);
    let when = advice.when.as_ref().filter(|when| {
        let selector = sibling(&when.field).filter(|selector| !selector.optional);
        !selector.is_some_and(|selector| has_value(&selector.ty, when.value, types))
    });
    let when = when.map(|Condition { field, value }| {
        format!("there is no field `{field}` that is always there and an enum with the value {value}")
    });
    let is_count = |name: &str| sibling(name).is_some_and(|count| count.ty == Type::Scalar(Scalar::Int));
    let per = advice.per.as_ref().filter(|name| !is_count(name));
    let per = per.map(|name| format!("there is no field `{name}` that is a whole number"));
    other.or(when).or(per)
}

/// The units of the numbers in a type; a wrapper's own one counts before that of the field.
fn numbers<'t>(ty: &'t Type, unit: Option<&'t str>, types: &'t [TypeDef], units: &mut Vec<Option<&'t str>>) {
    match ty {
        Type::Scalar(scalar) if scalar.is_number() => units.push(unit),
        Type::Scalar(_) | Type::Python(_) => {}
        Type::List(element) | Type::Array(element, _) => numbers(element, unit, types, units),
        Type::Named(id) => match &types[id.0].kind {
            TypeKind::Wrapper(inner, own) => numbers(inner, own.as_deref().or(unit), types, units),
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => {
                let outer = fields.iter().filter(|field| field.advised.is_empty());
                outer.for_each(|field| numbers(&field.ty, field.unit.as_deref(), types, units));
            }
            TypeKind::IntEnum(_) | TypeKind::TextEnum(_) | TypeKind::Choice(_) => {}
        },
    }
}

fn has_value(ty: &Type, wire: i64, types: &[TypeDef]) -> bool {
    let Type::Named(id) = ty else { return false };
    matches!(&types[id.0].kind, TypeKind::IntEnum(values) if values.iter().any(|value| value.wire == wire))
}

/// Follows a field that gets another name in Rust.
pub(crate) fn rename(fields: &mut [Field], old: &str, new: &str) {
    for advice in fields.iter_mut().flat_map(|field| &mut field.advised) {
        let names = advice.when.as_mut().map(|when| &mut when.field).into_iter().chain(&mut advice.per);
        names.filter(|name| *name == old).for_each(|name| new.clone_into(name));
    }
}

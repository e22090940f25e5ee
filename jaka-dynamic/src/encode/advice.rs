//! What is advised of a field's numbers, by the values of the fields next to it.

use jaka_proto::check::{Advice, AdvisoryRanges};
use jaka_spec::{Field, Shape, Spec};
use serde_json::Value;

use super::is_value;

/// The rows that hold, and how many times their bounds are meant.
pub(super) struct Rows<'a> {
    pub(super) list: Vec<Advice<'a>>,
    pub(super) times: Option<i64>,
}

/// What is advised of a field, which stands among `fields` with `values`: nothing where that is left to the controller.
pub(super) fn rows<'a>(
    spec: &Spec,
    fields: &[Field],
    (field, ranges): (&'a Field, AdvisoryRanges),
    values: &[Option<&Value>],
) -> Rows<'a> {
    let sibling = |name: &String| {
        let at = fields.iter().position(|other| other.name == *name)?;
        Some((&fields[at], values[at]?))
    };
    let holds = |advice: &&jaka_spec::Advice| {
        ranges == AdvisoryRanges::Enforced
            && advice.when.as_ref().is_none_or(|when| {
                sibling(&when.field).is_some_and(|(selector, value)| is_selected(spec, selector, value, when.value))
            })
    };
    let held: Vec<_> = field.advised.iter().filter(holds).collect();
    let count = held.first().and_then(|advice| sibling(advice.per.as_ref()?));
    let times = count.and_then(|(_, value)| value.as_i64());
    let row = |advice: &&'a jaka_spec::Advice| Advice {
        max: advice.max,
        nonzero: advice.nonzero,
        unit: advice.unit.as_deref().unwrap_or_default(),
    };
    Rows { list: held.iter().map(row).collect(), times }
}

/// True if the value given for an enum is the one with this number.
fn is_selected(spec: &Spec, selector: &Field, value: &Value, wire: i64) -> bool {
    let Shape::IntEnum(values) = spec.shape(&selector.ty) else { return false };
    values.iter().any(|listed| listed.wire == wire && is_value(value, wire, &listed.name))
}

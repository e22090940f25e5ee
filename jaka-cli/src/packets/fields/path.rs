//! Paths to fields, as typed by people.

use itertools::Itertools as _;
use jaka_dynamic::Label;
use jaka_spec::Shape;
use jaka_spec::words::distance;

use super::Field;

/// Greatest number of suggestions.
const MOST: usize = 3;

/// Follows a path from the packet.
pub(super) fn find(packet: Field, path: &str) -> Result<Field, String> {
    let mut found = packet;
    for segment in path.trim().split('.') {
        let (name, indices) = segment.split_at(segment.find('[').unwrap_or(segment.len()));
        found = named(&found, name)?;
        for index in parse_indices(indices)
            .ok_or_else(|| format!("`{segment}` is not a name, or a name with an index such as `name[0]`"))?
        {
            found = at(&found, index)?;
        }
    }
    Ok(found)
}

/// Returns the part of this name, in Rust or on the wire.
fn named(parent: &Field, name: &str) -> Result<Field, String> {
    let mut members = parent.members();
    if members.is_empty() {
        return Err(format!("the status field `{}` has no named parts, so it has no `{name}`", parent.name));
    }
    let by_name = members.iter().position(|member| names(member).next() == Some(name));
    let found = by_name.or_else(|| members.iter().position(|member| names(member).any(|known| known == name)));
    found.map(|at| members.swap_remove(at)).ok_or_else(|| {
        let of = if parent.name.is_empty() { String::new() } else { format!(" in `{}`", parent.name) };
        format!("there is no status field `{name}`{of}; {}", hint(name, members.iter().flat_map(names)))
    })
}

/// Returns the name in Rust, and the key on the wire if there is one.
fn names(member: &Field) -> impl Iterator<Item = &str> {
    let Label::Field(field) = member.place.label() else { return [None; 2].into_iter().flatten() };
    [Some(&*field.name), Some(&*field.wire).filter(|wire| !wire.is_empty())].into_iter().flatten()
}

/// Returns the element at an index.
fn at(list: &Field, index: usize) -> Result<Field, String> {
    let Some(Shape::List(_, count)) = list.place.shape() else {
        return Err(format!("the status field `{}` is not a list", list.name));
    };
    list.element(index).ok_or_else(|| {
        let count = count.unwrap_or_default();
        format!("the status field `{}` has {count} elements, 0 to {}", list.name, count.saturating_sub(1))
    })
}

/// Parses the numbers of `[1][2]`.
fn parse_indices(text: &str) -> Option<Vec<usize>> {
    if text.is_empty() {
        return Some(Vec::new());
    }
    let inner = text.strip_prefix('[')?.strip_suffix(']')?;
    inner.split("][").map(|index| index.parse().ok()).collect()
}

/// Returns a hint at similar names, or at the command that shows all fields.
fn hint<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
    let similar = names.filter_map(|name| Some((unlikeness(wanted, name)?, name))).sorted().dedup();
    match similar.take(MOST).map(|(_, name)| format!("`{name}`")).join(", ").as_str() {
        "" => "`jaka status --fields all` shows them all".to_owned(),
        similar => format!("similar names: {similar}"),
    }
}

/// Returns the number of different letters, if that is few; names that contain the wanted one come after those.
fn unlikeness(wanted: &str, name: &str) -> Option<usize> {
    let few = wanted.len() / 4 + 1;
    let apart = distance(wanted, name);
    if apart <= few {
        return Some(apart);
    }
    (wanted.len() >= 3 && name.contains(wanted)).then_some(few + name.len())
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn check(path: &str, expected: &Expect) {
        let found = find(Field::packet(), path);
        expected.assert_eq(&found.map_or_else(|error| error, |field| field.name));
    }

    #[test]
    fn names_of_the_wire_become_those_of_rust() {
        check("inpos", &expect!["in_position"]);
        check("monitor_data.joints[2].torque", &expect!["monitor_data.joints[2].torque"]);
        check("torqsensor.state.contact_force[5]", &expect!["torque_sensor.state.contact_force[5]"]);
    }

    #[test]
    fn errors_name_what_is_near() {
        check(
            "joint_actul_position",
            &expect![
                "there is no status field `joint_actul_position`; similar names: `joint_actual_position`, `joint_position`"
            ],
        );
        check(
            "digital",
            &expect![
                "there is no status field `digital`; similar names: `digital_inputs`, `digital_outputs`, `tool_digital_inputs`"
            ],
        );
        check("zzzzzz", &expect!["there is no status field `zzzzzz`; `jaka status --fields all` shows them all"]);
        check(
            "actual_position.w",
            &expect!["there is no status field `w` in `actual_position`; similar names: `x`, `y`, `z`"],
        );
        check("joint_actual_position[6]", &expect!["the status field `joint_actual_position` has 6 elements, 0 to 5"]);
        check("enabled[0]", &expect!["the status field `enabled` is not a list"]);
        check("enabled.x", &expect!["the status field `enabled` has no named parts, so it has no `x`"]);
        check("din[x]", &expect!["`din[x]` is not a name, or a name with an index such as `name[0]`"]);
        check("", &expect!["there is no status field ``; `jaka status --fields all` shows them all"]);
    }
}

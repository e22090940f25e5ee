//! Names in the spellings that people type: in kebab-case, in any case, or misspelt.

use jaka_spec::Field;
use jaka_spec::words::distance;

/// Returns a name in kebab-case: `jog_mode`, `jogMode` and `JogMode` become `jog-mode`.
pub(super) fn kebab(name: &str) -> String {
    let mut kebab = String::with_capacity(name.len() + 4);
    let mut inside_word = false;
    for c in name.chars() {
        if !c.is_alphanumeric() || c.is_uppercase() && inside_word {
            kebab.push('-');
        }
        kebab.extend(c.to_lowercase().filter(|c| c.is_alphanumeric()));
        inside_word = c.is_lowercase() || c.is_numeric();
    }
    kebab
}

/// Whether two names differ only by case and by the characters between words.
pub(super) fn same(a: &str, b: &str) -> bool {
    bare(a) == bare(b)
}

fn bare(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// Returns the field with the key `key`: its wire spelling, or else its Rust name.
pub(super) fn field_of<'f>(fields: &'f [Field], key: &str) -> Option<&'f Field> {
    let by_wire = fields.iter().find(|field| field.wire == key && !key.is_empty());
    by_wire.or_else(|| fields.iter().find(|field| field.name == key))
}

/// Suggests the known fields with names similar to that of an unknown field, or else all known fields.
pub(super) fn suggestion<'k>(name: &str, known: impl Iterator<Item = [&'k str; 2]>) -> String {
    let known: Vec<_> = known.collect();
    let near = |spelling: &str| {
        let (spelling, name) = (bare(spelling), bare(name));
        distance(&spelling, &name) <= spelling.chars().count().max(name.chars().count()) / 3
    };
    let nearest: Vec<_> = known.iter().filter(|names| names.iter().any(|name| near(name))).map(quoted).collect();
    match (nearest.is_empty(), known.is_empty()) {
        (false, _) => format!("did you mean {}?", nearest.join(" or ")),
        (true, false) => format!("the fields are {}", known.iter().map(quoted).collect::<Vec<_>>().join(", ")),
        (true, true) => "there are no fields".to_owned(),
    }
}

fn quoted(names: &[&str; 2]) -> String {
    format!("`{}`", names[0])
}

#[cfg(test)]
mod tests {
    use super::{kebab, suggestion};

    #[test]
    fn names_of_any_style_become_kebab_case() {
        let names = ["jog_mode", "jogMode", "JointLowPass", "EthernetIp", "X", "Brand10", "enabled status"];
        let kebabs = names.map(kebab);
        let expected = ["jog-mode", "jog-mode", "joint-low-pass", "ethernet-ip", "x", "brand10", "enabled-status"];
        assert_eq!(kebabs, expected);
    }

    #[test]
    fn near_names_are_suggested_and_all_where_none_is_near() {
        let known = || [["speed", "speed"], ["acceleration", "accel"]].into_iter();
        assert_eq!(suggestion("sped", known()), "did you mean `speed`?");
        assert_eq!(suggestion("Accell", known()), "did you mean `acceleration`?");
        assert_eq!(suggestion("tolerance", known()), "the fields are `speed`, `acceleration`");
        assert_eq!(suggestion("speed", [].into_iter()), "there are no fields");
    }
}

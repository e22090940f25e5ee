//! Names: those that Rust takes, conversions between their forms, and the one that is most like another.

/// Words that cannot name a field, a method, a module or a variant.
const KEYWORDS: &[&str] = &[
    "as", "async", "await", "box", "break", "const", "continue", "crate", "do", "dyn", "else", "enum", "extern",
    "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut",
    "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "Self", "abstract", "become", "macro",
];
/// Names that generated code uses for its own variables, and so cannot be a field's.
pub(crate) const RESERVED_FIELDS: &[&str] = &["reader", "key", "out", "place", "limits"];
/// Names of the prelude and of generated items, which cannot be a type's.
pub(crate) const RESERVED_TYPES: &[&str] = &[
    "AsRef",
    "Box",
    "Clone",
    "Client",
    "Copy",
    "Debug",
    "Default",
    "Eq",
    "Err",
    "Error",
    "From",
    "Into",
    "None",
    "Ok",
    "Option",
    "PartialEq",
    "Request",
    "Result",
    "Sized",
    "Some",
    "String",
    "Vec",
];
/// Names of methods that a client, a robot or every value has, which hide those of a pack.
pub(crate) const RESERVED_METHODS: &[&str] = &[
    "acknowledge",
    "call",
    "call_raw",
    "call_text",
    "call_within",
    "check_firmware",
    "client",
    "configure",
    "disconnect_cause",
    "enter_servo_mode",
    "explain",
    "firmware",
    "follow",
    "into",
    "last_reply",
    "limit_warning",
    "limits",
    "monitor",
    "peer_addr",
    "pipeline",
    "power_down",
    "power_down_with",
    "power_up",
    "power_up_with",
    "preflight",
    "reply_timeout",
    "run",
    "set_firmware",
    "start",
    "start_follow",
    "stop_handle",
    "stream",
    "try_clone",
    "try_into",
    "unacknowledged",
    "wait",
    "wait_for_analog",
    "wait_for_input",
    "wait_for_rest",
];
/// Names of Rust's own crates and types, which the module of a pack would hide from the user's code.
pub(crate) const RESERVED_MODULES: &[&str] = &[
    "alloc",
    "bool",
    "char",
    "core",
    "f32",
    "f64",
    "i8",
    "i16",
    "i32",
    "i64",
    "i128",
    "isize",
    "jaka_sync",
    "std",
    "str",
    "u8",
    "u16",
    "u32",
    "u64",
    "u128",
    "usize",
];

/// True for a name such as `joint_move` that can be a field, a method or a module.
pub fn is_snake(name: &str) -> bool {
    let mut bytes = name.bytes();
    bytes.next().is_some_and(|b| b.is_ascii_lowercase())
        && bytes.all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
        && !name.ends_with('_')
        && !name.contains("__")
        && !KEYWORDS.contains(&name)
}

/// True for a name such as `JointMove` that can be a type or a variant.
pub(crate) fn is_camel(name: &str) -> bool {
    let mut bytes = name.bytes();
    bytes.next().is_some_and(|b| b.is_ascii_uppercase())
        && bytes.all(|b| b.is_ascii_alphanumeric())
        && !KEYWORDS.contains(&name)
}

/// `joint_move` becomes `JointMove`.
pub fn to_camel(snake: &str) -> String {
    let mut camel = String::with_capacity(snake.len());
    for word in snake.split('_') {
        let mut chars = word.chars();
        camel.extend(chars.next().map(|c| c.to_ascii_uppercase()));
        camel.push_str(chars.as_str());
    }
    camel
}

/// The trait with the methods of the pack that this module is made of.
pub(crate) fn trait_name(module: &str) -> String {
    to_camel(module) + "Commands"
}

/// `TcpIp` becomes `tcp_ip`.
pub fn to_snake(camel: &str) -> String {
    to_screaming(camel).to_ascii_lowercase()
}

/// `PermissionDenied` becomes `PERMISSION_DENIED`.
pub fn to_screaming(camel: &str) -> String {
    let mut name = String::with_capacity(camel.len() + 4);
    for c in camel.chars() {
        if c.is_ascii_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.push(c.to_ascii_uppercase());
    }
    name
}

/// The known name that is most like `name`, if one is at all.
pub fn nearest<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let most = name.len().div_ceil(3);
    let len = name.chars().count();
    // No name is nearer than the difference of the lengths: a very long one is excluded immediately.
    let known = known.filter(|known| known.chars().count().abs_diff(len) <= most);
    let distances = known.map(|known| (distance(name, known), known));
    distances.filter(|(distance, _)| *distance <= most).min().map(|(_, known)| known)
}

/// Number of characters that must be put in, taken out or changed to turn one name into the other.
pub fn distance(one: &str, other: &str) -> usize {
    let mut row: Vec<usize> = (0..=other.chars().count()).collect();
    for (i, a) in one.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in other.chars().enumerate() {
            let changed = diagonal + usize::from(!a.eq_ignore_ascii_case(&b));
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row.last().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_levenshtein() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("Same", "same"), 0);
    }
}

//! Which names Rust takes, and how one becomes the other.

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
    "Some",
    "String",
    "Vec",
];

/// True for a name such as `joint_move` that can be a field, a method or a module.
pub(crate) fn is_snake(name: &str) -> bool {
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

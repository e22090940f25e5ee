//! Values without parts: their names, and the abilities of their types in Rust.

/// The type of one value without parts in the spec.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Scalar {
    /// A truth value, with the JSON texts that stand for false and true.
    Bool {
        /// JSON text of false.
        off: String,
        /// JSON text of true.
        on: String,
    },
    /// A whole number.
    Int,
    /// A floating-point number.
    Float,
    /// A string.
    Text,
    /// Any JSON.
    Json,
}

impl Scalar {
    /// The scalar of this name in the TOML files.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let boolean = Self::Bool { off: "false".to_owned(), on: "true".to_owned() };
        [boolean, Self::Int, Self::Float, Self::Text, Self::Json].into_iter().find(|scalar| scalar.name() == name)
    }

    /// Its name in the TOML files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Bool { .. } => "bool",
            Self::Int => "int",
            Self::Float => "float",
            Self::Text => "text",
            Self::Json => "json",
        }
    }

    /// True for a number, which may have a unit and a range.
    pub fn is_number(&self) -> bool {
        match self {
            Self::Int | Self::Float => true,
            Self::Bool { .. } | Self::Text | Self::Json => false,
        }
    }

    /// True if its type in Rust is `Copy`.
    pub(crate) fn is_copy(&self) -> bool {
        match self {
            Self::Bool { .. } | Self::Int | Self::Float => true,
            Self::Text | Self::Json => false,
        }
    }

    /// The two words, without quotes, for a truth value that is not read as usual: one in words of its own, such as
    /// `robot_enabled`, or one whose 0 means true.
    pub fn truth_words(&self) -> Option<[&str; 2]> {
        let Self::Bool { off, on } = self else { return None };
        let [off, on] = [off, on].map(|form| form.trim_matches('"'));
        let is = |form: &str, word: &str| form.eq_ignore_ascii_case(word);
        let is_usual = (is(off, "false") || is(off, "0")) && (is(on, "true") || is(on, "1"));
        (!is_usual).then_some([off, on])
    }
}

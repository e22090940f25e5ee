#![doc = include_str!("../README.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]
// On the host of the documentation each item says which feature it needs.
#![cfg_attr(docsrs, feature(doc_cfg))]

/// An enum whose values are words of the TOML files. jaka-proto-derive makes the enum of jaka-proto from it.
macro_rules! toml_words {
    ($(#[doc = $doc:literal])+ pub enum $type:ident {
        $($(#[doc = $of_value:literal])+ $variant:ident: $word:literal),+ $(,)?
    }) => {
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $type {
            $($(#[doc = $of_value])+ $variant),+
        }

        impl $type {
            /// Words of the TOML files, each with its value.
            pub(crate) const WORDS: &'static [(&'static str, Self)] = &[$(($word, Self::$variant)),+];

            /// The enum and its values, with their docs.
            pub const WORD_ENUM: $crate::WordEnum = $crate::WordEnum {
                name: stringify!($type),
                doc: &[$($doc),+],
                values: &[$((stringify!($variant), $word, concat!($($of_value),+))),+],
            };

            /// Word of the TOML files.
            pub fn word(self) -> &'static str {
                match self {
                    $(Self::$variant => $word),+
                }
            }

            /// Name of the variant in Rust.
            pub fn variant(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($variant)),+
                }
            }

            /// Docs of the value, on one line.
            pub fn doc(self) -> &'static str {
                match self {
                    $(Self::$variant => concat!($($of_value),+).trim_ascii_start()),+
                }
            }
        }
    };
}

mod advice;
mod builtin;
mod evidence;
mod files;
mod item;
mod keys;
mod meaning;
mod model;
mod names;
mod needed;
mod pack;
pub mod prose;
mod range;
mod read;
mod report;
mod resolve;
mod role;
mod scalar;
mod spec;
#[cfg(feature = "tools")]
pub mod tools;
mod type_text;
mod unit;
mod version;
pub mod words;

use std::collections::BTreeMap;

pub use builtin::{BUILTIN, builtin};
pub use evidence::{Evidence, Mark, evidence_sentence};
pub use files::{LONGEST_TEXT, open_regular, read_at_most, read_file, read_text, text_of};
pub use keys::{COMMAND_NAME, ENVELOPE, ERROR_CODE, ERROR_MESSAGE};
pub use model::{
    Choice, Command, Effect, EnumValue, ErrorCode, Event, EventFamily, EventTexts, Example, Field, Refusal, Reply,
    Request, Requirement, Severity, Topic, Type, TypeDef, TypeId, TypeKind, Variant, is_floats,
};
pub use names::{is_snake, to_camel, to_screaming, to_snake};
pub use needed::{FieldSource, NEEDED_FIELDS, NeededField, NeededSource};
pub use pack::{Module, Pack, load_pack};
pub use range::{Advice, Condition, Range};
pub use report::{Error, Errors};
pub use role::{Change, JOINT_POSITION, Motion, MotionMode, POSE, PathKind, Role};
pub use scalar::Scalar;
pub use spec::{Shape, Spec};
pub use unit::unit_factor;
pub use version::{Version, Versions};

/// An enum whose values are words of the TOML files, with its docs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WordEnum {
    /// Name of the enum.
    pub name: &'static str,
    /// Lines of its docs.
    pub doc: &'static [&'static str],
    /// Name of each variant, its word and its docs.
    pub values: &'static [(&'static str, &'static str, &'static str)],
}

/// A TOML file: the path that errors name, and its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source<'s> {
    /// The path that errors name. Its stem is the topic's name.
    pub path: &'s str,
    /// The file's text.
    pub text: &'s str,
}

impl Source<'_> {
    /// An error at an offset into the text, in bytes.
    pub fn error(self, offset: usize, message: impl Into<String>) -> Error {
        report::At { source: self, offset }.error(message)
    }
}

/// Loads a spec from its files, or says everything that is wrong with it.
///
/// # Errors
/// One [`Error`] for each thing that is wrong, at its line and column.
pub fn load(sources: &[Source<'_>]) -> Result<Spec, Errors> {
    let report = report::Report::default();
    let mut index = resolve::Index::default();
    let topics = sources.iter().map(|source| read::topic(*source, &mut index, &report)).collect();
    resolve::check(&index, &report);
    report.finish()?;
    Ok(Spec { topics, types: index.finish(), built_in: None, status_lines: BTreeMap::new() })
}

#![doc = include_str!("../README.md")]

mod advice;
mod builtin;
mod envelope;
mod item;
mod model;
mod names;
mod pack;
pub mod prose;
mod quote;
mod range;
mod read;
mod report;
mod resolve;
mod scalar;
mod shape;
mod similar;
#[cfg(feature = "tools")]
pub mod tools;
mod type_text;
mod unique;
mod version;
pub mod words;

pub use builtin::{BUILTIN, builtin};
pub use envelope::{COMMAND_NAME, ENVELOPE, ERROR_CODE, ERROR_MESSAGE};
#[doc(hidden)]
pub use item::{Item, Placed};
pub use model::{
    Choice, Command, Effect, EnumValue, ErrorCode, Event, Example, Field, Refusal, Reply, Request, Requirement,
    Severity, Spec, Topic, Type, TypeDef, TypeId, TypeKind, Variant,
};
pub use names::{is_snake, to_camel, to_screaming, to_snake};
pub use pack::{Module, Pack, load_pack};
pub use range::{Advice, Condition, Range};
#[doc(hidden)]
pub use report::At;
pub use report::{Error, Errors};
pub use scalar::Scalar;
pub use shape::{Shape, is_floats};
pub use version::{Version, Versions};

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
        At { source: self, offset }.error(message)
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
    Ok(Spec { topics, types: index.finish() })
}

/// Reads a TOML file of another kind: for jaka-motion.
///
/// # Errors
/// One [`Error`] for each thing that is wrong, as `read` finds it, and for each key that it does not ask for.
#[doc(hidden)]
pub fn read_toml<T>(source: Source<'_>, read: impl FnOnce(&Item<'_, '_>) -> T) -> Result<T, Errors> {
    let report = report::Report::default();
    let table = item::parse(source, &report);
    let file = Item::new(String::new(), At { source, offset: 0 }, table.get_ref(), &report);
    let found = read(&file);
    file.finish();
    report.finish().map(|()| found)
}

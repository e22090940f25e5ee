#![doc = include_str!("../README.md")]

mod advice;
mod builtin;
mod form;
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
mod robot_status;
mod role;
mod scalar;
mod shape;
#[cfg(feature = "tools")]
pub mod tools;
mod type_text;
mod unit;
mod version;
pub mod words;

use std::collections::BTreeMap;

pub use builtin::{BUILTIN, builtin};
pub use keys::{COMMAND_NAME, ENVELOPE, ERROR_CODE, ERROR_MESSAGE};
pub use model::{
    Choice, Command, Effect, EnumValue, ErrorCode, Event, Example, Field, Form, FormKind, Refusal, Reply, Request,
    Requirement, Severity, Spec, Topic, Type, TypeDef, TypeForm, TypeId, TypeKind, Variant,
};
pub use names::{is_snake, to_camel, to_screaming, to_snake};
pub use needed::{NEEDED_FIELDS, NeededField};
pub use pack::{Module, Pack, load_pack};
pub use range::{Advice, Condition, Range};
pub use report::{Error, Errors};
pub use robot_status::{FieldSource, NeededSource};
pub use role::{Change, JOINT_POSITION, Motion, MotionMode, POSE, PathKind, Role};
pub use scalar::Scalar;
pub use shape::{Shape, is_floats};
pub use unit::{Factors, unit_factor};
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

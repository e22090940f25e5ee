//! What can be made from a spec beside code.
//!
//! With the feature `tools`.
//!
//! ```
//! use jaka_spec::tools;
//!
//! let spec = jaka_spec::builtin()?;
//! assert!(tools::diff(&spec, &spec).is_empty());
//! # Ok::<(), jaka_spec::Errors>(())
//! ```

mod diff;
mod words;

pub use diff::{Change, Impact, diff, impact};

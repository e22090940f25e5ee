//! Products of a spec other than code: a comparison with another spec, a reference to read, a JSON Schema.
//!
//! With the feature `tools`.
//!
//! ```
//! use jaka_spec::tools;
//!
//! let spec = jaka_spec::builtin()?;
//! assert!(tools::diff(&spec, &spec).is_empty());
//! assert!(tools::reference(&spec).contains("### 4.7 `joint_move`"));
//! assert_eq!(tools::schema(&spec)["$defs"]["request.joint_move"]["properties"]["speed"]["minimum"], 0);
//! # Ok::<(), jaka_spec::Errors>(())
//! ```

mod diff;
mod reference;
mod schema;

pub use diff::{Difference, Impact, diff, impact, summary};
pub use reference::{events, events_zh, reference, reference_zh};
pub use schema::schema;

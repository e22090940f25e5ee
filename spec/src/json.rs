//! Messages as JSON by the model alone, for commands that were not compiled in.
//!
//! [`request`] writes a request as the generated code does, [`arguments`] and [`value`] are what a command line needs
//! for it, [`check_request`] and [`sample_reply`] what a simulated controller needs, and [`departures`] says how a
//! controller's reply differs from the spec.
//!
//! ```
//! use jaka_spec::json::{self, AdvisoryRanges};
//! use serde_json::json;
//!
//! let spec = jaka_spec::builtin()?;
//! let command = spec.command("joint_move").expect("the protocol has it");
//! let mut fields = serde_json::Map::new();
//! fields.insert("mode".to_owned(), json!("absolute"));
//! fields.insert("joint_position".to_owned(), json!([0, 90, 90, 90, -90, 0]));
//! fields.insert("speed".to_owned(), json!(-20));
//! let problems = json::request(&spec, command, &fields, AdvisoryRanges::Enforced).unwrap_err();
//! assert_eq!(problems[0].to_string(), "field `speed` is -20; allowed is a number, at least 0 deg/s");
//!
//! fields.insert("speed".to_owned(), json!(20));
//! assert_eq!(
//!     json::request(&spec, command, &fields, AdvisoryRanges::Enforced),
//!     Ok(r#"{"cmdName":"joint_move","relFlag":0,"jointPosition":[0,90,90,90,-90,0],"speed":20}"#.to_owned())
//! );
//! # Ok::<(), jaka_spec::Errors>(())
//! ```

mod arguments;
mod check;
mod decode;
mod departure;
mod encode;
mod envelope;
mod limits;
mod names;
mod notation;
mod problem;
mod python;
mod sample;
mod scalar;
mod text;
mod value;
mod whole;

pub use crate::envelope::{COMMAND_NAME, ENVELOPE};
pub use arguments::{Argument, PossibleValue, arguments};
pub use check::check_request;
pub use departure::{Departure, DepartureKind, Reading};
pub use encode::request;
pub use envelope::{departures, status_departures};
pub use limits::AdvisoryRanges;
pub use notation::notation;
pub use problem::{Problem, ProblemKind};
pub use sample::{complete_reply, sample_reply};
pub use value::value;

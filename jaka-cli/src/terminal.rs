//! Terminal of this program: keys, questions, results, warnings, logs and exit codes.

pub(crate) mod console;
pub(crate) mod exit;
pub(crate) mod logging;
pub(crate) mod output;
pub(crate) mod question;

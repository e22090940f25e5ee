//! Options of the benchmarks on the command line.

use std::error::Error;

/// The number that follows `name`, or `default` where it is not given.
///
/// # Errors
/// What follows is not a number.
pub fn number(name: &str, default: u32) -> Result<u32, Box<dyn Error>> {
    let Some(text) = std::env::args().skip_while(|argument| argument != name).nth(1) else { return Ok(default) };
    text.parse().map_err(|_| format!("{name} takes a number, not `{text}`").into())
}

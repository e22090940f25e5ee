//! Numbers for people, and for JSON.

use std::time::Duration;

/// Formats a number with this many decimals, without a sign if it rounds to 0: noise around 0 would flicker.
pub(crate) fn fixed(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    let is_zero = text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}

/// Returns seconds to the millisecond, for JSON.
pub(crate) fn seconds(time: Duration) -> f64 {
    rounded(time.as_secs_f64())
}

/// Milliseconds to the microsecond.
pub(crate) fn milliseconds(time: Duration) -> f64 {
    rounded(time.as_secs_f64() * 1e3)
}

/// Rounds a number to three decimals. Below 2^43, it is printed with them.
fn rounded(number: f64) -> f64 {
    (number * 1e3).round() / 1e3
}

/// Formats a count, such as `1 request` and `2 requests`.
pub(crate) fn count(number: usize, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{plural}")
}

/// Reads a position or a distance, in mm or degrees. A million is far beyond any arm and any frame.
pub(crate) fn place(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| number.abs() <= 1e6);
    number.ok_or_else(|| "not a number from -1e6 to 1e6".to_owned())
}

/// Reads a speed, an acceleration or a tolerance.
pub(crate) fn rate(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number| (1e-3..=1e9).contains(number));
    number.ok_or_else(|| "not a number from 0.001 to 1e9".to_owned())
}

/// Reads the tolerance of a corner; 0 for a stop there.
pub(crate) fn corner(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number| *number == 0.0 || (1e-3..=1e9).contains(number));
    number.ok_or_else(|| "not 0 or a number from 0.001 to 1e9".to_owned())
}

/// Reads six positions.
pub(crate) fn six(text: &str) -> Result<[f64; 6], String> {
    let words: Result<[&str; 6], _> = text.split(',').map(str::trim).collect::<Vec<_>>().try_into();
    let needed = |_| "six numbers with commas between them are needed, such as 0,90,90,90,-90,0".to_owned();
    let mut numbers = [0.0; 6];
    for (number, word) in numbers.iter_mut().zip(words.map_err(needed)?) {
        *number = place(word).map_err(|why| format!("`{word}` is {why}"))?;
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_three_decimals() {
        let time = Duration::from_nanos(2_794_873_340);
        assert_eq!([seconds(time), milliseconds(time)].map(|number| number.to_string()), ["2.795", "2794.873"]);
        assert_eq!(seconds(Duration::from_millis(1)).to_string(), "0.001");
    }

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(fixed(-0.0004, 3), "0.000");
        assert_eq!(fixed(-0.0006, 3), "-0.001");
        assert_eq!(fixed(-10.0, 0), "-10");
    }
}

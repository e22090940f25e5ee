//! Times as typed by people: seconds, with or without a fraction.

use std::time::Duration;

/// Reads seconds, 0 or more.
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let number = text.parse::<f64>().map_err(|_| "not a number of seconds".to_owned())?;
    from_number(number)
}

/// Reads seconds, more than 0.
pub(crate) fn some_seconds(text: &str) -> Result<Duration, String> {
    seconds(text).and_then(not_zero)
}

/// Reads seconds, more than 0, from a number in a config file.
pub(crate) fn from_file<'de, D: serde::Deserializer<'de>>(source: D) -> Result<Option<Duration>, D::Error> {
    use serde::{Deserialize, de::Error};
    let number = f64::deserialize(source)?;
    from_number(number).and_then(not_zero).map(Some).map_err(D::Error::custom)
}

/// Limit of more than thirty years: a longer time is a mistake, and overflows some functions for times.
const LONGEST: f64 = 1e9;

fn from_number(number: f64) -> Result<Duration, String> {
    if number > LONGEST {
        return Err(format!("{number} is more than {LONGEST} seconds"));
    }
    Duration::try_from_secs_f64(number).map_err(|_| format!("{number} is not a valid number of seconds"))
}

fn not_zero(time: Duration) -> Result<Duration, String> {
    if time.is_zero() { Err("must be more than 0 seconds".to_owned()) } else { Ok(time) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_finite_and_not_negative() {
        assert_eq!(seconds("0.25"), Ok(Duration::from_millis(250)));
        assert_eq!(seconds("0"), Ok(Duration::ZERO));
        for bad in ["-1", "nan", "inf", "1e300", "1e19", "2s", ""] {
            assert!(seconds(bad).is_err(), "{bad}");
        }
        assert!(some_seconds("0").is_err());
        assert_eq!(some_seconds("1e9"), Ok(Duration::from_secs(1_000_000_000)));
    }
}

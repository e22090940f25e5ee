//! Whole numbers in unusual forms.

/// The whole number that `text` holds, also with a fraction of zero or an exponent. It is read digit by digit: a float
/// on the way would round, up or down to a whole number too.
pub(crate) fn whole(text: &str) -> Option<i64> {
    if let Ok(int) = text.parse() {
        return Some(int);
    }
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let (int, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let power = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if mantissa.len() == usize::from(mantissa.contains('.')) || power.is_empty() {
        return None;
    }
    if ![int, fraction, power].into_iter().all(are_digits) {
        return None;
    }
    let (value, zeros) = significant(int.bytes().chain(fraction.bytes()))?;
    if value == 0 {
        return Some(0);
    }
    let shift = exponent.parse::<i64>().ok()?.checked_sub(i64::try_from(fraction.len()).ok()?)?;
    let value = shifted(value, u32::try_from(shift.checked_add(zeros.into())?).ok()?)?;
    Some(if text.starts_with('-') { -value } else { value })
}

/// With a fraction or an exponent, only numbers that a float tells from each other: so other programs read them, and
/// write them.
const BELOW: i64 = 1 << 53;

/// The number that decimal digits make without the zeros at their end, and how many these are.
fn significant(digits: impl Iterator<Item = u8>) -> Option<(i64, u32)> {
    let (mut value, mut zeros) = (0, 0_u32);
    for digit in digits {
        zeros = zeros.checked_add(1)?;
        if digit != b'0' {
            let before = if value == 0 { 0 } else { shifted(value, zeros)? };
            value = before + i64::from(digit - b'0');
            zeros = 0;
        }
    }
    Some((value, zeros))
}

/// The value with this many zeros appended.
fn shifted(value: i64, zeros: u32) -> Option<i64> {
    let shifted = 10_i64.checked_pow(zeros).and_then(|power| value.checked_mul(power));
    shifted.filter(|shifted| *shifted < BELOW)
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn numbers_that_are_whole_are_exact() {
        for (text, expected) in [
            ("0", 0),
            ("-0.0", 0),
            ("0e999999999999999999999", 0),
            ("+7", 7),
            ("1e3", 1000),
            ("-1.50e1", -15),
            ("1200e-2", 12),
            ("0.00012e+5", 12),
            ("100000000000000000000000000000e-29", 1),
            ("5.", 5),
            (".5e1", 5),
            ("9007199254740991.000", 9_007_199_254_740_991),
            ("9223372036854775807", i64::MAX),
            ("-9223372036854775808", i64::MIN),
        ] {
            assert_eq!(whole(text), Some(expected), "{text}");
        }
    }

    #[test]
    fn numbers_that_are_not_are_none() {
        for text in [
            "",
            "-",
            ".",
            "e5",
            "1e",
            "1e+",
            "1.5",
            "1e-1",
            "1e-400",
            "0.99999999999999999999",
            "4503599627370497.2",
            "9007199254740992.0",
            "9007199254740993.0",
            "9007199254740993e0",
            "90071992547409930e-1",
            "1e19",
            "1e300",
            "10000000000000000000000001.0",
            "1e99999999999999999999",
            "1e-99999999999999999999",
            "9223372036854775808",
            "inf",
            "nan",
            "0x10",
            "--1",
            "1.-5",
            "1.5.0",
            "1e5e5",
            "\u{661}",
        ] {
            assert_eq!(whole(text), None, "{text}");
        }
    }
}

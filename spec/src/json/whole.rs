//! Whole numbers in unusual forms, as jaka-proto reads them.

/// The whole number that `text` holds, also with a fraction of zero or an exponent. It is read digit by digit: a float on the way
/// would round, up or down to a whole number too.
pub(super) fn whole(text: &str) -> Option<i64> {
    let text = text.trim();
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

/// With a fraction or an exponent, only numbers that a float tells from each other: so other programs read them, and write them.
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

/// The value with so many zeros behind it.
fn shifted(value: i64, zeros: u32) -> Option<i64> {
    let shifted = 10_i64.checked_pow(zeros).and_then(|power| value.checked_mul(power));
    shifted.filter(|shifted| *shifted < BELOW)
}

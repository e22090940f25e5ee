//! Numbers in their usual form, read without a detour over their text.

mod whole;

use super::Decode;
pub(super) use whole::whole;

/// A value that can be read at once where it is written in its usual form.
pub(super) trait Scalar: Decode + Copy + Default {
    /// The value at the front of `bytes` and its length; `None` for any other form, which is left to [`Decode`].
    fn usual(bytes: &[u8]) -> Option<(Self, usize)>;
}

/// Takes values in their usual form and the commas between them, as many as follow each other, and gives each to
/// `take`; tells how many they are, and the length of all without a comma after the last.
#[inline]
pub(super) fn run<T: Scalar>(bytes: &[u8], mut take: impl FnMut(T)) -> (usize, usize) {
    let mut count = 0;
    let mut end = 0;
    let mut next = 0;
    while let Some((value, len)) = bytes.get(next..).and_then(T::usual) {
        take(value);
        count += 1;
        end = next + len;
        next = match bytes[end..] {
            [b',', b' ', ..] => end + 2,
            [b',', ..] => end + 1,
            _ => break,
        };
    }
    (count, end)
}

/// Truth written as 0 and 1, or as a word.
impl Scalar for bool {
    #[inline]
    fn usual(bytes: &[u8]) -> Option<(Self, usize)> {
        match bytes {
            [digit @ (b'0' | b'1'), next, ..] if !is_part(*next) => Some((*digit == b'1', 1)),
            [b't', b'r', b'u', b'e', ..] => Some((true, 4)),
            [b'f', b'a', b'l', b's', b'e', ..] => Some((false, 5)),
            _ => None,
        }
    }
}

/// Up to 18 digits.
impl Scalar for i64 {
    #[inline]
    fn usual(bytes: &[u8]) -> Option<(Self, usize)> {
        let sign = usize::from(bytes.first() == Some(&b'-'));
        let mut at = sign;
        let mut value = 0;
        while let Some(digit) = digit(bytes, at).filter(|_| at < sign + 18) {
            value = value * 10 + i64::from(digit);
            at += 1;
        }
        let ends = at > sign && !is_part(*bytes.get(at)?);
        ends.then_some((if sign == 1 { -value } else { value }, at))
    }
}

/// Up to 19 digits, with or without a fraction, and without an exponent; correctly rounded.
impl Scalar for f64 {
    #[inline]
    fn usual(bytes: &[u8]) -> Option<(Self, usize)> {
        let sign = usize::from(bytes.first() == Some(&b'-'));
        let (mut digits, mut end) = take_digits(bytes, sign, 0);
        let mut count = end - sign;
        let mut fraction = 0;
        if count == 0 {
            return None;
        }
        if bytes.get(end) == Some(&b'.') {
            let start = end + 1;
            (digits, end) = take_eights(bytes, start, digits);
            (digits, end) = take_digits(bytes, end, digits);
            fraction = end - start;
            count += fraction;
            if fraction == 0 {
                return None;
            }
        }
        if count > 19 || is_part(*bytes.get(end)?) {
            return None;
        }
        let value = quotient(digits, fraction)?;
        Some((if sign == 1 { -value } else { value }, end))
    }
}

/// `digits` by 10 to the power of `fraction`, correctly rounded.
#[inline]
fn quotient(digits: u64, fraction: usize) -> Option<f64> {
    #[expect(clippy::cast_precision_loss, reason = "up to 2^53 each whole number has a float of its own")]
    if digits <= 1 << 53 {
        // Both are exact, so the one division rounds once.
        return POWERS.get(fraction).map(|power| digits as f64 / power);
    }
    long_quotient(digits, fraction)
}

/// Divides as [`quotient`] does, for more than 53 bits: by whole numbers, with enough bits that the last one can stand
/// for the remainder.
#[inline(never)]
fn long_quotient(digits: u64, fraction: usize) -> Option<f64> {
    // 2^53 · 2^64 / 10^18 is more than 2^57: the last bit lies below the one that decides how to round.
    let power = *WHOLE_POWERS.get(fraction)?;
    let dividend = u128::from(digits) << 64;
    let quotient = dividend / u128::from(power);
    let rest = u128::from(quotient * u128::from(power) != dividend);
    #[expect(clippy::cast_precision_loss, reason = "this is where it is rounded, once")]
    Some((quotient | rest) as f64 * TWO_TO_MINUS_64)
}

const TWO_TO_MINUS_64: f64 = 1.0 / 18_446_744_073_709_551_616.0;

/// Powers of ten, as far as the quotient has bits enough.
const WHOLE_POWERS: [u64; 19] = {
    let mut powers = [1; 19];
    let mut at = 1;
    while at < powers.len() {
        powers[at] = 10 * powers[at - 1];
        at += 1;
    }
    powers
};

/// Powers of ten as floats, which hold them exactly.
const POWERS: [f64; 19] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18];

/// Whether a number cannot end before this byte.
#[inline]
pub(super) fn is_part(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9' | b'-' | b'+' | b'.' | b'e' | b'E')
}

#[inline]
fn digit(bytes: &[u8], at: usize) -> Option<u8> {
    bytes.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10)
}

/// Takes digits from `at` on: `value` with them appended, which wraps around after the 19th, and where they end.
#[inline]
fn take_digits(bytes: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(digit) = digit(bytes, at) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

/// Takes digits as [`take_digits`] does, but eight at once, as long as eight digits follow.
#[inline]
fn take_eights(bytes: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(eight) = bytes.get(at..).and_then(|rest| rest.first_chunk()).copied().and_then(eight_digits) {
        value = value.wrapping_mul(100_000_000).wrapping_add(eight);
        at += 8;
    }
    (value, at)
}

/// The number that eight digits make, or `None` if they are not all digits.
#[inline]
fn eight_digits(text: [u8; 8]) -> Option<u64> {
    // A byte for each digit; then a pair of bytes for two, four for four, eight for eight.
    let ones = u64::from_le_bytes(text) ^ 0x3030_3030_3030_3030;
    if (ones.wrapping_add(0x0606_0606_0606_0606) | ones) & 0xf0f0_f0f0_f0f0_f0f0 != 0 {
        return None;
    }
    let twos = (ones * 10).wrapping_add(ones >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = (twos * 100).wrapping_add(twos >> 16) & 0x0000_ffff_0000_ffff;
    Some((fours * 10_000).wrapping_add(fours >> 32) & 0xffff_ffff)
}

/// The length of the number at the front of `bytes`: everything that can be part of one.
pub(super) fn length(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| is_part(**byte)).count()
}

/// Whether the text of a number is one: `-7`, `1.5e-3`, and whatever else [`str::parse`] takes for a float.
pub(super) fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    plain || text.parse::<f64>().is_ok()
}

#[cfg(test)]
mod tests;

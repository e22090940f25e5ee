//! Search for a few bytes that are usually near.

use memchr::{memchr2, memchr3};

/// Up to this length eight bytes at a time are faster than a call of `memchr`.
const NEAR: usize = 24;

const ONES: u64 = 0x0101_0101_0101_0101;

/// The place of the first byte that is one of these.
#[inline]
pub(crate) fn first_of<const N: usize>(wanted: [u8; N], bytes: &[u8]) -> Option<usize> {
    let mut at = 0;
    while let Some(eight) = bytes.get(at..).and_then(|rest| rest.first_chunk()).filter(|_| at < NEAR) {
        let found = marks(wanted, u64::from_le_bytes(*eight));
        if found != 0 {
            return Some(at + found.trailing_zeros() as usize / 8);
        }
        at += 8;
    }
    far(wanted, &bytes[at..]).map(|found| at + found)
}

/// The length of the text in front of a quote, if neither an escape nor a control character comes before.
#[inline]
pub(crate) fn plain_text(bytes: &[u8]) -> Option<usize> {
    let mut at = 0;
    while let Some(eight) = bytes.get(at..).and_then(|rest| rest.first_chunk()) {
        let eight = u64::from_le_bytes(*eight);
        // A byte below 0x20 borrows, and so perhaps does the one after it.
        let controls = eight.wrapping_sub(ONES << 5) & !eight & (ONES << 7);
        let found = marks(*b"\"\\", eight) | controls;
        if found != 0 {
            at += found.trailing_zeros() as usize / 8;
            return (bytes[at] == b'"').then_some(at);
        }
        at += 8;
    }
    let ends = |byte: &u8| *byte < 0x20 || matches!(byte, b'"' | b'\\');
    let end = at + bytes[at..].iter().position(ends)?;
    (bytes[end] == b'"').then_some(end)
}

/// The highest bit of each of eight bytes that is wanted, and perhaps of some after the first such.
#[inline]
fn marks<const N: usize>(wanted: [u8; N], eight: u64) -> u64 {
    let found = wanted.iter().fold(0, |found, wanted| {
        let differs = eight ^ (ONES * u64::from(*wanted));
        found | (differs.wrapping_sub(ONES) & !differs)
    });
    found & (ONES << 7)
}

fn far<const N: usize>(wanted: [u8; N], bytes: &[u8]) -> Option<usize> {
    match *wanted.as_slice() {
        [a, b] => memchr2(a, b, bytes),
        [a, b, c] => memchr3(a, b, c, bytes),
        _ => bytes.iter().position(|byte| wanted.contains(byte)),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_first_one_is_found(bytes in prop::collection::vec(prop_oneof![prop::sample::select(b"\"\\{}!#".to_vec()), any::<u8>()], 0..80)) {
            let place = |wanted: &[u8]| bytes.iter().position(|byte| wanted.contains(byte));
            prop_assert_eq!(first_of(*b"\"\\", &bytes), place(b"\"\\"));
            prop_assert_eq!(first_of(*b"\"{}", &bytes), place(b"\"{}"));
            prop_assert_eq!(first_of(*b"\"'()", &bytes), place(b"\"'()"));
            prop_assert_eq!(first_of([0, 255], &bytes), place(&[0, 255]));
        }

        #[test]
        fn plain_text_ends_at_a_quote(text in "[a-z\\x00-\\x2f\\\\\u{80}-\u{ff}]{0,30}") {
            let is_end = |c: char| c < ' ' || c == '"' || c == '\\';
            let expected = text.find(is_end).filter(|at| text[*at..].starts_with('"'));
            prop_assert_eq!(plain_text(text.as_bytes()), expected);
        }

        #[test]
        fn it_is_found_after_others(before in prop::collection::vec(any::<u8>(), 0..80), wanted in any::<[u8; 2]>()) {
            let bytes: Vec<_> = before.into_iter().filter(|byte| !wanted.contains(byte)).chain([wanted[1]]).collect();
            prop_assert_eq!(first_of(wanted, &bytes), Some(bytes.len() - 1));
        }
    }
}

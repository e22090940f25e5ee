//! Decoding of JSON into values. It is lenient, since controllers write the same value in many forms.

use super::number::{Scalar, whole};
use super::reader::{Mark, Reader};
use super::{Decode, DecodeError};

/// Implements [`Decode`] for a scalar, which is read in its usual form at once, and lists of it in one go.
macro_rules! scalar {
    ($(#[$doc:meta])* $type:ty, $unusual:ident) => {
        $(#[$doc])*
        impl Decode for $type {
            #[inline]
            fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
                if let Some(value) = reader.usual() { Ok(value) } else { $unusual(reader) }
            }

            fn decode_list(list: &mut Vec<Self>, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
                scalar_list(list, reader)
            }

            fn decode_array<const N: usize>(reader: &mut Reader<'_>) -> Result<[Self; N], DecodeError> {
                scalar_array(reader)
            }
        }
    };
}

scalar! {
    /// A number, or a string that holds one. Correctly rounded; never NaN or infinite.
    f64, unusual_float
}

#[inline(never)]
fn unusual_float(reader: &mut Reader<'_>) -> Result<f64, DecodeError> {
    let start = reader.mark();
    let value = reader.scalar()?.and_then(|text| text.parse::<f64>().ok());
    value.filter(|value| value.is_finite()).ok_or_else(|| unfit(reader, start, "a number"))
}

scalar! {
    /// A whole number, or a string that holds one. With a fraction (of zero) or an exponent it must be less than 2^53;
    /// it is never rounded.
    i64, unusual_int
}

#[inline(never)]
fn unusual_int(reader: &mut Reader<'_>) -> Result<i64, DecodeError> {
    let start = reader.mark();
    let value = reader.scalar()?.and_then(|text| whole(&text));
    value.ok_or_else(|| unfit(reader, start, "a whole number"))
}

scalar! {
    /// `true` and `false`, 0 and 1, or a string that holds one of these, in any case.
    bool, unusual_truth
}

#[inline(never)]
fn unusual_truth(reader: &mut Reader<'_>) -> Result<bool, DecodeError> {
    let start = reader.mark();
    let value = match reader.scalar()? {
        Some(text) if text.eq_ignore_ascii_case("true") => Some(true),
        Some(text) if text.eq_ignore_ascii_case("false") => Some(false),
        Some(text) => whole(&text).and_then(zero_or_one),
        None => None,
    };
    value.ok_or_else(|| unfit(reader, start, "a truth value"))
}

fn zero_or_one(int: i64) -> Option<bool> {
    match int {
        0 => Some(false),
        1 => Some(true),
        _ => None,
    }
}

impl Decode for String {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.text().map(std::borrow::Cow::into_owned)
    }

    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        let text = reader.text()?;
        self.clear();
        self.push_str(&text);
        Ok(())
    }
}

impl<T: Decode> Decode for Vec<T> {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut list = Self::new();
        T::decode_list(&mut list, reader)?;
        Ok(list)
    }

    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        T::decode_list(self, reader)
    }
}

/// Exactly `N` values: neither is one made up nor one dropped.
impl<T: Decode, const N: usize> Decode for [T; N] {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        T::decode_array(reader)
    }
}

/// A list of numbers or truth values.
fn scalar_list<T: Scalar>(list: &mut Vec<T>, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
    list.clear();
    reader.begin_array()?;
    while reader.next_element()? {
        if reader.usual_run(|value| list.push(value)) == 0 {
            list.push(T::decode(reader).map_err(|error| error.in_element(list.len()))?);
        }
    }
    Ok(())
}

/// An array of numbers or truth values, without an allocation.
fn scalar_array<T: Scalar, const N: usize>(reader: &mut Reader<'_>) -> Result<[T; N], DecodeError> {
    let start = reader.mark();
    let mut values = [T::default(); N];
    let mut len = 0;
    let mut slots = values.iter_mut();
    let mut take = |value| {
        if let Some(slot) = slots.next() {
            *slot = value;
        }
    };
    reader.begin_array()?;
    while reader.next_element()? {
        let usual = reader.usual_run(&mut take);
        if usual == 0 {
            take(T::decode(reader).map_err(|error| error.in_element(len))?);
        }
        len += usual.max(1);
    }
    if len == N { Ok(values) } else { Err(not_an_array_of(N, reader, start)) }
}

/// Error for the array at `reader`'s place, which has another number of values.
#[cold]
pub(super) fn not_an_array_of(len: usize, reader: &mut Reader<'_>, start: Mark) -> DecodeError {
    unfit(reader, start, &format!("an array of {len}"))
}

/// Error for the value at `reader`'s place.
#[cold]
fn unfit(reader: &mut Reader<'_>, start: Mark, expected: &str) -> DecodeError {
    reader.go_back(start);
    match reader.raw() {
        Ok(raw) => DecodeError::unfit(expected, raw),
        Err(malformed) => malformed,
    }
}

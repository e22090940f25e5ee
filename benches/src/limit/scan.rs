//! Steps of which the hand-written decoders are made. They take JSON as controllers usually write it, and nothing else.

use jaka_proto::wire::Value;

/// A place in a message.
#[derive(Debug)]
pub struct Scan<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Scan<'a> {
    /// The beginning of a message.
    pub fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    fn rest(&self) -> &'a [u8] {
        self.text.as_bytes().get(self.at..).unwrap_or_default()
    }

    /// Skips white space, of which there is at most one blank as a rule.
    #[inline]
    pub fn blank(&mut self) {
        match *self.rest() {
            [byte, ..] if byte > b' ' => {}
            [b' ', byte, ..] if byte > b' ' => self.at += 1,
            _ => self.blanks(),
        }
    }

    #[inline(never)]
    fn blanks(&mut self) {
        while let Some(b' ' | b'\t' | b'\r' | b'\n') = self.rest().first() {
            self.at += 1;
        }
    }

    /// Takes this text, if it comes next.
    #[inline]
    pub fn eat<const N: usize>(&mut self, wanted: &[u8; N]) -> bool {
        let eaten = self.rest().first_chunk::<N>() == Some(wanted);
        self.at += if eaten { N } else { 0 };
        eaten
    }

    /// Takes this text and the white space after it.
    #[inline]
    pub fn need<const N: usize>(&mut self, wanted: &[u8; N]) -> Option<()> {
        self.eat(wanted).then(|| self.blank())
    }

    /// Takes a comma or the closing bracket: true for the comma.
    #[inline]
    pub fn comma(&mut self, close: u8) -> Option<bool> {
        match *self.rest() {
            [b',', byte, ..] if byte > b' ' => self.at += 1,
            [b',', b' ', byte, ..] if byte > b' ' => self.at += 2,
            [byte, ..] if byte == close => {
                self.at += 1;
                return Some(false);
            }
            _ => return self.comma_far(close),
        }
        Some(true)
    }

    #[inline(never)]
    fn comma_far(&mut self, close: u8) -> Option<bool> {
        self.blank();
        let byte = *self.rest().first()?;
        self.at += 1;
        self.blank();
        if byte == b',' { Some(true) } else { (byte == close).then_some(false) }
    }

    /// A string without escapes.
    #[inline]
    pub fn text(&mut self) -> Option<&'a str> {
        self.need(b"\"")?;
        let rest = self.rest();
        let is_end = |byte: &u8| matches!(byte, b'"' | b'\\');
        let len = match rest.first_chunk::<16>().map(|near| near.iter().position(is_end)) {
            Some(Some(near)) => near,
            _ => memchr::memchr2(b'"', b'\\', rest)?,
        };
        let text = self.text.get(self.at..self.at + len)?;
        self.at += len;
        self.eat(b"\"").then_some(text)
    }

    /// Puts a string into its place.
    #[inline]
    pub fn text_into(&mut self, into: &mut String) -> Option<()> {
        let text = self.text()?;
        into.clear();
        into.push_str(text);
        Some(())
    }

    /// A whole number.
    #[inline]
    pub fn int(&mut self) -> Option<i64> {
        let negative = self.eat(b"-");
        let rest = self.rest();
        let len = rest.iter().take(18).take_while(|byte| byte.is_ascii_digit()).count();
        let value = rest[..len].iter().fold(0, |value, byte| value * 10 + i64::from(byte - b'0'));
        self.at += len;
        let ends = !matches!(rest.get(len), Some(b'0'..=b'9' | b'.' | b'e' | b'E'));
        (len > 0 && ends).then_some(if negative { -value } else { value })
    }

    /// Truth written as 0 or 1.
    #[inline]
    pub fn bit(&mut self) -> Option<bool> {
        let rest = self.rest();
        let bit = rest.first()?.wrapping_sub(b'0');
        self.at += 1;
        let ends = !matches!(rest.get(1), Some(b'0'..=b'9' | b'.' | b'e' | b'E'));
        (bit <= 1 && ends).then_some(bit == 1)
    }

    /// Truth written as a word.
    #[inline]
    pub fn truth(&mut self) -> Option<bool> {
        if self.eat(b"true") { Some(true) } else { self.eat(b"false").then_some(false) }
    }

    /// A number, correctly rounded.
    #[inline]
    pub fn float(&mut self) -> Option<f64> {
        let rest = self.rest();
        let sign = usize::from(rest.first() == Some(&b'-'));
        let (mut all, mut end) = digits(rest, sign, 0);
        let mut fraction = 0;
        if let (Some(b'.'), true) = (rest.get(end), end > sign) {
            let first = end + 1;
            (all, end) = eights(rest, first, all);
            (all, end) = digits(rest, end, all);
            fraction = end - first;
        }
        // At most 19 digits and the point.
        let is_usual = end > sign && end - sign <= 20 - usize::from(fraction == 0) && rest.get(end - 1) != Some(&b'.');
        if !is_usual || matches!(rest.get(end), Some(b'e' | b'E')) {
            return self.float_slowly();
        }
        #[expect(clippy::cast_precision_loss, reason = "up to 2^53 each whole number has a float of its own")]
        let value = if all <= 1 << 53 { all as f64 / POWERS[fraction] } else { long_quotient(all, fraction)? };
        self.at += end;
        Some(if sign == 1 { -value } else { value })
    }

    #[inline(never)]
    fn float_slowly(&mut self) -> Option<f64> {
        let is_part = |byte: &u8| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E');
        let len = self.rest().iter().take_while(|byte| is_part(byte)).count();
        let value: f64 = self.text.get(self.at..self.at + len)?.parse().ok()?;
        self.at += len;
        value.is_finite().then_some(value)
    }

    /// Values in brackets.
    #[inline]
    pub fn list<T>(&mut self, into: &mut Vec<T>, one: impl Fn(&mut Self) -> Option<T>) -> Option<()> {
        into.clear();
        self.need(b"[")?;
        if self.eat(b"]") {
            return Some(());
        }
        loop {
            into.push(one(self)?);
            if !self.comma(b']')? {
                return Some(());
            }
        }
    }

    /// Truth values in brackets, each written as 0 or 1.
    pub fn bits(&mut self, into: &mut Vec<bool>) -> Option<()> {
        into.clear();
        self.need(b"[")?;
        if self.eat(b"]") {
            return Some(());
        }
        loop {
            let bytes = self.rest();
            let mut at = 0;
            while let [bit @ (b'0' | b'1'), b',', next, ..] = bytes[at..] {
                into.push(bit == b'1');
                at += 2 + usize::from(next == b' ');
            }
            self.at += at;
            self.blank();
            into.push(self.bit()?);
            if !self.comma(b']')? {
                return Some(());
            }
        }
    }

    /// So many values in brackets.
    #[inline]
    pub fn array<T: Default + Copy, const N: usize>(&mut self, one: impl Fn(&mut Self) -> Option<T>) -> Option<[T; N]> {
        let mut values = [T::default(); N];
        self.need(b"[")?;
        for (at, value) in values.iter_mut().enumerate() {
            *value = one(self)?;
            if self.comma(b']')? != (at + 1 < N) {
                return None;
            }
        }
        Some(values)
    }

    /// JSON of unknown shape, kept where nothing of it has to be allocated: numbers, and arrays of them.
    pub fn json_into(&mut self, into: &mut Value) -> Option<()> {
        if self.rest().first() != Some(&b'[') {
            *into = self.int()?.into();
            return Some(());
        }
        if !into.is_array() {
            *into = Value::Array(Vec::new());
        }
        self.list(into.as_array_mut()?, |scan| scan.int().map(Value::from))
    }

    /// Nothing but white space is left.
    pub fn end(&mut self) -> Option<()> {
        self.blank();
        self.rest().is_empty().then_some(())
    }
}

/// Takes digits from `at` on: `value` with them appended, which wraps around after the 19th, and where they end.
#[inline]
fn digits(bytes: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

/// Takes digits as [`digits`] does, eight at once, while at least eight digits are left.
#[inline]
fn eights(bytes: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(eight) = bytes.get(at..).and_then(|rest| rest.first_chunk::<8>()).copied().and_then(eight_digits) {
        value = value.wrapping_mul(100_000_000).wrapping_add(eight);
        at += 8;
    }
    (value, at)
}

/// `digits` by 10 to the power of `fraction`, by whole numbers: the last bit stands for all that is left.
#[inline(never)]
fn long_quotient(digits: u64, fraction: usize) -> Option<f64> {
    let power = u128::from(*WHOLE_POWERS.get(fraction)?);
    let dividend = u128::from(digits) << 64;
    let quotient = dividend / power;
    let rest = u128::from(quotient * power != dividend);
    #[expect(clippy::cast_precision_loss, reason = "this is where it is rounded, once")]
    Some((quotient | rest) as f64 * (1.0 / 18_446_744_073_709_551_616.0))
}

/// The number that eight digits make, all at once.
#[inline]
fn eight_digits(text: [u8; 8]) -> Option<u64> {
    let digits = u64::from_le_bytes(text) ^ 0x3030_3030_3030_3030;
    if (digits.wrapping_add(0x0606_0606_0606_0606) | digits) & 0xf0f0_f0f0_f0f0_f0f0 != 0 {
        return None;
    }
    let pairs = (digits.wrapping_mul(10).wrapping_add(digits >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(100).wrapping_add(pairs >> 16)) & 0x0000_ffff_0000_ffff;
    Some(fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff)
}

/// Powers of ten, as far as the quotient has bits enough.
const WHOLE_POWERS: [u64; 19] = [
    1,
    10,
    100,
    1_000,
    10_000,
    100_000,
    1_000_000,
    10_000_000,
    100_000_000,
    1_000_000_000,
    10_000_000_000,
    100_000_000_000,
    1_000_000_000_000,
    10_000_000_000_000,
    100_000_000_000_000,
    1_000_000_000_000_000,
    10_000_000_000_000_000,
    100_000_000_000_000_000,
    1_000_000_000_000_000_000,
];

/// Powers of ten that a float holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

//! How values become JSON.

use super::{Encode, Writer};

impl Encode for f64 {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.float(*self);
    }
}

impl Encode for i64 {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.int(*self);
    }
}

impl Encode for bool {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.choose(*self, "false", "true");
    }
}

impl Encode for String {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.text(self);
    }
}

impl Encode for serde_json::Value {
    fn encode(&self, out: &mut Writer) {
        out.json(self);
    }
}

impl<T: Encode> Encode for Vec<T> {
    fn encode(&self, out: &mut Writer) {
        out.array(self, |out, item| item.encode(out));
    }
}

impl<T: Encode, const N: usize> Encode for [T; N] {
    fn encode(&self, out: &mut Writer) {
        out.array(self, |out, item| item.encode(out));
    }
}

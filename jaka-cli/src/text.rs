//! Numbers, times and lines of CSV as text.

pub(crate) mod csv;
pub(crate) mod number;
pub(crate) mod seconds;
pub(crate) mod utc;

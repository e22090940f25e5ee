//! Recordings that this program makes and reads.

pub(crate) mod record;
pub(crate) mod recorded;

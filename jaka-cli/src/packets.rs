//! Status packets: fields, conditions, tables, events, and those of packs.

pub(crate) mod condition;
pub(crate) mod event;
pub(crate) mod fields;
pub(crate) mod flags;
pub(crate) mod packed_status;
pub(crate) mod value_rows;

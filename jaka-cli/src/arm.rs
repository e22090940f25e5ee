//! Commands that act on the arm: consent, motions and their ends, limits, Ctrl-C.

pub(crate) mod acting;
pub(crate) mod consent;
pub(crate) mod going;
pub(crate) mod interrupt;
pub(crate) mod limits;
pub(crate) mod motion;
pub(crate) mod planned;
pub(crate) mod rest;
pub(crate) mod units;

//! Tests of the expansion.

mod corpora;
mod golden;

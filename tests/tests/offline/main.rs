//! Tests without an arm: the spec and what is made of it, pages, and the mathematics of the arm.

mod architecture;
mod command_names;
mod diff;
mod document;
mod dynamic;
mod examples;
mod json;
mod json_schema;
mod kinematics;
mod named;
mod properties;
mod readme;
mod reference;
mod spec_edits;
mod spec_mutations;
mod user_crate;

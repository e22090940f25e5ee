#![doc = include_str!("../README.md")]

mod arc;
mod branches;
mod closed_form;
mod fit;
mod frames;
mod links;
mod model;
mod no_solution;
mod transform;
mod up_to_eight;

#[cfg(test)]
mod tests;

pub use arc::Arc;
pub use branches::Branches;
pub use fit::{Fit, FitError, Tolerance};
pub use frames::Frames;
/// The types of joint positions and poses.
pub use jaka_proto as proto;
pub use model::{DhMismatch, Model, SingularityDistance};
pub use no_solution::NoSolution;
pub use transform::Transform;

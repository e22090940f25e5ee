//! Why there is no generator.

use crate::beyond::Beyond;

/// Why a [`Generator`](crate::Generator) or its [`Dynamics`](crate::Dynamics) cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeneratorError {
    /// A speed, acceleration or jerk is too small, or not a number.
    #[error("{what} of joint {joint}: {given} {unit} is not at least {least} {unit}")]
    TooLittle {
        /// What of a joint, for example `speed`.
        what: &'static str,
        /// Its unit.
        unit: &'static str,
        /// The joint, 1 to 6.
        joint: usize,
        /// The number that was given.
        given: f64,
        /// The least that there may be.
        least: f64,
    },
    /// A speed or an acceleration is higher than the arm's limits allow.
    #[error("{what} of joint {joint}: {given} {unit} is beyond the arm's limit of {limit} {unit}")]
    BeyondLimit {
        /// What of a joint, for example `speed`.
        what: &'static str,
        /// Its unit.
        unit: &'static str,
        /// The joint, 1 to 6.
        joint: usize,
        /// The number that was given.
        given: f64,
        /// What the limits allow.
        limit: f64,
    },
    /// The period is not from 1 ms to 1 s.
    #[error("period: {given} s is not from 0.001 s to 1 s")]
    Period {
        /// The number that was given, in seconds.
        given: f64,
    },
    /// The arm starts beyond a limit.
    #[error("start: {0}")]
    Start(#[source] Beyond),
}

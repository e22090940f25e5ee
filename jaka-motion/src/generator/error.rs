//! Why there is no generator.

use std::fmt;

use crate::beyond::Beyond;

/// Why a [`Generator`](crate::Generator) or its [`Dynamics`](crate::Dynamics) cannot be made.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum GeneratorError {
    /// A speed, acceleration or jerk is too small, or not a number.
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
    Period {
        /// The number that was given, in seconds.
        given: f64,
    },
    /// The arm starts beyond a limit.
    Start(Beyond),
}

impl fmt::Display for GeneratorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLittle { what, unit, joint, given, least } => {
                write!(f, "{what} of joint {joint}: {given} {unit} is not at least {least} {unit}")
            }
            Self::BeyondLimit { what, unit, joint, given, limit } => {
                write!(f, "{what} of joint {joint}: {given} {unit} is beyond the arm's limit of {limit} {unit}")
            }
            Self::Period { given } => write!(f, "period: {given} s is not from 0.001 s to 1 s"),
            Self::Start(beyond) => write!(f, "start: {beyond}"),
        }
    }
}

impl std::error::Error for GeneratorError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Start(beyond) => Some(beyond),
            _ => None,
        }
    }
}

//! Why there is no generator.

use crate::beyond::Beyond;

jaka_proto::worded! {
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
        } => "{what} of joint {joint}: {given} {unit} is not at least {least} {unit}",
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
        } => "{what} of joint {joint}: {given} {unit} is beyond the arm's limit of {limit} {unit}",
        /// The period is not from 1 ms to 1 s.
        Period {
            /// The number that was given, in seconds.
            given: f64,
        } => "period: {given} s is not from 0.001 s to 1 s",
        /// The arm starts beyond a limit.
        Start(beyond: Beyond) => "start: {beyond}",
    }
}

impl std::error::Error for GeneratorError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Start(beyond) => Some(beyond),
            Self::TooLittle { .. } | Self::BeyondLimit { .. } | Self::Period { .. } => None,
        }
    }
}

//! One fault of each kind.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::payload::GetPayload;

use super::{Fault, LinkFault, StatusFault};

/// A value of each variant. An enum with a variant that is not listed does not compile.
macro_rules! one_of_each {
    ($($variant:ident $(($value:expr))? $({ $($field:ident: $given:expr),* })?),* $(,)?) => {{
        let _is_listed = |fault: &Self| match fault {
            $(Self::$variant { .. } => {})*
        };
        vec![$(Self::$variant $(($value))? $({ $($field: $given),* })?),*]
    }};
}

impl Fault {
    /// One fault of each kind, [`None`](Self::None) first, for tests that go through all of them.
    ///
    /// ```
    /// use jaka_sim::{Controller, Fault};
    ///
    /// for fault in Fault::one_of_each() {
    ///     let controller = Controller::start()?;
    ///     controller.inject(fault);
    ///     // Here a program must end, and must not believe wrong data.
    /// }
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn one_of_each() -> Vec<Self> {
        one_of_each![
            None,
            Drop,
            Delay(Duration::from_millis(50)),
            Hold,
            Pieces(vec![1, 2, 3]),
            WithNext,
            Twice,
            Nameless,
            Renamed(GetPayload::INFO.name.to_owned()),
            Before(b"{}".to_vec()),
            After(vec![0]),
            Instead(b"nonsense".to_vec()),
            Garbage { bytes: 500, seed: 7 },
            Oversized(100_000),
            HalfOpen,
            Close,
            CloseAfter(10),
            Reset,
            Takeover,
        ]
    }
}

impl StatusFault {
    /// One fault of each kind, [`None`](Self::None) first, for tests that go through all of them.
    pub fn one_of_each() -> Vec<Self> {
        one_of_each![
            None,
            Silent,
            Slow(Duration::from_millis(80)),
            Pieces(3),
            Garbage { bytes: 300, seed: 3 },
            Cut(100),
            Instead(b"{}".to_vec()),
            CloseAfter(100),
        ]
    }
}

impl LinkFault {
    /// One fault of each kind, [`None`](Self::None) first, for tests that go through all of them.
    pub fn one_of_each() -> Vec<Self> {
        one_of_each![None, Hold, Delay(Duration::from_millis(80)), Slow(20_000), Cut]
    }
}

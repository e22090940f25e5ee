//! The options of a controller.

use std::io;
use std::time::Duration;

use crate::Controller;

/// Options for a [`Controller`], which are set before it starts.
#[derive(Debug, Clone)]
pub struct Builder {
    pub(crate) takeover: Takeover,
    pub(crate) status_period: Duration,
}

impl Builder {
    pub(crate) fn new() -> Self {
        Self { takeover: Takeover::Replace, status_period: Duration::from_millis(50) }
    }

    /// Says what happens when a second client connects to the command port: [`Takeover::Replace`] if not set.
    #[must_use]
    pub fn takeover(mut self, takeover: Takeover) -> Self {
        self.takeover = takeover;
        self
    }

    /// Sets the time between two status packets: 50 ms if not set.
    ///
    /// With [`Duration::MAX`], each reader gets the packet on connecting and then those of [`Controller::publish`].
    #[must_use]
    pub fn status_period(mut self, period: Duration) -> Self {
        self.status_period = period;
        self
    }

    /// Starts the controller.
    ///
    /// # Errors
    /// A port or a thread cannot be had.
    pub fn start(self) -> io::Result<Controller> {
        Controller::with(self)
    }
}

impl Default for Builder {
    fn default() -> Self {
        Self::new()
    }
}

/// What happens when a client connects to the command port while another one is connected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Takeover {
    /// The newcomer takes the seat, and the old connection is closed.
    #[default]
    Replace,
    /// The newcomer is closed.
    Refuse,
}

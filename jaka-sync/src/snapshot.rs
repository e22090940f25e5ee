//! Status packets with the time of their arrival.

use std::time::{Duration, Instant};

use jaka_clock::Clock;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::DecodeError;

/// Status packet, and when it came.
///
/// Packets carry no time of their own, so nothing here tells when the controller wrote one: at least [`age`](Self::age)
/// ago. A link that delays all packets alike cannot be told from one that does not. Only a reply on the command port is
/// certain to be later than the command before it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Snapshot<S = RobotStatus> {
    /// Content of the packet.
    pub status: S,
    /// Time at which it came.
    pub received: Instant,
    /// Its number, counted from 1 since the monitor began; numbers without a packet were dropped, or could not be read.
    pub number: u64,
    /// The fields of the packet that do not fit the spec, each once, with what was expected and what was found: they
    /// are absent in [`status`](Self::status). Usually none.
    pub unfit: Vec<DecodeError>,
    /// True if the packet came within 100 ms after a silence longer than
    /// [`Config::stale_after`](crate::Config::stale_after): a network that stalled delivers what it had held back, so
    /// the controller may have written the packet at any time of the silence.
    ///
    /// [`Monitor::wait_until`](crate::Monitor::wait_until) and [`Monitor::next_packet`](crate::Monitor::next_packet)
    /// pass over such packets, and no motion goes out by them.
    pub follows_silence: bool,
    /// Field that its type says each packet tells, and that this one does not.
    pub(crate) untold: Option<DecodeError>,
    pub(crate) clock: Clock,
}

/// Fields without which it is not known whether the arm is stopped.
const NEEDED: [&str; 6] = ["emergency_stop", "protective_stop", "powered_on", "enabled", "in_position", "error_code"];

impl Snapshot {
    /// Error of a packet that shows nothing at all, because its own type has panicked.
    pub fn panicked(&self) -> Option<&DecodeError> {
        self.unfit.iter().find(|error| error.field().is_empty())
    }

    /// Reason for which the packet does not show whether the arm is stopped: that cannot be read, or is not there at
    /// all; or a field is not there that a pack maps, or that a program's own [type](crate::MotionStatus) must tell.
    pub fn unreadable(&self) -> Option<DecodeError> {
        let unfit = || self.unfit.iter().find(|error| NEEDED.iter().any(|field| error.is_in(field)));
        self.panicked().or_else(unfit).or(self.untold.as_ref()).cloned().or_else(|| {
            let status = &self.status;
            let told = [status.emergency_stop, status.protective_stop, status.powered_on, status.enabled];
            let is_told = told.iter().any(Option::is_some);
            (!is_told).then(|| {
                DecodeError::unfit("a packet that shows whether the arm is enabled and stopped", "none of these keys")
            })
        })
    }
}

#[cfg(shuttle)]
impl<S> Snapshot<S> {
    /// Packet that comes now, without a connection: for tests of interleavings.
    #[doc(hidden)]
    pub fn arriving(status: S, number: u64) -> std::sync::Arc<Self> {
        let clock = Clock::default();
        let (received, unfit, follows_silence, untold) = (clock.now(), Vec::new(), false, None);
        std::sync::Arc::new(Self { status, received, number, unfit, follows_silence, untold, clock })
    }
}

impl<S> Snapshot<S> {
    /// True if the packet has this field of [`RobotStatus`], by its name there, but in a form that does not fit: its
    /// value is unknown.
    ///
    /// ```no_run
    /// # let monitor = jaka_sync::Monitor::connect("10.5.5.100")?;
    /// let now = monitor.next_packet()?;
    /// let is_stopped = now.status.protective_stop == Some(true) || now.is_unfit("protective_stop");
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    pub fn is_unfit(&self, field: &str) -> bool {
        self.unfit.iter().any(|error| error.is_in(field))
    }

    /// Time since the packet came. The controller wrote it at least so long ago; after a silence it may be far older
    /// ([`follows_silence`](Self::follows_silence)).
    pub fn age(&self) -> Duration {
        self.clock.elapsed(self.received)
    }
}

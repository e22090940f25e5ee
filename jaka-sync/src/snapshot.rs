//! Status packets with the time of their arrival.

use std::time::{Duration, Instant};

use jaka_clock::Clock;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::DecodeError;

/// Status packet with the time of its arrival.
///
/// Packets have no timestamp, so the time at which the controller wrote one is unknown: at least [`age`](Self::age)
/// ago. A link that delays all packets equally looks like a link without delay. Only a reply on the command port is
/// certain to be later than the command before it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Snapshot<S = RobotStatus> {
    /// Content of the packet.
    pub status: S,
    /// Time of arrival.
    pub received: Instant,
    /// Number of the packet, counted from 1 since the monitor began. Missing numbers belong to packets that were
    /// dropped or unreadable.
    pub number: u64,
    /// Fields of the packet that do not fit the spec, each once, with the expected and the found value. They are absent
    /// in [`status`](Self::status). Usually empty.
    pub unfit: Vec<DecodeError>,
    /// True if the packet came within 100 ms after a silence longer than
    /// [`Config::stale_after`](crate::Config::stale_after). A network that stalled delivers the packets it had held
    /// back, so the controller may have written this one at any time of the silence.
    ///
    /// [`Monitor::wait_until`](crate::Monitor::wait_until) and [`Monitor::next_packet`](crate::Monitor::next_packet)
    /// ignore such packets, and no motion is sent on the basis of one.
    pub follows_silence: bool,
    /// Error of a field that this type of packet must have, and that this packet does not have.
    pub(crate) untold: Option<DecodeError>,
    pub(crate) clock: Clock,
}

/// Fields that show whether the arm is stopped.
const NEEDED: [&str; 6] = ["emergency_stop", "protective_stop", "powered_on", "enabled", "in_position", "error_code"];

impl Snapshot {
    /// Error of a packet that shows nothing, because the packet's own type has panicked.
    pub fn panicked(&self) -> Option<&DecodeError> {
        self.unfit.iter().find(|error| error.field().is_empty())
    }

    /// Reason why the packet does not show whether the arm is stopped: the fields for it cannot be read or are all
    /// absent, or a field is absent that a pack maps or that the program's [type](crate::MotionStatus) must provide.
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
    /// Packet that arrives now, without a connection: for tests of interleavings.
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

    /// Time since the packet came. The controller wrote it at least that long ago; after a silence it may be far older
    /// ([`follows_silence`](Self::follows_silence)).
    pub fn age(&self) -> Duration {
        self.clock.elapsed(self.received)
    }
}

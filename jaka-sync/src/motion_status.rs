//! What a robot reads of status packets, whatever type its monitor keeps.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError};

use crate::Snapshot;

/// Status packets by which a robot can tell how a motion goes: the built-in type, and the one of a
/// [pack](crate::pack!) that changes the packet.
///
/// The `RobotStatus` of a pack's module implements it, unless the pack gives another type in Rust to a field that a
/// robot needs. Another key, or truth values written in another form, are not another type. Where it is not
/// implemented, implement it: say what the packet means in terms of the built-in type.
///
/// ```no_run
/// use jaka_sync::status::RobotStatus;
/// use jaka_sync::{Config, Error, Monitor, MotionStatus};
///
/// fn monitor<S: MotionStatus>(address: &str) -> Result<Monitor<S>, Error> {
///     Monitor::connect_with(&Config::new(), address)
/// }
///
/// let monitor = monitor::<RobotStatus>("10.5.5.100")?;
/// # Ok::<(), Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "a robot cannot tell by `{Self}` how a motion goes",
    note = "a pack's `RobotStatus` does not implement `MotionStatus` if the pack changes the type of a field that a robot needs"
)]
pub trait MotionStatus: Decode + Send + Sync + Sized + 'static {
    /// The packet in terms of the built-in type.
    ///
    /// What is left out counts as a key that did not come: an arm is not moved if neither of its stops nor its power is
    /// shown. What does not fit ([`Snapshot::is_unfit`]) is known by the fields' names. Where this panics, the packet
    /// counts as one that cannot be read, and motions are kept back until `jaka_robot::Robot::acknowledge`.
    ///
    /// Called for each packet and robot on the monitor's thread, and by `Robot::power_up`: a slow implementation holds
    /// packets up.
    fn robot_status(&self) -> RobotStatus;

    /// Fields of the built-in type that came and do not fit, by their Rust names, in addition to those that the reader
    /// left out ([`Snapshot::unfit`](crate::Snapshot::unfit)).
    #[doc(hidden)]
    fn unfit(&self) -> Vec<DecodeError> {
        Vec::new()
    }

    /// The packet in terms of the built-in type, with when it came and what did not fit. After a panic no key has come,
    /// and the packet as a whole does not fit.
    #[doc(hidden)]
    fn snapshot(snapshot: &Arc<Snapshot<Self>>) -> Arc<Snapshot> {
        let Snapshot { status: packet, received, number, unfit, follows_silence, clock } = &**snapshot;
        let (mut unfit, clock) = (unfit.clone(), clock.clone());
        let told = caught(|| (packet.robot_status(), packet.unfit()));
        let (status, more) = told.unwrap_or_else(|error| (RobotStatus::default(), vec![error]));
        unfit.extend(more);
        let (received, number, follows_silence) = (*received, *number, *follows_silence);
        Arc::new(Snapshot { status, received, number, unfit, follows_silence, clock })
    }
}

/// Status that a packet tells, unless its own type panics.
pub fn told<S: MotionStatus>(status: &S) -> Result<RobotStatus, DecodeError> {
    caught(|| status.robot_status())
}

/// Calls a packet's own type, which may panic. Nothing else calls the methods of [`MotionStatus`].
fn caught<T>(tell: impl FnOnce() -> T) -> Result<T, DecodeError> {
    // What a panic leaves half done is the type's own.
    catch_unwind(AssertUnwindSafe(tell))
        .map_err(|_| DecodeError::unfit("a packet that the program's own type accepts", "a panic"))
}

impl MotionStatus for RobotStatus {
    fn robot_status(&self) -> RobotStatus {
        self.clone()
    }

    fn snapshot(snapshot: &Arc<Snapshot>) -> Arc<Snapshot> {
        Arc::clone(snapshot)
    }
}

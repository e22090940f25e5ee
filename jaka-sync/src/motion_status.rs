//! Fields that a robot reads from status packets of any type.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, DecodeError};

use crate::Snapshot;

/// Status packet from which a robot can read the progress of a motion: the built-in type, or the type of a
/// [pack](crate::pack!) that changes the packet.
///
/// The `RobotStatus` of a pack's module implements it by the pack's table `[robot_status]`, which locates the
/// [fields that a robot needs](crate::newer_firmware#what-a-robot-needs) in the packets. If the table leaves a field to
/// the program (`"program"`), the program implements the trait: the module's type then has a method `as_built_in`,
/// which returns all but these fields.
///
/// ```
/// use jaka_sync::proto::wire::{Decode, DecodeError, Reader};
/// use jaka_sync::status::RobotStatus;
/// use jaka_sync::{Config, Error, Monitor, MotionStatus};
///
/// /// Packets of a controller that never sends an error code.
/// struct Plain(RobotStatus);
///
/// impl Decode for Plain {
///     fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
///         RobotStatus::decode(reader).map(Self)
///     }
/// }
///
/// impl MotionStatus for Plain {
///     fn robot_status(&self) -> RobotStatus {
///         // Required: `emergency_stop`, `protective_stop`, `powered_on`, `enabled`, `in_position` and
///         // `joint_actual_position`.
///         self.0.clone()
///     }
///
///     fn absent() -> &'static [&'static str] {
///         &["error_code", "error_message"]
///     }
/// }
///
/// fn monitor(address: &str) -> Result<Monitor<Plain>, Error> {
///     Monitor::connect_with(&Config::new(), address)
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "a robot cannot read the state of a motion from `{Self}`",
    note = "a pack's `RobotStatus` does not implement it if the pack's `[robot_status]` leaves a field to the program"
)]
pub trait MotionStatus: Decode + Send + Sync + Sized + 'static {
    /// Returns the packet in terms of the built-in type.
    ///
    /// A field that is left out counts as a key that did not come. While packets leave out a required field, or an
    /// `error_code` that is not declared [absent](Self::absent), no motion is sent. Unfit fields
    /// ([`Snapshot::is_unfit`]) are known by their names. If this method panics, the packet counts as unreadable, and
    /// motions are kept back until `jaka_robot::Robot::acknowledge`.
    ///
    /// The monitor's thread calls it for each packet and robot, and `Robot::power_up` calls it, too: a slow
    /// implementation delays packets.
    fn robot_status(&self) -> RobotStatus;

    /// Fields of the built-in type, by their Rust names, that packets of this controller never have.
    ///
    /// `jaka_robot` reports the consequence: without `error_code`, the end of a motion and a preflight state that an
    /// error of the controller is not seen.
    fn absent() -> &'static [&'static str] {
        &[]
    }

    /// Fields without which a packet keeps motions back. Each has its Rust name in the built-in type and its name in
    /// this type, which the reader's errors use. Fields that are declared absent do not count.
    #[doc(hidden)]
    fn expected() -> &'static [[&'static str; 2]] {
        &REQUIRED
    }

    /// Fields of the built-in type that came and do not fit, by their Rust names, in addition to those that the reader
    /// left out ([`Snapshot::unfit`](crate::Snapshot::unfit)).
    #[doc(hidden)]
    fn unfit(&self) -> Vec<DecodeError> {
        Vec::new()
    }

    /// Returns the packet in terms of the built-in type, with its arrival time and its unfit fields. After a panic it
    /// has no key, and the packet as a whole does not fit.
    #[doc(hidden)]
    fn snapshot(snapshot: &Arc<Snapshot<Self>>) -> Arc<Snapshot> {
        let Snapshot { status: packet, received, number, unfit, follows_silence, clock, .. } = &**snapshot;
        let (mut unfit, clock) = (unfit.clone(), clock.clone());
        let told = caught(|| (packet.robot_status(), packet.unfit()));
        let (status, untold) = match told {
            Ok((status, more)) => {
                unfit.extend(more);
                unfit = in_built_in_names::<Self>(unfit);
                let untold = untold::<Self>(&status, &mut unfit);
                (status, untold)
            }
            Err(error) => {
                unfit.push(error);
                Default::default()
            }
        };
        let (received, number, follows_silence) = (*received, *number, *follows_silence);
        Arc::new(Snapshot { status, received, number, unfit, follows_silence, untold, clock })
    }
}

/// Fields that a program's own type must provide: the required ones, and the controller's errors.
const REQUIRED: [[&str; 2]; 7] = [
    ["emergency_stop"; 2],
    ["protective_stop"; 2],
    ["powered_on"; 2],
    ["enabled"; 2],
    ["in_position"; 2],
    ["joint_actual_position"; 2],
    ["error_code"; 2],
];

/// Errors of fields by their names in the built-in type. Leaves out errors of fields that a robot reads elsewhere or
/// does not have.
fn in_built_in_names<S: MotionStatus>(unfit: Vec<DecodeError>) -> Vec<DecodeError> {
    let is_unused = |error: &DecodeError| {
        let is_moved = |[field, own]: &[&str; 2]| field != own && error.is_in(field);
        S::absent().iter().any(|field| error.is_in(field)) || S::expected().iter().any(is_moved)
    };
    let named = |error: DecodeError| {
        let sources = S::expected().iter().filter(|[_, own]| error.is_in(own));
        let named: Vec<_> = sources.map(|[field, own]| within(error.clone(), field, own)).collect();
        if named.is_empty() && !is_unused(&error) { vec![error] } else { named }
    };
    unfit.into_iter().flat_map(named).collect()
}

fn within(error: DecodeError, field: &str, own: &str) -> DecodeError {
    if field == own { error } else { error.in_field(field) }
}

/// Error of the first expected field that a packet does not have. Adds each such field to the unfit ones.
fn untold<S: MotionStatus>(status: &RobotStatus, unfit: &mut Vec<DecodeError>) -> Option<DecodeError> {
    let is_told = |field: &str| needed(status).iter().any(|(name, is_told)| *name == field && *is_told);
    let untold = S::expected().iter().filter(|[field, _]| !S::absent().contains(field) && !is_told(field));
    let mut first = None;
    for [field, own] in untold {
        let at = unfit.iter().position(|error| error.is_in(field)).unwrap_or_else(|| {
            unfit.push(within(DecodeError::unfit("a value in each packet", "none").in_field(own), field, own));
            unfit.len() - 1
        });
        first.get_or_insert_with(|| unfit[at].clone());
    }
    first
}

/// Fields of status packets that a robot needs, each with true if the packet has it.
pub fn needed(status: &RobotStatus) -> [(&'static str, bool); 14] {
    [
        ("emergency_stop", status.emergency_stop.is_some()),
        ("protective_stop", status.protective_stop.is_some()),
        ("powered_on", status.powered_on.is_some()),
        ("enabled", status.enabled.is_some()),
        ("in_position", status.in_position.is_some()),
        ("joint_actual_position", status.joint_actual_position.is_some()),
        ("drag_status", status.drag_status.is_some()),
        ("on_soft_limit", status.on_soft_limit.is_some()),
        ("paused", status.paused.is_some()),
        ("error_code", status.error_code.is_some()),
        ("error_message", status.error_message.is_some()),
        ("actual_position", status.actual_position.is_some()),
        ("current_tool_id", status.current_tool_id.is_some()),
        ("current_user_frame_id", status.current_user_frame_id.is_some()),
    ]
}

/// Status that a packet shows, unless the packet's own type panics.
pub fn told<S: MotionStatus>(status: &S) -> Result<RobotStatus, DecodeError> {
    caught(|| status.robot_status())
}

/// Calls a method of a packet's own type, which may panic. Nothing else calls the methods of [`MotionStatus`].
fn caught<T>(tell: impl FnOnce() -> T) -> Result<T, DecodeError> {
    // A panic can leave only the type's own state incomplete.
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

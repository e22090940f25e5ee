//! Reasons why an arm does not move, or does not move on: data of errors and of the ends of motions.

mod braking;
mod consequence;
mod occurrence;
mod remedy;
mod servo_mode;
mod table;
mod trip;
mod unknown;

pub(crate) use self::braking::Braking;
pub(crate) use self::consequence::Consequence;
pub use self::occurrence::{Evidence, Occurrence};
pub use self::remedy::Remedy;
pub use self::servo_mode::ServoModeState;
pub use self::table::{Cause, CauseGroup};
pub use self::trip::{GuardTrip, LagBeyondReaction, TripReason};
pub(crate) use self::unknown::{Field, shown_joints};
pub use self::unknown::{NotGuarded, NotShown, Unchecked};

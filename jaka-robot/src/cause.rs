//! Reasons why an arm does not move, or does not move on: data of errors and of the ends of motions.

mod explanation;
mod not_guarded;
mod not_shown;
mod occurrence;
mod remedy;
mod table;
mod trip;
mod unchecked;

pub use self::explanation::Explanation;
pub use self::not_guarded::NotGuarded;
pub(crate) use self::not_shown::Field;
pub use self::not_shown::NotShown;
pub(crate) use self::not_shown::shown_joints;
pub(crate) use self::occurrence::Consequence;
pub use self::occurrence::{Evidence, Occurrence};
pub use self::remedy::Remedy;
pub use self::table::{Cause, CauseGroup};
pub use self::trip::{GuardTrip, LagBeyondReaction, TripReason};
pub use self::unchecked::Unchecked;

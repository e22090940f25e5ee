//! Subset of the fields of the status packet.

/// Makes a struct with some fields of the status packet, for programs that need no more.
///
/// The fields have the names, types and docs of [`RobotStatus`](crate::status::RobotStatus). Use the struct with
/// [`StatusStream::next_packet_as`](crate::StatusStream::next_packet_as) or
/// [`newest_packet_as`](crate::StatusStream::newest_packet_as), or as the type of a [`Monitor`](crate::Monitor).
///
/// ```no_run
/// use jaka_sync::{Config, Monitor, StatusStream};
///
/// jaka_sync::status_subset! {
///     /// Where the arm is.
///     pub struct Joints { joint_actual_position, in_position }
/// }
///
/// let mut status = StatusStream::connect("10.5.5.100")?;
/// let Joints { joint_actual_position, in_position } = status.newest_packet_as()?;
/// let monitor: Monitor<Joints> = Monitor::connect_with(&Config::new(), "10.5.5.100")?;
/// # Ok::<(), jaka_sync::Error>(())
/// ```
///
/// Reading it takes a fraction of the time of the whole packet: the values of other keys are skipped by their quotes
/// and brackets, so that an error in one of them goes unnoticed. A named field is read and checked as in a full packet:
/// it is `None` if its key does not come, does not fit or comes twice.
/// [`StatusStream::unfit`](crate::StatusStream::unfit) and [`Snapshot::unfit`](crate::Snapshot::unfit) list the keys
/// that do not fit or come twice.
///
/// A field that the packet does not have is a compiler error at its name:
///
/// ```compile_fail
/// jaka_sync::status_subset! {
///     struct Joints { joint_position }
/// }
/// ```
#[macro_export]
macro_rules! status_subset {
    ($(#[$attribute:meta])* $vis:vis struct $name:ident { $($field:ident),* $(,)? }) => {
        $crate::__private::status_subset! { ($crate) [$(#[$attribute])* $vis] $name { $($field),* } }
    };
}

//! Commands from a TOML file in the user's crate.

use crate::{Client, Command, Error};

/// Makes a module of a command pack: a TOML file of yours that adds commands to the built-in spec, or changes what is
/// there.
///
/// The path counts from the folder of your crate's `Cargo.toml`, and the module has the name of the file. Of
/// `newer.toml` comes `pub mod newer` with the requests, replies and types that the pack adds or changes, and a trait
/// `NewerCommands`, whose methods work on a [`Client`](crate::Client), a `jaka_robot::Robot` and everything else that
/// implements [`Call`](crate::Call). An edit of the file rebuilds your crate, and what is wrong in it is a compiler
/// error at the macro's path that names file, line and column.
///
/// ```toml
/// # newer.toml
/// title = "What firmware 1.7.2 adds"
///
/// [[command]]
/// wire = "demo_motion_state"
/// effect = "query"
/// doc = "Reads how the motion stands."
///
/// [[command.reply]]
/// wire = "queue"
/// type = "int"
/// doc = "How many motions are queued."
/// ```
///
/// ```ignore
/// jaka_sync::pack!("newer.toml");
/// use newer::NewerCommands as _;
///
/// let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
/// let queue = robot.demo_motion_state()?.queue;
/// ```
///
/// A pack can also change what the built-in spec has: `[[extend]]` adds fields to a command or a type, such as keys to
/// the status packet, and `[[override]]` changes a field: its type, meaning, unit or range, or decides what sources
/// dispute. The module then has messages of its own for each command that is changed by it. Their methods bear the
/// module's name, such as `joint_move_newer`, since the client has a `joint_move` already; a changed status packet is
/// read by a `Monitor<newer::RobotStatus>`, and a robot takes it: `jaka_robot::Robot::with_monitor`. Where the pack
/// changes the type, unit or name of what [a robot needs](crate::newer_firmware#what-a-robot-needs), its table
/// `[robot_status]` says where packets have that, that they never have it, or that the program implements
/// [`MotionStatus`](crate::MotionStatus). The format is described with [jaka-spec](https://docs.rs/jaka-spec).
///
/// A pack can stand on others, which are named in their order, and whose modules stand next to its own:
///
/// ```ignore
/// jaka_sync::pack!("newer.toml");
/// jaka_sync::pack!("later.toml" on "newer.toml");
/// ```
///
/// A command with a table `[command.motion]`, which names the fields of its target and path, is a
/// [`Motion`](jaka_proto::Motion): `jaka_robot::Robot::run` waits for its end, and a robot with limits compares it with
/// them. A command with `role = "stop"` is the pack's claim: stop handles, guards and sessions send the built-in
/// `stop_program` alone. Nothing can recognise a command that its pack describes wrongly.
///
/// From the first look at a controller with newer firmware to a finished pack: the guide in
/// [`newer_firmware`](crate::newer_firmware).
///
/// Where a later version of this crate has an entry of your pack in its own spec, the module keeps the entry's names,
/// and they stand for this crate's items. `jaka spec check` tells which entries these are. If this crate has something
/// else under the name, so that your program would notice, that is a compiler error.
#[macro_export]
macro_rules! pack {
    ($($input:tt)+) => {
        $crate::__private::pack! { ($crate) $($input)+ }
    };
}

/// Sender of commands: a [`Client`], a `jaka_robot::Robot`, or a type of your own that forwards them.
///
/// All types that implement this have the methods of [packs](crate::pack), and code can be generic over it:
///
/// ```
/// use jaka_sync::power::GetVersion;
/// use jaka_sync::{Call, Error};
///
/// fn version(robot: &mut impl Call) -> Result<String, Error> {
///     Ok(robot.call(&GetVersion::new())?.version)
/// }
/// ```
pub trait Call {
    /// Sends a command and waits for its reply.
    ///
    /// # Errors
    /// As [`Client::call`].
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, Error>;
}

impl Call for Client {
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, Error> {
        Client::call(self, command)
    }
}

impl<T: Call + ?Sized> Call for &mut T {
    fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, Error> {
        (**self).call(command)
    }
}

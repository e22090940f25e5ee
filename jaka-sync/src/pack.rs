//! Commands from a TOML file in the user's crate.

use crate::{Client, Command, Error};

/// Generates a module from a command pack: a TOML file of your crate that adds commands to the built-in spec or changes
/// its entries.
///
/// The path is relative to the folder of your crate's `Cargo.toml`; the module has the name of the file. `newer.toml`
/// gives `pub mod newer` with the requests, replies and types that the pack adds or changes, and a trait
/// `NewerCommands`. The methods of the trait work on a [`Client`](crate::Client), a `jaka_robot::Robot` and every other
/// type that implements [`Call`](crate::Call). An edit of the file rebuilds your crate. An error in the file is a
/// compiler error at the macro's path, with file, line and column.
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
/// ```no_run
/// # /*
/// jaka_sync::pack!("newer.toml");
/// # */
/// # jaka_sync::pack!("../jaka-cli/tests/guide/newer.toml");
/// use newer::NewerCommands as _;
///
/// # fn main() -> Result<(), jaka_sync::Error> {
/// let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
/// let queue = robot.demo_motion_state()?.queue;
/// # Ok(())
/// # }
/// ```
///
/// A pack can also change the built-in spec: `[[extend]]` adds fields to a command or a type, such as keys to the
/// status packet; `[[override]]` changes a field (its type, meaning, unit or range) or settles a dispute between
/// sources. The module then has its own messages for each command that the pack changes. Their methods carry the
/// module's name, such as `joint_move_newer`, since the client has a `joint_move` already. A
/// `Monitor<newer::RobotStatus>` reads a changed status packet, and a robot takes this monitor:
/// `jaka_robot::Robot::with_monitor`. If the pack changes the type, unit or name of a field that
/// [a robot needs](crate::newer_firmware#what-a-robot-needs), its table `[robot_status]` names the field in the
/// packets, states that they never have it, or states that the program implements
/// [`MotionStatus`](crate::MotionStatus). The README of jaka-spec describes the format.
///
/// A pack can build on other packs, which are named in their order. Their modules are siblings of its own module:
///
/// ```
/// # /*
/// jaka_sync::pack!("newer.toml");
/// jaka_sync::pack!("later.toml" on "newer.toml");
/// # */
/// # jaka_sync::pack!("../tests/pack-user/halt.toml");
/// # jaka_sync::pack!("../tests/pack-user/mapped.toml" on "../tests/pack-user/halt.toml");
/// # fn main() {}
/// ```
///
/// A command with a table `[command.motion]`, which names the fields of its target and path, is a
/// [`Motion`](jaka_proto::Motion): `jaka_robot::Robot::run` waits for its end, and a robot with limits compares it with
/// them. `role = "stop"` is only a claim of the pack: stop handles, guards and sessions send the built-in
/// `stop_program` alone. Nothing can recognise a command that its pack describes wrongly.
///
/// The guide in [`newer_firmware`](crate::newer_firmware) leads from a controller with newer firmware to a finished
/// pack.
///
/// If the spec of a later version of this crate has an entry of your pack, the module keeps the entry's names as names
/// of this crate's items. `jaka spec check` lists these entries. If this crate has a different item under such a name,
/// and your program would notice the difference, the result is a compiler error.
#[macro_export]
macro_rules! pack {
    ($($input:tt)+) => {
        $crate::__private::pack! { ($crate) $($input)+ }
    };
}

/// Sender of commands: a [`Client`], a `jaka_robot::Robot`, or a type that forwards to one of them.
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

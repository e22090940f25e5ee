//! What can send commands.

use crate::{Client, Command, Error};

/// What can send commands: a [`Client`], a `jaka_robot::Robot`, or a type of your own that forwards them.
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

//! Another client of the command port, which does nothing but be there.

use std::io;
use std::net::TcpStream;
use std::sync::Mutex;
use std::time::Duration;

use crate::lock::lock;
use crate::shared::Shared;

/// How long the kernel may take for a connection.
const PATIENCE: Duration = Duration::from_secs(2);

/// The connection of the other client, from its end.
#[derive(Debug, Default)]
pub(crate) struct Rival(Mutex<Option<TcpStream>>);

impl Rival {
    /// Takes the seat from whoever has it.
    ///
    /// The rival stands at the door before the client sees its end, so a client that comes back comes after it.
    pub(crate) fn take_seat(&self, shared: &Shared) -> io::Result<()> {
        let line = shared.seat.give_up();
        let stream = TcpStream::connect_timeout(&shared.command_door.address(), PATIENCE);
        if let Some(line) = line {
            line.close();
        }
        *lock(&self.0) = Some(stream?);
        Ok(())
    }

    /// Ends the connection, if it still is one.
    pub(crate) fn leave(&self) {
        lock(&self.0).take();
    }
}

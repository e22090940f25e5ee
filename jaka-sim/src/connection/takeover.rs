//! Another client of the command port, which takes the port and then does nothing.

use std::io;
use std::net::{SocketAddr, TcpStream};
use std::sync::Mutex;
use std::time::Duration;

use super::ActiveClient;
use crate::lock::lock;

/// How long the kernel may take for a connection.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(2);

/// The connection of the other client, from its end.
#[derive(Debug, Default)]
pub(crate) struct TakeoverClient(Mutex<Option<TcpStream>>);

impl TakeoverClient {
    /// Connects to the command port in place of the active client.
    ///
    /// This client is connected before the active one sees its end, so a client that reconnects comes after it.
    pub(crate) fn take_over(&self, active: &ActiveClient, port: SocketAddr) -> io::Result<()> {
        let before = active.replace(None);
        let stream = TcpStream::connect_timeout(&port, CONNECT_TIMEOUT);
        if let Some(connection) = before {
            connection.close();
        }
        *lock(&self.0) = Some(stream?);
        Ok(())
    }

    /// Ends the connection, if there is one.
    pub(crate) fn disconnect(&self) {
        lock(&self.0).take();
    }
}

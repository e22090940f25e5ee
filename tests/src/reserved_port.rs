//! A port that refuses connections.

use std::net::{Ipv4Addr, SocketAddr};

use socket2::{Domain, Socket, Type};

/// A port of loopback on which nothing listens, unless it is given the port's number. Nothing else gets it while this
/// lives, as it could if a
/// listener had been dropped; and a dropped listener goes on for as long as a program that is just being started has a
/// copy of it.
#[derive(Debug)]
pub struct ReservedPort {
    address: SocketAddr,
    _socket: Socket,
}

impl ReservedPort {
    /// One that is free.
    ///
    /// # Panics
    /// The system has none.
    #[must_use = "the port is given back when this is dropped"]
    pub fn any() -> Self {
        Self::at((Ipv4Addr::LOCALHOST, 0).into())
    }

    /// The one of a listener that has just been shut down.
    ///
    /// # Panics
    /// Somebody else has it.
    #[must_use = "the port is given back when this is dropped"]
    pub fn at(address: SocketAddr) -> Self {
        let socket = Socket::new(Domain::IPV4, Type::STREAM, None).expect("the system has sockets");
        socket.set_reuse_address(true).expect("it can be set");
        socket.bind(&address.into()).expect("the port is free");
        let address = socket.local_addr().ok().and_then(|address| address.as_socket()).expect("it is bound");
        Self { address, _socket: socket }
    }

    /// Its address.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

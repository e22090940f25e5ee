//! Addresses, with or without a port, and connections to them.

use std::io;
use std::net::{IpAddr, SocketAddr, TcpStream, ToSocketAddrs};
use std::time::Instant;

use socket2::{SockRef, TcpKeepalive};

use crate::{Config, Error};

/// Connects to `address`; `port` is used where it names none.
pub(crate) fn connect(address: &str, port: u16, config: &Config) -> Result<TcpStream, Error> {
    let failed = |source| Error::Connect { address: address.to_owned(), source };
    let stream = first_that_answers(address, port, config).map_err(failed)?;
    set_options(&stream, config).map_err(failed)?;
    Ok(stream)
}

fn first_that_answers(address: &str, port: u16, config: &Config) -> io::Result<TcpStream> {
    let deadline = Instant::now() + config.connect_timeout;
    let mut last = io::Error::new(io::ErrorKind::NotFound, "the name stands for no address");
    for candidate in resolve(address, port)? {
        let left = deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(io::Error::new(io::ErrorKind::TimedOut, "no answer within the connect timeout"));
        }
        match TcpStream::connect_timeout(&candidate, left) {
            Ok(stream) => return Ok(stream),
            Err(error) => last = error,
        }
    }
    Err(last)
}

fn resolve(address: &str, port: u16) -> io::Result<Vec<SocketAddr>> {
    if let Ok(ip) = address.trim_matches(['[', ']']).parse::<IpAddr>() {
        return Ok(vec![SocketAddr::new(ip, port)]);
    }
    let found = if address.contains(':') { address.to_socket_addrs() } else { (address, port).to_socket_addrs() };
    found.map(Iterator::collect)
}

fn set_options(stream: &TcpStream, config: &Config) -> io::Result<()> {
    // Without this a command waits for the acknowledgement of the one before: 40 ms and more.
    stream.set_nodelay(true)?;
    stream.set_write_timeout(Some(config.write_timeout))?;
    if let Some(idle) = config.keepalive {
        let keepalive = TcpKeepalive::new().with_time(idle).with_interval(idle / 3);
        SockRef::from(stream).set_tcp_keepalive(&keepalive)?;
    }
    Ok(())
}

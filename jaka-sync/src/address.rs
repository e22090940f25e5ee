//! Addresses, with or without a port.

use std::io;
use std::net::{IpAddr, SocketAddr, ToSocketAddrs};

/// True for `10.5.5.100:10001`, not for `10.5.5.100` or `fe80::1`.
pub fn names_a_port(address: &str) -> bool {
    ip(address).is_none() && address.contains(':')
}

/// The socket addresses of `address`; `port` is used where it names none.
pub(crate) fn resolve(address: &str, port: u16) -> io::Result<Vec<SocketAddr>> {
    if let Some(ip) = ip(address) {
        return Ok(vec![SocketAddr::new(ip, port)]);
    }
    let found = if address.contains(':') { address.to_socket_addrs() } else { (address, port).to_socket_addrs() };
    found.map(Iterator::collect)
}

/// `address` with a port: its own, or this one.
pub(crate) fn with_port(address: &str, port: u16) -> String {
    match ip(address) {
        Some(ip) => SocketAddr::new(ip, port).to_string(),
        None if address.contains(':') => address.to_owned(),
        None => format!("{address}:{port}"),
    }
}

fn ip(address: &str) -> Option<IpAddr> {
    address.trim_matches(['[', ']']).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ports_are_distinguished_from_parts_of_addresses() {
        for (address, expected, with_port) in [
            ("10.5.5.100", false, "10.5.5.100:10000"),
            ("10.5.5.100:10001", true, "10.5.5.100:10001"),
            ("robot.local", false, "robot.local:10000"),
            ("robot.local:10001", true, "robot.local:10001"),
            ("fe80::1", false, "[fe80::1]:10000"),
            ("[fe80::1]", false, "[fe80::1]:10000"),
            ("[fe80::1]:10001", true, "[fe80::1]:10001"),
        ] {
            assert_eq!(names_a_port(address), expected, "{address}");
            assert_eq!(super::with_port(address, 10000), with_port);
        }
    }
}

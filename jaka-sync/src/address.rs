//! Addresses, with or without a port.

use std::io;
use std::net::{IpAddr, SocketAddr, ToSocketAddrs};

/// True for `10.5.5.100:10001`, not for `10.5.5.100` or `fe80::1`.
pub(crate) fn names_a_port(address: &str) -> bool {
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

fn ip(address: &str) -> Option<IpAddr> {
    address.trim_matches(['[', ']']).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ports_are_distinguished_from_parts_of_addresses() {
        for (address, expected) in [
            ("10.5.5.100", false),
            ("10.5.5.100:10001", true),
            ("robot.local", false),
            ("robot.local:10001", true),
            ("fe80::1", false),
            ("[fe80::1]", false),
            ("[fe80::1]:10001", true),
        ] {
            assert_eq!(names_a_port(address), expected, "{address}");
        }
    }
}

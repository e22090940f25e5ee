//! Connections to a controller.

use std::io;
use std::net::{IpAddr, SocketAddr, TcpStream, ToSocketAddrs};
use std::time::Duration;

use jaka_clock::{Clock, Socket};
use jaka_proto::recording::Port;
use socket2::{SockRef, TcpKeepalive};

use crate::recorder::Tap;
use crate::{COMMAND_PORT, Config, Error, ErrorKind, STATUS_PORT};

/// Range of keepalive times that systems accept, in seconds.
const KEEPALIVE: std::ops::RangeInclusive<u64> = 1..=32767;

/// Connects to a controller, and records it. `port` selects one of its two ports, which is used if the address names
/// none.
pub(crate) fn connect(address: &str, port: Port, config: &Config) -> Result<(Socket, Tap), Error> {
    let (number, what) = match port {
        Port::Command => (COMMAND_PORT, "commands"),
        Port::Status => (STATUS_PORT, "status packets"),
    };
    let place = with_port(address, number);
    let tap = Tap::new(&place, port, config.recorder.as_ref(), config.recorded_status_interval, &config.clock);
    match connect_to(address, number, config) {
        Ok(stream) => {
            log::debug!(target: "jaka_sync", "connected to {place} (port for {what})");
            tap.connected(&stream);
            Ok((stream, tap))
        }
        Err(source) => Err(tap.attach(ErrorKind::Connect { address: place, port, source }.into())),
    }
}

fn connect_to(address: &str, port: u16, config: &Config) -> io::Result<Socket> {
    let stream = first_that_answers(&resolve(address, port)?, config.connect_timeout)?;
    set_options(&stream, config)?;
    Socket::connected(stream, &config.clock)
}

/// Connects to the first candidate that answers. The candidates share the time: a silent one uses only its own share.
fn first_that_answers(candidates: &[SocketAddr], timeout: Duration) -> io::Result<TcpStream> {
    // The system's connect timeout is in real time.
    let since = Clock::default().stopwatch();
    let mut failed = Vec::new();
    for (candidate, others) in candidates.iter().zip((1..=candidates.len()).rev()) {
        let left = since.left_of(timeout);
        let share = left / u32::try_from(others).unwrap_or(u32::MAX);
        // The system rejects a timeout of zero, and the time left may be zero.
        match TcpStream::connect_timeout(candidate, share.max(Duration::from_millis(1))) {
            Ok(stream) => return Ok(stream),
            Err(error) => failed.push((*candidate, error)),
        }
    }
    Err(none_answers(failed))
}

/// Error for a name without an address that accepts a connection.
fn none_answers(mut failed: Vec<(SocketAddr, io::Error)>) -> io::Error {
    if failed.len() == 1 {
        return failed.remove(0).1;
    }
    let Some((_, last)) = failed.last() else {
        return io::Error::new(io::ErrorKind::NotFound, "the name resolves to no address");
    };
    let texts: Vec<_> = failed.iter().map(|(address, error)| format!("{address}: {error}")).collect();
    io::Error::new(last.kind(), texts.join("; "))
}

fn set_options(stream: &TcpStream, config: &Config) -> io::Result<()> {
    // Without this a command waits for the acknowledgement of the one before: 40 ms and more.
    stream.set_nodelay(true)?;
    if let Some(idle) = config.keepalive {
        let [idle, interval] = keepalive(idle).map(Duration::from_secs);
        SockRef::from(stream).set_tcp_keepalive(&TcpKeepalive::new().with_time(idle).with_interval(interval))?;
    }
    Ok(())
}

/// Times before the first probe and between probes, in seconds, in the range that systems accept.
fn keepalive(idle: Duration) -> [u64; 2] {
    let up = idle.as_secs().saturating_add(u64::from(idle.subsec_nanos() > 0));
    let idle = up.clamp(*KEEPALIVE.start(), *KEEPALIVE.end());
    [idle, (idle / 3).max(*KEEPALIVE.start())]
}

/// True for `10.5.5.100:10001`, not for `10.5.5.100` or `fe80::1`.
pub fn names_a_port(address: &str) -> bool {
    ip(address).is_none() && address.contains(':')
}

/// Socket addresses of `address`; `port` is used if it names none.
pub(crate) fn resolve(address: &str, port: u16) -> io::Result<Vec<SocketAddr>> {
    if let Some(ip) = ip(address) {
        return Ok(vec![SocketAddr::new(ip, port)]);
    }
    let found = if address.contains(':') { address.to_socket_addrs() } else { (address, port).to_socket_addrs() };
    found.map(Iterator::collect)
}

/// `address` with its own port, or with this port if it has none.
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
    use std::net::TcpListener;
    use std::thread;

    use socket2::{Domain, Type};

    use super::*;

    /// Port that no other process gets while the socket lives. It refuses connections until the socket listens.
    fn bound() -> (socket2::Socket, SocketAddr) {
        let socket = socket2::Socket::new(Domain::IPV4, Type::STREAM, None).expect("sockets are to be had");
        socket.bind(&SocketAddr::from(([127, 0, 0, 1], 0)).into()).expect("loopback has free ports");
        let address = socket.local_addr().ok().and_then(|address| address.as_socket()).expect("it is bound");
        (socket, address)
    }

    /// Port at which connections wait without an answer while these sockets live: its backlog is full.
    fn silent() -> (socket2::Socket, Vec<socket2::Socket>, SocketAddr) {
        let (socket, address) = bound();
        socket.listen(1).expect("it is bound");
        let mut waiting = Vec::new();
        loop {
            let client = socket2::Socket::new(Domain::IPV4, Type::STREAM, None).expect("sockets are to be had");
            client.set_nonblocking(true).expect("it is open");
            // A nonblocking socket reports an error while it connects.
            client.connect(&address.into()).ok();
            // A sleep that is longer only gives the system more time.
            let is_connected = (0..50).any(|_| {
                thread::sleep(Duration::from_millis(2));
                client.peer_addr().is_ok()
            });
            if !is_connected {
                return (socket, waiting, address);
            }
            waiting.push(client);
            assert!(waiting.len() < 100);
        }
    }

    /// Timeouts of an attempt: a thread that was held up for the whole time attempts again with more.
    fn times() -> impl Iterator<Item = Duration> {
        (0..7).map(|n| Duration::from_secs(1 << n))
    }

    #[test]
    fn a_silent_address_leaves_time_for_the_others() {
        let (_silent, _waiting, silent) = silent();
        let (_refusing, refusing) = bound();
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let answering = listener.local_addr().expect("it is bound");
        for candidates in [vec![silent, answering], vec![refusing, silent, silent, answering]] {
            let stream = times().find_map(|time| first_that_answers(&candidates, time).ok());
            let stream = stream.expect("the last one answers");
            assert_eq!(stream.peer_addr().expect("it is connected"), answering);
        }
    }

    #[test]
    fn the_error_names_each_address_and_why_it_failed() {
        let (_silent, _waiting, silent) = silent();
        let (_refusing, refusing) = bound();
        let mut errors = times().map(|time| first_that_answers(&[refusing, silent], time).expect_err("none answers"));
        let error = errors.find(|error| error.to_string().contains("refused")).expect("there was time");
        let text = error.to_string();
        assert_eq!(error.kind(), io::ErrorKind::TimedOut);
        assert!(text.starts_with(&format!("{refusing}: ")), "{text}");
        assert!(text.contains(&format!("; {silent}: ")) && text.contains("timed out"), "{text}");
        // The error around it names the only address.
        let error = first_that_answers(&[refusing], Duration::MAX).expect_err("nobody listens");
        assert_eq!(error.kind(), io::ErrorKind::ConnectionRefused);
        assert_eq!(
            first_that_answers(&[], Duration::MAX).expect_err("there is none").to_string(),
            "the name resolves to no address"
        );
    }

    #[test]
    fn no_timeout_and_no_keepalive_is_too_long_or_too_short() {
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let address = listener.local_addr().expect("it is bound").to_string();
        for time in [
            Duration::ZERO,
            Duration::from_nanos(1),
            Duration::from_secs(2),
            Duration::from_secs(40_000),
            Duration::MAX,
        ] {
            let config = Config::new().connect_timeout(time.max(Duration::from_secs(60))).keepalive(Some(time));
            connect_to(&address, 0, &config).unwrap_or_else(|error| panic!("{time:?}: {error}"));
        }
        assert_eq!(keepalive(Duration::from_millis(2100)), [3, 1]);
        assert_eq!(keepalive(Duration::from_secs(9)), [9, 3]);
        assert_eq!(keepalive(Duration::MAX), [32767, 10922]);
    }

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

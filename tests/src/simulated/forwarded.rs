//! Connection that passes through a test on its way to a command port.

use std::io::{Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr};
use std::sync::Arc;
use std::thread;

use jaka_sim::SimulatedClock;
use jaka_sim::jaka_clock::Stream;

/// Listens for one client of a controller, in the time of a clock, and shows the bytes of both directions before they
/// are passed on; who sees them may change them. Returns the address to which the client connects.
///
/// # Panics
/// Loopback has no free port.
pub(super) fn forwarded(
    clock: &SimulatedClock,
    controller: SocketAddr,
    see_requests: impl FnMut(&mut Vec<u8>) + Send + 'static,
    see_replies: impl FnMut(&mut Vec<u8>) + Send + 'static,
) -> SocketAddr {
    let listener = clock.bind((Ipv4Addr::LOCALHOST, 0).into()).expect("loopback has free ports");
    let (address, clock) = (listener.local_addr(), clock.clone());
    thread::spawn(move || {
        let near = Arc::new(listener.accept().expect("it listens"));
        let far = Arc::new(clock.connect(controller).expect("the controller listens"));
        let (place, back) = (clock.servant(), (Arc::clone(&far), Arc::clone(&near)));
        thread::spawn(move || place.run(|| pass(&back.0, &back.1, see_replies)));
        let place = clock.servant();
        thread::spawn(move || place.run(|| pass(&near, &far, see_requests)));
    });
    address
}

/// Passes bytes on to the end of the connection.
fn pass(mut from: &Stream, mut to: &Stream, mut see: impl FnMut(&mut Vec<u8>)) {
    let mut space = vec![0; 1 << 16];
    while let Ok(count @ 1..) = from.read(&mut space) {
        let mut bytes = space[..count].to_vec();
        see(&mut bytes);
        if to.write_all(&bytes).is_err() {
            return;
        }
    }
    // An error says that it has ended already.
    to.shutdown(Shutdown::Both).ok();
}

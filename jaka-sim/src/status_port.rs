//! Status port (10000): any number of readers, each of which gets the state periodically.

use std::io;
use std::sync::Arc;

use jaka_clock::Socket;

use crate::Port;
use crate::link::Wire;
use crate::readers::{Reader, RecordedPackets};
use crate::shared::Shared;

/// Accepts readers until the listener is closed.
pub(crate) fn run(shared: &Arc<Shared>) {
    shared.status_listener.accept_all("status reader", |socket| admit(socket, shared));
    shared.readers.close();
    shared.status_listener.stop();
}

fn admit(socket: Socket, shared: &Arc<Shared>) -> io::Result<()> {
    log::trace!(target: "jaka_sim", "status reader connected");
    let host = Arc::clone(shared);
    if let Some(session) = &shared.replay {
        let Some(script) = session.next_reader() else {
            Wire::new(socket, Port::Status, &shared.links)?.close();
            return Ok(());
        };
        let packets = RecordedPackets::new(script, host.options.period(), host.time());
        return shared.readers.add(socket, &shared.links, move |reader| {
            if let Some(session) = &host.replay {
                reader.replay(packets, session);
            }
        });
    }
    // With a stepped clock, each step sends the packets.
    let period = Some(host.options.real_period()).filter(|_| !host.options.stepped);
    let run = move |reader: &Reader| reader.run(period, || host.packet());
    shared.readers.add(socket, &shared.links, run)
}

//! Port 10000: any number of readers, each of which is sent the state again and again.

use std::io;
use std::net::TcpStream;
use std::sync::Arc;

use crate::Port;
use crate::link::Wire;
use crate::readers::{Reader, RecordedPackets};
use crate::shared::Shared;

/// Accepts readers until the listener is closed.
pub(crate) fn run(shared: &Arc<Shared>) {
    shared.status_listener.accept_all("status reader", |stream| admit(stream, shared));
    shared.readers.close();
    shared.status_listener.stop();
}

fn admit(stream: TcpStream, shared: &Arc<Shared>) -> io::Result<()> {
    log::trace!(target: "jaka_sim", "status reader connected");
    let host = Arc::clone(shared);
    if let Some(session) = &shared.replay {
        let Some(script) = session.next_reader() else {
            Wire::new(stream, Port::Status, &shared.links)?.close();
            return Ok(());
        };
        let packets = RecordedPackets::new(script, host.options.period());
        return shared.readers.add(stream, &shared.links, move |reader| {
            if let Some(session) = &host.replay {
                reader.replay(packets, session);
            }
        });
    }
    // With a stepped clock, packets go out as it is stepped.
    let period = Some(host.options.real_period()).filter(|_| !host.options.stepped);
    let run = move |reader: &Reader| reader.run(period, || host.packet());
    shared.readers.add(stream, &shared.links, run)
}

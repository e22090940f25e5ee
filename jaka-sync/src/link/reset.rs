//! Breaking a connection so that what is queued is not delivered.

use std::net::Shutdown;
use std::sync::Arc;
use std::time::Duration;

use socket2::SockRef;

use super::Link;
use crate::Disconnect;

/// How long a thread that was woken may take to leave the socket: far longer than it needs.
const LEAVING: Duration = Duration::from_secs(1);

impl Link {
    /// Breaks the connection for good, and has the system discard what it has not sent yet. The first cause stays.
    ///
    /// Only the close of the last handle with a linger time of zero discards it, and only while no thread reads: a `shutdown` delivers
    /// it, and so does a close while another thread blocks in a read. So each thread that reads or writes is woken, the last to leave closes the socket,
    /// and this waits for that. What the network or the controller holds cannot be recalled.
    pub fn reset(&self, cause: Disconnect) -> Arc<Disconnect> {
        let mut state = self.state.lock();
        let broken = state.broken.get_or_insert_with(|| {
            self.tap.broken(&cause);
            Arc::new(cause)
        });
        let broken = Arc::clone(broken);
        self.state.wake();
        let Some(stream) = state.stream.take() else { return broken };
        // An error here means that the socket is closed already.
        let _ = SockRef::from(stream.system()).set_linger(Some(Duration::ZERO));
        // Wakes a thread that reads, and sends nothing. One that waits to send is woken by an end of sending alone; what that delivers
        // until this thread has left is what would be delivered without a reset.
        let _ = stream.shutdown(if state.outbound.is_some() { Shutdown::Read } else { Shutdown::Both });
        let others = Arc::downgrade(&stream);
        drop(stream);
        let since = self.clock.stopwatch();
        while others.strong_count() > 0 && since.passed() < LEAVING {
            state = self.state.wait(state, LEAVING);
        }
        broken
    }
}

//! The way to the next status packet, over bytes that belong to none.

use jaka_proto::framing::{FrameError, Framer};

use crate::Disconnect;
use crate::error::is_text_line;
use crate::recorder::Tap;

/// Records what the framer drops next, since no packet begins in it, and says how many bytes that is.
pub(crate) fn record_lost(framer: &Framer, tap: &Tap) -> usize {
    tap.stray(framer.lost());
    framer.lost().len()
}

/// Continues at the next packet, and returns how many bytes before it were dropped; firmware that sends text has no packets.
pub(crate) fn resync(framer: &mut Framer, tap: &Tap, error: FrameError) -> Result<usize, Disconnect> {
    if is_text_line(&error) {
        return Err(Disconnect::Frame(error));
    }
    let before = tap.copy(framer.partial());
    let dropped = framer.resync();
    tap.stray(before.get(..dropped).unwrap_or_default());
    log::debug!(target: "jaka_sync::wire", "status: {dropped} bytes dropped, {error}");
    Ok(dropped)
}

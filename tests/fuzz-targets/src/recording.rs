//! Recordings.

use jaka_proto::recording::Recording;
use jaka_proto::wire::Writer;

/// A recording that was read comes back when it is written and read again, with the same replies to the same requests.
///
/// # Panics
/// It does not.
pub fn recording(data: &[u8]) {
    let Ok(mut recording) = Recording::read(data).inspect_err(|error| drop(error.to_string())) else { return };
    recording.truncated = None;
    let mut out = Writer::new();
    recording.write(&mut out);
    let again = Recording::read(out.as_str().as_bytes()).unwrap_or_else(|error| panic!("{error}: {}", out.as_str()));
    assert_eq!(again, recording);
    assert_eq!(again.answers(), recording.answers());
}

//! Recordings in memory.

use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use jaka_proto::recording::{Event, Port, Recording};
use jaka_sync::Recorder;

use crate::{Arm, ArmBuilder};

/// A file in memory.
#[derive(Debug, Clone, Default)]
pub struct RecordingBuffer(Arc<Mutex<Vec<u8>>>);

impl Write for RecordingBuffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl RecordingBuffer {
    /// A recorder that writes here.
    ///
    /// # Panics
    /// The system has no thread left.
    pub fn recorder(&self) -> Recorder {
        Recorder::new(self.clone()).expect("a thread can be had")
    }

    /// Reads the recording that has been written so far.
    ///
    /// # Errors
    /// The bytes are not a recording.
    pub fn read(&self) -> Result<Recording, String> {
        let bytes = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        Recording::read(&bytes).map_err(|error| format!("the recording cannot be read: {error}"))
    }

    /// Ends a recording, and reads it.
    ///
    /// # Errors
    /// It cannot be written or read, or something was lost.
    pub fn finish(&self, recorder: &Recorder) -> Result<Recording, String> {
        let report = recorder.finish().map_err(|error| format!("the recorder failed: {error}"))?;
        let recording = self.read()?;
        let entries = u64::try_from(recording.entries.len()).unwrap_or_default();
        if report.dropped > 0 || report.entries != entries || recording.truncated.is_some() {
            return Err(format!("a recording has {entries} entries: {report:?}"));
        }
        Ok(recording)
    }
}

/// Runs a session of an arm whose clients are recorded: what it returns, and the recording.
///
/// # Panics
/// The arm does not start, or something was lost.
pub fn recorded<T>(arm: ArmBuilder, session: impl FnOnce(&Arm) -> T) -> (T, Recording) {
    let buffer = RecordingBuffer::default();
    let recorder = buffer.recorder();
    let arm = arm.config(|config| config.recorder(recorder.clone())).start();
    let result = session(&arm);
    (result, buffer.finish(&recorder).expect("memory loses nothing"))
}

/// The requests of a recording.
pub fn requests(recording: &Recording) -> Vec<String> {
    let commands = recording.entries.iter().filter(|entry| entry.port == Port::Command);
    let sent = commands.filter_map(|entry| if let Event::Sent(message) = &entry.event { Some(message) } else { None });
    sent.map(ToString::to_string).collect()
}

/// Events of a recording without times and addresses, which differ from run to run.
pub fn events(recording: &Recording) -> Vec<(Port, u32, Event)> {
    let without_address = |event: &Event| match event {
        Event::Connected { .. } => Event::Connected { address: String::new() },
        other => other.clone(),
    };
    recording.entries.iter().map(|entry| (entry.port, entry.connection, without_address(&entry.event))).collect()
}

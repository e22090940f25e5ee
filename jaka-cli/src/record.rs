//! Recordings that commands make.

use std::fs::File;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use jaka_sync::{Recorder, RecorderReport};

use crate::failure::Failure;

/// A recording that is being made.
#[derive(Debug)]
pub(crate) struct Tape {
    path: PathBuf,
    recorder: Recorder,
}

/// The one of `--record`.
static TAPE: OnceLock<Tape> = OnceLock::new();

impl Tape {
    /// Begins a recording in a new file. One that exists is not overwritten: it may be the only trace of what went wrong.
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let file = File::create_new(path).map_err(|error| match error.kind() {
            ErrorKind::AlreadyExists => {
                Failure::Usage(format!("{} exists already, and recordings are not overwritten", path.display()))
            }
            _ => failed(path, error),
        })?;
        let recorder = Recorder::new(file).map_err(|error| failed(path, error))?;
        Ok(Self { path: path.to_owned(), recorder })
    }

    pub(crate) fn recorder(&self) -> Recorder {
        self.recorder.clone()
    }

    /// Ends the recording, with all that was recorded in the file.
    pub(crate) fn finish(&self) -> Result<RecorderReport, Failure> {
        self.recorder.finish().map_err(|error| failed(&self.path, error))
    }

    /// Has [`finish`] end this recording.
    pub(crate) fn keep(self) {
        // A command has one robot, and so one recording.
        drop(TAPE.set(self));
    }
}

fn failed(path: &Path, error: std::io::Error) -> Failure {
    Failure::local(format!("cannot record to {}", path.display()), error)
}

/// Ends the recording of `--record`, if there is one, before the program ends.
pub(crate) fn finish() -> Result<(), Failure> {
    TAPE.get().map_or(Ok(()), |tape| tape.finish().map(drop))
}

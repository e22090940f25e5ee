//! Recording of a command.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use jaka_sync::proto::text::visible_json;
use jaka_sync::{Recorder, RecorderReport};

use crate::failure::Failure;

/// Recording of the command, which has one robot and so at most one recording.
static RECORDING: OnceLock<(PathBuf, Recorder)> = OnceLock::new();

/// Starts the recording in a new file. Does not overwrite an existing one: it may be the only trace of a problem.
pub(crate) fn begin(path: &Path) -> Result<Recorder, Failure> {
    let file = File::create_new(path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            Failure::Usage(format!("{} exists already, and recordings are not overwritten", path.display()))
        }
        _ => failed(path, error),
    })?;
    let recorder = Recorder::new(VisibleJson(file)).map_err(|error| failed(path, error))?;
    let (_, recorder) = RECORDING.get_or_init(|| (path.to_owned(), recorder));
    Ok(recorder.clone())
}

/// Ends the recording, if there is one, and writes all of it to the file. Removes a recording without a connection.
pub(crate) fn finish() -> Result<RecorderReport, Failure> {
    let Some((path, recorder)) = RECORDING.get() else { return Ok(RecorderReport::default()) };
    let report = recorder.finish().map_err(|error| failed(path, error))?;
    if report.connections == 0 {
        // The file may be gone already.
        fs::remove_file(path).ok();
    }
    Ok(report)
}

/// Writer of the lines of a recording in visible characters, for people who read the file. Their JSON values are
/// unchanged.
#[derive(Debug)]
struct VisibleJson(File);

impl Write for VisibleJson {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // A recorder writes whole lines of text.
        match std::str::from_utf8(bytes) {
            Ok(text) => self.0.write_all(visible_json(text).as_bytes())?,
            Err(_) => self.0.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

fn failed(path: &Path, error: io::Error) -> Failure {
    Failure::local(format!("cannot record to {}", path.display()), error)
}

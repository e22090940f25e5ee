//! Files that are read as a whole.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// Most bytes of a text that [`read_text`] reads: 64 MiB, far beyond any pack, configuration or list of points.
pub const LONGEST_TEXT: u64 = 1 << 26;

/// Opens a regular file for reading.
///
/// # Errors
/// As [`File::open`]; [`io::ErrorKind::InvalidInput`] for anything else than a regular file. A FIFO that nobody writes
/// would block for ever, and a device may have no end.
pub fn open_regular(path: impl AsRef<Path>) -> io::Result<File> {
    let is_regular = |metadata: io::Result<fs::Metadata>| metadata.map(|metadata| metadata.is_file());
    if is_regular(fs::metadata(&path))? {
        let file = File::open(path)?;
        if is_regular(file.metadata())? {
            return Ok(file);
        }
    }
    Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"))
}

/// Reads a regular file as a whole.
///
/// # Errors
/// As [`open_regular`] and [`read_at_most`].
pub fn read_file(path: impl AsRef<Path>, most: u64) -> io::Result<Vec<u8>> {
    read_at_most(open_regular(path)?, most)
}

/// Reads the text of a regular file, of [`LONGEST_TEXT`] at most.
///
/// # Errors
/// As [`read_file`]; [`io::ErrorKind::InvalidData`] if the text is not UTF-8.
pub fn read_text(path: impl AsRef<Path>) -> io::Result<String> {
    text_of(open_regular(path)?)
}

/// Reads a text to its end, of [`LONGEST_TEXT`] at most: that of standard input, for example.
///
/// # Errors
/// As [`read_at_most`]; [`io::ErrorKind::InvalidData`] if the text is not UTF-8.
pub fn text_of(source: impl Read) -> io::Result<String> {
    io::read_to_string(read_at_most(source, LONGEST_TEXT)?.as_slice())
}

/// Reads a source to its end.
///
/// # Errors
/// The errors of the source; [`io::ErrorKind::FileTooLarge`] if it has more bytes.
pub fn read_at_most(source: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut source = source.take(most);
    source.read_to_end(&mut bytes)?;
    if source.limit() == 0 && source.into_inner().read(&mut [0])? > 0 {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, format!("it has more than {most} bytes")));
    }
    Ok(bytes)
}

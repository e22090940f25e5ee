//! Files that are no files, or have no end.

use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::PathBuf;

use jaka_spec::{LONGEST_TEXT, open_regular, read_at_most, read_file, read_text, text_of};

/// Returns the path of a file that does not exist yet.
fn scratch(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_file(&path);
    path
}

#[test]
fn a_file_is_read_up_to_the_bound() {
    let path = scratch("files_bound");
    fs::write(&path, "twelve bytes").expect("it can be written");
    assert_eq!(read_text(&path).expect("a text"), "twelve bytes");
    assert_eq!(read_file(&path, 12).expect("no more than that"), b"twelve bytes");
    let error = read_file(&path, 11).expect_err("it is longer");
    assert_eq!((error.kind(), error.to_string().as_str()), (ErrorKind::FileTooLarge, "it has more than 11 bytes"));
    File::options()
        .write(true)
        .open(&path)
        .and_then(|file| file.set_len(LONGEST_TEXT + 1))
        .expect("it can be made longer");
    assert_eq!(read_text(&path).expect_err("it is longer").kind(), ErrorKind::FileTooLarge);
    fs::write(&path, [0xff]).expect("it can be written");
    assert_eq!(read_text(&path).expect_err("no UTF-8").kind(), ErrorKind::InvalidData);
}

#[test]
fn a_source_without_end_is_given_up() {
    assert_eq!(read_at_most(io::repeat(b'#'), 1000).expect_err("it has no end").kind(), ErrorKind::FileTooLarge);
    assert_eq!(text_of(io::repeat(b'#')).expect_err("it has no end").kind(), ErrorKind::FileTooLarge);
    assert_eq!(text_of(io::empty()).expect("nothing"), "");
}

#[test]
fn only_regular_files_are_read() {
    assert_eq!(read_text(scratch("files_none")).expect_err("there is none").kind(), ErrorKind::NotFound);
    let is_none = |path: PathBuf| {
        let error = open_regular(&path).expect_err("it is no file");
        assert_eq!(error.to_string(), "it is not a regular file", "{}", path.display());
    };
    is_none(PathBuf::from(env!("CARGO_TARGET_TMPDIR")));
    if cfg!(unix) {
        is_none("/dev/zero".into());
        let fifo = scratch("files_fifo");
        let made = std::process::Command::new("mkfifo").arg(&fifo).status().expect("mkfifo runs");
        assert!(made.success());
        is_none(fifo);
    }
}

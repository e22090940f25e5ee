//! Files on the command line that are no files, or have no end.

use std::fs::{self, File};
use std::process::Command;

use super::{scratch, without_robot};

/// Command lines, with `FILE` for a file that is read as a whole.
const LINES: [&str; 11] = [
    "call get_version --dry-run --pack FILE",
    "call get_version --dry-run --config FILE",
    "call get_version --dry-run --params @FILE",
    "status --config FILE -r cell1",
    "spec check FILE",
    "move --joints 0,90,90,90,-90,0 --speed 1 --dry-run --limits FILE",
    "follow FILE --model zu5 --dry-run --within-deg 1",
    "report FILE",
    "replay FILE",
    "sim --faults @FILE",
    "sim --pack FILE",
];

fn refused(line: &str, file: &str, why: &str) {
    let run = without_robot(line.replace("FILE", file).split(' '));
    assert!(run.code != 0 && run.err.contains(why), "{line}: {run:?}");
}

/// Nobody writes the FIFO: a reader would wait for ever.
#[cfg(unix)]
#[test]
fn only_regular_files_are_read() {
    let fifo = scratch("fifo.csv");
    assert!(Command::new("mkfifo").arg(&fifo).status().expect("mkfifo runs").success());
    for line in LINES {
        refused(line, &fifo.display().to_string(), "it is not a regular file");
        refused(line, "/dev/zero", "it is not a regular file");
        refused(line, &std::env::temp_dir().display().to_string(), "it is not a regular file");
    }
    let folder = scratch("programs");
    fs::create_dir_all(&folder).expect("it can be made");
    fs::rename(&fifo, folder.join("endless.jks")).expect("it can be moved");
    refused("sim --programs FILE", &folder.display().to_string(), "program `endless.jks`: it is not a regular file");
}

#[test]
fn a_text_that_is_too_long_is_refused() {
    let path = scratch("long.csv");
    File::create(&path).and_then(|file| file.set_len(jaka_spec::LONGEST_TEXT + 1)).expect("it can be made so long");
    for line in LINES.into_iter().filter(|line| !line.starts_with("report") && !line.starts_with("replay")) {
        refused(line, &path.display().to_string(), "it has more than 67108864 bytes");
    }
}

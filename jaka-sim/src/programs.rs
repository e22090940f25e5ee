//! Programs: lists of the protocol's own motion commands.

use std::collections::HashMap;
use std::path::Path;
use std::{fs, io, vec};

use jaka_proto::Request;
use jaka_proto::messages::motion::JointMove;

use crate::motion::Joints;

/// Commands of a program, in order.
pub(crate) type Program = Vec<Request>;

/// Remaining commands of the running program.
pub(crate) type Runner = vec::IntoIter<Request>;

/// Returns the programs of every controller: the document's example, which moves joint 1 there and back.
pub(crate) fn built_in() -> HashMap<String, Program> {
    let turn = |angle: f64| {
        let offset = [angle, 0.0, 0.0, 0.0, 0.0, 0.0];
        Request::JointMove(JointMove::relative(offset, 30.0).acceleration(120.0))
    };
    let program = vec![turn(10.0), turn(-10.0)];
    HashMap::from([("test.jks".to_owned(), program.clone()), ("track/test.jks".to_owned(), program)])
}

/// Creates a program that moves through recorded positions.
pub(crate) fn replay(points: &[Joints]) -> Program {
    let to = |joints: &Joints| Request::JointMove(JointMove::absolute(*joints, 30.0).acceleration(120.0));
    points.iter().map(to).collect()
}

/// Reads the programs of a folder: files with one request per line, as sent on the wire. A program has the name of its
/// file after the folders below `root`.
pub(crate) fn load_folder(folder: &Path, prefix: &str, programs: &mut HashMap<String, Program>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            load_folder(&entry.path(), &format!("{name}/"), programs)?;
        } else {
            let unread = |error: io::Error| io::Error::new(error.kind(), format!("program `{name}`: {error}"));
            let text = jaka_spec::read_text(entry.path()).map_err(unread)?;
            let invalid = |error| io::Error::new(io::ErrorKind::InvalidData, format!("program `{name}`, {error}"));
            let program = parse(&text).map_err(invalid)?;
            programs.insert(name, program);
        }
    }
    Ok(())
}

fn parse(text: &str) -> Result<Program, String> {
    let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let read =
        |(number, line): (usize, &str)| Request::read(line).map_err(|error| format!("line {}: {error}", number + 1));
    lines.map(read).collect()
}

//! Specs as files: a folder of TOML files, or a pack on the built-in spec.

use std::fs;
use std::path::Path;

use jaka_spec::{BUILTIN, Source, Spec};

use crate::builtin;
use crate::failure::Failure;
use crate::target::packs;

/// Word for the built-in spec on a command line.
const BUILTIN_NAME: &str = "builtin";

/// Reads the TOML files of a folder, each with its path and text: first those of the built-in spec in its order, then
/// the others by name.
///
/// A `Cargo.toml` is not part of the spec: the folder of its crate has one.
pub(super) fn read(folder: &Path) -> Result<Vec<(String, String)>, Failure> {
    let listed = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let listed = listed.map_err(|error| Failure::Usage(format!("cannot read {}: {error}", folder.display())))?;
    let mut paths: Vec<_> = listed.iter().map(fs::DirEntry::path).filter(|path| is_topic(path)).collect();
    if paths.is_empty() {
        return Err(Failure::Usage(format!("the folder {} has no TOML files", folder.display())));
    }
    paths.sort_by_cached_key(|path| (place(path), path.clone()));
    paths.into_iter().map(|path| Ok((path.display().to_string(), packs::read(&path)?))).collect()
}

/// Returns the files as sources of the spec.
pub(super) fn sources(files: &[(String, String)]) -> Vec<Source<'_>> {
    files.iter().map(|(path, text)| Source { path, text }).collect()
}

fn is_topic(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "toml") && !path.ends_with("Cargo.toml")
}

/// Returns the index of the file of this name in the built-in spec; the greatest number if it has none.
fn place(path: &Path) -> usize {
    let is_same = |source: &Source<'_>| Path::new(source.path).file_name() == path.file_name();
    BUILTIN.iter().position(is_same).unwrap_or(usize::MAX)
}

/// Returns the spec of a word of the command line: `builtin`, a folder, or a pack on the built-in spec.
pub(super) fn spec(word: &Path) -> Result<Spec, Failure> {
    if word == Path::new(BUILTIN_NAME) {
        return Ok(builtin::spec().clone());
    }
    if !word.is_dir() {
        return packs::add(builtin::spec(), word);
    }
    jaka_spec::load(&sources(&read(word)?))
        .map_err(|errors| Failure::Usage(format!("the spec in {} has errors:\n{errors}", word.display())))
}

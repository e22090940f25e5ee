//! `jaka spec check`: all errors of packs and specs.

use std::path::{Path, PathBuf};

use clap::Args;
use jaka_spec::{Command, Error, Errors, Source, Spec, tools};

use super::files;
use crate::builtin;
use crate::failure::Failure;
use crate::target::packs;
use crate::terminal::output;
use crate::text::number::count;

/// Check packs, or a whole spec, and list their additions and changes.
///
/// Prints all errors with file, line and column. Checks examples against the fields of their commands, and each pack on
/// top of the spec and the packs before it.
#[derive(Debug, Args)]
pub(super) struct SpecCheck {
    /// Packs, in order
    #[arg(value_name = "FILE", required_unless_present = "spec")]
    packs: Vec<PathBuf>,
    /// Folder of TOML files with the whole spec, instead of the built-in one
    #[arg(long, value_name = "FOLDER")]
    spec: Option<PathBuf>,
}

impl SpecCheck {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let mut found = Found::default();
        let mut spec = match &self.spec {
            Some(folder) => whole(folder, &mut found)?,
            None => builtin::spec().clone(),
        };
        for path in &self.packs {
            if let Some(with_pack) = pack(&spec, path, &mut found)? {
                spec = with_pack;
            }
        }
        found.finish()
    }
}

/// Found errors, of which the first are printed.
#[derive(Debug, Default)]
struct Found {
    printed: usize,
    more: usize,
}

impl Found {
    fn tell(&mut self, error: impl FnOnce() -> Error) -> Result<(), Failure> {
        if self.printed == Errors::MOST {
            self.more += 1;
            return Ok(());
        }
        self.printed += 1;
        output::line(&error().to_string())
    }

    fn tell_all(&mut self, errors: &Errors) -> Result<(), Failure> {
        errors.iter().try_for_each(|error| self.tell(|| error.clone()))?;
        self.more += errors.more();
        Ok(())
    }

    /// Prints the number of errors not printed.
    fn tell_more(&self) -> Result<(), Failure> {
        if self.more > 0 { output::line(&format!("and {}", count(self.more, "more error"))) } else { Ok(()) }
    }

    /// Returns a failure if there is an error.
    fn finish(&self) -> Result<(), Failure> {
        self.tell_more()?;
        match self.printed + self.more {
            0 => Ok(()),
            errors => Err(Failure::Usage(count(errors, "error"))),
        }
    }
}

/// Checks the examples of the commands of a file against their fields.
fn examples(found: &mut Found, spec: &Spec, commands: &[Command], source: Source<'_>) -> Result<(), Failure> {
    let mut misfits = commands.iter().flat_map(|command| jaka_dynamic::misfits(spec, command));
    misfits.try_for_each(|misfit| {
        if misfit.is_lenient { note(&error(&misfit, source)) } else { found.tell(|| error(&misfit, source)) }
    })
}

/// Prints a note, which is not an error.
fn note(Error { path, line, column, message }: &Error) -> Result<(), Failure> {
    output::line(&format!("{path}:{line}:{column}: note: {message}"))
}

/// Returns a misfit at the position of its example.
fn error(misfit: &jaka_dynamic::Misfit, source: Source<'_>) -> Error {
    // The file has its text unchanged if it needs no escapes, as between single quotes.
    let place = source.text.find(&misfit.message).or_else(|| source.text.find(&misfit.command));
    source.error(place.unwrap_or_default(), misfit.to_string())
}

/// Checks a folder with a whole spec; without its spec, packs could not be checked.
fn whole(folder: &Path, found: &mut Found) -> Result<Spec, Failure> {
    let files = files::read(folder)?;
    let sources = files::sources(&files);
    let spec = match jaka_spec::load(&sources) {
        Ok(spec) => spec,
        Err(errors) => {
            found.tell_all(&errors)?;
            found.tell_more()?;
            return Err(Failure::Usage(format!("the spec in {} has errors", folder.display())));
        }
    };
    for (topic, source) in spec.topics.iter().zip(sources) {
        examples(found, &spec, &topic.commands, source)?;
    }
    let (commands, types, codes) = (spec.commands().count(), spec.types().count(), spec.errors().count());
    let events: usize = spec.events().map(|event| event.codes().count()).sum();
    let folder = folder.display();
    output::line(&format!("{folder}: {commands} commands, {types} types, {codes} error codes, {events} events"))?;
    Ok(spec)
}

/// Checks a pack on top of a spec, and returns the spec with it if it loads.
fn pack(spec: &Spec, path: &Path, found: &mut Found) -> Result<Option<Spec>, Failure> {
    let name = path.display().to_string();
    let source = Source { path: &name, text: &packs::read(path)? };
    let pack = match jaka_spec::load_pack(spec, source) {
        Ok(pack) => pack,
        Err(errors) => return found.tell_all(&errors).map(|()| None),
    };
    pack.notes.iter().try_for_each(note)?;
    pack.module_errors.iter().try_for_each(|error| {
        let message = format!("it cannot be given to `pack!`: {}", error.message);
        note(&Error { message, ..error.clone() })
    })?;
    let added = pack.spec.topics.last().map_or(&[][..], |topic| &topic.commands);
    examples(found, &pack.spec, added, source)?;
    let changes = tools::diff(spec, &pack.spec);
    output::line(&format!("{name}: {}", tools::summary(&changes)))?;
    changes.iter().try_for_each(|change| output::line(&format!("  {change}")))?;
    Ok(Some(pack.spec))
}

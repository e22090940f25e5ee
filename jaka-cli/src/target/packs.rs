//! Protocol with the user's command packs.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use jaka_robot::proto::CommandInfo;
use jaka_spec::{Command, Source, Spec};

use crate::builtin;
use crate::failure::Failure;
use crate::target::{Lookup, usual_packs};
use crate::terminal::output;

/// Option for the packs of a command.
#[derive(Debug, Default, Args)]
pub(crate) struct SpecArgs {
    /// Files, in order.
    #[arg(
        long = "pack",
        help = "Command pack: a TOML file that adds to the protocol; repeat it for more [env: JAKA_PACK]",
        value_name = "FILE"
    )]
    packs: Vec<PathBuf>,
}

/// Protocol with packs.
#[derive(Debug)]
pub(crate) struct Protocol {
    pub(crate) spec: Spec,
    /// Files of the packs, in order.
    pub(crate) packs: Vec<PathBuf>,
    /// Whether the config file names the packs: the user has confirmed the effects that they give their commands.
    pub(crate) is_confirmed: bool,
    /// Facts of the requested commands, which stay in memory: once for each command.
    infos: RefCell<BTreeMap<String, &'static CommandInfo>>,
}

impl Protocol {
    pub(crate) fn new(spec: Spec, packs: Vec<PathBuf>, is_confirmed: bool) -> Self {
        Self { spec, packs, is_confirmed, infos: RefCell::default() }
    }

    /// Returns the facts of a command of this protocol.
    pub(crate) fn info(&self, command: &Command) -> &'static CommandInfo {
        let mut infos = self.infos.borrow_mut();
        infos.entry(command.wire.clone()).or_insert_with(|| jaka_dynamic::command_info(command))
    }

    /// Makes this the protocol of status packets. Called before the first packet.
    pub(crate) fn read_status(&self) {
        builtin::read_status_by(&self.spec);
    }
}

impl SpecArgs {
    /// Creates the options with these packs.
    pub(crate) fn of(packs: Vec<PathBuf>) -> Self {
        Self { packs }
    }

    /// Loads the protocol with its packs. The notes of a pack go to standard error.
    ///
    /// # Errors
    /// All errors of a pack, one a line.
    pub(crate) fn load(&self, lookup: Lookup<'_>) -> Result<Protocol, Failure> {
        let (packs, is_confirmed) =
            if self.packs.is_empty() { usual_packs(lookup)? } else { (self.packs.clone(), false) };
        let spec = packs.iter().try_fold(builtin::spec().clone(), |spec, path| add(&spec, path))?;
        Ok(Protocol::new(spec, packs, is_confirmed))
    }
}

/// Reads the text of a file named on the command line.
pub(crate) fn read(path: &Path) -> Result<String, Failure> {
    jaka_spec::read_text(path).map_err(|error| Failure::Usage(format!("cannot read {}: {error}", path.display())))
}

/// Adds a pack to the spec. The notes of the pack go to standard error.
///
/// # Errors
/// All errors of the pack, one a line.
pub(crate) fn add(spec: &Spec, path: &Path) -> Result<Spec, Failure> {
    let name = path.display().to_string();
    let text = read(path)?;
    let pack = jaka_spec::load_pack(spec, Source { path: &name, text: &text })
        .map_err(|errors| Failure::Usage(format!("the pack {name} has errors:\n{errors}")))?;
    for note in &pack.notes {
        output::warning(&note.to_string());
    }
    Ok(pack.spec)
}

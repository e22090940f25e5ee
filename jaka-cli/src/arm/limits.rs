//! The limits of the arm, as the command line has them.

use std::path::{Path, PathBuf};

use clap::Args;
use jaka_motion::{Limits, Model};

use crate::failure::Failure;
use crate::target::model;
use crate::target::packs;

/// The options that give limits.
#[derive(Debug, Args)]
pub(crate) struct LimitsArgs {
    /// The arm's model, such as zu5: what is beyond its published limits is not sent
    #[arg(long, value_name = "NAME", value_parser = model)]
    model: Option<&'static Model>,
    /// The arm's limits, with its model: a TOML file; what is beyond them is not sent
    #[arg(long, value_name = "FILE", conflicts_with = "model")]
    limits: Option<PathBuf>,
}

impl LimitsArgs {
    /// The limits, if any are given.
    pub(crate) fn read(&self) -> Result<Option<Limits>, Failure> {
        match &self.limits {
            Some(path) => read(path).map(Some),
            None => Ok(self.model.map(Limits::of)),
        }
    }
}

/// The acceleration of a motion of the joints: as given, or else, with limits, the lowest of them, since a motion whose
/// acceleration is not known cannot be compared with limits.
pub(crate) fn acceleration_deg_s2(given: Option<f64>, limits: Option<&Limits>) -> Option<f64> {
    given.or_else(|| limits?.joint_accelerations().iter().copied().reduce(f64::min))
}

/// The limits of a file.
pub(crate) fn read(path: &Path) -> Result<Limits, Failure> {
    let name = path.display().to_string();
    Limits::from_toml(&packs::read(path)?, &name).map_err(|errors| Failure::Usage(errors.to_string()))
}

//! Limits of the arm from the command line.

use std::path::{Path, PathBuf};

use clap::Args;
use jaka_motion::{Limits, Model};

use crate::failure::Failure;
use crate::target::model;
use crate::target::packs;

/// Options for limits.
#[derive(Debug, Args)]
pub(crate) struct LimitsArgs {
    /// Model of the arm, such as zu5: nothing beyond its published limits is sent
    #[arg(long, value_name = "NAME", value_parser = model)]
    model: Option<&'static Model>,
    /// TOML file with the limits of the arm and its model: nothing beyond them is sent
    #[arg(long, value_name = "FILE", conflicts_with = "model")]
    limits: Option<PathBuf>,
}

impl LimitsArgs {
    /// Returns the limits, if any are given.
    pub(crate) fn read(&self) -> Result<Option<Limits>, Failure> {
        match &self.limits {
            Some(path) => read(path).map(Some),
            None => Ok(self.model.map(Limits::of)),
        }
    }
}

/// Returns the acceleration of a joint motion: the given one, or else the lowest of the limits, since a motion with
/// unknown acceleration cannot be compared with limits.
pub(crate) fn acceleration_deg_s2(given: Option<f64>, limits: Option<&Limits>) -> Option<f64> {
    given.or_else(|| limits?.joint_accelerations().iter().copied().reduce(f64::min))
}

/// Reads the limits of a file.
pub(crate) fn read(path: &Path) -> Result<Limits, Failure> {
    let name = path.display().to_string();
    Limits::from_toml(&packs::read(path)?, &name).map_err(|errors| Failure::Usage(errors.to_string()))
}

//! The spec that comes with this crate.

use crate::{Errors, Source, Spec};

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        &[$(Source { path: concat!("spec/", $name), text: include_str!(concat!("../", $name)) }),*]
    };
}

/// The files of the built-in spec, in the order in which the topics are documented.
pub const BUILTIN: &[Source<'static>] = files![
    "power.toml",
    "motion.toml",
    "servo.toml",
    "program.toml",
    "io.toml",
    "frames.toml",
    "variables.toml",
    "payload.toml",
    "collision.toml",
    "kinematics.toml",
    "trajectory.toml",
    "force.toml",
    "network.toml",
    "session.toml",
    "beyond_state.toml",
    "beyond_io.toml",
    "beyond_settings.toml",
    "status.toml",
    "types.toml",
    "errors.toml",
    "events.toml",
];

/// Loads the built-in spec.
///
/// # Errors
/// None in a released version: the spec is checked before release. While editing, the same as [`load`](crate::load).
pub fn builtin() -> Result<Spec, Errors> {
    crate::load(BUILTIN)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn each_file_of_the_spec_is_listed() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let files = std::fs::read_dir(folder).expect("the folder of the spec").map(|entry| {
            let name = entry.expect("a file").file_name();
            name.into_string().expect("a name in Unicode")
        });
        let mut toml: Vec<_> = files.filter(|name| name.contains(".toml") && name != "Cargo.toml").collect();
        let mut listed: Vec<_> = BUILTIN.iter().map(|source| source.path.replace("spec/", "")).collect();
        toml.sort_unstable();
        listed.sort_unstable();
        assert_eq!(listed, toml);
    }
}

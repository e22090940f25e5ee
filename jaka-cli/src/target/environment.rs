//! Variables of the environment.

use std::env::var_os;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Variables that `jaka` reads. An empty one counts as not set.
#[derive(Debug, Default)]
pub(crate) struct Environment {
    /// `JAKA_ROBOT`.
    pub(crate) robot: Option<OsString>,
    /// `JAKA_CONFIG`.
    pub(crate) config: Option<PathBuf>,
    /// `JAKA_PACK`: paths of packs, separated as in `PATH`.
    pub(crate) packs: Option<OsString>,
    /// Folder of the user's config files.
    pub(crate) config_folder: Option<PathBuf>,
}

impl Environment {
    /// Reads the environment of this process.
    pub(crate) fn read() -> Self {
        if cfg!(test) {
            return Self::default();
        }
        let get = |name| var_os(name).filter(|value| !value.is_empty());
        let folder = |name| get(name).map(PathBuf::from);
        let below_home = || folder("HOME").map(|home| home.join(".config"));
        Self {
            robot: get("JAKA_ROBOT"),
            config: folder("JAKA_CONFIG"),
            packs: get("JAKA_PACK"),
            config_folder: folder("XDG_CONFIG_HOME").or_else(|| folder("APPDATA")).or_else(below_home),
        }
    }

    /// Returns the default path of the config file.
    pub(crate) fn usual_config(&self) -> Option<PathBuf> {
        self.config_folder.as_ref().map(|folder| folder.join(Path::new("jaka").join("config.toml")))
    }
}

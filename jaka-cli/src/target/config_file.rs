//! Config file with robots by name.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Deserialize;

use crate::failure::Failure;
use crate::text::seconds;

/// Contents of a config file. Unknown keys are errors.
#[derive(Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConfigFile {
    /// Robot for command lines without one.
    pub(crate) robot: Option<String>,
    /// Command packs of robots without their own: paths, relative to the config file's folder.
    #[serde(default)]
    pub(crate) packs: Vec<PathBuf>,
    /// Robots by name.
    #[serde(default)]
    pub(crate) robots: BTreeMap<String, Entry>,
}

/// Table `[robots.NAME]`.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Entry {
    /// Host name or IP address, without a port.
    pub(crate) address: String,
    /// Command pack of this robot, in place of `packs`: a path, relative to the config file's folder.
    pub(crate) pack: Option<PathBuf>,
    /// Port for commands.
    pub(crate) command_port: Option<u16>,
    /// Port for status packets.
    pub(crate) status_port: Option<u16>,
    /// Timeout for a reply or a status packet, in seconds.
    #[serde(default, deserialize_with = "seconds::from_file")]
    pub(crate) timeout: Option<Duration>,
    /// Timeout for connecting, in seconds.
    #[serde(default, deserialize_with = "seconds::from_file")]
    pub(crate) connect_timeout: Option<Duration>,
    /// Age, in seconds, at which status packets are stale while the program waits for a motion.
    #[serde(default, deserialize_with = "seconds::from_file")]
    pub(crate) stale_after: Option<Duration>,
}

impl ConfigFile {
    /// Reads a file that must exist.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        Self::read_if_there(path)?
            .ok_or_else(|| Failure::Usage(format!("the config file {} does not exist", path.display())))
    }

    /// Reads a file that may be missing.
    pub(crate) fn read_if_there(path: &Path) -> Result<Option<Self>, Failure> {
        match jaka_spec::read_text(path) {
            Ok(text) => Self::parse(&text, path).map(Some),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(Failure::Usage(format!("cannot read the config file {}: {error}", path.display()))),
        }
    }

    fn parse(text: &str, path: &Path) -> Result<Self, Failure> {
        let mut file: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            Failure::Usage(format!("{}:{line}: {}", path.display(), error.message().trim_end()))
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let own = file.robots.values_mut().filter_map(|robot| robot.pack.as_mut());
        file.packs.iter_mut().chain(own).for_each(|pack| *pack = folder.join(&pack));
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    fn check(text: &str, expected: &Expect) {
        let found = ConfigFile::parse(text, Path::new("config.toml"));
        expected.assert_eq(&found.map_or_else(|failure| failure.to_string(), |file| format!("{file:?}")));
    }

    #[test]
    fn robots_have_names() {
        let text = "
            robot = 'cell1'
            [robots.cell1]
            address = '10.5.5.100'
            timeout = 2
            connect_timeout = 0.5
            stale_after = 0.3
            [robots.'cell 2']
            address = 'arm.local'
            status_port = 20000
        ";
        check(
            text,
            &expect![[
                r#"ConfigFile { robot: Some("cell1"), packs: [], robots: {"cell 2": Entry { address: "arm.local", pack: None, command_port: None, status_port: Some(20000), timeout: None, connect_timeout: None, stale_after: None }, "cell1": Entry { address: "10.5.5.100", pack: None, command_port: None, status_port: None, timeout: Some(2s), connect_timeout: Some(500ms), stale_after: Some(300ms) }} }"#
            ]],
        );
    }

    #[test]
    fn packs_are_relative_to_the_file() {
        let file = ConfigFile::parse("packs = ['a.toml', '/b.toml']", Path::new("folder/config.toml"));
        assert_eq!(file.unwrap().packs, [Path::new("folder/a.toml"), Path::new("/b.toml")]);
    }

    #[test]
    fn errors_say_at_which_line() {
        check("robot = 1", &expect!["config.toml:1: invalid type: integer `1`, expected a string"]);
        check("\n\nrobots = 'cell1'", &expect![[r#"config.toml:3: invalid type: string "cell1", expected a map"#]]);
        check(
            "[robots.a]\naddress = 'x'\nport = 1\n",
            &expect![
                "config.toml:3: unknown field `port`, expected one of `address`, `pack`, `command_port`, `status_port`, `timeout`, `connect_timeout`, `stale_after`"
            ],
        );
        check("[robots.a]\nstatus_port = 1\n", &expect!["config.toml:1: missing field `address`"]);
        check(
            "[robots.a]\naddress = 'x'\nstatus_port = 70000\n",
            &expect!["config.toml:3: invalid value: integer `70000`, expected u16"],
        );
        check(
            "[robots.a]\naddress = 'x'\ntimeout = -1\n",
            &expect!["config.toml:3: -1 is not a valid number of seconds"],
        );
        check("[robots.a]\naddress = 'x'\n\n[robots.a]\n", &expect!["config.toml:4: duplicate key"]);
        check("robot = ", &expect!["config.toml:1: string values must be quoted, expected literal string"]);
    }
}

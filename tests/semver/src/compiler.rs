//! Compiles crates by calling the compiler itself, with libraries that cargo has built.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};

use serde_json::Value;

/// Module of jaka-proto that makes the messages; a file replaces it here.
const MACRO: &str = "pub mod messages {\n    jaka_proto_derive::messages!();\n}";

/// Folder of the sources and of what is compiled, and the libraries.
#[derive(Debug)]
pub(crate) struct Compiler {
    folder: PathBuf,
    /// Names and files of the libraries of jaka-proto.
    libraries: Vec<(String, PathBuf)>,
}

/// Errors of a crate that does not compile, each on its line.
#[derive(Debug)]
pub(crate) struct Errors(String);

impl std::fmt::Display for Errors {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let lines: Vec<_> = self.lines().take(6).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl Errors {
    pub(crate) fn lines(&self) -> impl Iterator<Item = &str> {
        self.0.lines().filter(|line| line.contains(": error") || line.starts_with("error"))
    }

    /// True if all errors are in the file with the generated messages.
    pub(crate) fn are_in_messages(&self) -> bool {
        self.lines().all(|line| line.contains("messages.rs:") || line.starts_with("error: aborting"))
    }
}

impl Compiler {
    /// Copies jaka-proto for two versions, `old` and `new`, and asks cargo for the libraries.
    pub(crate) fn new() -> Self {
        let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
        let libraries = libraries(&tests.join("Cargo.toml"));
        let (_, any) = libraries.first().expect("jaka-proto has dependencies");
        // `target/debug/deps/libserde.rlib`
        let target = any.ancestors().nth(3).expect("a library is in a folder of the target");
        let this = Self { folder: target.join("semver"), libraries };
        for version in ["old", "new"] {
            let (from, to) = (tests.join("../../jaka-proto"), this.folder.join(version));
            if to.exists() {
                fs::remove_dir_all(&to).expect("the folder of an earlier run can be removed");
            }
            copy(&from.join("src"), &to.join("src"));
            copy(&from.join("docs"), &to.join("docs"));
            let root = fs::read_to_string(from.join("src/lib.rs")).expect("the crate has a root");
            assert!(root.contains(MACRO), "the root of jaka-proto makes its messages in another way");
            write(&to.join("src/lib.rs"), &root.replace(MACRO, "#[allow(missing_docs)]\npub mod messages;"));
        }
        this
    }

    /// Compiles the crate of one version, `old` or `new`, with these messages.
    pub(crate) fn library(&self, version: &str, messages: &str) -> Result<(), Errors> {
        write(&self.folder.join(version).join("src/messages.rs"), messages);
        let mut command = self.call("rustc", version);
        command.arg(self.incremental(version));
        verdict(&command.arg(format!("--emit=metadata={}", self.metadata(version))).output().expect("rustc runs"))
    }

    /// Writes the description of one version's interface, and returns its path.
    pub(crate) fn description(&self, version: &str) -> PathBuf {
        let folder = self.folder.join(version).join("doc");
        let mut command = self.call("rustdoc", version);
        // What a nightly compiler does by itself: the format has versions instead of being stable.
        command.env("RUSTC_BOOTSTRAP", "1").args(["-Zunstable-options", "--output-format=json", "--out-dir"]);
        let output = command.arg(&folder).output().expect("rustdoc runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        folder.join("jaka_proto.json")
    }

    fn call(&self, tool: &str, version: &str) -> Command {
        let mut command = Command::new(beside_cargo(tool));
        command.args(["src/lib.rs", "--crate-name=jaka_proto", "--crate-type=lib"]);
        self.usual(&mut command);
        for (name, file) in &self.libraries {
            command.arg("--extern").arg(format!("{name}={}", file.display()));
        }
        command.current_dir(self.folder.join(version));
        command
    }

    /// Compiles a program against the crate of one version.
    pub(crate) fn program(&self, name: &str, code: &str, version: &str) -> Result<(), Errors> {
        let file = self.folder.join(format!("{name}.rs"));
        write(&file, code);
        let mut command = Command::new(beside_cargo("rustc"));
        command.arg(&file).args(["--crate-name=program", "--crate-type=lib"]);
        self.usual(&mut command);
        command.arg("--extern").arg(format!("jaka_proto={}", self.metadata(version)));
        command.arg(self.incremental(name));
        let serde = self.libraries.iter().find(|(name, _)| name == "serde");
        let (_, serde) = serde.expect("jaka-proto depends on serde");
        command.arg("--extern").arg(format!("serde={}", serde.display()));
        let out = self.folder.join(format!("lib{name}.rmeta"));
        verdict(&command.arg(format!("--emit=metadata={}", out.display())).output().expect("rustc runs"))
    }

    fn usual(&self, command: &mut Command) {
        let (_, any) = &self.libraries[0];
        let folder = any.parent().expect("a file is in a folder");
        command.args(["--edition=2024", "--error-format=short", "--cap-lints=allow"]);
        command.arg("-L").arg(format!("dependency={}", folder.display()));
    }

    /// An edit changes little of what is compiled.
    fn incremental(&self, name: &str) -> String {
        format!("-Cincremental={}", self.folder.join("incremental").join(name).display())
    }

    fn metadata(&self, version: &str) -> String {
        self.folder.join(version).join("libjaka_proto.rmeta").display().to_string()
    }
}

/// A tool of the toolchain that runs.
fn beside_cargo(tool: &str) -> PathBuf {
    Path::new(env!("CARGO")).with_file_name(tool)
}

fn verdict(output: &Output) -> Result<(), Errors> {
    if output.status.success() {
        return Ok(());
    }
    Err(Errors(String::from_utf8_lossy(&output.stderr).into_owned()))
}

/// The libraries of jaka-proto, as cargo has built them for this program.
fn libraries(manifest: &Path) -> Vec<(String, PathBuf)> {
    let mut command = Command::new(env!("CARGO"));
    command.args(["build", "--locked", "--quiet", "--message-format=json", "--package=jaka-proto", "--manifest-path"]);
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    // `.cargo/config.toml` is found from here.
    let folder = manifest.parent().expect("a file is in a folder");
    let output = command.arg(manifest).current_dir(folder).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).expect("cargo speaks UTF-8");
    let artifacts: Vec<_> = said.lines().filter_map(artifact).collect();
    let named = |name: &&str| {
        let found = artifacts.iter().find(|(known, _)| known == name);
        found.unwrap_or_else(|| panic!("cargo has not built {name}")).clone()
    };
    ["serde", "serde_json", "itoa", "memchr", "zmij", "jaka_proto_derive"].iter().map(named).collect()
}

/// Name and file of a library that cargo has built.
fn artifact(line: &str) -> Option<(String, PathBuf)> {
    let message: Value = serde_json::from_str(line).ok()?;
    let name = message["target"]["name"].as_str()?.replace('-', "_");
    let files = message["filenames"].as_array()?.iter().filter_map(Value::as_str);
    let is_library = |file: &&str| [".rlib", env::consts::DLL_SUFFIX].iter().any(|suffix| file.ends_with(suffix));
    Some((name, files.into_iter().find(is_library)?.into()))
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("the folder can be made");
    for entry in fs::read_dir(from).expect("the folder can be read") {
        let path = entry.expect("it can be read").path();
        let target = to.join(path.file_name().expect("it has a name"));
        if path.is_dir() {
            copy(&path, &target);
        } else {
            fs::copy(&path, &target).expect("it can be copied");
        }
    }
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

//! A simulated controller in a network namespace, reached by a link that can be taken down.

use std::fmt;
use std::io::{self, BufRead, BufReader, Write};
use std::net::{Ipv4Addr, SocketAddr};
use std::process::{Child, Command, Stdio};

/// A namespace, the two ends of the link to it, and the program in it. All of it is gone when this is dropped.
#[derive(Debug)]
pub(crate) struct Namespace {
    name: String,
    /// The end of the link at this side, and the one in the namespace.
    ends: [String; 2],
    controller: Option<Child>,
}

/// Reason for which a namespace cannot be made here.
#[derive(Debug)]
pub(crate) struct Unavailable(String);

impl fmt::Display for Unavailable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Runs `ip`, and gives what it has to say where it fails.
fn ip(arguments: &[&str]) -> Result<(), Unavailable> {
    let unavailable = |reason: &dyn fmt::Display| Unavailable(format!("`ip {}`: {reason}", arguments.join(" ")));
    let output = Command::new("ip").args(arguments).output().map_err(|error| unavailable(&error))?;
    if output.status.success() {
        return Ok(());
    }
    Err(unavailable(&String::from_utf8_lossy(&output.stderr).trim()))
}

/// An address of a small network that belongs to this process, of those reserved for tests of networks.
fn address(host: u32) -> Ipv4Addr {
    const TESTS: u32 = 198 << 24 | 18 << 16;
    let network = std::process::id() % (1 << 15);
    (TESTS + network * 4 + host).into()
}

impl Namespace {
    /// A namespace with a link to it. Its names and its addresses are those of this process, so it can be only one in
    /// each.
    pub(crate) fn new() -> Result<Self, Unavailable> {
        let pid = std::process::id();
        let ends = [format!("jks{pid}a"), format!("jks{pid}b")];
        let this = Self { name: format!("jaka-sim-{pid}"), ends, controller: None };
        // Left by a process with the same id, which was killed before it could clean up.
        this.remove();
        let [near, far] = this.ends.each_ref().map(String::as_str);
        let (here, there) = (address(1), address(2));
        ip(&["netns", "add", &this.name])?;
        ip(&["link", "add", near, "type", "veth", "peer", "name", far, "netns", &this.name])?;
        ip(&["address", "add", &format!("{here}/30"), "dev", near])?;
        ip(&["-n", &this.name, "address", "add", &format!("{there}/30"), "dev", far])?;
        this.up()?;
        ip(&["link", "set", near, "up"])?;
        Ok(this)
    }

    /// Starts the program in the namespace, and gives the addresses for commands and for status packets.
    pub(crate) fn start(&mut self, options: &[&str]) -> io::Result<[SocketAddr; 2]> {
        let address = address(2).to_string();
        let mut controller = Command::new("ip")
            .args(["netns", "exec", &self.name, env!("CARGO_BIN_EXE_jaka"), "sim"])
            .args(["--address", &address, "--commands", "0", "--status", "0"])
            .args(options)
            .stdout(Stdio::piped())
            .spawn()?;
        let stdout = controller.stdout.take();
        self.controller = Some(controller);
        let mut line = String::new();
        BufReader::new(stdout.ok_or(io::ErrorKind::BrokenPipe)?).read_line(&mut line)?;
        let addresses: Vec<_> = line.split([' ', ',', '\n']).filter_map(|word| word.parse().ok()).collect();
        addresses.try_into().map_err(|_| io::Error::other(format!("the program prints no addresses: {line:?}")))
    }

    /// Takes the link down: packets are lost, and this side knows no more than that its cable is pulled.
    pub(crate) fn down(&self) -> Result<(), Unavailable> {
        ip(&["-n", &self.name, "link", "set", &self.ends[1], "down"])
    }

    /// Takes the link up again.
    pub(crate) fn up(&self) -> Result<(), Unavailable> {
        ip(&["-n", &self.name, "link", "set", &self.ends[1], "up"])
    }

    fn remove(&self) {
        // What is not there need not be removed.
        ip(&["link", "delete", &self.ends[0]]).ok();
        ip(&["netns", "delete", &self.name]).ok();
    }
}

impl Drop for Namespace {
    fn drop(&mut self) {
        if let Some(mut controller) = self.controller.take() {
            controller.kill().ok();
            controller.wait().ok();
        }
        self.remove();
    }
}

/// Says that a test has not been made, and why: to the standard error itself, which the test harness does not capture.
pub(crate) fn skipped(test: &str, reason: &dyn fmt::Display) {
    writeln!(io::stderr(), "SKIPPED {test}: {reason}").ok();
}

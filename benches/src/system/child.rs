//! Servers in processes of their own.

use std::io::{self, BufRead, BufReader};
use std::net::SocketAddr;
use std::process::{Child, Command, Stdio};

/// A server's process, which ends with this.
#[derive(Debug)]
pub struct Server {
    child: Child,
    robots: Vec<Addresses>,
}

/// Addresses of the command port and the status port of one robot.
#[derive(Debug, Clone, Copy)]
pub struct Addresses {
    /// Of the command port.
    pub commands: SocketAddr,
    /// Of the status port.
    pub status: SocketAddr,
}

impl Server {
    /// Starts a program that prints the two addresses of each of its robots in a line, and an empty line after the
    /// last.
    ///
    /// `core` is the processor that it is bound to, by `taskset`; any, if it is none.
    ///
    /// # Errors
    /// It does not start, or prints something else.
    pub fn start(program: &str, arguments: &[&str], core: Option<&str>) -> io::Result<Self> {
        let mut command = match core {
            Some(core) => {
                let mut command = Command::new("taskset");
                command.args(["-c", core, program]);
                command
            }
            None => Command::new(program),
        };
        // It ends when its standard input does, also if this process is killed.
        let mut child = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let output = child.stdout.take().ok_or_else(|| io::Error::other("no standard output"))?;
        let mut robots = Vec::new();
        for line in BufReader::new(output).lines() {
            let line = line?;
            if line.is_empty() {
                break;
            }
            robots.push(Addresses::read(&line).ok_or_else(|| io::Error::other(line))?);
        }
        Ok(Self { child, robots })
    }

    /// The addresses of its robots.
    pub fn robots(&self) -> &[Addresses] {
        &self.robots
    }

    /// The id of its process.
    pub fn id(&self) -> u32 {
        self.child.id()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // An error says that it has ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Addresses {
    /// Reads a line as servers print it.
    pub fn read(line: &str) -> Option<Self> {
        let (commands, status) = line.split_once(' ')?;
        Some(Self { commands: commands.parse().ok()?, status: status.parse().ok()? })
    }
}

/// Waits for the end of standard input, which comes when the process that started this one ends.
///
/// # Errors
/// It cannot be read.
pub fn wait_for_parent() -> io::Result<()> {
    io::copy(&mut io::stdin(), &mut io::sink()).map(drop)
}

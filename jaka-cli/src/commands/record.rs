//! `jaka record`: recording of a session with a robot.

pub(crate) mod proxy;

use std::net::IpAddr;
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::Duration;

use clap::{ArgGroup, Args};
use jaka_sync::recording::Port;
use jaka_sync::{ErrorKind, Recorder, RecorderReport, StatusStream};

use crate::arm::interrupt::on_interrupt;
use crate::commands::record::proxy::{ProxyPort, RecordingQueue};
use crate::failure::Failure;
use crate::listen;
use crate::recordings::record;
use crate::target::{AddressArgs, Target};
use crate::terminal::output;
use crate::text::seconds::some_seconds;

/// Hint for ports in use.
const PORTS_IN_USE: &str =
    "end the program that uses the port; or `--listen-commands` and `--listen-status` set other ports, 0 a free one";

/// Record a session to a new file, until it is interrupted.
///
/// Records the traffic between any program and the robot, as a proxy between them (--listen), to which the program
/// connects instead of the robot. Or it records only the robot's status packets (--status-only), which disturbs no
/// other program.
///
/// `jaka replay` shows the file, and answers from it in place of the robot.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("source").required(true).args(["listen", "status_only"]))]
pub(crate) struct Record {
    /// New file, which must not exist
    file: PathBuf,
    /// Act as a proxy between programs and the robot, and listen at this address, such as 127.0.0.1
    ///
    /// Bytes are passed on unchanged and at once, in both directions. Anyone who can reach the address can move the
    /// robot.
    #[arg(long, value_name = "ADDRESS")]
    listen: Option<IpAddr>,
    /// Port of the proxy for commands, 0 for a free one
    #[arg(long, value_name = "PORT", default_value_t = jaka_sync::COMMAND_PORT, requires = "listen")]
    listen_commands: u16,
    /// Port of the proxy for status packets, 0 for a free one
    #[arg(long, value_name = "PORT", default_value_t = jaka_sync::STATUS_PORT, requires = "listen")]
    listen_status: u16,
    /// Record the robot's status packets
    #[arg(long)]
    status_only: bool,
    /// Record at most one status packet per connection in this many seconds; all are passed on
    #[arg(long, value_name = "SECONDS", value_parser = some_seconds)]
    status_every: Option<Duration>,
    /// End after this many status packets, recorded or not
    #[arg(long, short = 'n', value_name = "N", requires = "status_only")]
    count: Option<u64>,
    /// End after this many seconds
    #[arg(long, value_name = "SECONDS", value_parser = some_seconds)]
    seconds: Option<Duration>,
    #[command(flatten)]
    robot: AddressArgs,
}

impl Record {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let target = self.robot.target(&[])?;
        let recorder = record::begin(&self.file)?;
        let (sender, ended) = mpsc::channel();
        let interrupted = sender.clone();
        on_interrupt(move || drop(interrupted.send(Ok(()))));
        let (target, queue) = match self.listen {
            Some(address) => {
                let queue = RecordingQueue::start().map_err(|error| Failure::local("cannot start a thread", error))?;
                self.start_proxy(address, &target, &recorder, &queue)?;
                (target, Some(queue))
            }
            None => (self.read_packets(target, recorder, sender)?, None),
        };
        let result = self.wait(&ended);
        drop(target);
        let missing = queue.map_or(0, |queue| queue.finish());
        self.tell(record::finish()?, missing)?;
        result
    }

    /// Starts serving programs, for as long as this one runs.
    fn start_proxy(
        &self,
        address: IpAddr,
        target: &Target,
        recorder: &Recorder,
        queue: &RecordingQueue,
    ) -> Result<(), Failure> {
        let open = |port, own_port| {
            let (robot, timeout) = target.address(port);
            let (robot, recorder, queue) = (robot.to_owned(), recorder.clone(), queue.clone());
            let port_proxy =
                ProxyPort { port, robot, timeout, recorder, queue, status_interval: self.status_interval() };
            let opened = port_proxy.open(address, own_port);
            let what = format!("cannot listen at {address}, port {own_port}");
            opened.map_err(|error| Failure::unopened(what, error, PORTS_IN_USE))
        };
        listen::print(open(Port::Command, self.listen_commands)?, open(Port::Status, self.listen_status)?)
    }

    /// Reads status packets in a thread, and signals when there are enough, or no more come.
    fn read_packets(
        &self,
        target: Target,
        recorder: Recorder,
        ended: Sender<Result<(), Failure>>,
    ) -> Result<Target, Failure> {
        let target = target.recorded(recorder, self.status_interval());
        let mut stream = target.status_stream()?;
        output::line(&format!("recording the status packets of {}", target.title()))?;
        let count = self.count.unwrap_or(u64::MAX);
        thread::spawn(move || {
            let result = read(&mut stream, count);
            // The recording includes the end of the connection.
            drop(stream);
            ended.send(result)
        });
        Ok(target)
    }

    fn status_interval(&self) -> Duration {
        self.status_every.unwrap_or_default()
    }

    fn wait(&self, ended: &Receiver<Result<(), Failure>>) -> Result<(), Failure> {
        match self.seconds {
            Some(time) => ended.recv_timeout(time).unwrap_or(Ok(())),
            None => ended.recv().unwrap_or(Ok(())),
        }
    }

    /// Prints the number of recorded entries, and of pieces that could not be recorded.
    fn tell(&self, report: RecorderReport, missing: u64) -> Result<(), Failure> {
        let (file, entries) = (self.file.display(), report.entries);
        output::line(&match report.dropped + missing {
            _ if report.connections == 0 => "nothing was recorded".to_owned(),
            0 => format!("{file}: {entries} entries"),
            missing => {
                format!(
                    "{file}: {entries} entries; {missing} are missing, because they arrived faster than they could be recorded"
                )
            }
        })
    }
}

/// Reads this many packets, including those that do not fit the spec.
fn read(stream: &mut StatusStream, count: u64) -> Result<(), Failure> {
    (0..count).try_for_each(|_| match stream.next_packet() {
        Err(error) if !matches!(error.kind(), ErrorKind::UnexpectedStatus { .. }) => Err(error.into()),
        _ => Ok(()),
    })
}

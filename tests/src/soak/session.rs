//! One connection of an arm, with all that stands on it.

use std::time::Duration;

use jaka_robot::{Client, Config, Error, Monitor, Reconnect, Recorder, Robot, RobotConfig, StatusSampling};

use super::account::Connection;
use super::arm::Place;
use super::background::{Hand, observe};
use super::host::Ports;
use super::tally::Tally;
use crate::{RecordingBuffer, requests};

/// Timeout for a reply. In real time a slow machine is not a defect: then there are more timeouts.
const REPLY: Duration = Duration::from_millis(150);

/// The longest message that is taken: shorter than the longest of the faults.
const MAX_FRAME: usize = 64 << 10;

/// Timeout for connecting.
const CONNECT: Duration = Duration::from_secs(60);

/// One in this many status packets is recorded.
const SAMPLING: u32 = 20;

/// One connection of an arm.
#[derive(Debug)]
pub(super) struct Session {
    pub(super) robot: Robot,
    pub(super) hands: Vec<Hand>,
    pub(super) connection: Connection,
    /// Number of calls of `calls::once`; each of the first three sends a command that the connection sees only once.
    pub(super) once: u32,
    /// Number of calls in a row without an answer.
    pub(super) silent: u32,
    recording: Option<(Recorder, RecordingBuffer)>,
}

/// Options of all connections.
pub(super) fn config(ports: &Ports) -> Config {
    let reconnect =
        Reconnect::Attempts { limit: u32::MAX, delay: Duration::from_millis(5), longest: Duration::from_millis(100) };
    let config = Config::new().reply_timeout(REPLY).max_frame(MAX_FRAME).connect_timeout(CONNECT).reconnect(reconnect);
    ports.time.as_simulated().into_iter().fold(config, Config::clock)
}

impl Session {
    pub(super) fn new(place: &Place, first: String, is_recorded: bool) -> Result<Self, Error> {
        let buffer = RecordingBuffer::default();
        let recorder = is_recorded.then(|| buffer.recorder());
        let sampling = StatusSampling::EveryNth(SAMPLING);
        let config = config(&place.ports).status_sampling(sampling);
        let config = recorder.iter().fold(config, |config, recorder| config.recorder(recorder.clone()));
        let monitor: Monitor = Monitor::connect_with(&config, place.ports.status)?;
        observe(&monitor, &place.rate, &place.findings);
        let client = Client::connect_with(&config, place.ports.commands)?;
        // So short that a motion that is stopped is soon known to be.
        let waits = RobotConfig::new().start_grace(Duration::from_millis(60), 3);
        let mut robot = Robot::new(client, monitor).expect("it is the only robot");
        robot.configure(&waits.status_silence(Duration::from_millis(400)))?;
        let time = &place.ports.time;
        // One that ends the robot's waits, and one of which the robot does not know.
        let (stop, unknown_stop) = (robot.stop_handle(), robot.client().stop_handle());
        Ok(Self {
            robot,
            hands: vec![Hand::new(time, move || stop.stop()), Hand::new(time, move || Ok(unknown_stop.stop()?))],
            connection: Connection::new(first),
            once: 0,
            silent: 0,
            recording: recorder.map(|recorder| (recorder, buffer)),
        })
    }

    /// Ends the session, and returns its commands for the account.
    pub(super) fn end(mut self, place: &Place, tally: &mut Tally) -> Connection {
        for hand in self.hands.drain(..) {
            let Some((stops, counts)) = hand.end() else {
                place.findings.add(format!("arm {}: a stop panicked", place.arm));
                continue;
            };
            self.connection.stops.sent += stops.sent;
            self.connection.stops.seen += stops.seen;
            tally.join(&counts);
        }
        let statistics = self.robot.monitor().statistics();
        tally.add("packets", statistics.packets);
        tally.add("monitors reconnected", statistics.reconnects);
        // The connections are closed before the recording ends.
        drop(self.robot);
        if let Some((recorder, buffer)) = self.recording {
            tally.one("recordings");
            let recording = buffer.finish(&recorder).map_err(|finding| place.findings.add(finding));
            self.connection.recorded = recording.ok().as_ref().map(requests);
        }
        self.connection
    }
}

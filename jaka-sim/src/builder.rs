//! Options of a controller.

use std::collections::HashMap;
use std::io::{self, ErrorKind};
use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use jaka_clock::{Clock, SimulatedClock};
use jaka_motion::Model;
use jaka_proto::Request;
use jaka_proto::recording::Recording;

use crate::clock::scaled;
use crate::programs::{self, Program};
use crate::{
    Contact, Delays, FaultPlan, Firmware, Habits, Happening, Replay, ReplayTiming, Scheduled, StopInServo, Trip,
    Underrun,
};

/// Generates [`Builder`] with a field, a default and a setter for each option. The fields listed first have
/// hand-written methods.
macro_rules! options {
    (
        with methods of their own [ $( $field:ident: $Field:ty = $initial:expr; )* ]
        $( $(#[$meta:meta])* $option:ident: $Option:ty = $usual:expr; )*
    ) => {
        /// Options for a [`Controller`](crate::Controller), set before it starts.
        #[derive(Debug, Clone)]
        pub struct Builder {
            $( pub(crate) $option: $Option, )*
            $( pub(crate) $field: $Field, )*
        }

        impl Default for Builder {
            fn default() -> Self {
                Self { $( $option: $usual, )* $( $field: $initial, )* }
            }
        }

        impl Builder {
            $(
                $(#[$meta])*
                #[must_use]
                pub fn $option(mut self, $option: $Option) -> Self {
                    self.$option = $option;
                    self
                }
            )*
        }
    };
}

options! {
    with methods of their own [
        command_port: u16 = 0;
        status_port: u16 = 0;
        habits: Option<Habits> = None;
        trips: Vec<Trip> = Vec::new();
        contact: Option<Contact> = None;
        status_period: Option<Duration> = None;
        scheduled: Vec<Scheduled> = Vec::new();
        stepped: bool = false;
        time: Clock = Clock::default();
        folders: Vec<PathBuf> = Vec::new();
        packs: Vec<PathBuf> = Vec::new();
        programs: HashMap<String, Program> = programs::built_in();
        replay: Option<(Arc<Recording>, Replay)> = None;
    ]

    /// Sets the address to listen at (default: loopback). With any other address, other machines can move the simulated
    /// arm.
    address: IpAddr = Ipv4Addr::LOCALHOST.into();

    /// Sets the arm (default: Zu 5).
    model: Model = Model::default();

    /// Sets the delays of state changes other than motion (default: [`Delays::REAL`]).
    delays: Delays = Delays::REAL;

    /// Sets the lag of the arm behind its commanded positions, as the time constant of a first-order lag (default:
    /// none).
    ///
    /// An arm in motion is behind by its speed times the lag: 1.6 deg at 100 deg/s and 16 ms. It stops later and never
    /// overshoots. On a real arm, commanded and actual joints were observed to differ by up to 0.023 deg; its lag is
    /// unknown.
    ///
    /// `get_joint_pos`, `get_tcp_pos`, and `joint_position` and `position` of packets give the commanded positions.
    /// Without a lag, actual and commanded positions are equal, so that a test can compare positions in each cycle.
    lag: Duration = Duration::ZERO;

    /// Sets the noise of the encoders, in degrees: answers and packets give each joint position with a random number
    /// from minus this to this (default: 0, no noise). The numbers are the same in each run. Poses have no noise. The
    /// noise of a real arm is unknown.
    joint_noise: f64 = 0.0;

    /// Sets the reaction of the arm if set-points stop in servo mode while it moves (default: [`Underrun::Hold`]).
    underrun: Underrun = Underrun::Hold;

    /// Sets the reaction of the controller to `stop_program` in servo mode (default: [`StopInServo::Discard`]).
    stop_in_servo: StopInServo = StopInServo::Discard;

    /// Sets the ratio of the controller's time to real time, from 0.001 to 1000 (default: 1).
    ///
    /// Motions, [`Delays`], habits and the period of status packets use the controller's time. Times of faults,
    /// replays, and clients with their timeouts and servo periods use real time. With a number out of range the
    /// controller does not start.
    ///
    /// The ratio has no effect on a stepped clock.
    time_scale: f64 = 1.0;

    /// Sets the rule for a second client that connects to the command port (default: [`Takeover::Replace`]).
    takeover: Takeover = Takeover::Replace;

    /// Sets the faults of replies and packets (default: none).
    faults: FaultPlan = FaultPlan::new();

    /// Sets the firmware of the controller (default: [`Firmware::V1_5_14`]).
    firmware: Firmware = Firmware::default();

    /// Sets the times at which a replay sends its bytes (default: [`ReplayTiming::Recorded`]).
    replay_timing: ReplayTiming = ReplayTiming::Recorded;
}

impl Builder {
    /// Sets the ports for commands and for status packets (default: 0, which selects free ports). Real controllers use
    /// 10001 and 10000.
    #[must_use]
    pub fn ports(mut self, commands: u16, status: u16) -> Self {
        self.command_port = commands;
        self.status_port = status;
        self
    }

    /// Sets one or several [`Habit`](crate::Habit)s, traits of some real controllers (default: those of the firmware).
    #[must_use]
    pub fn habits(mut self, habits: impl Into<Habits>) -> Self {
        self.habits = Some(habits.into());
        self
    }

    /// Sets the conditions on which the drives stop the arm with an error event (default: none, since the thresholds of
    /// real drives are not published).
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Trip};
    ///
    /// let builder = Controller::builder().lag(Duration::from_millis(16));
    /// let controller = builder.trips([Trip::Deviation(3.0), Trip::CommandAcceleration(2000.0)]).start()?;
    /// # Ok::<(), std::io::Error>(())
    /// ```
    #[must_use]
    pub fn trips(mut self, trips: impl IntoIterator<Item = Trip>) -> Self {
        self.trips = trips.into_iter().collect();
        self
    }

    /// Schedules an event of the arm, of an input or of links for a time since the start of the controller. The event
    /// occurs in the first controller cycle that is not before that time.
    ///
    /// The controller does not start if it does not have the input.
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Happening};
    ///
    /// let controller = Controller::builder().stepped_clock().at(Duration::from_secs(2), Happening::Collide).start()?;
    /// controller.advance(Duration::from_secs(1));
    /// assert!(!controller.state().protective_stop);
    /// controller.advance(Duration::from_secs(1));
    /// assert!(controller.state().protective_stop);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    #[must_use]
    pub fn at(mut self, time: Duration, happening: impl Into<Happening>) -> Self {
        self.scheduled.push(Scheduled { happening: happening.into(), at: time });
        self
    }

    /// Selects a clock that only [`Controller::advance`](crate::Controller::advance) advances, so that a test decides
    /// when the arm moves.
    ///
    /// The controller sends status packets as its time advances, and one to each reader on connecting.
    #[must_use]
    pub fn stepped_clock(mut self) -> Self {
        self.stepped = true;
        self
    }

    /// Sets a simulated clock for connections, faults, status packets and the controller itself (default: the system
    /// clock).
    ///
    /// A client of jaka-sync with the same clock takes part in it, and so does each thread that waits by a method of
    /// the controller. Time advances as soon as all threads wait, so that hours pass in seconds. See
    /// [`SimulatedClock`].
    #[must_use]
    pub fn clock(mut self, clock: &SimulatedClock) -> Self {
        self.time = Clock::simulated(clock);
        self
    }

    /// Adds a program: a list of the protocol's own motion commands that run in sequence.
    ///
    /// Every controller has `test.jks` and `track/test.jks`, which turn joint 1 by 10 degrees and back.
    #[must_use]
    pub fn program(mut self, name: impl Into<String>, commands: Vec<Request>) -> Self {
        self.programs.insert(name.into(), commands);
        self
    }

    /// Adds the programs of a folder and its subfolders. A program file has one request a line, in its wire form. The
    /// program has the name of the file after that of the subfolder, such as `track/part.jks`. The controller reads the
    /// files at its start.
    #[must_use]
    pub fn programs_from(mut self, folder: impl Into<PathBuf>) -> Self {
        self.folders.push(folder.into());
        self
    }

    /// Adds a command pack: a TOML file that adds commands to the spec, or changes existing ones. The controller reads
    /// it at its start.
    ///
    /// The controller checks commands of a pack by the pack's spec, and answers with its example or else with zeros.
    /// For other replies, see [`Controller::set_reply`](crate::Controller::set_reply). A command outside the `since`
    /// and `until` of the pack for the simulated firmware is unknown to the controller, as to a real one: choose a
    /// [`firmware`](Self::firmware), or set [`State::version`](crate::State::version).
    ///
    /// Requests, replies and packets follow a pack in renamed keys, other words for false and true, converted units,
    /// and arrays in the form of objects. The controller refuses a command for which a pack changes the type or the
    /// meaning of a key, since the state has no value for it; the message names the key. Such a key of status packets
    /// is an error at the start. The controller also refuses a reply with a value that the pack does not allow.
    #[must_use]
    pub fn pack(mut self, path: impl Into<PathBuf>) -> Self {
        self.packs.push(path.into());
        self
    }

    pub(crate) fn programs(&self) -> io::Result<HashMap<String, Program>> {
        let mut programs = self.programs.clone();
        for folder in &self.folders {
            programs::load_folder(folder, "", &mut programs)?;
        }
        Ok(programs)
    }

    /// Adds a contact plane as an obstacle for the tool centre point (default: none).
    ///
    /// [`Controller::deepest_penetration`](crate::Controller::deepest_penetration) returns the depth that the tool
    /// reached.
    #[must_use]
    pub fn contact(mut self, contact: Contact) -> Self {
        self.contact = Some(contact);
        self
    }

    /// Sets the period of status packets (default: that of the firmware, which is 30 or 50 ms).
    ///
    /// With [`Duration::MAX`], each reader gets one packet on connecting and then those of
    /// [`Controller::publish`](crate::Controller::publish).
    #[must_use]
    pub fn status_period(mut self, period: Duration) -> Self {
        self.status_period = Some(period);
        self
    }

    /// Answers from a recording instead of with the simulated arm. State and faults then have no effect on replies.
    ///
    /// The controller sends status packets of the recording at their times. After the last packet of a connection, it
    /// repeats that packet every [`status_period`](Self::status_period). Time is real, also with a stepped clock.
    /// [`Controller::deviations`](crate::Controller::deviations) lists the client's deviations from the recording.
    ///
    /// ```
    /// use std::io::{Read, Write};
    /// use std::net::TcpStream;
    ///
    /// use jaka_sim::proto::recording::Recording;
    /// use jaka_sim::{Controller, Replay};
    ///
    /// let recording = Recording::read(br#"{"jaka_recording":1,"started":0,"software":"by hand"}
    /// {"time":0,"port":"command","event":"sent","text":"{\"cmdName\":\"get_version\"}"}
    /// {"time":0,"port":"command","event":"received","text":"{\"errorCode\":\"7\"}"}
    /// "#)?;
    /// let controller = Controller::builder().replay(recording, Replay::Strict).start()?;
    /// let mut client = TcpStream::connect(controller.command_addr())?;
    /// client.write_all(br#"{"cmdName": "get_version"}"#)?;
    /// let mut reply = [0; 17];
    /// client.read_exact(&mut reply)?;
    /// assert_eq!(&reply, br#"{"errorCode":"7"}"#);
    /// assert!(controller.deviations().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn replay(mut self, recording: Recording, mode: Replay) -> Self {
        self.replay = Some((Arc::new(recording), mode));
        self
    }

    /// Returns the period of status packets.
    pub(crate) fn period(&self) -> Duration {
        self.status_period.unwrap_or_else(|| self.firmware.status_period())
    }

    /// Returns the period of status packets in real time.
    pub(crate) fn real_period(&self) -> Duration {
        scaled(self.period(), self.time_scale.recip())
    }

    /// Checks that a controller can start with these options.
    pub(crate) fn check(&self) -> io::Result<()> {
        self.contact.as_ref().map_or(Ok(()), Contact::check)?;
        if (0.001..=1000.0).contains(&self.time_scale) {
            return Ok(());
        }
        let text = format!("a time scale is from 0.001 to 1000, and not {}", self.time_scale);
        Err(io::Error::new(ErrorKind::InvalidInput, text))
    }

    /// Returns the undocumented habits of the controller: those set, or else those of its firmware.
    pub(crate) fn usual_habits(&self) -> Habits {
        self.habits.unwrap_or_else(|| self.firmware.habits())
    }
}

/// Rule for a client that connects to the command port while another one is connected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Takeover {
    /// Makes the new client the active one, and closes the old connection.
    #[default]
    Replace,
    /// Closes the new connection.
    Refuse,
}

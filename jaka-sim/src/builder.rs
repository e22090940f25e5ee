//! The options of a controller.

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
use crate::replay::ReplaySource;
use crate::{Contact, Delays, FaultPlan, Firmware, Habits, Happening, Replay, ReplayTiming, Scheduled, Trip, Underrun};

/// Makes [`Builder`] of a row for each option, with what it is if not set, and a method that sets it. Those that come
/// first have methods of their own.
macro_rules! options {
    (
        with methods of their own [ $( $field:ident: $Field:ty = $initial:expr; )* ]
        $( $(#[$meta:meta])* $option:ident: $Option:ty = $usual:expr; )*
    ) => {
        /// Options for a [`Controller`](crate::Controller), which are set before it starts.
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
        replay: Option<ReplaySource> = None;
    ]

    /// Sets the address to listen at: that of loopback if not set. Any other lets other machines move the simulated
    /// arm.
    address: IpAddr = Ipv4Addr::LOCALHOST.into();

    /// Sets the arm: a Zu 5 if not set.
    model: Model = Model::default();

    /// Sets how long changes of state take, other than motion: [`Delays::REAL`] if not set.
    delays: Delays = Delays::REAL;

    /// Sets by how much the arm lags behind its commanded positions, as the time constant of a first-order lag: none if
    /// not set.
    ///
    /// So an arm in motion is behind by its speed times the lag, 1.6 deg at 100 deg/s and 16 ms, and comes to rest
    /// later. It never overshoots. On a real arm, commanded and actual joints were seen to differ by up to 0.023 deg;
    /// its lag is not known.
    ///
    /// `get_joint_pos`, `get_tcp_pos`, and `joint_position` and `position` of packets are the commanded ones. Without a
    /// lag the arm is where it is commanded to be, so that a test can compare places in each cycle.
    lag: Duration = Duration::ZERO;

    /// Sets what the arm does in servo mode when set-points stop while it has speed: [`Underrun::Hold`] if not set.
    underrun: Underrun = Underrun::Hold;

    /// Lets the controller's time pass so many times as fast as real time, from 0.001 to 1000: 1 if not set.
    ///
    /// Motions, [`Delays`], habits and the time between status packets are the controller's. What is not its own keeps
    /// real time: the times of faults, replays, and clients with their timeouts and servo periods. With any other
    /// number the controller does not start.
    ///
    /// A stepped clock is not affected.
    time_scale: f64 = 1.0;

    /// Sets what happens when a second client connects to the command port: [`Takeover::Replace`] if not set.
    takeover: Takeover = Takeover::Replace;

    /// Sets what goes wrong with replies and packets: nothing if not set.
    faults: FaultPlan = FaultPlan::new();

    /// Sets the firmware that the controller has: [`Firmware::V1_5_14`] if not set.
    firmware: Firmware = Firmware::default();

    /// Sets when a replay sends what it sends: [`ReplayTiming::Recorded`] if not set.
    replay_timing: ReplayTiming = ReplayTiming::Recorded;
}

impl Builder {
    /// Sets the ports for commands and for status packets: 0, for free ones, if not set. Real controllers have 10001
    /// and 10000.
    #[must_use]
    pub fn ports(mut self, commands: u16, status: u16) -> Self {
        self.command_port = commands;
        self.status_port = status;
        self
    }

    /// Sets what the controller does as some real ones do, one or several [`Habit`](crate::Habit)s: those of the
    /// firmware if not set.
    #[must_use]
    pub fn habits(mut self, habits: impl Into<Habits>) -> Self {
        self.habits = Some(habits.into());
        self
    }

    /// Sets what makes the drives stop the arm with an error event: nothing if not set, since the thresholds of real
    /// drives are not published.
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

    /// Has something happen to the arm, to an input or to links at a time of the controller since its start, in the
    /// first controller cycle that is not before it.
    ///
    /// An input that the controller does not have keeps it from starting.
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

    /// Lets time go on by [`Controller::advance`](crate::Controller::advance) alone, so that a test decides when the
    /// arm moves.
    ///
    /// Status packets are sent as time goes on, and each reader gets one on connecting.
    #[must_use]
    pub fn stepped_clock(mut self) -> Self {
        self.stepped = true;
        self
    }

    /// Takes the time from a simulated clock: that of connections, faults and status packets, and the controller's own.
    /// The clock of the system if not set.
    ///
    /// A client of jaka-sync with the same clock takes part in it, and so does each thread that waits by a method of
    /// the controller. Time goes on as soon as all wait, so that hours pass in seconds. See [`SimulatedClock`].
    #[must_use]
    pub fn clock(mut self, clock: &SimulatedClock) -> Self {
        self.time = Clock::simulated(clock);
        self
    }

    /// Adds a program: a list of the protocol's own motion commands, run one after the other.
    ///
    /// Every controller has `test.jks` and `track/test.jks`, which turn joint 1 by 10 degrees and back.
    #[must_use]
    pub fn program(mut self, name: impl Into<String>, commands: Vec<Request>) -> Self {
        self.programs.insert(name.into(), commands);
        self
    }

    /// Adds the programs of a folder and its subfolders: files of requests, one a line, as they go over the wire. A
    /// program's name is that of its file, with the subfolder's before it, such as `track/part.jks`. They are read at
    /// the start.
    #[must_use]
    pub fn programs_from(mut self, folder: impl Into<PathBuf>) -> Self {
        self.folders.push(folder.into());
        self
    }

    /// Adds a command pack: a TOML file that adds commands to the spec, or changes what is there. It is read at the
    /// start.
    ///
    /// Commands of a pack are checked and answered by what it says: with its example, or else with zeros. To answer
    /// something else, see [`Controller::set_reply`](crate::Controller::set_reply). A command that the simulated
    /// firmware does not have by the pack's `since` and `until` is unknown to the controller, as to a real one: choose
    /// a [`firmware`](Self::firmware), or set [`State::version`](crate::State::version).
    ///
    /// Keys that a pack names otherwise than the built-in spec, other words for false and true, units that convert, and
    /// arrays that are objects are followed, in requests, replies and packets, and so are forms by firmware, in those
    /// of [`State::version`](crate::State::version). A command of which a pack gives a key another type or another
    /// meaning is refused with a message that names the key, since the state has no value for it; such a key of status
    /// packets is an error at the start. A reply whose value the pack does not allow is refused.
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

    /// Puts a plane into the way of the tool centre point: none if not set.
    ///
    /// [`Controller::deepest_penetration`](crate::Controller::deepest_penetration) says how far the tool went in.
    #[must_use]
    pub fn contact(mut self, contact: Contact) -> Self {
        self.contact = Some(contact);
        self
    }

    /// Sets the time between two status packets: that of the firmware if not set, which is 30 or 50 ms.
    ///
    /// With [`Duration::MAX`], each reader gets the packet on connecting and then those of
    /// [`Controller::publish`](crate::Controller::publish).
    #[must_use]
    pub fn status_period(mut self, period: Duration) -> Self {
        self.status_period = Some(period);
        self
    }

    /// Answers from a recording instead of by the simulated arm, whose state and faults then have no effect on replies.
    ///
    /// Status packets of the recording are sent at their times; after the last one of a connection, it is repeated each
    /// [`status_period`](Self::status_period). Time is real, also with a stepped clock. Where the client deviates from
    /// the recording is listed by [`Controller::deviations`](crate::Controller::deviations).
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
        self.replay = Some(ReplaySource { recording: Arc::new(recording), mode });
        self
    }

    /// The time between two status packets.
    pub(crate) fn period(&self) -> Duration {
        self.status_period.unwrap_or_else(|| self.firmware.status_period())
    }

    /// The real time between two status packets.
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

    /// Habits of the controller that no document describes: those that are set, or else those of its firmware.
    pub(crate) fn usual_habits(&self) -> Habits {
        self.habits.unwrap_or_else(|| self.firmware.habits())
    }
}

/// Rule for a client that connects to the command port while another one is connected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Takeover {
    /// The new client becomes the active one, and the old connection is closed.
    #[default]
    Replace,
    /// The new connection is closed.
    Refuse,
}

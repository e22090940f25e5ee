//! Replay of a recording in place of the simulated arm.

mod canonical;
mod dependencies;
mod deviation;
mod script;

use std::collections::{HashMap, VecDeque};
use std::fmt;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use jaka_clock::{Clock, Signal, lock};
use jaka_proto::recording::{Answer, Port, Recording};

use self::canonical::canonical;
pub(crate) use self::canonical::is_same;
use self::dependencies::{Dependencies, Dependency};
pub use self::deviation::Deviation;
pub(crate) use self::script::{Script, ScriptStep};

/// Mode of the answers from a recording: see [`Builder::replay`](crate::Builder::replay).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Replay {
    /// The n-th connection to a port replays the n-th of the recording, message by message. Requests must come in the
    /// recorded order and be equal as JSON. The controller sends the recorded bytes, also late, unsolicited or garbage
    /// ones, and ends the connection at the recorded point.
    ///
    /// Status packets wait for the requests recorded before them, so that a slower or faster program sees the same. A
    /// program may repeat a set-point that holds the arm more often than recorded. Anything else is a [`Deviation`],
    /// and ends the connection.
    Strict,
    /// Each request gets the reply to the first unused equal request of the recording, from any connection. A request
    /// without a recorded reply gets none.
    ///
    /// A request is equal if it is the same JSON: the controller never uses a reply to another request. If none is
    /// left, the controller refuses the request, which is a [`Deviation`]. Further status readers get the packets of
    /// the last recorded reader.
    Matching,
}

/// Timing of the messages of a replay.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ReplayTiming {
    /// Recorded time after the request, or after the start of the connection.
    #[default]
    Recorded,
    /// Replies at once, and status packets one each [`Builder::status_period`](crate::Builder::status_period).
    Immediate,
}

/// Running replay.
pub(crate) struct ReplaySession {
    pub(crate) mode: Replay,
    timing: ReplayTiming,
    commands: Vec<Arc<Script>>,
    readers: Vec<Arc<Script>>,
    /// Requests on which the status packets of a strict replay wait.
    dependencies: Option<Dependencies>,
    progress: Mutex<ReplayProgress>,
    /// Signal at each deviation.
    deviated: Signal,
}

#[derive(Debug, Default)]
struct ReplayProgress {
    commands: usize,
    readers: usize,
    /// Unused answers, by their request.
    answers: HashMap<String, VecDeque<Answer>>,
    deviations: Vec<Deviation>,
}

impl ReplaySession {
    pub(crate) fn new(recording: &Recording, mode: Replay, timing: ReplayTiming, time: &Clock) -> Self {
        let mut progress = ReplayProgress::default();
        if mode == Replay::Matching {
            for answered in recording.answers() {
                let same = progress.answers.entry(canonical(&answered.request.to_string())).or_default();
                same.push_back(answered.answer);
            }
        }
        Self {
            mode,
            timing,
            commands: script::scripts(recording, Port::Command),
            readers: script::scripts(recording, Port::Status),
            dependencies: (mode == Replay::Strict).then(|| Dependencies::new(recording, time)),
            progress: Mutex::new(progress),
            deviated: Signal::new(time),
        }
    }

    /// Returns the events of the next command connection; `None` if the recording has no further one, which is a
    /// deviation.
    pub(crate) fn next_commands(&self) -> Option<Arc<Script>> {
        let mut progress = lock(&self.progress);
        let script = self.commands.get(progress.commands).cloned();
        progress.commands += 1;
        self.known(script, Port::Command, &mut progress)
    }

    /// Returns the events of the next status connection.
    pub(crate) fn next_reader(&self) -> Option<Arc<Script>> {
        let mut progress = lock(&self.progress);
        let again = self.readers.last().filter(|_| self.mode == Replay::Matching);
        let script = self.readers.get(progress.readers).or(again).cloned();
        progress.readers += 1;
        self.known(script, Port::Status, &mut progress)
    }

    fn known(&self, script: Option<Arc<Script>>, port: Port, progress: &mut ReplayProgress) -> Option<Arc<Script>> {
        if script.is_none() {
            let recorded = if port == Port::Command { &self.commands } else { &self.readers };
            self.note(progress, Deviation::Connection { port, recorded: recorded.len() });
        }
        script
    }

    /// Returns the answer to a request; `None` if none is left, which is a deviation.
    pub(crate) fn answer(&self, request: &str) -> Option<Answer> {
        let mut progress = lock(&self.progress);
        let same = progress.answers.get_mut(&canonical(request));
        let answer = same.and_then(VecDeque::pop_front);
        if answer.is_none() {
            self.note(&mut progress, Deviation::NoReplyLeft { received: request.to_owned() });
        }
        answer
    }

    /// Returns the delay of a message after its predecessor: the recorded one, or none with immediate timing.
    pub(crate) fn delay(&self, recorded: Duration) -> Duration {
        match self.timing {
            ReplayTiming::Recorded => recorded,
            ReplayTiming::Immediate => Duration::ZERO,
        }
    }

    /// Records that a request of the script has come or never will, which releases later status packets.
    pub(crate) fn request_came(&self, script: &Script, at: Duration) {
        if let Some(dependencies) = &self.dependencies {
            dependencies.came(script.start.saturating_add(at));
        }
    }

    /// Returns the due time of a packet on a connection opened at `began`: the recorded time after the last request
    /// before it, or `next`; `None` while a request is outstanding.
    pub(crate) fn packet_due(&self, script: &Script, at: Duration, began: Instant, next: Instant) -> Option<Instant> {
        let recorded = script.start.saturating_add(at);
        let (since, delay) =
            match self.dependencies.as_ref().map_or(Dependency::None, |dependencies| dependencies.before(recorded)) {
                Dependency::Awaited => return None,
                Dependency::Came(since, then) if then >= script.start => (since, recorded.saturating_sub(then)),
                Dependency::Came(..) | Dependency::None => (began, at),
            };
        match self.timing {
            ReplayTiming::Recorded => since.checked_add(delay),
            ReplayTiming::Immediate => Some(since.max(next)),
        }
    }

    pub(crate) fn deviates(&self, deviation: Deviation) {
        self.note(&mut lock(&self.progress), deviation);
    }

    fn note(&self, progress: &mut ReplayProgress, deviation: Deviation) {
        log::debug!(target: "jaka_sim", "the replay deviates: {deviation}");
        progress.deviations.push(deviation);
        self.deviated.notify_all();
    }

    pub(crate) fn deviations(&self) -> Vec<Deviation> {
        lock(&self.progress).deviations.clone()
    }

    /// Waits until there are this many deviations in total; returns false on timeout.
    pub(crate) fn wait_for_deviations(&self, count: usize, timeout: Duration) -> bool {
        let enough = |progress: &ReplayProgress| progress.deviations.len() >= count;
        enough(&self.deviated.wait_until(&self.progress, timeout, enough))
    }
}

impl fmt::Debug for ReplaySession {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ReplaySession").field("mode", &self.mode).field("timing", &self.timing).finish_non_exhaustive()
    }
}

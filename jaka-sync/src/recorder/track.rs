//! One connection in a recording.

use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_clock::{Clock, lock};
use jaka_proto::recording::{Entry, Event, Message, Port};

use super::Recorder;
use super::sampling::{Sampler, StatusSampling};

/// One connection in a recording, for programs that make connections of their own, such as a proxy.
///
/// ```
/// use jaka_sync::recording::{Event, Message, Port};
/// use jaka_sync::{Recorder, StatusSampling};
///
/// let recorder = Recorder::new(std::io::sink())?;
/// let track = recorder.track(Port::Command, StatusSampling::All);
/// track.record(Event::Connected { address: "10.5.5.100:10001".to_owned() });
/// track.record(Event::Sent(Message::new(r#"{"cmdName":"get_version"}"#)));
/// assert_eq!(recorder.finish()?.entries, 2);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Track {
    recorder: Recorder,
    port: Port,
    number: u32,
    clock: Clock,
    sampling: StatusSampling,
    sampler: Mutex<Sampler>,
}

impl Recorder {
    /// Adds a connection to the recording, with the next number. The connections of this crate's clients and streams add
    /// themselves.
    pub fn track(&self, port: Port, sampling: StatusSampling) -> Track {
        self.track_by(&Clock::default(), port, sampling)
    }

    /// The same by a clock.
    pub(super) fn track_by(&self, clock: &Clock, port: Port, sampling: StatusSampling) -> Track {
        let (recorder, number) = (self.clone(), self.0.connections.fetch_add(1, Ordering::Relaxed) + 1);
        Track { recorder, port, number, clock: clock.clone(), sampling, sampler: Mutex::default() }
    }
}

impl Track {
    /// Records what happens now.
    pub fn record(&self, event: Event) {
        self.push(&self.entry(self.now(), event));
    }

    /// Records a status packet that comes now, if the sampling takes it.
    pub fn record_packet(&self, packet: Message) {
        self.push_packet(&self.entry(self.now(), Event::Received(packet)));
    }

    /// Time since the start of the recording; by a simulated clock, since the clock was made.
    pub(super) fn now(&self) -> Duration {
        self.clock.elapsed_since_start(self.recorder.0.started)
    }

    pub(super) fn entry(&self, time: Duration, event: Event) -> Arc<Entry> {
        Arc::new(Entry::new(time, self.port, self.number, event))
    }

    pub(super) fn push(&self, entry: &Arc<Entry>) {
        self.recorder.0.queue.push(entry);
    }

    pub(super) fn push_packet(&self, entry: &Arc<Entry>) {
        if lock(&self.sampler).takes(self.sampling, entry.time) {
            self.push(entry);
        }
    }
}

//! State that the threads of one controller share.

use std::collections::HashMap;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::Duration;

use jaka_clock::{Clock, lock};
use jaka_dynamic::Forms;
use serde_json::{Map, Value};

use crate::clock::{CYCLE, ControllerClock};
use crate::connection::ActiveClient;
use crate::link::Links;
use crate::listener::Listener;
use crate::readers::Readers;
use crate::replay::ReplaySession;
use crate::request_log::RequestLog;
use crate::spec_index::SpecIndex;
use crate::status_packet::Part;
use crate::trigger::Triggers;
use crate::world::World;
use crate::{Builder, FaultPlan, State, status_packet};

/// State that the threads of one controller share. No lock is held while waiting for another of these. The exception is
/// `world`: it is taken last, except for the progress of a trigger.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) options: Builder,
    pub(crate) spec_index: Arc<SpecIndex>,
    /// Forms of the firmware, by its version; none where all firmware has the same.
    forms: Mutex<(String, Option<Arc<Forms>>)>,
    pub(crate) command_listener: Listener,
    pub(crate) status_listener: Listener,
    pub(crate) active_client: ActiveClient,
    pub(crate) readers: Readers,
    pub(crate) request_log: RequestLog,
    pub(crate) links: Arc<Links>,
    pub(crate) triggers: Triggers,
    /// The replay, in place of the simulated arm.
    pub(crate) replay: Option<ReplaySession>,
    world: Mutex<World>,
    clock: ControllerClock,
    steps: Mutex<Steps>,
    faults: Mutex<FaultPlan>,
    replies: Mutex<HashMap<String, Map<String, Value>>>,
    status_values: Mutex<Map<String, Value>>,
    packet_parts: Mutex<Vec<Part>>,
}

/// Time of a stepped clock, and time of the last packet.
#[derive(Debug, Default)]
struct Steps {
    now: Duration,
    packet: Duration,
}

impl Shared {
    pub(crate) fn new(options: Builder) -> io::Result<Self> {
        options.check()?;
        let spec_index = SpecIndex::open(&options.packs)?;
        let time = &options.time;
        let links = Arc::new(Links::new(time));
        let world = World::new(&options, &spec_index, &links)?;
        let forms = Mutex::new((world.state.version.clone(), forms_of(&spec_index, &world.state.version)));
        Ok(Self {
            command_listener: Listener::bind(options.address, options.command_port, time)?,
            status_listener: Listener::bind(options.address, options.status_port, time)?,
            active_client: ActiveClient::new(time),
            readers: Readers::new(options.faults.status.clone()),
            request_log: RequestLog::new(time),
            triggers: Triggers::default(),
            links,
            replay: options.replay.as_ref().map(|source| ReplaySession::new(source, options.replay_timing, time)),
            world: Mutex::new(world),
            forms,
            spec_index,
            replies: Mutex::default(),
            status_values: Mutex::default(),
            packet_parts: Mutex::default(),
            clock: if options.stepped {
                ControllerClock::Stepped
            } else {
                ControllerClock::of(time, options.time_scale)
            },
            faults: Mutex::new(options.faults.clone()),
            steps: Mutex::default(),
            options,
        })
    }

    /// The time in which threads and connections wait.
    pub(crate) fn time(&self) -> &Clock {
        &self.options.time
    }

    /// The world as it is now.
    pub(crate) fn world(&self) -> MutexGuard<'_, World> {
        let mut world = lock(&self.world);
        if let Some(now) = self.clock.now() {
            world.advance_to(now);
        }
        world
    }

    /// Forms of the firmware that a state names; none where all firmware has the same.
    pub(crate) fn forms(&self, state: &State) -> Option<Arc<Forms>> {
        let mut known = lock(&self.forms);
        if known.0 != state.version {
            *known = (state.version.clone(), forms_of(&self.spec_index, &state.version));
            // What the last packet showed is written in other forms.
            lock(&self.packet_parts).clear();
        }
        known.1.clone()
    }

    /// The status packet of the present state.
    pub(crate) fn packet(&self) -> Vec<u8> {
        self.packet_of(&self.world().state).into_bytes()
    }

    /// The status packet of a state.
    pub(crate) fn packet_of(&self, state: &State) -> String {
        let set = self.status_values().clone();
        let forms = self.forms(state);
        let model = (&*self.spec_index, forms.as_deref());
        status_packet::packet(state, self.options.firmware, model, &set, &mut lock(&self.packet_parts))
    }

    /// Sends the present state to all status readers; nothing in a replay, which has its own packets.
    pub(crate) fn publish(&self) {
        if self.replay.is_none() {
            self.readers.send_packet(self.packet());
        }
    }

    /// Has another client take the command port: the connection of the active one is closed.
    pub(crate) fn take_over(&self) -> io::Result<()> {
        self.active_client.take_over(self.command_listener.address())
    }

    /// Lets a stepped clock go on, and sends the status packets that fall due on the way.
    pub(crate) fn step(&self, time: Duration) {
        if !matches!(self.clock, ControllerClock::Stepped) {
            return;
        }
        let mut steps = lock(&self.steps);
        let end = steps.now.saturating_add(time);
        let period = self.readers.period(self.options.period()).max(CYCLE);
        while let Some(due) = steps.packet.checked_add(period).filter(|due| *due <= end) {
            // A packet that was not due at the period before goes out now.
            let due = due.max(steps.now);
            self.pass_to(due);
            self.publish();
            steps.packet = due;
        }
        self.pass_to(end);
        steps.now = end;
    }

    /// Lets a stepped time pass, and waits for the actions of conditions that hold on the way.
    fn pass_to(&self, time: Duration) {
        self.triggers.wait_for_actions();
        while !lock(&self.world).advance_until_fired(time) {
            self.triggers.wait_for_actions();
        }
    }

    /// Time until the next scheduled change, in the time that passes; none if nothing is scheduled.
    pub(crate) fn until_next_due(&self) -> Option<Duration> {
        self.world().next_due().map(|due| self.clock.until(due))
    }

    /// Time until the next controller cycle.
    pub(crate) fn until_next_cycle(&self) -> Duration {
        self.clock.until_next_cycle()
    }

    /// Faults of the replies to come.
    pub(crate) fn faults(&self) -> MutexGuard<'_, FaultPlan> {
        lock(&self.faults)
    }

    /// The values of keys of status packets that a user has set.
    pub(crate) fn status_values(&self) -> MutexGuard<'_, Map<String, Value>> {
        lock(&self.status_values)
    }

    /// The fields of replies that a user has set, by command.
    pub(crate) fn replies(&self) -> MutexGuard<'_, HashMap<String, Map<String, Value>>> {
        lock(&self.replies)
    }
}

fn forms_of(spec_index: &SpecIndex, version: &str) -> Option<Arc<Forms>> {
    Forms::of(&spec_index.spec, version.parse().ok()).map(Arc::new)
}

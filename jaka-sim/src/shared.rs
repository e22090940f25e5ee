//! State shared by the threads of one controller.

use std::collections::HashMap;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::Duration;

use jaka_clock::{Clock, lock};
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

/// State shared by the threads of one controller. No thread holds a lock while it waits for another of these. The
/// exception is `world`: it is taken last, except for the progress of a trigger.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) options: Builder,
    pub(crate) spec_index: Arc<SpecIndex>,
    pub(crate) command_listener: Listener,
    pub(crate) status_listener: Listener,
    pub(crate) active_client: ActiveClient,
    pub(crate) readers: Readers,
    pub(crate) request_log: RequestLog,
    pub(crate) links: Arc<Links>,
    pub(crate) triggers: Triggers,
    /// Replay in place of the simulated arm.
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
        Ok(Self {
            command_listener: Listener::bind(options.address, options.command_port, time)?,
            status_listener: Listener::bind(options.address, options.status_port, time)?,
            active_client: ActiveClient::new(time),
            readers: Readers::new(options.faults.status.clone()),
            request_log: RequestLog::new(time),
            triggers: Triggers::default(),
            links,
            replay: options
                .replay
                .as_ref()
                .map(|(recording, mode)| ReplaySession::new(recording, *mode, options.replay_timing, time)),
            world: Mutex::new(world),
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

    /// Returns the clock of threads and connections.
    pub(crate) fn time(&self) -> &Clock {
        &self.options.time
    }

    /// Returns the world, advanced to the present time.
    pub(crate) fn world(&self) -> MutexGuard<'_, World> {
        let mut world = lock(&self.world);
        if let Some(now) = self.clock.now() {
            world.advance_to(now);
        }
        world
    }

    /// Returns the status packet of the present state.
    pub(crate) fn packet(&self) -> Vec<u8> {
        let mut world = self.world();
        if world.noise.is_none() {
            return self.packet_of(&world.state).into_bytes();
        }
        let mut measured = world.state.clone();
        measured.joint_position = world.noise.of(measured.joint_position);
        measured.joint_commanded_position = world.noise.of(measured.joint_commanded_position);
        self.packet_of(&measured).into_bytes()
    }

    /// Returns the status packet of a state.
    pub(crate) fn packet_of(&self, state: &State) -> String {
        let set = self.status_values().clone();
        status_packet::packet(state, self.options.firmware, &self.spec_index, &set, &mut lock(&self.packet_parts))
    }

    /// Sends the present state to all status readers, except in a replay, which has its own packets.
    pub(crate) fn publish(&self) {
        if self.replay.is_none() {
            self.readers.send_packet(self.packet());
        }
    }

    /// Connects another client to the command port and closes the connection of the active one.
    pub(crate) fn take_over(&self) -> io::Result<()> {
        self.active_client.take_over(self.command_listener.address())
    }

    /// Advances a stepped clock, and sends the status packets that are due.
    pub(crate) fn step(&self, time: Duration) {
        if !matches!(self.clock, ControllerClock::Stepped) {
            return;
        }
        let mut steps = lock(&self.steps);
        let end = steps.now.saturating_add(time);
        let period = self.readers.period(self.options.period()).max(CYCLE);
        while let Some(due) = steps.packet.checked_add(period).filter(|due| *due <= end) {
            // The period may have become shorter: a packet with a past due time goes out now.
            let due = due.max(steps.now);
            self.pass_to(due);
            self.publish();
            steps.packet = due;
        }
        self.pass_to(end);
        steps.now = end;
    }

    /// Advances a stepped time, and waits for the actions of conditions that hold meanwhile.
    fn pass_to(&self, time: Duration) {
        self.triggers.wait_for_actions();
        while !lock(&self.world).advance_until_fired(time) {
            self.triggers.wait_for_actions();
        }
    }

    /// Returns the time until the next scheduled change, by the underlying clock; `None` if nothing is scheduled.
    pub(crate) fn until_next_due(&self) -> Option<Duration> {
        self.world().next_due().map(|due| self.clock.until(due))
    }

    /// Returns the time until the next controller cycle.
    pub(crate) fn until_next_cycle(&self) -> Duration {
        self.clock.until_next_cycle()
    }

    /// Returns the faults of later replies.
    pub(crate) fn faults(&self) -> MutexGuard<'_, FaultPlan> {
        lock(&self.faults)
    }

    /// Returns the values of status packet keys set by the user.
    pub(crate) fn status_values(&self) -> MutexGuard<'_, Map<String, Value>> {
        lock(&self.status_values)
    }

    /// Returns the reply fields set by the user, by command.
    pub(crate) fn replies(&self) -> MutexGuard<'_, HashMap<String, Map<String, Value>>> {
        lock(&self.replies)
    }
}

//! What the threads of one controller share.

use std::collections::HashMap;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use serde_json::{Map, Value};

use crate::book::Book;
use crate::clock::{CYCLE, Clock};
use crate::command_port::{Rival, Seat};
use crate::door::Door;
use crate::link::Links;
use crate::lock::lock;
use crate::replay::Stage;
use crate::status_port::Readers;
use crate::tape::Tape;
use crate::world::World;
use crate::{Builder, FaultPlan};

/// What the threads of one controller share. No lock is held while another of these is waited for, but for `world`,
/// which is the last.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) options: Builder,
    pub(crate) book: Arc<Book>,
    pub(crate) command_door: Door,
    pub(crate) status_door: Door,
    pub(crate) seat: Seat,
    pub(crate) rival: Rival,
    pub(crate) readers: Readers,
    pub(crate) tape: Tape,
    pub(crate) links: Arc<Links>,
    /// The replay, in place of the simulated arm.
    pub(crate) stage: Option<Stage>,
    world: Mutex<World>,
    clock: Clock,
    steps: Mutex<Steps>,
    faults: Mutex<FaultPlan>,
    replies: Mutex<HashMap<String, Map<String, Value>>>,
}

/// How far a stepped clock is, and when the last packet went out.
#[derive(Debug, Default)]
struct Steps {
    now: Duration,
    packet: Duration,
}

impl Shared {
    pub(crate) fn new(options: Builder) -> io::Result<Self> {
        let book = Book::open(&options.packs)?;
        Ok(Self {
            command_door: Door::open(options.address, options.command_port)?,
            status_door: Door::open(options.address, options.status_port)?,
            seat: Seat::default(),
            rival: Rival::default(),
            readers: Readers::new(options.faults.status_fault().clone()),
            tape: Tape::default(),
            links: Arc::new(Links::new(options.faults.links())),
            stage: options.replay.as_ref().map(|plan| Stage::new(plan, options.replay_timing)),
            world: Mutex::new(World::new(&options, &book)?),
            book,
            replies: Mutex::default(),
            clock: if options.stepped { Clock::Stepped } else { Clock::Real(Instant::now()) },
            faults: Mutex::new(options.faults.clone()),
            steps: Mutex::default(),
            options,
        })
    }

    /// The world as it is now.
    pub(crate) fn world(&self) -> MutexGuard<'_, World> {
        let mut world = lock(&self.world);
        if let Some(now) = self.clock.now() {
            world.advance_to(now);
        }
        world
    }

    /// Lets a stepped clock go on, and sends the status packets that fall due on the way.
    pub(crate) fn step(&self, time: Duration) {
        if self.clock != Clock::Stepped {
            return;
        }
        let mut steps = lock(&self.steps);
        let end = steps.now.saturating_add(time);
        let period = self.readers.period(self.options.period()).max(CYCLE);
        while let Some(due) = steps.packet.checked_add(period).filter(|due| *due <= end) {
            // A packet that was not due at the period before goes out now.
            let due = due.max(steps.now);
            lock(&self.world).advance_to(due);
            self.readers.publish(self);
            steps.packet = due;
        }
        lock(&self.world).advance_to(end);
        steps.now = end;
    }

    /// What is wrong with the replies to come.
    pub(crate) fn faults(&self) -> MutexGuard<'_, FaultPlan> {
        lock(&self.faults)
    }

    /// The fields of replies that a user has set, by command.
    pub(crate) fn replies(&self) -> MutexGuard<'_, HashMap<String, Map<String, Value>>> {
        lock(&self.replies)
    }
}

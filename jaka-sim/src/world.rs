//! The controller and its arm over time.

mod events;
mod planning;
mod program;
mod schedule;
mod servo;
mod touch;

use std::collections::HashMap;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_motion::{Frames, Model, Transform};
use jaka_proto::messages::force::IdentifyStatus;
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::types::{JointPosition, Pose};

use self::events::Reported;
use self::schedule::Schedule;
use self::touch::Touch;
use crate::clock::CYCLE;
use crate::firmware::Writing;
use crate::link::Links;
use crate::motion::{Drives, Engine, Joints};
use crate::programs::{Program, Runner};
use crate::spec_index::SpecIndex;
use crate::trips::Trip;
use crate::underrun::Underrun;
use crate::{Builder, Delays, Habits, State};

/// The state, and what changes it as time goes on.
#[derive(Debug)]
pub(crate) struct World {
    pub(crate) state: State,
    pub(crate) model: Model,
    pub(crate) engine: Engine,
    pub(crate) drives: Drives,
    trips: Vec<Trip>,
    underrun: Underrun,
    schedule: Schedule,
    links: Arc<Links>,
    touch: Touch,
    /// For how long the arm has been moving without a rest.
    busy: Duration,
    pub(crate) programs: HashMap<String, Program>,
    pub(crate) runner: Option<Runner>,
    /// The file for which a trajectory is recorded, and where the arm has been since.
    pub(crate) recorder: Option<(String, Vec<Joints>)>,
    /// The trajectory files, by name; the document's own, which stand in the list from the start, are empty.
    pub(crate) recordings: HashMap<String, Vec<Joints>>,
    /// True while the arm moves to identify the payload.
    pub(crate) identifying: bool,
    pub(crate) delays: Delays,
    pub(crate) habits: Habits,
    pub(crate) writing: Writing,
    /// The states of which events have been sent.
    seen: Reported,
    /// End of the information in the error code.
    event_ends: Option<Duration>,
    changes: Vec<(Duration, Change)>,
    now: Duration,
}

/// A change of state that takes its time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Change {
    PoweredOn,
    Enabled,
    ServoMode(bool),
}

/// What a reply waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wait {
    /// The arm is at rest, or the controller's time is this, if it is given.
    Rest(Option<Duration>),
    /// The change is made or given up.
    Change(Change),
}

impl World {
    pub(crate) fn new(options: &Builder, spec_index: &SpecIndex, links: &Arc<Links>) -> io::Result<Self> {
        let model = options.model.clone();
        let state = State::initial(spec_index, &model)?;
        let mut world = Self {
            drives: Drives::new(options.lag, state.joint_position.0),
            trips: options.trips.clone(),
            underrun: options.underrun,
            schedule: Schedule::default(),
            links: Arc::clone(links),
            touch: Touch::new(options.contact),
            busy: Duration::ZERO,
            state,
            model,
            engine: Engine::new(options.usual_habits().pause.unwrap_or_default()),
            programs: options.programs()?,
            runner: None,
            recorder: None,
            recordings: HashMap::new(),
            identifying: false,
            delays: options.delays,
            habits: options.usual_habits(),
            writing: options.firmware.shape().writing,
            seen: Reported::default(),
            event_ends: None,
            changes: Vec::new(),
            now: Duration::ZERO,
        };
        options.firmware.fit(&mut world.state);
        options.scheduled.iter().try_for_each(|scheduled| world.schedule(*scheduled))?;
        world.make_consistent();
        Ok(world)
    }

    /// The controller's time.
    pub(crate) fn now(&self) -> Duration {
        self.now
    }

    /// Lets time pass, cycle by cycle.
    pub(crate) fn advance_to(&mut self, now: Duration) {
        while !self.advance_until_fired(now) {}
    }

    /// Lets time pass, cycle by cycle, up to one in which a condition is settled; true if there is none before this time.
    pub(crate) fn advance_until_fired(&mut self, now: Duration) -> bool {
        let conditions = self.conditions();
        let mut left = now.saturating_sub(self.now).as_nanos() / CYCLE.as_nanos();
        while left > 0 {
            // Where nothing goes on, all cycles are passed at once.
            let is_idle = self.is_idle();
            let cycles = if is_idle { self.idle_cycles(left) } else { 1 };
            self.now += CYCLE * cycles;
            left -= u128::from(cycles);
            self.run_schedule();
            self.end_information();
            if !is_idle {
                self.cycle();
            }
            self.ask_conditions();
            if self.conditions() < conditions {
                return false;
            }
        }
        true
    }

    /// How many of these cycles can be passed at once where nothing goes on: up to the next of what is scheduled.
    fn idle_cycles(&self, left: u128) -> u32 {
        let until = |due: Duration| due.saturating_sub(self.now).as_nanos().div_ceil(CYCLE.as_nanos()).max(1);
        let next_due = self.next_due().into_iter().chain(self.event_ends).min();
        let cycles = next_due.map_or(left, |due| left.min(until(due)));
        u32::try_from(cycles).unwrap_or(u32::MAX)
    }

    fn is_idle(&self) -> bool {
        self.changes.is_empty() && self.is_at_rest() && self.busy.is_zero()
    }

    /// True while the arm moves or has motions to run.
    pub(crate) fn is_moving(&self) -> bool {
        self.engine.is_busy() || !self.drives.is_settled()
    }

    /// True where the arm does not move, and nothing waits for it to do so.
    pub(crate) fn is_at_rest(&self) -> bool {
        !self.is_moving() && self.runner.is_none()
    }

    /// True if there is nothing left to wait for.
    pub(crate) fn is_over(&self, wait: Wait) -> bool {
        match wait {
            Wait::Rest(time) => self.is_at_rest() || time.is_some_and(|time| self.now >= time),
            Wait::Change(change) => self.changes.iter().all(|(_, pending)| *pending != change),
        }
    }

    fn cycle(&mut self) {
        self.run_changes();
        self.run_program();
        self.busy = if self.is_moving() { self.busy + CYCLE } else { Duration::ZERO };
        let rate = self.rate();
        let before = self.tool_at(self.drives.actual);
        let commanded = self.engine.cycle(self.drives.commanded, rate, &self.model);
        self.drives.follow(commanded);
        let after = self.drives.actual;
        self.state.joint_position = JointPosition(after);
        let moved = self.tool_at(after).distance_mm(&before);
        self.state.tcp_speed = moved / CYCLE.as_secs_f64();
        self.record(after);
        if self.identifying && self.engine.pending() == 0 {
            self.identified();
        }
        match self.error() {
            Some(code) => self.trip(code),
            None => self.update(),
        }
    }

    /// Stands still at once, and gives up all that moves the arm.
    fn halt(&mut self) {
        self.engine.halt();
        self.drives.place(self.state.joint_position.0);
        self.busy = Duration::ZERO;
        self.end_program();
        if std::mem::take(&mut self.identifying) {
            self.state.torque_sensor.identify_status = IdentifyStatus::Failed;
        }
    }

    /// Makes a change after a delay, or at once if there is none.
    pub(crate) fn later(&mut self, delay: Duration, change: Change) {
        if delay.is_zero() {
            self.make(change);
        } else {
            self.changes.push((self.now + delay, change));
        }
    }

    fn run_changes(&mut self) {
        let now = self.now;
        let due: Vec<_> = self.changes.iter().filter(|(at, _)| *at <= now).map(|(_, change)| *change).collect();
        self.changes.retain(|(at, _)| *at > now);
        for change in due {
            self.make(change);
        }
    }

    fn make(&mut self, change: Change) {
        match change {
            Change::PoweredOn => self.state.powered = true,
            Change::Enabled => self.state.enabled = true,
            Change::ServoMode(on) => self.state.servo_mode = on,
        }
        self.make_consistent();
    }

    /// Gives up the changes that are under way.
    pub(crate) fn cancel_changes(&mut self, cancelled: impl Fn(Change) -> bool) {
        self.changes.retain(|(_, change)| !cancelled(*change));
    }

    /// Ends what cannot be in this state. Follows each change.
    pub(crate) fn make_consistent(&mut self) {
        self.state.make_consistent();
        if self.state.joint_position != JointPosition(self.drives.actual) {
            self.drives.place(self.state.joint_position.0);
            self.engine.servo = None;
        }
        if !self.state.can_move() {
            self.halt();
        }
        if !self.state.servo_mode {
            self.engine.servo = None;
        } else if self.engine.servo.is_none() {
            self.engine.servo = Some(self.servo());
        }
        self.update();
        self.ask_conditions();
    }

    /// What follows from a change and from the motion: events, the pose, and whether the robot is in position.
    fn update(&mut self) {
        self.report_events();
        self.state.tcp_pose = self.pose(self.state.joint_position.0);
        self.feel();
        let is_moving = self.is_moving();
        let is_resting = self.engine.is_resting() && self.drives.is_settled();
        self.state.at_rest = self.is_at_rest();
        self.state.in_position = !is_moving || is_resting || self.busy < self.delays.in_position;
        self.update_commanded();
        if !is_moving {
            self.state.tcp_speed = 0.0;
        }
    }

    /// Where the arm is commanded to be: where it will be, where it is a habit to say so.
    fn update_commanded(&mut self) {
        let joints = self.drives.commanded;
        let lead = self.habits.lead.filter(|_| self.engine.is_busy()).unwrap_or_default();
        let ahead = self.engine.ahead(joints, lead, self.rate(), &self.model);
        self.state.joint_commanded_position = ahead.into();
        self.state.tcp_commanded_pose = self.pose(ahead);
    }

    /// The rate by which motions are scaled; none goes on in a pause.
    fn rate(&self) -> f64 {
        if self.state.program_state == ProgramState::Paused { 0.0 } else { self.state.rapid_rate }
    }

    /// Brakes, and forgets all motions that wait.
    pub(crate) fn stop(&mut self) {
        self.engine.stop(self.drives.commanded, &self.model);
    }

    fn tool_at(&self, joints: Joints) -> Transform {
        self.model.forward(joints) * self.tool()
    }

    /// The tool frame in use, on the flange.
    pub(crate) fn tool(&self) -> Transform {
        offset(&self.state.tool_frames, self.state.tool_frame_id)
    }

    /// The user frame in use, on the base.
    pub(crate) fn user(&self) -> Transform {
        offset(&self.state.user_frames, self.state.user_frame_id)
    }

    fn frames(&self) -> Frames {
        Frames::new().with_tool(self.tool()).with_user_frame(self.user())
    }

    /// The tool frame in use, seen from the user frame in use, for these joints.
    pub(crate) fn pose(&self, joints: Joints) -> Pose {
        self.frames().pose(self.model.forward(joints))
    }

    /// The flange for a pose as [`pose`](Self::pose) gives it.
    pub(crate) fn flange(&self, pose: Pose) -> Transform {
        self.frames().flange(pose)
    }

    fn identified(&mut self) {
        self.identifying = false;
        let (payload, identified) = (&self.state.payload, &mut self.state.torque_sensor.identified);
        (identified.mass, identified.centroid) = (payload.mass, payload.centroid);
        self.state.torque_sensor.identify_status = IdentifyStatus::Done;
    }

    fn record(&mut self, joints: Joints) {
        const MOST: usize = 100_000;
        let Some((_, points)) = self.recorder.as_mut().filter(|(_, points)| points.len() < MOST) else { return };
        let far = |last: &Joints| last.iter().zip(&joints).any(|(last, now)| (last - now).abs() > 0.05);
        if points.last().is_none_or(far) {
            points.push(joints);
        }
    }
}

fn offset(frames: &[crate::Frame], id: i64) -> Transform {
    let frame = usize::try_from(id).ok().and_then(|id| frames.get(id));
    frame.map_or_else(Transform::identity, |frame| frame.offset.into())
}

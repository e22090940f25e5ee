//! Controller and arm over time.

mod schedule;

use std::collections::HashMap;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_motion::{Frames, Model, Transform};
use jaka_proto::messages::force::IdentifyStatus;
use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_proto::messages::program::ProgramState;
use jaka_proto::messages::types::{JointPosition, MoveMode, Pose};
use jaka_proto::{ControllerEvent, Request, Severity};

use self::schedule::Schedule;
use crate::clock::CYCLE;
use crate::firmware::Writing;
use crate::link::Links;
use crate::motion::{ArmPath, Drives, Engine, Filter, Joints, Planned, Profile, Servo, Zone};
use crate::noise::Noise;
use crate::programs::{Program, Runner};
use crate::spec_index::SpecIndex;
use crate::trips::{self, Observed, Trip};
use crate::underrun::Underrun;
use crate::{Builder, Contact, Delays, Habits, State, StopInServo};

/// State of the controller, and the processes that change it over time.
#[derive(Debug)]
pub(crate) struct World {
    pub(crate) state: State,
    pub(crate) model: Model,
    pub(crate) engine: Engine,
    pub(crate) drives: Drives,
    pub(crate) noise: Noise,
    trips: Vec<Trip>,
    underrun: Underrun,
    stop_in_servo: StopInServo,
    schedule: Schedule,
    links: Arc<Links>,
    touch: Touch,
    /// Duration of the present motion, since the last rest.
    busy: Duration,
    pub(crate) programs: HashMap<String, Program>,
    pub(crate) runner: Option<Runner>,
    /// File of the running trajectory recording, and the recorded positions.
    pub(crate) recorder: Option<(String, Vec<Joints>)>,
    /// Trajectory files, by name; those of the document, in the list from the start, are empty.
    pub(crate) recordings: HashMap<String, Vec<Joints>>,
    /// Whether the arm moves to identify the payload.
    pub(crate) identifying: bool,
    pub(crate) delays: Delays,
    pub(crate) habits: Habits,
    pub(crate) writing: Writing,
    /// States at the last report of events.
    seen: Reported,
    /// Time at which the information leaves the error code.
    event_ends: Option<Duration>,
    changes: Vec<(Duration, Change)>,
    now: Duration,
}

/// Change of state with a delay.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Change {
    PoweredOn,
    Enabled,
    ServoMode(bool),
}

/// Event on which a reply waits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wait {
    /// The arm is at rest, or the controller's time has reached the given time.
    Rest(Option<Duration>),
    /// The change is made or cancelled.
    Change(Change),
}

impl World {
    pub(crate) fn new(options: &Builder, spec_index: &SpecIndex, links: &Arc<Links>) -> io::Result<Self> {
        let model = options.model.clone();
        let state = State::initial(spec_index, &model)?;
        let mut world = Self {
            drives: Drives::new(options.lag, state.joint_position.0),
            noise: Noise::new(options.joint_noise),
            trips: options.trips.clone(),
            underrun: options.underrun,
            stop_in_servo: options.stop_in_servo,
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

    /// Returns the controller's time.
    pub(crate) fn now(&self) -> Duration {
        self.now
    }

    /// Advances the time, cycle by cycle.
    pub(crate) fn advance_to(&mut self, now: Duration) {
        while !self.advance_until_fired(now) {}
    }

    /// Advances the time, cycle by cycle, up to a cycle that settles a condition; returns true if none does before this
    /// time.
    pub(crate) fn advance_until_fired(&mut self, now: Duration) -> bool {
        let conditions = self.conditions();
        let mut left = now.saturating_sub(self.now).as_nanos() / CYCLE.as_nanos();
        while left > 0 {
            // In an idle state, all cycles pass at once.
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

    /// Returns the number of idle cycles up to the next scheduled change; at most `left`.
    fn idle_cycles(&self, left: u128) -> u32 {
        let until = |due: Duration| due.saturating_sub(self.now).as_nanos().div_ceil(CYCLE.as_nanos()).max(1);
        let next_due = self.next_due().into_iter().chain(self.event_ends).min();
        let cycles = next_due.map_or(left, |due| left.min(until(due)));
        u32::try_from(cycles).unwrap_or(u32::MAX)
    }

    fn is_idle(&self) -> bool {
        self.changes.is_empty() && self.is_at_rest() && self.busy.is_zero()
    }

    /// Whether the arm moves or has motions to run.
    pub(crate) fn is_moving(&self) -> bool {
        self.engine.is_busy() || !self.drives.is_settled()
    }

    /// Whether the arm does not move, and no program runs.
    pub(crate) fn is_at_rest(&self) -> bool {
        !self.is_moving() && self.runner.is_none()
    }

    /// Whether the awaited event has occurred.
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

    /// Stops the arm at once, and discards all motions.
    fn halt(&mut self) {
        self.engine.halt();
        self.drives.place(self.state.joint_position.0);
        self.busy = Duration::ZERO;
        self.end_program();
        if std::mem::take(&mut self.identifying) {
            self.state.torque_sensor.identify_status = IdentifyStatus::Failed;
        }
    }

    /// Makes a change after a delay; at once if the delay is zero.
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

    /// Cancels pending changes.
    pub(crate) fn cancel_changes(&mut self, cancelled: impl Fn(Change) -> bool) {
        self.changes.retain(|(_, change)| !cancelled(*change));
    }

    /// Ends conditions that the state excludes. Called after each change.
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

    /// Updates the values derived from a change or a motion: events, the pose, and whether the robot is in position.
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

    /// Updates the commanded positions. With the habit [`Lead`](crate::Habit::Lead), they are later positions of the
    /// arm.
    fn update_commanded(&mut self) {
        let joints = self.drives.commanded;
        let lead = self.habits.lead.filter(|_| self.engine.is_busy()).unwrap_or_default();
        let ahead = self.engine.ahead(joints, lead, self.rate(), &self.model);
        self.state.joint_commanded_position = ahead.into();
        self.state.tcp_commanded_pose = self.pose(ahead);
    }

    /// Returns the scale of motion speeds; 0 in a pause.
    fn rate(&self) -> f64 {
        if self.state.program_state == ProgramState::Paused { 0.0 } else { self.state.rapid_rate }
    }

    /// Brakes, and discards all waiting motions. In servo mode, the reaction is that of the options.
    pub(crate) fn stop(&mut self) {
        let Drives { commanded, commanded_speed, .. } = self.drives;
        self.engine.stop(commanded, &self.model);
        let Some(servo) = &mut self.engine.servo else { return };
        match self.stop_in_servo {
            StopInServo::Discard => servo.stop(),
            StopInServo::Ignore => {}
            StopInServo::Leave => {
                self.state.servo_mode = false;
                self.engine.leave_servo(commanded, commanded_speed, USUAL_ACCELERATION, &self.model);
            }
            StopInServo::Fault => self.trip(trips::command_error(commanded_speed)),
        }
    }

    fn tool_at(&self, joints: Joints) -> Transform {
        self.model.forward(joints) * self.tool()
    }

    /// Returns the tool frame in use, relative to the flange.
    pub(crate) fn tool(&self) -> Transform {
        offset(&self.state.tool_frames, self.state.tool_frame_id)
    }

    /// Returns the user frame in use, relative to the base.
    pub(crate) fn user(&self) -> Transform {
        offset(&self.state.user_frames, self.state.user_frame_id)
    }

    fn frames(&self) -> Frames {
        Frames::new().with_tool(self.tool()).with_user_frame(self.user())
    }

    /// Returns the pose of the tool frame in use, relative to the user frame in use, for these joints.
    pub(crate) fn pose(&self, joints: Joints) -> Pose {
        self.frames().pose(self.model.forward(joints))
    }

    /// Returns the flange for a pose as returned by [`pose`](Self::pose).
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

    /// Starts the next command of the program after the end of the previous one.
    pub(super) fn run_program(&mut self) {
        if self.state.program_state != ProgramState::Running || self.engine.is_busy() {
            return;
        }
        let Some(runner) = &mut self.runner else {
            return;
        };
        let Some(command) = runner.next() else {
            return self.end_program();
        };
        if !self.start_motion(&command) {
            log::debug!(target: "jaka_sim", "the program ends: `{}` is refused", command.info().name);
            self.end_program();
        }
    }

    /// Ends the program.
    pub(crate) fn end_program(&mut self) {
        self.runner = None;
        self.state.program_state = ProgramState::Idle;
    }

    /// Creates the servo mode with the present filter settings.
    pub(super) fn servo(&self) -> Servo {
        let at = self.drives.commanded;
        let filter = Filter::new(&self.state.servo_filter, at, self.tool(), &self.model);
        Servo::new(at, filter, self.underrun, self.trips.clone())
    }

    /// Takes the error of the motion in this cycle, as a code of the vendor's table.
    pub(super) fn error(&mut self) -> Option<u32> {
        let drives = &self.drives;
        let observed = Observed {
            deviation: drives.deviation(),
            speed: drives.speed,
            speed_deviation: drives.speed_deviation(),
            ..Observed::default()
        };
        let of_servo = self.engine.servo.as_mut().and_then(Servo::take_error);
        of_servo.or_else(|| trips::error(&self.trips, &observed))
    }

    /// Stops with an error, as the drives do.
    pub(super) fn trip(&mut self, code: u32) {
        self.state.report(code);
        self.state.servo_mode = false;
        self.halt();
        self.make_consistent();
    }

    /// Sets or removes the contact plane.
    pub(crate) fn set_contact(&mut self, contact: Option<Contact>) {
        self.touch = Touch::new(contact);
        self.state.torque_sensor.contact_force = [0.0; 6];
        self.feel();
    }

    /// Returns the greatest depth of the tool below the plane, in mm.
    pub(crate) fn deepest_penetration(&self) -> f64 {
        self.touch.deepest
    }

    /// Updates the depth and the contact force for the present position of the tool.
    pub(super) fn feel(&mut self) {
        let Some(contact) = self.touch.contact else { return };
        let tool = self.tool_at(self.state.joint_position.0);
        self.touch.deepest = self.touch.deepest.max(contact.depth(&tool));
        self.state.torque_sensor.contact_force = contact.force(&tool);
    }

    /// Reports new events in the error code, if the controller has that habit and the code is not an error.
    pub(super) fn report_events(&mut self) {
        let now = Reported {
            enabled: self.state.enabled,
            servo_mode: self.state.servo_mode,
            program: self.state.program_state != ProgramState::Idle,
            protective_stop: self.state.protective_stop,
        };
        let before = std::mem::replace(&mut self.seen, now);
        let happened = [
            (before.servo_mode, now.servo_mode, SERVO_ON, Some(SERVO_OFF)),
            (before.enabled, now.enabled, ENABLED, Some(DISABLED)),
            (before.program, now.program, PROGRAM_STARTS, None),
            (before.protective_stop, now.protective_stop, PROTECTIVE_STOP, None),
        ];
        for (before, now, begins, ends) in happened {
            let event = if now { Some(begins) } else { ends };
            if let Some(event) = event.filter(|_| before != now && self.habits.events && !has_error(&self.state)) {
                self.state.report(event);
                self.event_ends = Some(self.now + INFORMATION);
            }
        }
    }

    /// Removes information from the error code after its time.
    pub(super) fn end_information(&mut self) {
        if self.event_ends.take_if(|ends| *ends <= self.now).is_some() && !has_error(&self.state) {
            self.state.clear_error();
        }
    }

    /// Queues a motion; returns false if the arm cannot make it, or the request is not a motion.
    pub(crate) fn start_motion(&mut self, request: &Request) -> bool {
        let planned = match request {
            Request::JointMove(command) => joint_move(command, self),
            Request::EndMove(command) => end_move(command, self),
            Request::MoveL(command) => move_l(command, self),
            Request::MoveC(command) => move_c(command, self),
            _ => None,
        };
        self.enqueue(planned.filter(|_| self.engine.jog.is_none()))
    }

    /// Returns the number of motions that wait for the end of the running one.
    pub(crate) fn motions_waiting(&self) -> usize {
        self.engine.waiting()
    }

    /// Queues a motion; returns false if there is none.
    pub(crate) fn enqueue(&mut self, planned: Option<Planned>) -> bool {
        planned.map(|planned| self.engine.enqueue(planned)).is_some()
    }

    /// Returns the joint position at which the next motion starts, in degrees.
    pub(crate) fn tail(&self) -> Joints {
        self.engine.tail(self.drives.commanded)
    }

    /// Plans a motion of all joints to a target.
    pub(crate) fn plan_joints(&self, to: Joints, speed: f64, acceleration: f64) -> Option<Planned> {
        let from = self.tail();
        self.model.is_within_range(to).then_some(())?;
        self.plan(ArmPath::Joints { from, to }, speed, acceleration)
    }

    pub(crate) fn plan(&self, path: ArmPath, speed: f64, acceleration: f64) -> Option<Planned> {
        if speed <= 0.0 || acceleration <= 0.0 {
            return None;
        }
        let end = path.end(&self.model, self.tail())?;
        let profile = Profile::new(path.length(), speed, acceleration);
        Some(Planned { path, profile, deceleration: acceleration, end, zone: None })
    }

    /// Adds a blend zone of this tolerance to a motion, if the controller has that habit.
    fn rounded(&self, planned: Planned, tolerance: Option<f64>) -> Planned {
        let radius = tolerance.filter(|_| self.habits.blend).unwrap_or_default();
        let end = self.model.forward(planned.end) * self.tool();
        Planned { zone: Zone::new(self.tool(), end, radius), ..planned }
    }

    /// Returns the flange displaced along the axes of the user frame.
    pub(crate) fn displaced(&self, flange: Transform, by: Pose) -> Transform {
        let (user, tool) = (self.user(), self.tool());
        user * (user.inverse() * flange * tool).displaced(&by.into()) * tool.inverse()
    }
}

fn offset(frames: &[crate::Frame], id: i64) -> Transform {
    let frame = usize::try_from(id).ok().and_then(|id| frames.get(id));
    frame.map_or_else(Transform::identity, |frame| frame.offset.into())
}

/// Contact plane for the tool centre point, and the greatest depth of the tool.
#[derive(Debug)]
pub(super) struct Touch {
    contact: Option<Contact>,
    deepest: f64,
}

impl Touch {
    pub(super) fn new(contact: Option<Contact>) -> Self {
        Self { contact, deepest: 0.0 }
    }
}

/// Codes of the vendor's table of controller events.
const ENABLED: u32 = 0x10f_0004;
const DISABLED: u32 = 0x10f_0005;
const PROTECTIVE_STOP: u32 = 0x10f_000b;
const SERVO_ON: u32 = 0x10f_0015;
const SERVO_OFF: u32 = 0x10f_0016;
const PROGRAM_STARTS: u32 = 0x10f_001b;

/// Time for which information stays in the error code: a capture has one entry of a log for 257 ms.
const INFORMATION: Duration = Duration::from_millis(256);

/// Facts at the last report of events.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub(super) struct Reported {
    enabled: bool,
    servo_mode: bool,
    program: bool,
    protective_stop: bool,
}

/// Whether the error code is anything other than information.
fn has_error(state: &State) -> bool {
    let event = ControllerEvent::from_text(&state.error_code);
    event.map_or(true, |event| event.is_some_and(|event| event.severity() != Severity::Information))
}

/// Acceleration for a command without one, in deg/s² and mm/s². The default of real controllers is unknown.
const USUAL_ACCELERATION: f64 = 180.0;

fn joint_move(command: &JointMove, world: &World) -> Option<Planned> {
    let from = world.tail();
    let JointPosition(values) = command.joint_position;
    let to = match command.mode {
        MoveMode::Relative => std::array::from_fn(|i| from[i] + values[i]),
        _ => values,
    };
    world.plan_joints(to, command.speed, command.acceleration.unwrap_or(USUAL_ACCELERATION))
}

fn end_move(command: &EndMove, world: &World) -> Option<Planned> {
    let to = world.model.inverse(world.flange(command.pose), world.tail()).ok()?;
    world.plan_joints(to.into(), command.speed, command.acceleration.unwrap_or(USUAL_ACCELERATION))
}

/// Returns the pose of the tool for the pose of a command.
fn tool_at(world: &World, mode: MoveMode, pose: Pose) -> Transform {
    let tool = world.tool();
    match mode {
        MoveMode::Relative => world.displaced(world.model.forward(world.tail()), pose) * tool,
        _ => world.flange(pose) * tool,
    }
}

fn move_l(command: &MoveL, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let to = match command.mode {
        LineMode::Relative => tool_at(world, MoveMode::Relative, command.pose),
        LineMode::RelativeToTool => from * command.pose.into(),
        _ => tool_at(world, MoveMode::Absolute, command.pose),
    };
    let acceleration = command.acceleration.unwrap_or(USUAL_ACCELERATION);
    let planned = world.plan(ArmPath::Line { from, to, tool }, command.speed, acceleration)?;
    Some(world.rounded(planned, command.tolerance))
}

fn move_c(command: &MoveC, world: &World) -> Option<Planned> {
    let tool = world.tool();
    let from = world.model.forward(world.tail()) * tool;
    let middle = tool_at(world, command.mode, command.mid_pose);
    let to = tool_at(world, command.mode, command.end_pose);
    let arc = ArmPath::arc(from, middle, to, tool)?;
    let planned = world.plan(arc, command.speed, command.acceleration)?;
    Some(world.rounded(planned, Some(command.tolerance)))
}

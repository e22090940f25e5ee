//! Stops of a connection, what they keep back, and the session that moves the arm.
//!
//! Any handle of a connection can stop the arm, and a stop concerns all of them. So this state belongs to the
//! connection. It has a lock of its own, under which no other one is taken but the clock's.

use std::fmt;
use std::sync::Arc;
#[cfg(not(all(test, shuttle)))]
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use jaka_clock::Clock;
use jaka_proto::Role;
use jaka_proto::exchange::{Owner, RequestId};
#[cfg(all(test, shuttle))]
use shuttle::thread::{self, ThreadId};

use super::outgoing::{Handle, Outgoing};
use crate::sync::Watched;
use crate::{Error, ErrorKind};

/// Longest wait of a stop until a session has braked.
const LONGEST_BRAKING: Duration = Duration::from_secs(3);

/// Reasons for commands that are kept back.
const LED: &str = "a servo session, a stream or a trajectory moves the arm, and only outputs, short queries and stops are sent meanwhile";
const LED_BEFORE: &str =
    "a servo session, a stream or a trajectory has ended, and the arm was not seen at rest since then";
const STOPPED: &str = "the arm was stopped, or its status was lost, and the program has not acknowledged that";
const NOT_AT_REST: &str = "the arm was stopped, and was not seen at rest since then";

/// Robot of a connection. It may be called under the lock of the connection.
pub trait AttachedRobot: Send + Sync {
    /// Takes note of an accepted stop.
    fn stopped(&self);

    /// True while packets have shown a stop, or a lost status, that was not acknowledged.
    fn is_latched(&self) -> bool;
}

/// Stops of a connection, what they keep back, and the session that moves the arm.
pub struct Stops {
    /// Stops wait for its changes until a session has braked.
    state: Watched<State>,
}

#[derive(Default)]
struct State {
    /// Robot of the connection, if it has one.
    robot: Option<Arc<dyn AttachedRobot>>,
    /// True once the connection has had a robot: only then do stops keep other commands back.
    binds: bool,
    latch: Latch,
    rest: Rest,
    lead: Option<Lead>,
    /// Time at which the first stop that waits for a session to brake goes out at the latest; `None` if none waits.
    goes_out_at: Option<Instant>,
    /// Stops that were entered and have no reply yet.
    unanswered: Vec<(RequestId, u64)>,
    /// Number of entered commands that may move the arm.
    moves: u64,
}

/// Stops by their numbers from 1.
#[derive(Debug, Default)]
struct Latch {
    /// The latest requested stop.
    begun: u64,
    /// The latest one that keeps motions back until it is acknowledged.
    latching: u64,
    /// The latest one that an acknowledgement covers.
    acknowledged: u64,
    /// The latest one that goes out, or has gone out: before that a session may brake.
    sent: u64,
    /// The latest one that the controller has accepted.
    accepted: u64,
    /// Number of calls that stop and have not returned.
    under_way: u64,
}

/// Need for an observation that the arm is at rest.
#[derive(Debug, Default)]
struct Rest {
    /// Number of stops, and of ends of sessions that have moved the arm.
    events: u64,
    /// The latest of them after which the arm must be seen at rest, apart from the end of the [`Lead`].
    due: u64,
    /// Number of them that had happened before the arm was seen at rest.
    seen: u64,
}

/// Session, stream or trajectory that moves the arm.
#[derive(Debug)]
struct Lead {
    by: Handle,
    /// Owner of its set-points.
    owner: Owner,
    /// The latest stop before it.
    stops: u64,
    /// Time until which its next set-point goes out, and the thread that sends it; `None` if it does not move the arm.
    set_point: Option<(Instant, ThreadId)>,
    /// True if it has moved the arm.
    has_moved: bool,
    /// Number of its end among the events of [`Rest`], while the arm was not seen at rest; `None` before its end.
    over: Option<u64>,
}

impl Lead {
    fn is_over(&self) -> bool {
        self.over.is_some()
    }
}

impl Rest {
    /// Requires that the arm is seen at rest from now on.
    fn require(&mut self) {
        self.events += 1;
        self.due = self.events;
    }
}

/// Kind of a stop, by its consequences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopKind {
    /// Stop of the program: a session brakes first, and motions are kept back until the program acknowledges the stop.
    Program,
    /// Stop of the program that goes out at once: no set-point follows it.
    ProgramNow,
    /// Stop with which the SDK ends one motion, such as a guard's: the next motion waits for rest alone.
    OfMotion,
}

/// Reason that keeps a motion or a set-point back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// A stop is on its way, or was not acknowledged.
    Stopped,
    /// The arm was not seen at rest since a stop, or since the end of a session.
    NotAtRest,
    /// A session leads the arm.
    Led,
}

/// Stop that has begun. When it is dropped, the call that stops has returned.
#[derive(Debug)]
#[must_use = "a stop is on its way until this is dropped"]
pub struct UnderWay {
    stops: Arc<Stops>,
    kind: StopKind,
    number: u64,
}

/// Lead of a session, until it is dropped.
///
/// A session that has moved the arm keeps other commands back after its end, until the arm is seen at rest. A
/// connection has one at most.
#[derive(Debug)]
#[must_use = "a session leads the arm until this is dropped"]
pub struct Leading {
    stops: Arc<Stops>,
}

impl Latch {
    fn is_held(&self) -> bool {
        self.under_way > 0 || self.latching > self.acknowledged
    }

    /// Keeps motions back until an acknowledgement that is yet to come.
    fn latch(&mut self) {
        self.begun += 1;
        self.latching = self.begun;
    }
}

impl State {
    /// The session that moves the arm at present.
    fn leading(&self) -> Option<&Lead> {
        self.lead.as_ref().filter(|lead| !lead.is_over())
    }

    /// True if a stop has begun since the session did.
    fn has_stopped_session(&self) -> bool {
        self.leading().is_some_and(|lead| self.latch.begun > lead.stops)
    }

    /// True if a stop keeps motions back, or ends the session that moves the arm.
    fn is_held(&self) -> bool {
        self.latch.is_held() || self.has_stopped_session()
    }

    /// A stop has failed: counts as one of the program that begins now.
    fn fail(&mut self) {
        self.latch.latch();
        if !self.binds {
            self.latch.acknowledged = self.latch.begun;
        }
    }

    fn needs_rest(&self) -> bool {
        self.binds && (self.rest.due > self.rest.seen || self.lead.as_ref().is_some_and(Lead::is_over))
    }

    /// Time until which a stop waits for a session to brake; `None` without a wait. The thread of the session itself
    /// does not wait.
    fn waits_until(&self) -> Option<Instant> {
        let (due, by) = self.lead.as_ref()?.set_point?;
        (by != thread::current().id()).then_some(due.min(self.goes_out_at?))
    }
}

impl Stops {
    /// Stops of a new connection.
    pub fn new(clock: &Clock) -> Arc<Self> {
        Arc::new(Self { state: Watched::new(clock, State::default()) })
    }

    /// Clock of the connection.
    pub fn clock(&self) -> &Clock {
        self.state.clock()
    }

    /// Attaches a robot; false if the connection has one.
    pub fn attach(&self, robot: impl AttachedRobot + 'static) -> bool {
        let mut state = self.state.lock();
        if state.robot.is_some() {
            return false;
        }
        state.robot = Some(Arc::new(robot));
        state.binds = true;
        true
    }

    /// Detaches the robot. What keeps motions back stays for the next one; true if a session that has ended without
    /// rest kept commands back until now.
    pub fn detach(&self) -> bool {
        let Some(robot) = self.state.lock().robot.clone() else { return false };
        let is_latched = robot.is_latched();
        // At once, so that no motion of another handle passes between.
        let mut state = self.state.lock();
        state.robot = None;
        if is_latched {
            state.latch.latch();
        }
        state.lead.take_if(|lead| lead.is_over()).is_some()
    }

    /// Begins a stop: from here on no motion and no set-point goes out but those that brake.
    pub fn begin(self: &Arc<Self>, kind: StopKind) -> UnderWay {
        let latest = self.clock().now() + LONGEST_BRAKING;
        let mut state = self.state.lock();
        // A thread that sees the stop knows when it goes out.
        state.goes_out_at.get_or_insert(latest);
        state.latch.under_way += 1;
        state.latch.begun += 1;
        state.rest.require();
        let number = state.latch.begun;
        match kind {
            StopKind::Program => state.latch.latching = number,
            StopKind::ProgramNow => (state.latch.latching, state.latch.sent) = (number, number),
            StopKind::OfMotion => {}
        }
        if !state.binds {
            state.latch.acknowledged = number;
        }
        drop(state);
        UnderWay { stops: Arc::clone(self), kind, number }
    }

    /// Records that commands were entered into the exchange as these requests.
    pub(super) fn entered(&self, requests: impl ExactSizeIterator<Item = RequestId>, outgoing: &Outgoing<'_>) {
        if !outgoing.may_move() && outgoing.stop.is_none() {
            return;
        }
        let mut state = self.state.lock();
        if outgoing.may_move() {
            state.moves += requests.len() as u64;
        }
        if let Some(number) = outgoing.stop {
            state.unanswered.extend(requests.map(|request| (request, number)));
        }
    }

    /// Number of commands of all handles so far that may move the arm.
    pub fn moves(&self) -> u64 {
        self.state.lock().moves
    }

    /// Takes a reply, which may be that to a stop.
    pub(super) fn answered(&self, request: RequestId, is_accepted: bool) {
        let mut state = self.state.lock();
        let stop = state.unanswered.iter().find(|(stop, _)| *stop == request).map(|(_, number)| *number);
        // With the reply to a later one they are lost, but a refusal without a name may overtake them.
        state.unanswered.retain(|(stop, _)| if is_accepted { *stop > request } else { *stop != request });
        let Some(number) = stop else { return };
        if !is_accepted {
            state.fail();
            return;
        }
        state.latch.accepted = state.latch.accepted.max(number);
        let robot = state.robot.clone();
        drop(state);
        if let Some(robot) = robot {
            robot.stopped();
        }
    }

    /// Owners of the requests of the session that leads the arm: its handle, and that of its set-points.
    pub(super) fn leaders(&self) -> Option<[Owner; 2]> {
        self.state.lock().leading().map(|lead| [lead.by.owner(), lead.owner])
    }

    /// True while a session sends set-points that move the arm.
    pub(crate) fn is_led(&self) -> bool {
        self.state.lock().lead.as_ref().is_some_and(|lead| lead.set_point.is_some())
    }

    /// Number of the latest requested stop.
    pub fn begun(&self) -> u64 {
        self.state.lock().latch.begun
    }

    /// Number of the latest stop that the controller has accepted.
    pub fn accepted(&self) -> u64 {
        self.state.lock().latch.accepted
    }

    /// Number of the latest requested stop; `None` while a stop keeps motions back.
    pub fn settled(&self) -> Option<u64> {
        let state = self.state.lock();
        (!state.latch.is_held()).then_some(state.latch.begun)
    }

    /// True while a call that stops has not returned.
    pub fn is_under_way(&self) -> bool {
        self.state.lock().latch.under_way > 0
    }

    /// True if a stop keeps motions back, or ends the session that moves the arm.
    pub fn is_held(&self) -> bool {
        self.state.lock().is_held()
    }

    /// Acknowledges the stops that have begun before. A stop on its way still keeps motions back, and the session that
    /// it ends, too.
    pub fn acknowledge(&self) {
        let mut state = self.state.lock();
        state.latch.acknowledged = state.latch.begun;
        state.lead.take_if(|lead| lead.is_over());
    }

    /// Requires that the arm is seen at rest before the next motion, as after a stop that a packet shows.
    pub fn require_rest(&self) {
        self.state.lock().rest.require();
    }

    /// Number of the events so far, after which the arm must be seen at rest: for [`rest_seen`](Self::rest_seen).
    pub fn rest_due(&self) -> u64 {
        self.state.lock().rest.events
    }

    /// The arm was seen at rest by answers to questions that were asked after [`rest_due`](Self::rest_due) gave this
    /// number.
    pub fn rest_seen(&self, due: u64) {
        let mut state = self.state.lock();
        state.rest.seen = state.rest.seen.max(due);
        state.lead.take_if(|lead| lead.over.is_some_and(|end| end <= due));
    }

    /// True if the arm must be seen at rest before the next motion.
    pub fn needs_rest(&self) -> bool {
        self.state.lock().needs_rest()
    }

    /// Fails if a motion that the controller plans may not go out, or no session may begin.
    pub fn check_motion(&self) -> Result<(), Kept> {
        let state = self.state.lock();
        if state.is_held() {
            Err(Kept::Stopped)
        } else if state.leading().is_some() {
            Err(Kept::Led)
        } else if state.needs_rest() {
            Err(Kept::NotAtRest)
        } else {
            Ok(())
        }
    }

    /// Fails if a set-point of the session may not go out, and none that holds the arm.
    pub fn check_set_point(&self) -> Result<(), Kept> {
        if self.is_held() { Err(Kept::Stopped) } else { Ok(()) }
    }

    /// Fails if no set-point may go out any more that brakes the arm: a stop has gone out, or is about to.
    pub fn check_braking(&self) -> Result<(), Kept> {
        let state = self.state.lock();
        let has_sent = state.leading().is_none_or(|lead| state.latch.sent > lead.stops);
        if has_sent { Err(Kept::Stopped) } else { Ok(()) }
    }

    /// Fails if the session that moves the arm, or has moved it, keeps this command back, or a stop does. A robot's own
    /// commands have a gate in place of this check.
    pub(super) fn check(&self, outgoing: &Outgoing<'_>) -> Result<(), Error> {
        let state = self.state.lock();
        let passes = outgoing.role.is_some_and(Role::passes_beside_set_points);
        let moves = state.binds && !outgoing.is_raw && outgoing.role.is_some_and(Role::moves);
        let robot = state.robot.clone().filter(|_| moves);
        let because = match state.lead.as_ref().filter(|lead| lead.is_over() || lead.by != outgoing.by) {
            // Nothing moves any more that a long query could delay.
            Some(lead) if lead.is_over() && !passes && !outgoing.is_query() => Some(LED_BEFORE),
            Some(lead) if !lead.is_over() && !passes => Some(LED),
            _ if moves && state.latch.is_held() => Some(STOPPED),
            _ if moves && state.needs_rest() => Some(NOT_AT_REST),
            _ => None,
        };
        drop(state);
        let is_latched = robot.is_some_and(|robot| robot.is_latched());
        match because {
            None | Some(NOT_AT_REST) if is_latched => Err(kept_back(outgoing, STOPPED)),
            Some(because) => Err(kept_back(outgoing, because)),
            None => Ok(()),
        }
    }

    /// Begins the lead of a session by this handle. Other handles send only what passes beside it, from here on.
    pub(super) fn lead(self: &Arc<Self>, by: Handle, owner: Owner) -> Result<Leading, Kept> {
        let mut state = self.state.lock();
        if state.latch.is_held() {
            return Err(Kept::Stopped);
        }
        if state.leading().is_some() {
            return Err(Kept::Led);
        }
        if state.needs_rest() {
            return Err(Kept::NotAtRest);
        }
        let stops = state.latch.begun;
        state.lead = Some(Lead { by, owner, stops, set_point: None, has_moved: false, over: None });
        drop(state);
        Ok(Leading { stops: Arc::clone(self) })
    }

    /// Waits while a session brakes. Does not wait for a session with an overdue set-point, because the arm has none to
    /// follow.
    fn wait_until_braked(&self) {
        let mut state = self.state.lock();
        while let Some(until) = state.waits_until() {
            let left = self.clock().left(until);
            if left.is_zero() {
                break;
            }
            state = self.state.wait(state, left);
        }
        state.goes_out_at = None;
    }

    /// Time that a stop waits yet for a session to brake; `None` if none waits.
    pub fn time_to_brake(&self) -> Option<Duration> {
        let latest = self.state.lock().goes_out_at?;
        Some(self.clock().left(latest))
    }
}

fn kept_back(outgoing: &Outgoing<'_>, because: &'static str) -> Error {
    ErrorKind::KeptBack { command: outgoing.command.to_owned(), because }.into()
}

impl UnderWay {
    /// Number of the stop.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// Waits while a session brakes, for 3 s at most. From here on no set-point goes out.
    pub(crate) fn wait_until_braked(&self) {
        match self.kind {
            StopKind::Program | StopKind::OfMotion => self.stops.wait_until_braked(),
            StopKind::ProgramNow => self.stops.state.lock().goes_out_at = None,
        }
        let mut state = self.stops.state.lock();
        state.latch.sent = state.latch.sent.max(self.number);
        // Rest that was seen before counts for nothing.
        state.rest.require();
    }

    /// Records that the controller has not accepted the stop. Counts as a stop of the program that begins now, so that
    /// an earlier acknowledgement does not cover it.
    pub(crate) fn failed(&self) {
        self.stops.state.lock().fail();
    }

    /// Withdraws the stop, of which nothing was sent, unless another one has begun since.
    pub(crate) fn take_back(self) {
        let mut state = self.stops.state.lock();
        if state.latch.begun == self.number {
            state.latch.begun -= 1;
            state.latch.latching = state.latch.latching.min(state.latch.begun);
            state.latch.sent = state.latch.sent.min(state.latch.begun);
            state.latch.acknowledged = state.latch.acknowledged.min(state.latch.begun);
        }
    }
}

impl Drop for UnderWay {
    fn drop(&mut self) {
        self.stops.state.lock().latch.under_way -= 1;
    }
}

impl Leading {
    /// The session sends its next set-point from this thread by `due`; `None` if it does not move the arm.
    pub fn expect_set_point(&self, due: Option<Instant>) {
        let mut state = self.stops.state.lock();
        let Some(lead) = state.lead.as_mut() else { return };
        let was_expected = lead.set_point.is_some();
        lead.set_point = due.map(|due| (due, thread::current().id()));
        lead.has_moved |= due.is_some();
        if was_expected && due.is_none() {
            self.stops.state.wake();
        }
    }

    /// Ends the lead of a session after which the arm was seen at rest.
    pub fn end_at_rest(self) {
        let mut state = self.stops.state.lock();
        if let Some(lead) = state.lead.as_mut() {
            lead.has_moved = false;
        }
    }
}

impl Drop for Leading {
    fn drop(&mut self) {
        let mut state = self.stops.state.lock();
        let state = &mut *state;
        let Some(lead) = state.lead.as_mut() else { return };
        if lead.has_moved {
            state.rest.events += 1;
            (lead.set_point, lead.over) = (None, Some(state.rest.events));
        } else {
            state.lead = None;
        }
        self.stops.state.wake();
    }
}

impl fmt::Debug for Stops {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let state = self.state.lock();
        f.debug_struct("Stops").field("latch", &state.latch).field("lead", &state.lead).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod fixture;

#[cfg(all(test, shuttle))]
mod interleavings;

#[cfg(all(test, not(shuttle)))]
mod tests;

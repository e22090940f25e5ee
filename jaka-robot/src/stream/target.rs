//! Orders for the arm, shared by the handles and the cycle's thread.

use std::sync::OnceLock;
use std::time::{Duration, Instant};

use jaka_clock::Clock;
use jaka_motion::{Bound, Goal, Step};
use jaka_proto::messages::types::JointPosition;
use jaka_sync::layer::Watched;

use crate::Cause;
use crate::error::SessionEnd;
use crate::place::Quantity;

/// Order for the arm, and the arm's progress with it.
#[derive(Debug)]
pub(super) struct Targets {
    /// Locked alone, and only for as long as it takes to copy: the cycle's thread never waits for it. Waited for until
    /// the arm has come to rest, or the stream has ended.
    state: Watched<TargetState>,
    /// Reason why the stream lands, once it does.
    landing: OnceLock<SessionEnd>,
}

/// Goal of the arm, its deadline, and its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Order {
    goal: Goal,
    /// Quantity in which the goal was given.
    given_in: Quantity,
    until: Option<Instant>,
    number: u64,
}

impl Order {
    pub(super) fn depends_on_frames(&self) -> bool {
        self.given_in == Quantity::Pose
    }

    /// Rest, after a velocity that has ended.
    fn goal(&self, now: Instant) -> Goal {
        if self.has_ended(now) { Goal::Rest } else { self.goal }
    }

    /// True if nothing more is to come: a target stays, a velocity ends.
    fn is_final(&self, now: Instant) -> bool {
        self.until.is_none() || self.has_ended(now)
    }

    fn has_ended(&self, now: Instant) -> bool {
        self.until.is_some_and(|until| now >= until)
    }
}

#[derive(Debug)]
struct TargetState {
    /// Numbered by the count of goals.
    order: Order,
    /// Joint positions of the last set-point; `is_at_rest` is true if the last order ends there.
    joints: JointPosition,
    is_at_rest: bool,
    /// Bound that slowed the last set-point.
    bound: Option<Bound>,
    ended: Option<SessionEnd>,
}

impl Targets {
    pub(super) fn new(start: JointPosition, clock: &Clock) -> Self {
        let order = Order { goal: Goal::Rest, given_in: Quantity::Joints, until: None, number: 0 };
        let state = TargetState { order, joints: start, is_at_rest: true, bound: None, ended: None };
        Self { state: Watched::new(clock, state), landing: OnceLock::new() }
    }

    /// Gives another goal. Fails if the stream lands or has ended, with the reason.
    pub(super) fn give(
        &self,
        (given_in, goal): (Quantity, Goal),
        for_at_most: Option<Duration>,
    ) -> Result<(), SessionEnd> {
        let until = for_at_most.map(|time| self.state.clock().now() + time);
        let mut state = self.state.lock();
        if let Some(because) = self.ends_because(&state) {
            return Err(because);
        }
        state.order = Order { goal, given_in, until, number: state.order.number + 1 };
        state.is_at_rest = false;
        Ok(())
    }

    /// Has the stream land.
    pub(super) fn land(&self) {
        self.land_because(SessionEnd::new(Cause::Stopped, "it lands"));
    }

    /// Takes no more goals, since the stream lands. Never waits for a lock.
    pub(super) fn land_because(&self, end: SessionEnd) {
        self.landing.get_or_init(|| end);
        self.tell_landing();
    }

    pub(super) fn is_landing(&self) -> bool {
        self.landing.get().is_some()
    }

    /// Wakes the threads that wait for rest, unless a handle has the lock: then one of the next set-points does so.
    fn tell_landing(&self) {
        if let Some(_state) = self.state.try_lock() {
            self.state.wake();
        }
    }

    /// Reason why the stream takes no more goals, if so.
    fn ends_because(&self, state: &TargetState) -> Option<SessionEnd> {
        state.ended.as_ref().or_else(|| self.landing.get()).cloned()
    }

    /// Joint positions of the last set-point.
    pub(super) fn joints(&self) -> JointPosition {
        self.state.lock().joints
    }

    /// Bound that slowed the last set-point, if one did.
    pub(super) fn bound(&self) -> Option<Bound> {
        self.state.lock().bound.clone()
    }

    /// Waits until the arm rests at the last goal, or the stream lands or has ended; returns the reason for such an
    /// end.
    pub(super) fn wait_for_rest(&self, timeout: Duration) -> Result<bool, SessionEnd> {
        let found = self.state.wait_for(timeout, |state| match self.ends_because(state) {
            Some(because) => Some(Err(because)),
            None => state.is_at_rest.then_some(Ok(true)),
        });
        found.unwrap_or(Ok(false))
    }

    /// Order for this cycle. `None` while a handle changes it: the cycle then repeats the previous order.
    pub(super) fn order(&self) -> Option<Order> {
        self.state.try_lock().map(|state| state.order)
    }

    /// Present goal of an order: rest, after a velocity that has ended.
    pub(super) fn goal(&self, order: &Order) -> Goal {
        order.goal(self.state.clock().now())
    }

    /// A set-point was sent by this order; the joints rest at its goal, or move on.
    pub(super) fn sent(&self, step: Step, order: &Order, rests_there: bool) {
        let Some(mut state) = self.state.try_lock() else { return };
        (state.joints, state.bound) = (step.joints, step.bound);
        let rests = rests_there && order.is_final(self.state.clock().now()) && order.number == state.order.number;
        if rests && !state.is_at_rest {
            self.state.wake();
        }
        state.is_at_rest = rests;
    }

    /// The stream lands: a set-point of the landing was sent to these joints.
    pub(super) fn landing(&self, joints: Option<JointPosition>) {
        if let (Some(joints), Some(mut state)) = (joints, self.state.try_lock()) {
            (state.joints, state.bound) = (joints, None);
        }
        self.tell_landing();
    }

    /// The stream has landed: nothing waits for this thread any more.
    pub(super) fn landed(&self, joints: JointPosition) {
        self.state.lock().joints = joints;
    }

    pub(super) fn end(&self, end: SessionEnd) {
        self.state.lock().ended.get_or_insert(end);
        self.state.wake();
    }
}

//! What the arm is to do next, shared by the handles and the cycle's thread.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

use jaka_motion::Goal;
use jaka_proto::messages::types::JointPosition;

/// What the arm is to do next, and how far it is.
#[derive(Debug)]
pub(super) struct Targets {
    /// Locked alone, and only for as long as it takes to copy: the cycle's thread never waits for it.
    state: Mutex<State>,
    /// Signalled when the arm has come to rest, and when the stream has ended.
    rested: Condvar,
}

/// What the cycle's thread is to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Order {
    Go(Goal),
    Land,
}

#[derive(Debug)]
struct State {
    goal: Goal,
    /// Until when it holds; a velocity ends.
    until: Option<Instant>,
    is_landing: bool,
    /// How many goals were given.
    given: u64,
    /// Where the joints are to be, the number of the last goal that counted for it, and whether they rest.
    joints: JointPosition,
    reached: u64,
    is_at_rest: bool,
    ended: Option<String>,
}

impl Targets {
    pub(super) fn new(start: JointPosition) -> Self {
        let state = State {
            goal: Goal::Rest,
            until: None,
            is_landing: false,
            given: 0,
            joints: start,
            reached: 0,
            is_at_rest: true,
            ended: None,
        };
        Self { state: Mutex::new(state), rested: Condvar::new() }
    }

    /// Gives another goal; fails with why the stream has ended, if it has.
    pub(super) fn give(&self, goal: Goal, for_at_most: Option<Duration>) -> Result<(), String> {
        let until = for_at_most.map(|time| Instant::now() + time);
        let mut state = self.lock();
        match &state.ended {
            Some(because) => Err(because.clone()),
            None if state.is_landing => Err("it lands".to_owned()),
            None => {
                (state.goal, state.until) = (goal, until);
                state.given += 1;
                state.is_at_rest = false;
                Ok(())
            }
        }
    }

    pub(super) fn land(&self) {
        self.lock().is_landing = true;
    }

    /// Where the joints are to be at the last set-point.
    pub(super) fn joints(&self) -> JointPosition {
        self.lock().joints
    }

    /// Waits until the arm rests on the last goal that was given, or the stream has ended, of which it tells why.
    pub(super) fn wait_for_rest(&self, timeout: Duration) -> Result<bool, String> {
        let since = Instant::now();
        let mut state = self.lock();
        loop {
            if let Some(because) = &state.ended {
                return Err(because.clone());
            }
            if state.is_at_rest {
                return Ok(true);
            }
            let left = timeout.saturating_sub(since.elapsed());
            if left.is_zero() {
                return Ok(false);
            }
            state = self.rested.wait_timeout(state, left).unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    /// What to do in this cycle, with the number of the goal; none while a handle changes it: then as in the cycle before.
    pub(super) fn order(&self) -> Option<(Order, u64)> {
        let mut state = match self.state.try_lock() {
            Ok(state) => state,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return None,
        };
        if state.is_landing {
            return Some((Order::Land, state.given));
        }
        if state.until.is_some_and(|until| Instant::now() >= until) {
            (state.goal, state.until) = (Goal::Rest, None);
        }
        Some((Order::Go(state.goal), state.given))
    }

    /// A set-point was sent on the way to the goal of this number.
    pub(super) fn sent(&self, joints: JointPosition, number: u64, is_at_rest: bool) {
        let Ok(mut state) = self.state.try_lock() else { return };
        state.joints = joints;
        state.reached = number;
        // A velocity that still holds is not at its end where the arm rests, at a limit.
        let is_over = state.until.is_none();
        let rests = is_at_rest && is_over && number == state.given;
        if rests && !state.is_at_rest {
            self.rested.notify_all();
        }
        state.is_at_rest = rests;
    }

    pub(super) fn end(&self, because: String) {
        self.lock().ended.get_or_insert(because);
        self.rested.notify_all();
    }

    /// Every change is made whole before the lock is left.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

//! One cell of the matrix: a controller, a fault, a call, and the next one.

use std::fmt::{self, Debug};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::Duration;

use jaka_robot::jaka_sync::{self, ErrorKind as Failure};
use jaka_robot::kinematics::GetJointPos;
use jaka_robot::payload::GetPayload;
use jaka_robot::types::JointPosition;
use jaka_robot::{Client, Config, Error};
use jaka_sim::SimulatedClock;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, failure};

use crate::link::LinkTrouble;
use crate::model::{self, Expected};
use crate::outcome::Outcome;
use crate::troubles::Trouble;
use crate::{calls, motion, servo, status};

/// The kinds of calls: the columns of the matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Query,
    Setting,
    Raw,
    Text,
    /// A query whose connection is recorded.
    Recorded,
    /// A stop handle, while no call waits.
    Stop,
    /// A query, and a stop handle while it waits.
    StopBeside,
    /// A motion, where it goes wrong before the motion is sent.
    Motion,
    /// A motion, where it goes wrong once it was accepted.
    EndOfMotion,
    /// A servo session, where it goes wrong before servo mode is asked for.
    Entering,
    /// A servo session, where it goes wrong in servo mode.
    SetPoints,
    StatusStream,
    Monitor,
}

impl Kind {
    pub(crate) const ALL: [Self; 13] = [
        Self::Query,
        Self::Setting,
        Self::Raw,
        Self::Text,
        Self::Recorded,
        Self::Stop,
        Self::StopBeside,
        Self::Motion,
        Self::EndOfMotion,
        Self::Entering,
        Self::SetPoints,
        Self::StatusStream,
        Self::Monitor,
    ];

    /// True if the reply has fields that the spec knows.
    pub(crate) fn has_typed_fields(self) -> bool {
        matches!(self, Self::Query | Self::Recorded | Self::StopBeside)
    }
}

/// The call after the one with the fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Next {
    Other,
    Same,
}

/// Outcomes that were seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Seen {
    pub(crate) first: Outcome,
    pub(crate) stop: Option<Outcome>,
    pub(crate) next: Outcome,
}

/// Longer than anything takes.
pub(crate) const LIMIT: Duration = Duration::from_secs(60);

/// Timeout of a call that is to succeed.
pub(crate) const PATIENCE: Duration = Duration::from_secs(20);

/// Age of a stale packet, where packets are to stay away.
pub(crate) const STALE: Duration = Duration::from_millis(600);

/// Between two looks at something that another thread does.
pub(crate) const SHORT: Duration = Duration::from_millis(1);

/// The longest message that clients take: more than a status packet, less than an oversized reply.
pub(crate) const MAX_FRAME: usize = 16 << 10;

/// Period of status packets.
pub(crate) const PERIOD: Duration = Duration::from_millis(8);

/// A fault and a call that meet.
pub(crate) struct Cell<'t> {
    pub(crate) trouble: &'t Trouble,
    pub(crate) kind: Kind,
    pub(crate) next: Next,
    pub(crate) expected: Expected,
    /// Expected end of the next call.
    pub(crate) then: Outcome,
    pub(crate) controller: Arm,
    /// Position of the arm, as a number that no state before had.
    mark: AtomicU32,
    is_struck: AtomicBool,
    is_lifted: AtomicBool,
    pause: Duration,
}

impl<'t> Cell<'t> {
    /// An arm that is powered and enabled, in a simulated time of its own.
    pub(crate) fn new(trouble: &'t Trouble, kind: Kind, next: Next, pause: Duration) -> Self {
        let expected = model::expected(trouble, kind);
        let then = if next == Next::Same { expected.same } else { None }.unwrap_or(expected.other);
        let controller = Arm::simulated().status_period(PERIOD).start();
        Self {
            trouble,
            kind,
            next,
            expected,
            then,
            controller,
            mark: AtomicU32::new(0),
            is_struck: AtomicBool::new(false),
            is_lifted: AtomicBool::new(false),
            pause,
        }
    }

    /// Makes the call and the next one.
    pub(crate) fn run(&self) -> Seen {
        match self.kind {
            Kind::Query | Kind::Setting | Kind::Raw | Kind::Text | Kind::Recorded | Kind::Stop => calls::run(self),
            Kind::StopBeside => calls::run_concurrent_stop(self),
            Kind::Motion => motion::run(self),
            Kind::EndOfMotion => motion::run_end(self),
            Kind::Entering => servo::run_entering(self),
            Kind::SetPoints => servo::run_set_points(self),
            Kind::StatusStream => status::run_stream(self),
            Kind::Monitor => status::run_monitor(self),
        }
    }

    /// Timeout of a call: short where it is to wait in vain.
    pub(crate) fn patience(&self, expected: Outcome) -> Duration {
        match self.kind {
            _ if !expected.is_timeout() => PATIENCE,
            // A motion has ended by then, and the controller is asked where the arm is.
            Kind::EndOfMotion => Duration::from_millis(1500),
            // Shorter than a late reply takes, and longer than half of that.
            Kind::Entering => Duration::from_secs(1),
            _ => Duration::from_millis(100),
        }
    }

    pub(crate) fn config(&self) -> Config {
        let ends = [self.expected.first, self.then].into_iter().find(|outcome| outcome.is_timeout());
        let timeout = match self.kind {
            // Their calls have a time of their own.
            Kind::Motion | Kind::EndOfMotion | Kind::SetPoints => PATIENCE,
            Kind::Entering => self.patience(ends.unwrap_or(Outcome::Ok)),
            _ => self.patience(self.expected.first),
        };
        let stale_after = if self.waits_for_stale_status() { STALE } else { LIMIT };
        self.controller.config().max_frame(MAX_FRAME).reply_timeout(timeout).stale_after(stale_after)
    }

    /// True if a call of this cell is to be kept back without status.
    pub(crate) fn waits_for_stale_status(&self) -> bool {
        [self.expected.first, self.then].contains(&Outcome::StatusUnknown)
    }

    pub(crate) fn client(&self) -> Client {
        Client::connect_with(&self.config(), self.controller.command_addr()).expect("the controller listens")
    }

    /// The time of this cell.
    pub(crate) fn clock(&self) -> &SimulatedClock {
        self.controller.clock()
    }

    /// From now on the next reply to this command, and status packets, go wrong.
    pub(crate) fn strike(&self, command: &str) {
        if let Some(fault) = self.trouble.fault(command) {
            self.controller.inject_for(command, fault);
        }
        self.controller.status_fault(self.trouble.status());
        if let Trouble::Link(trouble) = self.trouble {
            trouble.strike(&self.controller);
        }
        self.is_struck.store(true, Ordering::SeqCst);
    }

    /// Makes a call, while a link that is held for a time is released.
    pub(crate) fn while_held<T>(&self, call: impl FnOnce() -> T) -> T {
        let held = match self.trouble {
            Trouble::Link(LinkTrouble { lasting: Some(time), .. }) if !self.is_lifted() => *time,
            _ => return call(),
        };
        let is_done = AtomicBool::new(false);
        let release = || {
            while !self.is_struck.load(Ordering::SeqCst) && !is_done.load(Ordering::SeqCst) {
                self.clock().sleep(SHORT);
            }
            self.clock().sleep(held);
            self.controller.links().release();
        };
        beside(self.clock(), release, || {
            let result = call();
            is_done.store(true, Ordering::SeqCst);
            result
        })
    }

    fn is_lifted(&self) -> bool {
        self.is_lifted.load(Ordering::SeqCst)
    }

    /// Number of requests of this name that the controller has received.
    pub(crate) fn received(&self, command: &str) -> usize {
        let name = format!("\"{command}\"");
        self.controller.requests().iter().filter(|request| request.contains(&name)).count()
    }

    /// From now on nothing goes wrong any more.
    pub(crate) fn lift(&self) {
        self.is_lifted.store(true, Ordering::SeqCst);
        self.controller.clear_faults();
        self.controller.status_fault(jaka_sim::StatusFault::None);
        if matches!(self.trouble, Trouble::Link(_)) {
            self.controller.links().release();
        }
        self.clock().sleep(self.pause);
    }

    /// Moves the arm at once to where it has never been, by a number that goes up.
    pub(crate) fn mark(&self) -> f64 {
        let mark = f64::from(self.mark.fetch_add(1, Ordering::SeqCst) + 1);
        self.controller.set_state(|state| {
            state.joint_position = position(mark);
            state.payload.mass = mark;
        });
        mark
    }

    /// Makes a call, and tells how it ended. One that ends by its timeout ends at that very time; entering servo mode
    /// alone takes several commands.
    pub(crate) fn ends<T: Into<Outcome> + Debug, E: Into<Error>>(
        &self,
        timeout: Duration,
        expected: Outcome,
        call: impl FnOnce() -> Result<T, E>,
    ) -> Outcome {
        let before = self.controller.requests().len();
        let since = self.clock().elapsed();
        let result = self.while_held(call).map_err(Into::into);
        let took = self.clock().elapsed().saturating_sub(since);
        assert!(took <= timeout.max(PATIENCE), "{self}: took {took:?}");
        let shown = format!("{result:?}");
        if let Err(error) = &result {
            let failure = failure(error);
            let is_timeout = matches!(failure, Some(Failure::Timeout { .. } | Failure::StatusTimeout { .. }));
            if is_timeout && self.kind == Kind::Entering {
                assert!(took >= timeout, "{self}: {error} after {took:?}");
            } else if is_timeout && !timeout.is_zero() {
                assert_eq!(took, timeout, "{self}: {error}");
            }
            assert!(!self.is_broken() || !error.may_have_run(), "{self}: sent on a broken connection, {error:?}");
            if let Some(Failure::Disconnected { command: Some(command), sent: false, .. }) = failure {
                // Of the call before, something may have come late.
                let name = format!("\"{command}\"");
                let came = self.controller.requests().split_off(before);
                let count = came.iter().filter(|request| request.contains(&name)).count();
                // A servo session enters by a command of the name by which it leaves.
                let entered = matches!(self.kind, Kind::Entering | Kind::SetPoints) && command == "servo_move";
                assert!(count <= usize::from(entered), "{self}: {error}, but {came:?}");
            }
        }
        let outcome = result.map_or_else(|error| Outcome::of(&error), Into::into);
        if outcome == Outcome::Deadline {
            assert_eq!(took, timeout, "{self}: {shown}");
        }
        if outcome != expected {
            println!("{self}: {shown} instead of {expected}");
        }
        outcome
    }

    /// True if the first call has broken the connection.
    fn is_broken(&self) -> bool {
        let ended = self.expected.stop.unwrap_or(self.expected.first);
        self.is_lifted() && matches!(ended, Outcome::Broken(_))
    }

    /// Checks that a query gets the position that the arm has now.
    pub(crate) fn joint_position(&self, client: &mut Client, timeout: Duration) -> Result<(), jaka_sync::Error> {
        let mark = self.mark();
        let found = client.call_within(&GetJointPos::new(), timeout)?.joint_position;
        assert_eq!(found, position(mark), "{self}: the reply is another's");
        Ok(())
    }

    /// The payload as it is now, and nothing else.
    pub(crate) fn payload(&self, client: &mut Client, timeout: Duration) -> Result<(), jaka_sync::Error> {
        let mark = self.mark();
        let found = client.call_within(&GetPayload::new(), timeout)?.mass;
        assert_eq!(found.to_bits(), mark.to_bits(), "{self}: the reply is another's");
        Ok(())
    }
}

impl fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {:?}, then {:?}", self.trouble, self.kind, self.next)
    }
}

/// The position with this mark.
pub(crate) fn position(mark: f64) -> JointPosition {
    [mark; 6].into()
}

//! The arm at the other end of a connection: commands to it, queries, and its state.

mod guards;
#[cfg(all(test, shuttle))]
mod interleavings;
mod position;
mod rest;
mod state;
mod status;
mod stillness;
mod stop_handle;
mod trouble;

use std::fmt;
use std::sync::{Arc, Weak};
use std::time::Duration;

use jaka_clock::Clock;
use jaka_proto::Refusal;
use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::messages::status::RobotStatus;
use jaka_sync::layer::{AttachedRobot, ClientParts as _, Leading, Link, Owner, Stops, told};

pub(crate) use self::guards::{GuardProgress, PacketObserver};
pub use self::position::wait_for_rest;
pub(crate) use self::position::{Answer, Position, QUERY_PERIOD, SETTLING};
pub(crate) use self::rest::REST_SPEED;
use self::state::not_acknowledged;
pub(crate) use self::state::{ArmState, Sending, kept_back};
pub(crate) use self::status::unknown;
pub(crate) use self::stillness::Stillness;
pub use self::stop_handle::RobotStop;
pub(crate) use self::stop_handle::Sent;
pub(crate) use self::trouble::{Since, Stop, lost, stop};
use crate::error::Attach as _;
use crate::under_way::UnderWay;
use crate::{
    Client, Command, Disconnect, Error, ErrorKind, Monitor, MonitorStatistics, MotionStatus, Occurrence, Snapshot,
};

/// Monitor of an arm, for any type of its status.
pub(crate) trait StatusSource: Send + Sync {
    fn statistics(&self) -> MonitorStatistics;

    /// Fields that packets never have: [`MotionStatus::absent`].
    fn absent(&self) -> &'static [&'static str];

    /// Fails if the connection has ended.
    fn check_open(&self) -> Result<(), jaka_sync::Error>;

    /// Waits for the next packet: as [`Monitor::next_packet`].
    fn next_packet(&self) -> Result<(), jaka_sync::Error>;

    /// Waits for a packet: as [`Monitor::wait_until`].
    fn wait_until(&self, wanted: &dyn Fn(&RobotStatus) -> bool, timeout: Duration) -> Result<(), jaka_sync::Error>;
}

impl<S: MotionStatus> StatusSource for Monitor<S> {
    fn statistics(&self) -> MonitorStatistics {
        Self::statistics(self)
    }

    fn absent(&self) -> &'static [&'static str] {
        S::absent()
    }

    fn check_open(&self) -> Result<(), jaka_sync::Error> {
        self.newest_packet().map(drop)
    }

    fn next_packet(&self) -> Result<(), jaka_sync::Error> {
        Self::next_packet(self).map(drop)
    }

    fn wait_until(&self, wanted: &dyn Fn(&RobotStatus) -> bool, timeout: Duration) -> Result<(), jaka_sync::Error> {
        Self::wait_until(self, |status| told(status).is_ok_and(|status| wanted(&status)), timeout).map(drop)
    }
}

/// Status port of an arm: its monitor, and the status from its packets.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StatusPort<'m> {
    pub(crate) source: &'m dyn StatusSource,
    pub(crate) state: &'m ArmState,
}

impl fmt::Debug for dyn StatusSource + '_ {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("StatusSource").field(&self.statistics()).finish()
    }
}

/// Longest wait for the rest of an arm that was stopped.
pub(crate) const REST: Duration = Duration::from_secs(2);

/// State of an arm, as its connection knows it.
struct Attachment(Weak<ArmState>);

impl AttachedRobot for Attachment {
    fn stopped(&self) {
        if let Some(state) = self.0.upgrade() {
            state.wake();
        }
    }

    fn is_latched(&self) -> bool {
        self.0.upgrade().is_some_and(|state| state.is_latched())
    }
}

/// Robot of a connection, until it is dropped.
#[derive(Debug)]
struct Attached(Arc<Stops>);

impl Drop for Attached {
    fn drop(&mut self) {
        // During a panic a logger, which may panic, must not run.
        if self.0.detach() && !std::thread::panicking() {
            log::warn!(target: "jaka_robot", "the robot was dropped, and its arm was not seen at rest since its last set-point");
        }
    }
}

/// Arm at the other end of a connection.
#[derive(Debug)]
pub(crate) struct Arm {
    client: Client,
    /// The robot of the connection, for the robot's own arm; `None` for a lent one. Dropped before the state: the
    /// connection takes over what must be acknowledged.
    _attached: Option<Attached>,
    source: Arc<dyn StatusSource>,
    pub(crate) state: Arc<ArmState>,
    pub(crate) position: Position,
    /// Number of this program's frame changes at the time of its last motion; packets may be older than a later change.
    frame_changes: u64,
}

impl Arm {
    /// Arm of two connections to the same controller. `needs_status` is false where motions go out while the status is
    /// not known.
    ///
    /// Gives the client back if its connection has a robot.
    pub(crate) fn new<S: MotionStatus>(
        client: Client,
        monitor: &Arc<Monitor<S>>,
        needs_status: bool,
    ) -> Result<Self, Box<Client>> {
        let stops = &client.link().stops;
        let state = ArmState::new(monitor, stops, needs_status);
        if !stops.attach(Attachment(Arc::downgrade(&state))) {
            return Err(Box::new(client));
        }
        let attached = Some(Attached(Arc::clone(stops)));
        let position = Position::new(&client);
        let source: Arc<dyn StatusSource> = Arc::<Monitor<S>>::clone(monitor);
        Ok(Self { client, source, state, position, _attached: attached, frame_changes: 0 })
    }

    /// Returns a second arm of the same connections, for another thread, which ends before this arm is dropped.
    pub(crate) fn lent(&mut self) -> Self {
        let (source, state) = (Arc::clone(&self.source), Arc::clone(&self.state));
        let (client, position) = (self.client.lent(), self.position.lent());
        Self { client, source, state, position, _attached: None, frame_changes: self.frame_changes }
    }

    /// Client of the arm, for a command that may change the position of the arm.
    pub(crate) fn client(&mut self) -> &mut Client {
        self.position.note_rest(false);
        &mut self.client
    }

    /// Client of the arm, for a query.
    pub(crate) fn queries(&mut self) -> &mut Client {
        &mut self.client
    }

    /// Both ports.
    pub(crate) fn ports(&mut self) -> (&mut Client, StatusPort<'_>) {
        (&mut self.client, StatusPort { source: &*self.source, state: &self.state })
    }

    /// Command connection.
    pub(crate) fn link(&self) -> &Arc<Link> {
        self.client.link()
    }

    /// Number of commands of other handles of the connection that may have changed something.
    pub(crate) fn changes_by_others(&self) -> u64 {
        self.link().changes_but_of(self.client.handle())
    }

    /// Record of changes under way (selected frames, rapid rate), beginning now.
    pub(crate) fn under_way(&self) -> UnderWay {
        let is_current = self.frame_changes == self.link().frame_changes();
        let newest = self.state.newest_packet().filter(|_| is_current);
        newest.map_or_else(|| UnderWay::after(self.clock().now()), |newest| UnderWay::from(&newest))
    }

    /// The arm is moved, and this program had changed frames so often before.
    pub(crate) fn moved_after(&mut self, frame_changes: u64) {
        self.frame_changes = frame_changes;
    }

    /// Stops of the connection, what they keep back, and the session that moves the arm.
    pub(crate) fn stops(&self) -> &Arc<Stops> {
        &self.link().stops
    }

    /// Begins the lead of a session: other handles of the connection send only what passes beside it.
    pub(crate) fn lead(&self, owner: Owner) -> Result<Leading, Error> {
        self.link().lead(self.client.handle(), owner).map_err(|by| self.attach(kept_back(by)))
    }

    /// Waits until an arm is at rest that was stopped, or led by a session, and was not seen at rest since then. Fails
    /// if it does not come to rest within `timeout`, and 2 s.
    pub(crate) fn rest_after_stop(&mut self, timeout: Duration) -> Result<(), Error> {
        if !self.stops().needs_rest() {
            return Ok(());
        }
        self.position.wait_for_rest(timeout.min(REST)).map(drop)
    }

    /// Sends a command; its reply is polled for, as in [`Link::ask`].
    pub(crate) fn ask<C: Command>(&self, command: &C) -> Result<jaka_sync::layer::Sent<'static>, jaka_sync::Error> {
        self.link().ask((C::INFO, command.role(), self.client.handle()), &mut |out| command.write_request(out))
    }

    /// Clock of the connections.
    pub(crate) fn clock(&self) -> &Clock {
        &self.client.link().clock
    }

    /// Error with the last messages of the command connection.
    pub(crate) fn attach(&self, kind: impl Into<Error>) -> Error {
        self.link().attach(kind.into())
    }

    /// Error for an action that the state of the arm prevents.
    pub(crate) fn not_ready(&self, occurrence: impl Into<Occurrence>) -> Error {
        self.attach(ErrorKind::NotReady { occurrence: occurrence.into() })
    }

    /// Gate that lets this pass while it may be sent.
    pub(crate) fn gate(&self, what: Sending) -> impl Fn() -> Result<(), Error> + use<> {
        let state = Arc::clone(&self.state);
        move || state.may_send(what)
    }

    /// Fails while something must be acknowledged.
    pub(crate) fn check_acknowledged(&self) -> Result<(), Error> {
        self.unacknowledged().map_or(Ok(()), |occurrence| Err(not_acknowledged(occurrence)))
    }

    /// Occurrence that must be acknowledged, if there is one.
    pub(crate) fn unacknowledged(&self) -> Option<Occurrence> {
        self.state.unacknowledged()
    }

    /// Occurrence that must be acknowledged, apart from a lost status.
    pub(crate) fn unacknowledged_stop(&self) -> Option<Occurrence> {
        self.state.unacknowledged_stop()
    }

    /// Newest packet, for actions that need one; none if the program has allowed them without status. Waits briefly if
    /// no packet has come lately.
    pub(crate) fn known_status(&self, timeout: Duration) -> Result<Option<Arc<Snapshot>>, Error> {
        match self.state.status_within(timeout) {
            Ok(packet) => Ok(Some(packet)),
            Err(_) if self.state.moves_without_status() => Ok(None),
            Err(problem) => Err(self.attach(unknown(problem))),
        }
    }

    /// Statistics of the status packets.
    pub(crate) fn statistics(&self) -> MonitorStatistics {
        self.source.statistics()
    }

    /// Fields that status packets never have.
    pub(crate) fn absent(&self) -> &'static [&'static str] {
        self.source.absent()
    }

    /// Error for the end of the status connection.
    pub(crate) fn status_ended(&self, cause: Arc<Disconnect>) -> Error {
        // The monitor shows it a moment later than the state.
        let address = self.state.address();
        let ended = || jaka_sync::ErrorKind::Disconnected { address, command: None, sent: false, cause }.into();
        self.source.check_open().map_or_else(Error::from, |()| ended())
    }

    /// Waits for a packet: as [`Monitor::wait_until`].
    pub(crate) fn wait_for_status(
        &self,
        wanted: impl Fn(&RobotStatus) -> bool,
        timeout: Duration,
    ) -> Result<(), Error> {
        Ok(self.source.wait_until(&wanted, timeout)?)
    }

    /// Handle that stops the arm from another thread.
    pub(crate) fn stop_handle(&self) -> RobotStop {
        RobotStop::new(self.client.stop_handle())
    }

    /// Adds the reason for a refusal to the error, if the state of the arm shows it.
    pub(crate) fn explained(&mut self, mut error: Error, timeout: Duration) -> Error {
        let found = error.refusal().and_then(|refusal| explain(self, refusal, timeout));
        if let ErrorKind::Refused { explanation, .. } = error.kind_mut() {
            *explanation = found;
        }
        error
    }

    /// Explanation of an error of the client, if it is a refusal and the state of the arm shows its reason.
    pub(crate) fn explain(&mut self, error: &jaka_sync::Error) -> Option<Occurrence> {
        let timeout = self.client.reply_timeout();
        explain(self, error.refusal()?, timeout)
    }
}

/// Timeout for the query that explains a refusal.
const PATIENCE: Duration = Duration::from_secs(1);

/// Reason for a refusal, as far as the state of the arm shows it.
fn explain(arm: &mut Arm, refusal: &Refusal, timeout: Duration) -> Option<Occurrence> {
    if let Some(reason) = Occurrence::of_refusal(refusal, None) {
        return Some(reason);
    }
    let mut status = arm.state.fresh_packet().map(|newest| newest.status.clone()).unwrap_or_default();
    let state = arm.queries().call_within(&GetRobotState::new(), PATIENCE.min(timeout));
    (status.powered_on, status.enabled) = match &state {
        Ok(state) => (Some(state.powered_on), Some(state.enabled)),
        Err(_) => (None, None),
    };
    if let Ok(Some(event)) = state.as_ref().map_or(Ok(None), GetRobotStateReply::event) {
        status.error_code = Some(format!("{:#x}", event.code()));
    }
    Occurrence::of_refusal(refusal, Some(&status))
}

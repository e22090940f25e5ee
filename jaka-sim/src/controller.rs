//! A running controller.

mod faults;
mod links;
mod run_while;
mod when;

use std::fmt;
use std::io::{self, ErrorKind};
use std::net::SocketAddr;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::SimulatedClock;
use serde_json::Value;

pub use self::links::Link;
use crate::listener::Listener;
use crate::replay::ReplaySession;
use crate::shared::Shared;
use crate::{Builder, Contact, Deviation, Happening, Scheduled, State, command_port, status_port};

/// A simulated controller, which serves both of its ports until it is dropped.
///
/// Any number of them run side by side, each on ports of its own. Dropping it closes all connections, frees the ports
/// and waits for the threads.
pub struct Controller {
    shared: Arc<Shared>,
    commands: Option<JoinHandle<()>>,
    status: Option<JoinHandle<()>>,
    /// Lent to an action, which does not end it.
    is_lent: bool,
}

impl Controller {
    /// Starts a controller with the usual options.
    ///
    /// # Errors
    /// A port cannot be opened, or a thread cannot be started.
    pub fn start() -> io::Result<Self> {
        Self::builder().start()
    }

    /// The options of a controller to start.
    pub fn builder() -> Builder {
        Builder::default()
    }

    fn spawn(&self, run: fn(&Arc<Shared>)) -> io::Result<JoinHandle<()>> {
        let shared = Arc::clone(&self.shared);
        thread::Builder::new().name("jaka-sim".to_owned()).spawn(move || run(&shared))
    }

    /// Where commands are taken: what is port 10001 of a real controller.
    pub fn command_addr(&self) -> SocketAddr {
        self.shared.command_listener.address()
    }

    /// Where status packets are sent: what is port 10000 of a real controller.
    pub fn status_addr(&self) -> SocketAddr {
        self.shared.status_listener.address()
    }

    /// A copy of the present state.
    pub fn state(&self) -> State {
        self.shared.world().state.clone()
    }

    /// Changes the state, as no command could: powers the arm at once, or puts it into a protective stop.
    ///
    /// What cannot be in the new state ends with it: enabling without power, servo mode and drag mode without
    /// enabling, servo mode in a protective stop. Requests wait while `change` runs, so it must not call
    /// the controller.
    pub fn set_state(&self, change: impl FnOnce(&mut State)) {
        let mut world = self.shared.world();
        change(&mut world.state);
        world.make_consistent();
    }

    /// Lets time go on, on a controller with a [stepped clock](Builder::stepped_clock): motions move, delays pass, and status
    /// packets go out on the way. Time goes on in controller cycles of 8 ms; what is less is kept for the next call.
    ///
    /// On a controller with a real clock this does nothing, nor within an action of [`when`](Self::when).
    pub fn advance(&self, time: Duration) {
        if self.is_lent {
            return;
        }
        self.shared.status_listener.wait_until_accepted();
        self.shared.step(time);
    }

    /// The simulated clock, if it was [given](Builder::clock) one.
    pub fn clock(&self) -> Option<&SimulatedClock> {
        self.shared.time().as_simulated()
    }

    /// The controller's time since its start, in whole cycles.
    pub fn elapsed(&self) -> Duration {
        self.shared.world().now()
    }

    /// Has something happen to the arm, to an input or to links at a time of the controller since its start, which is that of
    /// [`elapsed`](Self::elapsed): in the first controller cycle that is not before it, or at once where it has passed.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the controller does not have the input; or a thread cannot be started.
    pub fn at(&self, time: Duration, happening: impl Into<Happening>) -> io::Result<()> {
        let scheduled = Scheduled { happening: happening.into(), at: time };
        self.shared.world().schedule(scheduled)?;
        self.keep_time(&[scheduled])
    }

    /// Puts a plane into the way of the tool centre point, or takes it away, and forgets how deep the tool has been.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if it is not a plane: a normal of zero, a number that is not finite, a negative stiffness.
    pub fn set_contact(&self, contact: Option<Contact>) -> io::Result<()> {
        contact.as_ref().map_or(Ok(()), Contact::check)?;
        self.shared.world().set_contact(contact);
        Ok(())
    }

    /// How deep the tool centre point has been below the plane of [`Builder::contact`] or [`set_contact`](Self::set_contact), in mm; 0 without one.
    ///
    /// It is computed in each controller cycle, and counts until the plane is set again.
    pub fn deepest_penetration(&self) -> f64 {
        self.shared.world().deepest_penetration()
    }

    /// Simulates a collision: a protective stop and the error `0xf0034`, until `clear_error`.
    pub fn collide(&self) {
        self.shared.world().happen(&Happening::Collide);
    }

    /// Presses the emergency stop: the arm is not enabled, and cannot be, until it is released.
    pub fn press_emergency_stop(&self) {
        self.shared.world().happen(&Happening::PressEmergencyStop);
    }

    /// Releases the emergency stop. The arm stays disabled until it is enabled again.
    pub fn release_emergency_stop(&self) {
        self.shared.world().happen(&Happening::ReleaseEmergencyStop);
    }

    /// Cuts the arm's power.
    pub fn cut_power(&self) {
        self.shared.world().happen(&Happening::CutPower);
    }

    /// Sets fields of the reply to a command, for each time that it is accepted from now on: of a command that a pack adds, and
    /// of any other. Fields that are not set here are answered as usual.
    ///
    /// ```
    /// use jaka_sim::Controller;
    ///
    /// let controller = Controller::start()?;
    /// controller.set_reply("get_version", [("version".to_owned(), "1.7.2".into())]);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn set_reply(&self, command: impl Into<String>, fields: impl IntoIterator<Item = (String, Value)>) {
        self.shared.replies().insert(command.into(), fields.into_iter().collect());
    }

    /// Sets keys of status packets from now on: those that a pack adds, and any other but that of the packet's length. A key
    /// that the firmware does not send is sent by none of this. Keys that are not set here show the state.
    ///
    /// ```
    /// use jaka_sim::Controller;
    ///
    /// let controller = Controller::start()?;
    /// controller.set_status([("motion_mode".to_owned(), 2.into())]);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn set_status(&self, keys: impl IntoIterator<Item = (String, Value)>) {
        self.shared.status_values().extend(keys);
    }

    /// The text of the requests received so far, in order, the last 10,000 of them and of these the last 16 MiB.
    ///
    /// Also those that were refused; without bytes that have not even the outline of a request.
    pub fn requests(&self) -> Vec<String> {
        self.shared.request_log.texts()
    }

    /// Waits until `count` requests have been received since the start; false if there are fewer after `timeout`.
    ///
    /// The requests that it counts have been carried out.
    pub fn wait_for_requests(&self, count: usize, timeout: Duration) -> bool {
        self.shared.request_log.wait_for(count, timeout)
    }

    /// Where clients deviated from the recording, in a [replay](Builder::replay); empty if there was nothing.
    ///
    /// The connection of a client that has left may not have ended yet: [`wait_for_disconnect`](Self::wait_for_disconnect) waits for it.
    pub fn deviations(&self) -> Vec<Deviation> {
        self.shared.replay.as_ref().map(ReplaySession::deviations).unwrap_or_default()
    }

    /// Waits until there are `count` [`deviations`](Self::deviations) in all; false if there are not after `timeout`, or nothing
    /// is replayed.
    pub fn wait_for_deviations(&self, count: usize, timeout: Duration) -> bool {
        self.shared.replay.as_ref().is_some_and(|session| session.wait_for_deviations(count, timeout))
    }

    /// Sends unsolicited bytes to the command client.
    ///
    /// # Errors
    /// [`ErrorKind::NotConnected`] if there is no client, or what the socket reports.
    pub fn send(&self, bytes: &[u8]) -> io::Result<()> {
        self.shared.command_listener.wait_until_accepted();
        let connection = self.shared.active_client.connection().ok_or(ErrorKind::NotConnected)?;
        connection.writer().write(bytes)
    }

    /// Sends a status packet to all readers now.
    ///
    /// Returns when each has been sent its packet. A reader that has not read for a second is dropped. In a replay, which has its
    /// own packets, this does nothing.
    pub fn publish(&self) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.publish();
    }

    /// Sends bytes to all status readers, between two packets.
    pub fn send_status(&self, bytes: &[u8]) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.readers.send(bytes);
    }

    /// Closes the connections of the command client and of all status readers, whatever is wrong with their links. New ones are
    /// accepted.
    pub fn disconnect(&self) {
        self.wait_until_accepted();
        self.shared.active_client.close();
        self.shared.readers.close();
        self.shared.links.abort();
    }

    /// Waits until the controller has accepted every connection made before this call, on both ports.
    ///
    /// A client's `connect` returns as soon as the system has the connection. Only after this call has a new command
    /// client taken the port from the one before it. If the system has no socket left to wait with, only what has been
    /// accepted so far counts.
    pub fn wait_until_accepted(&self) {
        self.shared.command_listener.wait_until_accepted();
        self.shared.status_listener.wait_until_accepted();
    }

    /// Waits until no command client is connected; false if one still is after `timeout`.
    pub fn wait_for_disconnect(&self, timeout: Duration) -> bool {
        self.shared.active_client.wait_until_none(timeout)
    }
}

impl Builder {
    /// Starts the controller.
    ///
    /// # Errors
    /// A port cannot be opened, a thread cannot be started, a program or a pack cannot be read, or the
    /// [`time_scale`](Self::time_scale) is out of range.
    pub fn start(self) -> io::Result<Controller> {
        let shared = Arc::new(Shared::new(self)?);
        // If the second thread cannot be started, dropping this ends the first.
        let mut controller = Controller { shared, commands: None, status: None, is_lent: false };
        controller.commands = Some(controller.spawn(command_port::run)?);
        controller.status = Some(controller.spawn(status_port::run)?);
        controller.keep_time(&controller.shared.options.scheduled)?;
        Ok(controller)
    }
}

impl Drop for Controller {
    fn drop(&mut self) {
        if self.is_lent {
            return;
        }
        self.shared.triggers.close();
        close(&self.shared.command_listener, self.commands.take());
        close(&self.shared.status_listener, self.status.take());
        self.shared.links.abort();
    }
}

/// Closes a listener and waits for its thread.
fn close(listener: &Listener, thread: Option<JoinHandle<()>>) {
    // A thread that cannot be woken is left to itself, rather than waited for without end.
    if let (Ok(()), Some(thread)) = (listener.close(), thread) {
        // A panic there has been reported.
        drop(thread.join());
    }
}

impl fmt::Debug for Controller {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Controller")
            .field("command_addr", &self.command_addr())
            .field("status_addr", &self.status_addr())
            .finish_non_exhaustive()
    }
}

//! Running controller.

use std::fmt;
use std::io::{self, ErrorKind};
use std::net::SocketAddr;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::SimulatedClock;
use serde_json::Value;

use crate::link_selector::LinkSelector;
use crate::listener::Listener;
use crate::replay::ReplaySession;
use crate::shared::Shared;
use crate::trigger::{Condition, Trigger};
use crate::{
    Builder, Contact, Deviation, Direction, Fault, Happening, LinkFault, Port, Scheduled, State, StatusFault, clock,
    command_port, status_port,
};

/// Simulated controller that serves both of its ports until it is dropped.
///
/// Any number of controllers run side by side, each on its own ports. Dropping a controller closes all connections,
/// frees the ports and waits for the threads.
pub struct Controller {
    shared: Arc<Shared>,
    commands: Option<JoinHandle<()>>,
    status: Option<JoinHandle<()>>,
    /// Whether this is the handle of an action; dropping it does not end the controller.
    is_lent: bool,
}

impl Controller {
    /// Starts a controller with the default options.
    ///
    /// # Errors
    /// A port cannot be opened, or a thread cannot be started.
    pub fn start() -> io::Result<Self> {
        Self::builder().start()
    }

    /// Returns the options of a controller to start.
    pub fn builder() -> Builder {
        Builder::default()
    }

    fn spawn(&self, run: fn(&Arc<Shared>)) -> io::Result<JoinHandle<()>> {
        let shared = Arc::clone(&self.shared);
        thread::Builder::new().name("jaka-sim".to_owned()).spawn(move || run(&shared))
    }

    /// Returns the address for commands: port 10001 on a real controller.
    pub fn command_addr(&self) -> SocketAddr {
        self.shared.command_listener.address()
    }

    /// Returns the address for status packets: port 10000 on a real controller.
    pub fn status_addr(&self) -> SocketAddr {
        self.shared.status_listener.address()
    }

    /// Returns a copy of the present state.
    pub fn state(&self) -> State {
        self.shared.world().state.clone()
    }

    /// Changes the state beyond the effect of any command: powers the arm at once, or puts it into a protective stop.
    ///
    /// Conditions that the new state excludes end: enabling without power, servo mode and drag mode without enabling,
    /// servo mode in a protective stop. Requests wait while `change` runs, so `change` must not call the controller.
    pub fn set_state(&self, change: impl FnOnce(&mut State)) {
        let mut world = self.shared.world();
        change(&mut world.state);
        world.make_consistent();
    }

    /// Advances the time of a controller with a [stepped clock](Builder::stepped_clock): motions progress, delays pass,
    /// and the controller sends status packets. Time advances in controller cycles of 8 ms; the remainder counts for
    /// the next call.
    ///
    /// Has no effect on a controller with a real clock, or within an action of [`when`](Self::when).
    pub fn advance(&self, time: Duration) {
        if self.is_lent {
            return;
        }
        self.shared.status_listener.wait_until_accepted();
        self.shared.step(time);
    }

    /// Returns the simulated clock, if [given](Builder::clock).
    pub fn clock(&self) -> Option<&SimulatedClock> {
        self.shared.time().as_simulated()
    }

    /// Returns the controller's time since its start, in whole cycles.
    pub fn elapsed(&self) -> Duration {
        self.shared.world().now()
    }

    /// Schedules an event of the arm, of an input or of links for a time since the start of the controller, as in
    /// [`elapsed`](Self::elapsed). The event occurs in the first controller cycle that is not before that time, or at
    /// once if the time has passed.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the controller does not have the input; or a thread cannot start.
    pub fn at(&self, time: Duration, happening: impl Into<Happening>) -> io::Result<()> {
        let scheduled = Scheduled { happening: happening.into(), at: time };
        self.shared.world().schedule(scheduled)?;
        self.keep_time(&[scheduled])
    }

    /// Sets or removes the contact plane of the tool centre point, and resets the depth that the tool reached.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for an invalid plane: a normal of zero, a number that is not finite, a negative
    /// stiffness.
    pub fn set_contact(&self, contact: Option<Contact>) -> io::Result<()> {
        contact.as_ref().map_or(Ok(()), Contact::check)?;
        self.shared.world().set_contact(contact);
        Ok(())
    }

    /// Returns the greatest depth of the tool centre point below the plane of [`Builder::contact`] or
    /// [`set_contact`](Self::set_contact), in mm; 0 without a plane.
    ///
    /// The controller updates it in each cycle, until the plane is set again.
    pub fn deepest_penetration(&self) -> f64 {
        self.shared.world().deepest_penetration()
    }

    /// Simulates a collision: a protective stop and the error `0xf0034`, until `clear_error`.
    pub fn collide(&self) {
        self.shared.world().happen(&Happening::Collide);
    }

    /// Presses the emergency stop: the arm is disabled, and cannot be enabled until the release.
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

    /// Sets fields of all later replies to accepted commands of this name, from a pack or not. Other fields keep their
    /// usual values.
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

    /// Sets keys of all later status packets: those of a pack, and any other except the packet's length. The controller
    /// does not send a key that the firmware does not have. Keys that are not set show the state.
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

    /// Returns the text of the requests received so far, in order: the last 10,000, and of these the last 16 MiB.
    ///
    /// Includes refused requests; omits bytes without the outline of a request.
    pub fn requests(&self) -> Vec<String> {
        self.shared.request_log.texts()
    }

    /// Waits until `count` requests were received since the start; returns false if there are fewer after `timeout`.
    ///
    /// The controller has carried out the counted requests.
    pub fn wait_for_requests(&self, count: usize, timeout: Duration) -> bool {
        self.shared.request_log.wait_for(count, timeout)
    }

    /// Returns the deviations of clients from the recording of a [replay](Builder::replay); empty if there were none.
    ///
    /// The connection of a client that has left may still be open: [`wait_for_disconnect`](Self::wait_for_disconnect)
    /// waits for its end.
    pub fn deviations(&self) -> Vec<Deviation> {
        self.shared.replay.as_ref().map(ReplaySession::deviations).unwrap_or_default()
    }

    /// Waits until there are `count` [`deviations`](Self::deviations) in total; returns false if there are fewer after
    /// `timeout`, or without a replay.
    pub fn wait_for_deviations(&self, count: usize, timeout: Duration) -> bool {
        self.shared.replay.as_ref().is_some_and(|session| session.wait_for_deviations(count, timeout))
    }

    /// Sends unsolicited bytes to the command client.
    ///
    /// # Errors
    /// [`ErrorKind::NotConnected`] without a client, or the error of the socket.
    pub fn send(&self, bytes: &[u8]) -> io::Result<()> {
        self.shared.command_listener.wait_until_accepted();
        let connection = self.shared.active_client.connection().ok_or(ErrorKind::NotConnected)?;
        connection.writer().write(bytes)
    }

    /// Sends a status packet to all readers now.
    ///
    /// Returns after sending to each reader. The controller drops a reader that does not read for a second. Has no
    /// effect in a replay, which has its own packets.
    pub fn publish(&self) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.publish();
    }

    /// Sends bytes to all status readers, between two packets.
    pub fn send_status(&self, bytes: &[u8]) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.readers.send(bytes);
    }

    /// Closes the connections of the command client and of all status readers, regardless of link faults. The
    /// controller accepts new connections.
    pub fn disconnect(&self) {
        self.wait_until_accepted();
        self.shared.active_client.close();
        self.shared.readers.close();
        self.shared.links.abort();
    }

    /// Waits until the controller has accepted every connection made before this call, on both ports.
    ///
    /// A client's `connect` returns as soon as the operating system has the connection. Only after this call, a new
    /// command client has replaced the one before it. If the system has no socket left to wait with, this call covers
    /// only the connections accepted so far.
    pub fn wait_until_accepted(&self) {
        self.shared.command_listener.wait_until_accepted();
        self.shared.status_listener.wait_until_accepted();
    }

    /// Waits until no command client is connected; returns false if one is still connected after `timeout`.
    pub fn wait_for_disconnect(&self, timeout: Duration) -> bool {
        self.shared.active_client.wait_until_none(timeout)
    }

    /// Adds a fault to the queue; each reply takes the next fault from it.
    pub fn inject(&self, fault: Fault) {
        self.shared.faults().script.push_back(fault);
    }

    /// Assigns a fault to the next reply to this command, such as `joint_move`, without an assigned fault.
    ///
    /// That reply takes no fault from the queue of [`inject`](Self::inject).
    pub fn inject_for(&self, command: impl Into<String>, fault: Fault) {
        self.shared.faults().commands.push((command.into(), fault));
    }

    /// Applies a fault to all later replies without another fault; [`Fault::None`] ends it.
    pub fn inject_always(&self, fault: Fault) {
        self.shared.faults().inject_always(fault);
    }

    /// Removes all faults of later replies, also those of the [`FaultPlan`](crate::FaultPlan).
    ///
    /// Replies already held back stay so, and so do the faults of the status port and of the links.
    pub fn clear_faults(&self) {
        self.shared.faults().clear();
    }

    /// Sets the fault of all later status packets; [`StatusFault::None`] ends it.
    ///
    /// ```
    /// use jaka_sim::{Controller, StatusFault};
    ///
    /// let controller = Controller::start()?;
    /// controller.status_fault(StatusFault::Silent);
    /// // Here a monitor must say that it is blind.
    /// controller.status_fault(StatusFault::None);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn status_fault(&self, fault: StatusFault) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.readers.set_fault(fault);
    }

    /// Sends the replies held back by [`Fault::Hold`], if the client is still connected, and disconnects the other
    /// client of [`take_over`](Self::take_over) or [`Fault::Takeover`].
    pub fn release(&self) {
        if let Some(connection) = self.shared.active_client.connection() {
            // The replies of a lost connection are lost with it.
            connection.writer().release().ok();
        }
        self.shared.active_client.disconnect_other();
    }

    /// Connects another client to the command port and closes the connection of the present one.
    ///
    /// The other client stays until a further client replaces it, or, if the port refuses further clients
    /// ([`Takeover::Refuse`](crate::Takeover::Refuse)), until [`release`](Self::release).
    ///
    /// # Errors
    /// The other client cannot connect.
    pub fn take_over(&self) -> io::Result<()> {
        self.shared.command_listener.wait_until_accepted();
        self.shared.take_over()?;
        self.shared.command_listener.wait_until_accepted();
        Ok(())
    }

    /// Returns the links of a port, in both directions.
    pub fn link(&self, port: Port) -> Link<'_> {
        Link { controller: self, selector: LinkSelector { port: Some(port), direction: None } }
    }

    /// Returns the links of both ports, in both directions.
    pub fn links(&self) -> Link<'_> {
        Link { controller: self, selector: LinkSelector::default() }
    }

    /// Runs an action once, in its own thread, when the state first meets the condition, which may be now.
    ///
    /// The controller checks the condition in each cycle and after each change of the state. Requests wait meanwhile,
    /// so the condition must not call the controller. The action may call the controller, and the arm continues to move
    /// while it runs. With a [stepped clock](crate::Builder::stepped_clock), [`advance`](Self::advance) waits for the
    /// action, and has no effect within it.
    ///
    /// With a real clock the controller is late by as much as the machine is busy; with a stepped or a
    /// [simulated](crate::Builder::clock) one the action begins in the cycle in which the condition holds.
    ///
    /// Dropping the controller discards pending conditions, and waits for running actions.
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Happening, Level};
    ///
    /// let rises = Happening::Input(3, Level::High);
    /// let controller = Controller::builder().stepped_clock().at(Duration::from_secs(2), rises).start()?;
    /// let collision = controller.when(|state| state.digital_inputs[3], |controller| controller.collide())?;
    /// controller.advance(Duration::from_secs(3));
    /// assert_eq!(collision.fired_at(), Some(Duration::from_secs(2)));
    /// assert!(controller.state().protective_stop);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// A thread cannot start.
    pub fn when(
        &self,
        condition: impl FnMut(&State) -> bool + Send + 'static,
        action: impl FnOnce(&Self) + Send + 'static,
    ) -> io::Result<Trigger> {
        let trigger = Trigger::new(self.shared.time());
        let (shared, theirs) = (Arc::clone(&self.shared), trigger.clone());
        let thread = clock::spawn(self.shared.time(), "when", move || watch(&shared, &theirs, action))?;
        self.shared.triggers.add(&trigger, thread);
        self.shared.world().watch(Condition::new(condition, &trigger));
        Ok(trigger)
    }

    /// Starts a thread that applies scheduled link events on time if nobody calls the controller. A stepped clock needs
    /// no thread.
    pub(super) fn keep_time(&self, scheduled: &[Scheduled]) -> io::Result<()> {
        let is_of_links = |scheduled: &Scheduled| matches!(scheduled.happening, Happening::Link { .. });
        if self.shared.options.stepped || !scheduled.iter().any(is_of_links) {
            return Ok(());
        }
        let end = Trigger::new(self.shared.time());
        let (shared, theirs) = (Arc::clone(&self.shared), end.clone());
        let keep = move || while shared.until_next_due().is_some_and(|left| theirs.waits(left)) {};
        let thread = clock::spawn(self.shared.time(), "schedule", keep)?;
        self.shared.triggers.add(&end, thread);
        Ok(())
    }
}

impl Builder {
    /// Starts the controller.
    ///
    /// # Errors
    /// A port cannot be opened, a thread cannot start, a program or a pack cannot be read, or the
    /// [`time_scale`](Self::time_scale) is out of range.
    pub fn start(self) -> io::Result<Controller> {
        let shared = Arc::new(Shared::new(self)?);
        // If the second thread cannot start, dropping this ends the first.
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
    // Does not wait for a thread that cannot be woken.
    if let (Ok(()), Some(thread)) = (listener.close(), thread) {
        // The panic hook has reported a panic of the thread.
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

/// Links between a controller's ports and its clients, of one port or both, in one direction or both.
///
/// A fault applies to open and later connections, until another one is set. See [`LinkFault`] for the effect of each
/// fault.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sim::{Controller, Port};
///
/// let controller = Controller::start()?;
/// controller.links().hold(); // nothing passes any more
/// controller.links().release(); // all that has waited passes at once
/// controller.link(Port::Status).to_client().delay(Duration::from_millis(800));
/// controller.link(Port::Command).to_controller().cut();
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
#[must_use = "links stay as they are until something is set"]
pub struct Link<'c> {
    controller: &'c Controller,
    selector: LinkSelector,
}

impl Link<'_> {
    /// Selects one direction.
    pub fn direction(self, direction: Direction) -> Self {
        Self { selector: LinkSelector { direction: Some(direction), ..self.selector }, ..self }
    }

    /// Selects the direction to the client: replies and status packets.
    pub fn to_client(self) -> Self {
        self.direction(Direction::ToClient)
    }

    /// Selects the direction to the controller: requests.
    pub fn to_controller(self) -> Self {
        self.direction(Direction::ToController)
    }

    /// Sets the fault from now on: [`Happening::Link`].
    pub fn set(self, fault: LinkFault) {
        self.controller.shared.command_listener.wait_until_accepted();
        self.controller.shared.status_listener.wait_until_accepted();
        let LinkSelector { port, direction } = self.selector;
        self.controller.shared.world().happen(&Happening::Link { port, direction, fault });
    }

    /// Blocks all bytes: [`LinkFault::Hold`].
    pub fn hold(self) {
        self.set(LinkFault::Hold);
    }

    /// Delays each byte by this time: [`LinkFault::Delay`].
    pub fn delay(self, time: Duration) {
        self.set(LinkFault::Delay(time));
    }

    /// Limits the rate to this many bytes a second: [`LinkFault::Slow`]. Held bytes pass at this rate, too.
    pub fn slow(self, bytes_per_second: u64) {
        self.set(LinkFault::Slow(bytes_per_second));
    }

    /// Blocks all bytes for good on the present connections: [`LinkFault::Cut`].
    pub fn cut(self) {
        self.set(LinkFault::Cut);
    }

    /// Passes all bytes at once, including held ones: [`LinkFault::None`].
    pub fn release(self) {
        self.set(LinkFault::None);
    }
}

/// Waits until the condition holds, and then runs the action.
fn watch(shared: &Arc<Shared>, trigger: &Trigger, action: impl FnOnce(&Controller)) {
    while trigger.waits(shared.until_next_cycle()) {
        // Taking the world checks the condition.
        drop(shared.world());
    }
    let lent = Controller { shared: Arc::clone(shared), commands: None, status: None, is_lent: true };
    trigger.run(|| action(&lent));
}

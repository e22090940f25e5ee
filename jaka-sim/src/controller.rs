//! A running controller.

mod program_thread;

use std::fmt;
use std::io::{self, ErrorKind};
use std::net::SocketAddr;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::SimulatedClock;
use serde_json::Value;

use self::program_thread::ProgramThread;
use crate::link_selector::LinkSelector;
use crate::listener::Listener;
use crate::replay::ReplaySession;
use crate::shared::Shared;
use crate::trigger::{Condition, Trigger};
use crate::{
    Builder, Contact, Deviation, Direction, Fault, Happening, LinkFault, Port, Scheduled, State, StatusFault, clock,
    command_port, status_port,
};

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

    /// Address at which the controller takes commands: port 10001 of a real controller.
    pub fn command_addr(&self) -> SocketAddr {
        self.shared.command_listener.address()
    }

    /// Address at which the controller sends status packets: port 10000 of a real controller.
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

    /// Lets time go on, on a controller with a [stepped clock](Builder::stepped_clock): motions move, delays pass, and
    /// status packets go out on the way. Time goes on in controller cycles of 8 ms; what is less is kept for the next
    /// call.
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

    /// Has something happen to the arm, to an input or to links at a time of the controller since its start, which is
    /// that of [`elapsed`](Self::elapsed): in the first controller cycle that is not before it, or at once where it has
    /// passed.
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
    /// [`ErrorKind::InvalidInput`] if it is not a plane: a normal of zero, a number that is not finite, a negative
    /// stiffness.
    pub fn set_contact(&self, contact: Option<Contact>) -> io::Result<()> {
        contact.as_ref().map_or(Ok(()), Contact::check)?;
        self.shared.world().set_contact(contact);
        Ok(())
    }

    /// Greatest depth of the tool centre point below the plane of [`Builder::contact`] or
    /// [`set_contact`](Self::set_contact), in mm; 0 without one.
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

    /// Sets fields of the reply to a command, for each time that it is accepted from now on: of a command that a pack
    /// adds, and of any other. Fields that are not set here are answered as usual.
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

    /// Sets keys of status packets from now on: those that a pack adds, and any other but that of the packet's length.
    /// A key that the firmware does not send is sent by none of this. Keys that are not set here show the state.
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

    /// Deviations of clients from the recording, in a [replay](Builder::replay); empty if there were none.
    ///
    /// The connection of a client that has left may not have ended yet:
    /// [`wait_for_disconnect`](Self::wait_for_disconnect) waits for it.
    pub fn deviations(&self) -> Vec<Deviation> {
        self.shared.replay.as_ref().map(ReplaySession::deviations).unwrap_or_default()
    }

    /// Waits until there are `count` [`deviations`](Self::deviations) in all; false if there are not after `timeout`,
    /// or nothing is replayed.
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
    /// Returns when each has been sent its packet. A reader that has not read for a second is dropped. In a replay,
    /// which has its own packets, this does nothing.
    pub fn publish(&self) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.publish();
    }

    /// Sends bytes to all status readers, between two packets.
    pub fn send_status(&self, bytes: &[u8]) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.readers.send(bytes);
    }

    /// Closes the connections of the command client and of all status readers, whatever is wrong with their links. New
    /// ones are accepted.
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

    /// Puts a fault into the queue, from which each reply takes the next.
    pub fn inject(&self, fault: Fault) {
        self.shared.faults().script.push_back(fault);
    }

    /// Gives a fault to the next reply to this command, such as `joint_move`, that has none yet.
    ///
    /// That reply takes none from the queue of [`inject`](Self::inject).
    pub fn inject_for(&self, command: impl Into<String>, fault: Fault) {
        self.shared.faults().commands.push((command.into(), fault));
    }

    /// Gives a fault to all replies that have no other, from now on; [`Fault::None`] ends it.
    pub fn inject_always(&self, fault: Fault) {
        self.shared.faults().inject_always(fault);
    }

    /// Takes back all faults of replies to come, also those of the [`FaultPlan`](crate::FaultPlan).
    ///
    /// What is kept back already stays so, and so do the faults of the status port and of the links.
    pub fn clear_faults(&self) {
        self.shared.faults().clear();
    }

    /// Sets what is wrong with status packets from now on; [`StatusFault::None`] ends it.
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

    /// Sends the replies that are held back by [`Fault::Hold`], if the client is still connected, and has the other
    /// client of [`take_over`](Self::take_over) or [`Fault::Takeover`] leave.
    pub fn release(&self) {
        if let Some(connection) = self.shared.active_client.connection() {
            // A connection that is lost takes its replies with it.
            connection.writer().release().ok();
        }
        self.shared.active_client.disconnect_other();
    }

    /// Has another client take the command port: the connection of the present one is closed.
    ///
    /// The other client stays until a further client takes the port from it, or, if further clients are refused
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

    /// The links of a port, in both directions.
    pub fn link(&self, port: Port) -> Link<'_> {
        Link { controller: self, selector: LinkSelector { port: Some(port), direction: None } }
    }

    /// The links of both ports, in both directions.
    pub fn links(&self) -> Link<'_> {
        Link { controller: self, selector: LinkSelector::default() }
    }

    /// Runs a program in a thread of its own while this thread does something with the controller, and returns what the
    /// program returns when both have ended.
    ///
    /// The program may take `limit` after this thread is ready, in real time whatever the clock is; one that takes
    /// longer is left to itself. With a [simulated clock](crate::Builder::clock) both begin at the same time.
    ///
    /// ```
    /// use std::io::{Read, Write};
    /// use std::net::TcpStream;
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Fault};
    ///
    /// let controller = Controller::start()?;
    /// controller.inject(Fault::Hold);
    /// let limit = Duration::from_secs(60);
    /// let mut client = TcpStream::connect(controller.command_addr())?;
    /// let program = move || {
    ///     client.write_all(br#"{"cmdName": "get_version"}"#)?;
    ///     client.read(&mut [0; 200])
    /// };
    /// let read = controller.run_while(limit, program, |controller| {
    ///     assert!(controller.wait_for_requests(1, limit));
    ///     controller.release();
    /// });
    /// assert!(read?? > 0);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::TimedOut`] if the program takes longer; or a thread cannot be started.
    ///
    /// # Panics
    /// The program panics: with the same payload.
    pub fn run_while<T: Send + 'static>(
        &self,
        limit: Duration,
        program: impl FnOnce() -> T + Send + 'static,
        meanwhile: impl FnOnce(&Self),
    ) -> io::Result<T> {
        let time = self.shared.time();
        // This thread takes part in a simulated time before the program's does.
        let run = time.participating(|| {
            let thread = ProgramThread::spawn(time, program)?;
            meanwhile(self);
            time.outside(|| thread.join(limit))
        });
        run()
    }

    /// Does something once, in a thread of its own, when the state first is as the condition says, which may be now.
    ///
    /// The condition is asked in each controller cycle and after each change of the state. Requests wait meanwhile, so
    /// it must not call the controller. The action may do with the controller what its owner may, and take its time:
    /// the arm goes on, except that with a [stepped clock](crate::Builder::stepped_clock) [`advance`](Self::advance)
    /// waits for it, and does nothing within it.
    ///
    /// With a clock of its own the controller is late by as much as the machine is busy; with a stepped or a
    /// [simulated](crate::Builder::clock) one the action begins in the cycle in which the condition holds.
    ///
    /// Dropping the controller gives up what has not happened, and waits for actions that have begun.
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
    /// A thread cannot be started.
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

    /// Has links change at their times where nobody asks the controller for anything then; a stepped clock needs no
    /// thread for it.
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

/// The links between a controller's ports and its clients, of one port or both, in one direction or both.
///
/// What is set holds for the connections that are open and for those to come, until something else is set. See
/// [`LinkFault`] for what each does.
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
    /// In one direction alone.
    pub fn direction(self, direction: Direction) -> Self {
        Self { selector: LinkSelector { direction: Some(direction), ..self.selector }, ..self }
    }

    /// In the direction of what clients receive alone: replies and status packets.
    pub fn to_client(self) -> Self {
        self.direction(Direction::ToClient)
    }

    /// In the direction of what clients send alone: requests.
    pub fn to_controller(self) -> Self {
        self.direction(Direction::ToController)
    }

    /// Sets what is wrong from now on: [`Happening::Link`].
    pub fn set(self, fault: LinkFault) {
        self.controller.shared.command_listener.wait_until_accepted();
        self.controller.shared.status_listener.wait_until_accepted();
        let LinkSelector { port, direction } = self.selector;
        self.controller.shared.world().happen(&Happening::Link { port, direction, fault });
    }

    /// Lets nothing pass: [`LinkFault::Hold`].
    pub fn hold(self) {
        self.set(LinkFault::Hold);
    }

    /// Makes each byte arrive this much later: [`LinkFault::Delay`].
    pub fn delay(self, time: Duration) {
        self.set(LinkFault::Delay(time));
    }

    /// Lets this many bytes a second pass: [`LinkFault::Slow`]. Bytes that were held pass at this rate, too.
    pub fn slow(self, bytes_per_second: u64) {
        self.set(LinkFault::Slow(bytes_per_second));
    }

    /// Lets nothing pass ever again on the connections that there are: [`LinkFault::Cut`].
    pub fn cut(self) {
        self.set(LinkFault::Cut);
    }

    /// Lets everything pass at once, also what has been held: [`LinkFault::None`].
    pub fn release(self) {
        self.set(LinkFault::None);
    }
}

/// Waits until the condition holds, and then acts.
fn watch(shared: &Arc<Shared>, trigger: &Trigger, action: impl FnOnce(&Controller)) {
    while trigger.waits(shared.until_next_cycle()) {
        // The condition is asked on the way.
        drop(shared.world());
    }
    let lent = Controller { shared: Arc::clone(shared), commands: None, status: None, is_lent: true };
    trigger.run(|| action(&lent));
}

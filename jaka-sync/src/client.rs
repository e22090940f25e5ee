//! The client.

use std::borrow::Cow;
use std::fmt::Display;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::check::{InvalidArgument, Rules};
use jaka_proto::exchange::{Owner, ReadReply, TextOnly, TypedReply};
use jaka_proto::messages::power::GetVersion;
use jaka_proto::recording::Port;
use jaka_proto::wire::{Decode, DecodeError, Fields, Reader, Writer};
use jaka_proto::{Command, CommandInfo, Envelope, FirmwareVersion, Role};
use serde_json::Value;

use crate::link::{Dispatched, Gate, Handle, Link, OPEN, Outgoing, SendError, UnderWay, Written, unexpected};
use crate::{Config, Disconnect, Error, ErrorKind, StopHandle, connection};

/// A connection to a controller's command port.
///
/// Each method sends one command and waits for its reply. A command that the controller refuses is an error, with the
/// controller's code and message. A motion that was accepted has only begun.
///
/// The command port serves one client. Dropping the client closes the connection, even if stop handles still exist, and
/// leaves the robot as it is: motions that were accepted go on, and can only be stopped through a new connection.
///
/// ```no_run
/// use jaka_sync::Client;
///
/// let mut robot = Client::connect("10.5.5.100")?;
/// let position = robot.get_joint_pos()?.joint_position;
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[derive(Debug)]
#[must_use = "dropping a client closes its connection"]
pub struct Client {
    pub(crate) link: Arc<Link>,
    config: Config,
    reply: String,
    pub(crate) handle: Handle,
    /// True if its drop closes the connection.
    owns_link: bool,
}

impl Client {
    /// Connects to a controller: `10.5.5.100`, `robot.local`, `10.5.5.100:10001`, or a socket address.
    ///
    /// # Errors
    /// [`ErrorKind::Connect`] if no controller answers there within the connect timeout.
    pub fn connect(address: impl Display) -> Result<Self, Error> {
        Self::connect_with(&Config::new(), address)
    }

    /// Connects to a controller by a configuration.
    ///
    /// # Errors
    /// As [`connect`](Self::connect).
    pub fn connect_with(config: &Config, address: impl Display) -> Result<Self, Error> {
        let (stream, tap) = connection::connect(&address.to_string(), Port::Command, config)?;
        let link = Arc::new(Link::new(stream, tap, config));
        Ok(Self { link, config: config.clone(), reply: String::new(), handle: Handle::FIRST, owns_link: true })
    }

    /// Returns another handle of the same connection, for another thread or for use beside a
    /// [`Pipeline`](crate::Pipeline).
    ///
    /// A connection sends one request at a time: a handle that sends much delays the others until the network has taken
    /// its data. Each reply reaches the handle that sent the request. The first client owns the connection: dropping it
    /// closes the connection for all handles, whose calls then fail. Dropping another handle closes nothing.
    ///
    /// Controllers refuse a command that they do not have without its name. So that such a refusal finds its call, one
    /// command at a time is outstanding that the controller has not answered by name on this connection. Another one
    /// waits within its deadline, and then fails with [`ErrorKind::NotSentInTime`]. A stop does not wait.
    ///
    /// While a servo session, a stream or a trajectory of jaka-robot moves the arm, other handles can send only
    /// outputs, short queries, the end of servo mode and stops. Every other command fails with
    /// [`ErrorKind::KeptBack`]. Of outputs and queries, at most 8 are outstanding then, and the next one waits within
    /// its deadline. After a stop by any handle of a robot's connection, no typed motion goes out:
    /// [`StopHandle::stop`] says for how long.
    ///
    /// ```no_run
    /// use jaka_sync::Client;
    ///
    /// let mut robot = Client::connect("10.5.5.100")?;
    /// let mut other = robot.try_clone()?;
    /// let watching = std::thread::spawn(move || other.get_robot_state());
    /// println!("{:?}", robot.get_joint_pos()?);
    /// println!("{:?}", watching.join().expect("it does not panic")?);
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::Disconnected`] if the connection is broken.
    pub fn try_clone(&self) -> Result<Self, Error> {
        self.link.check_open("try_clone")?;
        Ok(self.lent_as(self.link.new_handle()))
    }

    fn lent_as(&self, handle: Handle) -> Self {
        Self {
            link: Arc::clone(&self.link),
            config: self.config.clone(),
            reply: String::new(),
            handle,
            owns_link: false,
        }
    }

    /// Sends a command and waits for its reply.
    ///
    /// # Errors
    /// - [`InvalidArgument`](ErrorKind::InvalidArgument): the spec forbids a field; nothing was sent.
    /// - [`NotInFirmware`](ErrorKind::NotInFirmware): the firmware does not have the command or a field, which is known
    ///   after [`check_firmware`](Self::check_firmware); nothing was sent.
    /// - [`Refused`](ErrorKind::Refused): the controller refused; the command did not run.
    /// - [`Timeout`](ErrorKind::Timeout), [`ReplyLost`](ErrorKind::ReplyLost): the command may have run.
    /// - [`UnexpectedReply`](ErrorKind::UnexpectedReply): accepted, but the reply does not fit the spec.
    /// - [`Disconnected`](ErrorKind::Disconnected): the connection is broken for good.
    pub fn call<C: Command>(&mut self, command: &C) -> Result<C::Reply, Error> {
        self.call_within(command, self.timeout_of(C::INFO))
    }

    /// Sends a command and waits for its reply for at most `timeout`, regardless of the spec and the configuration.
    ///
    /// # Errors
    /// As [`call`](Self::call).
    pub fn call_within<C: Command>(&mut self, command: &C, timeout: Duration) -> Result<C::Reply, Error> {
        Ok(self.call_through(OPEN, command, timeout)?)
    }

    /// Sends a request and waits for its reply, of type `A`.
    ///
    /// Generic over the reply type only, which many commands share.
    fn call_as<A: Fields, R>(
        &mut self,
        (info, role): (&'static CommandInfo, Option<Role>),
        gate: Gate<'_, R>,
        timeout: Duration,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<A, SendError<R>> {
        let mut reader = TypedReply::new(info);
        match self.exchange((info, role), gate, timeout, write, &mut reader) {
            Ok(()) => Ok(reader.take(&self.reply).map_err(|source| self.link.attach(unexpected(info.name, source)))?),
            Err(SendError::Failed(error)) if is_success_without_reply(info, &error) => {
                Ok(A::without_fields().ok_or(error)?)
            }
            Err(error) => Err(error),
        }
    }

    /// Sends a request and waits until `reader` has read its reply. Generic over the reason of the gate only: a copy
    /// for each type of reply would make up most of this crate's compile time.
    fn exchange<R>(
        &mut self,
        (info, role): (&'static CommandInfo, Option<Role>),
        gate: Gate<'_, R>,
        timeout: Duration,
        write: &mut dyn FnMut(&mut Writer),
        reader: &mut dyn ReadReply,
    ) -> Result<(), SendError<R>> {
        let outgoing = Outgoing::of(&self.link.clock, info, timeout).of_handle(self.handle);
        self.link.call(outgoing.in_role(role), gate, write, &mut self.reply, reader)?;
        if info.ends_session {
            self.link.end(info);
        }
        Ok(())
    }

    /// Rules for the check of commands, apart from the spec.
    fn rules(&self) -> Rules {
        Rules { ranges: self.config.advisory_ranges, firmware: self.link.firmware() }
    }

    /// Sends the first of the checked commands in one write: at least one of them, and only ones of one role.
    pub(crate) fn post_some<C: Command, R>(
        &self,
        owner: Owner,
        gate: Gate<'_, R>,
        commands: &[C],
    ) -> Result<Dispatched, SendError<R>> {
        let role = commands.first().and_then(C::role);
        let count = commands.iter().take_while(|command| command.role() == role).count();
        let outgoing = Outgoing::of(&self.link.clock, C::INFO, self.config.reply_timeout).of_handle(self.handle);
        let outgoing = outgoing.posted_for(owner).in_role(role);
        let (outgoing, stop) = self.link.begun(outgoing);
        let sent = self.link.transmit(&outgoing, gate, count, &mut |index, out| commands[index].write_request(out));
        sent.inspect_err(|_| stop.iter().for_each(UnderWay::failed))
    }

    /// Checks commands against the spec and the firmware.
    pub(crate) fn check<C: Command>(&self, commands: &[C]) -> Result<(), Error> {
        Ok(commands.iter().try_for_each(|command| command.check(self.rules()))?)
    }

    /// Reads the controller's version once (`get_version`, 4.51). From then on the client refuses commands and fields
    /// that, according to the spec, this firmware does not have. All handles of the connection share the firmware.
    ///
    /// By default, firmware is not checked. Raw calls and stop handles are never checked.
    ///
    /// ```no_run
    /// # let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
    /// let firmware = robot.check_firmware()?;
    /// println!("firmware {firmware}");
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`call`](Self::call); [`UnexpectedReply`](ErrorKind::UnexpectedReply) with the controller's text if that is
    /// not a version. The checks then stay as they were.
    pub fn check_firmware(&mut self) -> Result<FirmwareVersion, Error> {
        let text = self.call(&GetVersion::new())?.version;
        let unfit = || DecodeError::unfit("a firmware version such as 1.6.5_01_X86", &text).in_field("version");
        let no_version = |_| self.link.attach(unexpected(GetVersion::INFO.name, unfit()));
        let firmware = text.parse().map_err(no_version)?;
        self.link.set_firmware(Some(firmware));
        Ok(firmware)
    }

    /// Sets the firmware that requests are checked against, for all handles of the connection, without asking the
    /// controller; `None` turns these checks off.
    pub fn set_firmware(&mut self, firmware: Option<FirmwareVersion>) {
        self.link.set_firmware(firmware);
    }

    /// Firmware that requests are checked against, if any.
    pub fn firmware(&self) -> Option<FirmwareVersion> {
        self.link.firmware()
    }

    /// Sends a command that is not in the spec, and returns the whole reply as JSON.
    ///
    /// `parameters` is a JSON object with the fields other than `cmdName`, or null for none. They are sent unchecked.
    ///
    /// ```no_run
    /// # let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
    /// let reply = robot.call_raw("demo_motion_state", &serde_json::json!({}))?;
    /// println!("{}", reply["queue"]);
    /// # Ok::<(), jaka_sync::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`call`](Self::call); [`InvalidArgument`](ErrorKind::InvalidArgument) if `parameters` is another JSON value
    /// or has a `cmdName`; [`UnexpectedReply`](ErrorKind::UnexpectedReply) if the reply is accepted but is not JSON
    /// throughout, or has a key twice.
    pub fn call_raw(&mut self, command: &str, parameters: &Value) -> Result<Value, Error> {
        let request = raw_request(command, parameters)?;
        let outgoing = Outgoing::named(
            &self.link.clock,
            command,
            Cow::Owned(command.trim().to_owned()),
            self.config.reply_timeout,
        )
        .of_handle(self.handle);
        self.link.call(outgoing, OPEN, &mut |out| out.raw(&request), &mut self.reply, &mut TextOnly)?;
        let mut reader = Reader::new(&self.reply);
        let found = Value::decode(&mut reader).and_then(|value| reader.end().map(|()| value));
        found.map_err(|source| self.link.attach(unexpected(command, source)))
    }

    /// Sends a request unchanged, byte for byte, and returns the text of its reply, with `\udcNN` for each byte that is
    /// not UTF-8.
    ///
    /// `request` is a JSON object with a `cmdName`; nothing else is checked. For programs that write requests without
    /// this crate's types, such as a command line or the replay of a log.
    ///
    /// # Errors
    /// As [`call`](Self::call); [`InvalidArgument`](ErrorKind::InvalidArgument) if `request` is not a JSON object or
    /// has no `cmdName`.
    pub fn call_text(&mut self, request: &str, timeout: Duration) -> Result<&str, Error> {
        let envelope = Envelope::read(request);
        let command = envelope.as_ref().ok().and_then(|envelope| envelope.command.as_deref());
        let Some(command) = command.filter(|command| !command.is_empty()) else {
            let excerpt: String = request.chars().take(80).collect();
            return Err(InvalidArgument::new("call_text", "request", excerpt, "a JSON object with `cmdName`").into());
        };
        let name = Cow::Owned(command.to_owned());
        let outgoing = Outgoing::named(&self.link.clock, command, name, timeout).of_handle(self.handle);
        self.link.call(outgoing, OPEN, &mut |out| out.raw(request), &mut self.reply, &mut TextOnly)?;
        Ok(&self.reply)
    }

    /// Text of the last reply as it was received, even if it was a refusal or does not fit the spec; with `\udcNN` for
    /// each byte that is not UTF-8.
    pub fn last_reply(&self) -> Option<&str> {
        (!self.reply.is_empty()).then_some(&*self.reply)
    }

    /// Timeout for a reply, unless the spec gives the command a longer time: see
    /// [`Config::reply_timeout`](Config::reply_timeout).
    pub fn reply_timeout(&self) -> Duration {
        self.config.reply_timeout
    }

    /// Returns the cause that broke the connection, if one did. Detects also an end by the controller that no call has
    /// noticed yet.
    pub fn disconnect_cause(&self) -> Option<Arc<Disconnect>> {
        self.link.lost()
    }

    /// Returns a handle that stops the running motion or program from another thread, even while a call waits.
    pub fn stop_handle(&self) -> StopHandle {
        StopHandle::new(Arc::clone(&self.link), self.config.reply_timeout)
    }

    /// Address of the controller.
    ///
    /// # Errors
    /// The connection is closed.
    pub fn peer_addr(&self) -> io::Result<SocketAddr> {
        self.link.peer_addr()
    }
}

/// Parts of a [`Client`].
pub trait ClientParts: Sized {
    /// Connection of the client.
    fn link(&self) -> &Arc<Link>;

    /// Handle of the connection, by which the client sends.
    fn handle(&self) -> Handle;

    /// Another client of the same connection, for a thread that this one outlives.
    #[must_use]
    fn lent(&self) -> Self;

    /// Timeout for the reply to a command.
    fn timeout_of(&self, info: &CommandInfo) -> Duration;

    /// Sends a command unless the gate keeps it back, and waits for its reply.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn call_through<C: Command, R>(
        &mut self,
        gate: Gate<'_, R>,
        command: &C,
        timeout: Duration,
    ) -> Result<C::Reply, SendError<R>>;

    /// Sends a request of any type unless the gate keeps it back, and returns once it is accepted. Fields of the reply
    /// are not read.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn call_written<R>(
        &mut self,
        gate: Gate<'_, R>,
        request: (&'static CommandInfo, &dyn Written),
        timeout: Duration,
    ) -> Result<(), SendError<R>>;

    /// Sends commands without waiting for their replies, which are counted for their owner, and returns the number of
    /// its outstanding ones.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn post<C: Command, R>(&self, owner: Owner, gate: Gate<'_, R>, commands: &[C]) -> Result<usize, SendError<R>>;
}

impl ClientParts for Client {
    fn link(&self) -> &Arc<Link> {
        &self.link
    }

    fn handle(&self) -> Handle {
        self.handle
    }

    fn lent(&self) -> Self {
        self.lent_as(self.handle)
    }

    fn timeout_of(&self, info: &CommandInfo) -> Duration {
        info.deadline.unwrap_or_default().max(self.config.reply_timeout)
    }

    fn call_through<C: Command, R>(
        &mut self,
        gate: Gate<'_, R>,
        command: &C,
        timeout: Duration,
    ) -> Result<C::Reply, SendError<R>> {
        command.check(self.rules()).map_err(Error::from)?;
        self.call_as((C::INFO, command.role()), gate, timeout, &mut |out| command.write_request(out))
    }

    fn call_written<R>(
        &mut self,
        gate: Gate<'_, R>,
        (info, request): (&'static CommandInfo, &dyn Written),
        timeout: Duration,
    ) -> Result<(), SendError<R>> {
        request.check(self.rules()).map_err(Error::from)?;
        self.call_as((info, info.role), gate, timeout, &mut |out| request.write(out))
    }

    fn post<C: Command, R>(&self, owner: Owner, gate: Gate<'_, R>, commands: &[C]) -> Result<usize, SendError<R>> {
        self.check(commands)?;
        let (mut rest, mut outstanding) = (commands, 0);
        while !rest.is_empty() {
            let posting = self.post_some(owner, gate, rest)?;
            (rest, outstanding) = (&rest[posting.sent..], posting.outstanding);
        }
        Ok(outstanding)
    }
}

/// Closes the connection, so that the controller can serve another client. Stop handles then fail with this reason.
impl Drop for Client {
    fn drop(&mut self) {
        if self.owns_link {
            self.link.close();
        }
    }
}

/// True if the controller closed the connection, and may do so instead of replying when it carries out this command.
fn is_success_without_reply(info: &CommandInfo, error: &Error) -> bool {
    let ErrorKind::Disconnected { sent: true, cause, .. } = error.kind() else { return false };
    !info.reply_certain && matches!(**cause, Disconnect::Closed { .. } | Disconnect::Read(_))
}

fn raw_request(command: &str, parameters: &Value) -> Result<String, InvalidArgument> {
    let invalid =
        |field: &str, value: &Value, allowed: &str| InvalidArgument::new(command, field, value.to_string(), allowed);
    let mut request = format!("{{\"cmdName\":{}", Value::from(command));
    match parameters {
        Value::Null => {}
        Value::Object(fields) if fields.contains_key("cmdName") => {
            return Err(invalid("cmdName", &fields["cmdName"], "only given as the first argument"));
        }
        Value::Object(fields) => {
            for (key, value) in fields {
                request = format!("{request},{}:{value}", Value::from(key.as_str()));
            }
        }
        other => return Err(invalid("parameters", other, "a JSON object or null")),
    }
    Ok(request + "}")
}

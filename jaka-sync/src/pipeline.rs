//! Commands that are sent without a wait for each reply.

use std::collections::VecDeque;

use jaka_proto::exchange::Owner;
use jaka_proto::{Command, Role};

#[cfg(doc)]
use crate::ErrorKind;
use crate::link::{MOST_OUTSTANDING, OPEN};
use crate::{Client, Error};

/// Sends commands without waiting for the reply to each, from [`Client::pipeline`].
///
/// A pipeline serves many settings at once, such as outputs and variables, and set-points at the cycle of the program.
/// The controller processes the commands in order and replies to each. The replies are counted; up to a window of
/// commands is outstanding at once.
///
/// The first command of a name goes out alone, unless this connection has seen one answered: a controller that does not
/// have it refuses it without its name.
///
/// Counts and failures are those of this pipeline's commands alone, whatever other handles send. A refusal is noticed
/// late: up to a window of later commands have been sent by then, and may have run. If a command must not be sent
/// unless the previous one was accepted, call them one by one.
///
/// A stop is sent between the commands. One that the pipeline itself sends waits for no room in the window, and is sent
/// also if an earlier command has failed. The controller first processes the outstanding ones, so at most 256 commands
/// are outstanding, including those of dropped pipelines.
///
/// Dropping the pipeline gives up the outstanding replies; [`finish`](Self::finish) waits for them.
///
/// ```no_run
/// use jaka_sync::Client;
/// use jaka_sync::io::SetDigitalOutput;
/// use jaka_sync::types::Switch;
///
/// let mut robot = Client::connect("10.5.5.100")?;
/// let off = |index| SetDigitalOutput::cabinet(index, Switch::Off);
/// let mut pipeline = robot.pipeline(8);
/// for index in 0..16 {
///     pipeline.send(&off(index))?;
/// }
/// let accepted = pipeline.finish()?;
/// assert_eq!(accepted, 16);
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[derive(Debug)]
#[must_use = "dropping a pipeline gives up its outstanding replies; `finish` waits for them"]
pub struct Pipeline<'c> {
    client: &'c mut Client,
    owner: Owner,
    window: usize,
    outstanding: usize,
    sent: u64,
    accepted: u64,
    /// Failures that have not been reported yet.
    failed: VecDeque<Error>,
}

impl Client {
    /// Sends commands without waiting for the reply to each. Up to `window` of them are outstanding at once; `window`
    /// is limited to the range from 1 to 256.
    pub fn pipeline(&mut self, window: usize) -> Pipeline<'_> {
        Pipeline::new(self, window)
    }
}

impl<'c> Pipeline<'c> {
    fn new(client: &'c mut Client, window: usize) -> Self {
        Self {
            owner: client.link.new_owner(),
            client,
            window: window.clamp(1, MOST_OUTSTANDING),
            outstanding: 0,
            sent: 0,
            accepted: 0,
            failed: VecDeque::new(),
        }
    }

    /// Sends a command. If the window is full, first waits until half of it has been answered.
    ///
    /// # Errors
    /// - [`InvalidArgument`](ErrorKind::InvalidArgument), [`NotInFirmware`](ErrorKind::NotInFirmware): as
    ///   [`Client::call`].
    /// - [`Refused`](ErrorKind::Refused), [`Timeout`](ErrorKind::Timeout), [`ReplyLost`](ErrorKind::ReplyLost),
    ///   [`UnexpectedReply`](ErrorKind::UnexpectedReply): the outcome of an earlier command, which the error names.
    ///   Each is reported once.
    /// - [`Disconnected`](ErrorKind::Disconnected): the connection is broken for good; outstanding commands may have
    ///   run.
    /// - [`NotSentInTime`](ErrorKind::NotSentInTime): the controller accepted or answered too little in time for this
    ///   command to be sent.
    ///
    /// After an error, this command was not sent, unless the error is `Disconnected` and says so.
    pub fn send<C: Command<Reply = ()>>(&mut self, command: &C) -> Result<(), Error> {
        self.send_all(std::slice::from_ref(command))
    }

    /// Sends commands, several in one write if the window has room for them. If it is full, waits as
    /// [`send`](Self::send) does.
    ///
    /// # Errors
    /// As [`send`](Self::send); [`sent`](Self::sent) is the number of commands that were sent. If one of the commands
    /// is an [`InvalidArgument`](ErrorKind::InvalidArgument), none of them was sent.
    pub fn send_all<C: Command<Reply = ()>>(&mut self, commands: &[C]) -> Result<(), Error> {
        self.client.check(commands)?;
        let mut rest = commands;
        while !rest.is_empty() {
            // A stop waits for nothing.
            let room = if rest[0].role() == Some(Role::Stop) { 1 } else { self.wait_for_room(C::INFO.name)? };
            let (now, later) = rest.split_at(rest.len().min(room));
            self.send_checked(now)?;
            rest = later;
        }
        Ok(())
    }

    /// Waits until there is room for at least one command, and returns the number of commands that fit.
    fn wait_for_room(&mut self, command: &str) -> Result<usize, Error> {
        // Also takes the outcomes that other threads have read.
        self.wait(if self.outstanding >= self.window { self.window / 2 } else { self.window })?;
        if let Some(error) = self.failed.pop_front() {
            return Err(error);
        }
        let room = self.client.link.wait_for_room(command, self.client.reply_timeout())?;
        Ok(room.min(self.window - self.outstanding).max(1))
    }

    fn send_checked<C: Command>(&mut self, commands: &[C]) -> Result<(), Error> {
        let mut rest = commands;
        while !rest.is_empty() {
            let posting = self.client.post_some(self.owner, OPEN, rest)?;
            self.outstanding = posting.outstanding;
            self.sent += posting.sent as u64;
            rest = &rest[posting.sent..];
        }
        Ok(())
    }

    /// Number of commands sent.
    pub fn sent(&self) -> u64 {
        self.sent
    }

    /// Number of commands sent whose replies have not been processed.
    pub fn outstanding(&self) -> usize {
        self.outstanding
    }

    /// Number of commands accepted so far, by the replies that have been processed.
    pub fn accepted(&self) -> u64 {
        self.accepted
    }

    /// Waits for the outstanding replies, each for the reply timeout since its command was sent, and returns the total
    /// number of accepted commands.
    ///
    /// # Errors
    /// As [`send`](Self::send), for the first failure that has not been reported.
    pub fn finish(mut self) -> Result<u64, Error> {
        let waited = self.wait(0);
        self.failed.pop_front().map_or(waited, Err)?;
        Ok(self.accepted)
    }

    fn wait(&mut self, most: usize) -> Result<(), Error> {
        let (answers, outstanding, checked) =
            self.client.link.wait_for_posted(self.owner, most, self.client.reply_timeout());
        self.accepted += answers.accepted;
        self.failed.extend(answers.failed);
        self.outstanding = outstanding;
        checked
    }
}

impl Drop for Pipeline<'_> {
    fn drop(&mut self) {
        // Only `finish` reports the outcomes of the others.
        drop(self.client.link.forget_posted(self.owner));
    }
}

//! Who may receive what: the simplest account of an exchange, which also knows whose each reply really is.

use std::collections::VecDeque;
use std::fmt;

use jaka_sync::Command;
use jaka_sync::program::StopProgram;

/// What stop handles send: the one name of which several commands can be waited for.
pub(crate) const STOP: &str = StopProgram::INFO.name;

/// Who waits for replies: the client's own thread, and threads with stop handles.
pub(crate) type Actor = usize;

/// What a call ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Got {
    /// The reply that the server wrote for the command with this number.
    Reply(u32),
    Timeout,
    /// The deadline passed before anything was sent.
    NotSentInTime,
    Lost,
    /// The connection broke while the call waited.
    Broken,
    /// The connection was broken before, and nothing was sent.
    NotSent,
}

/// What the server writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Message {
    /// A reply, with the number of the command that it is for, under its name.
    Reply {
        name: &'static str,
        number: u32,
    },
    /// A copy of it, or a reply to nothing.
    Surplus {
        name: &'static str,
        number: u32,
    },
    /// A refusal that names no command.
    Nameless {
        number: u32,
    },
    Garbage,
    /// The end of the connection.
    End,
}

/// A command that has not been answered.
#[derive(Debug, Clone)]
struct Outstanding {
    number: u32,
    name: &'static str,
    actor: Actor,
    waits: bool,
    /// A reply that completed an older command of the name may have been this one's.
    doubtful: bool,
}

/// The exchange as it should be.
#[derive(Debug, Clone, Default)]
pub(crate) struct Model {
    outstanding: Vec<Outstanding>,
    /// What the client has read and not looked at, and what it has not read.
    read: VecDeque<Message>,
    unread: VecDeque<Message>,
    pub(crate) is_broken: bool,
    /// What calls have ended with and the test has not asked for yet.
    pub(crate) ended: Vec<(Actor, Got)>,
    /// How many replies came too late.
    pub(crate) dropped: u32,
    /// A surplus reply was taken for a request's own.
    is_mistaken: bool,
    /// A reply was lost of a name of which several commands may be waited for.
    is_mistakable: bool,
}

impl Model {
    pub(crate) fn is_waited_for(&self) -> bool {
        self.outstanding.iter().any(|request| request.waits)
    }

    pub(crate) fn waits(&self, actor: Actor) -> bool {
        self.outstanding.iter().any(|request| request.waits && request.actor == actor)
    }

    /// True if something has come that was not read.
    pub(crate) fn has_more(&self) -> bool {
        !self.unread.is_empty() || !self.read.is_empty()
    }

    /// A call begins. False if nothing must be sent.
    pub(crate) fn send(&mut self, actor: Actor, name: &'static str, number: u32) -> bool {
        let is_sent = self.send_only(actor, name, number);
        self.look();
        is_sent
    }

    /// The same, before what has come is read.
    pub(crate) fn send_only(&mut self, actor: Actor, name: &'static str, number: u32) -> bool {
        if !self.send_nothing(actor) {
            return false;
        }
        let doubtful = self.outstanding.iter().any(|request| request.doubtful && request.name == name);
        self.outstanding.push(Outstanding { number, name, actor, waits: true, doubtful });
        true
    }

    /// A call begins, and its command does not go out yet. False if the connection is broken.
    pub(crate) fn send_nothing(&mut self, actor: Actor) -> bool {
        // What has been read before a command goes out is not a reply to it.
        while let Some(message) = self.read.pop_front() {
            self.arrive(message);
        }
        if self.is_broken {
            self.ended.push((actor, Got::NotSent));
        }
        !self.is_broken
    }

    /// The server writes, at once.
    pub(crate) fn write(&mut self, messages: &[Message]) {
        self.unread.extend(messages);
        self.look();
    }

    /// A reply is lost.
    pub(crate) fn lose(&mut self, name: &str) {
        self.is_mistakable |= name == STOP;
    }

    /// A deadline passes.
    pub(crate) fn give_up(&mut self, actor: Actor) {
        let Some(request) = self.outstanding.iter_mut().find(|request| request.waits && request.actor == actor) else {
            return;
        };
        if request.doubtful {
            self.break_off();
        } else {
            request.waits = false;
            self.ended.push((actor, Got::Timeout));
        }
    }

    /// While somebody waits, everything is looked at that has been read, and then all is read that has come.
    fn look(&mut self) {
        while self.is_waited_for() {
            if self.read.is_empty() {
                // The end is found by a read of its own.
                let end = self.unread.iter().position(|message| *message == Message::End);
                let count = end.map_or(self.unread.len(), |place| place.max(1));
                self.read.extend(self.unread.drain(..count));
            }
            let Some(message) = self.read.pop_front() else { break };
            self.arrive(message);
        }
    }

    fn arrive(&mut self, message: Message) {
        let place = match message {
            Message::Reply { name, .. } | Message::Surplus { name, .. } => {
                self.outstanding.iter().position(|request| request.name == name)
            }
            Message::Nameless { .. } => (self.outstanding.len() == 1).then_some(0),
            Message::Garbage | Message::End => None,
        };
        let (Some(place), Some((number, is_surplus))) = (place, message.number()) else {
            return self.break_off();
        };
        for lost in self.outstanding.drain(..place).filter(|request| request.waits) {
            self.ended.push((lost.actor, Got::Lost));
        }
        let taker = self.outstanding.remove(0);
        self.is_mistaken |= is_surplus;
        if taker.waits {
            let own = taker.number == number;
            assert!(own || self.is_mistaken || self.is_mistakable, "{message:?} is given to {taker:?}");
            self.ended.push((taker.actor, Got::Reply(number)));
            return;
        }
        self.dropped += 1;
        for request in self.outstanding.iter_mut().filter(|request| request.name == taker.name) {
            request.doubtful = true;
        }
    }

    fn break_off(&mut self) {
        self.is_broken = true;
        self.ended.extend(
            self.outstanding.drain(..).filter(|request| request.waits).map(|request| (request.actor, Got::Broken)),
        );
        self.read.clear();
        self.unread.clear();
    }
}

impl Message {
    /// The number of a reply, and whether it is surplus.
    fn number(self) -> Option<(u32, bool)> {
        match self {
            Self::Reply { number, .. } | Self::Nameless { number } => Some((number, false)),
            Self::Surplus { number, .. } => Some((number, true)),
            Self::Garbage | Self::End => None,
        }
    }
}

/// As the server writes it. The number of a stop's reply is its code, since a stop shows no more of it.
impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reply { name, number } | Self::Surplus { name, number } if *name == STOP => {
                write!(f, r#"{{"errorCode": "{number}", "errorMsg": "", "cmdName": "{name}"}}"#)
            }
            Self::Reply { name, number } | Self::Surplus { name, number } => {
                write!(f, r#"{{"errorCode": "0", "errorMsg": "", "cmdName": "{name}", "number": {number}}}"#)
            }
            Self::Nameless { number } => write!(f, r#"{{"errorCode": "{number}", "errorMsg": ""}}"#),
            Self::Garbage => f.write_str("garbage"),
            Self::End => Ok(()),
        }
    }
}

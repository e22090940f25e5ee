//! What the threads of one controller share.

use std::collections::VecDeque;
use std::io;
use std::sync::Mutex;

use crate::book::Book;
use crate::command_port::Seat;
use crate::door::Door;
use crate::fault::Fault;
use crate::lock::lock;
use crate::status_port::Readers;
use crate::tape::Tape;
use crate::{Builder, State};

/// What the threads of one controller share. No lock is held while another of these is waited for, but for `state`,
/// which is the last.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) options: Builder,
    pub(crate) book: &'static Book,
    pub(crate) command_door: Door,
    pub(crate) status_door: Door,
    pub(crate) seat: Seat,
    pub(crate) readers: Readers,
    pub(crate) tape: Tape,
    pub(crate) state: Mutex<State>,
    faults: Mutex<VecDeque<Fault>>,
}

impl Shared {
    pub(crate) fn new(options: Builder) -> io::Result<Self> {
        let book = Book::open()?;
        Ok(Self {
            options,
            book,
            command_door: Door::open()?,
            status_door: Door::open()?,
            seat: Seat::default(),
            readers: Readers::default(),
            tape: Tape::default(),
            state: Mutex::new(State::initial(book)?),
            faults: Mutex::default(),
        })
    }

    pub(crate) fn add_fault(&self, fault: Fault) {
        lock(&self.faults).push_back(fault);
    }

    /// What is wrong with the next reply.
    pub(crate) fn next_fault(&self) -> Fault {
        lock(&self.faults).pop_front().unwrap_or(Fault::None)
    }
}

//! Port 10001: one client, whose requests are answered in order.

mod feed;
mod line;
mod replayed;
mod rival;
mod seat;
mod way_out;

use std::io;
use std::net::TcpStream;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use jaka_proto::wire::Writer;

use self::feed::{Feed, Incoming, Next};
use self::line::{Flow, Line};
pub(crate) use self::rival::Rival;
pub(crate) use self::seat::Seat;
use crate::answer::{self, Sequel};
use crate::link::Wire;
use crate::replay::Replay;
use crate::shared::Shared;
use crate::{Port, Takeover, firmware};

/// Lets clients in until the door is closed.
pub(crate) fn run(shared: &Arc<Shared>) {
    let mut serving = None;
    while let Some(guest) = shared.command_door.next_guest() {
        if let Err(error) = admit(guest, &mut serving, shared) {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
        }
    }
    vacate(&mut serving, shared);
    shared.command_door.desert();
}

/// Gives the seat to a client, or closes its connection.
fn admit(guest: TcpStream, serving: &mut Option<JoinHandle<()>>, shared: &Arc<Shared>) -> io::Result<()> {
    if shared.options.takeover == Takeover::Refuse && shared.seat.is_taken() {
        log::trace!(target: "jaka_sim", "command client refused");
        Wire::new(guest, Port::Command, &shared.links)?.close();
        return Ok(());
    }
    vacate(serving, shared);
    log::trace!(target: "jaka_sim", "command client connected");
    let line = Arc::new(Line::new(guest, &shared.links)?);
    shared.seat.take(Arc::clone(&line));
    let thread = thread::Builder::new().name("jaka-sim commands".to_owned());
    let (theirs, host) = (Arc::clone(&line), Arc::clone(shared));
    match thread.spawn(move || attend(&theirs, &host)) {
        Ok(thread) => *serving = Some(thread),
        Err(error) => {
            shared.seat.leave(&line);
            return Err(error);
        }
    }
    Ok(())
}

/// Closes the connection of the client that has the seat, and waits for its thread.
fn vacate(serving: &mut Option<JoinHandle<()>>, shared: &Shared) {
    shared.seat.vacate();
    if let Some(thread) = serving.take() {
        // A panic there has been reported, and concerns one connection.
        drop(thread.join());
    }
}

/// Serves a client to the end of its connection.
fn attend(line: &Arc<Line>, shared: &Shared) {
    let end = match &shared.stage {
        Some(stage) if stage.mode == Replay::Strict => replayed::serve(line, stage, shared),
        _ => serve(line, shared),
    };
    log::trace!(target: "jaka_sim", "command client leaves");
    match end {
        Flow::Takeover => take_over(shared),
        Flow::Shutdown => shut_down(shared),
        _ => {}
    }
    // The seat is free before the client sees the end.
    shared.seat.leave(line);
    if end == Flow::Reset {
        line.reset_on_drop();
    } else {
        line.close();
    }
}

fn take_over(shared: &Shared) {
    if let Err(error) = shared.rival.take_seat(shared) {
        log::trace!(target: "jaka_sim", "no other client can be had: {error}");
    }
}

/// Closes the connections of the status port, as the end of the session closes this one. New ones are let in: those of a
/// controller that has been started again.
fn shut_down(shared: &Shared) {
    // Where the system has no socket left to wait with, what has been let in so far has to do.
    shared.status_door.settle().ok();
    shared.readers.close();
}

fn serve(line: &Line, shared: &Shared) -> Flow {
    let mut feed = Feed::new(line.wire());
    let mut reply = Writer::new();
    loop {
        let mut flow = line.way_out().send_due(|by| shared.world().is_at_rest_by(by));
        if flow == Flow::Stay {
            flow = receive(&mut feed, line, shared, &mut reply);
        }
        match flow {
            Flow::Stay => {}
            Flow::HalfOpen => return ignore(&mut feed, line),
            Flow::Close | Flow::Reset | Flow::Takeover | Flow::Shutdown => return flow,
        }
    }
}

/// Waits for the next request, or until a late reply is due.
fn receive(feed: &mut Feed, line: &Line, shared: &Shared, reply: &mut Writer) -> Flow {
    let patience = line.way_out().wait_for_due();
    match feed.next(patience) {
        Ok(Next::Incoming(incoming)) => match &shared.stage {
            Some(stage) => replayed::answer(&incoming, line, stage, &shared.tape),
            None => exchange(&incoming, line, shared, reply),
        },
        Ok(Next::Silence) => Flow::Stay,
        Ok(Next::End) => Flow::Close,
        Err(error) => {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            Flow::Close
        }
    }
}

/// Answers nothing to the end of the connection.
fn ignore(feed: &mut Feed, line: &Line) -> Flow {
    log::trace!(target: "jaka_sim", "command client ignored");
    if matches!(feed.ignore(), Ok(false)) {
        line.wait_until_closed();
    }
    Flow::Close
}

/// Answers one request.
///
/// The state has changed before the request is seen on the tape, and the way out is locked until the reply is on it:
/// who waits for a request can rely on its effects, and can release its reply.
fn exchange(incoming: &Incoming, line: &Line, shared: &Shared, reply: &mut Writer) -> Flow {
    let mut way_out = line.way_out();
    reply.clear();
    log::trace!(target: "jaka_sim", "received {incoming}");
    let mut world = shared.world();
    let sequel = match incoming {
        Incoming::Request(text) => answer::answer(text, &shared.book, &mut world, reply),
        Incoming::NoText(_) | Incoming::Garbage => {
            answer::refuse_unknown(&shared.book, reply);
            Sequel::Nothing
        }
    };
    put_set_fields(incoming, shared, reply);
    firmware::restyle(shared.options.style(), &shared.book.spec, &world.state, reply);
    drop(world);
    let fault = shared.faults().next(incoming.command().as_deref());
    if let Incoming::Request(text) | Incoming::NoText(text) = incoming {
        shared.tape.record(text.clone());
    }
    way_out.send_reply(reply.as_str(), fault, sequel)
}

/// Writes the fields that a user has set into the reply.
fn put_set_fields(incoming: &Incoming, shared: &Shared, reply: &mut Writer) {
    let replies = shared.replies();
    if replies.is_empty() {
        return;
    }
    if let Some(fields) = incoming.command().and_then(|command| replies.get(&command).cloned()) {
        answer::put(&fields, reply);
    }
}

//! Command port (10001): one active client, with requests answered in order.

mod replayed;
mod request_reader;

use std::io;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

use jaka_clock::Socket;
use jaka_proto::Envelope;
use jaka_proto::wire::Writer;

use self::request_reader::{Incoming, NextRequest, RequestReader};
use crate::answer::{self, Sequel};
use crate::clock;
use crate::connection::{CommandConnection, NextStep};
use crate::firmware::Values;
use crate::link::Wire;
use crate::replay::Replay;
use crate::shared::Shared;
use crate::spec_index::accepted;
use crate::world::World;
use crate::{Port, Takeover};

/// Accepts clients until the listener is closed.
pub(crate) fn run(shared: &Arc<Shared>) {
    let mut serving = None;
    shared.command_listener.accept_all("command client", |socket| admit(socket, &mut serving, shared));
    close_active(&mut serving, shared);
    shared.command_listener.stop();
}

/// Makes a client the active one, or closes its connection.
fn admit(socket: Socket, serving: &mut Option<JoinHandle<()>>, shared: &Arc<Shared>) -> io::Result<()> {
    if shared.options.takeover == Takeover::Refuse && shared.active_client.connection().is_some() {
        log::trace!(target: "jaka_sim", "command client refused");
        Wire::new(socket, Port::Command, &shared.links)?.close();
        return Ok(());
    }
    close_active(serving, shared);
    log::trace!(target: "jaka_sim", "command client connected");
    let connection = Arc::new(CommandConnection::new(socket, &shared.links)?);
    shared.active_client.replace(Some(Arc::clone(&connection)));
    let (theirs, host) = (Arc::clone(&connection), Arc::clone(shared));
    let thread = clock::spawn(shared.time(), "commands", move || serve_to_end(&theirs, &host));
    *serving = Some(thread.inspect_err(|_| shared.active_client.clear(&connection))?);
    Ok(())
}

/// Closes the connection of the active client, and waits for its thread.
fn close_active(serving: &mut Option<JoinHandle<()>>, shared: &Shared) {
    shared.active_client.close();
    if let Some(thread) = serving.take() {
        // The panic hook has reported a panic of the thread, which concerns one connection.
        drop(thread.join());
    }
}

/// Serves a client, and ends its connection.
fn serve_to_end(connection: &Arc<CommandConnection>, shared: &Shared) {
    let end = match &shared.replay {
        Some(session) if session.mode == Replay::Strict => replayed::serve(connection, session, shared),
        _ => serve(connection, shared),
    };
    log::trace!(target: "jaka_sim", "command client leaves");
    match end {
        NextStep::Takeover => take_over(shared),
        NextStep::Shutdown => shut_down(shared),
        _ => {}
    }
    // The port is free before the client sees the end of the connection.
    shared.active_client.clear(connection);
    if end == NextStep::Reset {
        connection.wire().reset_on_drop();
    } else {
        connection.close();
    }
}

fn take_over(shared: &Shared) {
    if let Err(error) = shared.take_over() {
        log::trace!(target: "jaka_sim", "no other client can connect: {error}");
    }
}

/// Closes the connections of the status port, as the end of the session closes this one. Accepts new connections, as a
/// restarted controller does.
fn shut_down(shared: &Shared) {
    // If the system has no socket left to wait with, closes only the connections accepted so far.
    shared.status_listener.wait_until_accepted();
    shared.readers.close();
}

fn serve(connection: &CommandConnection, shared: &Shared) -> NextStep {
    let mut requests = RequestReader::new(connection.wire());
    let mut reply = Writer::new();
    loop {
        let mut next = connection.writer().send_due(|wait| shared.world().is_over(wait));
        if next == NextStep::Continue {
            next = receive(&mut requests, connection, shared, &mut reply);
        }
        match next {
            NextStep::Continue => {}
            NextStep::HalfOpen => return ignore(&mut requests, connection),
            NextStep::Close | NextStep::Reset | NextStep::Takeover | NextStep::Shutdown => return next,
        }
    }
}

/// Waits for the next request, or until a delayed reply is due.
fn receive(
    requests: &mut RequestReader,
    connection: &CommandConnection,
    shared: &Shared,
    reply: &mut Writer,
) -> NextStep {
    let timeout = connection.writer().wait_for_due();
    match requests.next(timeout) {
        Ok(NextRequest::Incoming(incoming)) => match &shared.replay {
            Some(session) => replayed::answer(&incoming, connection, session, &shared.request_log),
            None => exchange(&incoming, connection, shared, reply),
        },
        Ok(NextRequest::Silence) => NextStep::Continue,
        Ok(NextRequest::End) => NextStep::Close,
        Err(error) => {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            NextStep::Close
        }
    }
}

/// Leaves all requests unanswered until the connection ends.
fn ignore(requests: &mut RequestReader, connection: &CommandConnection) -> NextStep {
    log::trace!(target: "jaka_sim", "command client ignored");
    if matches!(requests.ignore(), Ok(false)) {
        connection.closes_within(Duration::MAX);
    }
    NextStep::Close
}

/// Answers one request.
///
/// The state changes before the log has the request, and the writer stays locked until the reply is written or held. A
/// thread that has waited for the request therefore sees its effects, and can release its reply.
fn exchange(incoming: &Incoming, connection: &CommandConnection, shared: &Shared, reply: &mut Writer) -> NextStep {
    let mut writer = connection.writer();
    reply.clear();
    log::trace!(target: "jaka_sim", "received {incoming}");
    let mut world = shared.world();
    let sequel = match incoming {
        Incoming::Request(text) => answer::answer(text, &shared.spec_index, &mut world, reply),
        Incoming::NoText(_) | Incoming::Garbage => {
            answer::refuse_unknown(&shared.spec_index, reply);
            Sequel::Nothing
        }
    };
    let command = incoming.command();
    if let Some(command) = &command {
        put_status(command, shared, &world, reply);
        put_set_fields(command, shared, reply);
    }
    Values::of_replies(&shared.spec_index.spec, world.writing).rewrite(reply);
    drop(world);
    let fault = shared.faults().next(command.as_deref());
    if let Incoming::Request(text) | Incoming::NoText(text) = incoming {
        shared.request_log.record(text.clone());
    }
    writer.send_reply(fault.delivery(reply.as_str()), sequel)
}

/// Writes the values of a packet into an accepted reply with a packet's keys.
fn put_status(command: &str, shared: &Shared, world: &World, reply: &mut Writer) {
    let Some(entry) = shared.spec_index.entry(command) else { return };
    let is_status = entry.command.reply.object().is_some_and(|ty| Some(ty) == shared.spec_index.spec.status_type());
    if !is_status || Envelope::read(reply.as_str()).is_ok_and(|envelope| envelope.refusal().is_some()) {
        return;
    }
    reply.clear();
    reply.raw(&accepted(&entry.command.wire, &shared.packet_of(&world.state)));
}

/// Writes the fields set by the user into the reply.
fn put_set_fields(command: &str, shared: &Shared, reply: &mut Writer) {
    if let Some(fields) = shared.replies().get(command).cloned() {
        answer::put(&fields, reply);
    }
}

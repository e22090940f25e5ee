//! The ports: whether a controller listens there that answers this client.

use std::error::Error as StdError;
use std::io;

use jaka_sync::layer::is_text_line;
use jaka_sync::{Disconnect, Error, ErrorCode, ErrorKind};

use super::finding::Judgement;

const REMOTE_CONTROL: &str = "grant remote control at the pendant: the controller may be in local mode";
const ANOTHER_CLIENT: &str =
    "the command port serves one client: look for another program that is connected to it, and end that one";
const NO_STATUS: &str = "check the address and the port, and wait until the controller has started";
const NO_COMMANDS: &str = "check the address and the port, wait until the controller has started, and end other programs that are connected to \
                           this port, such as the vendor's app: it serves one client";
const STATUS_ENDED: &str = "check that this is port 10000 of a controller that is not shutting down";
const NOT_A_CONTROLLER: &str =
    "check the address and the port: something else may listen there, or a controller that expects TLS";

/// True if the error is not of one command: no other would be answered either.
pub(super) fn is_unusable(error: &Error) -> bool {
    let denied = error.refusal().is_some_and(|refusal| refusal.code == ErrorCode::PERMISSION_DENIED);
    denied || error.is_connect() || error.is_timeout() || error.is_disconnected()
}

/// Judges an error because of which the command port cannot be used.
pub(super) fn of_commands(error: &Error) -> Judgement {
    let (seen, advice) = match error.kind() {
        ErrorKind::Connect { address, source, .. } => not_connected(address, source, NO_COMMANDS),
        ErrorKind::Timeout { .. } => {
            (failure(error), "check that this is port 10001 of a controller that has started, and the network")
        }
        ErrorKind::Disconnected { cause, .. } => lost(cause, ANOTHER_CLIENT),
        _ => (failure(error), advice(error)),
    };
    Judgement::wrong(seen, advice)
}

/// The status port has ended.
pub(super) fn status_ended(cause: &Disconnect) -> Judgement {
    let (seen, advice) = lost(cause, STATUS_ENDED);
    Judgement::wrong(seen, advice)
}

/// Judges an error because of which the status port cannot be used. `dropped` is the number of bytes that came and do
/// not belong to a packet.
pub(super) fn of_status(error: &Error, dropped: u64) -> Judgement {
    let (seen, advice) = match error.kind() {
        ErrorKind::Connect { address, source, .. } => not_connected(address, source, NO_STATUS),
        ErrorKind::StatusTimeout { address, after } if dropped > 0 => {
            (format!("no status packet from {address} within {after:?}; other data came"), NOT_A_CONTROLLER)
        }
        ErrorKind::StatusTimeout { address, after } => (
            format!("no status packet from {address} within {after:?}"),
            "check the network, and that this is port 10000; port 10001 sends only replies",
        ),
        ErrorKind::Disconnected { cause, .. } => lost(cause, STATUS_ENDED),
        _ => (facts(error), "print the received bytes with `jaka status --raw`"),
    };
    Judgement::wrong(seen, advice)
}

/// Reason why a query has no answer. It does not matter that the query may have run.
pub(super) fn failure(error: &Error) -> String {
    match error.kind() {
        ErrorKind::Timeout { command, after } => format!("no reply to `{command}` within {after:?}"),
        ErrorKind::Disconnected { command: Some(command), cause, .. } => {
            format!("the connection broke at `{command}`: {}", chain(&**cause))
        }
        _ => facts(error),
    }
}

/// Advice for a query that failed.
pub(super) fn advice(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::Refused { refusal, .. } if refusal.code == ErrorCode::PERMISSION_DENIED => REMOTE_CONTROL,
        ErrorKind::Refused { .. } => "read it at the pendant: this controller does not answer the query",
        ErrorKind::UnexpectedReply { .. } => "read it at the pendant; `jaka probe` shows the reply",
        ErrorKind::Disconnected { .. } => ANOTHER_CLIENT,
        _ => "check the network and the load of the controller, then run the check again",
    }
}

fn not_connected(address: &str, source: &io::Error, refused: &'static str) -> (String, &'static str) {
    match source.kind() {
        io::ErrorKind::ConnectionRefused => (format!("{address} refuses the connection ({source})"), refused),
        io::ErrorKind::TimedOut
        | io::ErrorKind::WouldBlock
        | io::ErrorKind::HostUnreachable
        | io::ErrorKind::NetworkUnreachable => (
            format!("{address} does not answer ({source})"),
            "check that the controller is on, the cable, the address, and that this machine is in the controller's network",
        ),
        _ => (format!("cannot connect to {address}: {source}"), "check the address"),
    }
}

fn lost(cause: &Disconnect, closed: &'static str) -> (String, &'static str) {
    match cause {
        Disconnect::Closed { .. } => ("the controller closed the connection".to_owned(), closed),
        Disconnect::Read(_) | Disconnect::Write(_) => (chain(cause), closed),
        Disconnect::StatusPort => {
            ("this port sends status packets".to_owned(), "this is the status port: commands go to port 10001")
        }
        Disconnect::CommandPort => {
            ("this port sends replies to commands".to_owned(), "this is the command port: packets come from port 10000")
        }
        Disconnect::Frame(error) if is_text_line(error) => {
            (chain(cause), "this firmware is older than the protocol: ask the vendor for newer firmware")
        }
        Disconnect::Frame(_) | Disconnect::NotJson(_) => (chain(cause), NOT_A_CONTROLLER),
        _ => (chain(cause), "connect again"),
    }
}

/// Facts of an error and its sources.
fn facts(error: &Error) -> String {
    let fact = error.kind().to_string();
    error.source().map_or_else(|| fact.clone(), |source| format!("{fact}: {}", chain(source)))
}

/// An error's text, followed by the texts of its causes.
fn chain(error: &(dyn StdError + 'static)) -> String {
    let errors = std::iter::successors(Some(error), |&error| error.source());
    errors.map(ToString::to_string).collect::<Vec<_>>().join(": ")
}

//! Queries on the command port, until it is lost.

use jaka_clock::Clock;
use jaka_proto::messages::power::{GetVersion, GetVersionReply};
use jaka_proto::{Command, FirmwareVersion};
use jaka_sync::layer::ClientParts as _;
use jaka_sync::{Client, Error};

use super::finding::{CheckItem, Finding, Judgement, either};
use super::ports;

/// The oldest firmware of which there is a capture.
const OLDEST: FirmwareVersion = FirmwareVersion::new([1, 5, 14]);
/// The newest firmware that a client names.
const NEWEST: FirmwareVersion = FirmwareVersion::new([3, 2, 10]);
/// After so many queries without a reply, one after the other, no other is sent.
const MOST_UNANSWERED: u32 = 2;

/// The command port, if it can be used.
#[derive(Debug)]
pub(super) struct Commands<'c> {
    client: Option<&'c mut Client>,
    unanswered: u32,
}

impl<'c> Commands<'c> {
    /// Asks for the controller's version, and so finds out whether the port can be used.
    pub(super) fn open(client: Result<&'c mut Client, &Error>, findings: &mut Vec<Finding>) -> Self {
        let opened = match client {
            Ok(client) => usable(client),
            Err(error) => Err(ports::of_commands(error)),
        };
        let (client, [port, firmware]) = match opened {
            Ok((client, found)) => (Some(client), found),
            Err(port) => (None, [port, no_commands()]),
        };
        findings.extend([port.at(CheckItem::CommandPort), firmware.at(CheckItem::Firmware)]);
        Self { client, unanswered: 0 }
    }

    /// The clock of the connection.
    pub(super) fn clock(&self) -> Clock {
        self.client.as_ref().map_or_else(Clock::default, |client| client.link().clock.clone())
    }

    /// Asks one question, and judges its failure, if it has no answer.
    pub(super) fn ask<C: Command>(&mut self, query: &C) -> Result<C::Reply, Judgement> {
        let Some(client) = &mut self.client else { return Err(no_commands()) };
        let error = match client.call(query) {
            Ok(reply) => {
                self.unanswered = 0;
                return Ok(reply);
            }
            Err(error) => error,
        };
        self.unanswered = if error.is_timeout() { self.unanswered + 1 } else { 0 };
        let is_lost = error.is_disconnected();
        if is_lost || self.unanswered == MOST_UNANSWERED {
            self.client = None;
        }
        let found = if is_lost { Judgement::wrong } else { Judgement::look };
        Err(found(ports::failure(&error), ports::advice(&error)))
    }

    /// Judges the answer to a question, or its failure.
    pub(super) fn judge<C: Command>(&mut self, query: &C, judge: impl FnOnce(C::Reply) -> Judgement) -> Judgement {
        either(self.ask(query).map(judge))
    }
}

/// The client and the answers of its port, or the reason against its use.
fn usable(client: &mut Client) -> Result<(&mut Client, [Judgement; 2]), Judgement> {
    let answer = client.call(&GetVersion::new());
    if let Some(error) = answer.as_ref().err().filter(|error| ports::is_unusable(error)) {
        return Err(ports::of_commands(error));
    }
    let peer = client.peer_addr().map_or_else(|_| "the controller".to_owned(), |peer| peer.to_string());
    let port = Judgement::nothing(format!("{peer} answers"));
    Ok((client, [port, firmware(answer)]))
}

fn no_commands() -> Judgement {
    Judgement::not_checked("the command port cannot be used")
}

fn firmware(answer: Result<GetVersionReply, Error>) -> Judgement {
    const COMPARE: &str = "compare its answers with the spec before you rely on them: `jaka probe` does it";
    let text = match answer {
        Ok(reply) => reply.version,
        Err(error) => return Judgement::look(ports::failure(&error), ports::advice(&error)),
    };
    match text.parse::<FirmwareVersion>() {
        Err(error) => Judgement::look(error.to_string(), COMPARE),
        Ok(version) if version < OLDEST => {
            Judgement::look(format!("{text}, older than {OLDEST}, the oldest that was captured"), COMPARE)
        }
        Ok(version) if version > NEWEST => {
            Judgement::look(format!("{text}, newer than {NEWEST}, the newest that is known"), COMPARE)
        }
        Ok(_) => Judgement::nothing(text),
    }
}

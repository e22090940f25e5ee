//! Sending a request, and showing what comes back.

use std::time::Duration;

use jaka_dynamic::{DepartureKind, Reading, departures};
use jaka_spec::{Command, Spec};
use jaka_sync::proto::text::visible_json_line;
use jaka_sync::proto::wire::DecodeError;
use jaka_sync::{Client, Disconnect, Error, ErrorKind, Explanation};

use super::options::Options;
use super::request::Request;
use super::{consent, firmware, reply, wait};
use crate::failure::Failure;
use crate::interrupt::UnderWay;
use crate::output;
use crate::packs::Protocol;
use crate::target::Target;

/// Sends the request and prints the reply; with `--dry-run`, prints the bytes alone.
pub(super) fn carry_out(protocol: &Protocol, options: &Options, request: &Request<'_>) -> Result<(), Failure> {
    if options.dry_run {
        // The bytes that would be sent, which are the user's own.
        return output::write(format!("{}\n", request.text).as_bytes());
    }
    let motion = options.wait.then(|| wait::motion(request)).transpose()?;
    let under_way = UnderWay::begin()?;
    let target = options.robot.target(&protocol.packs)?;
    consent::obtain(request, options, target.title())?;
    if let Some(motion) = motion {
        return wait::carry_out(protocol, options, request, &target, &motion, &under_way);
    }
    let mut client = target.client()?;
    if options.check_firmware {
        firmware::check(&mut client, &protocol.spec, request)?;
    }
    let usual = client.reply_timeout().max(request.command.and_then(|command| command.deadline).unwrap_or_default());
    under_way.sends(&format!("`{}`", request.name));
    let sent = send(&mut client, request, target.patience(usual));
    under_way.answered();
    match sent {
        Ok(Some(text)) => print_reply(&protocol.spec, options, request, &text),
        Ok(None) => output::line("sent; the controller closed the connection instead of replying"),
        Err(error) => {
            let raw = client.last_reply().filter(|_| options.json && answered(&error));
            raw.map_or(Ok(()), json_line)?;
            Err(explained(&protocol.spec, &target, error))
        }
    }
}

/// The reply's text; none where the controller may go away instead of replying, and did.
fn send(client: &mut Client, request: &Request<'_>, timeout: Duration) -> Result<Option<String>, Error> {
    let reply = client.call_text(&request.text, timeout).map(str::to_owned);
    let may_end = request.command.is_some_and(|command| !command.reply_certain);
    match reply {
        Err(error) if may_end && has_ended(&error) => Ok(None),
        other => other.map(Some),
    }
}

/// True if the controller closed the connection after the request was sent.
fn has_ended(error: &Error) -> bool {
    let ErrorKind::Disconnected { sent: true, cause, .. } = error.kind() else { return false };
    matches!(**cause, Disconnect::Closed { .. } | Disconnect::Read(_))
}

/// True if the error is about a reply that came.
fn answered(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::Refused { .. } | ErrorKind::UnexpectedReply { .. })
}

/// The error with what the spec or a pack says about the controller's code, and what the robot's status says.
fn explained(spec: &Spec, target: &Target, error: Error) -> Failure {
    let mut failure = Failure::explained(spec, error);
    if let Failure::Refused { refusal, explanation, .. } = &mut failure {
        // Without a status, the refusal has no explanation.
        let status = target.status_stream().ok().and_then(|mut stream| stream.newest_packet().ok());
        *explanation = Explanation::of(refusal, status.as_ref()).map(Box::new);
    }
    failure
}

fn print_reply(spec: &Spec, options: &Options, request: &Request<'_>, text: &str) -> Result<(), Failure> {
    if options.json {
        json_line(text)?;
    } else {
        output::lines(&reply::table(spec, request.command, text))?;
    }
    request.command.map_or(Ok(()), |command| must_fit(spec, command, text))
}

/// The controller's own JSON in one line, with escapes for what cannot be seen.
fn json_line(text: &str) -> Result<(), Failure> {
    output::line(&visible_json_line(text))
}

/// Fails if the reply cannot be read as the spec has it.
fn must_fit(spec: &Spec, command: &Command, text: &str) -> Result<(), Failure> {
    let departures = departures(spec, command, &reply::json(text));
    let Some(first) = departures.into_iter().find(|departure| departure.reading == Reading::Unreadable) else {
        return Ok(());
    };
    let source = match first.kind {
        DepartureKind::Missing => {
            let key = first.field.rsplit('.').next().unwrap_or_default().to_owned();
            DecodeError::missing(&first.field, key)
        }
        _ => DecodeError::unfit(first.expected, &first.found).in_field(&first.field),
    };
    Err(Error::from(ErrorKind::UnexpectedReply { command: command.wire.clone(), source }).into())
}

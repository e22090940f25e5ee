//! Sending of a request, and output of its reply.

use jaka_dynamic::{Departure, Node, Reading, not_in_firmware};
use jaka_robot::Occurrence;
use jaka_robot::proto::text::visible_json_line;
use jaka_spec::Spec;
use jaka_sync::{Client, Disconnect, Error, ErrorKind};
use serde_json::{Map, Value, json};

use super::options::{Keys, Options};
use super::request::Request;
use super::{consent, reply, wait};
use crate::arm::interrupt::{Stage, UnderWay};
use crate::arm::motion;
use crate::arm::motion::Form;
use crate::failure::Failure;
use crate::packets::packed_status::{PackedRobot, PackedStatus};
use crate::target::Target;
use crate::target::packs::Protocol;
use crate::terminal::output;

/// Sends the request and prints the reply; with `--dry-run`, only prints the bytes.
pub(super) fn carry_out(protocol: &Protocol, options: &Options, request: &Request<'_>) -> Result<(), Failure> {
    if options.dry_run {
        // Prints the user's own bytes as they would be sent.
        return output::write(format!("{}\n", request.text).as_bytes());
    }
    let motion = options.wait.then(|| wait::must_be_motion(protocol, request)).transpose()?;
    let under_way = UnderWay::begin();
    let target = options.robot.target(&protocol.packs)?;
    consent::obtain(protocol, request, options, target.title())?;
    let mut connection = Connection::open(&target, options)?;
    if options.check_firmware {
        check_firmware(connection.client(), &protocol.spec, request)?;
    }
    if let (Connection::Robot(robot), Some(motion)) = (&mut connection, motion) {
        let patience = target.patience(motion::PATIENCE);
        let ended = motion::end(robot, |robot| robot.run(&motion, patience), &protocol.spec, &under_way)?;
        return motion::print(&request.name, ended, Form::of(options.json.is_some()));
    }
    let client = connection.client();
    match send(client, request, &target, &under_way) {
        Ok(Some(text)) => print_reply(&protocol.spec, options, request, &text),
        Ok(None) => output::line("sent; the controller closed the connection instead of replying"),
        Err(error) => {
            let is_wire = options.json == Some(Keys::Wire);
            let raw = client.last_reply().filter(|_| is_wire && answered(&error));
            raw.map_or(Ok(()), json_line)?;
            Err(explained(&protocol.spec, &target, error))
        }
    }
}

/// Queries the controller's version, and refuses a request that its firmware does not have.
fn check_firmware(client: &mut Client, spec: &Spec, request: &Request<'_>) -> Result<(), Failure> {
    let firmware = client.check_firmware()?;
    let Some(command) = request.command else { return Ok(()) };
    let message: Map<String, Value> = serde_json::from_str(&request.text).unwrap_or_default();
    let missing = not_in_firmware(command, &Node::request(spec, command, message), firmware);
    missing.map_or(Ok(()), |missing| Err(Error::from(missing).into()))
}

/// Connection for requests.
pub(super) enum Connection {
    Client(Box<Client>),
    /// Robot, for waits for the end of motions.
    Robot(Box<PackedRobot>),
}

impl Connection {
    pub(super) fn open(target: &Target, options: &Options) -> Result<Self, Failure> {
        if options.wait {
            Ok(Self::Robot(Box::new(target.robot()?)))
        } else {
            Ok(Self::Client(Box::new(target.client()?)))
        }
    }

    pub(super) fn client(&mut self) -> &mut Client {
        match self {
            Self::Client(client) => client,
            Self::Robot(robot) => robot.client(),
        }
    }
}

/// Returns the reply's text; `None` if the controller went away where it may do so instead of replying.
pub(super) fn send(
    client: &mut Client,
    request: &Request<'_>,
    target: &Target,
    under_way: &UnderWay,
) -> Result<Option<String>, Error> {
    let usual = client.reply_timeout().max(request.command.and_then(|command| command.deadline).unwrap_or_default());
    under_way.set(Stage::Sent(format!("`{}`", request.name)));
    let reply = client.call_text(&request.text, target.patience(usual)).map(str::to_owned);
    under_way.set(Stage::Answered);
    let may_end = request.command.is_some_and(|command| !command.reply_certain);
    match reply {
        Err(error) if may_end && has_ended(&error) => Ok(None),
        other => other.map(Some),
    }
}

/// Whether the controller closed the connection after the request was sent.
fn has_ended(error: &Error) -> bool {
    let ErrorKind::Disconnected { sent: true, cause, .. } = error.kind() else { return false };
    matches!(**cause, Disconnect::Closed { .. } | Disconnect::Read(_))
}

/// Whether the error is about a received reply.
fn answered(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::Refused { .. } | ErrorKind::UnexpectedReply { .. })
}

/// Returns the error with the meaning of the controller's code in the spec or a pack, and with the robot's status.
pub(super) fn explained(spec: &Spec, target: &Target, error: impl Into<jaka_robot::Error>) -> Failure {
    let mut failure = Failure::explained(spec, error);
    if let Failure::Refused { refusal, explanation, .. } = &mut failure {
        // Without a status, the refusal has no explanation.
        let status = target.status::<PackedStatus>().ok();
        *explanation = Occurrence::of_refusal(refusal, status.as_ref()).map(Box::new);
    }
    failure
}

/// Prints a reply.
fn print_reply(spec: &Spec, options: &Options, request: &Request<'_>, text: &str) -> Result<(), Failure> {
    let reply = Node::reply(spec, request.command, reply::json(text));
    match options.json {
        Some(Keys::Wire) => json_line(text)?,
        Some(Keys::Names) => {
            let line = json!({"command": request.name, "reply": reply.named()});
            output::json(&format!("{line}\n"))?;
        }
        None => output::lines(&reply::table(&reply))?,
    }
    must_fit(request, &reply)
}

/// Prints the controller's own JSON in one line, with escapes for invisible characters.
fn json_line(text: &str) -> Result<(), Failure> {
    output::line(&visible_json_line(text))
}

/// Returns an error if the reply is unreadable by the spec.
pub(super) fn must_fit(request: &Request<'_>, reply: &Node<'_>) -> Result<(), Failure> {
    let is_unreadable = |departure: &Departure| departure.reading == Reading::Unreadable;
    let Some((command, first)) = request.command.zip(reply.departures().into_iter().find(is_unreadable)) else {
        return Ok(());
    };
    let source = first.error();
    Err(Error::from(ErrorKind::UnexpectedReply { command: command.wire.clone(), source }).into())
}

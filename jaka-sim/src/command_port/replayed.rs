//! Answers from a recording.

use std::time::{Duration, Instant};

use jaka_proto::messages::servo::ServoJ;
use jaka_proto::messages::types::{JointPosition, MoveMode};
use jaka_proto::recording::{Answer, Ending};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, ErrorCode, Request, write_refusal, write_reply};

use super::request_reader::{Incoming, NextRequest, RequestReader};
use crate::Fault;
use crate::answer::Sequel;
use crate::connection::{CommandConnection, NextStep};
use crate::replay::{Deviation, ReplaySession, Script, ScriptStep, is_same};
use crate::request_log::RequestLog;
use crate::shared::Shared;

/// Replays the next connection of the recording, message by message.
pub(super) fn serve(connection: &CommandConnection, session: &ReplaySession, shared: &Shared) -> NextStep {
    let Some(script) = session.next_commands() else { return NextStep::Close };
    let requests = RequestReader::new(connection.wire());
    let mut player = Player {
        connection,
        session,
        shared,
        requests,
        since: (shared.time().now(), Duration::ZERO),
        came: 0,
        last: String::new(),
    };
    let end = player.play(&script);
    // Releases the status packets that wait for requests that will not come.
    script.requests().skip(player.came).for_each(|at| session.request_came(&script, at));
    shared.readers.reschedule();
    end.unwrap_or_else(|deviation| {
        session.deviates(deviation);
        NextStep::Close
    })
}

struct Player<'p> {
    connection: &'p CommandConnection,
    session: &'p ReplaySession,
    shared: &'p Shared,
    requests: RequestReader<'p>,
    /// Times of the last request, or of the start of the connection: now and in the recording.
    since: (Instant, Duration),
    /// Number of requests received.
    came: usize,
    /// Text of the last request.
    last: String,
}

impl Player<'_> {
    fn play(&mut self, script: &Script) -> Result<NextStep, Deviation> {
        for step in &script.steps {
            match step {
                ScriptStep::Expect { request, at } => {
                    self.expect(request, *at)?;
                    self.came += 1;
                    self.session.request_came(script, *at);
                    self.shared.readers.reschedule();
                }
                ScriptStep::Send { bytes, at } => {
                    if self.wait_until(*at) {
                        return Ok(NextStep::Close);
                    }
                    // A missing next request reveals a client that has disconnected.
                    self.connection.writer().write(bytes).ok();
                }
                ScriptStep::End { by, at } => {
                    self.wait_until(*at);
                    return Ok(next(*by));
                }
                ScriptStep::Gap { count } => return Err(Deviation::Gap { count: *count }),
            }
        }
        match self.next_request() {
            Some(received) => Err(Deviation::FurtherRequest { received }),
            None => Ok(NextStep::Close),
        }
    }

    fn expect(&mut self, expected: &str, at: Duration) -> Result<(), Deviation> {
        let expected = || expected.to_owned();
        loop {
            let received = self.next_request().ok_or_else(|| Deviation::MissingRequest { expected: expected() })?;
            if is_same(&expected(), &received) {
                self.since = (self.shared.time().now(), at);
                self.last = received;
                return Ok(());
            }
            if !(is_same(&self.last, &received) && holds(&received)) {
                return Err(Deviation::OtherRequest { expected: expected(), received });
            }
            let mut reply = Writer::new();
            write_reply(ServoJ::INFO, &(), &mut reply);
            self.connection.writer().write(reply.into_string().as_bytes()).ok();
        }
    }

    /// Returns the next request; `None` if the client has disconnected.
    fn next_request(&mut self) -> Option<String> {
        let Ok(NextRequest::Incoming(incoming)) = self.requests.next(None) else { return None };
        if let Incoming::Request(text) | Incoming::NoText(text) = &incoming {
            self.shared.request_log.record(text.clone());
        }
        Some(incoming.to_string())
    }

    /// Waits until the time of a message of the recording, and returns whether the connection was closed meanwhile.
    fn wait_until(&self, recorded: Duration) -> bool {
        let (since, then) = self.since;
        let delay = self.session.delay(recorded.saturating_sub(then));
        self.connection.closes_within(delay.saturating_sub(self.shared.time().elapsed(since)))
    }
}

/// Whether a repeated set-point of joint positions holds the arm in its position. The number of repetitions until
/// packets show the arm at rest depends on the times of the packets.
fn holds(request: &str) -> bool {
    match Request::read(request) {
        Ok(Request::ServoJ(set_point)) => {
            set_point.mode == MoveMode::Absolute || set_point.joint_position == JointPosition([0.0; 6])
        }
        _ => false,
    }
}

/// Answers a request from an equal one anywhere in the recording.
pub(super) fn answer(
    incoming: &Incoming,
    connection: &CommandConnection,
    session: &ReplaySession,
    request_log: &RequestLog,
) -> NextStep {
    let mut writer = connection.writer();
    let request = incoming.to_string();
    let (reply, fault) = match session.answer(&request) {
        Some(Answer::Reply { reply, after }) => (reply.to_string(), Fault::Delay(session.delay(after))),
        Some(Answer::Closed { by: Ending::Failure }) => (String::new(), Fault::Reset),
        Some(Answer::Closed { .. }) => (String::new(), Fault::Close),
        Some(_) => (String::new(), Fault::Drop),
        None => (refusal(incoming.command().as_deref()), Fault::None),
    };
    request_log.record(request);
    writer.send_reply(fault.delivery(&reply), Sequel::Nothing)
}

fn refusal(command: Option<&str>) -> String {
    let mut out = Writer::new();
    write_refusal(command, ErrorCode::EXCEPTION, "the recording has no unused reply to this request", &mut out);
    out.into_string()
}

fn next(by: Ending) -> NextStep {
    if by == Ending::Failure { NextStep::Reset } else { NextStep::Close }
}

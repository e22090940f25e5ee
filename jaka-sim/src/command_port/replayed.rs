//! Answers from a recording.

use std::time::{Duration, Instant};

use jaka_proto::recording::{Answer, Ending};
use jaka_proto::wire::Writer;
use jaka_proto::{ErrorCode, write_refusal};

use super::feed::{Feed, Incoming, Next};
use super::line::{Flow, Line};
use crate::Fault;
use crate::answer::Sequel;
use crate::replay::{Deviation, Script, Stage, Step, is_same};
use crate::shared::Shared;
use crate::tape::Tape;

/// Plays the next connection of the recording, message by message.
pub(super) fn serve(line: &Line, stage: &Stage, shared: &Shared) -> Flow {
    let Some(script) = stage.next_commands() else { return Flow::Close };
    let feed = Feed::new(line.wire());
    let mut player = Player { line, stage, shared, feed, since: (Instant::now(), Duration::ZERO), came: 0 };
    let end = player.play(&script);
    // Status packets wait no longer for requests that will not come.
    script.requests().skip(player.came).for_each(|at| stage.request_came(&script, at));
    shared.readers.wake();
    end.unwrap_or_else(|deviation| {
        stage.deviates(deviation);
        Flow::Close
    })
}

struct Player<'p> {
    line: &'p Line,
    stage: &'p Stage,
    shared: &'p Shared,
    feed: Feed<'p>,
    /// When the last request came, or the connection began, and when it did in the recording.
    since: (Instant, Duration),
    /// How many requests have come.
    came: usize,
}

impl Player<'_> {
    fn play(&mut self, script: &Script) -> Result<Flow, Deviation> {
        for step in &script.steps {
            match step {
                Step::Expect { request, at } => {
                    self.expect(request, *at)?;
                    self.came += 1;
                    self.stage.request_came(script, *at);
                    self.shared.readers.wake();
                }
                Step::Send { bytes, at } => {
                    if self.wait_until(*at) {
                        return Ok(Flow::Close);
                    }
                    // A client that has gone is noticed where its next request is missing.
                    self.line.way_out().write(bytes).ok();
                }
                Step::End { by, at } => {
                    self.wait_until(*at);
                    return Ok(flow(*by));
                }
                Step::Gap { count } => return Err(Deviation::Gap { count: *count }),
            }
        }
        match self.next_request() {
            Some(received) => Err(Deviation::FurtherRequest { received }),
            None => Ok(Flow::Close),
        }
    }

    fn expect(&mut self, expected: &str, at: Duration) -> Result<(), Deviation> {
        let expected = || expected.to_owned();
        let received = self.next_request().ok_or_else(|| Deviation::MissingRequest { expected: expected() })?;
        self.since = (Instant::now(), at);
        if is_same(&expected(), &received) {
            return Ok(());
        }
        Err(Deviation::OtherRequest { expected: expected(), received })
    }

    /// The next request; `None` if the client has gone.
    fn next_request(&mut self) -> Option<String> {
        let Ok(Next::Incoming(incoming)) = self.feed.next(None) else { return None };
        if let Incoming::Request(text) | Incoming::NoText(text) = &incoming {
            self.shared.tape.record(text.clone());
        }
        Some(incoming.to_string())
    }

    /// Waits until it is time for what is so late in the recording, and says whether the connection was closed meanwhile.
    fn wait_until(&self, recorded: Duration) -> bool {
        let (since, then) = self.since;
        let delay = self.stage.delay(recorded.saturating_sub(then));
        self.line.closes_within(delay.saturating_sub(since.elapsed()))
    }
}

/// Answers a request from wherever in the recording an equal one is.
pub(super) fn answer(incoming: &Incoming, line: &Line, stage: &Stage, tape: &Tape) -> Flow {
    let mut way_out = line.way_out();
    let request = incoming.to_string();
    let (reply, fault) = match stage.answer(&request) {
        Some(Answer::Reply { reply, after }) => (reply.to_string(), Fault::Delay(stage.delay(after))),
        Some(Answer::Closed { by: Ending::Failure }) => (String::new(), Fault::Reset),
        Some(Answer::Closed { .. }) => (String::new(), Fault::Close),
        Some(_) => (String::new(), Fault::Drop),
        None => (refusal(incoming.command().as_deref()), Fault::None),
    };
    tape.record(request);
    way_out.send_reply(&reply, fault, Sequel::Nothing)
}

fn refusal(command: Option<&str>) -> String {
    let mut out = Writer::new();
    write_refusal(command, ErrorCode::EXCEPTION, "the recording has no reply left to this request", &mut out);
    out.into_string()
}

fn flow(by: Ending) -> Flow {
    if by == Ending::Failure { Flow::Reset } else { Flow::Close }
}

//! End of servo mode, for each end of a session.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::exchange::TextOnly;
use jaka_proto::messages::servo::{IsInServomove, ServoJ, SetServoMode};
use jaka_proto::messages::types::Switch;
use jaka_proto::recording::MotionStep;
use jaka_sync::layer::{ClientParts as _, Sent};

use super::ServoSession;
use super::Supervision;
use super::braking::braking_after;
use super::land::{BrakingPath, not_seen};
use super::pace::{CYCLE, Pace};
use crate::cause::Braking;
use crate::error::SessionEnd;
use crate::{Cause, Disconnect, End, Error, ErrorKind, Occurrence, Report, ServoModeState};

/// Timeout for the last replies, and for the end of servo mode after set-points that were not answered.
const PATIENCE: Duration = Duration::from_secs(1);

/// Timeout for the packet that shows why a set-point was refused: packets come each 100 ms or sooner.
const SETTLING: Duration = Duration::from_millis(250);

impl ServoSession<'_> {
    /// Brakes the arm, holds it until the status shows it at rest, waits for the last answers, and leaves servo mode.
    ///
    /// # Errors
    /// As [`Client::call`](crate::Client::call), and [`ErrorKind::Refused`] if the controller refused a set-point.
    /// [`ErrorKind::RestNotSeen`] if no status packet showed the arm at rest. Servo mode is left in any case, if
    /// possible; [`ErrorKind::ServoModeNotLeft`] if it cannot be left, or that is not known, with the session's own
    /// error if there is one. [`ErrorKind::SessionEnded`] if the session had ended before.
    pub fn land(mut self) -> Result<End, Error> {
        if let Some(end) = self.ended.take() {
            return Err(end.into_error());
        }
        let landed = self.come_to_rest();
        self.leave_landed(landed, None)?;
        Ok(self.landed())
    }

    /// Lands as [`land`](Self::land), on another braking path. A guard that trips before the arm is at rest is an
    /// error, too.
    pub(crate) fn land_by(&mut self, braking: BrakingPath<'_>, supervision: &Supervision<'_>) -> Result<(), Error> {
        let landed = self.come_to_rest_by(braking);
        self.leave_landed(landed, supervision.check_tripped().err())
    }

    /// End of a session that has landed because the program said so, with its report.
    pub(crate) fn landed(&mut self) -> End {
        let cause = if self.rest.was_seen() { Cause::Landed } else { Cause::RestNotSeen };
        End::new(cause, self.rest, self.take_report())
    }

    /// Report of a session that has ended.
    pub(crate) fn take_report(&mut self) -> Report {
        self.report.waited = self.since.passed();
        std::mem::take(&mut self.report)
    }

    /// After a landing, during which a guard may have tripped.
    fn leave_landed(&mut self, landed: Result<(), Error>, tripped: Option<Error>) -> Result<(), Error> {
        let answers = self.last_answers();
        let left = self.leave();
        let first = answers.err().or(self.refusal.take()).or(self.check_news().err()).or(tripped);
        let first = first.map(|error| self.explained(error));
        let first = match (first, landed) {
            // The error of a lost connection says so itself.
            (Some(first), Err(landing)) if !first.is_disconnected() => Some(not_seen(first, landing)),
            (first, landed) => first.or(landed.err()).map(|error| self.explained(error)),
        };
        let ended = match (first, left) {
            (first, Ok(())) => first.map_or(Ok(()), Err),
            (first, Err(leaving)) => Err(not_left(first, leaving)),
        };
        let rest = if self.rest.was_seen() { "is at rest" } else { "was not seen at rest" };
        let link = self.arm.link();
        match &ended {
            Ok(()) => link.record_motion(MotionStep::Done, || format!("the set-points have ended, and the arm {rest}")),
            Err(error) => link.record_motion(MotionStep::Failed, || error.kind().to_string()),
        }
        ended
    }

    fn last_answers(&mut self) -> Result<(), Error> {
        let since = self.arm.clock().stopwatch();
        let mut pace = Pace::new(self.arm.clock(), CYCLE, Duration::ZERO);
        while self.arm.link().outstanding(self.owner) > 0 && since.passed() < PATIENCE {
            self.take_answers(ServoJ::INFO.name)?;
            pace.wait();
        }
        // The last set-point has its period, too.
        self.pace.wait();
        Ok(())
    }

    /// Ends the session because of an error: by a landing, where set-points are still followed, and servo mode is left.
    pub(crate) fn end(&mut self, first: Error) -> Error {
        let mut straight_on = self.straight_on();
        self.end_by(first, &mut |course| straight_on.next(course))
    }

    /// Ends the session as [`end`](Self::end), on another braking path.
    pub(crate) fn end_by(&mut self, first: Error, braking: BrakingPath<'_>) -> Error {
        self.has_departed = matches!(first.kind(), ErrorKind::Departed { .. });
        let landed =
            if self.is_open && braking_after(&first) == Braking::Land { self.come_to_rest_by(braking) } else { Ok(()) };
        let left = if self.is_open { self.leave() } else { Ok(()) };
        let first = self.explained(first);
        let error = match (landed, left) {
            (Ok(()), Ok(())) => first,
            (Err(landing), Ok(())) => not_seen(first, landing),
            (_, Err(leaving)) => not_left(Some(first), leaving),
        };
        self.ended = Some(SessionEnd::of(&error));
        self.end_lead();
        self.arm.link().record_motion(MotionStep::Failed, || error.kind().to_string());
        drop(self.priority.take());
        error
    }

    /// Settles the cause of the end: news of packets counts before what followed from the same event, such as the
    /// refusal of a set-point. Packets are later than a refusal, so that the next ones are waited for; braking and
    /// leaving servo mode are over by then.
    fn explained(&mut self, error: Error) -> Error {
        if error.is_refused() && self.arm.unacknowledged().is_none() {
            let (state, since) = (&self.arm.state, self.since_packet);
            let seen = state.newest_packet().map_or(0, |packet| packet.number);
            // If none comes, none shows it.
            let _ = state.watch(SETTLING, |newest| {
                let is_later = newest.is_some_and(|newest| newest.number > seen);
                let is_settled = is_later && !state.has_unconfirmed_news();
                (is_settled || state.news(since, |_| true).is_some()).then_some(())
            });
        }
        self.look_for_news();
        if let Some(news) = self.news.clone().filter(|news| counts_before(news, &error)) {
            return self.ended_by(news);
        }
        if !error.is_refused() {
            return error;
        }
        let error = self.arm.explained(error, PATIENCE);
        match error.cause() {
            // By the controller's own answer, before packets that come seldom show it.
            Cause::NotPowered | Cause::NotEnabled => self.ended_by(error.occurrence()),
            _ => error,
        }
    }

    /// Leaves servo mode, and asks whether it was left.
    ///
    /// Only the answer to the query counts: the next reply of the command's name may be the late one to the command
    /// that entered servo mode, and waiting for a second one that was lost would cost the connection, and the stop with
    /// it.
    pub(super) fn leave(&mut self) -> Result<(), Error> {
        self.is_open = false;
        self.expect_set_point(false);
        // Another thread that reads may have received replies meanwhile.
        let (answers, unanswered) = self.arm.link().forget_posted(self.owner);
        self.count(answers);
        self.report.unanswered += unanswered;
        let off = self.arm.ask(&SetServoMode::new(Switch::Off))?;
        let left = self.wait_until_left(&off, unanswered);
        self.arm.link().forget(&off);
        self.end_lead();
        left
    }

    /// Set-points that were not answered may be queued on a link that stalls. If the end of servo mode is not answered
    /// either, the connection is reset, so that the system discards those that it has queued.
    fn wait_until_left(&mut self, off: &Sent<'_>, unanswered: u64) -> Result<(), Error> {
        let since = self.arm.clock().stopwatch();
        let mut pace = Pace::new(self.arm.clock(), CYCLE, Duration::ZERO);
        loop {
            let client = self.arm.client();
            let timeout = if unanswered > 0 { PATIENCE } else { client.timeout_of(IsInServomove::INFO) };
            match client.call_within(&IsInServomove::new(), timeout) {
                Ok(reply) if !reply.in_servo_mode => return Ok(()),
                Ok(_) if since.passed() > PATIENCE => return Err(self.still_in_servo_mode(off)),
                Ok(_) => drop(pace.wait()),
                Err(error) if unanswered > 0 && matches!(error.kind(), jaka_sync::ErrorKind::Timeout { .. }) => {
                    let link = client.link();
                    let cause = link.reset(Disconnect::Reset { unanswered });
                    let (address, command) = (link.address(), Some(SetServoMode::INFO.name.to_owned()));
                    let kind = jaka_sync::ErrorKind::Disconnected { address, command, sent: true, cause };
                    return Err(self.arm.attach(kind));
                }
                Err(error) => return Err(error.into()),
            }
        }
    }

    /// The command was refused, or was acknowledged and not carried out.
    fn still_in_servo_mode(&mut self, off: &Sent<'_>) -> Error {
        let answer = self.arm.link().poll(off, Duration::ZERO, &mut String::new(), &mut TextOnly);
        answer.err().map_or_else(|| self.arm.not_ready(ServoModeState::NotLeft), Error::from)
    }
}

fn not_left(first: Option<Error>, leaving: Error) -> Error {
    let exchanges = leaving.exchanges().to_vec();
    Error::from(ErrorKind::ServoModeNotLeft { first, leaving }).with_exchanges(exchanges)
}

/// True if news of packets is the cause of the end, and not this error. A stop of the program's own may have led to the
/// news.
fn counts_before(news: &Occurrence, error: &Error) -> bool {
    news.cause <= error.cause() && (error.cause() != Cause::Stopped || news.consequence().latches())
}

impl Drop for ServoSession<'_> {
    fn drop(&mut self) {
        if self.is_open {
            let landed = self.come_to_rest();
            if let Err(error) = self.leave().and(landed) {
                log::warn!(target: "jaka_robot", "the servo session that was dropped did not end at rest: {error}");
            }
        }
    }
}

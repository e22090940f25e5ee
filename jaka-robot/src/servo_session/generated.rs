//! Set-points that are generated within limits, for streams and for the following of trajectories.

use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_motion::{Beyond, Checker};
use jaka_proto::Command;
use jaka_proto::messages::servo::ServoJ;
use jaka_proto::messages::types::JointPosition;

use super::ServoSession;
use super::departure::Departure;
use super::lag::LagFit;
use super::pace::Pace;
use super::set_point::SetPoint;
use crate::arm::Arm;
use crate::cause::shown_joints;
use crate::guard::{MeasuredLag, SetPointGuard};
use crate::{Error, ErrorKind, FollowLag, NotShown, Snapshot, Unchecked};

/// Source of set-points, one a cycle.
pub(crate) trait SetPoints {
    /// True if no more are to come.
    fn is_done(&mut self) -> bool;

    /// The next one.
    fn next(&mut self) -> JointPosition;

    /// True if the last one depends on the selected frames.
    fn depend_on_frames(&self) -> bool;

    /// No set-point had come when one was due: the next one starts from standstill.
    fn paused(&mut self);

    /// The last one was not sent.
    fn take_back(&mut self);

    /// The last one was sent.
    fn sent(&mut self);
}

/// Supervision that ends generated set-points: by joints that do not follow, a machine that is too slow, and a guard.
#[derive(Debug)]
pub(crate) struct Supervision<'g> {
    max_departure_deg: f64,
    /// The number of the last packet.
    packet: u64,
    /// Arrival of the first packet after which none has shown the joints.
    unseen: Option<Instant>,
    max_gap: Duration,
    guard: Option<&'g SetPointGuard>,
    /// True if the guard depends on the selected frames.
    depends_on_frames: bool,
    lag: Option<LagFit>,
}

impl<'g> Supervision<'g> {
    pub(crate) fn new(
        max_departure_deg: f64,
        max_gap: Duration,
        guard: Option<&'g SetPointGuard>,
        lag: Option<LagFit>,
    ) -> Self {
        let depends_on_frames = guard.is_some_and(SetPointGuard::depends_on_frames);
        Self { max_departure_deg, packet: 0, unseen: None, max_gap, guard, depends_on_frames, lag }
    }

    /// Fails once the guard has tripped.
    pub(super) fn check_tripped(&self) -> Result<(), Error> {
        self.guard.map_or(Ok(()), |guard| guard.check_tripped(|| self.measured_lag()))
    }

    /// Lag of the arm behind its set-points; `None` if it is not measured, or not known.
    pub(crate) fn lag(&self) -> Option<FollowLag> {
        self.lag.as_ref().and_then(LagFit::best)
    }

    /// Lag as [`lag`](Self::lag), also if it is known only to be beyond the measured range.
    fn measured_lag(&self) -> Option<MeasuredLag> {
        self.lag.as_ref().and_then(LagFit::measured)
    }

    /// A set-point was sent.
    fn sent(&mut self, at: impl FnOnce() -> Instant, joints: JointPosition) {
        if let Some(lag) = &mut self.lag {
            lag.sent(at(), joints);
        }
    }

    /// Compares the joints of a packet, if it shows them. Fails if none has for half a second.
    fn take(&mut self, packet: &Snapshot, departure: &Departure) -> Result<(), Error> {
        self.packet = packet.number;
        match shown_joints(packet) {
            Ok(joints) => {
                self.unseen = None;
                departure.check(joints)?;
                if let Some(lag) = &mut self.lag {
                    lag.seen(packet.received, joints);
                }
                Ok(())
            }
            Err(reason) => {
                let since = *self.unseen.get_or_insert(packet.received);
                let is_long = packet.received.saturating_duration_since(since) >= UNSEEN;
                if is_long { Err(not_shown(reason)) } else { Ok(()) }
            }
        }
    }
}

/// Longest time for which packets may come that do not show the joints.
const UNSEEN: Duration = Duration::from_millis(500);

fn not_shown(reason: NotShown) -> Error {
    ErrorKind::NotShown { what: "the joints follow their set-points".to_owned(), reason }.into()
}

/// Fails if packets do not show the joints, so that it would not be known whether these follow. Where no packets
/// come, something else decides.
pub(crate) fn check_shows_joints(arm: &Arm, timeout: Duration) -> Result<(), Error> {
    let packet = arm.known_status(timeout)?;
    packet.map_or(Ok(()), |packet| shown_joints(&packet).map(drop).map_err(not_shown))
}

impl ServoSession<'_> {
    /// Checker of the set-points, and joint positions at the start; `None` if the robot has no limits.
    pub(crate) fn checker_and_start(&self) -> Option<(&Checker, JointPosition)> {
        Some((self.limits.checker()?, self.last_joints()?))
    }

    /// Makes the first cycle due now, so that computing after servo mode was entered does not make it late.
    pub(crate) fn begin_pace(&mut self) {
        self.pace = Pace::new(self.arm.clock(), self.config.period(), self.config.busy_wait);
    }

    /// Joint positions of the last set-point, where they are known.
    pub(crate) fn last_joints(&self) -> Option<JointPosition> {
        self.course.last_joints().map(|[_, last]| last)
    }

    /// Sends a set-point in each cycle until no more are to come. After an error the session is to be ended.
    pub(crate) fn send_all(
        &mut self,
        set_points: &mut impl SetPoints,
        supervision: &mut Supervision<'_>,
    ) -> Result<(), Error> {
        self.departure.most_deg = supervision.max_departure_deg;
        loop {
            let cycle = self.wait_for_cycle();
            // The arm is taken to stand: it had no set-points for so long.
            if cycle.as_ref().map_or(true, |late| *late >= self.config.gap()) {
                set_points.paused();
            }
            let guarded =
                supervision.guard.map_or(Ok(()), |guard| guard.check(&self.arm.state, || supervision.measured_lag()));
            // A packet by which the guard has tripped is known by now. In other frames the tool is elsewhere.
            self.look_at_frames();
            self.check_news()?;
            if self.limits.depend_on_frames() || supervision.depends_on_frames {
                self.check_frames()?;
            }
            guarded?;
            // Before the end: a motion that has no set-point when one is due does not end as commanded.
            let late = cycle?;
            if set_points.is_done() {
                return Ok(());
            }
            if late > supervision.max_gap {
                return Err(ErrorKind::SetPointLate { late }.into());
            }
            if let Some(packet) = self.packet_after(supervision.packet) {
                supervision.take(&packet, &self.departure)?;
            }
            let joints = set_points.next();
            if set_points.depend_on_frames() {
                self.check_frames().inspect_err(|_| set_points.take_back())?;
            }
            self.take_answers(ServoJ::INFO.name).inspect_err(|_| set_points.take_back())?;
            let sent = self.send_checked(SetPoint::Joints(joints), Some(joints), supervision.max_gap);
            sent.inspect_err(|_| set_points.take_back())?;
            supervision.sent(|| self.arm.clock().now(), joints);
            set_points.sent();
        }
    }

    /// The newest packet, unless it has this number.
    fn packet_after(&self, number: u64) -> Option<Arc<Snapshot>> {
        self.arm.state.newest_packet().filter(|packet| packet.number != number)
    }
}

pub(crate) fn beyond_limit(beyond: Beyond) -> Error {
    ErrorKind::BeyondLimit { command: ServoJ::INFO.name.to_owned(), beyond }.into()
}

pub(crate) fn no_limits() -> Error {
    ErrorKind::NotChecked { command: ServoJ::INFO.name.to_owned(), reason: Unchecked::NoLimits }.into()
}

//! Pauses, speeds and stops, from any thread.

use std::sync::Arc;
use std::time::Duration;

use super::config::check_scale;
use super::orders::Orders;
use crate::error::OptionName;
#[cfg(feature = "serde")]
use crate::form;
use crate::{Cause, End, Error, Report, Rest, TrajectoryReport};

/// Pauses, slows down and stops a [`FollowRun`](super::FollowRun), from any thread; all of it along the trajectory.
#[derive(Debug, Clone)]
pub struct FollowHandle {
    pub(super) orders: Arc<Orders>,
    pub(super) duration: Duration,
}

/// Progress on a trajectory.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FollowProgress {
    /// The trajectory time of the last set-point; the arm lags behind it.
    #[cfg_attr(feature = "serde", serde(rename = "time_s", serialize_with = "form::seconds"))]
    pub time: Duration,
    /// Duration of the trajectory at its own speed.
    #[cfg_attr(feature = "serde", serde(rename = "duration_s", serialize_with = "form::seconds"))]
    pub duration: Duration,
    /// Rate at which the trajectory time passes: from 0 in a pause to 1.
    pub rate: f64,
}

impl FollowHandle {
    /// Slows down to a standstill on the trajectory, within the accelerations of motions, and stays there until
    /// [`resume`](Self::resume).
    ///
    /// # Errors
    /// [`ErrorKind::SessionEnded`](crate::ErrorKind::SessionEnded) if the run has ended.
    pub fn pause(&self) -> Result<(), Error> {
        self.check_open().map(|()| self.orders.pause())
    }

    /// Brakes to a standstill on the trajectory as [`stop`](Self::stop) does, and stays there until
    /// [`resume`](Self::resume).
    ///
    /// # Errors
    /// As [`pause`](Self::pause).
    pub fn pause_by_stop(&self) -> Result<(), Error> {
        self.check_open().map(|()| self.orders.pause_by_stop())
    }

    /// Goes on after a [`pause`](Self::pause), up to the speed scale.
    ///
    /// # Errors
    /// As [`pause`](Self::pause).
    pub fn resume(&self) -> Result<(), Error> {
        self.check_open().map(|()| self.orders.resume())
    }

    /// Changes the rate: 1 for the trajectory's own speed, which is the most, down to 0 for a standstill. Ends a pause.
    ///
    /// # Errors
    /// As [`pause`](Self::pause); [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) for a scale that is not
    /// from 0 to 1.
    pub fn set_speed_scale(&self, scale: f64) -> Result<(), Error> {
        check_scale(OptionName::new("FollowHandle", "speed_scale"), scale)?;
        self.check_open().map(|()| self.orders.set_scale(scale))
    }

    /// Brakes to a standstill on the trajectory, within the accelerations of stops
    /// ([`Limits::stop_accelerations`](jaka_motion::Limits::stop_accelerations)), and ends the run there.
    ///
    /// It returns at once; [`FollowRun::wait`](super::FollowRun::wait) returns when the arm is at rest. It is none of
    /// the robot's stops: nothing must be acknowledged after it, and where set-points do not reach the controller it
    /// has no effect. [`RobotStop`](crate::RobotStop) brakes likewise, and then sends `stop_program`.
    ///
    /// # Errors
    /// As [`pause`](Self::pause).
    pub fn stop(&self) -> Result<(), Error> {
        self.check_open().map(|()| self.orders.stop())
    }

    /// Progress of the run on its trajectory.
    pub fn progress(&self) -> FollowProgress {
        let (time_s, rate) = self.orders.progress();
        FollowProgress { time: Duration::from_secs_f64(time_s).min(self.duration), duration: self.duration, rate }
    }

    /// True once the run has ended: then [`FollowRun::wait`](super::FollowRun::wait) returns at once.
    pub fn has_ended(&self) -> bool {
        self.orders.ended().is_some()
    }

    /// End of a run after a panic of its thread; the session is braked straight on.
    pub(super) fn lost(&self, error: Error) -> End {
        let progress = self.progress();
        let trajectory = TrajectoryReport {
            reached: progress.time,
            duration: progress.duration,
            has_left_curve: progress.rate > 0.0,
            lag: None,
        };
        let report = Report::default().of_trajectory(trajectory);
        End { error: Some(error), ..End::new(Cause::Failed, Rest::NotSeen, report) }
    }

    fn check_open(&self) -> Result<(), Error> {
        self.orders.ended().map_or(Ok(()), |end| Err(end.clone().into_error()))
    }
}

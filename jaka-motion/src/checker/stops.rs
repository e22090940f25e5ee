//! The ways of joints to a stop, each as soon as it can.

use super::amounts::{ROUNDING, START_ROUNDING};
use super::landing::as_landing;
use super::{Checker, rounded_up};
use crate::beyond::{Exceeded, Found};
use crate::braking::Stop;
use crate::limits::Point;

/// The most periods of a way to rest in which the speed of the tool centre point is compared.
const MOST_PERIODS: f64 = 4096.0;

impl Checker {
    /// Checks the way from one set-point to the next and from there to rest: joint ranges, regions, and the speed of the tool centre point as mean over
    /// each period, and that it goes on for no more than `stopping_mm`. Where an arm has rested, if it has, counts as within regions.
    pub(crate) fn check_stops(
        &self,
        rested: Option<&[f64; 6]>,
        last: &[f64; 6],
        stops: &[Stop; 6],
        (period_s, stopping_mm): (f64, f64),
    ) -> Result<(), Exceeded> {
        self.stops_in_ranges(stops)?;
        let next = stops.map(|stop| stop.at(0.0).position);
        if !self.limits.regions().is_empty() {
            self.regions_on_joint_way(last, &next).map_err(|(exceeded, _)| exceeded)?;
            self.regions_on_stops(rested, stops).map_err(|(exceeded, _)| as_landing(exceeded))?;
        }
        self.tcp_on_stops(last, stops, period_s, stopping_mm)
    }

    fn stops_in_ranges(&self, stops: &[Stop; 6]) -> Result<(), Exceeded> {
        let (min, max) = (self.limits.joint_min(), self.limits.joint_max());
        for (index, stop) in stops.iter().enumerate() {
            let (least, most) = stop.span();
            for (end_deg, limit_deg) in [(least, min[index]), (most, max[index])] {
                if end_deg < min[index] - ROUNDING || end_deg > max[index] + ROUNDING {
                    return Err(Exceeded::LandingRange { joint: index + 1, end_deg, limit_deg });
                }
            }
        }
        Ok(())
    }

    fn regions_on_stops(&self, rested: Option<&[f64; 6]>, stops: &[Stop; 6]) -> Result<(), Found> {
        let seconds = longest(stops);
        let turned = stops.map(|stop| stop.top_speed().to_radians() * seconds);
        let swung = stops.map(|stop| stop.top_acceleration().to_radians() * seconds * seconds);
        self.limited_points().try_for_each(|point| {
            let at = |share: f64| self.point(point, &stops.map(|stop| stop.at(share * seconds).position));
            let start = rested.map(|joints| self.point(point, joints));
            self.along_from(point, start, 0.0, self.course_of_swings(point, &turned, &swung), at)
        })
    }

    fn tcp_on_stops(&self, last: &[f64; 6], stops: &[Stop; 6], period_s: f64, limit_mm: f64) -> Result<(), Exceeded> {
        let Some(limit_mm_s) = self.limits.tcp_speed() else { return Ok(()) };
        let (seconds, mut done, mut way_mm) = (longest(stops), 0.0, 0.0);
        if seconds > MOST_PERIODS * period_s {
            return Err(Exceeded::TooLong);
        }
        let mut before = self.point(Point::Tcp, last);
        loop {
            let here = self.point(Point::Tcp, &stops.map(|stop| stop.at(done).position));
            let step_mm = (here - before).norm();
            let speed_mm_s = step_mm / period_s;
            way_mm += step_mm;
            if speed_mm_s > rounded_up(limit_mm_s) + START_ROUNDING / period_s {
                return Err(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s });
            }
            if way_mm > limit_mm {
                return Err(Exceeded::LandingWay { way_mm, limit_mm });
            }
            if done >= seconds {
                return Ok(());
            }
            (before, done) = (here, done + period_s);
        }
    }
}

pub(crate) fn longest(stops: &[Stop; 6]) -> f64 {
    stops.iter().map(Stop::seconds).fold(0.0, f64::max)
}

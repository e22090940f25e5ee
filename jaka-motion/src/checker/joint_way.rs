//! Ways straight in joint space.

use nalgebra::Vector3;

use super::amounts::LEAST_STEP;
use super::pace::JointPace;
use super::points::Course;
use super::{Checker, rounded_up};
use crate::beyond::{Exceeded, Found};
use crate::limits::Point;

impl Checker {
    pub(super) fn joint_way(&self, from: &[f64; 6], to: &[f64; 6], pace: JointPace) -> Result<(), Found> {
        let at_end = |exceeded| (exceeded, 1.0);
        pace.check().map_err(at_end)?;
        // Each joint turns one way only, so what holds at both ends holds between them.
        self.within_ranges(to, from).map_err(at_end)?;
        let moved: [f64; 6] = std::array::from_fn(|index| to[index] - from[index]);
        if longest(&moved) > 0.0 {
            self.joint_pace(&moved, pace).map_err(at_end)?;
            self.tcp_speed_on_joint_way(from, &moved, pace)?;
        }
        self.regions_on_joint_way(from, to)
    }

    /// The regions alone.
    pub(super) fn regions_on_joint_way(&self, from: &[f64; 6], to: &[f64; 6]) -> Result<(), Found> {
        let moved: [f64; 6] = std::array::from_fn(|index| to[index] - from[index]);
        self.limited_points().try_for_each(|point| {
            let at = |share| self.point(point, &on_way(from, &moved, share));
            self.along(point, 0.0, self.course(point, &moved), at)
        })
    }

    /// The speed and acceleration of each joint, where the one with the longest way has those of the pace.
    fn joint_pace(&self, moved: &[f64; 6], pace: JointPace) -> Result<(), Exceeded> {
        let longest = longest(moved);
        let worst = |most: &[f64; 6]| {
            let over = |index: usize| moved[index].abs() / longest / most[index];
            let index = (0..6).fold(0, |worst, index| if over(index) > over(worst) { index } else { worst });
            (index, moved[index].abs() / longest, most[index])
        };
        let (index, part, limit_deg_s) = worst(self.limits.joint_speeds());
        let speed_deg_s = part * pace.speed_deg_s;
        if speed_deg_s > rounded_up(limit_deg_s) {
            return Err(Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near: None });
        }
        let (index, part, limit_deg_s2) = worst(self.limits.joint_accelerations());
        let Some(acceleration) = pace.acceleration_deg_s2 else {
            return Err(Exceeded::NoAcceleration { most_deg_s2: limit_deg_s2 / part });
        };
        let acceleration_deg_s2 = part * acceleration;
        if acceleration_deg_s2 > rounded_up(limit_deg_s2) {
            return Err(Exceeded::JointAcceleration { joint: index + 1, acceleration_deg_s2, limit_deg_s2 });
        }
        Ok(())
    }

    fn tcp_speed_on_joint_way(&self, from: &[f64; 6], moved: &[f64; 6], pace: JointPace) -> Result<(), Found> {
        let Some(limit_mm_s) = self.limits.tcp_speed() else { return Ok(()) };
        let seconds = longest(moved) / pace.speed_deg_s;
        let (most, course) = (limit_mm_s * seconds, self.course(Point::Tcp, moved));
        if course.rate_mm <= most {
            return Ok(());
        }
        let mut share = 0.0;
        loop {
            let rate = self.tcp_rate(&on_way(from, moved, share), moved);
            if rate > rounded_up(most) {
                return Err((Exceeded::TcpSpeed { speed_mm_s: rate / seconds, limit_mm_s }, share));
            }
            if share >= 1.0 {
                return Ok(());
            }
            let step = ((1.0 + Self::AMOUNT_SPEED) * most - rate) / course.bend_mm;
            if step.is_nan() || step < LEAST_STEP {
                return Err((Exceeded::TooLong, share));
            }
            share = f64::min(share + step, 1.0);
        }
    }

    /// How far the tool centre point would move if the joints went on so, in mm.
    pub(crate) fn tcp_rate(&self, joints: &[f64; 6], moved: &[f64; 6]) -> f64 {
        let frames = self.limits.model().links.frames(joints);
        let tcp = (frames[5] * self.tool).translation.vector;
        let parts = frames.iter().zip(moved).map(|(frame, moved)| {
            (frame.rotation * Vector3::z()).cross(&(tcp - frame.translation.vector)) * moved.to_radians()
        });
        parts.sum::<Vector3<f64>>().norm()
    }

    /// How far apart the tool centre point is at two joint positions, in mm.
    pub(crate) fn tcp_distance(&self, one: &[f64; 6], other: &[f64; 6]) -> f64 {
        (self.point(Point::Tcp, one) - self.point(Point::Tcp, other)).norm()
    }

    /// How a point goes while the joints move by these degrees.
    fn course(&self, point: Point, moved: &[f64; 6]) -> Course {
        self.course_of_turns(point, &moved.map(|degrees| degrees.abs().to_radians()))
    }

    /// How a point goes while the joints turn by at most these radians.
    pub(super) fn course_of_turns(&self, point: Point, turned: &[f64; 6]) -> Course {
        let (mut rate_mm, mut bend_mm, mut sum) = (0.0, 0.0, 0.0);
        for (radius, turned) in self.radii(point).iter().zip(turned) {
            rate_mm += turned * radius;
            // The turn of one joint changes how another moves the point: at most by the turns' product times the outer one's distance.
            bend_mm += (2.0 * sum + turned) * turned * radius;
            sum += turned;
        }
        Course { rate_mm, bend_mm }
    }

    /// The same where the turns themselves change by at most these radians.
    pub(super) fn course_of_swings(&self, point: Point, turned: &[f64; 6], swung: &[f64; 6]) -> Course {
        let course = self.course_of_turns(point, turned);
        let swings: f64 = self.radii(point).iter().zip(swung).map(|(radius, swung)| radius * swung).sum();
        Course { bend_mm: course.bend_mm + swings, ..course }
    }
}

fn on_way(from: &[f64; 6], moved: &[f64; 6], share: f64) -> [f64; 6] {
    std::array::from_fn(|index| from[index] + share * moved[index])
}

fn longest(moved: &[f64; 6]) -> f64 {
    moved.iter().fold(0.0, |longest, moved| longest.max(moved.abs()))
}

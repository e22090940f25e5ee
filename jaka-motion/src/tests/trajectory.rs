//! Trajectories: what all their tests share.

mod hostile;
mod reserve;
mod timed;

use super::Random;
use crate::{Checker, Frames, Limits, Model, TimedPoint, Trajectory};

/// Well within all limits.
const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];

fn zu5() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn checker() -> Checker {
    Checker::new(zu5(), Frames::new())
}

/// Points at random around [`HOME`], from 0.2 to 2 seconds apart.
fn some_points(random: &mut Random, count: usize) -> Vec<TimedPoint> {
    let mut time_s = 0.0;
    let point = |_| {
        let joints = HOME.map(|joint| joint + random.between(-10.0, 10.0));
        let point = TimedPoint::new(time_s, joints);
        time_s += random.between(0.2, 2.0);
        point
    };
    (0..count).map(point).collect()
}

/// The points at as many times their times as it takes to be within the limits.
fn slow_enough(points: &[TimedPoint], checker: &Checker) -> (Vec<TimedPoint>, Trajectory) {
    let mut points = points.to_vec();
    for _ in 0..40 {
        if let Ok(trajectory) = Trajectory::timed(&points, checker) {
            return (points, trajectory);
        }
        points.iter_mut().for_each(|point| {
            point.time_s *= 1.3;
            point.velocity = point.velocity.map(|speeds| speeds.map(|speed| speed / 1.3));
            point.acceleration = point.acceleration.map(|all| all.map(|one| one / 1.3 / 1.3));
        });
    }
    panic!("no time is enough")
}

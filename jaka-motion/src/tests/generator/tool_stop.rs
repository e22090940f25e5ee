//! A tool that must be able to stop soon.

use super::{Random, Watched, joints};
use crate::{Checker, Dynamics, Frames, Goal, Limits, Model, TcpVelocity, VelocityFrame};

const START: [f64; 6] = [0.0, 100.0, 80.0, 90.0, -90.0, 0.0];
/// Duration of the path to a target at the permitted speed, in seconds.
const SECONDS: f64 = 2.0;

/// Zu 5 with a limit of the tool's speed, in mm/s, and of its travel to rest, in mm.
struct Slow {
    arm: Watched,
    period_s: f64,
    speed: f64,
    within: f64,
}

impl Slow {
    /// Creates the arm as for packets each 30 ms and a reaction of 20 ms.
    fn new(acceleration: f64, period_s: f64, overtravel: f64) -> Self {
        let unbraked_s = 0.05 + 2.0 * period_s;
        let speed = overtravel / (unbraked_s + 0.1);
        let within = overtravel - speed * unbraked_s;
        let limits = Limits::of(&Model::default()).with_joint_accelerations([acceleration; 6]).expect("above 0");
        let dynamics = Dynamics::of(&limits);
        let mut arm = Watched::with(&Checker::new(limits, Frames::new()), dynamics, START, period_s);
        arm.generator = arm.generator.with_tool_stop(speed, within).expect("above 0");
        Self { arm, period_s, speed, within }
    }

    /// Makes the next set-point, and checks the speed and the travel of the tool to rest.
    fn next(&mut self, goal: &Goal) {
        let before = self.arm.generator.joints().0;
        let here = self.arm.next(goal).joints.0;
        let step = moved(before, here);
        assert!(step <= self.speed * self.period_s * (1.0 + 1e-6) + 1e-8, "{step} mm: {:?}", self.arm.generator);
        let (mut stopping, mut way, mut last) = (self.arm.generator.clone(), step, here);
        while !stopping.is_at_rest() {
            let next = stopping.next(&Goal::Rest).joints.0;
            way += moved(last, next);
            last = next;
        }
        assert!(way <= self.within * (1.0 + 1e-6) + 1e-8, "{way} mm of {} mm", self.within);
    }

    /// Returns the duration of this many set-points, as a share of the path's duration at the permitted speed.
    fn times(&self, set_points: u32) -> f64 {
        f64::from(set_points) * self.period_s / SECONDS
    }
}

fn moved(from: [f64; 6], to: [f64; 6]) -> f64 {
    let [from, to] = [from, to].map(|joints| Model::default().forward(joints).position_mm());
    (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt()
}

/// Runs a test at any period and for any overtravel, also if the first step with the full jerk is too much.
fn each_slow_arm(mut then: impl FnMut(Slow, &str)) {
    for acceleration in [72.0, 200.0, 720.0] {
        for period_s in [0.008, 0.016, 0.032, 0.064, 0.096] {
            for overtravel in [0.1, 0.5, 2.0] {
                let slow = Slow::new(acceleration, period_s, overtravel);
                then(slow, &format!("{acceleration} deg/s², {period_s} s, {overtravel} mm"));
            }
        }
    }
}

fn by(towards: [f64; 6], share: f64) -> [f64; 6] {
    std::array::from_fn(|joint| START[joint] + share * towards[joint])
}

#[test]
fn targets_are_reached_straight_and_about_as_soon_as_the_tool_may() {
    for towards in [[10.0, -5.0, 5.0, 0.0, 0.0, 30.0], [-4.0, 3.0, 9.0, -20.0, 15.0, 7.0]] {
        each_slow_arm(|mut slow, name| {
            let share = slow.speed * SECONDS / (1e3 * moved(START, by(towards, 1e-3)));
            let (target, mut count) = (by(towards, share), 0);
            while slow.arm.generator.joints().max_distance(&target.into()) > 1e-6 {
                slow.next(&joints(target));
                count += 1;
                assert!(slow.times(count) < 2.0, "{name}: {:?}", slow.arm.generator);
                let here = slow.arm.generator.joints();
                let along = (here.0[0] - START[0]) / towards[0];
                assert!(here.max_distance(&by(towards, along).into()) < 1e-6, "{name}: {here:?}");
            }
        });
    }
}

#[test]
fn a_velocity_of_the_tool_is_reached_as_far_as_it_may_be() {
    each_slow_arm(|mut slow, name| {
        let linear_mm_s = [0.0, 0.6 * slow.speed, 0.8 * slow.speed];
        let goal = TcpVelocity { linear_mm_s, angular_deg_s: [0.0; 3], frame: VelocityFrame::ArmBase };
        let mut count = 0;
        while moved(START, slow.arm.generator.joints().0) < slow.speed * SECONDS {
            slow.next(&Goal::TcpVelocity(goal));
            count += 1;
            assert!(slow.times(count) < 2.0, "{name}: {:?}", slow.arm.generator);
        }
    });
}

#[test]
fn speeds_of_joints_are_reached_in_proportion_as_far_as_the_tool_may() {
    let speeds = [10.0, -5.0, 5.0, 0.0, 0.0, 30.0];
    each_slow_arm(|mut slow, name| {
        let mut count = 0;
        while moved(START, slow.arm.generator.joints().0) < slow.speed * SECONDS {
            slow.next(&Goal::Velocity(speeds));
            count += 1;
            assert!(slow.times(count) < 2.0, "{name}: {:?}", slow.arm.generator);
        }
        let share = (slow.arm.generator.joints().0[0] - START[0]) / speeds[0];
        assert!(slow.arm.generator.joints().max_distance(&by(speeds, share).into()) < 1e-3, "{name}");
    });
}

#[test]
fn goals_that_change_leave_the_tool_slow() {
    let mut random = Random::new(91);
    each_slow_arm(|mut slow, name| {
        for _ in 0..12 {
            let mut some = |size: f64| [0.0; 6].map(|_: f64| random.between(-size, size));
            let (target, speeds) = (by(some(3.0), 1.0), some(20.0));
            for goal in [joints(target), Goal::Velocity(speeds)] {
                for _ in 0..5 {
                    slow.next(&goal);
                }
            }
        }
        assert!(moved(START, slow.arm.generator.joints().0) > 0.0, "{name}");
    });
}

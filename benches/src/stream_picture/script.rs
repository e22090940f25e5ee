//! Goals of the stream in the picture, and the set-points that result.

use std::error::Error;

use jaka_motion::{Checker, Dynamics, Frames, Generator, Goal, Limits, Model};
use jaka_proto::messages::types::JointPosition;

use crate::planning::PERIOD;

/// A change of the goal.
pub(super) struct Moment {
    /// Name of the goal.
    pub(super) name: &'static str,
    goal: Goal,
    /// The number of the first set-point that is on the way to it.
    first: u32,
}

/// Position, speed or acceleration.
pub(super) struct Quantity {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    /// The most in both directions, of each joint of the picture.
    pub(super) limit: f64,
    /// Of each joint of the picture: seconds, and the value then.
    pub(super) curves: [Vec<(f64, f64)>; 2],
}

/// The joints of the picture; the others rest.
pub(super) const JOINTS: [usize; 2] = [1, 6];
/// Length of the picture in seconds: time of the last set-point.
pub(super) const END_S: f64 = 7.0;
const LAST: u32 = 875;

pub(super) const MOMENTS: [Moment; 5] = [
    Moment { name: "rest", goal: Goal::Rest, first: 0 },
    Moment { name: "target", goal: Goal::Joints(turned(50.0, -20.0)), first: 50 },
    Moment { name: "another target", goal: Goal::Joints(turned(-10.0, 40.0)), first: 200 },
    Moment { name: "velocity", goal: Goal::Velocity([30.0, 0.0, 0.0, 0.0, 0.0, -40.0]), first: 550 },
    Moment { name: "landing", goal: Goal::Rest, first: 700 },
];

const START: JointPosition = turned(-30.0, 10.0);
/// In degrees, as a user would give it.
const RANGE: f64 = 60.0;
/// In deg/s, as a user would give it.
const SPEED: f64 = 45.0;

impl Moment {
    /// Time of the change, in seconds.
    pub(super) fn at_s(&self) -> f64 {
        f64::from(self.first) * PERIOD
    }
}

/// Positions, speeds and accelerations of the joints of the picture, of which the latter two are differences of
/// set-points.
pub(super) fn quantities() -> Result<[Quantity; 3], Box<dyn Error>> {
    let mut limits = Limits::of(Model::named("Zu 5").ok_or("there is no Zu 5")?).with_joint_speeds([SPEED; 6])?;
    for joint in JOINTS {
        limits = limits.with_joint_range(joint, -RANGE, RANGE)?;
    }
    let dynamics = Dynamics::of(&limits);
    let acceleration = dynamics.accelerations()[0];
    let generator = Generator::new(&Checker::new(limits, Frames::new()), dynamics, START, PERIOD)?;
    let set_points = set_points(generator);
    let positions = JOINTS.map(|joint| set_points.iter().map(|set_point| set_point.0[joint - 1]).collect::<Vec<_>>());
    let speeds = positions.each_ref().map(|positions| rates(positions));
    let accelerations = speeds.each_ref().map(|speeds| rates(speeds));
    Ok([
        Quantity { name: "position", unit: "deg", limit: RANGE, curves: positions.map(timed) },
        Quantity { name: "speed", unit: "deg/s", limit: SPEED, curves: speeds.map(timed) },
        Quantity { name: "acceleration", unit: "deg/s²", limit: acceleration, curves: accelerations.map(timed) },
    ])
}

impl Quantity {
    /// The limit, or the largest value where that is larger.
    pub(super) fn most(&self) -> f64 {
        self.curves.iter().flatten().map(|(_, value)| value.abs()).fold(self.limit, f64::max)
    }
}

const fn turned(joint_1: f64, joint_6: f64) -> JointPosition {
    JointPosition([joint_1, 60.0, -80.0, 190.0, -90.0, joint_6])
}

/// All that the script makes of it, one a period.
fn set_points(mut generator: Generator) -> Vec<JointPosition> {
    let goal = |number| &MOMENTS.iter().rfind(|moment| moment.first <= number).unwrap_or(&MOMENTS[0]).goal;
    (0..=LAST).map(|number| generator.next(goal(number)).joints).collect()
}

/// The difference from the previous value, divided by the period; 0 for the first value, before which the arm rested.
fn rates(values: &[f64]) -> Vec<f64> {
    let differences = values.windows(2).map(|pair| (pair[1] - pair[0]) / PERIOD);
    std::iter::once(0.0).chain(differences).collect()
}

fn timed(values: Vec<f64>) -> Vec<(f64, f64)> {
    (0u32..).map(|number| f64::from(number) * PERIOD).zip(values).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of both joints at a set-point.
    fn at(quantity: &Quantity, number: u32) -> [f64; 2] {
        let number = usize::try_from(number).expect("a small number");
        quantity.curves.each_ref().map(|curve| curve[number].1)
    }

    #[test]
    fn the_picture_shows_what_its_page_says() {
        let [positions, speeds, accelerations] = quantities().expect("the script fits the arm");
        for quantity in [&positions, &speeds, &accelerations] {
            let lands_s = MOMENTS[MOMENTS.len() - 1].at_s();
            let beyond = |(at_s, value): &&(f64, f64)| *at_s < lands_s && value.abs() > quantity.limit * (1.0 + 1e-9);
            assert_eq!(quantity.curves.iter().flatten().find(beyond), None, "{}", quantity.name);
        }
        assert!((350.0..570.0).contains(&accelerations.most()), "a stop: {} deg/s²", accelerations.most());
        let [rest, target, other, velocity, landing] = MOMENTS.map(|moment| moment.first);
        assert_eq!((at(&positions, rest), at(&positions, target - 1)), ([-30.0, 10.0], [-30.0, 10.0]));
        assert!(at(&speeds, other - 1)[0] > 44.0, "far from the first target, and fast");
        assert!(at(&positions, other - 1)[0] < 20.0);
        let [reached, wanted] = [at(&positions, velocity - 1), [-10.0, 40.0]];
        assert!(
            (0..2).all(|joint| (reached[joint] - wanted[joint]).abs() < 1e-5),
            "the other one is reached: {reached:?}"
        );
        let fast = at(&speeds, landing - 1);
        assert!((fast[0] - 30.0).abs() < 0.1 && (fast[1] + 40.0).abs() < 0.1, "at speed: {fast:?}");
        let first_at_rest = (landing..=LAST).find(|number| at(&speeds, *number).iter().all(|speed| speed.abs() < 1e-9));
        let first_at_rest = first_at_rest.expect("it ends at rest");
        let braked_for = f64::from(first_at_rest - landing) * PERIOD;
        assert!((0.165..0.175).contains(&braked_for), "{braked_for} s");
    }
}

//! Motion of `jaka move` and `jaka jog` before it is sent: its description in words, and its comparison with limits as
//! far as possible without the command port.

use itertools::Itertools as _;
use jaka_motion::{Beyond, Checker, Exceeded, Frames, JointSpeed, Limits};
use jaka_robot::types::JointPosition;

use crate::arm::units::other_unit;
use crate::failure::Failure;

/// Target of a motion, with joints and axes by their index.
#[derive(Debug, Clone, Copy)]
pub(crate) enum MoveTarget {
    /// Joint positions, in deg.
    Joints([f64; 6]),
    /// One joint, and its angle, in deg.
    Joint(usize, f64),
    /// Pose at the end of a straight line, in mm and deg.
    Pose([f64; 6]),
    /// One axis, and the distance of the tool centre point along it, in mm.
    Line(usize, f64),
}

/// Motion to send.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Planned {
    pub(crate) goal: MoveTarget,
    /// Speed, in deg/s or mm/s.
    pub(crate) speed: f64,
    /// Acceleration, in deg/s² or mm/s²; `None` for the controller's default.
    pub(crate) acceleration: Option<f64>,
}

/// Returns this value at one index, and 0 elsewhere.
pub(crate) fn only_at(index: usize, by: f64) -> [f64; 6] {
    std::array::from_fn(|other| if other == index { by } else { 0.0 })
}

impl MoveTarget {
    pub(crate) fn is_of_joints(self) -> bool {
        matches!(self, Self::Joints(_) | Self::Joint(..))
    }
}

impl Planned {
    /// Describes the motion, from these joint positions if known.
    pub(crate) fn told(&self, from: Option<JointPosition>) -> String {
        let Self { goal, speed, acceleration } = self;
        let unit = if goal.is_of_joints() { "deg/s" } else { "mm/s" };
        let acceleration = acceleration.map_or_else(
            || "the controller's own acceleration".to_owned(),
            |acceleration| format!("an acceleration of {acceleration} {unit}²"),
        );
        let asked = format!("at {speed} {unit} scaled by the rapid rate, with {acceleration}");
        match (*goal, from) {
            (MoveTarget::Joints(to), from) => {
                let longest =
                    from.map_or_else(|| "the joint that turns furthest".to_owned(), |from| longest(from.0, to));
                format!("go to the joint positions {} deg: {longest} {asked}", list(&to))
            }
            (MoveTarget::Joint(at, by), Some(from)) => {
                let (joint, from, to) = (at + 1, in_tenths(from.0[at]), in_tenths(from.0[at] + by));
                format!("turn joint {joint} by {by} deg, from {from} to {to} deg, {asked}")
            }
            (MoveTarget::Joint(at, by), None) => format!("turn joint {} by {by} deg, {asked}", at + 1),
            (MoveTarget::Pose(to), _) => {
                let (position, rotation) = to.split_at(3);
                let (position, rotation) = (list(position), list(rotation));
                format!(
                    "move its tool centre point in a straight line to {position} mm (x, y, z) and {rotation} deg (rx, ry, rz), {asked}"
                )
            }
            (MoveTarget::Line(at, by), _) => {
                let axis = ["x", "y", "z"][at];
                format!("move its tool centre point by {by} mm along {axis} of the selected user frame, {asked}")
            }
        }
    }

    /// Compares the motion with the limits of joints and of the requested speed, from these joint positions if known.
    /// Without them, it does not compare a target with ranges, since an arm beyond a range may be moved back. The check
    /// with the controller's tool and frames covers the limits that depend on these.
    pub(crate) fn check(&self, limits: &Limits, from: Option<JointPosition>) -> Result<(), Failure> {
        match (self.goal, from) {
            (MoveTarget::Joints(to), Some(from)) => self.check_way(limits, from.0, to),
            (MoveTarget::Joints(_), None) => Ok(()),
            (MoveTarget::Joint(at, by), Some(from)) => {
                let turned = only_at(at, by);
                self.check_way(limits, from.0, std::array::from_fn(|joint| from.0[joint] + turned[joint]))
            }
            (MoveTarget::Joint(at, by), None) => {
                // Path within the range, on which only the speed can exceed a limit.
                let (least, most) = (*limits.joint_min(), *limits.joint_max());
                let mut to = least;
                to[at] += by.abs().min(most[at] - least[at]);
                self.check_way(limits, least, to)
            }
            (MoveTarget::Pose(_) | MoveTarget::Line(..), _) => match limits.tcp_speed() {
                Some(limit) if self.speed > limit => Err(Failure::NotSent(format!(
                    "`moveL` was not sent: the tool centre point would move at {} mm/s; limit {limit} ({})",
                    self.speed,
                    limits.model().name()
                ))),
                _ => Ok(()),
            },
        }
    }

    fn check_way(&self, limits: &Limits, from: [f64; 6], to: [f64; 6]) -> Result<(), Failure> {
        let asked = JointSpeed { speed_deg_s: self.speed, acceleration_deg_s2: self.acceleration };
        let checked = of_joints(limits).check_joint_way(from.into(), to.into(), asked);
        checked.map_err(|beyond| {
            let hint = hint(&beyond).unwrap_or_default();
            Failure::NotSent(format!("`joint_move` was not sent: {beyond}{hint}"))
        })
    }
}

/// Returns the limits without a dependency on the tool or frames: ranges, speeds and accelerations of joints.
fn of_joints(limits: &Limits) -> Checker {
    let mut own = Limits::of(limits.model());
    for (joint, (least, most)) in (1..).zip(limits.joint_min().iter().zip(limits.joint_max())) {
        // Values from limits are within them.
        own = own.clone().with_joint_range(joint, *least, *most).unwrap_or(own);
    }
    own = own.clone().with_joint_speeds(*limits.joint_speeds()).unwrap_or(own);
    own = own.clone().with_joint_accelerations(*limits.joint_accelerations()).unwrap_or(own);
    Checker::new(own, Frames::new())
}

fn hint(beyond: &Beyond) -> Option<String> {
    match beyond.exceeded {
        Exceeded::JointSpeed { speed_deg_s, .. } => other_unit(speed_deg_s, "at most deg/s"),
        Exceeded::JointAcceleration { acceleration_deg_s2, .. } => other_unit(acceleration_deg_s2, "at most deg/s²"),
        _ => None,
    }
}

/// Returns the joint that turns furthest, and its angle in deg, in words.
fn longest(from: [f64; 6], to: [f64; 6]) -> String {
    let ways: [f64; 6] = std::array::from_fn(|joint| to[joint] - from[joint]);
    let at = (0..6).fold(0, |longest, at| if ways[at].abs() > ways[longest].abs() { at } else { longest });
    format!("joint {}, which turns furthest ({} deg),", at + 1, in_tenths(ways[at]))
}

/// Rounds to tenths, without a negative zero.
fn in_tenths(degrees: f64) -> f64 {
    (degrees * 10.0).round() / 10.0 + 0.0
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().join(", ")
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use jaka_motion::Model;

    use super::*;

    const HERE: [f64; 6] = [0.0, 90.0, 90.0, 90.0, -90.0, 12.25];

    #[track_caller]
    fn check(goal: MoveTarget, from: Option<[f64; 6]>, expected: &Expect) {
        expected.assert_eq(&Planned { goal, speed: 20.0, acceleration: Some(50.0) }.told(from.map(JointPosition)));
    }

    #[test]
    fn a_motion_is_told_with_its_units() {
        let to = MoveTarget::Joints([0.0, 90.0, 85.5, 90.0, -90.0, 10.0]);
        check(
            to,
            Some(HERE),
            &expect![
                "go to the joint positions 0, 90, 85.5, 90, -90, 10 deg: joint 3, which turns furthest (-4.5 deg), at 20 deg/s scaled by the rapid rate, with an acceleration of 50 deg/s²"
            ],
        );
        check(
            to,
            None,
            &expect![
                "go to the joint positions 0, 90, 85.5, 90, -90, 10 deg: the joint that turns furthest at 20 deg/s scaled by the rapid rate, with an acceleration of 50 deg/s²"
            ],
        );
        check(
            MoveTarget::Joint(5, -2.5),
            Some(HERE),
            &expect![
                "turn joint 6 by -2.5 deg, from 12.3 to 9.8 deg, at 20 deg/s scaled by the rapid rate, with an acceleration of 50 deg/s²"
            ],
        );
        check(
            MoveTarget::Joint(5, -2.5),
            None,
            &expect![
                "turn joint 6 by -2.5 deg, at 20 deg/s scaled by the rapid rate, with an acceleration of 50 deg/s²"
            ],
        );
        check(
            MoveTarget::Pose([-400.0, 100.0, 450.0, 180.0, 0.0, 90.0]),
            None,
            &expect![
                "move its tool centre point in a straight line to -400, 100, 450 mm (x, y, z) and 180, 0, 90 deg (rx, ry, rz), at 20 mm/s scaled by the rapid rate, with an acceleration of 50 mm/s²"
            ],
        );
        let line = Planned { goal: MoveTarget::Line(2, -10.0), speed: 20.0, acceleration: None };
        expect!["move its tool centre point by -10 mm along z of the selected user frame, at 20 mm/s scaled by the rapid rate, with the controller's own acceleration"].assert_eq(&line.told(None));
    }

    #[test]
    fn what_is_known_is_compared() {
        let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
        let limits = limits
            .with_tcp_speed(250.0)
            .and_then(|limits| limits.with_joint_range(3, -100.0, 100.0))
            .expect("they are tighter");
        let is_within = |goal, speed, from: Option<[f64; 6]>| {
            let planned = Planned { goal, speed, acceleration: Some(50.0) };
            planned.check(&limits, from.map(JointPosition)).is_ok()
        };
        let to = |joint_3| MoveTarget::Joints([0.0, 90.0, joint_3, 90.0, -90.0, 0.0]);
        assert!(is_within(to(99.0), 20.0, Some(HERE)) && !is_within(to(101.0), 20.0, Some(HERE)));
        let outside = [0.0, 90.0, 120.0, 90.0, -90.0, 0.0];
        assert!(is_within(to(101.0), 20.0, Some(outside)), "it leads back");
        assert!(is_within(to(101.0), 20.0, None), "it may lead back");
        assert!(
            is_within(MoveTarget::Joint(2, 5.0), 20.0, Some(HERE))
                && !is_within(MoveTarget::Joint(2, 15.0), 20.0, Some(HERE))
        );
        for by in [-5.0, 5.0, 900.0] {
            assert!(
                is_within(MoveTarget::Joint(2, by), 180.0, None) && !is_within(MoveTarget::Joint(2, by), 190.0, None),
                "{by}"
            );
        }
        assert!(is_within(MoveTarget::Line(0, 5.0), 250.0, None) && !is_within(MoveTarget::Line(0, 5.0), 251.0, None));
    }
}

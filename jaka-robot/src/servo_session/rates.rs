//! Rates of set-points, by which the arm is also braked.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::check::InvalidArgument;
use jaka_proto::messages::servo::{ServoJ, ServoP};

use super::set_point::length;
use super::set_point::{SetPoint, SetPointStep};
use crate::Error;
use crate::error::OptionName;

/// Greatest speeds and accelerations of set-points, by which the arm is also braked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rates {
    /// False if set-points are sent as they are. The arm is braked all the same.
    pub(super) are_checked: bool,
    /// Of each joint, in deg/s².
    pub(super) joint_acceleration: [f64; 6],
    /// Of a joint that slows down, in deg/s².
    pub(super) joint_deceleration: [f64; 6],
    /// Of the tool centre point, in mm/s.
    pub(super) tcp_speed: f64,
    /// In mm/s².
    pub(super) tcp_acceleration: f64,
}

/// The greatest speed of a joint in servo mode, in deg/s (4.15).
const JOINT_SPEED: f64 = 180.0;

/// Greatest speed and acceleration of a turn of the tool, in deg/s and deg/s²: ours, as fast as three joints of the
/// wrist turn it together.
const TURN_SPEED: f64 = 540.0;
const TURN_ACCELERATION: f64 = 2160.0;

/// Rounding error of a step. Where joints are a hundred degrees from zero, their differences have some 14 digits.
const ROUNDING: f64 = 1e-9;

/// Sizes of a step: of six joints, or of the tool centre point's position and of its orientation.
type Sizes = [f64; 6];

/// The document advises 720 deg/s² for joints (4.7) and 8000 mm/s² for the tool centre point (4.9) at most; 3000 mm/s
/// is ours.
impl Default for Rates {
    fn default() -> Self {
        let all_joints = [720.0; 6];
        Self {
            are_checked: true,
            joint_acceleration: all_joints,
            joint_deceleration: all_joints,
            tcp_speed: 3000.0,
            tcp_acceleration: 8000.0,
        }
    }
}

impl Rates {
    /// Checks a step, and its difference from the previous one. It judges each set-point by its nominal period, as the
    /// controller does (4.15).
    pub(super) fn check(
        &self,
        step: &SetPointStep,
        before: &SetPointStep,
        period: Duration,
    ) -> Result<(), InvalidArgument> {
        if !self.are_checked {
            return Ok(());
        }
        let (speeds, accelerations) = self.of(step);
        let time = period.as_secs_f64();
        if let Some((index, size, most)) = first_beyond(&sizes(step), &speeds.map(|speed| speed * time)) {
            let unit = unit(step, index);
            let value = format!("a step of {size:.3} {unit}");
            let allowed = format!("a step of at most {most:.3} {unit} each {period:?} ({} {unit}/s)", speeds[index]);
            return Err(refused(step, index, value, allowed));
        }
        let Some(change) = step.change_from(before) else { return Ok(()) };
        let accelerations = self.slowing(step, before, time).unwrap_or(accelerations);
        let most = accelerations.map(|acceleration| acceleration * time * time);
        let Some((index, size, most)) = first_beyond(&sizes(&change), &most) else { return Ok(()) };
        let unit = unit(step, index);
        let from = if before.is_none() { "standstill" } else { "the step before" };
        let value = format!("a step that differs by {size:.3} {unit} from {from}");
        let allowed =
            format!("a change of at most {most:.3} {unit} each {period:?} ({} {unit}/s²)", accelerations[index]);
        Err(refused(step, index, value, allowed))
    }

    /// Greatest accelerations of joints of which some slow down, or turn round within that of a motion; none for poses.
    fn slowing(&self, step: &SetPointStep, before: &SetPointStep, time: f64) -> Option<Sizes> {
        let (SetPointStep::Joints(step), SetPointStep::Joints(before)) = (step, before) else { return None };
        Some(std::array::from_fn(|joint| {
            let turned = (step[joint] * before[joint].signum()).min(0.0).abs() / time / time;
            let slows = step[joint].abs() < before[joint].abs() && turned <= self.joint_acceleration[joint];
            if slows { self.joint_deceleration[joint] } else { self.joint_acceleration[joint] }
        }))
    }

    /// Refuses a set-point at an unknown distance from the previous one.
    pub(super) fn check_unknown(&self, set_point: &SetPoint) -> Result<(), InvalidArgument> {
        if !self.are_checked {
            return Ok(());
        }
        let (command, field) = match set_point {
            SetPoint::Joints(_) | SetPoint::JointOffset(_) => (ServoJ::INFO.name, "joint_position"),
            SetPoint::Pose(_) | SetPoint::PoseOffset(_) => (ServoP::INFO.name, "pose"),
        };
        let value = "a set-point at an unknown distance from the previous one".to_owned();
        let allowed = "a set-point of the same kind as the previous one, or a new servo session".to_owned();
        Err(InvalidArgument::new(command, field, value, allowed))
    }

    /// True if the arm can be as fast as a step asks.
    pub(super) fn is_reachable(&self, step: &SetPointStep, period: Duration) -> bool {
        let (speeds, _) = self.of(step);
        first_beyond(&sizes(step), &speeds.map(|speed| speed * period.as_secs_f64())).is_none()
    }

    /// Checks that these are numbers with which an arm can brake.
    pub(super) fn check_themselves(&self) -> Result<(), Error> {
        let rates = [
            ("max_joint_acceleration", self.joint_acceleration[0], "deg/s²"),
            ("max_tcp_speed", self.tcp_speed, "mm/s"),
            ("max_tcp_acceleration", self.tcp_acceleration, "mm/s²"),
        ];
        rates
            .into_iter()
            .try_for_each(|(name, rate, unit)| OptionName::new("SessionConfig", name).check_at_least(rate, unit))
    }

    /// Number of periods in which the arm is braked from this step: the n-th set-point of them goes on by
    /// `1 - n / count` of it.
    pub(super) fn periods_to_brake(&self, step: &SetPointStep, period: Duration) -> u32 {
        let time = period.as_secs_f64();
        let (_, accelerations) = self.of(step);
        let periods = sizes(step).into_iter().zip(accelerations).map(|(size, most)| size / (most * time * time));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cast takes the nearest that fits"
        )]
        let count = (periods.fold(0.0, f64::max) - ROUNDING).ceil() as u32;
        count
    }

    /// The greatest speeds and accelerations of a step of this kind.
    fn of(&self, step: &SetPointStep) -> (Sizes, Sizes) {
        match step {
            SetPointStep::Joints(_) => ([JOINT_SPEED; 6], self.joint_acceleration),
            SetPointStep::Pose(_) => {
                let (mut speeds, mut accelerations) = ([f64::INFINITY; 6], [f64::INFINITY; 6]);
                (speeds[0], speeds[1]) = (self.tcp_speed, TURN_SPEED);
                (accelerations[0], accelerations[1]) = (self.tcp_acceleration, TURN_ACCELERATION);
                (speeds, accelerations)
            }
        }
    }
}

fn sizes(step: &SetPointStep) -> Sizes {
    match step {
        SetPointStep::Joints(step) => step.map(f64::abs),
        SetPointStep::Pose([x, y, z, rx, ry, rz]) => {
            [length([*x, *y, *z]), length([*rx, *ry, *rz]), 0.0, 0.0, 0.0, 0.0]
        }
    }
}

/// The first excess, and its amount. The encoder refuses a number that is not finite.
fn first_beyond(sizes: &Sizes, most: &Sizes) -> Option<(usize, f64, f64)> {
    (0..6).find(|index| sizes[*index] > most[*index] + ROUNDING).map(|index| (index, sizes[index], most[index]))
}

fn unit(step: &SetPointStep, index: usize) -> &'static str {
    if matches!(step, SetPointStep::Pose(_)) && index == 0 { "mm" } else { "deg" }
}

fn refused(step: &SetPointStep, index: usize, value: String, allowed: String) -> InvalidArgument {
    let (command, field) = match step {
        SetPointStep::Joints(_) => (ServoJ::INFO.name, format!("joint_position[{index}]")),
        SetPointStep::Pose(_) => (ServoP::INFO.name, "pose".to_owned()),
    };
    InvalidArgument::new(command, field, value, allowed)
}

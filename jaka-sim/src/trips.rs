//! What makes the drives stop the arm.

use std::error::Error;
use std::fmt;
use std::str::FromStr;

/// The events of the first joint's drive, by the vendor's table of controller events; those of the others follow at this distance.
const SPEED: u32 = 0x10_8482;
const SPEED_DEVIATION: u32 = 0x10_8485;
const DEVIATION: u32 = 0x10_8611;
const COMMAND_SPEED: u32 = 0x10_8612;
const COMMAND_ACCELERATION: u32 = 0x10_8613;
const COMMAND_ERROR: u32 = 0x10_8614;
const NEXT_JOINT: u32 = 0x1_0000;

/// A threshold beyond which a joint's drive stops the arm with an error event.
///
/// The vendor's table of controller events says what trips, and not at which values: without
/// [`Builder::trips`](crate::Builder::trips) nothing does. A trip puts its event into the error code, ends servo mode and halts the
/// arm where it is; further set-points are refused as outside servo mode. In the codes, `n` is the joint, from 0 to 5.
///
/// Positions and speeds of the arm are looked at in each cycle of each motion. Set-points are compared with the one before, each
/// over its nominal period whenever it came; the first, and one that comes more than 100 ms after the one before, with rest. They are
/// looked at as they were sent, before the filter.
///
/// A trip has a text form, as `jaka sim --trips` takes it: `deviation 1.5`. It is what `Display` writes and `FromStr` reads.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Trip {
    /// A joint is so many degrees from its commanded position: event `0x1n8611`. `deviation 1.5` as a text.
    Deviation(f64),
    /// A joint is faster, in deg/s: event `0x1n8482`. `speed 180` as a text.
    Speed(f64),
    /// A joint's speed is so far from its commanded one, in deg/s: event `0x1n8485`. `speed-deviation 30` as a text.
    SpeedDeviation(f64),
    /// A set-point asks for a greater speed of a joint, in deg/s: event `0x1n8612`. `command-speed 180` as a text.
    ///
    /// Set-points of more than 180 deg/s (4.15) have no effect where they do not trip.
    CommandSpeed(f64),
    /// A set-point asks for a greater acceleration of a joint, in deg/s²: event `0x1n8613`. `command-acceleration 2000` as a text.
    CommandAcceleration(f64),
}

type Kind = (&'static str, fn(f64) -> Trip);

/// The kinds, by their names.
const KINDS: [Kind; 5] = [
    ("deviation", Trip::Deviation),
    ("speed", Trip::Speed),
    ("speed-deviation", Trip::SpeedDeviation),
    ("command-speed", Trip::CommandSpeed),
    ("command-acceleration", Trip::CommandAcceleration),
];

/// The text is not that of a [`Trip`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TripError {
    text: String,
}

/// What the drives know of the arm's motion in a cycle, of each joint.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Observed {
    /// In degrees.
    pub(crate) deviation: [f64; 6],
    /// In deg/s.
    pub(crate) speed: [f64; 6],
    /// In deg/s.
    pub(crate) speed_deviation: [f64; 6],
}

/// The event of the arm's motion in a cycle, if there is one.
pub(crate) fn of_motion(trips: &[Trip], observed: &Observed) -> Option<u32> {
    trips.iter().find_map(|trip| match *trip {
        Trip::Deviation(most) => event(DEVIATION, observed.deviation, most),
        Trip::Speed(most) => event(SPEED, observed.speed, most),
        Trip::SpeedDeviation(most) => event(SPEED_DEVIATION, observed.speed_deviation, most),
        Trip::CommandSpeed(_) | Trip::CommandAcceleration(_) => None,
    })
}

/// The event of a set-point that asks for these speeds and accelerations, if there is one.
pub(crate) fn of_set_point(trips: &[Trip], speed: [f64; 6], acceleration: [f64; 6]) -> Option<u32> {
    trips.iter().find_map(|trip| match *trip {
        Trip::CommandSpeed(most) => event(COMMAND_SPEED, speed, most),
        Trip::CommandAcceleration(most) => event(COMMAND_ACCELERATION, acceleration, most),
        Trip::Deviation(_) | Trip::Speed(_) | Trip::SpeedDeviation(_) => None,
    })
}

/// The event of set-points that have stopped at these speeds: that of the fastest joint.
pub(crate) fn command_error(speed: [f64; 6]) -> u32 {
    let fastest = speed.iter().map(|speed| speed.abs()).fold(0.0, f64::max);
    let joints = speed.iter().zip(0..);
    let joint = joints.into_iter().find(|(speed, _)| speed.abs() >= fastest).map_or(0, |(_, joint)| joint);
    COMMAND_ERROR + joint * NEXT_JOINT
}

/// The event of the first joint whose value is greater. What is greater by rounding is not.
fn event(code: u32, values: [f64; 6], most: f64) -> Option<u32> {
    let codes = (0..).map(|joint| code + joint * NEXT_JOINT);
    values.iter().zip(codes).find(|(value, _)| value.abs() > most * (1.0 + 1e-9) + 1e-9).map(|(_, code)| code)
}

impl Trip {
    fn threshold(self) -> f64 {
        match self {
            Self::Deviation(most)
            | Self::Speed(most)
            | Self::SpeedDeviation(most)
            | Self::CommandSpeed(most)
            | Self::CommandAcceleration(most) => most,
        }
    }
}

impl fmt::Display for TripError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not a trip; the trips, each with a threshold, are", self.text)?;
        let names = KINDS.iter().enumerate();
        names.into_iter().try_for_each(|(i, (name, _))| write!(f, "{} `{name} 1`", if i == 0 { "" } else { "," }))
    }
}

impl Error for TripError {}

impl fmt::Display for Trip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let threshold = self.threshold();
        let name = KINDS.iter().find(|(_, kind)| kind(threshold) == *self).map_or("", |(name, _)| name);
        write!(f, "{name} {threshold}")
    }
}

impl FromStr for Trip {
    type Err = TripError;

    /// Reads the text form of a trip.
    ///
    /// # Errors
    /// There is no such trip, or its threshold is not a number from 0.
    fn from_str(text: &str) -> Result<Self, TripError> {
        let read = || {
            let (name, threshold) = text.trim().split_once(' ')?;
            let (_, kind) = KINDS.iter().find(|(kind, _)| *kind == name)?;
            threshold.trim().parse().ok().filter(|most: &f64| *most >= 0.0 && most.is_finite()).map(kind)
        };
        read().ok_or_else(|| TripError { text: text.trim().to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_trip_has_a_text() {
        for (name, kind) in KINDS {
            assert_eq!(kind(1.5).to_string(), format!("{name} 1.5"));
            assert_eq!(format!(" {name}  1.5 ").parse(), Ok(kind(1.5)));
        }
        for text in ["", "speed", "speed -1", "speed x", "speed inf", "speed 1 2", "sped 1"] {
            assert!(text.parse::<Trip>().is_err(), "{text}");
        }
        assert_eq!(
            "sped 1".parse::<Trip>().expect_err("there is no such trip").to_string(),
            "`sped 1` is not a trip; the trips, each with a threshold, are `deviation 1`, `speed 1`, `speed-deviation 1`, \
             `command-speed 1`, `command-acceleration 1`"
        );
    }

    #[test]
    fn an_event_names_its_joint() {
        let trips = [Trip::CommandSpeed(10.0), Trip::CommandAcceleration(100.0)];
        let one = |joint: usize, value: f64| std::array::from_fn(|i| if i == joint { value } else { 0.0 });
        assert_eq!(of_set_point(&trips, one(0, -10.1), [0.0; 6]), Some(0x10_8612));
        assert_eq!(of_set_point(&trips, [10.0; 6], one(5, 101.0)), Some(0x15_8613));
        assert_eq!(of_set_point(&trips, [10.0; 6], [100.0; 6]), None);
        assert_eq!(command_error(one(3, -0.5)), 0x13_8614);
    }
}

//! Thresholds at which the drives stop the arm.

use crate::fault::{kinds, quoted};

/// Events of the first joint's drive, in the vendor's table of controller events; those of the other joints follow at
/// this distance.
const SPEED: u32 = 0x10_8482;
const SPEED_DEVIATION: u32 = 0x10_8485;
const DEVIATION: u32 = 0x10_8611;
const COMMAND_SPEED: u32 = 0x10_8612;
const COMMAND_ACCELERATION: u32 = 0x10_8613;
const COMMAND_ERROR: u32 = 0x10_8614;
const NEXT_JOINT: u32 = 0x1_0000;

kinds! {
    /// Threshold beyond which a joint's drive stops the arm with an error event.
    ///
    /// The vendor's table of controller events gives the conditions, but not their values: without
    /// [`Builder::trips`](crate::Builder::trips) there are none. A trip puts its event into the error code, ends servo
    /// mode and halts the arm in its position; the controller then refuses set-points as outside servo mode. In the
    /// codes, `n` is the joint, from 0 to 5.
    ///
    /// The drives check positions and speeds of the arm in each cycle of each motion. They compare a set-point with the
    /// previous one, each over its nominal period regardless of its arrival time. They compare the first set-point, and
    /// one more than 100 ms after the previous one, with rest. They check set-points as sent, before the filter.
    ///
    /// A trip has a text form, as for `jaka sim --trips`: `deviation 1.5`. `Display` writes it and `FromStr` reads it.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum Trip("a trip", unknown);

    /// Returns the event for the observation, if the threshold is exceeded.
    pub(crate) fn event(&self, observed: &Observed) -> Option<u32>;

    /// Greatest distance of a joint from its commanded position, in degrees: event `0x1n8611`. `deviation 1.5` as a
    /// text.
    Deviation(most: f64 as threshold = 1.0): "deviation" => event(DEVIATION, observed.deviation, *most);

    /// Greatest speed of a joint, in deg/s: event `0x1n8482`. `speed 180` as a text.
    Speed(most: f64 as threshold = 1.0): "speed" => event(SPEED, observed.speed, *most);

    /// Greatest difference of a joint's speed from its commanded one, in deg/s: event `0x1n8485`. `speed-deviation 30`
    /// as a text.
    SpeedDeviation(most: f64 as threshold = 1.0): "speed-deviation" => event(SPEED_DEVIATION, observed.speed_deviation, *most);

    /// Greatest joint speed that a set-point may command, in deg/s: event `0x1n8612`. `command-speed 180` as a text.
    ///
    /// Set-points of more than 180 deg/s (4.15) without a trip have no effect.
    CommandSpeed(most: f64 as threshold = 1.0): "command-speed" => event(COMMAND_SPEED, observed.command_speed, *most);

    /// Greatest joint acceleration that a set-point may command, in deg/s²: event `0x1n8613`.
    /// `command-acceleration 2000` as a text.
    CommandAcceleration(most: f64 as threshold = 1.0): "command-acceleration" => event(COMMAND_ACCELERATION, observed.command_acceleration, *most);
}

fn unknown(_word: &str) -> String {
    format!("unknown trip; the trips, each with a threshold, are {}", quoted(&Trip::one_of_each()))
}

/// Values that the drives observe in a cycle, of the arm's motion or of a set-point: for each joint, in degrees, deg/s
/// and deg/s².
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Observed {
    pub(crate) deviation: [f64; 6],
    pub(crate) speed: [f64; 6],
    pub(crate) speed_deviation: [f64; 6],
    pub(crate) command_speed: [f64; 6],
    pub(crate) command_acceleration: [f64; 6],
}

/// Returns the event for an observation, if there is one.
pub(crate) fn error(trips: &[Trip], observed: &Observed) -> Option<u32> {
    trips.iter().find_map(|trip| trip.event(observed))
}

/// Returns the event for set-points that stopped at these speeds: that of the fastest joint.
pub(crate) fn command_error(speed: [f64; 6]) -> u32 {
    let fastest = speed.iter().map(|speed| speed.abs()).fold(0.0, f64::max);
    let joints = speed.iter().zip(0..);
    let joint = joints.into_iter().find(|(speed, _)| speed.abs() >= fastest).map_or(0, |(_, joint)| joint);
    COMMAND_ERROR + joint * NEXT_JOINT
}

/// Returns the event of the first joint with a greater value. A difference by rounding does not count.
fn event(code: u32, values: [f64; 6], most: f64) -> Option<u32> {
    let codes = (0..).map(|joint| code + joint * NEXT_JOINT);
    values.iter().zip(codes).find(|(value, _)| value.abs() > most * (1.0 + 1e-9) + 1e-9).map(|(_, code)| code)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_trip_has_a_text() {
        for trip in Trip::one_of_each() {
            assert_eq!(trip.to_string().parse(), Ok(trip));
            assert_eq!(format!(" {} ", trip.to_string().replace(' ', "  ")).parse(), Ok(trip));
        }
        assert_eq!(Trip::SpeedDeviation(1.5).to_string(), "speed-deviation 1.5");
        for text in ["", "speed", "speed -1", "speed x", "speed inf", "speed 1 2", "sped 1"] {
            assert!(text.parse::<Trip>().is_err(), "{text}");
        }
        assert_eq!(
            "sped 1".parse::<Trip>().expect_err("there is no such trip").to_string(),
            "`sped`: unknown trip; the trips, each with a threshold, are `deviation 1`, `speed 1`, `speed-deviation 1`, \
             `command-speed 1`, `command-acceleration 1`"
        );
        assert_eq!(
            "speed x".parse::<Trip>().expect_err("that is not a number").to_string(),
            "`x`: expected a threshold, a number from 0"
        );
    }

    #[test]
    fn an_event_names_its_joint() {
        let trips = [Trip::CommandSpeed(10.0), Trip::CommandAcceleration(100.0)];
        let one = |joint: usize, value: f64| std::array::from_fn(|i| if i == joint { value } else { 0.0 });
        let of_set_point = |command_speed, command_acceleration| {
            error(&trips, &Observed { command_speed, command_acceleration, ..Observed::default() })
        };
        assert_eq!(of_set_point(one(0, -10.1), [0.0; 6]), Some(0x10_8612));
        assert_eq!(of_set_point([10.0; 6], one(5, 101.0)), Some(0x15_8613));
        assert_eq!(of_set_point([10.0; 6], [100.0; 6]), None);
        assert_eq!(command_error(one(3, -0.5)), 0x13_8614);
    }
}

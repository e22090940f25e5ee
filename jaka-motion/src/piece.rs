//! Part of a motion of the joints: for each joint a polynomial of time of at most the fifth degree.

pub(crate) mod bernstein;

use jaka_proto::messages::types::JointPosition;

use self::bernstein::{differences, largest, part, peak, sum, value, weights};

/// Joint positions at one moment, with their speeds and accelerations.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sample {
    /// Joint positions.
    #[cfg_attr(feature = "serde", serde(rename = "joints_deg"))]
    pub joints: JointPosition,
    /// Speed of each joint, in deg/s.
    #[cfg_attr(feature = "serde", serde(rename = "velocity_deg_s"))]
    pub velocity: [f64; 6],
    /// Acceleration of each joint, in deg/s².
    #[cfg_attr(feature = "serde", serde(rename = "acceleration_deg_s2"))]
    pub acceleration: [f64; 6],
}

/// Polynomial of time for each joint.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub(crate) start_s: f64,
    pub(crate) seconds: f64,
    from: [f64; 6],
    /// Bernstein coefficients of each joint, in degrees from its start, without the first, which is 0.
    way: [[f64; 5]; 6],
}

/// Bounds of a piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hull {
    /// Lowest and highest position of each joint, in degrees.
    positions: [[f64; 2]; 6],
    /// Upper bound of each joint's speed, in deg/s.
    pub(crate) speeds: [f64; 6],
    /// Upper bound of each joint's acceleration, in deg/s².
    pub(crate) accelerations: [f64; 6],
}

impl Hull {
    /// Whether all positions are between these; false if one is not a number.
    pub(crate) fn is_between(&self, least: &[f64; 6], most: &[f64; 6]) -> bool {
        let between = |joint: usize| {
            let [lowest, highest] = self.positions[joint];
            // With NaN this is false.
            least[joint] <= lowest && lowest <= highest && highest <= most[joint]
        };
        (0..6).all(between)
    }

    /// Returns the greatest turn of each joint in this time, in radians.
    pub(crate) fn turned(&self, seconds: f64) -> [f64; 6] {
        self.speeds.map(|speed| speed.to_radians() * seconds)
    }

    /// Returns the greatest change of that turn, in radians.
    pub(crate) fn swung(&self, seconds: f64) -> [f64; 6] {
        self.accelerations.map(|acceleration| acceleration.to_radians() * seconds * seconds)
    }
}

impl Piece {
    /// Creates the piece from one sample to another, with the speeds and accelerations of both.
    pub(crate) fn between(start_s: f64, seconds: f64, from: &Sample, to: &Sample) -> Self {
        let moved = std::array::from_fn(|joint| to.joints.0[joint] - from.joints.0[joint]);
        Self::moving(start_s, seconds, moved, from, to)
    }

    /// Creates a piece as [`between`](Self::between) does, over exactly these degrees; the difference of two positions
    /// would have lost digits.
    pub(crate) fn moving(start_s: f64, seconds: f64, moved: [f64; 6], from: &Sample, to: &Sample) -> Self {
        let way = std::array::from_fn(|joint| {
            let moved = moved[joint];
            let (begin, end) = (from.velocity[joint] * seconds / 5.0, to.velocity[joint] * seconds / 5.0);
            let bend = |sample: &Sample| sample.acceleration[joint] * seconds * seconds / 20.0;
            [begin, 2.0 * begin + bend(from), moved - 2.0 * end + bend(to), moved - end, moved]
        });
        Self { start_s, seconds, from: from.joints.0, way }
    }

    pub(crate) fn end_s(&self) -> f64 {
        self.start_s + self.seconds
    }

    /// Returns the sample at a share of its time.
    pub(crate) fn at(&self, share: f64) -> Sample {
        let (first, second) = (weights::<5>(share), weights::<4>(share));
        let (by_speed, by_acceleration) = (5.0 / self.seconds, 20.0 / self.seconds / self.seconds);
        let (mut velocity, mut acceleration) = ([0.0; 6], [0.0; 6]);
        for (joint, [one, two, three, four, five]) in self.way.iter().enumerate() {
            let steps = [*one, two - one, three - two, four - three, five - four];
            velocity[joint] = by_speed * sum(&first, &steps);
            acceleration[joint] = by_acceleration * sum(&second, &differences::<5, 4>(&steps, 1.0));
        }
        Sample { joints: JointPosition(self.joints(share)), velocity, acceleration }
    }

    /// Returns the joint positions at a share of its time.
    pub(crate) fn joints(&self, share: f64) -> [f64; 6] {
        let [_, weights @ ..] = weights::<6>(share);
        std::array::from_fn(|joint| self.from[joint] + sum(&weights, &self.way[joint]))
    }

    /// Returns the part between two shares of its time.
    pub(crate) fn part(&self, from: f64, to: f64) -> Self {
        let seconds = (to - from) * self.seconds;
        let start = self.joints(from);
        let way = std::array::from_fn(|joint| {
            let [first, rest @ ..] = part(&self.way(joint), from, to);
            rest.map(|way| way - first)
        });
        Self { start_s: self.start_s + from * self.seconds, seconds, from: start, way }
    }

    /// Returns the third derivative of each joint at a share of its time.
    pub(crate) fn jerk(&self, share: f64) -> [f64; 6] {
        std::array::from_fn(|joint| value(&self.jerks(joint), share))
    }

    /// Returns the joint positions at its start and its end.
    pub(crate) fn ends(&self) -> [[f64; 6]; 2] {
        [self.from, std::array::from_fn(|joint| self.from[joint] + self.way[joint][4])]
    }

    /// Returns the Bernstein coefficients of a joint's position.
    pub(crate) fn positions(&self, joint: usize) -> [f64; 6] {
        self.way(joint).map(|way| self.from[joint] + way)
    }

    /// Returns the Bernstein coefficients of a joint's speed.
    pub(crate) fn speeds(&self, joint: usize) -> [f64; 5] {
        differences(&self.way(joint), 5.0 / self.seconds)
    }

    /// Returns the Bernstein coefficients of a joint's acceleration.
    pub(crate) fn accelerations(&self, joint: usize) -> [f64; 4] {
        differences(&self.speeds(joint), 4.0 / self.seconds)
    }

    /// Returns quick bounds of the piece, from its coefficients.
    pub(crate) fn hull(&self) -> Hull {
        let mut hull = Hull { positions: [[0.0; 2]; 6], speeds: [0.0; 6], accelerations: [0.0; 6] };
        for joint in 0..6 {
            let (positions, speeds) = (self.positions(joint), self.speeds(joint));
            hull.positions[joint] = [
                positions.into_iter().fold(f64::INFINITY, f64::min),
                positions.into_iter().fold(f64::NEG_INFINITY, f64::max),
            ];
            hull.speeds[joint] = largest(&speeds);
            hull.accelerations[joint] = largest(&differences::<5, 4>(&speeds, 4.0 / self.seconds));
        }
        hull
    }

    /// Returns the highest speed of each joint, or a little more.
    pub(crate) fn top_speeds(&self) -> [f64; 6] {
        std::array::from_fn(|joint| peak(&self.speeds(joint)))
    }

    /// Returns the largest acceleration of each joint, or a little more.
    pub(crate) fn top_accelerations(&self) -> [f64; 6] {
        std::array::from_fn(|joint| peak(&self.accelerations(joint)))
    }

    /// Returns the largest jerk of each joint, or a little more.
    pub(crate) fn top_jerks(&self) -> [f64; 6] {
        std::array::from_fn(|joint| peak(&self.jerks(joint)))
    }

    /// Returns a quick upper bound of each joint's jerk, in deg/s³.
    pub(crate) fn jerks_at_most(&self) -> [f64; 6] {
        std::array::from_fn(|joint| largest(&self.jerks(joint)))
    }

    /// Whether all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let moves = (0..6).all(|joint| self.accelerations(joint).iter().all(|number| number.is_finite()));
        moves && self.from.iter().all(|joint| joint.is_finite())
    }

    fn jerks(&self, joint: usize) -> [f64; 3] {
        differences(&self.accelerations(joint), 3.0 / self.seconds)
    }

    fn way(&self, joint: usize) -> [f64; 6] {
        let way = self.way[joint];
        std::array::from_fn(|index| if index == 0 { 0.0 } else { way[index - 1] })
    }
}

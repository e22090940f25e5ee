//! How fast a trajectory goes along its legs and around its corners.

/// How fast the way along a leg may be, by its length's unit and seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    pub(super) speed: f64,
    pub(super) acceleration: f64,
    pub(super) jerk: f64,
}

/// How fast a corner may be rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corner {
    /// The highest speed.
    pub(super) speed: f64,
    /// The seconds that it takes at a speed of 1, by accelerations, and by jerks.
    pub(super) seconds: [f64; 2],
}

/// How fast one leg is passed, and the corner after it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passage {
    /// How much of the leg belongs to the corner before it.
    pub(super) from: f64,
    /// The speed at its start, between, and at its end.
    pub(super) speeds: [f64; 3],
    /// How long it takes to get from the first speed to the second, how long that holds, and how long it takes to get to the third.
    pub(super) seconds: [f64; 3],
    /// How long the corner takes, half of it before its point, at the third speed on both sides; 0 for none.
    pub(super) corner_s: f64,
}

/// How many speeds are tried at most in a search.
const ROUNDS: u32 = 40;
/// The share of a way that a search may leave.
const LEFT: f64 = 1e-4;
/// How many binary digits of a speed are left out, of 52: speeds are equal, or differ by some thousandths at least. To get from one to another that is nearer would take a
/// moment in which nothing but rounding is left of joint positions.
const DIGITS: u32 = 43;
/// The share of a leg that is left to go straight on.
const STRAIGHT: f64 = 0.1;
/// The share of what is left to it in which a leg has one speed.
const STEADY: f64 = 0.02;
/// Where less than this share is left to the changes of a leg's speed, they take all of it, somewhat more slowly: that saves a piece.
const FILLED: f64 = 0.05;

impl Bounds {
    /// All of it as it would be in slower time.
    pub(super) fn slowed(self, factor: f64) -> Self {
        let Self { speed, acceleration, jerk } = self;
        Self { speed: speed * factor, acceleration: acceleration * factor.powi(2), jerk: jerk * factor.powi(3) }
    }

    /// The lower of each.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            speed: self.speed.min(other.speed),
            acceleration: self.acceleration.min(other.acceleration),
            jerk: self.jerk.min(other.jerk),
        }
    }

    /// How long it takes to get from one speed to another.
    ///
    /// The speed goes as `3x² - 2x³`: its steepest rise is 1.5 times the mean, and the strongest bend 6 times.
    fn seconds(self, change: f64) -> f64 {
        (1.5 * change.abs() / self.acceleration).max((6.0 * change.abs() / self.jerk).sqrt())
    }

    /// The way on which a speed changes to another.
    fn way(self, from: f64, to: f64) -> f64 {
        0.5 * (from + to) * self.seconds(to - from)
    }
}

impl Corner {
    /// A stop.
    pub(super) const STOP: Self = Self { speed: 0.0, seconds: [0.0; 2] };
    /// Straight on.
    pub(super) const NONE: Self = Self { speed: f64::INFINITY, seconds: [0.0; 2] };

    pub(super) fn slowed(self, factor: f64) -> Self {
        let [accelerating, jerking] = self.seconds;
        let seconds = [accelerating / factor.powi(2), jerking / factor.powi(3).sqrt()];
        Self { speed: self.speed * factor, seconds }
    }

    fn seconds(self, speed: f64) -> f64 {
        (self.seconds[0] * speed).max(self.seconds[1] * speed.sqrt())
    }

    /// The way that it takes of both legs together.
    fn way(self, speed: f64) -> f64 {
        speed * self.seconds(speed)
    }

    /// Not as fast as takes a longer way than this.
    pub(super) fn within(self, way: f64) -> Self {
        let [accelerating, jerking] = self.seconds;
        let fastest = (way / accelerating).sqrt().min((way / jerking).powf(2.0 / 3.0));
        Self { speed: self.speed.min(fastest), ..self }
    }
}

/// How legs of these lengths are passed, with a corner before each and after the last, at the first and the last of which it stops.
pub(super) fn plan(lengths: &[f64], bounds: &[Bounds], corners: &[Corner]) -> Vec<Passage> {
    let speeds = corner_speeds(lengths, bounds, corners);
    let passage = |leg: usize| {
        let ends = [speeds[leg], speeds[leg + 1]];
        let [entry_s, exit_s] = [0, 1].map(|end| corners[leg + end].seconds(ends[end]));
        let [from, after] = [0.5 * ends[0] * entry_s, 0.5 * ends[1] * exit_s];
        let bounds = bounds[leg];
        let way = lengths[leg] - from - after;
        let top = top_speed(way, bounds, ends);
        let changing = bounds.way(ends[0], top) + bounds.way(top, ends[1]);
        let (slower, steady) =
            if way - changing < FILLED * changing { (way / changing, 0.0) } else { (1.0, (way - changing) / top) };
        let [rise, fall] = ends.map(|end| slower * bounds.seconds(top - end));
        let seconds = [rise, steady, fall];
        Passage { from, speeds: [ends[0], top, ends[1]], seconds, corner_s: exit_s }
    };
    (0..lengths.len()).map(passage).collect()
}

/// The speed at each corner: as high as the corner allows, and as the legs on both sides leave way to get to the next one.
fn corner_speeds(lengths: &[f64], bounds: &[Bounds], corners: &[Corner]) -> Vec<f64> {
    let last = lengths.len();
    let mut speeds: Vec<f64> = (0..=last)
        .map(|index| {
            if index == 0 || index == last {
                return 0.0;
            }
            let room = (1.0 - STRAIGHT) * lengths[index - 1].min(lengths[index]);
            let fastest = corners[index].within(room).speed;
            rounded_down(fastest.min(bounds[index - 1].speed).min(bounds[index].speed))
        })
        .collect();
    for leg in (0..last).rev() {
        speeds[leg] =
            reachable(lengths[leg], bounds[leg], [corners[leg], corners[leg + 1]], [speeds[leg], speeds[leg + 1]]);
    }
    for leg in 0..last {
        let (corners, ends) = ([corners[leg + 1], corners[leg]], [speeds[leg + 1], speeds[leg]]);
        speeds[leg + 1] = reachable(lengths[leg], bounds[leg], corners, ends);
    }
    speeds
}

/// The highest speed at one end of a leg, up to the first, from which that at the other is reached on the way.
fn reachable(length: f64, bounds: Bounds, corners: [Corner; 2], [fast, slow]: [f64; 2]) -> f64 {
    if fast <= slow {
        return fast;
    }
    let left = length - 0.5 * corners[1].way(slow);
    let speed = highest([slow, fast], LEFT * length, |speed| {
        (1.0 - STEADY) * (left - 0.5 * corners[0].way(speed)) - bounds.way(speed, slow)
    });
    rounded_down(speed).max(slow)
}

/// The highest speed on a way for which there is room between the speeds at its ends.
fn top_speed(way: f64, bounds: Bounds, ends: [f64; 2]) -> f64 {
    let least = ends[0].max(ends[1]);
    let speed = highest([least, bounds.speed], LEFT * way, |speed| {
        (1.0 - STEADY) * way - bounds.way(ends[0], speed) - bounds.way(speed, ends[1])
    });
    rounded_down(speed).max(least)
}

/// A speed with some eight binary digits.
fn rounded_down(speed: f64) -> f64 {
    f64::from_bits(speed.to_bits() >> DIGITS << DIGITS)
}

/// The highest number between two for which there is room, which gets less with the number; no more room is left than this.
///
/// Each next one is where a straight line between the room at a number that is too low and at one that is too high is 0. An end that stays
/// twice counts half, so that both come nearer.
fn highest([mut low, mut high]: [f64; 2], enough: f64, room: impl Fn(f64) -> f64) -> f64 {
    let (mut left, mut lacking) = (room(low), room(high));
    if lacking >= 0.0 {
        return high;
    }
    let (mut weight, mut was_lacking) = (left, None);
    for _ in 0..ROUNDS {
        let middle = low + (high - low) * weight / (weight - lacking);
        // Also where it is not a number.
        if !(left > enough && low < middle && middle < high) {
            break;
        }
        let found = room(middle);
        let is_lacking = found < 0.0;
        let stays = was_lacking.replace(is_lacking) == Some(is_lacking);
        let other = if stays { 0.5 } else { 1.0 };
        if is_lacking {
            (high, lacking, weight) = (middle, found, other * weight);
        } else {
            (low, left, weight, lacking) = (middle, found, found, other * lacking);
        }
    }
    low
}

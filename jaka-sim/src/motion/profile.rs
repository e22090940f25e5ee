//! Trapezoidal speed profiles.

/// Speed over time along a path: acceleration, constant speed, deceleration.
///
/// Lengths are in the path's unit, degrees or millimetres; times in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Profile {
    length: f64,
    acceleration: f64,
    /// Greatest speed reached: less than the requested speed if the path is too short for it.
    peak: f64,
}

impl Profile {
    /// Creates the profile along `length`; speed and acceleration must be positive.
    pub(crate) fn new(length: f64, speed: f64, acceleration: f64) -> Self {
        Self { length, acceleration, peak: speed.min((length * acceleration).sqrt()) }
    }

    fn ramp(&self) -> f64 {
        self.peak / self.acceleration
    }

    /// Returns the duration of the motion along the path, in seconds.
    pub(crate) fn duration(&self) -> f64 {
        if self.length > 0.0 { self.length / self.peak + self.ramp() } else { 0.0 }
    }

    /// Returns the distance after `time`, and the speed at that point.
    pub(crate) fn at(&self, time: f64) -> Along {
        let left = self.duration() - time;
        if left <= 0.0 {
            return Along { distance: self.length, speed: 0.0 };
        }
        let time = time.max(0.0);
        let (ramp, a) = (self.ramp(), self.acceleration);
        if time < ramp {
            Along { distance: a * time * time / 2.0, speed: a * time }
        } else if left < ramp {
            Along { distance: self.length - a * left * left / 2.0, speed: a * left }
        } else {
            Along { distance: self.peak * (time - ramp / 2.0), speed: self.peak }
        }
    }
}

/// Point on the path, and the speed there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Along {
    pub(crate) distance: f64,
    pub(crate) speed: f64,
}

/// Deceleration to a stop from a point on the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Brake {
    from: Along,
    deceleration: f64,
}

impl Brake {
    /// Creates a deceleration from a point and its speed; the deceleration must be positive.
    pub(crate) fn new(from: Along, deceleration: f64) -> Self {
        Self { from, deceleration }
    }

    /// Returns the duration of the braking, in seconds.
    pub(crate) fn duration(&self) -> f64 {
        self.from.speed / self.deceleration
    }

    /// Returns the point after `time`.
    pub(crate) fn at(&self, time: f64) -> Along {
        let time = time.clamp(0.0, self.duration());
        let speed = self.from.speed - self.deceleration * time;
        Along { distance: self.from.distance + f64::midpoint(self.from.speed, speed) * time, speed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn a_long_way_has_a_part_of_even_speed() {
        // Accelerates for 2 s over 20, moves 60 at 20 for 3 s, and decelerates for 2 s over 20.
        let profile = Profile::new(100.0, 20.0, 10.0);
        assert!(close(profile.duration(), 7.0));
        for (time, distance, speed) in
            [(0.0, 0.0, 0.0), (1.0, 5.0, 10.0), (2.0, 20.0, 20.0), (3.5, 50.0, 20.0), (6.0, 95.0, 10.0)]
        {
            let along = profile.at(time);
            assert!(close(along.distance, distance) && close(along.speed, speed), "{time}: {along:?}");
        }
        assert_eq!(profile.at(7.0), Along { distance: 100.0, speed: 0.0 });
        assert_eq!(profile.at(1e9), Along { distance: 100.0, speed: 0.0 });
    }

    #[test]
    fn a_short_way_never_reaches_the_speed() {
        let profile = Profile::new(10.0, 1000.0, 10.0);
        assert!(close(profile.duration(), 2.0));
        assert!(close(profile.at(1.0).distance, 5.0) && close(profile.at(1.0).speed, 10.0));
    }

    #[test]
    fn no_way_takes_no_time() {
        let profile = Profile::new(0.0, 10.0, 10.0);
        assert!(close(profile.duration(), 0.0));
        assert_eq!(profile.at(0.0), Along { distance: 0.0, speed: 0.0 });
    }

    #[test]
    fn braking_takes_the_way_it_must() {
        let brake = Brake::new(Along { distance: 30.0, speed: 20.0 }, 10.0);
        assert!(close(brake.duration(), 2.0));
        assert_eq!(brake.at(5.0), Along { distance: 50.0, speed: 0.0 });
    }
}

//! Trapezoidal speed profiles.

/// Speed over time on the way along a path: up at an acceleration, along at a speed, and down again.
///
/// Lengths are in the path's unit, degrees or millimetres; times in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Profile {
    length: f64,
    acceleration: f64,
    /// The greatest speed reached: less than the speed asked for where the path is too short for it.
    peak: f64,
}

impl Profile {
    /// The profile along `length`; speed and acceleration must be positive.
    pub(crate) fn new(length: f64, speed: f64, acceleration: f64) -> Self {
        Self { length, acceleration, peak: speed.min((length * acceleration).sqrt()) }
    }

    fn ramp(&self) -> f64 {
        self.peak / self.acceleration
    }

    /// Duration of the motion along the path, in seconds.
    pub(crate) fn duration(&self) -> f64 {
        if self.length > 0.0 { self.length / self.peak + self.ramp() } else { 0.0 }
    }

    /// Distance covered after `time`, and the speed there.
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

/// A place on the way, and the speed there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Along {
    pub(crate) distance: f64,
    pub(crate) speed: f64,
}

/// Slowing down to a stop from a place on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Brake {
    from: Along,
    deceleration: f64,
}

impl Brake {
    /// Slowing down from a place and its speed; the deceleration must be positive.
    pub(crate) fn new(from: Along, deceleration: f64) -> Self {
        Self { from, deceleration }
    }

    /// Duration of the braking, in seconds.
    pub(crate) fn duration(&self) -> f64 {
        self.from.speed / self.deceleration
    }

    /// The place after `time`.
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
        // Up in 2 s over 20, along 60 at 20 for 3 s, down in 2 s over 20.
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

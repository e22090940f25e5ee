//! The witness: set-points out of the bytes, their differences by index, and where they put the arm.

use jaka_motion::Dynamics;
use jaka_tests::witness::way::Bounds;

/// Limits of the joints: speeds, accelerations, jerks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moves {
    pub(crate) limits: [[f64; 6]; 3],
    /// Acceleration and jerk of a joint that is braked; `None` if nothing stops.
    pub(crate) stops: Option<[f64; 2]>,
    pub(crate) period: f64,
}

impl Moves {
    pub(crate) fn of(dynamics: &Dynamics, period: f64) -> Self {
        let limits = [*dynamics.speeds(), *dynamics.accelerations(), *dynamics.jerks()];
        Self { limits, stops: Some(STOPS), period }
    }
}

#[derive(Clone)]
pub(crate) struct Judge {
    bounds: Bounds,
    moves: Moves,
    /// The last three set-points, the last one last.
    last: [[f64; 6]; 3],
    tool: [f64; 3],
}

/// Acceleration and jerk of stops by default, in deg/s² and deg/s³.
const STOPS: [f64; 2] = [570.0, 5700.0];
/// Tolerance for rounding, as a share of a limit.
const SHARE: f64 = 2e-9;
/// Tolerance for rounding of a difference, in degrees: positions of some hundred degrees have steps of 6e-14.
const DEGREES: f64 = 3e-12;
/// Tolerance of a joint's range in degrees, for rounding.
const RANGE: f64 = 2e-5;
/// Tolerance of a region in mm: 0.1 between computed places, and half a millimetre where a path cuts the edge of a
/// box.
const REGION: f64 = 0.61;
const NAMES: [&str; 3] = ["speed", "acceleration", "jerk"];

impl Judge {
    pub(crate) fn new(bounds: Bounds, moves: Moves, start: [f64; 6]) -> Self {
        let tool = bounds.tcp(start).map(|row| row[3]);
        Self { bounds, moves, last: [start; 3], tool }
    }

    /// Starts the next set-points from standstill.
    pub(crate) fn paused(&mut self) {
        self.last = [self.last[2]; 3];
    }

    pub(crate) fn set_point(&mut self, here: [f64; 6]) -> Result<(), String> {
        let [third, second, first] = self.last;
        for joint in 0..6 {
            let by = [
                here[joint] - first[joint],
                here[joint] - 2.0 * first[joint] + second[joint],
                here[joint] - 3.0 * first[joint] + 3.0 * second[joint] - third[joint],
            ];
            let [now, before, oldest] = [by[0], first[joint] - second[joint], second[joint] - third[joint]];
            // Its acceleration may also go to zero first.
            let is_braked = now.abs() < before.abs() || before.abs() < oldest.abs() || by[2] * now < 0.0;
            let mut limits = self.moves.limits.map(|limits| limits[joint]);
            if let Some([acceleration, jerk]) = self.moves.stops.filter(|_| is_braked) {
                (limits[1], limits[2]) = (limits[1].max(acceleration), limits[2].max(jerk));
            }
            let mut duration = 1.0;
            for ((by, limit), name) in by.into_iter().zip(limits).zip(NAMES) {
                duration *= self.moves.period;
                let most = limit * duration * (1.0 + SHARE) + DEGREES;
                if by.is_nan() || by.abs() > most {
                    return Err(format!("{name} of joint {}: {}, limit {limit}", joint + 1, by / duration));
                }
            }
        }
        self.last = [second, first, here];
        let place = self.bounds.place(here);
        if place.degrees > RANGE || place.millimetres > REGION {
            return Err(format!("{place:?} at {here:?}"));
        }
        let tool = self.bounds.tcp(here).map(|row| row[3]);
        let moved = (0..3).map(|axis| (tool[axis] - self.tool[axis]).powi(2)).sum::<f64>().sqrt();
        self.tool = tool;
        if moved / self.moves.period > self.bounds.tcp_speed * (1.0 + 1e-6) {
            return Err(format!(
                "the tool moves at {} mm/s, limit {}",
                moved / self.moves.period,
                self.bounds.tcp_speed
            ));
        }
        Ok(())
    }

    /// Checks that the arm is at a joint position, and that this position is within all zones.
    pub(crate) fn is_at(&self, there: [f64; 6]) -> Result<(), String> {
        let off = (0..6).map(|joint| (self.last[2][joint] - there[joint]).abs()).fold(0.0, f64::max);
        let place = self.bounds.place(there);
        if off > 1e-6 || place.millimetres > 1e-3 {
            return Err(format!("at rest {off} degrees from {there:?}: {place:?}"));
        }
        Ok(())
    }
}

/// The six numbers between the first brackets of a request.
pub(crate) fn joints_in(request: &str) -> [f64; 6] {
    let (_, from) = request.split_once('[').expect("a list");
    let (list, _) = from.split_once(']').expect("its end");
    let mut numbers = list.split(',').map(|number| number.trim().parse().expect("a number"));
    let joints = std::array::from_fn(|_| numbers.next().expect("six"));
    assert_eq!(numbers.next(), None);
    joints
}

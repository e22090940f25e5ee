//! Speeds of the joints, from their positions.

use crate::plots::Series;

/// Smallest time for a mean speed, in seconds: the network delays packets differently, so that speeds over shorter
/// times would be wrong.
const LEAST_S: f64 = 0.1;

/// Speeds of the joints, in deg/s.
#[derive(Debug, Default)]
pub(in crate::commands::report) struct Speeds {
    pub(in crate::commands::report) series: [Series; 6],
    /// Start time and joint positions of the next mean.
    since: Option<(f64, [f64; 6])>,
}

impl Speeds {
    /// Takes the positions at a time, in deg.
    pub(super) fn see(&mut self, time: f64, joints: Option<[f64; 6]>) {
        let Some(joints) = joints else { return self.interrupt(time) };
        let Some((begin, before)) = self.since else {
            self.since = Some((time, joints));
            return;
        };
        if time - begin < LEAST_S {
            return;
        }
        for (series, (now, before)) in self.series.iter_mut().zip(joints.iter().zip(before)) {
            series.push(f64::midpoint(begin, time), Some((now - before) / (time - begin)));
        }
        self.since = Some((time, joints));
    }

    /// Interrupts the series at this time. The next speeds are computed from new positions.
    pub(super) fn interrupt(&mut self, time: f64) {
        self.since = None;
        self.series.iter_mut().for_each(|series| series.push(time, None));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_are_means_and_none_is_computed_across_a_gap() {
        let mut speeds = Speeds::default();
        for (time, joint) in [(0.0, 0.0), (0.001, 1.0), (0.2, 2.0), (0.4, 2.0)] {
            speeds.see(time, Some([joint; 6]));
        }
        assert_eq!(speeds.series[5].range(), Some((0.0, 10.0)));
        speeds.interrupt(0.4);
        speeds.see(10.0, Some([1000.0; 6]));
        assert_eq!(speeds.series[0].range(), Some((0.0, 10.0)));
    }
}

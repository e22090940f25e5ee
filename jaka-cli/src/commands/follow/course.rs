//! A trajectory as a table of samples: what it reaches, and what its picture shows.

use jaka_motion::{Checker, Sample, Trajectory};

/// A trajectory, sampled evenly, with where the tool centre point is.
#[derive(Debug)]
pub(super) struct Course {
    duration_s: f64,
    /// Times in seconds.
    samples: Vec<(f64, Sample)>,
    /// In mm.
    tool: Vec<[f64; 3]>,
}

/// How many samples there are: as many as can be seen in a picture.
const SAMPLES: u32 = 1000;
/// In which steps peaks are searched, in seconds, and how many steps are made at most.
const STEP_S: f64 = 0.001;
const MOST_STEPS: f64 = 1e6;

/// What a trajectory reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Peaks {
    pub(super) speeds: [f64; 6],
    pub(super) accelerations: [f64; 6],
    /// In mm/s.
    pub(super) tool: f64,
}

impl Course {
    pub(super) fn of(trajectory: &Trajectory, checker: &Checker) -> Self {
        let duration_s = trajectory.duration_s();
        let time_s = |number: u32| duration_s * f64::from(number) / f64::from(SAMPLES);
        let samples: Vec<_> = (0..=SAMPLES).map(|number| (time_s(number), trajectory.at(time_s(number)))).collect();
        let tool = samples.iter().map(|(_, sample)| tool_at(sample, checker)).collect();
        Self { duration_s, samples, tool }
    }

    pub(super) fn duration_s(&self) -> f64 {
        self.duration_s
    }

    pub(super) fn positions(&self) -> [Vec<(f64, f64)>; 6] {
        self.curves(|sample| sample.joints.0)
    }

    pub(super) fn speeds(&self) -> [Vec<(f64, f64)>; 6] {
        self.curves(|sample| sample.velocity)
    }

    pub(super) fn accelerations(&self) -> [Vec<(f64, f64)>; 6] {
        self.curves(|sample| sample.acceleration)
    }

    pub(super) fn tool_way(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.tool.iter().copied()
    }

    fn curves(&self, of: impl Fn(&Sample) -> [f64; 6]) -> [Vec<(f64, f64)>; 6] {
        std::array::from_fn(|joint| self.samples.iter().map(|(time_s, sample)| (*time_s, of(sample)[joint])).collect())
    }
}

impl Peaks {
    /// The largest values, in steps of 1 ms, or larger ones where it takes more than 1000 s.
    pub(super) fn of(trajectory: &Trajectory, checker: &Checker) -> Self {
        let duration_s = trajectory.duration_s();
        let step_s = STEP_S.max(duration_s / MOST_STEPS);
        let mut peaks = Self { speeds: [0.0; 6], accelerations: [0.0; 6], tool: 0.0 };
        let (mut time_s, mut last): (f64, Option<[f64; 3]>) = (0.0, None);
        loop {
            let sample = trajectory.at(time_s);
            for joint in 0..6 {
                peaks.speeds[joint] = peaks.speeds[joint].max(sample.velocity[joint].abs());
                peaks.accelerations[joint] = peaks.accelerations[joint].max(sample.acceleration[joint].abs());
            }
            let here = tool_at(&sample, checker);
            let moved =
                last.map_or(0.0, |last| (0..3).map(|axis| (here[axis] - last[axis]).powi(2)).sum::<f64>().sqrt());
            (peaks.tool, last) = (peaks.tool.max(moved / step_s), Some(here));
            if time_s >= duration_s {
                return peaks;
            }
            time_s += step_s;
        }
    }
}

fn tool_at(sample: &Sample, checker: &Checker) -> [f64; 3] {
    checker.frames().pose(checker.limits().model().forward(sample.joints)).position_mm()
}

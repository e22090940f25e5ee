//! The velocities at which pieces of the third degree join without a step of acceleration.

use super::TimedPoint;
use crate::piece::Sample;

/// Points with these velocities, and rest at both ends.
///
/// At each inner point the acceleration before is to be that after, which gives an equation for its velocity and those of its neighbours. All
/// together are solved by elimination forwards and insertion backwards.
pub(super) fn with_spline_velocities(points: &[TimedPoint]) -> Vec<Sample> {
    let at_rest = |point: &TimedPoint| Sample { joints: point.joints, velocity: [0.0; 6], acceleration: [0.0; 6] };
    let mut samples: Vec<Sample> = points.iter().map(at_rest).collect();
    // The share of the next velocity in each; the rest of it is in the samples until insertion.
    let mut shares = vec![0.0; points.len()];
    for index in 1..points.len() - 1 {
        let [before, here, after] = [index - 1, index, index + 1].map(|index| &points[index]);
        let [first, second] = [here.time_s - before.time_s, after.time_s - here.time_s];
        // Weighted so that no number is larger than the speeds.
        let (near, far) = (second / (first + second), first / (first + second));
        let pivot = 2.0 - near * shares[index - 1];
        shares[index] = far / pivot;
        samples[index].velocity = std::array::from_fn(|joint| {
            let mean = |from: &TimedPoint, to: &TimedPoint, seconds: f64| {
                (to.joints.0[joint] - from.joints.0[joint]) / seconds
            };
            let sum = 3.0 * (near * mean(before, here, first) + far * mean(here, after, second));
            (sum - near * samples[index - 1].velocity[joint]) / pivot
        });
    }
    for index in (1..points.len() - 1).rev() {
        let next = samples[index + 1].velocity;
        for (velocity, next) in samples[index].velocity.iter_mut().zip(next) {
            *velocity -= shares[index] * next;
        }
    }
    samples
}

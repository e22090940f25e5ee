//! Trajectories followed at other rates.

use super::{Random, checker, slow_enough, some_points};

/// As a change of the rate says, within a period of it, the joints stay within their accelerations; and with a little more they do not.
#[test]
fn a_rate_that_changes_so_stays_within_the_accelerations() {
    let (mut random, checker) = (Random::new(4), checker());
    let limits = *checker.limits().joint_accelerations();
    for _ in 0..30 {
        let (_, trajectory) = slow_enough(&some_points(&mut random, 5), &checker);
        for _ in 0..100 {
            let (time_s, rate) = (random.between(0.0, trajectory.duration_s()), random.between(0.0, 1.0));
            let change = trajectory.rate_change(time_s, rate);
            let here = trajectory.at(time_s);
            let needed = |change: f64| {
                let most =
                    |joint: usize| here.acceleration[joint].abs() * rate * rate + here.velocity[joint].abs() * change;
                (0..6).map(|joint| most(joint) / limits[joint]).fold(0.0, f64::max)
            };
            assert!(change >= 0.0 && (needed(change) - 1.0).abs() < 1e-3, "{}", needed(change));
            let while_passing = trajectory.rate_change_between(time_s - 0.01, time_s + 0.01, rate);
            for later in [-0.01, -0.003, 0.0, 0.006, 0.01] {
                assert!(while_passing <= trajectory.rate_change(time_s + later, rate) * (1.0 + 1e-3));
            }
        }
    }
}

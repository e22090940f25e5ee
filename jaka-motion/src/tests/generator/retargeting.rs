//! Goals that change at random.

use super::{Random, Watched, joints};
use crate::{Checker, Dynamics, Frames, Goal, Limits, Model, TcpVelocity, VelocityFrame};

fn some_goal(random: &mut Random, limits: &Limits, from: [f64; 6]) -> Goal {
    match random.below(6) {
        0 => joints(random.joints(limits.model())),
        1 | 2 => joints(from.map(|joint| joint + random.between(-5.0, 5.0))),
        3 => Goal::Velocity(limits.joint_speeds().map(|speed| random.between(-speed, speed))),
        4 => Goal::TcpVelocity(TcpVelocity {
            linear_mm_s: [0.0; 3].map(|_: f64| random.between(-300.0, 300.0)),
            angular_deg_s: [0.0; 3].map(|_: f64| random.between(-40.0, 40.0)),
            frame: [VelocityFrame::ArmBase, VelocityFrame::User, VelocityFrame::Tool][random.below(3)],
        }),
        _ => Goal::Rest,
    }
}

#[test]
fn differences_are_within_the_dynamics_whatever_the_goals_are() {
    let mut random = Random::new(77);
    let (mut set_points, mut rejections) = (0_u32, 0);
    for round in 0..40 {
        let model = &Model::published()[round % Model::published().len()];
        let mut each = |low: f64, high: f64| [0.0; 6].map(|_: f64| 10_f64.powf(random.between(low, high)));
        let (shares, accelerations, jerks) = (each(-1.5, 0.0), each(0.7, 4.5), each(1.0, 6.0));
        let limits = Limits::of(model).with_joint_accelerations(accelerations).expect("above 0");
        let speeds = std::array::from_fn(|joint| limits.joint_speeds()[joint] * shares[joint]);
        let dynamics = Dynamics::of(&limits).with_speeds(speeds).and_then(|dynamics| dynamics.with_jerks(jerks));
        let dynamics = dynamics.expect("above 0");
        let period_s = f64::from(u32::try_from(random.below(12)).expect("few") + 1) * 0.008;
        let start = loop {
            let start = random.joints(model);
            if Checker::new(limits.clone(), Frames::new()).check_place(start.into()).is_ok() {
                break start;
            }
        };
        let mut arm = Watched::with(&Checker::new(limits.clone(), Frames::new()), dynamics, start, period_s);
        for _ in 0..40 {
            let goal = some_goal(&mut random, &limits, arm.generator.joints().0);
            for _ in 0..=random.below(20) {
                arm.next(&goal);
                set_points += 1;
            }
            if random.below(20) == 0 {
                arm.paused();
            }
        }
        let landing = arm.generator.landing();
        arm.until_rest(&Goal::Rest, 1_000_000);
        assert!(arm.generator.joints().max_distance(&landing.joints) < 1e-7);
        rejections += arm.generator.rejections();
    }
    println!("{set_points} set-points, {rejections} rejections");
    assert!(set_points > 10_000);
}

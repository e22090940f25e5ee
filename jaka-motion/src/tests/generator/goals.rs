//! Joint positions, speeds of joints, and rest.

use super::{CYCLE, ELBOW_UP, Watched, joints, zu5};
use crate::{Beyond, Bound, Exceeded, Goal, Point, Region};

#[test]
fn joints_arrive_together_and_straight() {
    let mut arm = Watched::new(zu5(), ELBOW_UP);
    let target = [50.0, 40.0, -100.0, 190.0, -95.0, 5.5];
    let by: [f64; 6] = std::array::from_fn(|joint| target[joint] - ELBOW_UP[joint]);
    let count = (0..1000).position(|_| {
        let at = arm.next(&joints(target)).joints.0;
        let share = (at[0] - ELBOW_UP[0]) / by[0];
        let is_straight = (0..6).all(|joint| (at[joint] - ELBOW_UP[joint] - share * by[joint]).abs() < 1e-6);
        assert!(is_straight, "{at:?}");
        arm.generator.is_at_rest()
    });
    // The motion is 40 degrees at 300 deg/s² and 180 deg/s.
    let seconds = f64::from(u32::try_from(count.expect("it arrives")).expect("few")) * CYCLE;
    assert!((0.7..1.1).contains(&seconds), "{seconds}");
    assert!(arm.generator.joints().max_distance(&target.into()) < 1e-6);
    assert_eq!(arm.generator.rejections(), 0);
    let rest = arm.generator.joints();
    assert_eq!(arm.next(&joints(target)).joints, rest);
}

#[test]
fn a_joint_stops_at_the_end_of_its_range_and_the_others_go_on() {
    let mut arm = Watched::new(zu5().with_joint_range(1, -90.0, 90.0).expect("tighter"), ELBOW_UP);
    let goal = Goal::Velocity([100.0, 0.0, 0.0, 0.0, 0.0, -30.0]);
    let mut bounds = Vec::new();
    for _ in 0..500 {
        let step = arm.next(&goal);
        assert!(step.joints.0[0] <= 90.0 + 1e-6);
        bounds.extend(step.bound);
    }
    let at = arm.generator.joints().0;
    assert!((at[0] - 90.0).abs() < 1e-6 && at[1] == ELBOW_UP[1], "{at:?}");
    assert!((arm.generator.velocity()[5] + 30.0).abs() < 1e-6, "{:?}", arm.generator.velocity());
    let Some(Bound::Limit(beyond)) = bounds.last() else { panic!("{bounds:?}") };
    assert!(matches!(beyond.exceeded, Exceeded::LandingRange { joint: 1, .. }), "{beyond}");
    assert_eq!(arm.generator.rejections(), 0);
    // The path back is free.
    let back = Goal::Velocity([-50.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    for _ in 0..100 {
        arm.next(&back);
    }
    assert!((arm.generator.velocity()[0] + 50.0).abs() < 1e-6);
}

#[test]
fn rest_is_where_and_when_it_was_said() {
    let mut arm = Watched::new(zu5(), ELBOW_UP);
    for count in [3, 10, 40, 90] {
        for _ in 0..count {
            arm.next(&joints([200.0, 60.0, -150.0, 190.0, 90.0, 5.0]));
        }
        let landing = arm.generator.landing();
        let periods = f64::from(arm.until_rest(&Goal::Rest, 1000));
        assert!((periods * CYCLE - landing.time_s) < CYCLE + 1e-9, "{periods} for {landing:?}");
        assert!(arm.generator.joints().max_distance(&landing.joints) < 1e-8);
        assert!(arm.generator.landing().time_s < 1e-12);
    }
}

#[test]
fn after_a_pause_the_arm_starts_from_standstill() {
    let mut arm = Watched::new(zu5(), ELBOW_UP);
    let goal = Goal::Velocity([0.0, 0.0, 20.0, 0.0, 0.0, 150.0]);
    for _ in 0..5 {
        for _ in 0..40 {
            arm.next(&goal);
        }
        let before = arm.generator.joints();
        arm.paused();
        assert!(arm.generator.is_at_rest() && arm.generator.joints() == before);
    }
}

/// The straight path to the goal goes through a box.
#[test]
fn the_arm_stops_in_front_of_a_region_and_leaves_it() {
    let post = Region::outside_box("post", [-700.0, 250.0, -1000.0], [700.0, 290.0, 2000.0]).expect("a box");
    let limits = zu5().with_region(post).expect("the only one");
    let limits =
        limits.with_region(Region::half_space("floor", [0.0; 3], [0.0, 0.0, 1.0]).expect("a plane").of(Point::Wrist));
    let mut arm = Watched::new(limits.expect("another name"), [0.0, 60.0, -80.0, 190.0, -90.0, 5.0]);
    let goal = joints([90.0, 60.0, -80.0, 190.0, -90.0, 5.0]);
    let is_within = |arm: &Watched| match arm.generator.checker().check_place(arm.generator.joints()) {
        Err(Beyond { exceeded: Exceeded::Region { by_mm, .. }, .. }) => by_mm < 0.1,
        found => found.is_ok(),
    };
    assert_eq!(arm.generator.check_goal(&goal), Ok(()));
    let mut last = None;
    for _ in 0..1500 {
        last = arm.next(&goal).bound;
        assert!(is_within(&arm));
    }
    assert!(arm.generator.is_at_rest(), "{:?}", arm.generator);
    let Some(Bound::Limit(beyond)) = last else { panic!("it is held") };
    assert!(beyond.to_string().contains("beyond `post`"), "{beyond}");
    let y = crate::Model::default().forward(arm.generator.joints()).position_mm()[1];
    assert!((249.0..=250.00001).contains(&y), "{y}");
    arm.until_rest(&joints([-40.0, 60.0, -80.0, 190.0, -90.0, 5.0]), 1000);
    assert!((arm.generator.joints().0[0] + 40.0).abs() < 1e-6);
}

#[test]
fn the_tool_is_not_faster_than_its_limit() {
    let limits = zu5().with_tcp_speed(250.0).expect("a speed");
    let mut arm = Watched::new(limits, ELBOW_UP);
    let place = |arm: &Watched| crate::Model::default().forward(arm.generator.joints()).position_mm();
    let (mut before, mut most) = (place(&arm), 0.0_f64);
    for _ in 0..600 {
        arm.next(&joints([100.0, 60.0, -80.0, 190.0, -90.0, 5.0]));
        let here = place(&arm);
        let moved = (0..3).map(|axis| (here[axis] - before[axis]).powi(2)).sum::<f64>().sqrt();
        (before, most) = (here, most.max(moved / CYCLE));
    }
    assert!((200.0..250.0001).contains(&most), "{most}");
    assert!((arm.generator.joints().0[0] - 100.0).abs() < 1e-6);
}

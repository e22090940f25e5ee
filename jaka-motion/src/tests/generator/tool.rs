//! Velocities of the tool, and poses.

use jaka_proto::messages::types::Pose;

use super::{CYCLE, ELBOW_UP, Watched, zu5};
use crate::tests::Random;
use crate::{
    Bound, Checker, Dynamics, Exceeded, Frames, Generator, Goal, Model, Region, Singularity, TcpVelocity, VelocityFrame,
};

fn along(linear_mm_s: [f64; 3]) -> Goal {
    let frame = VelocityFrame::ArmBase;
    Goal::TcpVelocity(TcpVelocity { linear_mm_s, angular_deg_s: [0.0; 3], frame })
}

fn place(arm: &Watched) -> [f64; 3] {
    Model::default().forward(arm.generator.joints()).position_mm()
}

fn minus(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

fn length(of: [f64; 3]) -> f64 {
    of.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[test]
fn the_tool_moves_as_it_is_told() {
    let mut arm = Watched::new(zu5(), ELBOW_UP);
    let goal = along([0.0, 60.0, -30.0]);
    for _ in 0..100 {
        arm.next(&goal);
    }
    let (before, turned) = (place(&arm), Model::default().forward(arm.generator.joints()));
    for _ in 0..100 {
        assert_eq!(arm.next(&goal).bound, None);
    }
    let moved = minus(place(&arm), before).map(|part| part / (100.0 * CYCLE));
    assert!(length(minus(moved, [0.0, 60.0, -30.0])) < 0.5, "{moved:?}");
    assert!(turned.angle_deg(&Model::default().forward(arm.generator.joints())) < 0.05);
    // The tool turns about its own axis, which does not move it.
    let turn = TcpVelocity { linear_mm_s: [0.0; 3], angular_deg_s: [0.0, 0.0, 20.0], frame: VelocityFrame::Tool };
    arm.until_rest(&Goal::Rest, 500);
    let (before, turned) = (place(&arm), Model::default().forward(arm.generator.joints()));
    for _ in 0..200 {
        arm.next(&Goal::TcpVelocity(turn));
    }
    assert!(length(minus(place(&arm), before)) < 0.01);
    let turned = turned.angle_deg(&Model::default().forward(arm.generator.joints()));
    assert!((28.0..32.0).contains(&turned), "{turned}");
}

/// Measures at each set-point the speed at which the tool reached it, and its travel from there to rest.
#[test]
fn a_tool_that_is_to_stop_soon_can_whatever_the_goals_are() {
    let (speed, within) = (20.0, 0.7);
    let checker = Checker::new(zu5(), Frames::new());
    let generator = Generator::new(&checker, Dynamics::of(&zu5()), ELBOW_UP.into(), CYCLE).expect("at rest");
    let mut generator = generator.with_tool_stop(speed, within).expect("above 0");
    let at = |generator: &Generator| Model::default().forward(generator.joints()).position_mm();
    let (mut random, mut goal, mut fastest, mut furthest) = (Random::new(3), Goal::Rest, 0.0, 0.0);
    for index in 0..1500 {
        if index % 60 == 0 {
            let by: [f64; 6] = std::array::from_fn(|_| random.between(-10.0, 10.0));
            let target = std::array::from_fn(|joint| ELBOW_UP[joint] + by[joint]);
            let goals =
                [Goal::Joints(target.into()), Goal::Velocity(by), along([2.0 * by[0], by[1], by[2]]), Goal::Rest];
            goal = goals[random.below(4)];
        }
        let before = at(&generator);
        generator.next(&goal);
        let (mut stopping, mut last, mut way) =
            (generator.clone(), at(&generator), length(minus(at(&generator), before)));
        fastest = f64::max(fastest, way / CYCLE);
        while !stopping.is_at_rest() {
            stopping.next(&Goal::Rest);
            way += length(minus(at(&stopping), last));
            last = at(&stopping);
        }
        furthest = f64::max(furthest, way);
    }
    assert!(fastest <= 1.0001 * speed && furthest <= 1.0001 * within, "{fastest} mm/s, {furthest} mm");
    assert!(fastest > 0.5 * speed && furthest > 0.8 * within, "{fastest} mm/s, {furthest} mm");
    let beyond = generator.check_goal(&along([30.0, 0.0, 0.0])).expect_err("it is too fast");
    assert!(matches!(beyond.exceeded, Exceeded::TcpSpeed { limit_mm_s: 20.0, .. }), "{beyond}");
}

/// A slow motion along the plane would be permitted, but the direction is kept.
#[test]
fn all_axes_slow_down_in_front_of_a_region() {
    let y = Model::default().forward(ELBOW_UP).position_mm()[1];
    let wall = Region::half_space("wall", [0.0, y + 80.0, 0.0], [0.0, -1.0, 0.0]).expect("a plane");
    let mut arm = Watched::new(zu5().with_region(wall).expect("the only one"), ELBOW_UP);
    let (goal, start, mut last) = (along([-80.0, 80.0, 0.0]), place(&arm), None);
    for _ in 0..1500 {
        last = arm.next(&goal).bound;
        let [x, y, z] = minus(place(&arm), start);
        assert!(y < 80.1 && (x + y).abs() < 1.0 && z.abs() < 1.0, "{x} {y} {z}");
    }
    let moved = minus(place(&arm), start);
    assert!((79.0..80.00001).contains(&moved[1]), "{moved:?}");
    let Some(Bound::Limit(beyond)) = last else { panic!("it is held") };
    assert!(matches!(beyond.exceeded, Exceeded::Region { .. } | Exceeded::LandingRegion { .. }), "{beyond}");
    // The motion away from the wall is at full speed at once.
    for _ in 0..100 {
        arm.next(&along([0.0, -80.0, 0.0]));
    }
    let before = place(&arm);
    arm.next(&along([0.0, -80.0, 0.0]));
    assert!((before[1] - place(&arm)[1] - 80.0 * CYCLE).abs() < 0.02);
}

#[test]
fn the_arm_slows_down_in_front_of_a_singularity_and_comes_back() {
    let mut arm = Watched::new(zu5(), ELBOW_UP);
    let elbow = |arm: &Watched| Model::default().singularity_distance(arm.generator.joints()).elbow;
    let (out, mut last) = (along([150.0, 0.0, 0.0]), None);
    for _ in 0..3000 {
        last = arm.next(&out).bound;
    }
    let Some(Bound::Limit(beyond)) = last else { panic!("it is held: {:?}", arm.generator) };
    assert!(matches!(beyond.exceeded, Exceeded::Singularity { which: Singularity::Elbow, .. }), "{beyond}");
    assert!(arm.generator.velocity().iter().all(|speed| speed.abs() < 0.1), "{:?}", arm.generator);
    assert!((0.0..0.1).contains(&elbow(&arm)), "{}", elbow(&arm));
    let there = place(&arm);
    for _ in 0..300 {
        arm.next(&along([-150.0, 0.0, 0.0]));
    }
    assert!(there[0] - place(&arm)[0] > 100.0, "{:?}", arm.generator);
}

#[test]
fn a_pose_is_reached_on_the_branch_of_the_session() {
    let arm = Watched::new(zu5(), ELBOW_UP);
    let model = Model::default();
    let there = [30.0, 45.0, -60.0, 170.0, -70.0, 15.0];
    let pose: Pose = model.forward(there).into();
    assert!(
        arm.generator
            .checker()
            .joints_on_branch(arm.generator.joints(), pose)
            .expect("within reach")
            .max_distance(&there.into())
            < 1e-6
    );
    let far = arm
        .generator
        .checker()
        .joints_on_branch(arm.generator.joints(), Pose { x: 3000.0, ..pose })
        .expect_err("out of reach");
    assert!(matches!(far.exceeded, Exceeded::OutOfReach { .. }), "{far}");
    // The flipped wrist is as near in some poses; here its range is closed.
    let odd = arm
        .generator
        .checker()
        .joints_on_branch(arm.generator.joints(), Pose { x: f64::NAN, ..pose })
        .expect_err("not a pose");
    assert!(matches!(odd.exceeded, Exceeded::NotFinite), "{odd}");
}

#[test]
fn a_pose_that_takes_another_branch_is_refused() {
    let limits = zu5().with_joint_range(5, -170.0, -60.0).expect("tighter").with_joint_range(6, -20.0, 30.0);
    let arm = Watched::new(limits.expect("tighter"), ELBOW_UP);
    let flipped = [10.0, 60.0, -80.0, 190.0, 90.0, 5.0];
    let found = arm
        .generator
        .checker()
        .joints_on_branch(arm.generator.joints(), Model::default().forward(flipped).into())
        .expect_err("another branch");
    assert!(matches!(found.exceeded, Exceeded::JointRange { .. } | Exceeded::Singularity { .. }), "{found}");
}

//! Models against poses of a simulated controller.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::{Random, from_pose};
use crate::{Fit, FitError, Frames, Model, Tolerance};

type Pairs = Vec<(JointPosition, Pose)>;

/// Returns poses as from `kine_forward`, with six decimals.
fn answered(model: &Model, frames: &Frames) -> Pairs {
    let decimals = |pose: Pose| Pose::from(<[f64; 6]>::from(pose).map(|number| (number * 1e6).round() / 1e6));
    let positions = model.positions_to_compare();
    positions.map(|joints| (joints, decimals(frames.pose(model.forward(joints))))).to_vec()
}

fn some_frames(random: &mut Random) -> Frames {
    let mut pose = || {
        let number = |index| if index < 3 { random.between(-800.0, 800.0) } else { random.between(-180.0, 180.0) };
        from_pose(std::array::from_fn(number))
    };
    Frames::new().with_tool(pose()).with_user_frame(pose()).with_mounting(pose())
}

fn fit(model: &Model, pairs: &Pairs) -> Result<Fit, FitError> {
    model.fit(pairs, Tolerance::default())
}

#[test]
fn the_positions_to_compare_are_within_range_and_move_all_joints() {
    for model in Model::published() {
        assert!(model.positions_to_compare().iter().all(|joints| model.is_within_range(*joints)), "{}", model.name());
        assert!(fit(model, &answered(model, &Frames::new())).is_ok(), "{}", model.name());
    }
}

#[test]
fn any_tool_user_frame_and_mounting_is_found() {
    for (seed, model) in (901..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..20 {
            let frames = some_frames(&mut random);
            let found = fit(model, &answered(model, &frames)).unwrap_or_else(|error| panic!("{error}"));
            assert!(found.position_mm < 1e-4 && found.angle_deg < 1e-5, "{found:?}");
            assert!(found.frames.tool().distance_mm(&frames.tool()) < 1e-4, "{found:?}");
            assert!(found.frames.base().distance_mm(&frames.base()) < 1e-4, "{found:?}");
        }
    }
}

/// Tool and mounting cannot absorb differences of a few mm in the lengths of upper arm, forearm and wrist.
#[test]
fn another_arm_is_refused() {
    let arms = ["Zu 3", "Zu 5", "Zu 7", "Zu 12", "Zu 18", "Zu 20", "Zu 30", "Pro 16", "MiniCobo"];
    let arms = arms.map(|name| Model::named(name).expect("published"));
    let mut random = Random::new(31);
    for real in arms {
        let pairs = answered(real, &some_frames(&mut random));
        for model in arms.iter().filter(|model| model.name() != real.name()) {
            let refused = fit(model, &pairs).expect_err("another arm");
            assert!(matches!(refused, FitError::Differs { position_mm, .. } if position_mm > 5.0), "{refused}");
        }
    }
}

#[test]
fn a_joint_that_turns_the_other_way_is_refused() {
    let model = Model::default();
    for joint in 0..6 {
        let mut pairs = answered(&model, &Frames::new());
        for (joints, _) in &mut pairs {
            joints.0[joint] = -joints.0[joint];
        }
        assert!(matches!(fit(&model, &pairs), Err(FitError::Differs { .. })), "joint {}", joint + 1);
    }
}

#[test]
fn poses_that_tell_too_little_are_refused() {
    let model = Model::default();
    let pairs = answered(&model, &Frames::new());
    assert_eq!(fit(&model, &pairs[..5].to_vec()), Err(FitError::TooFew { least: 6 }));
    let mut odd = pairs.clone();
    odd[3].1.rz = f64::NAN;
    assert_eq!(fit(&model, &odd), Err(FitError::NotFinite));
    for joint in 0..6 {
        let mut still = pairs.clone();
        for (joints, pose) in &mut still {
            joints.0[joint] = 10.0;
            *pose = model.forward(*joints).into();
        }
        let refused = fit(&model, &still).expect_err("a joint does not move");
        assert!(matches!(refused, FitError::JointNotMoved { joint: still, .. } if still == joint + 1), "{refused}");
    }
    // All joints move, and the flange turns about a single axis.
    let upright: Pairs = (0..12)
        .map(|step| {
            let turn = f64::from(step) * 10.0;
            let joints = JointPosition([turn, turn, -turn, 0.0, 0.0, turn]);
            (joints, from_pose([0.0, 0.0, 0.0, 0.0, 0.0, turn]).into())
        })
        .collect();
    assert!(fit(&model, &upright).is_err());
}

#[test]
fn a_difference_is_told_where_it_is_largest() {
    let model = Model::default();
    let mut pairs = answered(&model, &Frames::new());
    pairs[7].1.x += 3.0;
    let refused = fit(&model, &pairs).expect_err("one pose is off");
    let FitError::Differs { joints, position_mm, .. } = refused else { panic!("{refused}") };
    assert_eq!(joints, pairs[7].0);
    assert!((1.0..3.0).contains(&position_mm), "{refused}");
    assert!(refused.to_string().ends_with("allowed are 0.5 mm and 0.01 deg"), "{refused}");
}

//! Invalid numbers, branches that the controller chooses, and arms off their drawings.

use jaka_proto::messages::types::Pose;

use super::{ELBOW_UP, PACE, SLOW, amidst, bare, moved, some_frames, zu5};
use crate::tests::Random;
use crate::{Beyond, Checker, Exceeded, Frames, JointSpeed, Limits, Model, Point, Region, TcpSpeed};

const ODD: [f64; 9] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, f64::MAX, f64::MIN_POSITIVE, -0.0, 1e9];

fn fenced() -> Limits {
    let mut limits = zu5().with_tcp_speed(200.0).expect("a speed");
    for point in [Point::Tcp, Point::Elbow, Point::Wrist] {
        for region in [
            Region::inside_box(format!("cell {point}"), [-2e3; 3], [2e3; 3]),
            Region::outside_box(format!("box {point}"), [3e3; 3], [4e3; 3]),
        ] {
            limits = limits.with_region(region.expect("a region").of(point)).expect("another name");
        }
    }
    limits
}

/// Every odd number is refused or has no effect; nothing panics or runs on.
#[test]
fn odd_numbers_anywhere_are_refused() {
    let checker = bare(fenced());
    let (good, pose) = (ELBOW_UP, <[f64; 6]>::from(moved(ELBOW_UP, [0.0, 20.0, 0.0])));
    for odd in ODD {
        for index in 0..6 {
            let (mut joints, mut other) = (good, pose);
            (joints[index], other[index]) = (odd, odd);
            let (joints, other) = (joints.into(), Pose::from(other));
            let results: [Result<(), Beyond>; 8] = [
                checker.check_place(joints),
                checker.check_joint_way(good.into(), joints, PACE),
                checker.check_line(good.into(), other, SLOW).map(|_| ()),
                checker.check_arc(good.into(), other, moved(good, [0.0, 0.0, 20.0]), SLOW).map(|_| ()),
                checker.check_arc(good.into(), moved(good, [0.0, 0.0, 20.0]), other, SLOW).map(|_| ()),
                checker.check_end_move(good.into(), other, PACE),
                checker.check_set_point([good.into(); 2], joints, 0.008),
                checker.check_pose_set_point([good.into(); 2], other, 0.008).map(|_| ()),
            ];
            for (number, found) in results.into_iter().enumerate() {
                // Any finite number of degrees is a direction.
                let direction = index >= 3 && odd.is_finite() && [2, 3, 4, 5, 7].contains(&number);
                assert!(found.is_err() || odd.abs() < 1.0 || direction, "{odd} {index} {number}");
                assert!(odd.is_finite() || found.unwrap_err().exceeded == Exceeded::NotFinite, "{odd} {index}");
            }
            // The start is impossible for any arm.
            let end = Pose::from(pose);
            let _ = checker.check_joint_way(joints, good.into(), PACE);
            let _ = checker.check_line(joints, end, SLOW);
            let _ = checker.check_arc(joints, moved(good, [0.0, 0.0, 20.0]), end, SLOW);
            let _ = checker.check_end_move(joints, end, PACE);
            let _ = checker.check_set_point([joints; 2], good.into(), 0.008);
            let _ = checker.check_pose_set_point([joints, good.into()], end, 0.008);
        }
    }
}

#[test]
fn odd_paces_are_refused() {
    let checker = bare(zu5());
    let to = moved(ELBOW_UP, [0.0, 20.0, 0.0]);
    for odd in [f64::NAN, f64::INFINITY, 0.0, -5.0] {
        for asked in [JointSpeed { speed_deg_s: odd, ..PACE }, JointSpeed { acceleration_deg_s2: Some(odd), ..PACE }] {
            let found = checker.check_joint_way(ELBOW_UP.into(), ELBOW_UP.into(), asked).unwrap_err();
            assert!(matches!(found.exceeded, Exceeded::Asked { .. }), "{found}");
        }
        let blended = TcpSpeed { tolerance_mm: if odd == 0.0 { -1.0 } else { odd }, ..SLOW };
        for asked in [TcpSpeed { speed_mm_s: odd, ..SLOW }, blended] {
            let found = checker.check_line(ELBOW_UP.into(), to, asked).unwrap_err();
            assert!(matches!(found.exceeded, Exceeded::Asked { .. }), "{found}");
        }
    }
}

#[test]
fn frames_that_are_not_finite_are_refused() {
    let nowhere = Pose::from([f64::NAN; 6]);
    for frames in
        [Frames::new().with_tool(nowhere), Frames::new().with_user_frame(nowhere), Frames::new().with_mounting(nowhere)]
    {
        let found = Checker::new(fenced(), frames).check_joint_way(ELBOW_UP.into(), ELBOW_UP.into(), PACE);
        assert_eq!(found.unwrap_err().exceeded, Exceeded::NotFinite);
    }
}

/// The controller does not know these limits: it may take any branch.
#[test]
fn each_branch_of_an_end_move_counts() {
    let to = moved(ELBOW_UP, [0.0, 50.0, 0.0]);
    assert_eq!(bare(zu5()).check_end_move(ELBOW_UP.into(), to, PACE), Ok(()));
    // The elbow stays up, and does not go down.
    let checker = bare(zu5().with_joint_range(3, -175.0, 0.0).expect("tighter"));
    assert!(checker.check_line(ELBOW_UP.into(), to, SLOW).is_ok());
    let found = checker.check_end_move(ELBOW_UP.into(), to, PACE).unwrap_err().to_string();
    let end = "; limit 0, for one of the joint positions that the controller may choose for the pose (Zu 5)";
    assert!(found.starts_with("joint 3 would be at ") && found.ends_with(end), "{found}");
    let far = checker.check_end_move(ELBOW_UP.into(), moved(ELBOW_UP, [2e3, 0.0, 0.0]), PACE).unwrap_err();
    assert!(matches!(far.exceeded, Exceeded::OutOfReach { .. }), "{far}");
}

/// There is no closed form, but the joints follow by Newton steps all the same.
#[test]
fn a_calibrated_arm_is_followed_too() {
    let mut random = Random::new(83);
    for model in Model::published() {
        let mut arm = model.clone();
        for index in 0..6 {
            arm.links.alpha[index] += random.between(-0.3, 0.3);
            arm.links.a[index] += random.between(-1.0, 1.0);
            arm.links.d[index] += random.between(-1.0, 1.0);
        }
        arm.closed_form.links = model.closed_form.nearest_to(&arm.links);
        arm.closed_form.precision = crate::closed_form::Precision::FirstGuess;
        let frames = some_frames(&mut random);
        let from = amidst(&mut random, &Limits::of(model));
        let start = arm.forward(from) * frames.tool();
        let end = start.displaced(&Pose::from_millimetres_degrees([20.0, 30.0, -25.0], [5.0, 0.0, 8.0]).into());
        let checker = Checker::new(Limits::of(&arm), frames);
        let slow = TcpSpeed { speed_mm_s: 5.0, ..SLOW };
        let joints = checker
            .check_line(from.into(), (frames.base() * end).into(), slow)
            .unwrap_or_else(|beyond| panic!("{beyond}"));
        assert!((arm.forward(joints) * frames.tool()).distance_mm(&end) < 1e-5, "{}", model.name());
        let near = start.between(&end, 0.01);
        let before = [from.into(); 2];
        let _ = checker.check_pose_set_point(before, (frames.base() * near).into(), 1.0).expect("a slow step");
    }
}

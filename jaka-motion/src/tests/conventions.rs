//! Conventions compared with the vendor's own figures, and poses converted in both directions.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::{Random, apart, assert_close, from_pose, to_pose};
use crate::closed_form::Wrist;
use crate::{Model, Transform};

/// Figures from the vendor's SDK examples (`example_kine_inverse`, `example_rpy_to_rot_matrix`,
/// `example_quaternion_to_rot_matrix`), of some arm. Its lengths are not those of a published model (the Zu 7 is
/// nearest, 10 mm off), but orientation does not depend on lengths.
const EXAMPLE_JOINTS: [f64; 6] = [0.558, 0.872, 0.872, 0.349, 0.191, 0.191];
const EXAMPLE_RPY: [f64; 3] = [-1.81826, -0.834_253, -2.30243];
const EXAMPLE_QUATERNION: [f64; 4] = [0.0629, 0.522_886, -0.5592, 0.6453];
/// Joint positions and poses; the transcripts are public, in `nkawa/JAKA_Zu5s_MQTT_Control`, `src/check_jkrc.py`.
#[rustfmt::skip]
const CAPTURED: [([f64; 6], [f64; 6]); 4] = [
    ([-263.405_107, 106.408_955, 75.061_059, 89.814_487, -93.426_702, -13.407_083],
     [-50.169_481, -610.805_76, 413.795_359, 177.953_437, -3.034_099, -159.905_394]),
    ([-263.403_734, 106.909_519, 75.547_89, 89.850_193, -93.426_702, -13.407_083],
     [-49.993_733, -612.200_172, 404.404_579, 176.957_42, -2.794_82, -159.853_377]),
    ([-263.403_734, 107.408_71, 76.043_649, 89.887_272, -93.426_016, -13.407_083],
     [-49.852_504, -613.410_281, 394.960_563, 175.953_287, -2.551_933, -159.806_574]),
    ([-261.539_269, 107.261_397, 76.208_493, 89.979_374, -93.315_612, -1.542_663],
     [-29.852_503, -613.410_289, 394.960_562, 176.457_188, -3.215_444, -169.797_277]),
];

/// Joint positions and poses, in public status packets of a newer controller with tool 1 and user frame 0:
/// `moisesoliveira-dev/article`, `dados.json` and, at two commits, `jaka_monitor/data/jaka_monitor.db`.
#[rustfmt::skip]
const CAPTURED_NEWER: [([f64; 6], [f64; 6]); 3] = [
    ([-90.935_89, 78.621_94, 11.783_46, -7.199_99, -1.569_47, 286.683_64],
     [2.877_734_337_937_711_4, 577.104_892_219_393_6, 229.424_273_779_459_33,
      -91.167_635_952_102_49, -9.480_430_961_367_986, 179.453_177_770_693_7]),
    ([-92.7246, -3.171_27, 4.507_77, 22.692_43, -2.233_45, 286.681_58],
     [-4.007_253_990_122_829_5, -8.556_245_894_451_035, 767.040_209_324_755_7,
      178.893_738_844_379_33, -0.206_719_525_424_343_27, -143.358_645_942_956_03]),
    ([-90.569_91, 13.886_38, 82.622_62, 4.924_79, 80.350_77, 286.681_58],
     [-16.856_803_348_947_118, 269.120_102_441_501_33, 207.417_466_712_425_95,
      -1.577_666_462_355_306_7, -5.581_022_399_363_026, 162.132_604_064_458_04]),
];

fn example_pose() -> Transform {
    let [rx, ry, rz] = EXAMPLE_RPY.map(f64::to_degrees);
    from_pose([0.0, 0.0, 0.0, rx, ry, rz])
}

#[test]
fn forward_turns_the_flange_as_the_vendor_does() {
    for model in Model::published().iter().filter(|model| model.closed_form.wrist == Wrist::Parallel) {
        let flange = model.forward(EXAMPLE_JOINTS.map(f64::to_degrees));
        assert!(apart(&flange, &example_pose()).1 < 0.005, "{}", model.name());
    }
}

#[test]
fn euler_angles_are_roll_pitch_yaw_as_the_vendor_has_them() {
    let [s, x, y, z] = EXAMPLE_QUATERNION;
    let vendor = UnitQuaternion::from_quaternion(Quaternion::new(s, x, y, z));
    assert!(vendor.angle_to(&example_pose().0.rotation) < 0.003);
    let turn = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
    let [rx, ry, rz] = EXAMPLE_RPY;
    let by_hand = turn(Vector3::z_axis(), rz) * turn(Vector3::y_axis(), ry) * turn(Vector3::x_axis(), rx);
    assert!(by_hand.angle_to(&example_pose().0.rotation) < 1e-12);
}

/// The SDK's `example_circle_move` moves to these joints before a circle whose points all have rpy -90, 0, 0 degrees.
#[test]
fn the_circle_example_starts_with_its_own_orientation() {
    let flange = Model::default().forward([85.76, -6.207, 111.269, 74.938, 94.24, 0.0]);
    let [.., rx, ry, rz] = to_pose(flange);
    assert!((rx + 90.0).abs() < 1e-6 && ry.abs() < 1e-6 && rz.abs() < 1e-6, "{rx} {ry} {rz}");
}

/// The expected pose follows by hand: the arm lies along x, joint 4 is offset towards y, the wrist points down and the
/// flange points back.
#[test]
fn a_zu_5_at_zero_is_where_its_lengths_say() {
    let [x, y, z, rx, ry, rz] = to_pose(Model::default().forward([0.0; 6]));
    let expected = [430.0 + 368.5, 114.0 - 107.0, 120.15 - 113.5, 90.0, 0.0, 0.0];
    let close = [x, y, z, rx, ry, rz].iter().zip(expected).all(|(is, expected)| (is - expected).abs() < 1e-9);
    assert!(close, "{:?}", [x, y, z, rx, ry, rz]);
}

#[test]
fn poses_survive_the_way_there_and_back() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let pose =
            std::array::from_fn(
                |index| if index < 3 { random.between(-1e3, 1e3) } else { random.between(-180.0, 180.0) },
            );
        assert_close(&from_pose(to_pose(from_pose(pose))), &from_pose(pose), (1e-12, 1e-6), &format!("{pose:?}"));
    }
}

#[test]
fn poses_survive_near_gimbal_lock() {
    let mut random = Random::new(5);
    for exponent in 0..20 {
        for side in [-90.0, 90.0] {
            let ry = side - f64::signum(side) * 10_f64.powi(-exponent);
            let pose = [1.0, 2.0, 3.0, random.between(-180.0, 180.0), ry, random.between(-180.0, 180.0)];
            assert_close(&from_pose(to_pose(from_pose(pose))), &from_pose(pose), (1e-12, 2e-6), &format!("{pose:?}"));
        }
    }
}

#[test]
fn gimbal_lock_leaves_rz_zero() {
    let [.., rx, ry, rz] = to_pose(from_pose([0.0, 0.0, 0.0, 30.0, 90.0, 10.0]));
    assert!((rx - 20.0).abs() < 1e-6 && (ry - 90.0).abs() < 1e-6, "{rx} {ry}");
    assert_eq!(rz.to_bits(), 0.0_f64.to_bits());
}

/// The real arm's lengths differ from the published ones by some tenths of a millimetre.
#[test]
fn a_real_zu_5_is_where_the_model_says() {
    for (joints, pose) in CAPTURED {
        assert_close(&Model::default().forward(joints), &from_pose(pose), (0.42, 0.00001), "Zu 5");
    }
}

#[test]
fn the_inverse_finds_the_joints_of_a_real_zu_5() {
    for (joints, pose) in CAPTURED {
        let found = Model::default().inverse(from_pose(pose), joints).expect("the arm was there");
        assert!(found.max_distance(&joints.into()) < 0.1, "{found}");
    }
}

/// The tool is turned by half a turn about x and has no offset. The arm's lengths differ from the published ones by up
/// to 0.8 mm.
#[test]
fn the_newer_controller_has_a_minicobo() {
    let tool = from_pose([0.0, 0.0, 0.0, 180.0, 0.0, 0.0]);
    for model in Model::published() {
        let off = CAPTURED_NEWER.map(|(joints, pose)| apart(&(model.forward(joints) * tool), &from_pose(pose)));
        let within = |most: (f64, f64)| off.iter().all(|off| off.0 < most.0 && off.1 < most.1);
        assert_eq!(within((1.7, 0.000_02)), model.name() == "MiniCobo", "{} {off:?}", model.name());
        assert!(model.name() == "MiniCobo" || !within((50.0, 5.0)), "{} {off:?}", model.name());
    }
}

/// Four lengths fit the nine coordinates of the poses to within the precision of the joint positions.
#[test]
fn the_lengths_of_the_newer_controllers_arm_are_calibrated() {
    let published = Model::named("MiniCobo").expect("published");
    let mut dh = super::calibrated::reply(published);
    (dh.a[2], dh.d[0], dh.d[3], dh.d[5]) = (210.360_844, 186.202_853, 210.987_879, 159.898_996);
    let (arm, tool) = (published.with_dh(&dh).expect("near"), from_pose([0.0, 0.0, 0.0, 180.0, 0.0, 0.0]));
    for (joints, pose) in CAPTURED_NEWER {
        assert_close(&(arm.forward(joints) * tool), &from_pose(pose), (0.000_05, 0.000_02), "MiniCobo");
    }
}

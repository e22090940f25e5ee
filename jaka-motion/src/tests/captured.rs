//! What a real Zu 5 with firmware 1.5.14 answered to `get_joint_pos` and `get_tcp_pos`, with the flange as its tool.

use super::{assert_close, from_pose};
use crate::Model;

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

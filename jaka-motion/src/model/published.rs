//! Published arms.
//!
//! Sources: the URDF files of the vendor's ROS 2 package, `JakaCobot/jaka_ros2`
//! `src/jaka_description/urdf/jaka_*.urdf` (commit 7e985b78, September 2025). Each gives the frame of every joint, the
//! source of the parameters here, the joint limits (rounded in radians there: -1.48 to 4.62 is -85 to 265 degrees, 3.05
//! is 175) and the joint speeds. The Zu, Pro 16 and `MiniCobo` lengths and the limits in degrees agree with the Python
//! package `robotkinematicscatalogue` 1.1.2 (`JAKA_*.py`), and speeds and most lengths with the Rust crate `libjaka`
//! 0.1.16 (`src/jaka/jaka_*.rs`), apart from signs and from:
//! - Zu 7: the URDF has 303.53 for the forearm; both others, and the URDF of C7, S7 and Pro 7, have 303.5, followed
//!   here.
//! - Zu 3: both others have a 246 and d6 105, and d4 116 and 113; the URDF, followed here, has 248, 106.5 and 115.
//! - Zu 12 and Zu 18: the catalogue has tighter limits, followed here: 270 degrees for joints 1, 5 and 6, and on the Zu
//!   18 -50 to 230 for joint 2 and 155 for joint 3.
//! - A12: only `jaka_a12.urdf` has it. Its wrist differs from those of all other arms.
//! - A5: `libjaka` has d4 114, and 265 deg/s for joints 4 to 6.
//! - `MiniCobo`: the catalogue has 125 degrees for joint 2; `libjaka` has 180 deg/s.
//!
//! All other details of the URDF files are noise of the drawings and are left out: lateral offsets under 0.4 mm, the
//! position of the base mesh, the rotation of joint 6's mesh on the S7. `tests/tests/offline/kinematics.rs` of the
//! repository compares each model with its chain.

use super::Model;
use crate::closed_form::{ClosedForm, Precision, Wrist};
use crate::links::Links;

pub(super) static PUBLISHED: [Model; 21] = [
    arm("Zu 5", [120.15, 430.0, 368.5, 114.0, 113.5, 107.0], EVEN_180),
    arm("Zu 3", [150.55, 248.0, 228.0, 115.0, 117.5, 106.5], [180.0, 180.0, 180.0, 220.0, 220.0, 220.0]),
    arm("Zu 7", [120.15, 360.0, 303.5, 115.01, 113.5, 107.0], EVEN_180),
    Model {
        joint_min: [-270.0, -85.0, -175.0, -85.0, -270.0, -270.0],
        joint_max: [270.0, 265.0, 175.0, 265.0, 270.0, 270.0],
        ..arm("Zu 12", [142.65, 595.0, 571.5, 131.5, 115.0, 103.5], SLOW_BASE)
    },
    Model {
        joint_min: [-270.0, -50.0, -155.0, -85.0, -270.0, -270.0],
        joint_max: [270.0, 230.0, 155.0, 265.0, 270.0, 270.0],
        ..arm("Zu 18", [142.65, 510.0, 400.0, 154.0, 115.0, 103.5], SLOW_SHOULDER)
    },
    arm("Zu 20", [196.5, 897.0, 744.5, 188.35, 138.5, 120.5], FAST_WRIST),
    arm("Zu 30", [196.5, 662.5, 549.0, 188.35, 138.5, 120.5], FAST_WRIST),
    arm("Pro 5", [120.15, 430.0, 368.5, 114.0, 113.5, 107.0], EVEN_180),
    arm("Pro 7", [120.15, 360.0, 303.5, 115.02, 113.5, 107.0], EVEN_180),
    arm("Pro 12", [142.65, 595.0, 571.5, 131.5, 115.0, 103.5], SLOW_BASE),
    arm("Pro 16", [196.5, 819.0, 687.0, 158.01, 144.15, 126.65], SLOW_BASE),
    arm("Pro 18", [142.65, 510.0, 400.0, 154.0, 115.0, 103.5], SLOW_SHOULDER),
    arm("S5", [120.15, 430.0, 368.5, 114.0, 113.5, 117.5], EVEN_180),
    arm("S7", [120.15, 360.0, 303.5, 115.01, 113.5, 117.5], EVEN_180),
    arm("S12", [142.65, 595.0, 571.5, 131.5, 115.0, 112.0], SLOW_BASE),
    arm("C5", [120.15, 430.0, 368.5, 114.0, 113.5, 107.0], EVEN_180),
    arm("C7", [120.15, 360.0, 303.5, 115.01, 113.5, 107.0], EVEN_180),
    arm("C12", [142.65, 595.0, 571.5, 131.5, 115.0, 103.5], [120.0, 120.0, 120.0, 150.0, 150.0, 150.0]),
    arm("A5", [120.15, 430.0, 368.5, 115.0, 113.5, 107.0], [210.0; 6]),
    A12,
    MINICOBO,
];

const EVEN_180: [f64; 6] = [180.0; 6];
const SLOW_BASE: [f64; 6] = [120.0, 120.0, 120.0, 180.0, 180.0, 180.0];
const SLOW_SHOULDER: [f64; 6] = [120.0, 120.0, 180.0, 180.0, 180.0, 180.0];
const FAST_WRIST: [f64; 6] = [120.0, 120.0, 120.0, 220.0, 220.0, 220.0];

/// Returns an arm whose joints 2, 3 and 4 are parallel, from its lengths in mm: base height, upper arm, forearm, and
/// the offsets of joints 4, 5 and 6.
const fn arm(name: &'static str, lengths: [f64; 6], joint_speed: [f64; 6]) -> Model {
    let [base, upper_arm, forearm, wrist_1, wrist_2, wrist_3] = lengths;
    let links = Links {
        alpha: [0.0, 90.0, 0.0, 0.0, 90.0, -90.0],
        a: [0.0, 0.0, upper_arm, forearm, 0.0, 0.0],
        d: [base, 0.0, 0.0, -wrist_1, wrist_2, wrist_3],
        joint_home_offset: [0.0; 6],
    };
    Model {
        name,
        links,
        closed_form: ClosedForm { links, wrist: Wrist::Parallel, precision: Precision::Exact },
        joint_min: [-360.0, -85.0, -175.0, -85.0, -360.0, -360.0],
        joint_max: [360.0, 265.0, 175.0, 265.0, 360.0, 360.0],
        joint_speed,
    }
}

/// Arm whose forearm turns about itself, with an offset in its wrist. The drawing has no ranges except two turns for
/// each joint.
const A12: Model = {
    let links = Links {
        alpha: [0.0, 90.0, 0.0, 90.0, 90.0, 90.0],
        a: [0.0, 0.0, 770.0, 0.0, 0.0, 0.0],
        d: [142.65, 0.0, 37.5, 551.5, 115.0, 103.5],
        joint_home_offset: [0.0, 0.0, 90.0, 180.0, 90.0, 0.0],
    };
    Model {
        name: "A12",
        links,
        closed_form: ClosedForm { links, wrist: Wrist::Offset, precision: Precision::Exact },
        joint_min: [-360.0; 6],
        joint_max: [360.0; 6],
        joint_speed: [150.0, 150.0, 210.0, 210.0, 210.0, 210.0],
    }
};

/// Small arm with a spherical wrist, upright at zero.
const MINICOBO: Model = {
    let links = Links {
        alpha: [0.0, 90.0, 0.0, -90.0, 90.0, -90.0],
        a: [0.0, 0.0, 210.0, 0.0, 0.0, 0.0],
        d: [187.0, 6.0, 0.0, 210.5, 0.0, 159.3],
        joint_home_offset: [0.0, 90.0, -90.0, 0.0, 0.0, 0.0],
    };
    Model {
        name: "MiniCobo",
        links,
        closed_form: ClosedForm { links, wrist: Wrist::Spherical, precision: Precision::Exact },
        joint_min: [-360.0, -120.0, -130.0, -360.0, -120.0, -360.0],
        joint_max: [360.0, 120.0, 130.0, 360.0, 120.0, 360.0],
        joint_speed: [90.0; 6],
    }
};

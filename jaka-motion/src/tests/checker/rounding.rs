//! Rounding does not add up from motion to motion, and refuses nothing.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::{ELBOW_UP, SLOW, amidst, bare, moved, with_region, zu5};
use crate::tests::Random;
use crate::{JointSpeed, Limits, Model, Point, Region, Transform};

const CYCLE: f64 = 0.008;
/// Step that is a little less than the rounding allowance.
const CREEP: f64 = 0.99e-5;
const STEPS: u32 = 200;

/// Returns the final excess over the limit, if each motion starts at the end of the one before.
fn crept<T: Copy>(start: T, next: impl Fn(T) -> Option<T>, excess: impl Fn(T) -> f64) -> f64 {
    let mut here = start;
    for _ in 0..STEPS {
        let Some(there) = next(here) else { break };
        here = there;
    }
    excess(here)
}

#[test]
fn a_joint_does_not_creep_out_of_its_range() {
    let checker = bare(zu5());
    let asked = JointSpeed { speed_deg_s: 1.0, acceleration_deg_s2: Some(1.0) };
    for (limit, outward) in [(175.0, 1.0), (-175.0, -1.0)] {
        let mut start = ELBOW_UP;
        start[2] = limit;
        let out = |joints: JointPosition| {
            let mut joints = joints.0;
            joints[2] += outward * CREEP;
            JointPosition(joints)
        };
        let set_point = |[before, last]: [JointPosition; 2]| {
            checker.check_set_point([before, last], out(last), CYCLE).ok().map(|()| [last, out(last)])
        };
        let excess = |joints: JointPosition| outward * (joints.0[2] - limit);
        let by = crept([start.into(); 2], set_point, |before| excess(before[1]));
        assert!(by < 2.0 * CREEP, "{by}");
        let joint_way = |from| checker.check_joint_way(from, out(from), asked).ok().map(|()| out(from));
        let by = crept(start.into(), joint_way, excess);
        assert!(by < 2.0 * CREEP, "{by}");
    }
}

#[test]
fn a_point_does_not_creep_out_of_a_region() {
    let floor = moved(ELBOW_UP, [0.0; 3]).z;
    let limits = with_region(Region::half_space("floor", [0.0, 0.0, floor], [0.0, 0.0, 1.0]));
    let checker = bare(limits.with_joint_accelerations([1e9; 6]).expect("above 0"));
    let height = |joints: JointPosition| Pose::from(Model::default().forward(joints)).z;
    let lower = |joints: JointPosition| moved(joints.0, [0.0, 0.0, -CREEP]);
    let line = |from| checker.check_line(from, lower(from), SLOW).ok();
    let set_point = |from| checker.check_pose_set_point([from; 2], lower(from), CYCLE).ok();
    for by in [
        crept(ELBOW_UP.into(), line, |joints| floor - height(joints)),
        crept(ELBOW_UP.into(), set_point, |joints| floor - height(joints)),
    ] {
        assert!(by < 2.0 * CREEP, "{by}");
    }
}

#[test]
fn a_pose_does_not_creep_to_a_singularity() {
    let model = Model::default();
    let checker = bare(zu5().with_joint_accelerations([1e9; 6]).expect("above 0"));
    let start = [0.0, 60.0, -80.0, 190.0, 0.01_f64.asin().to_degrees(), 0.0];
    let nearer = |joints: JointPosition| {
        let mut joints = joints.0;
        joints[4] -= CREEP.to_degrees();
        model.forward(joints).into()
    };
    let set_point = |from| checker.check_pose_set_point([from; 2], nearer(from), CYCLE).ok();
    let line = |from| checker.check_line(from, nearer(from), SLOW).ok();
    let excess = |joints| 0.01 - model.singularity_distance(joints).wrist;
    for by in [crept(start.into(), set_point, excess), crept(start.into(), line, excess)] {
        assert!(by < 2.0 * CREEP, "{by}");
    }
}

/// Only joint 6 turns: the other joints, elbow and wrist stay equally far beyond.
#[test]
fn what_stays_beyond_a_limit_is_not_refused() {
    let mut random = Random::new(97);
    for model in Model::published() {
        for odd in 0..12 {
            let mut from = amidst(&mut random, &Limits::of(model));
            from[5] = 0.0;
            let mut limits = nowhere_far_enough(model);
            match odd % 3 {
                0 => limits = beyond_ranges_and_regions(limits, from),
                1 => from[4] = random.between(0.05, 0.5),
                _ => from[2] = random.between(0.05, 0.5),
            }
            let checker = bare(limits);
            let turn = Pose::from_millimetres_degrees([0.0; 3], [0.0, 0.0, random.between(-100.0, 100.0)]);
            let to = (model.forward(from) * Transform::from(turn)).into();
            let found = checker.check_line(from.into(), to, SLOW);
            assert!(found.is_ok(), "{} {from:?}: {found:?}", model.name());
            let to = (model.forward(from) * Transform::from(Pose { rz: 0.5, ..turn })).into();
            let found = checker.check_pose_set_point([from.into(); 2], to, CYCLE);
            assert!(found.is_ok(), "{} {from:?}: {found:?}", model.name());
        }
    }
}

/// Returns limits with a least distance that no place keeps from a singularity.
fn nowhere_far_enough(model: &Model) -> Limits {
    let limits = Limits::of(model).with_joint_accelerations([1e9; 6]).expect("above 0");
    limits.with_singularity_distance(0.999).expect("a distance")
}

/// Returns limits for which joints 1 to 5 are beyond their ranges, and all points beyond a region.
fn beyond_ranges_and_regions(mut limits: Limits, from: [f64; 6]) -> Limits {
    for (joint, at) in (1..6).zip(from) {
        limits = limits.with_joint_range(joint, at - 20.0, at - 10.0).expect("tighter");
    }
    for point in [Point::Tcp, Point::Elbow, Point::Wrist] {
        for (number, inward) in [[1.0, 0.3, 0.2], [-0.2, 0.5, -1.0], [0.1, -1.0, 0.7]].into_iter().enumerate() {
            let region = Region::half_space(format!("{point} {number}"), inward.map(|part| part * 1e4), inward);
            limits = limits.with_region(region.expect("a region").of(point)).expect("another name");
        }
    }
    limits
}

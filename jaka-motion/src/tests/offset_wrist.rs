//! The A12, whose wrist has an offset, against its drawing and against searches without a closed form.

use std::f64::consts::FRAC_PI_2;

use jaka_proto::messages::types::Pose;

use super::{Random, apart, from_pose, to_pose};
use crate::{Branches, Checker, Frames, Limits, Model, NoSolution, TcpSpeed, Transform};

/// Rotation and position in mm.
type Frame = [[f64; 4]; 3];

/// Origins of the joints: x, y and z in metres, roll, pitch and yaw in quarter turns, which are 1.5708 in
/// `jaka_a12.urdf` of `JakaCobot/jaka_ros2`; 0.09 mm of the first are left out. Each turns about its z axis.
const DRAWN: [[f64; 6]; 6] = [
    [0.0, 0.0, 0.14265, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [0.77, 0.0, 0.0375, 0.0, 0.0, 1.0],
    [0.0, -0.5515, 0.0, -1.0, 0.0, -2.0],
    [0.0, -0.115, 0.0, -1.0, -1.0, 2.0],
    [0.0, -0.1035, 0.0, 1.0, 0.0, 0.0],
];
/// Difference of a joint below which two solutions are one, in degrees.
const SAME: f64 = 1e-3;
/// Radians to degrees: `1e-6` radians.
const CLOSE: f64 = 6e-5;

fn a12() -> &'static Model {
    Model::named("A12").expect("published")
}

fn product(one: &Frame, other: &Frame) -> Frame {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let sum: f64 = (0..3).map(|inner| one[row][inner] * other[inner][column]).sum();
            if column == 3 { sum + one[row][3] } else { sum }
        })
    })
}

fn turn(axis: usize, angle: f64) -> Frame {
    let (next, last, (sin, cos)) = ((axis + 1) % 3, (axis + 2) % 3, angle.sin_cos());
    let mut frame = [[0.0; 4]; 3];
    frame[axis][axis] = 1.0;
    (frame[next][next], frame[next][last]) = (cos, -sin);
    (frame[last][next], frame[last][last]) = (sin, cos);
    frame
}

/// Returns the frames of the joints for joint positions in degrees, by the drawing.
fn drawn(joints: [f64; 6]) -> [Frame; 6] {
    let mut frame = turn(2, 0.0);
    std::array::from_fn(|joint| {
        let [x, y, z, roll, pitch, yaw] = DRAWN[joint];
        let turned = |axis, quarters: f64| turn(axis, quarters * FRAC_PI_2);
        let mut origin = product(&turned(2, yaw), &product(&turned(1, pitch), &turned(0, roll)));
        for (row, length) in origin.iter_mut().zip([x, y, z]) {
            row[3] = 1e3 * length;
        }
        frame = product(&product(&frame, &origin), &turn(2, joints[joint].to_radians()));
        frame
    })
}

/// Returns the distance of one frame from another: mm, and thousandths of a radian.
fn off(from: &Frame, to: &Frame) -> [f64; 6] {
    let mut off = [0.0; 6];
    for row in 0..3 {
        off[row] = to[row][3] - from[row][3];
    }
    for column in 0..3 {
        let (from, to) = (from.map(|row| row[column]), to.map(|row| row[column]));
        for (axis, off) in off[3..].iter_mut().enumerate() {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            *off += 500.0 * (from[next] * to[last] - from[last] * to[next]);
        }
    }
    off
}

fn size(off: &[f64; 6]) -> f64 {
    off.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// Returns the motion of the flange with the joints, in the unit of [`off`] for a radian.
fn slopes(frames: &[Frame; 6]) -> [[f64; 6]; 6] {
    let mut rows = [[0.0; 6]; 6];
    for (joint, frame) in frames.iter().enumerate() {
        let axis = frame.map(|row| row[2]);
        let lever: [f64; 3] = std::array::from_fn(|row| frames[5][row][3] - frame[row][3]);
        for row in 0..3 {
            let (next, last) = ((row + 1) % 3, (row + 2) % 3);
            rows[row][joint] = axis[next] * lever[last] - axis[last] * lever[next];
            rows[row + 3][joint] = 1e3 * axis[row];
        }
    }
    rows
}

/// Solves six equations by elimination; also returns the determinant.
fn solved(mut rows: [[f64; 6]; 6], mut right: [f64; 6]) -> ([f64; 6], f64) {
    let mut determinant = 1.0;
    for pivot in 0..6 {
        let best = (pivot..6).max_by(|one, other| rows[*one][pivot].abs().total_cmp(&rows[*other][pivot].abs()));
        let best = best.expect("a row is left");
        if best != pivot {
            rows.swap(pivot, best);
            right.swap(pivot, best);
            determinant = -determinant;
        }
        determinant *= rows[pivot][pivot];
        for row in (0..6).filter(|row| *row != pivot) {
            let factor = rows[row][pivot] / rows[pivot][pivot];
            let from = rows[pivot];
            rows[row].iter_mut().zip(from).for_each(|(entry, from)| *entry -= factor * from);
            right[row] -= factor * right[pivot];
        }
    }
    (std::array::from_fn(|row| right[row] / rows[row][row]), determinant)
}

/// Returns the joint positions that Newton's method reaches from a start, if it reaches any.
fn searched(target: &Frame, mut joints: [f64; 6]) -> Option<[f64; 6]> {
    for _ in 0..60 {
        let frames = drawn(joints);
        let off = off(&frames[5], target);
        if size(&off) < 1e-9 {
            // A flange that is turned by half a turn has no error either.
            let alike: f64 =
                frames[5].iter().zip(target).flat_map(|(one, other)| (0..3).map(|at| one[at] * other[at])).sum();
            return (alike > 2.9).then_some(joints);
        }
        let (step, _) = solved(slopes(&frames), off);
        let longest = step.iter().fold(0.0_f64, |longest, step| longest.max(step.abs()));
        if !longest.is_finite() {
            return None;
        }
        let share = (0.5 / longest).min(1.0);
        joints = std::array::from_fn(|joint| joints[joint] + share * step[joint].to_degrees());
    }
    None
}

fn differ(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    let apart = |(one, other): (&f64, &f64)| ((one - other + 180.0).rem_euclid(360.0) - 180.0).abs();
    one.iter().zip(other).map(apart).fold(0.0, f64::max)
}

fn transform(frame: &Frame) -> Transform {
    let rows = frame.map(|[x, y, z, _]| [x, y, z]);
    let pose = Pose::from_millimetres_degrees(frame.map(|row| row[3]), [0.0; 3]);
    pose.with_rotation_matrix(rows).expect("a rotation").into()
}

fn frame(of: &Transform) -> Frame {
    let (turn, place) = (of.0.rotation.to_rotation_matrix(), of.0.translation.vector);
    std::array::from_fn(|row| [turn[(row, 0)], turn[(row, 1)], turn[(row, 2)], place[row]])
}

#[track_caller]
fn reproduce(branches: &Branches, target: &Frame, what: &[f64; 6]) {
    for (index, joints) in branches.iter().enumerate() {
        let off = size(&off(&drawn(joints.0)[5], target));
        assert!(off < 1e-3, "{what:?} {joints}: {off}");
        for other in &branches[..index] {
            assert!(differ(&joints.0, &other.0) > CLOSE, "{what:?}: {joints} twice");
        }
    }
}

#[test]
fn forward_is_the_product_of_the_drawing() {
    let (model, mut random) = (a12(), Random::new(2101));
    for _ in 0..1_000 {
        let joints = random.joints(model);
        for (found, drawn) in model.joint_frames(joints).iter().zip(drawn(joints)) {
            let (moved, turned) = apart(found, &transform(&drawn));
            assert!(moved < 1e-9 && turned < 1e-9, "{joints:?}: {moved} mm, {turned} degrees");
        }
    }
}

#[test]
fn each_position_is_among_those_of_its_pose() {
    let (model, mut random, mut most) = (a12(), Random::new(2102), 0);
    for _ in 0..2_000 {
        let joints = random.joints(model);
        let target = drawn(joints)[5];
        let branches = model.inverse_all(transform(&target), joints).expect("reachable");
        let nearest = branches.iter().map(|found| found.max_distance(&joints.into())).fold(f64::INFINITY, f64::min);
        assert!(nearest < CLOSE, "{joints:?}: {nearest} {branches:?}");
        reproduce(&branches, &target, &joints);
        most = most.max(branches.len());
    }
    assert!((13..=16).contains(&most), "{most}");
}

/// The search reaches some branch from each of many starts, and each branch from all of them.
#[test]
fn a_search_finds_as_many_branches() {
    let (model, mut random) = (a12(), Random::new(2103));
    for _ in 0..30 {
        let joints = random.joints(model);
        let target = drawn(joints)[5];
        let branches = model.inverse_all(transform(&target), joints).expect("reachable");
        let mut found: Vec<[f64; 6]> = Vec::new();
        for start in 0..600 {
            let mut from: [f64; 6] = random.joints(model);
            from[5] = f64::from(start) * 360.0 / 600.0;
            let Some(joints) = searched(&target, from) else { continue };
            if !found.iter().any(|other| differ(&joints, other) < SAME) {
                found.push(joints);
            }
        }
        for joints in &found {
            assert!(branches.iter().any(|branch| differ(&branch.0, joints) < SAME), "{joints:?} {branches:?}");
        }
        assert_eq!(branches.len(), found.len(), "{joints:?} {branches:?} {found:?}");
    }
}

/// A search finds no joints for a pose that the model refuses, and vice versa.
#[test]
fn a_search_finds_nothing_where_nothing_is_found() {
    let (model, mut random) = (a12(), Random::new(2104));
    let (mut reachable, mut far, mut turned) = (0, 0, 0);
    for _ in 0..150 {
        let direction: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let size = random.between(1290.0, 1345.0) / direction.iter().map(|part| part * part).sum::<f64>().sqrt();
        let ([x, y, z], turn) = (direction.map(|part| part * size), [(); 3].map(|()| random.between(-180.0, 180.0)));
        let wrist = from_pose([x, y, z + 142.65, turn[0], turn[1], turn[2]]);
        let target = wrist * from_pose([0.0, 0.0, 103.5, 0.0, 0.0, 0.0]);
        let found = (0..60).find_map(|_| searched(&frame(&target), random.joints(model)));
        match (model.inverse(target, [0.0; 6]), found) {
            (Ok(_), Some(_)) => reachable += 1,
            (Err(NoSolution::OutOfReach { by_mm }), None) if by_mm > 0.0 => far += 1,
            (Err(NoSolution::Orientation), None) => turned += 1,
            (refused, found) => panic!("{target:?}: {refused:?}, and the search has {found:?}"),
        }
    }
    assert!(reachable > 90 && far > 20 && turned > 3, "{reachable} {far} {turned}");
}

/// Upper arm and forearm with the wrist's offset are in one line, at the distance of the arm from its plane.
#[test]
fn out_of_reach_says_by_how_much_at_least() {
    let most = 770.0_f64.hypot(37.5) + 551.5_f64.hypot(115.0);
    for by in [0.01, 1.0, 200.0, 5e4] {
        let refused = a12().inverse(from_pose([most + by, 0.0, 142.65 - 103.5, 180.0, 0.0, 0.0]), [0.0; 6]);
        assert!(matches!(refused, Err(NoSolution::OutOfReach { by_mm }) if (by_mm - by).abs() < 1e-6), "{refused:?}");
    }
    let refused = a12().inverse(from_pose([most - 1.0, 0.0, 142.65 - 103.5, 180.0, 0.0, 0.0]), [0.0; 6]).unwrap_err();
    assert_eq!((refused, refused.to_string()), (NoSolution::Orientation, "the orientation is out of reach".to_owned()));
    let inner = 770.0_f64.hypot(37.5) - 551.5_f64.hypot(115.0);
    let refused = a12().inverse(from_pose([inner - 2.0, 0.0, 142.65 - 103.5, 180.0, 0.0, 0.0]), [0.0; 6]);
    assert!(matches!(refused, Err(NoSolution::OutOfReach { by_mm }) if (by_mm - 2.0).abs() < 1e-6), "{refused:?}");
}

/// The measure is the determinant of the drawing's Jacobian, by elimination.
#[test]
fn the_distance_from_singularities_is_the_determinant() {
    let (model, mut random, mut most) = (a12(), Random::new(2105), 0.0_f64);
    for _ in 0..5_000 {
        let joints = random.joints(model);
        let (_, determinant) = solved(slopes(&drawn(joints)), [0.0; 6]);
        // The rows of turns have a factor of a thousand.
        let share = determinant / 1e9 / (770.0 * 551.5 * (770.0 + 551.5));
        let distance = model.singularity_distance(joints);
        assert!((distance.wrist - share.abs()).abs() < 1e-9, "{joints:?} {distance:?} {share}");
        assert_eq!((distance.shoulder, distance.elbow), (1.0, 1.0));
        most = most.max(distance.wrist);
    }
    assert!(0.75 < most && most < 0.85, "{most}");
}

/// Returns joint positions at a singularity, found by the drawing.
fn singular(random: &mut Random) -> [f64; 6] {
    let side = |joints: [f64; 6]| solved(slopes(&drawn(joints)), [0.0; 6]).1 > 0.0;
    loop {
        let mut from = random.joints(a12()).map(|joint| joint / 2.0);
        let mut to = from;
        to[4] += 40.0;
        if side(from) == side(to) {
            continue;
        }
        for _ in 0..60 {
            let middle = std::array::from_fn(|joint| f64::midpoint(from[joint], to[joint]));
            *(if side(middle) == side(from) { &mut from } else { &mut to }) = middle;
        }
        return from;
    }
}

/// Two branches that meet at a singularity are one; next to it they are distinct.
#[test]
fn branches_that_meet_are_neither_lost_nor_doubled() {
    let (model, mut random, mut both) = (a12(), Random::new(2106), 0);
    for _ in 0..200 {
        let on = singular(&mut random);
        for beside in [0.0, 1e-9, 1e-6, 1e-3, 0.1, 1.0] {
            let mut joints = on;
            joints[4] += beside;
            let target = drawn(joints)[5];
            let found = model.inverse(transform(&target), joints).expect("reachable").0;
            let branches = model.inverse_all(transform(&target), joints).expect("reachable");
            // At a singularity the flange hardly moves within a tenth of a degree.
            let close = if beside < 0.05 { 0.1 } else { CLOSE };
            assert!(
                differ(&found, &joints) < close && differ(&branches[0].0, &joints) < close,
                "{beside} {joints:?} {found:?}"
            );
            reproduce(&branches, &target, &joints);
            let distance = model.singularity_distance(joints);
            assert!(beside > 0.0 || distance.smallest_singular_value < 1e-9, "{joints:?} {distance:?}");
            let near = branches.iter().filter(|branch| differ(&branch.0, &joints) < 0.1).count();
            assert!(near == 1 || beside > 1e-6, "{joints:?} {branches:?}");
            let is_pair = |branch: &&_| differ(branch, &joints) < 60.0 * beside;
            both += i32::from(beside > 0.05 && branches.iter().map(|branch| &branch.0).filter(is_pair).count() > 1);
        }
    }
    assert!(both > 300, "{both}");
}

/// With joint 6 on the axis of joint 1 and the forearm upright, any position of joint 6 would do.
#[test]
fn above_the_base_joint_6_keeps_the_reference() {
    let (model, mut random, mut solved) = (a12(), Random::new(2107), 0);
    let aside = (115.0_f64.powi(2) - 37.5_f64.powi(2)).sqrt();
    let elbow = (770.0_f64.powi(2) - aside * aside).sqrt();
    for (upper_arm, forearm) in [(elbow, 551.5), (elbow, -551.5), (-elbow, 551.5), (-elbow, -551.5)] {
        for (upright, flange) in [(0.0, 103.5), (180.0, -103.5)] {
            for off_axis in [0.0, 0.0, 1e-9, 1e-7, 1e-5, 1e-3, 0.1, 3.0] {
                let height = 142.65 + upper_arm + forearm + flange;
                let target = from_pose([off_axis, 0.0, height, upright, 0.0, random.between(-180.0, 180.0)]);
                let reference = random.joints(model);
                let Ok(found) = model.inverse(target, reference) else {
                    assert!(off_axis > 1e-6, "{target:?} {reference:?}");
                    continue;
                };
                solved += 1;
                assert!(off_axis > 0.0 || (found.0[5] - reference[5]).abs() < 0.01, "{reference:?} {found}");
                let branches = model.inverse_all(target, reference).expect("reachable");
                reproduce(&branches, &frame(&target), &reference);
            }
        }
    }
    assert!(solved > 40, "{solved}");
}

/// The steps of the checker rely on this bound.
#[test]
fn the_distance_from_singularities_changes_no_faster_than_its_bound() {
    let (model, mut random, mut closest) = (a12(), Random::new(2108), 0.0_f64);
    let checker = Checker::new(Limits::of(model), Frames::new());
    for _ in 0..20_000 {
        let joints = random.joints(model);
        let joint = random.below(6);
        let mut turned = [0.0; 6];
        turned[joint] = random.between(0.001, 0.1);
        let moved = std::array::from_fn(|index| joints[index] + f64::to_degrees(turned[index]));
        let change = checker.signed_distances(&moved)[2] - checker.signed_distances(&joints)[2];
        let bound = checker.arm().radii().distances_change(&turned);
        assert!(change.abs() <= bound[2] + 1e-12 && bound[..2] == [0.0; 2], "{joints:?} {change} {bound:?}");
        if bound[2] > 0.0 {
            closest = closest.max(change.abs() / bound[2]);
        }
    }
    assert!(closest > 0.5, "{closest}");
}

/// Towards the edge of reach the tool keeps its orientation until no joints can; the checker follows the path up to
/// there.
#[test]
fn lines_are_followed_and_told_where_the_orientation_ends() {
    let checker = Checker::new(Limits::of(a12()), Frames::new());
    let (joints, slow) = ([0.0, 40.0, -80.0, 30.0, 70.0, 20.0], TcpSpeed { speed_mm_s: 20.0, tolerance_mm: 0.0 });
    let from = a12().forward(joints);
    let ahead = |mm: f64| Pose { x: Pose::from(from).x + mm, ..from.into() };
    let found = checker.check_line(joints.into(), ahead(60.0), slow).expect("clear");
    assert!(a12().forward(found).distance_mm(&ahead(60.0).into()) < 1e-6, "{found}");
    // At the first pose out of reach, only the orientation is.
    let is_turned = |mm: &f64| a12().inverse(ahead(*mm), joints) == Err(NoSolution::Orientation);
    let edge = (0..2_000).map(f64::from).find(is_turned).expect("there is an edge");
    let words = checker.check_line(joints.into(), ahead(edge), slow).expect_err("too far").to_string();
    assert_eq!(words, "the orientation is out of reach (A12)");
    let words = checker.check_pose_set_point([joints.into(); 2], ahead(edge), 0.008).expect_err("too far").to_string();
    assert_eq!(words, "the orientation is out of reach (A12)");
}

/// The poses have six decimals, as on the wire; half of them are beyond the joints' reach by that rounding.
#[test]
fn a_singular_arm_is_found_by_a_rounded_pose() {
    let (model, mut random) = (a12(), Random::new(2109));
    for _ in 0..500 {
        let joints = singular(&mut random);
        let rounded = to_pose(model.forward(joints)).map(|number| (number * 1e6).round() / 1e6);
        let found = model.inverse(from_pose(rounded), joints).expect("reachable");
        let (moved, turned) = apart(&model.forward(found), &from_pose(rounded));
        assert!(moved < 1e-3 && turned < 1e-4, "{joints:?} {found}");
        assert!(differ(&found.0, &joints) < 2.0, "{joints:?} {found}");
    }
}

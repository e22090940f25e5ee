//! jaka-motion against a second computation from the vendor's drawings, which shares no code with it.

use std::time::Duration;

use jaka_motion::{Model, NoSolution};
use jaka_proto::messages::types::Pose;
use jaka_sim::{Controller, Delays};
use jaka_sync::Client;
use jaka_sync::motion::{JointMove, MoveL};
use jaka_tests::witness::{Frame, Witness, apart, pose};

/// Joint positions of each arm. All of the promise: 10,000.
const POSITIONS: u64 = 10_000;

/// Evenly spread numbers from 0 to 1 (`SplitMix64`).
fn share(seed: u64) -> f64 {
    let mut bits = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    f64::from(u32::try_from((bits ^ (bits >> 31)) >> 32).expect("32 bits are left")) / f64::from(u32::MAX)
}

fn joints(model: &Model, seed: u64) -> [f64; 6] {
    std::array::from_fn(|joint| {
        let (min, max) = (model.joint_min()[joint], model.joint_max()[joint]);
        min + (max - min) * share(seed * 6 + joint as u64 + 1)
    })
}

fn frame(of: Pose) -> Frame {
    pose(of.position_mm(), of.rotation_rad())
}

/// The largest differences in mm and degrees over so many joint positions.
fn worst(model: &Model, witness: &Witness, positions: u64) -> (f64, f64) {
    (0..positions).map(|seed| joints(model, seed)).fold((0.0, 0.0), |(moved, turned): (f64, f64), joints| {
        let (here, there) = apart(frame(model.forward(joints).into()), witness.flange(joints));
        (moved.max(here), turned.max(there))
    })
}

#[test]
fn forward_is_what_the_witness_computes() {
    assert_eq!(Witness::names().count(), 21);
    for name in Witness::names() {
        let model = Model::named(name).expect("published");
        let (moved, turned) = worst(model, &Witness::published(name), POSITIONS);
        assert!(moved < 1e-6 && turned < 1e-6, "{name}: {moved} mm, {turned} degrees");
    }
    assert_eq!(Model::published().len(), 21);
}

/// The drawings round a quarter turn to 1.5708, which the witness puts right, and have up to 0.39 mm of noise a joint.
#[test]
fn forward_is_near_the_drawings() {
    for name in Witness::names() {
        let model = Model::named(name).expect("published");
        let (moved, turned) = worst(model, &Witness::drawn(name), 200);
        assert!(moved < 0.4 && turned < 0.01, "{name}: {moved} mm, {turned} degrees");
    }
    // The default's drawing has no more than 0.012 mm.
    let (moved, turned) = worst(&Model::default(), &Witness::drawn("Zu 5"), 1_000);
    assert!(moved < 0.012 && turned < 1e-6, "{moved} mm, {turned} degrees");
}

/// At each cycle of a motion in joints and of one on a line.
#[test]
fn a_simulated_arm_is_where_the_witness_says() {
    for name in ["Zu 5", "A12", "MiniCobo"] {
        let builder = Controller::builder().model(Model::named(name).expect("published").clone());
        let builder = builder.delays(Delays::NONE).stepped_clock().status_period(Duration::MAX);
        let controller = builder.start().expect("loopback has free ports");
        let mut client = Client::connect(controller.command_addr()).expect("the controller listens");
        client.power_on().expect("it answers");
        client.enable_robot().expect("it answers");
        let turn = JointMove::relative([20.0, -10.0, 15.0, 5.0, 10.0, 40.0], 30.0);
        client.joint_move(&turn).expect("it is in range");
        client.move_l(&MoveL::relative([20.0, 10.0, -30.0, 0.0, 0.0, 5.0], 50.0)).expect("it is reachable");
        let (witness, start) = (Witness::published(name), controller.state().joint_position);
        for _ in 0..400 {
            controller.advance(Duration::from_millis(8));
            let state = controller.state();
            let (moved, turned) = apart(frame(state.tcp_pose), witness.flange(state.joint_position.0));
            assert!(moved < 1e-6 && turned < 1e-6, "{name} {}: {moved} mm, {turned} degrees", state.joint_position);
        }
        assert!(controller.state().joint_position.max_distance(&start) > 20.0 && controller.state().at_rest, "{name}");
    }
}

/// Dense sampling: where the witness says that some joint positions bring the flange, the inverse finds some.
#[test]
fn what_some_joints_reach_is_found() {
    for name in Witness::names() {
        let (model, witness) = (Model::named(name).expect("published"), Witness::published(name));
        for seed in 0..POSITIONS / 5 {
            let (joints, reference) = (joints(model, seed), joints(model, seed + POSITIONS));
            let target = witness.flange(joints);
            let found = model.inverse(as_pose(target), reference);
            let found = found.unwrap_or_else(|error| panic!("{name} {joints:?}: {error}"));
            let (moved, turned) = apart(witness.flange(found.0), target);
            assert!(moved < 0.001 && turned < 0.0001, "{name} {joints:?}: {moved} mm, {turned} degrees");
        }
    }
}

fn as_pose(frame: Frame) -> Pose {
    let place = frame.map(|row| row[3]);
    let rows = frame.map(|[x, y, z, _]| [x, y, z]);
    Pose::from_millimetres_degrees(place, [0.0; 3]).with_rotation_matrix(rows).expect("the witness gives rotations")
}

/// Checks that a refused pose cannot be reached: a search by the witness alone, from many joint positions, finds no
/// joint position within the joints' ranges. The search does find poses that can be reached.
#[test]
fn what_is_refused_no_search_finds() {
    let (mut reachable, mut reached) = (0, 0);
    for (name, arm) in Witness::names().zip(0..) {
        let (model, witness) = (Model::named(name).expect("published"), Witness::published(name));
        for seed in 0..6 {
            // Around the edge of reach.
            let out = |index: u64| 2.0 * share(9_000_000 + 1_000 * arm + seed * 6 + index) - 1.0;
            let place = [0, 1, 2].map(|index| out(index) * 0.6 * model.reach_mm());
            let target = Pose::from_millimetres_degrees(place, [3, 4, 5].map(|index| out(index) * 180.0));
            let found = (0..8).find_map(|start| {
                let joints = search(&witness, frame(target), joints(model, 1_000 * seed + start));
                let (moved, turned) = apart(witness.flange(joints), frame(target));
                (moved < 0.01 && turned < 0.01 && turns_within_range(model, joints)).then_some(joints)
            });
            match (model.inverse(target, [0.0; 6]), found) {
                (Ok(_), found) => (reachable, reached) = (reachable + 1, reached + i32::from(found.is_some())),
                (
                    Err(NoSolution::OutOfReach { .. } | NoSolution::Orientation | NoSolution::BeyondRange { .. }),
                    None,
                ) => {}
                (Err(error), found) => panic!("{name} {target}: {error}, and the search has {found:?}"),
            }
        }
    }
    assert!(reachable > 20 && reached * 10 > reachable * 8, "{reached} of {reachable}");
}

fn turns_within_range(model: &Model, joints: [f64; 6]) -> bool {
    (0..6).all(|joint| {
        let (min, max) = (model.joint_min()[joint], model.joint_max()[joint]);
        min + (joints[joint] - min).rem_euclid(360.0) <= max
    })
}

/// Joint positions that bring the flange as near to the target as steps of least squares come (Levenberg, Marquardt).
fn search(witness: &Witness, target: Frame, start: [f64; 6]) -> [f64; 6] {
    let off = |joints: [f64; 6]| difference(witness.flange(joints), target);
    let size = |off: [f64; 12]| off.iter().map(|entry| entry * entry).sum::<f64>();
    let (mut joints, mut now, mut damping) = (start, off(start), 1.0);
    for _ in 0..40 {
        let slopes: [[f64; 12]; 6] = std::array::from_fn(|joint| {
            let mut next = joints;
            next[joint] += 1e-5;
            let next = off(next);
            std::array::from_fn(|entry| (next[entry] - now[entry]) / 1e-5)
        });
        let dot =
            |one: &[f64; 12], other: &[f64; 12]| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
        let mut rows: [[f64; 7]; 6] = std::array::from_fn(|row| {
            std::array::from_fn(|column| match column {
                6 => -dot(&slopes[row], &now),
                column => dot(&slopes[row], &slopes[column]) + if row == column { damping } else { 0.0 },
            })
        });
        let step = solved(&mut rows);
        let next = std::array::from_fn(|joint| joints[joint] + step[joint]);
        if size(off(next)) < size(now) {
            (joints, now, damping) = (next, off(next), damping * 0.2);
        } else {
            damping *= 4.0;
        }
        if size(now) < 1e-12 {
            break;
        }
    }
    joints
}

/// The differences of all entries; an axis that points elsewhere counts as if it were half a metre long.
fn difference(one: Frame, other: Frame) -> [f64; 12] {
    std::array::from_fn(|entry| {
        let (row, column) = (entry / 4, entry % 4);
        (one[row][column] - other[row][column]) * if column == 3 { 1.0 } else { 500.0 }
    })
}

/// Gauss's elimination of positive definite equations, whose last column is the right-hand side.
fn solved(rows: &mut [[f64; 7]; 6]) -> [f64; 6] {
    for pivot in 0..6 {
        let own = rows[pivot].map(|entry| entry / rows[pivot][pivot]);
        for row in rows.iter_mut() {
            let share = row[pivot];
            row.iter_mut().zip(own).for_each(|(entry, own)| *entry -= share * own);
        }
        rows[pivot] = own;
    }
    rows.map(|row| row[6])
}

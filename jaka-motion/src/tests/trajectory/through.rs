//! Trajectories through points without times.

use jaka_proto::messages::types::Pose;

use super::{HOME, Random, checker, jerks_are_within, off_way, times, witness, zu5};
use crate::{Checker, Frames, Model, Passing, Through, Trajectory, Transform, Via};

fn some_joints(random: &mut Random) -> [f64; 6] {
    HOME.map(|joint| joint + random.between(-20.0, 20.0))
}

fn some_pose(random: &mut Random) -> Pose {
    let model = Model::named("Zu 5").expect("a published arm");
    let home = Pose::from(model.forward(HOME));
    let mut offset = |most: f64| random.between(-most, most);
    let (x, y, z) = (home.x + offset(80.0), home.y + offset(80.0), home.z + offset(80.0));
    Pose { x, y, z, rx: home.rx + offset(10.0), ry: home.ry + offset(10.0), rz: home.rz + offset(10.0) }
}

#[test]
fn ways_in_joints_are_straight_but_for_their_corners() {
    let (mut random, checker) = (Random::new(6), checker());
    for round in 0..30 {
        let tolerance = [0.0, 0.5, 2.0, 10.0][round % 4];
        let points: Vec<_> = (0..2 + round % 6).map(|_| some_joints(&mut random)).collect();
        let trajectory = Trajectory::through(points.clone()).corner_deg(tolerance).build(&checker).expect("a way");
        assert!(trajectory.end().max_distance(&points[points.len() - 1].into()) < 1e-9);
        for period_s in [0.001, 0.008] {
            witness(&trajectory, &checker, period_s);
        }
        jerks_are_within(&trajectory, &checker, 1.0);
        for time_s in times(&trajectory, 3000) {
            let here = trajectory.at(time_s).joints.0;
            let off = points.windows(2).map(|pair| off_way(here, pair[0], pair[1])).fold(f64::INFINITY, f64::min);
            assert!(off <= tolerance * 6.0_f64.sqrt() + 1e-9);
        }
        for (point, way_point) in points.iter().zip(trajectory.way_points()) {
            let there = trajectory.at(way_point.time_s);
            assert!(there.joints.max_distance(&(*point).into()) <= tolerance + 1e-9);
            let is_at_rest = there.velocity.iter().all(|speed| speed.abs() < 1e-9);
            assert_eq!(is_at_rest, way_point.passing == Passing::Stops);
        }
        let inner = &trajectory.way_points()[1..points.len() - 1];
        assert!(inner.iter().all(|way_point| (way_point.passing == Passing::Rounded) == (tolerance > 0.0)));
    }
}

#[test]
fn lines_are_straight_but_for_their_corners() {
    let mut random = Random::new(7);
    let tool = Pose::from_millimetres_degrees([20.0, 0.0, 120.0], [0.0, 30.0, 0.0]);
    for round in 0..20 {
        let tolerance = [0.0, 1.0, 5.0][round % 3];
        let limits = if round % 2 == 0 { zu5() } else { zu5().with_tcp_speed(100.0).expect("limits") };
        let checker = Checker::new(limits, Frames::new().with_tool(tool));
        let start = checker.frames().pose(checker.limits().model().forward(HOME));
        let seen = |pose: Pose| checker.frames().pose(Transform::from(pose));
        let poses: Vec<_> =
            std::iter::once(start).chain((0..=round % 5).map(|_| seen(some_pose(&mut random)))).collect();
        let points = std::iter::once(Via::from(HOME)).chain(poses[1..].iter().map(|pose| Via::from(*pose)));
        let trajectory = Trajectory::through(points).corner_mm(tolerance).build(&checker).expect("a way");
        for period_s in [0.001, 0.008] {
            witness(&trajectory, &checker, period_s);
        }
        jerks_are_within(&trajectory, &checker, 1.0);
        let place = |time_s: f64| checker.frames().pose(checker.limits().model().forward(trajectory.at(time_s).joints));
        for time_s in times(&trajectory, 2000) {
            let here = place(time_s).position_mm();
            let off = poses.windows(2).map(|pair| off_way(here, pair[0].position_mm(), pair[1].position_mm()));
            let off = off.fold(f64::INFINITY, f64::min);
            assert!(off <= tolerance + 0.006, "{off} mm off at {time_s} s");
        }
        for (pose, way_point) in poses.iter().zip(trajectory.way_points()) {
            let (there, wanted) = (Transform::from(place(way_point.time_s)), Transform::from(*pose));
            assert!(there.distance_mm(&wanted) <= tolerance + 0.006 && there.angle_deg(&wanted) <= 1.002);
            assert!(tolerance > 0.0 || there.angle_deg(&wanted) < 0.002);
        }
    }
}

#[test]
fn a_corner_between_a_line_and_a_way_in_joints_is_within_the_tolerances_of_both() {
    let checker = checker();
    let forward = |joints: [f64; 6]| Transform::from(Pose::from(checker.limits().model().forward(joints)));
    let pose = Pose::from(checker.limits().model().forward(HOME));
    let mut random = Random::new(9);
    for _ in 0..20 {
        let down = Pose { z: pose.z - 60.0, x: pose.x + random.between(-30.0, 30.0), ..pose };
        let aside = HOME.map(|joint| joint + random.between(-20.0, 20.0));
        let points = [Via::from(HOME), down.into(), aside.into(), pose.into()];
        let both = Trajectory::through(points).corner_mm(5.0).corner_deg(4.0).corner_turn_deg(3.0);
        let trajectory = both.build(&checker).expect("a way");
        for period_s in [0.001, 0.008] {
            witness(&trajectory, &checker, period_s);
        }
        jerks_are_within(&trajectory, &checker, 1.0);
        let found = trajectory.way_points();
        assert!(found[1..3].iter().all(|point| point.passing == Passing::Rounded), "{found:?}");
        let stops = Trajectory::through(points).corner_mm(5.0).build(&checker).expect("a way");
        assert!(stops.way_points().iter().all(|point| point.passing == Passing::Stops));
        assert!(trajectory.duration_s() < stops.duration_s());
        let at_down = stops.at(stops.way_points()[1].time_s).joints.0;
        for (point, joints) in found[1..3].iter().zip([at_down, aside]) {
            let near = times(&trajectory, 5000).map(|time_s| trajectory.at(time_s).joints);
            let near = near.filter(|there| there.max_distance(&joints.into()) <= 4.0);
            let closest = near.map(|there| {
                let (there, wanted) = (forward(there.0), forward(joints));
                if there.angle_deg(&wanted) <= 3.0 { there.distance_mm(&wanted) } else { f64::INFINITY }
            });
            assert!(closest.fold(f64::INFINITY, f64::min) <= 5.0, "{point:?}");
        }
    }
}

#[test]
fn a_pose_is_a_start_where_joint_positions_near_it_are_named() {
    let checker = checker();
    let model = checker.limits().model();
    let first = Pose::from(model.forward(HOME));
    let down = Pose { z: first.z - 40.0, ..first };
    let near = HOME.map(|joint| joint + 3.0);
    let other = [-160.0, 120.0, 80.0, -10.0, 90.0, 180.0];
    for (near, reaches_home) in [(near, true), (other, false)] {
        let through = Trajectory::through([first, down]).near(near).build(&checker).expect("a way");
        let curve = Trajectory::curve([first, down]).near(near).within_mm(0.1).build(&checker).expect("a way");
        for trajectory in [through, curve] {
            assert_eq!(trajectory.start().max_distance(&HOME.into()) < 1e-6, reaches_home);
            let ends = [trajectory.start(), trajectory.end()].map(|joints| Pose::from(model.forward(joints)));
            assert!((ends[0].z - first.z).abs() < 1e-6 && (ends[1].z - down.z).abs() < 1e-3, "{ends:?}");
        }
    }
    let far = Pose { x: 2000.0, ..first };
    let error = Trajectory::through([far, down]).near(HOME).build(&checker).unwrap_err().to_string();
    assert!(error.starts_with("way-point 1: out of reach by "), "{error}");
}

#[test]
fn points_in_a_row_are_passed_without_a_stop() {
    let checker = checker();
    let along = |turn: f64| HOME.map(|joint| joint + turn);
    let trajectory = Trajectory::through([0.0, 3.0, 10.0, 11.0, 30.0].map(along)).corner_deg(1.0).build(&checker);
    let trajectory = trajectory.expect("a way");
    let direct = Trajectory::through([0.0, 30.0].map(along)).build(&checker).expect("a way");
    assert!(trajectory.way_points()[1..4].iter().all(|point| point.passing == Passing::Through));
    assert!(trajectory.duration_s() < 1.3 * direct.duration_s(), "{trajectory:?}, {direct:?}");
}

#[test]
fn what_cannot_be_is_refused_and_named() {
    let checker = checker();
    let pose = Pose::from(checker.limits().model().forward(HOME));
    let refused = |through: Through, text: &str| assert_eq!(through.build(&checker).unwrap_err().to_string(), text);
    let through = |points: &[Via]| Trajectory::through(points.to_vec());
    let start = Via::from(HOME);
    refused(through(&[]), "a trajectory takes at least 2 way-points; given 0");
    refused(through(&[start]), "a trajectory takes at least 2 way-points; given 1");
    refused(through(&[start, start, pose.into()]), "all way-points are at the same place");
    let text = "way-point 1 is a pose, which several joint positions reach; give joint positions near it, or a first way-point in joints";
    refused(through(&[pose.into(), start]), text);
    let two = through(&[start, [0.0; 6].into()]);
    refused(two.clone().corner_mm(-1.0), "corner_mm: -1 is not 0, or finite and at least 0.001");
    refused(two.clone().corner_deg(f64::NAN), "corner_deg: NaN is not 0, or finite and at least 0.001");
    refused(two.clone().tcp_speed(0.0), "tcp_speed: 0 is not at least 0.001");
    refused(two.jerks([0.0; 6]), "jerks: 0 is not from 0.001 to 1e9");
    let beyond = [0.0, 60.0, -181.2, 190.0, -90.0, 0.0];
    refused(through(&[start, start, beyond.into()]), "way-point 3: joint 3 would be at -181.2 deg; limit -175 (Zu 5)");
    let far = Pose { x: 1500.0, ..pose };
    refused(through(&[start, start, far.into()]), "between way-points 2 and 3: out of reach by 806 mm (Zu 5)");
    let across = Pose { x: -pose.x, y: -pose.y, ..pose };
    let text = "between way-points 1 and 2: the line passes the shoulder singularity at 49 % of its path (Zu 5)";
    refused(through(&[start, across.into()]), text);
}

#[test]
fn no_numbers_make_it_panic() {
    let (mut random, checker) = (Random::new(8), checker());
    let odd = [0.0, 1e308, f64::NAN, f64::INFINITY, 1e-300, 5e-324, -1.0, 1e-7];
    for _ in 0..500 {
        let mut number = |usual: f64| if random.below(8) == 0 { odd[random.below(8)] } else { usual };
        let pose = Pose::from(checker.limits().model().forward(HOME));
        let points = [
            Via::from(HOME.map(&mut number)),
            HOME.map(|joint| joint + number(1.0)).into(),
            Pose { x: number(pose.x), y: number(pose.y), z: number(pose.z + 10.0), ..pose }.into(),
            Pose { rx: number(pose.rx), ry: number(pose.ry), rz: number(pose.rz + 3.0), ..pose }.into(),
            HOME.map(|joint| joint + number(1e-6)).into(),
        ];
        let through =
            Trajectory::through(points).corner_mm(number(2.0)).corner_deg(number(2.0)).tcp_speed(number(100.0));
        if let Ok(trajectory) = through.build(&checker) {
            assert!(trajectory.duration_s().is_finite());
        }
    }
}

/// The tool goes down and up again: it reaches the lowest point for any tolerance of the corner.
#[test]
fn where_the_way_turns_back_it_stops() {
    let checker = checker();
    let pose = Pose::from(checker.limits().model().forward(HOME));
    let points = [Via::from(HOME), Pose { z: pose.z - 50.0, ..pose }.into(), pose.into()];
    let trajectory = Trajectory::through(points).corner_mm(20.0).build(&checker).expect("a way");
    assert_eq!(trajectory.way_points()[1].passing, Passing::Stops);
}

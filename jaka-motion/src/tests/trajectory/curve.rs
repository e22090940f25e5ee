//! Curves through dense points.

use jaka_proto::messages::types::Pose;

use super::{HOME, Random, checker, jerks_are_within, off_way, times, witness, zu5};
use crate::{Checker, Curve, Frames, Model, Passing, SlowedBy, Trajectory, Transform, Via};

fn home() -> Pose {
    Pose::from(Model::named("Zu 5").expect("a published arm").forward(HOME))
}

/// Returns part of a circle with a radius of 80 mm, with steps of this many mm.
fn on_circle(step_mm: f64) -> Vec<Pose> {
    let arc = 0.6 * std::f64::consts::TAU;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    let count = (80.0 * arc / step_mm).round() as u32;
    let angles = (0..=count).map(|index| arc * f64::from(index) / f64::from(count));
    angles
        .map(|angle| Pose { x: home().x + 80.0 * (angle.cos() - 1.0), y: home().y + 80.0 * angle.sin(), ..home() })
        .collect()
}

fn through_poses(poses: &[Pose]) -> Curve {
    Trajectory::curve(std::iter::once(Via::from(HOME)).chain(poses[1..].iter().map(|pose| Via::from(*pose))))
}

/// Checks that the set-points are within all limits, also of jerk, at rest at both ends and near the points and the
/// lines between.
fn is_kept(trajectory: &Trajectory, checker: &Checker, poses: &[Pose], within: (f64, f64)) {
    for period_s in [0.001, 0.008] {
        witness(trajectory, checker, period_s);
    }
    jerks_are_within(trajectory, checker, 1.0);
    let ends = [0.0, trajectory.duration_s()].map(|time_s| trajectory.at(time_s).velocity);
    assert!(ends.iter().flatten().all(|speed| speed.abs() < 1e-9));
    let place = |time_s: f64| checker.frames().pose(checker.limits().model().forward(trajectory.at(time_s).joints));
    for time_s in times(trajectory, 1500) {
        let here = place(time_s).position_mm();
        let ways = poses.windows(2).map(|pair| off_way(here, pair[0].position_mm(), pair[1].position_mm()));
        let off = ways.fold(f64::INFINITY, f64::min);
        assert!(off <= within.0, "{off} mm off at {time_s} s");
    }
    assert_eq!(trajectory.way_points().len(), poses.len());
    for (pose, way_point) in poses.iter().zip(trajectory.way_points()) {
        let (there, wanted) = (Transform::from(place(way_point.time_s)), Transform::from(*pose));
        let off = (there.distance_mm(&wanted), there.angle_deg(&wanted));
        assert!(off.0 <= within.0 && off.1 <= within.1, "{off:?} off {way_point:?}");
    }
    let ordered = trajectory.way_points().windows(2).all(|pair| pair[0].time_s <= pair[1].time_s);
    assert!(ordered, "{:?}", trajectory.way_points());
}

/// Returns the speed of the tool centre point in each millisecond, in mm/s.
fn tool_speeds(trajectory: &Trajectory, checker: &Checker) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    let count = (trajectory.duration_s() * 1000.0) as u32;
    let model = checker.limits().model();
    let places: Vec<_> = (0..=count).map(|ms| model.forward(trajectory.at(f64::from(ms) / 1000.0).joints)).collect();
    places.windows(2).map(|pair| pair[0].distance_mm(&pair[1]) * 1000.0).collect()
}

#[test]
fn a_circle_takes_as_long_whatever_its_steps() {
    for (acceleration, longest_s) in [(300.0, 3.2), (72.0, 3.35)] {
        let limits = zu5().with_joint_accelerations([acceleration; 6]).expect("above 0");
        let checker = Checker::new(limits, Frames::new());
        for step_mm in [10.0, 5.0, 2.0, 1.0, 0.5, 0.2] {
            let poses = on_circle(step_mm);
            let trajectory = through_poses(&poses).within_mm(0.2).tcp_speed(100.0).build(&checker).expect("a way");
            assert!(trajectory.duration_s() < longest_s, "{acceleration} deg/s², {step_mm} mm: {trajectory:?}");
            is_kept(&trajectory, &checker, &poses, (0.2, 1.0));
            let speeds = tool_speeds(&trajectory, &checker);
            let [first, last] = [speeds.iter().position(|one| *one > 99.0), speeds.iter().rposition(|one| *one > 99.0)];
            let cruising = &speeds[first.expect("it is as fast")..last.expect("it is as fast")];
            assert!(cruising.len() > 2600 && cruising.iter().all(|speed| (98.0..=100.0).contains(speed)));
            let off = |place: Transform| {
                let [x, y, z] = Pose::from(place).position_mm();
                ((x - home().x + 80.0).hypot(y - home().y) - 80.0).hypot(z - home().z)
            };
            let model = checker.limits().model();
            let most = times(&trajectory, 2000).map(|time_s| off(model.forward(trajectory.at(time_s).joints)));
            assert!(most.fold(0.0, f64::max) <= 0.2);
        }
    }
}

#[test]
fn noise_within_the_tolerance_costs_no_speed() {
    let (mut random, checker) = (Random::new(10), checker());
    for step_mm in [0.2, 1.0, 5.0] {
        let mut poses = vec![home()];
        let mut y = home().y;
        while y < home().y + 100.0 {
            y += step_mm;
            let mut noise = |most: f64| random.between(-most, most);
            let [x, z] = [home().x, home().z].map(|at| at + noise(0.02));
            let [rx, ry, rz] = [home().rx, home().ry, home().rz].map(|turn| turn + noise(0.05));
            poses.push(Pose { x, y: y + noise(0.02), z, rx, ry, rz });
        }
        let curve = through_poses(&poses).within_mm(0.2).within_deg(0.5).tcp_speed(15.0);
        let trajectory = curve.build(&checker).expect("a way");
        assert!(trajectory.duration_s() < 1.1 * 100.0 / 15.0, "{step_mm} mm: {trajectory:?}");
        is_kept(&trajectory, &checker, &poses, (0.2, 0.5));
    }
}

#[test]
fn joint_positions_are_passed_within_the_tolerance() {
    let checker = checker();
    let wave = |at: f64| -> [f64; 6] {
        std::array::from_fn(|joint| {
            let [rate, phase] = [[0.7, 0.0], [1.1, 1.0], [0.9, 2.0], [1.3, 3.0], [1.7, 4.0], [2.1, 5.0]][joint];
            HOME[joint] + 20.0 * ((rate * at + phase).sin() - f64::sin(phase))
        })
    };
    let mut took = Vec::new();
    for count in [30, 100, 1000, 3000] {
        let points: Vec<_> = (0..=count).map(|index| wave(3.0 * f64::from(index) / f64::from(count))).collect();
        let trajectory = Trajectory::curve(points.clone()).within_deg(0.1).build(&checker).expect("a way");
        for period_s in [0.001, 0.008] {
            witness(&trajectory, &checker, period_s);
        }
        jerks_are_within(&trajectory, &checker, 1.0);
        for time_s in times(&trajectory, 1000) {
            let here = trajectory.at(time_s).joints.0;
            let off = points.windows(2).map(|pair| off_way(here, pair[0], pair[1])).fold(f64::INFINITY, f64::min);
            assert!(off <= 0.1 * 6.0_f64.sqrt(), "{off} deg off at {time_s} s");
        }
        for (point, way_point) in points.iter().zip(trajectory.way_points()) {
            assert!(trajectory.at(way_point.time_s).joints.max_distance(&(*point).into()) <= 0.1);
        }
        took.push(trajectory.duration_s());
    }
    assert!(took.iter().all(|one| took.iter().all(|other| one < &(1.03 * other))), "{took:?}");
}

#[test]
fn corners_stay_corners() {
    let checker = checker();
    let along = |way: f64| {
        let [x, y] = if way < 60.0 { [0.0, way] } else { [60.0 - way, 60.0] };
        Pose { x: home().x + x, y: home().y + y, ..home() }
    };
    let poses: Vec<_> = (0..=240).map(|step| along(f64::from(step) * 0.5)).collect();
    let curve = through_poses(&poses).within_mm(0.1).tcp_speed(60.0);
    for (corner_mm, passing) in [(0.0, Passing::Stops), (3.0, Passing::Rounded)] {
        let trajectory = curve.clone().corner_mm(corner_mm).build(&checker).expect("a way");
        assert_eq!(trajectory.way_points()[120].passing, passing);
        is_kept(&trajectory, &checker, &poses[..], (corner_mm.max(0.1), 1.0));
        let at_corner = trajectory.at(trajectory.way_points()[120].time_s);
        let off = checker.limits().model().forward(at_corner.joints).distance_mm(&Transform::from(poses[120]));
        assert!(off <= corner_mm + 1e-3 && (corner_mm == 0.0) == at_corner.velocity.iter().all(|one| one.abs() < 1e-9));
    }
    // A curve that may bend there does not stop either.
    let bent = curve.corner_above_deg(170.0).build(&checker).expect("a way");
    assert!(bent.way_points()[1..240].iter().all(|point| point.passing == Passing::Rounded));
    is_kept(&bent, &checker, &poses, (0.1, 1.0));
}

#[test]
fn what_cannot_be_is_refused_and_named() {
    let checker = checker();
    let refused = |curve: Curve, text: &str| assert_eq!(curve.build(&checker).unwrap_err().to_string(), text);
    let poses = on_circle(10.0);
    refused(through_poses(&poses), "within_mm: 0 is not at least 0.001");
    refused(Trajectory::curve([HOME, [0.0; 6]]), "within_deg: 0 is not at least 0.001");
    refused(through_poses(&poses).within_mm(f64::NAN), "within_mm: NaN is not 0, or finite and at least 0.001");
    refused(through_poses(&poses).within_mm(1.0).reserve(0.95), "reserve: 0.95 is not from 0 to 0.9");
    refused(
        through_poses(&poses).within_mm(1.0).corner_mm(-1.0),
        "corner_mm: -1 is not 0, or finite and at least 0.001",
    );
    refused(Trajectory::curve::<Via>([]), "a trajectory takes at least 2 way-points; given 0");
    refused(Trajectory::curve([HOME; 3]).within_deg(1.0), "all way-points are at the same place");
    let text = "way-point 3: after the first, the points of a curve are all joint positions or all poses";
    refused(Trajectory::curve([Via::from(HOME), HOME.into(), home().into()]).within_deg(1.0), text);
    let text = "way-point 1 is a pose, which several joint positions reach; give joint positions near it, or a first way-point in joints";
    refused(Trajectory::curve([home(), home()]), text);
    let far = Pose { x: 1500.0, ..home() };
    let error = through_poses(&[home(), poses[3], far]).within_mm(1.0).build(&checker).unwrap_err().to_string();
    assert!(error.starts_with("between way-points 2 and 3: "), "{error}");
    let across: Vec<_> = (0..=200)
        .map(|step| {
            let share = 1.0 - f64::from(step) / 100.0;
            Pose { x: home().x * share, y: home().y * share, ..home() }
        })
        .collect();
    let error = through_poses(&across).within_mm(0.5).build(&checker).unwrap_err().to_string();
    assert!(error.contains("shoulder singularity"), "{error}");
}

#[test]
fn no_numbers_make_it_panic() {
    let (mut random, checker) = (Random::new(11), checker());
    let odd = [0.0, 1e308, f64::NAN, f64::INFINITY, 1e-300, 5e-324, -1.0, 1e-7, 1e9, 180.0];
    for round in 0..300 {
        let mut number = |usual: f64| if random.below(30) == 0 { odd[random.below(10)] } else { usual };
        let near = |by: f64| 0.3 * by;
        let poses: Vec<_> =
            (1..20).map(|step| Pose { x: number(home().x + near(f64::from(step))), ..home() }).collect();
        let joints: Vec<_> = (0..20).map(|step| HOME.map(|joint| number(joint + near(f64::from(step))))).collect();
        let curve = if round % 2 == 0 {
            Trajectory::curve(joints)
        } else {
            Trajectory::curve(std::iter::once(Via::from(HOME)).chain(poses.into_iter().map(Via::from)))
        };
        let curve = curve.within_mm(number(0.1)).within_deg(number(0.1)).tcp_speed(number(100.0)).reserve(number(0.2));
        if let Ok(trajectory) = curve.corner_above_deg(number(30.0)).build(&checker) {
            assert!(trajectory.duration_s().is_finite());
        }
    }
}

/// The slowest places are those of the set-points, and name the joint that is at its limit.
#[test]
fn slow_places_are_told_with_what_slows_them() {
    let poses = on_circle(1.0);
    let limits = |joint_1: f64| {
        let mut speeds = [180.0; 6];
        speeds[0] = joint_1;
        zu5().with_joint_speeds(speeds).expect("no faster than the arm").with_joint_accelerations([300.0; 6])
    };
    let fast = Checker::new(limits(180.0).expect("above 0"), Frames::new());
    let curve = through_poses(&poses).within_mm(0.2).tcp_speed(100.0);
    assert_eq!(curve.build(&fast).expect("a way").slow_places(), []);
    let slow = Checker::new(limits(10.0).expect("above 0"), Frames::new());
    let trajectory = curve.build(&slow).expect("a way");
    let places = trajectory.slow_places();
    assert!(!places.is_empty() && places.windows(2).all(|pair| pair[0].share <= pair[1].share), "{places:?}");
    let speeds = tool_speeds(&trajectory, &slow);
    for place in places {
        assert_eq!(place.by, SlowedBy::Speed { joint: 1 }, "{place:?}");
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
        let found = speeds[(place.time_s * 1000.0) as usize] / 100.0;
        assert!((found - place.share).abs() < 0.02, "{found}: {place:?}");
    }
    // The tool is nowhere as fast as requested.
    let faster = through_poses(&poses).within_mm(0.2).tcp_speed(2000.0).build(&fast).expect("a way");
    let fastest = tool_speeds(&faster, &fast).into_iter().fold(0.0, f64::max) / 2000.0;
    assert!(faster.slow_places().iter().all(|place| place.share <= fastest + 1e-3), "{:?}", faster.slow_places());
    assert!(!faster.slow_places().is_empty());
}

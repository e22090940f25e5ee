//! Speeds and tolerances of single points, measured on the set-points.

use jaka_proto::messages::types::Pose;

use super::{HOME, checker, jerks_are_within, witness};
use crate::{Model, Passing, Trajectory, TrajectoryError, Via};

fn home() -> Pose {
    Pose::from(Model::default().forward(HOME))
}

fn moved(by: [f64; 3]) -> Pose {
    let home = home();
    Pose { x: home.x + by[0], y: home.y + by[1], z: home.z + by[2], ..home }
}

fn place(trajectory: &Trajectory, time_s: f64) -> [f64; 3] {
    Model::default().forward(trajectory.at(time_s).joints).position_mm()
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|axis| (one[axis] - other[axis]).powi(2)).sum::<f64>().sqrt()
}

/// Returns the highest speed of the tool between two way-points, by differences each millisecond, in mm/s.
fn fastest(trajectory: &Trajectory, from: usize, to: usize) -> f64 {
    let [from_s, to_s] = [from, to].map(|index| trajectory.way_points()[index].time_s);
    let moments = (0..).map(|step| from_s + f64::from(step) * 1e-3).take_while(|time_s| *time_s < to_s - 1e-3);
    moments.map(|time_s| apart(place(trajectory, time_s), place(trajectory, time_s + 1e-3)) / 1e-3).fold(0.0, f64::max)
}

#[test]
fn each_way_has_its_own_speed_and_each_corner_its_own_tolerance() {
    let checker = checker();
    let corners = [moved([0.0, 80.0, 0.0]), moved([0.0, 80.0, 80.0]), moved([0.0, 0.0, 80.0])];
    let points = [
        Via::joints(HOME),
        Via::line(corners[0]).with_tcp_speed(100.0).with_corner_mm(8.0),
        Via::line(corners[1]).with_tcp_speed(20.0).with_corner_mm(0.0),
        Via::line(corners[2]),
        Via::line(home()).with_tcp_speed(60.0),
    ];
    let trajectory =
        Trajectory::through(points).tcp_speed(150.0).corner_mm(1.0).build(&checker).expect("within limits");
    witness(&trajectory, &checker, 0.008);
    jerks_are_within(&trajectory, &checker, 1.0);
    for (way, most) in [(0, 100.0), (1, 20.0), (2, 150.0), (3, 60.0)] {
        let found = fastest(&trajectory, way, way + 1);
        assert!(found < most * 1.0005, "way {way}: {found} mm/s");
    }
    assert!(fastest(&trajectory, 0, 1) > 80.0 && fastest(&trajectory, 2, 3) > 70.0);
    let slow = fastest(&trajectory, 1, 2);
    assert!(slow > 19.8, "{slow} mm/s");
    let passings: Vec<_> = trajectory.way_points().iter().map(|point| point.passing).collect();
    assert_eq!(passings, [Passing::Stops, Passing::Rounded, Passing::Stops, Passing::Rounded, Passing::Stops]);
    let nearest = |corner: Pose| {
        let corner = [corner.x, corner.y, corner.z];
        let moments = (0..).map(|step| f64::from(step) * 1e-3).take_while(|time_s| *time_s < trajectory.duration_s());
        moments.map(|time_s| apart(place(&trajectory, time_s), corner)).fold(f64::INFINITY, f64::min)
    };
    let off = corners.map(nearest);
    assert!(off[0] > 4.0 && off[0] <= 8.0 && off[1] < 1e-3 && off[2] > 0.3 && off[2] <= 1.0, "{off:?}");
}

#[test]
fn the_speeds_of_joints_are_those_of_their_way() {
    let checker = checker();
    let turned = |by: f64| Via::joints([HOME[0] + by, HOME[1], HOME[2], HOME[3], HOME[4], HOME[5]]);
    let points = [turned(0.0), turned(40.0), turned(60.0).with_joint_speeds([10.0; 6]), turned(100.0)];
    let trajectory = Trajectory::through(points).corner_deg(1.0).build(&checker).expect("within limits");
    witness(&trajectory, &checker, 0.008);
    let top = |from: usize| {
        let [from_s, to_s] = [from, from + 1].map(|index| trajectory.way_points()[index].time_s);
        (0..=1000)
            .map(|part| trajectory.at(from_s + f64::from(part) / 1000.0 * (to_s - from_s)).velocity[0])
            .fold(0.0, f64::max)
    };
    let tops = [0, 1, 2].map(top);
    assert!(tops[0] > 40.0 && tops[1] > 9.8 && tops[1] <= 10.0 + 1e-9 && tops[2] > 40.0, "{tops:?}");
}

#[test]
fn wrong_settings_of_a_point_are_refused() {
    let refused = |via: Via| {
        let built = Trajectory::through([Via::joints(HOME), via]).build(&checker());
        built.expect_err("it is wrong").to_string()
    };
    let line = Via::line(moved([0.0, 50.0, 0.0]));
    assert_eq!(refused(line.with_tcp_speed(0.0)), "tcp_speed: 0 is not at least 0.001");
    assert_eq!(refused(line.with_joint_speeds([f64::NAN; 6])), "joint_speeds: NaN is not at least 0.001");
    assert_eq!(refused(line.with_corner_mm(-1.0)), "corner_mm: -1 is not 0, or finite and at least 0.001");
    let curve =
        Trajectory::curve([Via::joints(HOME), line, line.with_tcp_speed(10.0)]).within_mm(0.1).build(&checker());
    assert_eq!(curve.expect_err("it is wrong"), TrajectoryError::OnCurve { way_point: 3 });
}

/// The path is half of a circle of 60 mm in a plane through the start, with a tangential line at each end.
#[test]
fn an_arc_is_a_circle_between_lines() {
    let checker = checker();
    let at = |angle: f64| moved([0.0, 60.0 * angle.sin(), 60.0 - 60.0 * angle.cos()]);
    let half = std::f64::consts::PI;
    let (before, after) = (moved([0.0, -50.0, 0.0]), moved([0.0, -50.0, 120.0]));
    let points = [
        Via::joints(HOME),
        Via::line(before),
        Via::line(home()),
        Via::arc(at(0.4 * half), at(half)).with_tcp_speed(60.0),
        Via::line(after),
    ];
    let trajectory =
        Trajectory::through(points).corner_mm(0.5).tcp_speed(100.0).build(&checker).expect("within limits");
    witness(&trajectory, &checker, 0.008);
    jerks_are_within(&trajectory, &checker, 1.0);
    let passings: Vec<_> = trajectory.way_points().iter().map(|point| point.passing).collect();
    assert_eq!(passings, [Passing::Stops, Passing::Stops, Passing::Rounded, Passing::Rounded, Passing::Stops]);
    let [from_s, to_s] = [2, 3].map(|index: usize| trajectory.way_points()[index].time_s);
    let centre = [home().x, home().y, home().z + 60.0];
    let (mut furthest, mut fastest, mut slowest) = (0.0_f64, 0.0_f64, f64::INFINITY);
    for part in 0..=2000 {
        let time_s = from_s + f64::from(part) / 2000.0 * (to_s - from_s);
        let (here, next) = (place(&trajectory, time_s), place(&trajectory, time_s + 1e-3));
        // Corners take half a millimetre at both ends.
        let beside = apart(here, place(&trajectory, from_s)).min(apart(here, place(&trajectory, to_s)));
        if beside > 15.0 {
            furthest = furthest.max((apart(here, centre) - 60.0).abs()).max((here[0] - centre[0]).abs());
            slowest = slowest.min(apart(here, next) / 1e-3);
        }
        fastest = fastest.max(apart(here, next) / 1e-3);
    }
    assert!(furthest < 0.01, "{furthest} mm off the circle");
    assert!(fastest < 60.0 * 1.0005 && slowest > 58.0, "from {slowest} to {fastest} mm/s");
    // Where the tangential line meets the arc, the tool hardly slows down.
    let joined = trajectory.way_points()[2].time_s;
    assert!(apart(place(&trajectory, joined), place(&trajectory, joined + 1e-3)) / 1e-3 > 55.0);
}

#[test]
fn on_an_arc_the_tool_turns_to_its_middle_pose_and_on() {
    let checker = checker();
    let [middle, end] = [(30.0, 25.0, 10.0), (60.0, 0.0, 4.0)].map(|(y, z, turn)| {
        let pose = moved([0.0, y, z]);
        Pose { rx: pose.rx + turn, ..pose }
    });
    let points = [Via::joints(HOME), Via::arc(middle, end)];
    let trajectory = Trajectory::through(points).tcp_speed(40.0).build(&checker).expect("within limits");
    witness(&trajectory, &checker, 0.008);
    let poses = (0..=4000).map(|part| {
        let joints = trajectory.at(f64::from(part) / 4000.0 * trajectory.duration_s()).joints;
        Pose::from(Model::default().forward(joints))
    });
    let nearest = poses.min_by(|one, other| one.distance_mm(&middle).total_cmp(&other.distance_mm(&middle)));
    let nearest = nearest.expect("there are some");
    assert!(nearest.distance_mm(&middle) < 0.02 && nearest.angle_deg(&middle) < 0.05, "{nearest:?}, {middle:?}");
    let last = Pose::from(Model::default().forward(trajectory.end()));
    assert!(last.distance_mm(&end) < 1e-3 && last.angle_deg(&end) < 1e-3, "{last:?}, {end:?}");
    let straight = [Via::joints(HOME), Via::arc(moved([0.0, 10.0, 0.0]), moved([0.0, 20.0, 0.0]))];
    let error = Trajectory::through(straight).build(&checker).expect_err("it is a line");
    assert_eq!(
        error.to_string(),
        "between way-points 1 and 2: the positions of the three poses lie on a line: there is no arc (Zu 5)"
    );
}

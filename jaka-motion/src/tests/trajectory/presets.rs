//! Presets, measured on the set-points.

use jaka_proto::messages::types::Pose;

use super::{HOME, jerks_are_within, witness, zu5};
use crate::{Checker, Frames, Model, Preset, SlowedBy, Trajectory, Via};

fn checker(preset: Preset) -> Checker {
    Checker::new(zu5().with_preset(preset), Frames::new())
}

/// Returns the greatest change of the tool's speed in a second, from differences of its place each 4 ms, in mm/s².
fn tool_acceleration(trajectory: &Trajectory) -> f64 {
    const STEP_S: f64 = 0.004;
    let place = |time_s: f64| Model::default().forward(trajectory.at(time_s).joints).position_mm();
    let speed = |time_s: f64| {
        let (from, to) = (place(time_s), place(time_s + STEP_S));
        (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt() / STEP_S
    };
    let moments = (0..).map(|step| f64::from(step) * STEP_S).take_while(|time_s| *time_s < trajectory.duration_s());
    moments.map(|time_s| ((speed(time_s + STEP_S) - speed(time_s)) / STEP_S).abs()).fold(0.0, f64::max)
}

/// Each joint takes the seconds of the preset and 0.1 s to reach its highest speed.
#[test]
fn a_joint_reaches_its_highest_speed_in_the_time_of_the_preset() {
    for (preset, seconds) in [(Preset::Gentle, 2.5), (Preset::Usual, 0.75), (Preset::Quick, 0.4)] {
        let checker = checker(preset);
        // The last joint does not move the flange's position.
        let (mut start, mut end) = (HOME, HOME);
        (start[5], end[5]) = (-350.0, 350.0);
        let trajectory = Trajectory::through([start, end].map(Via::from)).build(&checker).expect("within the limits");
        let fast =
            (1..10_000).map(|step| f64::from(step) * 1e-3).find(|time_s| trajectory.at(*time_s).velocity[5] > 171.0);
        let fast = fast.expect("it gets to 95 % of it");
        assert!((0.95 * seconds..0.95 * seconds + 0.1).contains(&fast), "{preset:?}: {fast} s");
        witness(&trajectory, &checker, 0.008);
        jerks_are_within(&trajectory, &checker, 1.0);
    }
}

#[test]
fn the_tool_keeps_its_acceleration_on_lines_ways_in_joints_and_curves() {
    let pose = |by: [f64; 3]| {
        let mut pose = Pose::from(Model::default().forward(HOME));
        (pose.x, pose.y, pose.z) = (pose.x + by[0], pose.y + by[1], pose.z + by[2]);
        pose
    };
    for (preset, most) in [(Preset::Usual, 2000.0), (Preset::Quick, 5000.0)] {
        let checker = checker(preset);
        let turned =
            |by: [f64; 3]| Via::from([HOME[0] + by[0], HOME[1] + by[1], HOME[2] + by[2], HOME[3], HOME[4], HOME[5]]);
        let lines = [Via::from(HOME), Via::line(pose([0.0, 0.0, 150.0])), Via::line(pose([0.0, 200.0, 150.0]))];
        let joints = [turned([0.0; 3]), turned([40.0, 10.0, 20.0]), turned([70.0, -10.0, -20.0])];
        let circle = (0..=100).map(|step| {
            let angle = 0.02 * f64::from(step) * std::f64::consts::PI;
            Via::from(pose([80.0 * angle.sin(), 80.0 - 80.0 * angle.cos(), 0.0]))
        });
        let all = [
            ("lines", Trajectory::through(lines).corner_mm(5.0).build(&checker)),
            ("joints", Trajectory::through(joints).corner_deg(3.0).build(&checker)),
            ("curve", Trajectory::curve(circle).near(HOME).within_mm(0.2).within_deg(0.5).build(&checker)),
        ];
        for (name, trajectory) in all {
            let trajectory = trajectory.unwrap_or_else(|error| panic!("{name}: {error}"));
            let found = tool_acceleration(&trajectory);
            assert!(found <= 1.01 * most && found > 0.4 * most, "{preset:?}, {name}: {found} mm/s²");
            witness(&trajectory, &checker, 0.008);
            jerks_are_within(&trajectory, &checker, 1.0);
        }
    }
}

#[test]
fn a_place_that_the_acceleration_of_the_tool_slows_is_told() {
    let limits = zu5().with_preset(Preset::Quick).with_tcp_acceleration(300.0).expect("above 0");
    let checker = Checker::new(limits, Frames::new());
    let mut pose = Pose::from(Model::default().forward(HOME));
    pose.z += 100.0;
    let line = Trajectory::through([Via::from(HOME), Via::line(pose)]).tcp_speed(500.0).build(&checker);
    let slow = line.expect("within the limits").slow_places().to_vec();
    assert!(matches!(slow[..], [place] if place.by == SlowedBy::ToolAcceleration && place.share < 0.4), "{slow:?}");
}

//! Time to generate a set-point towards goals that change twenty times a second: median and upper percentiles.

use std::fmt::Write as _;
use std::time::Instant;

use jaka_motion::{
    Checker, Dynamics, Frames, Generator, Goal, Limits, Model, Point, Region, TcpVelocity, VelocityFrame,
};

use crate::kinematics::{JOINTS, PERIOD};

/// Number of timed set-points.
const SET_POINTS: u32 = 40_000;
/// Number of set-points for each goal: 20 goals a second.
const EACH: u32 = 6;
/// The most that 99 of 100 set-points may take, in microseconds.
const TARGET_US: f64 = 50.0;

/// A generator for a Zu 5 with so many regions, up to three: a table, a cell and a post.
///
/// # Panics
/// There is no Zu 5, or a region makes no sense.
pub fn generator(regions: usize) -> Generator {
    let mut limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    limits = limits.with_joint_accelerations([300.0; 6]).expect("accelerations");
    let all = [
        Region::half_space("table", [0.0, 0.0, 20.0], [0.0, 0.0, 1.0]),
        Region::inside_box("cell", [-900.0, -900.0, -100.0], [900.0, 900.0, 1300.0]).map(|cell| cell.of(Point::Wrist)),
        Region::outside_box("post", [-600.0, -60.0, 0.0], [-500.0, 60.0, 1500.0]),
    ];
    for region in all.into_iter().take(regions) {
        limits = limits.with_region(region.expect("a region")).expect("another name");
    }
    let dynamics = Dynamics::of(&limits);
    Generator::new(&Checker::new(limits, Frames::new()), dynamics, JOINTS.into(), PERIOD).expect("a free place")
}

/// A goal of each kind in turn, none like the one before.
pub fn goal(number: u32) -> Goal {
    let wave = |index: u32| (f64::from(number) * 0.7 + f64::from(index) * 1.3).sin();
    let six = |size: f64| [0, 1, 2, 3, 4, 5].map(|index| size * wave(index));
    match number % 3 {
        0 => {
            let by = six(25.0);
            Goal::Joints(std::array::from_fn(|index| JOINTS[index] + by[index]).into())
        }
        1 => Goal::Velocity(six(60.0)),
        _ => {
            let (linear_mm_s, angular_deg_s) =
                ([0, 1, 2].map(|axis| 200.0 * wave(axis)), [3, 4, 5].map(|axis| 20.0 * wave(axis)));
            Goal::TcpVelocity(
                TcpVelocity::new(VelocityFrame::ArmBase).with_linear(linear_mm_s).with_angular(angular_deg_s),
            )
        }
    }
}

/// A line for an arm without regions, and one for an arm with three.
pub fn report() -> String {
    let mut out = String::from("a set-point of a Zu 5, generated; goals change at 20 Hz\n");
    for (name, regions) in [("no region", 0), ("three regions", 3)] {
        let mut times = times(regions);
        times.sort_by(f64::total_cmp);
        let at = |share: usize| times[times.len() * share / 1000];
        let _ = writeln!(out, "  {name:24} p50 {:6.1} us, p99 {:6.1} us, p99.9 {:6.1} us", at(500), at(990), at(999));
        let met = if at(990) <= TARGET_US { "met" } else { "MISSED" };
        let _ = writeln!(out, "  target: p99 at most {TARGET_US} us: {:.1} us, {met}", at(990));
    }
    out
}

/// Of each set-point, in microseconds.
fn times(regions: usize) -> Vec<f64> {
    let mut generator = generator(regions);
    let next = |number: u32| {
        let goal = goal(number / EACH);
        let since = Instant::now();
        std::hint::black_box(generator.next(&goal));
        since.elapsed().as_secs_f64() * 1e6
    };
    (0..SET_POINTS).map(next).collect()
}

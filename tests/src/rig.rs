//! Random arms, limits and motions, for the checker and for the witness.

use crate::witness::way::{Bounds, Shape, Zone};
use crate::witness::{Frame, Witness, pose};
use jaka_motion::{Checker, Frames, Limits, Model, Point, Region, RegionFrame};
use jaka_sync::types::{JointPosition, Pose};
use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Amounts by which a limit may be exceeded without notice, as the checker documents them.
pub const AMOUNTS: [f64; 4] =
    [Checker::AMOUNT_DEG, Checker::AMOUNT_MM, Checker::AMOUNT_SPEED, Checker::AMOUNT_SINGULARITY];

/// Margins inside the limits that the witness cannot resolve, because of its steps and of rounding. The checker
/// documents that it may refuse a motion this close to the least distance from a singularity.
pub const WITHIN: [f64; 4] = [-1e-4, -0.05, -0.01, -Checker::AMOUNT_SINGULARITY];

/// Random numbers of a seed.
#[derive(Debug)]
pub struct Random(TestRng);

impl Random {
    /// The numbers of a seed.
    pub fn new(seed: u32) -> Self {
        let mut bytes = [0; 32];
        bytes[..4].copy_from_slice(&seed.to_le_bytes());
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    /// A whole number below a limit.
    pub fn below(&mut self, limit: u32) -> u32 {
        self.0.next_u32() % limit
    }

    /// True once in so many times.
    pub fn one_in(&mut self, times: u32) -> bool {
        self.below(times) == 0
    }

    /// A number in a range.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * f64::from(self.0.next_u32()) / f64::from(u32::MAX)
    }

    /// From next to nothing to `most`.
    pub fn mostly_small(&mut self, most: f64) -> f64 {
        self.between(0.05, 1.0).powi(2) * most
    }

    /// Numbers between `-most` and `most`.
    pub fn offsets<const N: usize>(&mut self, most: f64) -> [f64; N] {
        std::array::from_fn(|_| self.between(-most, most))
    }

    fn frame(&mut self, most_mm: f64, most_deg: f64) -> Pose {
        Pose::from_millimetres_degrees(self.offsets(most_mm), self.offsets(most_deg))
    }
}

/// An arm with limits, for the checker and for the witness.
#[derive(Debug)]
pub struct Rig {
    /// Limits of the checker.
    pub limits: Limits,
    /// Tool frame.
    pub tool: Pose,
    /// Mounting of the arm.
    pub base: Pose,
    /// Limits of the witness, equal to those of the checker.
    pub bounds: Bounds,
}

impl Rig {
    /// Limits that about half of the motions of these tests are beyond.
    ///
    /// # Panics
    /// A published arm has gone.
    pub fn new(random: &mut Random) -> Self {
        let name = Witness::names().nth(random.below(21) as usize).expect("there are twenty-one");
        let model = Model::named(name).expect("published");
        let (tool, base) = (random.frame(150.0, 180.0), random.frame(500.0, 180.0));
        let mut limits =
            Limits::of(model).with_joint_accelerations([random.between(50.0, 400.0); 6]).expect("positive");
        let tcp_speed = random.between(200.0, 1500.0);
        let least = random.between(0.0, 0.1);
        limits = limits.with_tcp_speed(tcp_speed).expect("positive").with_singularity_distance(least).expect("small");
        for joint in 1..=6 {
            let (min, max) = (limits.joint_min()[joint - 1], limits.joint_max()[joint - 1]);
            let width = max - min;
            let (min, max) = (min + random.between(0.0, 0.2) * width, max - random.between(0.0, 0.2) * width);
            limits = limits.with_joint_range(joint, min, max).expect("a tighter range");
        }
        let mut bounds = Bounds {
            arm: Witness::published(name),
            joint_min: *limits.joint_min(),
            joint_max: *limits.joint_max(),
            speeds: *limits.joint_speeds(),
            accelerations: *limits.joint_accelerations(),
            tcp_speed,
            least,
            reach: model.reach_mm(),
            zones: Vec::new(),
            base: frame(base),
            tool: frame(tool),
        };
        for number in 0..random.below(4) {
            let (region, zone) = zone(random, number, model.reach_mm());
            limits = limits.with_region(region).expect("each has a name of its own");
            bounds.zones.push(zone);
        }
        Self { limits, tool, base, bounds }
    }

    /// Compares motions of the arm with its limits.
    pub fn checker(&self) -> Checker {
        Checker::new(self.limits.clone(), Frames::new().with_tool(self.tool).with_mounting(self.base))
    }

    /// Joint positions within all limits, if some are soon found.
    pub fn place(&self, random: &mut Random) -> Option<[f64; 6]> {
        let anywhere = |random: &mut Random| -> [f64; 6] {
            std::array::from_fn(|joint| random.between(self.bounds.joint_min[joint], self.bounds.joint_max[joint]))
        };
        let is_good = |joints: &[f64; 6]| {
            !self.bounds.place(*joints).is_beyond([-0.01, -1.0, -0.01, -0.01])
                && self.bounds.nearest_singularity(*joints) > self.bounds.least + 0.01
        };
        (0..200).map(|_| anywhere(random)).find(is_good)
    }

    /// The pose of the tool, as commands have it.
    pub fn pose(&self, joints: [f64; 6]) -> Pose {
        let frames = Frames::new().with_tool(self.tool).with_mounting(self.base);
        frames.pose(self.limits.model().forward(JointPosition(joints)))
    }
}

/// A pose in the form of the witness.
pub fn frame(of: Pose) -> Frame {
    pose(of.position_mm(), of.rotation_rad())
}

/// A region that leaves most of the arm's reach, or that is in its midst.
fn zone(random: &mut Random, number: u32, reach: f64) -> (Region, Zone) {
    let name = format!("zone {number}");
    let middle = random.offsets::<3>(reach * 0.6);
    let (point, of) =
        [(Point::Elbow, 0), (Point::Wrist, 1), (Point::Tcp, 2), (Point::Tcp, 2)][random.below(4) as usize];
    let in_user = random.one_in(2);
    let (region, shape) = match random.below(3) {
        0 => {
            let half = random.between(0.5, 1.1) * reach;
            let (min, max) = (middle.map(|part| part - half), middle.map(|part| part + half));
            (Region::inside_box(name, min, max), Shape::Inside(min, max))
        }
        1 => {
            let halves: [f64; 3] = std::array::from_fn(|_| random.between(1.0, 150.0));
            let (min, max): ([f64; 3], [f64; 3]) = (
                std::array::from_fn(|axis| middle[axis] - halves[axis]),
                std::array::from_fn(|axis| middle[axis] + halves[axis]),
            );
            (Region::outside_box(name, min, max), Shape::Outside(min, max))
        }
        _ => {
            let inward = random.offsets::<3>(1.0);
            let length = inward.iter().map(|part| part * part).sum::<f64>().sqrt();
            let inward = inward.map(|part| part / length);
            let border = inward.map(|part| part * -random.between(0.0, reach * 0.8));
            (Region::half_space(name, border, inward), Shape::Half(border, inward))
        }
    };
    let seen = if in_user { RegionFrame::User } else { RegionFrame::ArmBase };
    (region.expect("a region").of(point).seen_from(seen), Zone { point: of, in_user, shape })
}

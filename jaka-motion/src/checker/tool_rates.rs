//! The joints' rates for a velocity of the tool, and the room along them.

use nalgebra::{Vector3, Vector6};

use super::Checker;
use crate::beyond::Exceeded;
use crate::model::Singularity;
use crate::velocity::{TcpVelocity, VelocityFrame};

/// In how many parts of the way ahead distances from singularities are compared.
const PARTS: u8 = 4;

impl Checker {
    /// A velocity seen from the arm's base, in mm/s and radians a second.
    pub(crate) fn twist_in_base(&self, velocity: &TcpVelocity, joints: &[f64; 6]) -> Vector6<f64> {
        let turn = match velocity.frame {
            VelocityFrame::ArmBase => nalgebra::UnitQuaternion::identity(),
            VelocityFrame::User => self.base.rotation.inverse(),
            VelocityFrame::Tool => self.tcp(joints).rotation,
        };
        let linear = turn * velocity.linear();
        let angular = turn * Vector3::from(velocity.angular_deg_s.map(f64::to_radians));
        Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
    }

    /// How the joints turn for it, in deg/s, unless they cannot; and the nearest singularity.
    pub(crate) fn rates(&self, joints: &[f64; 6], twist: &Vector6<f64>) -> (Option<[f64; 6]>, Exceeded) {
        let model = self.limits.model();
        let frames = model.links.frames(joints);
        let distances = model.distances(&frames);
        let nearest = (0..3).fold(0, |least, index| if distances[index] < distances[least] { index } else { least });
        (self.solved_at(joints, &frames).and_then(|here| here.rates(twist)), self.too_near(nearest, distances[nearest]))
    }

    /// How much of a way straight in joint space is free, if not all of it, and what is in the way; the way is `length` seconds at these rates.
    pub(crate) fn room_along(&self, from: &[f64; 6], rates: &[f64; 6], length: f64) -> Option<(f64, Exceeded)> {
        let at = |share: f64| std::array::from_fn(|index| from[index] + share * length * rates[index]);
        let regions =
            self.regions_on_joint_way(from, &at(1.0)).err().map(|(exceeded, share)| (share * length, exceeded));
        let ranges = (0..6).filter_map(|index| self.room_of_joint(index, from[index], rates[index]));
        let singularities = self.room_to_singularities(from, at).map(|(share, exceeded)| (share * length, exceeded));
        let all = ranges.chain(regions).chain(singularities).filter(|(room, _)| *room < length);
        all.min_by(|one, other| one.0.total_cmp(&other.0))
    }

    fn room_of_joint(&self, index: usize, position: f64, rate: f64) -> Option<(f64, Exceeded)> {
        let limit_deg = if rate > 0.0 { self.limits.joint_max()[index] } else { self.limits.joint_min()[index] };
        let room = (limit_deg - position) / rate;
        let exceeded = Exceeded::LandingRange { joint: index + 1, end_deg: position, limit_deg };
        room.is_finite().then_some((room.max(0.0), exceeded))
    }

    /// The share of the way at which the least distance from a singularity is reached; none of it for one that is nearer and comes nearer still.
    fn room_to_singularities(&self, from: &[f64; 6], at: impl Fn(f64) -> [f64; 6]) -> Option<(f64, Exceeded)> {
        let model = self.limits.model();
        let least = self.limits.singularity_distance();
        let distances = |joints: &[f64; 6]| model.signed_distances(&model.links.frames(joints));
        let mut before = distances(from);
        for part in 0..PARTS {
            let (begun, done) = (f64::from(part) / f64::from(PARTS), f64::from(part + 1) / f64::from(PARTS));
            let here = distances(&at(done));
            for index in 0..3 {
                // Counted on the side where the arm is.
                let (one, other) = (before[index].abs(), here[index] * before[index].signum());
                if other < least && other < one {
                    let part = ((one - least) / (one - other)).max(0.0);
                    return Some((begun + part * (done - begun), self.too_near(index, one)));
                }
            }
            before = here;
        }
        None
    }

    fn too_near(&self, index: usize, distance: f64) -> Exceeded {
        Exceeded::Singularity { which: Singularity::ALL[index], distance, least: self.limits.singularity_distance() }
    }
}

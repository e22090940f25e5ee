//! The joints where the tool is led.

use nalgebra::{Isometry3, Vector6};

use super::Checker;
use crate::beyond::Exceeded;
use crate::piece::Sample;

/// How a tool moves: where it is in the arm's base, its velocity and the change of it, in mm and radians a second.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Led {
    pub(crate) tool: Isometry3<f64>,
    pub(crate) velocity: Vector6<f64>,
    pub(crate) acceleration: Vector6<f64>,
}

impl Checker {
    /// How the joints near others move for a tool that moves so; none where they are not found, or cannot.
    pub(crate) fn led(&self, led: &Led, near: &[f64; 6]) -> Option<Sample> {
        self.solved(&led.tool, near)?.moving(&led.velocity, &led.acceleration)
    }

    /// Whether joint positions between two others are not nearer to a singularity than both of these and the least distance, but for the stated
    /// amount.
    pub(crate) fn no_nearer_to_singularities(&self, ends: [&[f64; 6]; 2], here: &[f64; 6]) -> Result<(), Exceeded> {
        let model = self.limits.model();
        let [one, other, here] = [ends[0], ends[1], here].map(|joints| model.distances(&model.links.frames(joints)));
        let least = std::array::from_fn(|index| one[index].min(other[index]) - Self::AMOUNT_SINGULARITY);
        self.distances_kept(&least, &here)
    }
}

//! A published arm with the Denavit-Hartenberg parameters of its own controller.

use std::fmt;

use jaka_proto::messages::kinematics::GetDhParamReply;

use super::Model;
use crate::closed_form::Precision;
use crate::links::Links;

/// How far a length of a controller may be from the published one, in mm.
const LENGTH: f64 = 5.0;
/// How far an angle of a controller may be from the published one, in degrees.
const ANGLE: f64 = 1.0;

/// Denavit-Hartenberg parameters that are not those of the published arm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct DhMismatch {
    /// The published arm's name.
    pub model: &'static str,
    /// Which parameter differs: `alpha`, `a`, `d` or `joint_home_offset`.
    pub parameter: &'static str,
    /// The joint, 1 to 6.
    pub joint: usize,
    /// What the controller has, in mm or degrees.
    pub found: f64,
    /// What the published arm has.
    pub published: f64,
}

impl fmt::Display for DhMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { model, parameter, joint, found, published } = self;
        let unit = if matches!(*parameter, "a" | "d") { "mm" } else { "deg" };
        write!(
            f,
            "DH parameter {parameter} of joint {joint} is {found} {unit}; that of the {model} is {published} {unit}"
        )
    }
}

impl std::error::Error for DhMismatch {}

impl Model {
    /// This arm with the parameters that its controller's `get_dh_param` (section 4.82) answers.
    ///
    /// Joint ranges and speeds stay the published ones. No source says how a controller means its parameters, and whether its
    /// own kinematics follow them: [`fit`](Self::fit) compares. Where the controller's are calibrated, so that axes are no longer quite parallel or at
    /// right angles, there is no closed form: the inverse starts from that of the nearest arm that has one and goes on step by step. It
    /// takes longer, and near a singularity it can miss a branch, or find nothing.
    ///
    /// # Errors
    /// A length differs from the published one by more than 5 mm, or an angle by more than 1 degree: it is another arm, or the
    /// parameters are meant in another way.
    pub fn with_dh(&self, reply: &GetDhParamReply) -> Result<Self, DhMismatch> {
        let (published, GetDhParamReply { alpha, a, d, joint_home_offset, .. }) = (&self.links, reply);
        self.compare("alpha", alpha, &published.alpha, ANGLE)?;
        self.compare("a", a, &published.a, LENGTH)?;
        self.compare("d", d, &published.d, LENGTH)?;
        self.compare("joint_home_offset", joint_home_offset, &published.joint_home_offset, ANGLE)?;
        let links = Links { alpha: *alpha, a: *a, d: *d, joint_home_offset: *joint_home_offset };
        let mut model = Self { links, ..self.clone() };
        model.closed_form.links = self.closed_form.nearest_to(&links);
        if model.closed_form.links != links {
            model.closed_form.precision = Precision::FirstGuess;
        }
        Ok(model)
    }

    fn compare(
        &self,
        parameter: &'static str,
        found: &[f64; 6],
        published: &[f64; 6],
        most: f64,
    ) -> Result<(), DhMismatch> {
        // Not `>`: a number that is not one differs too.
        let near = |index: &usize| (found[*index] - published[*index]).abs() <= most;
        (0..6).find(|index| !near(index)).map_or(Ok(()), |index| {
            let (found, published) = (found[index], published[index]);
            Err(DhMismatch { model: self.name, parameter, joint: index + 1, found, published })
        })
    }
}

//! Comparison of the arm's model with the controller's computations, and of the arm's place with its limits.

use jaka_motion::{Checker, Exceeded, FitError, Frames, Limits, Model, Tolerance};
use jaka_proto::messages::kinematics::{GetDhParam, GetDhParamReply, GetJointPos, KineForward};
use jaka_proto::messages::types::{JointPosition, Pose};

use super::commands::Commands;
use super::finding::{CheckItem, Finding, Judgement, either};

const NO_MODEL: &str = "no model agrees with the controller";

/// Limits of a model that agrees with the controller, and the frames that it has then.
type Agreeing = (Limits, Frames);

/// Judgement on the model, and the models that agree with the controller; or the reason why none was compared.
type Found = Result<(Judgement, Vec<Agreeing>), Judgement>;

/// Joint positions, and the controller's poses at them.
type Pairs = Vec<(JointPosition, Pose)>;

/// Compares the model that the arm should have, or else all published ones.
pub(super) fn read(limits: Option<&Limits>, commands: &mut Commands<'_>, findings: &mut Vec<Finding>) {
    let dh = commands.ask(&GetDhParam::new());
    let (model, agreeing) = match limits {
        Some(limits) => one(limits, dh.as_ref().ok(), commands),
        None => published(dh.as_ref().ok(), commands),
    }
    .unwrap_or_else(|failed| (failed, Vec::new()));
    let dh = either(dh.map(|reply| parameters(&agreeing, &reply)));
    let place = place(&agreeing, commands);
    findings.extend([model.at(CheckItem::Model), dh.at(CheckItem::DhParameters), place.at(CheckItem::Limits)]);
}

/// The model that the arm should be.
fn one(limits: &Limits, dh: Option<&GetDhParamReply>, commands: &mut Commands<'_>) -> Found {
    let pairs = poses(&limits.model().positions_to_compare(), commands)?;
    match limits.model().fit(&pairs, Tolerance::default()) {
        Ok(fit) => {
            let agreeing = vec![(limits.clone(), fit.frames)];
            Ok((Judgement::nothing(format!("poses agree with a {}", names(&agreeing))), agreeing))
        }
        Err(error) => {
            let advice = "look at the arm's name plate: limits of another model do not fit this arm";
            let own = calibrated(limits.model(), dh, &pairs).map(|agreeing| own_parameters(&agreeing));
            Ok((own.unwrap_or_else(|| Judgement::wrong(difference(&error), advice)), Vec::new()))
        }
    }
}

/// All published models. Several models of one size agree at once if a tool or a mounting can make up their difference.
fn published(dh: Option<&GetDhParamReply>, commands: &mut Commands<'_>) -> Found {
    let pairs = answered(commands)?;
    let fits = |model| Some((Limits::of(model), model.fit(&pairs, Tolerance::default()).ok()?.frames));
    let agreeing: Vec<_> = Model::published().iter().filter_map(fits).collect();
    if !agreeing.is_empty() {
        return Ok((Judgement::nothing(format!("poses agree with {}", names(&agreeing))), agreeing));
    }
    if let Some(agreeing) = Model::published().iter().find_map(|model| calibrated(model, dh, &pairs)) {
        return Ok((own_parameters(&agreeing), vec![agreeing]));
    }
    let advice = "do not use limits of a published model: they are for another arm";
    Ok((Judgement::look("no published model agrees with the controller", advice), Vec::new()))
}

/// The model with the controller's own parameters, if it agrees with these.
fn calibrated(model: &Model, dh: Option<&GetDhParamReply>, pairs: &Pairs) -> Option<Agreeing> {
    let own = model.with_dh(dh?).ok()?;
    let frames = own.fit(pairs, Tolerance::default()).ok()?.frames;
    Some((Limits::of(&own), frames))
}

fn own_parameters(agreeing: &Agreeing) -> Judgement {
    let name = agreeing.0.model().name();
    let seen = format!("a {name}, with its own parameters: the published ones differ too much");
    Judgement::look(seen, "build its model from `get_dh_param` with `Model::with_dh`")
}

fn difference(error: &FitError) -> String {
    match error {
        FitError::Differs { model, position_mm, angle_deg, tolerance, .. } => format!(
            "this is not a {model}: poses differ by up to {position_mm:.1} mm and {angle_deg:.3} deg, more than {} mm or {} \
             deg",
            tolerance.position_mm, tolerance.angle_deg
        ),
        error => error.to_string(),
    }
}

/// Poses at the first positions that the controller takes: it may refuse those beyond the ranges of its arm.
fn answered(commands: &mut Commands<'_>) -> Result<Pairs, Judgement> {
    let mut asked: Vec<[JointPosition; 12]> = Vec::new();
    let mut failed = None;
    for positions in Model::published().iter().map(Model::positions_to_compare) {
        if asked.contains(&positions) {
            continue;
        }
        match poses(&positions, commands) {
            Ok(pairs) => return Ok(pairs),
            Err(finding) => failed = failed.or(Some(finding)),
        }
        asked.push(positions);
    }
    Err(failed.unwrap_or_else(|| Judgement::not_checked("there is no model")))
}

fn poses(positions: &[JointPosition; 12], commands: &mut Commands<'_>) -> Result<Pairs, Judgement> {
    let pose = |joints| Ok((joints, commands.ask(&KineForward::new(joints))?.pose));
    positions.iter().copied().map(pose).collect()
}

/// The controller's own parameters: calibrated ones are near the published ones.
fn parameters(agreeing: &[Agreeing], reply: &GetDhParamReply) -> Judgement {
    let mut differs = None;
    for model in agreeing.iter().map(|(limits, _)| limits.model()) {
        match model.with_dh(reply) {
            Ok(_) => return Judgement::nothing(format!("equal or close to those of a {}", model.name())),
            Err(mismatch) => differs = differs.or(Some(mismatch)),
        }
    }
    let Some(mismatch) = differs else { return Judgement::not_checked(NO_MODEL) };
    let advice = "no source states their definition: the agreement of the model with the controller's poses decides";
    Judgement::look(mismatch.to_string(), advice)
}

/// Judges the place of the arm against the limits of the models that agree.
fn place(agreeing: &[Agreeing], commands: &mut Commands<'_>) -> Judgement {
    if agreeing.is_empty() {
        return Judgement::not_checked(NO_MODEL);
    }
    commands.judge(&GetJointPos::new(), |reply| {
        let at = reply.joint_position;
        let beyond =
            agreeing.iter().find_map(|(limits, frames)| Checker::new(limits.clone(), *frames).check_place(at).err());
        let Some(beyond) = beyond else {
            return Judgement::nothing(format!("the arm is within the limits of {}", names(agreeing)));
        };
        let seen = match &beyond.exceeded {
            Exceeded::JointRange { joint, position_deg, limit_deg } => {
                format!("joint {joint} is at {position_deg} deg; limit {limit_deg} ({})", beyond.model)
            }
            _ => beyond.to_string(),
        };
        Judgement::look(seen, "move it back, by a motion that goes no further out, or at the pendant")
    })
}

fn names(agreeing: &[Agreeing]) -> String {
    agreeing.iter().map(|(limits, _)| limits.model().name()).collect::<Vec<_>>().join(", ")
}

//! Motions with a wait for their end.

use jaka_robot::motions::MotionText;
use jaka_spec::words;

use super::request::Request;
use crate::builtin;
use crate::failure::Failure;
use crate::target::packs::Protocol;

/// Returns the motion of the request, if the program can wait for its end; `text` is sent.
///
/// # Errors
/// A pack has changed it, so that its target is unknown.
pub(super) fn motion(protocol: &Protocol, request: &Request<'_>) -> Result<Option<MotionText>, Failure> {
    let Some(command) = request.command else { return Ok(None) };
    let motion = jaka_dynamic::motion(&protocol.spec, builtin::spec(), command, &request.text);
    let motion = motion.map_err(|problem| {
        Failure::Usage(format!("`{}` was not sent: jaka cannot wait for its end: {problem}", request.name))
    })?;
    Ok(motion.map(|motion| {
        let text = MotionText::new(protocol.info(command), &*request.text);
        text.target(motion.target).path(motion.path).tolerance_mm(motion.tolerance_mm)
    }))
}

/// Returns the motion of the request. Any other request is an error.
pub(super) fn must_be_motion(protocol: &Protocol, request: &Request<'_>) -> Result<MotionText, Failure> {
    motion(protocol, request)?.ok_or_else(|| {
        let motions: Vec<_> =
            protocol.spec.commands().filter(|command| command.motion.is_some()).map(|command| &*command.wire).collect();
        let motions = words::list(&motions, "and");
        Failure::Usage(format!("`{}` was not sent: --wait is for the motions {motions}", request.name))
    })
}

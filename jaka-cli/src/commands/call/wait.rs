//! Motions whose end is waited for.

use std::time::Duration;

use jaka_robot::proto::check::{Limits, NotSent, Place, Validate};
use jaka_robot::proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_robot::proto::{self, Command, CommandInfo, RequestError};
use jaka_robot::{End, Error, Motion, Path, Robot};

use super::request::Request;
use crate::failure::Failure;

/// Runs a motion, for no longer than a time.
type Run = dyn Fn(&mut Robot, Duration) -> Result<End, Error>;

/// The motion that the request asks for, if its end can be waited for.
///
/// # Errors
/// A pack has changed it, so that it cannot be told where it ends.
pub(super) fn motion(request: &Request<'_>) -> Result<Option<Box<Run>>, Failure> {
    use proto::Request::{EndMove, JointMove, MoveC, MoveL, StartTorqSensorPayloadIdentify};
    let text = &request.text;
    Ok(Some(match proto::Request::read(text) {
        Ok(JointMove(motion)) => run(motion, text),
        Ok(EndMove(motion)) => run(motion, text),
        Ok(MoveL(motion)) => run(motion, text),
        Ok(MoveC(motion)) => run(motion, text),
        Ok(StartTorqSensorPayloadIdentify(motion)) => run(motion, text),
        Ok(_) | Err(RequestError::Unknown { .. }) => return Ok(None),
        Err(error) => {
            let name = &request.name;
            return Err(Failure::Usage(format!("`{name}` was not sent: it cannot be waited for: {error}")));
        }
    }))
}

/// The same of a request that must ask for one.
pub(super) fn must_be_motion(request: &Request<'_>) -> Result<Box<Run>, Failure> {
    motion(request)?.ok_or_else(|| {
        Failure::Usage(format!(
            "`{}` was not sent: --wait is for the motions joint_move, end_move, moveL, movc and \
             start_torq_sensor_payload_identify",
            request.name
        ))
    })
}

fn run<M: Motion + 'static>(motion: M, text: &str) -> Box<Run> {
    let motion = WithText { motion, text: text.to_owned() };
    Box::new(move |robot, patience| robot.run(&motion, patience))
}

/// A motion that goes out as its request was written, with what a pack adds to it. The request was checked by the packs before.
#[derive(Debug)]
struct WithText<M> {
    motion: M,
    text: String,
}

impl<M: Motion> Command for WithText<M> {
    type Reply = ();
    const INFO: &'static CommandInfo = M::INFO;

    fn write_request(&self, out: &mut Writer) {
        out.raw(&self.text);
    }
}

impl<M: Motion> Motion for WithText<M> {
    fn target(&self) -> jaka_robot::Target {
        self.motion.target()
    }

    fn path(&self) -> Path {
        self.motion.path()
    }

    fn tolerance(&self) -> f64 {
        self.motion.tolerance()
    }
}

impl<M: Motion> Validate for WithText<M> {
    fn validate(&self, _place: &Place<'_>, _limits: &Limits<'_>) -> Result<(), NotSent> {
        Ok(())
    }
}

impl<M: Motion> Fields for WithText<M> {
    fn write_fields(&self, out: &mut Writer) {
        self.motion.write_fields(out);
    }

    fn read_fields(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        M::read_fields(reader).map(|motion| Self { motion, text: String::new() })
    }
}

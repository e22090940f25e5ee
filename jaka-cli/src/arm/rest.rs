//! Rest of the arm after a stop.

use std::time::Duration;

use jaka_robot::Error;
use jaka_robot::kinematics::GetJointPos;
use jaka_robot::proto::Command as _;
use jaka_spec::Spec;

use crate::arm::interrupt::{Stage, UnderWay};
use crate::builtin;
use crate::failure::{Failure, unrest};
use crate::packets::packed_status::PackedRobot;
use crate::terminal::output;

/// Text for an arm that was seen at rest.
pub(crate) const SEEN: &str = "the arm is at rest";

/// Time within which an arm usually comes to rest. After that, the program says that it still moves.
pub(crate) const SOON: Duration = Duration::from_secs(1);

/// Time after that for an arm to come to rest, or the time for a reply if that is longer.
const PATIENCE: Duration = Duration::from_secs(5);

/// Waits until the arm is at rest. `wait` does so for at most a given time, and `reply` is the time for a reply.
pub(crate) fn seek(
    spec: &Spec,
    reply: Duration,
    mut wait: impl FnMut(Duration) -> Result<(), Error>,
) -> Result<(), Failure> {
    let query = GetJointPos::INFO.name;
    if !builtin::is_unchanged(spec, query) {
        return Err(Failure::NotSent(format!("a pack changes `{query}`, which is only read in its built-in form")));
    }
    match wait(SOON) {
        Err(error) if !error.is_disconnected() => {
            let unrest = unrest(&error.into());
            output::urgent_warning(&format!("{unrest}; use the emergency stop if it does not come to rest"));
            Ok(wait(PATIENCE.max(reply))?)
        }
        ended => Ok(ended?),
    }
}

/// Marks the end of the requests. If Ctrl-C has stopped the arm, first waits until the arm is at rest; `None` if not.
pub(crate) fn after_interrupt(
    under_way: &UnderWay,
    spec: &Spec,
    robot: &mut PackedRobot,
) -> Option<Result<(), Failure>> {
    let rest = under_way.finish().then(|| {
        let reply = robot.client().reply_timeout();
        seek(spec, reply, |timeout| robot.wait_for_rest(timeout))
    });
    under_way.set(Stage::Answered);
    rest
}

/// Says that the arm was seen at rest. The failure of the command says the contrary.
pub(crate) fn say(rest: Option<&Result<(), Failure>>) {
    if let Some(Ok(())) = rest {
        output::urgent_note(SEEN);
    }
}

/// Returns a result, or the failure of an arm that has been stopped and was not seen at rest.
pub(crate) fn required<T>(done: Result<T, Failure>, rest: Option<Result<(), Failure>>) -> Result<T, Failure> {
    match rest {
        Some(Err(unrest)) => Err(Failure::NotAtRest { ended: done.err().map(Box::new), unrest: unrest.into() }),
        Some(Ok(())) | None => done,
    }
}

//! `jaka clear`: leave a protective stop.

use std::time::Duration;

use clap::Args;
use jaka_sync::collision::ClearError;

use crate::arm::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::packets::packed_status::PackedStatus;
use crate::target::Target;
use crate::terminal::output;

/// Default timeout of `jaka clear`.
const PATIENCE: Duration = Duration::from_secs(15);

/// Leave the protective stop after a collision
///
/// Make sure first that nobody and nothing is in contact with the arm. This command waits until a status packet shows
/// no protective stop. An emergency stop must be released by hand.
#[derive(Debug, Args)]
pub(crate) struct Clear {
    #[command(flatten)]
    act: ActArgs,
}

impl Clear {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = self
            .act
            .begin("leave its protective stop, after which it can be moved again", &[intent(&ClearError::new())?])?;
        act.with(Target::robot::<PackedStatus>, "`clear_error`", |robot| {
            let patience = act.patience(PATIENCE);
            robot.client().call_within(&ClearError::new(), patience)?;
            robot.monitor().wait_until(|status| status.status.protective_stop == Some(false), patience)
        })?;
        output::line("the robot is not in a protective stop")
    }
}

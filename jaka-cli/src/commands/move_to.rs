//! `jaka move`: move the arm to joint positions or to a pose.

use clap::{ArgGroup, Args};

use crate::arm::going::GoArgs;
use crate::arm::planned::MoveTarget;
use crate::failure::Failure;
use crate::text::number::six;

const EXAMPLES: &str = "\
Examples:
  jaka move --joints 0,90,90,90,-90,0 --speed 10 -r cell1
  jaka move --pose -400,100,450,180,0,90 --speed 50 -r cell1 --model zu5
  jaka move --joints 0,90,90,90,-90,0 --speed 10 --dry-run";

/// Move the arm to joint positions or to a pose, and wait until it is there; Ctrl-C stops it
///
/// The command waits for the end of the motion for 300 s or --timeout, and its exit code tells the outcome: see
/// `jaka --help`. Without --model or --limits, only the controller knows the reach of the arm.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, group = ArgGroup::new("target").required(true).args(["joints", "pose"]))]
pub(crate) struct Move {
    /// Positions of the six joints, in deg (`joint_move`)
    #[arg(long, value_name = "DEG,...", value_parser = six, allow_hyphen_values = true)]
    joints: Option<[f64; 6]>,
    /// Pose of the tool centre point, reached on a straight line: x, y, z, rx, ry, rz in mm and deg (`moveL`)
    ///
    /// The pose is in the tool and user frames selected on the controller.
    #[arg(long, value_name = "X,Y,Z,RX,RY,RZ", value_parser = six, allow_hyphen_values = true)]
    pose: Option<[f64; 6]>,
    #[command(flatten)]
    go: GoArgs,
}

impl Move {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.go.go(match (self.joints, self.pose) {
            (Some(joints), _) => MoveTarget::Joints(joints),
            (None, pose) => MoveTarget::Pose(pose.unwrap_or_default()),
        })
    }
}

//! Common parts of `jaka move` and `jaka jog`.

use clap::Args;
use jaka_motion::Limits;
use jaka_robot::Motion;
use jaka_robot::motion::{JointMove, MoveL};

use crate::arm::acting::{ActArgs, QueueArgs, intent, joints};
use crate::arm::limits::{LimitsArgs, acceleration_deg_s2};
use crate::arm::motion::Form;
use crate::arm::planned::{MoveTarget, Planned, only_at};
use crate::failure::Failure;
use crate::terminal::output;
use crate::text::number::rate;

/// Options of a motion with a wait for its end.
#[derive(Debug, Args)]
pub(crate) struct GoArgs {
    /// Speed: in deg/s of the joint that turns furthest, or in mm/s along the line
    #[arg(long, value_name = "SPEED", value_parser = rate)]
    speed: f64,
    /// Acceleration: in deg/s² or mm/s² [default: the controller's; for joints with --model or --limits, the lowest
    /// limit]
    #[arg(long, value_name = "ACCELERATION", value_parser = rate)]
    acceleration: Option<f64>,
    /// Print the request without sending it
    ///
    /// With --model or --limits, compare it with the limits as far as possible without the command port. With --robot
    /// or --sim as well, read the position of the arm from one status packet, which disturbs no other program.
    #[arg(long)]
    dry_run: bool,
    /// Print one JSON object: `command` and `end`
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limits: LimitsArgs,
    #[command(flatten)]
    queue: QueueArgs,
    #[command(flatten)]
    act: ActArgs,
}

impl GoArgs {
    /// Checks the motion, asks, sends it and waits for its end; or prints the request.
    pub(crate) fn go(&self, goal: MoveTarget) -> Result<(), Failure> {
        let limits = self.limits.read()?;
        let mut acceleration = self.acceleration;
        if goal.is_of_joints() {
            acceleration = acceleration_deg_s2(acceleration, limits.as_ref());
        }
        let planned = Planned { goal, speed: self.speed, acceleration };
        let joints = |mut motion: JointMove| {
            motion.acceleration = acceleration;
            self.carry_out(&motion, &planned, limits.clone())
        };
        let line = |mut motion: MoveL| {
            motion.acceleration = acceleration;
            self.carry_out(&motion, &planned, limits.clone())
        };
        match goal {
            MoveTarget::Joints(to) => joints(JointMove::absolute(to, self.speed)),
            MoveTarget::Joint(at, by) => joints(JointMove::relative(only_at(at, by), self.speed)),
            MoveTarget::Pose(to) => line(MoveL::absolute(to, self.speed)),
            MoveTarget::Line(at, by) => line(MoveL::relative(only_at(at, by), self.speed)),
        }
    }

    fn carry_out<M: Motion>(&self, motion: &M, planned: &Planned, limits: Option<Limits>) -> Result<(), Failure> {
        let intent = intent(motion)?;
        if let Some(limits) = &limits {
            planned.check(limits, None)?;
        }
        if self.dry_run {
            if let Some(limits) = &limits {
                self.compare(planned, limits)?;
            }
            // Prints the bytes of the request, as `jaka call --dry-run` does.
            return output::write(format!("{}\n", intent.text).as_bytes());
        }
        let act = self.act.begin_told(&[intent], |target| {
            let from = match &limits {
                _ if !planned.goal.is_of_joints() => None,
                Some(_) => joints(target)?,
                // The position is only shown in the question.
                None => joints(target).ok().flatten(),
            };
            limits.as_ref().map_or(Ok(()), |limits| planned.check(limits, from))?;
            Ok(planned.told(from))
        })?;
        act.run(motion, limits, (self.queue, Form::of(self.json)))
    }

    /// Compares the motion with limits from the position of the arm, if the line names it, and notes the limits not
    /// compared.
    fn compare(&self, planned: &Planned, limits: &Limits) -> Result<(), Failure> {
        let target = if planned.goal.is_of_joints() { self.act.named_target()? } else { None };
        let from = target.map_or(Ok(None), |target| joints(&target))?;
        planned.check(limits, from)?;
        output::note(match from {
            Some(_) => {
                "compared with the limits of joints, from the position of the arm; regions and the tool's speed are compared before it is sent"
            }
            None if planned.goal.is_of_joints() => {
                "only the speed was compared with limits, because the position of the arm is not known; --robot or --sim name an arm"
            }
            None => {
                "only the tool's speed was compared with limits: the tool and the frames are read before it is sent"
            }
        });
        Ok(())
    }
}

//! Commands with one action on a robot, each after a question.

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use jaka_motion::{Checker, Frames, Limits, Trajectory};
use jaka_robot::kinematics::{GetJointPos, GetTcpPos};
use jaka_robot::power::GetRobotState;
use jaka_robot::program::StopProgram;
use jaka_robot::proto::Command;
use jaka_robot::servo::IsInServomove;
use jaka_robot::types::JointPosition;
use jaka_robot::{Error, FollowConfig, Motion, RobotConfig, wait_for_rest};
use jaka_spec::{Effect, Role, Spec};

use crate::arm::consent;
use crate::arm::consent::Intent;
use crate::arm::interrupt::{Stage, UnderWay};
use crate::arm::motion;
use crate::arm::motion::{Ended, Form};
use crate::arm::rest;
use crate::builtin;
use crate::failure::Failure;
use crate::packets::packed_status::{PackedRobot, PackedStatus};
use crate::target::packs::{Protocol, SpecArgs};
use crate::target::{RobotArgs, Target};
use crate::terminal::output;

/// Options of a command with one action on a robot.
#[derive(Debug, Args)]
pub(crate) struct ActArgs {
    /// Send without asking
    #[arg(long, short)]
    yes: bool,
    #[command(flatten)]
    spec: SpecArgs,
    #[command(flatten)]
    robot: RobotArgs,
}

/// Robot of an action. From its creation on, Ctrl-C is handled.
#[derive(Debug)]
pub(crate) struct Act {
    target: Target,
    under_way: UnderWay,
}

impl ActArgs {
    /// Asks whether the user wants this of the arm, such as "lose its power", for which these requests are sent as
    /// needed. Does not connect yet.
    pub(crate) fn begin(&self, what: &str, intents: &[Intent<'_>]) -> Result<Act, Failure> {
        self.begin_told(intents, |_| Ok(what.to_owned()))
    }

    /// Asks whether the user wants this of the arm, like [`Self::begin`]. `what` may read the status port first, which
    /// disturbs no other program.
    pub(crate) fn begin_told(
        &self,
        intents: &[Intent<'_>],
        what: impl FnOnce(&Target) -> Result<String, Failure>,
    ) -> Result<Act, Failure> {
        let protocol = self.protocol()?;
        must_be_as_built_in(&protocol.spec, intents)?;
        let act = Act::begin(&self.robot, &protocol.packs)?;
        if !self.yes && !self.robot.is_simulated() {
            consent::must_be_askable(intents)?;
            consent::obtain_act(&what(&act.target)?, intents, act.target.title())?;
        }
        Ok(act)
    }

    /// Returns the robot, if the line names one.
    pub(crate) fn named_target(&self) -> Result<Option<Target>, Failure> {
        if self.robot.is_given() { self.robot.target(&self.protocol()?.packs).map(Some) } else { Ok(None) }
    }

    /// Loads the protocol with the packs of the line, and makes it the protocol of status packets.
    fn protocol(&self) -> Result<Protocol, Failure> {
        let protocol = self.spec.load(self.robot.lookup())?;
        protocol.read_status();
        Ok(protocol)
    }
}

/// Returns an error if packs change a command that is sent here, or one that a robot sends meanwhile: these go out in
/// their built-in form.
fn must_be_as_built_in(spec: &Spec, intents: &[Intent<'_>]) -> Result<(), Failure> {
    let is_needed = |command: &&jaka_spec::Command| {
        command.effect == Effect::Power
            || matches!(command.role, Some(Role::Stop | Role::SetPoint | Role::ServoMode))
            || intents.iter().any(|intent| intent.name == command.wire)
            || QUERIES.contains(&&*command.wire)
    };
    let is_changed = |command: &&jaka_spec::Command| !builtin::is_unchanged(spec, &command.wire);
    match builtin::spec().commands().filter(is_needed).find(is_changed) {
        None => Ok(()),
        Some(command) => Err(Failure::Usage(format!(
            "nothing was sent: a pack changes `{0}`, but this command sends the built-in form\nhint: `jaka call` sends commands in the form of the packs",
            command.wire
        ))),
    }
}

/// Queries that a robot uses to detect the end of a motion, and the states that prevent a motion.
const QUERIES: [&str; 4] =
    [GetJointPos::INFO.name, GetTcpPos::INFO.name, GetRobotState::INFO.name, IsInServomove::INFO.name];

/// Returns the intent to send this request.
pub(crate) fn intent<C: Command>(request: &C) -> Result<Intent<'static>, Failure> {
    Intent::of(builtin::spec(), request)
}

impl Act {
    /// Begins an action that sends its request without a question, also if it cannot be recorded; the failure of that
    /// comes with it.
    pub(crate) fn at_once(robot: &RobotArgs) -> Result<(Self, Option<Failure>), Failure> {
        let under_way = UnderWay::begin();
        let (target, unrecorded) = robot.target_or_unrecorded(&[])?;
        Ok((Self { target, under_way }, unrecorded))
    }

    fn begin(robot: &RobotArgs, packs: &[PathBuf]) -> Result<Self, Failure> {
        let under_way = UnderWay::begin();
        Ok(Self { target: robot.target(packs)?, under_way })
    }

    /// Returns the timeout for the action: `--timeout` of the command line, or else this one.
    pub(crate) fn patience(&self, usual: Duration) -> Duration {
        self.target.patience(usual)
    }

    /// Runs an action over this connection; `sends` names its requests.
    pub(crate) fn with<C, T, E: Into<Error>>(
        &self,
        connect: fn(&Target) -> Result<C, Failure>,
        sends: &str,
        act: impl FnOnce(&mut C) -> Result<T, E>,
    ) -> Result<T, Failure> {
        let mut connection = connect(&self.target)?;
        self.under_way.set(Stage::Sent(sends.to_owned()));
        let done = act(&mut connection);
        self.under_way.set(Stage::Answered);
        done.map_err(|error| Failure::explained(builtin::of_status(), error))
    }

    /// Stops the arm, says so once the controller has accepted that, and waits until the arm is at rest. `protocol`
    /// loads the spec of its joints, after the stop.
    pub(crate) fn stop(&self, protocol: impl FnOnce() -> Spec) -> Result<(), Failure> {
        let mut client = self.target.client().map_err(not_stopped)?;
        self.under_way.set(Stage::Sent("`stop_program`".to_owned()));
        let stopped = client.call(&StopProgram::new());
        stopped.map_err(|error| not_stopped(Failure::explained(builtin::of_status(), error)))?;
        self.under_way.set(Stage::Stopped);
        // The reader of the output may be gone, which ends no wait.
        let said = output::line("the controller accepted the stop (`stop_program`)");
        let usual = client.reply_timeout();
        let rest = rest::seek(&protocol(), usual, |timeout| wait_for_rest(&mut client, timeout));
        self.under_way.set(Stage::Answered);
        rest.map_err(|unrest| Failure::NotAtRest { ended: None, unrest: unrest.into() })?;
        said.and_then(|()| output::line(rest::SEEN))
    }

    /// Runs an action with both ports, step by step. After Ctrl-C no further step is sent, and the arm must come to
    /// rest.
    pub(crate) fn with_steps<T>(&self, act: impl FnOnce(&mut PackedRobot) -> Result<T, Error>) -> Result<T, Failure> {
        let mut robot: PackedRobot = self.target.robot()?;
        self.under_way.set(Stage::Steps(robot.stop_handle()));
        let done = act(&mut robot);
        let done = done.map_err(|error| Failure::explained(builtin::of_status(), error));
        let rest = rest::after_interrupt(&self.under_way, builtin::of_status(), &mut robot);
        rest::say(rest.as_ref());
        rest::required(done, rest)
    }

    /// Returns the joints of the arm, from the status port alone; `None` if the packet does not have them.
    pub(crate) fn joints(&self) -> Result<Option<JointPosition>, Failure> {
        joints(&self.target)
    }

    /// Follows a trajectory to its end. Plans it with the frames of the controller.
    pub(crate) fn follow(
        &self,
        plan: &dyn Fn(&Checker) -> Result<Trajectory, Failure>,
        limits: Limits,
        config: &FollowConfig,
    ) -> Result<Ended, Failure> {
        let mut robot: PackedRobot = self.target.robot()?;
        let without_frames = Checker::new(limits.clone(), Frames::new());
        robot.configure(&RobotConfig::new().limits(limits))?;
        let trajectory = &plan(robot.limits().unwrap_or(&without_frames))?;
        let stop = robot.stop_handle();
        self.under_way.set(Stage::Moving(stop.clone()));
        let ended = robot.start_follow(trajectory, config).map(|run| {
            self.under_way.set(Stage::Following(run.handle(), stop));
            run.wait()
        });
        motion::at_rest(&mut robot, ended, builtin::of_status(), &self.under_way)
    }

    /// Runs a motion, and prints its end.
    pub(crate) fn run<M: Motion>(
        &self,
        motion: &M,
        limits: Option<Limits>,
        (queue, form): (QueueArgs, Form),
    ) -> Result<(), Failure> {
        let mut robot = self.target.robot()?;
        queue.check(&robot, M::INFO.name, self.patience(QUEUE_PATIENCE))?;
        if let Some(limits) = limits {
            robot.configure(&RobotConfig::new().limits(limits))?;
        }
        let patience = self.patience(motion::PATIENCE);
        let ended =
            motion::end(&mut robot, |robot| robot.run(motion, patience), builtin::of_status(), &self.under_way)?;
        motion::print(M::INFO.name, ended, form)
    }
}

fn not_stopped(failure: Failure) -> Failure {
    Failure::NotStopped(Box::new(failure))
}

/// Returns the joint positions, from the status port alone; `None` if the packet does not have them.
pub(super) fn joints(target: &Target) -> Result<Option<JointPosition>, Failure> {
    Ok(target.status::<PackedStatus>()?.joint_actual_position)
}

/// Timeout for the packet that shows whether the arm moves.
const QUEUE_PATIENCE: Duration = Duration::from_secs(5);

/// Option to queue a motion behind another one.
#[derive(Debug, Clone, Copy, Args)]
pub(crate) struct QueueArgs {
    /// Send the motion even while the arm moves: the controller queues it behind that motion
    #[arg(long)]
    queue: bool,
}

impl QueueArgs {
    /// Returns an error if packets show that the arm moves, or do not show whether it moves.
    fn check(self, robot: &PackedRobot, command: &str, patience: Duration) -> Result<(), Failure> {
        if self.queue {
            return Ok(());
        }
        let why = match robot.monitor().wait_until(|_| true, patience)?.status.status.in_position {
            Some(true) => return Ok(()),
            Some(false) => {
                "the arm is moving, and the controller would queue the command after that motion\nhint: wait for its end, stop it with `jaka stop`, or use --queue"
            }
            None => {
                "status packets do not show whether the arm moves, and the controller would queue the command after another motion\nhint: look at the arm, and use --queue"
            }
        };
        Err(Failure::NotSent(format!("`{command}` was not sent: {why}")))
    }
}

#[cfg(test)]
mod tests {
    use jaka_robot::motion::JointMove;
    use jaka_spec::{Source, load_pack};

    use super::*;

    fn spec(pack: &str) -> Spec {
        let text = format!("title = 'T'\n{pack}");
        let pack = load_pack(builtin::spec(), Source { path: "pack.toml", text: &text });
        pack.unwrap_or_else(|errors| panic!("{errors}")).spec
    }

    #[test]
    fn commands_that_packs_change_are_not_sent_as_built_in() {
        let intents = [intent(&JointMove::absolute([0.0; 6], 10.0)).expect("the spec allows it")];
        let unit = "[[override]]\ntarget = 'joint_move'\nrequest = 'speed'\nunit = 'rad/s'\n\
                    [[override]]\ntarget = 'joint_move'\nmotion = 'unknown'\n";
        let key = "[[override]]\ntarget = 'get_joint_pos'\nreply = 'joint_pos'\nwire = 'joints'\n";
        let words = "[[override]]\ntarget = 'get_robot_state'\nreply = 'enable'\nwritten = ['off', 'on']\n";
        for (pack, command) in [(unit, "`joint_move`"), (key, "`get_joint_pos`"), (words, "`get_robot_state`")] {
            let refused = must_be_as_built_in(&spec(pack), &intents).expect_err("it would be sent in another form");
            assert!(refused.to_string().contains(command), "{refused}");
        }
        // An additional optional field, and commands that are not sent here.
        let more = "[[extend]]\ntarget = 'joint_move'\n[[extend.request]]\nwire = 'zone'\ntype = 'float'\noptional = true\n\
                    doc = 'D.'\n[[override]]\ntarget = 'get_payload'\nreply = 'mass'\nwire = 'weight'\n";
        assert!(must_be_as_built_in(&spec(more), &intents).is_ok());
    }
}

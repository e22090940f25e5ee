//! Events between two steps of a call: a stop, a trip, an answer, a panic. Time is simulated; the requests that the
//! controller received are the witness.

mod guards;
mod power;
mod queues;
mod sending;
mod stops;
mod waits;

use std::borrow::Cow;
use std::time::Duration;

use jaka_proto::check::{FieldLimits, NotSent, Place, Validate};
use jaka_proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_proto::{Command, CommandInfo, Envelope};
use jaka_robot::motion::JointMove;
use jaka_robot::{Motion, Numbering, Robot, Target};
use jaka_sim::{Controller, Fault};
use jaka_tests::{Arm, ArmBuilder, LONG};

/// Period of status packets.
const PERIOD: Duration = Duration::from_millis(10);

const IO: Numbering = Numbering::FromOne;

/// Target of joint 1, which takes four seconds.
const FAR: f64 = 100.0;

fn arm() -> ArmBuilder {
    Arm::simulated().status_period(PERIOD)
}

/// An absolute motion of joint 1 to an angle in degrees, at 25 deg/s.
fn to(angle: f64) -> JointMove {
    JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0)
}

/// Names of the requests that the controller received.
fn names(controller: &Controller) -> Vec<String> {
    let name = |text: &String| Envelope::read(text).expect("requests are JSON").command.map(Cow::into_owned);
    controller.requests().iter().map(|text| name(text).expect("requests have a name")).collect()
}

/// Names of the requests that change something.
fn changes(controller: &Controller) -> Vec<String> {
    names(controller).into_iter().filter(|name| !name.starts_with("get_") && !name.starts_with("is_")).collect()
}

/// A refusal of a command.
fn refusal(command: &str) -> Fault {
    let text = format!(r#"{{"errorCode": "2", "errorMsg": "call {command} failed", "cmdName": "{command}"}}"#);
    Fault::Instead(text.into_bytes())
}

/// The arm is at rest on its way to [`FAR`].
fn assert_stopped_on_the_way(controller: &Controller) {
    let state = controller.state();
    let angle = state.joint_position.0[0];
    assert!(state.at_rest && angle > 0.0 && angle < FAR - 1.0, "at {angle} deg, at rest: {}", state.at_rest);
}

/// The next motion is sent, and reaches its target.
fn assert_moves(robot: &mut Robot) {
    robot.run(&to(0.0), LONG).expect("nothing keeps it back").reached().expect("nothing is in its way");
}

/// A motion to [`FAR`] by code of the program's own, which runs before it is sent.
struct Hooked<'h> {
    target: Target,
    /// Runs when the robot has made its checks, before the motion is sent.
    before_sending: &'h dyn Fn(),
}

impl Default for Hooked<'_> {
    fn default() -> Self {
        Self { target: Target::Joints(to(FAR).joint_position), before_sending: &|| () }
    }
}

impl Command for Hooked<'_> {
    type Reply = ();
    const INFO: &'static CommandInfo = JointMove::INFO;
}

impl Motion for Hooked<'_> {
    fn target(&self) -> Target {
        self.target
    }
}

impl Validate for Hooked<'_> {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        (self.before_sending)();
        Ok(())
    }
}

impl Fields for Hooked<'_> {
    fn write_fields(&self, out: &mut Writer) {
        to(FAR).write_fields(out);
    }

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Err(DecodeError::unfit("nothing", ""))
    }
}

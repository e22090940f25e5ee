//! Commands: each links the type of a request to the type of its reply.

use std::time::Duration;

use crate::check::{FieldLimits, NotSent, Place, Rules, Validate};
use crate::firmware::FirmwareRange;
use crate::messages::{Change, Effect, Requirement, Role};
use crate::wire::{Fields, Writer};

/// A request, with the type of its reply.
///
/// Implemented by the generated requests. A client sends any of them through one method, so code can be generic over
/// the command.
pub trait Command: Fields + Validate {
    /// Payload of the reply, in addition to the error code: a struct, or `()` for a reply without a payload.
    type Reply: Fields;

    /// Facts of the spec about the command.
    const INFO: &'static CommandInfo;

    /// Role of this request for the arm. A request has another one than its command if it stops the jog of an axis, or
    /// leaves servo mode.
    fn role(&self) -> Option<Role> {
        Self::INFO.role
    }

    /// Writes the request as it goes over the wire.
    fn write_request(&self, out: &mut Writer) {
        out.raw(Self::INFO.head);
        self.write_fields(out);
        out.raw("}");
    }

    /// Checks the request against the spec, and against the controller's firmware where the rules say which it is.
    ///
    /// # Errors
    /// A field has a forbidden value, or the firmware does not have the command or a given field.
    fn check(&self, rules: impl Into<Rules>) -> Result<(), NotSent> {
        check_request(Self::INFO, self, rules.into())
    }
}

fn check_request(info: &CommandInfo, request: &dyn Validate, rules: Rules) -> Result<(), NotSent> {
    let place = Place::request(info.name, rules);
    place.exists(&info.firmware)?;
    request.validate(&place, &FieldLimits::NONE)
}

/// Operation on a request of any type: see [`Request::visit`](crate::Request::visit).
pub trait Visit {
    /// Result of the operation.
    type Output;

    /// Applies the operation to the request.
    fn visit<C: Command>(self, command: &C) -> Self::Output;
}

/// Facts of the spec about a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct CommandInfo {
    /// `cmdName` on the wire.
    pub name: &'static str,
    /// The beginning of each request: the brace, and `cmdName` with its value.
    #[doc(hidden)]
    pub head: &'static str,
    /// Section of the vendor's document, such as `4.7`; empty for a command that the document does not have.
    pub section: &'static str,
    /// Effect of the command on the robot.
    pub effect: Effect,
    /// Role of the command for the arm; single requests may have another one ([`Command::role`]). That of a pack is its
    /// author's claim.
    pub role: Option<Role>,
    /// Properties of the arm that it changes.
    pub changes: &'static [Change],
    /// True for a motion with an end that can be awaited: its request is a [`Motion`](crate::Motion), unless a pack has
    /// changed the type of its target.
    pub is_motion: bool,
    /// States without which the controller refuses.
    pub requires: &'static [Requirement],
    /// Timeout for a reply, if the client's default does not fit.
    pub deadline: Option<Duration>,
    /// False if the controller may go away instead of replying.
    pub reply_certain: bool,
    /// True if the connection is useless after the reply.
    pub ends_session: bool,
    /// Key of the reply that a bare Python tuple in place of a JSON reply represents.
    pub bare_reply: Option<&'static str>,
    /// The firmware that has the command.
    pub firmware: FirmwareRange,
}

/// Builds the facts of a command from the fields that differ from those of most commands. The controller
/// answers most commands within the client's default timeout. For generated code.
#[doc(hidden)]
#[macro_export]
macro_rules! __command_info {
    ($name:expr, $head:expr, $section:expr, $effect:ident $(, $field:ident: $value:expr)* $(,)?) => {{
        #[allow(unused_mut)]
        let mut info = $crate::CommandInfo::usual($name, $head, $section, $crate::Effect::$effect);
        $(info.$field = $value;)*
        info
    }};
}

impl CommandInfo {
    /// Facts of the built-in command with this `cmdName`; `None` if the spec does not have it.
    pub fn of(name: &str) -> Option<&'static Self> {
        crate::Request::COMMANDS.iter().copied().find(|info| info.name == name)
    }

    #[doc(hidden)]
    pub const fn usual(name: &'static str, head: &'static str, section: &'static str, effect: Effect) -> Self {
        Self {
            name,
            head,
            section,
            effect,
            role: None,
            changes: &[],
            is_motion: false,
            requires: &[],
            deadline: None,
            reply_certain: true,
            ends_session: false,
            bare_reply: None,
            firmware: FirmwareRange::ALL,
        }
    }
}

impl Role {
    /// True for a request that another handle of the connection may send while a session, a stream or a trajectory
    /// moves the arm: a stop, the end of servo mode, an output, a short query. Power and enabling are kept back: at
    /// speed the arm would fall into its brakes, where a stop brakes it.
    pub fn passes_beside_set_points(self) -> bool {
        match self {
            Self::Stop | Self::StopAxis | Self::LeaveServoMode | Self::Output | Self::State => true,
            Self::Start | Self::Pause | Self::Resume | Self::SetPoint | Self::ServoMode => false,
        }
    }

    /// True for a request that moves the arm, or lets set-points move it: none goes out after a stop until that is
    /// acknowledged.
    pub fn moves(self) -> bool {
        match self {
            Self::Start | Self::Resume | Self::SetPoint | Self::ServoMode => true,
            Self::Stop | Self::StopAxis | Self::Pause | Self::LeaveServoMode | Self::Output | Self::State => false,
        }
    }
}

impl Change {
    /// True if poses mean something else afterwards.
    pub fn concerns_poses(self) -> bool {
        match self {
            Self::Frames | Self::Tool => true,
            Self::Payload => false,
        }
    }
}

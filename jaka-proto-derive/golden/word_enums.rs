/// Effect of a command on the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Effect {
    /// Reads; changes nothing.
    Query,
    /// Changes a setting or an output.
    Setting,
    /// Starts, stops or continues a motion or a program.
    Motion,
    /// Switches power, brakes or the controller itself.
    Power,
    /// Concerns the connection alone.
    Session,
}
/// The word of the spec's files.
impl ::core::fmt::Display for Effect {}
/// Role of a request for the arm, which decides the times at which it may be sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Role {
    /// Stops the arm. Stop handles, guards and sessions send the built-in `stop_program` alone.
    Stop,
    /// Stops the jog of one axis.
    StopAxis,
    /// Pauses a motion or a program.
    Pause,
    /// Resumes a paused motion.
    Resume,
    /// Set-point of servo mode.
    SetPoint,
    /// Enters or leaves servo mode. A request that leaves it has a role of its own.
    ServoMode,
    /// Sets an output. Passes while a session, a stream or a trajectory moves the arm.
    Output,
    /// Short query for a state of the robot. Passes while a session, a stream or a trajectory moves the arm.
    State,
    /// Starts a motion or a program, or moves the arm otherwise.
    Start,
    /// Leaves servo mode.
    LeaveServoMode,
}
/// The word of the spec's files.
impl ::core::fmt::Display for Role {}
/// Property of the arm that a command changes, and on which other commands depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Change {
    /// Frames to which poses refer: the user frame, or the mounting of the arm.
    Frames,
    /// Tool frame, whose origin is the tool centre point.
    Tool,
    /// Payload.
    Payload,
}
/// The word of the spec's files.
impl ::core::fmt::Display for Change {}
/// A state that a command needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Requirement {
    /// The arm has power.
    Powered,
    /// The arm is enabled.
    Enabled,
    /// Servo mode is on.
    ServoMode,
    /// Servo mode is off.
    NotServoMode,
}
/// The word of the spec's files.
impl ::core::fmt::Display for Requirement {}
/// Severity of a controller's event.
///
/// The severity is the vendor's and does not say whether the arm moves: an emergency stop is information. The
/// other fields of the status packet say whether the arm is stopped. For a program that waits for the end of a
/// motion the rule is: an error ends the wait; a warning and information are reported and end nothing; an unknown
/// event ends the wait only together with an arm at rest or a stop that the status packet shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Severity {
    /// Something failed.
    Error,
    /// Something may fail, or was not done.
    Warning,
    /// Something happened.
    Information,
    /// The table does not have the event's code, as with newer firmware. It may be an error.
    Unknown,
}
/// The word of the spec's files.
impl ::core::fmt::Display for Severity {}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Effect {
    Query,
    Setting,
    Motion,
    Power,
    Session,
}
impl ::core::fmt::Display for Effect {}
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Role {
    Stop,
    StopAxis,
    Pause,
    Resume,
    SetPoint,
    ServoMode,
    Output,
    State,
    Start,
    LeaveServoMode,
}
impl ::core::fmt::Display for Role {}
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Change {
    Frames,
    Tool,
    Payload,
}
impl ::core::fmt::Display for Change {}
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Requirement {
    Powered,
    Enabled,
    ServoMode,
    NotServoMode,
}
impl ::core::fmt::Display for Requirement {}
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Severity {
    Error,
    Warning,
    Information,
    Unknown,
}
impl ::core::fmt::Display for Severity {}

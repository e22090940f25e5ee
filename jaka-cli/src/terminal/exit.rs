//! Exit codes, by the possible reactions of a script to a failure. Those of a motion's end are in the table of causes
//! of jaka-robot.

use std::process::ExitCode;

use jaka_robot::{Cause, Error, ErrorKind};
use jaka_spec::tools::Impact;

use crate::failure::command_line;
use crate::failure::{Failure, chain};
use crate::terminal::output;

/// Code for a command that the controller refused and did not run.
pub(crate) const REFUSED: u8 = 1;
/// Code for a wrong command line, config file or argument. clap's own code for its errors.
pub(crate) const USAGE: u8 = 2;
/// Code for a failed connection; nothing was sent.
pub(crate) const NO_CONNECTION: u8 = 3;
/// Code for a command that may have run.
pub(crate) const MAY_HAVE_RUN: u8 = Cause::Unanswered.exit_code();
/// Code for a lost or unreadable connection without an outstanding command.
pub(crate) const LOST: u8 = 5;
/// Code for a failure on this machine.
pub(crate) const LOCAL: u8 = 6;

/// Code for a deviation from the spec in `jaka probe`, or of clients from the recording in `jaka replay`.
pub(crate) const DEPARTS: u8 = 7;

/// Code for a finding of `jaka check` to look at.
pub(crate) const LOOK: u8 = 8;
/// Code for an error found by `jaka check`.
pub(crate) const WRONG: u8 = 9;

/// Code for a motion that the robot's state or a limit forbids, or with an unknown state; nothing that moves the arm
/// was sent.
pub(crate) const NOT_MOVED: u8 = Cause::Moving.exit_code();
/// Code for a wait that ended with its timeout. After a wait for the end of a motion, the arm may still move.
pub(crate) const DEADLINE: u8 = Cause::Deadline.exit_code();
/// Code for a stop by Ctrl-C or `jaka stop` after which the arm may still move: the controller did not accept it, or
/// its acceptance is unknown, or the arm was not seen at rest.
pub(crate) const NOT_STOPPED: u8 = 29;

/// Code for Ctrl-C before any request was sent, or before the awaited event.
pub(crate) const INTERRUPTED: u8 = 130;

/// Prints a failure with its causes on standard error, and returns the exit code.
pub(crate) fn report(failure: &Failure) -> ExitCode {
    match failure {
        Failure::Printed(_) => {}
        // The reader may be gone: the exit code is sufficient.
        Failure::CommandLine(error) if command_line::is_help(error) => drop(error.print()),
        _ => {
            let hint = failure.hint().map(|hint| format!("\nhint: {hint}")).unwrap_or_default();
            output::error(&format!("{}{hint}", chain(failure)));
        }
    }
    ExitCode::from(code(failure))
}

/// Returns the exit code of a failure.
pub(crate) fn code(failure: &Failure) -> u8 {
    match failure {
        Failure::CommandLine(error) if !error.use_stderr() => 0,
        Failure::Usage(_) | Failure::CommandLine(_) => USAGE,
        Failure::Robot(error) => exit_code(error),
        Failure::Refused { .. } => REFUSED,
        Failure::NotStopped(_) | Failure::NotAtRest { .. } => NOT_STOPPED,
        Failure::NotInTime(_) => DEADLINE,
        Failure::NotSent(_) => NOT_MOVED,
        Failure::Departs(_) => DEPARTS,
        Failure::Local { .. } => LOCAL,
        Failure::Interrupted => INTERRUPTED,
        Failure::Printed(code) => *code,
    }
}

/// Returns the exit code of `jaka spec diff --exit-code` for this highest impact.
pub(crate) fn difference(impact: Impact) -> u8 {
    match impact {
        Impact::Patch => 10,
        Impact::Minor => 11,
        Impact::Major => 12,
    }
}

/// Returns the exit code for an error of the robot, by the possible reactions of a script.
fn exit_code(error: &Error) -> u8 {
    if let ErrorKind::NotReached { end } = error.kind() {
        end.cause().exit_code()
    } else if error.may_have_run() {
        MAY_HAVE_RUN
    } else if error.is_refused() {
        REFUSED
    } else if error.is_invalid_argument() || error.is_not_in_firmware() {
        USAGE
    } else if error.is_connect() {
        NO_CONNECTION
    } else {
        match error.kind() {
            ErrorKind::Connection(error) if matches!(error.kind(), jaka_sync::ErrorKind::StateTimeout { .. }) => {
                DEADLINE
            }
            ErrorKind::Stopped { accepted, .. } if accepted.is_empty() => INTERRUPTED,
            ErrorKind::Stopped { .. } => MAY_HAVE_RUN,
            ErrorKind::Connection(_) => LOST,
            ErrorKind::NotSent { .. } if error.is_disconnected() => LOST,
            // Nothing was sent, since `may_have_run` is false.
            _ => NOT_MOVED,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use jaka_robot::motion::JointMove;
    use jaka_robot::{Client, StatusStream};
    use jaka_sim::Fault;
    use jaka_tests::{Arm, ReservedPort};

    use super::*;

    const SHORT: Duration = Duration::from_millis(50);

    fn joint_move(speed: f64) -> JointMove {
        let joint_position = [0.0; 6];
        JointMove::absolute(joint_position, speed)
    }

    fn code<T: std::fmt::Debug>(result: Result<T, impl Into<Error>>) -> u8 {
        match result {
            Ok(done) => panic!("{done:?}"),
            Err(error) => exit_code(&error.into()),
        }
    }

    #[test]
    fn codes_tell_whether_the_command_may_have_run() {
        let arm = Arm::simulated().without_power().config(|config| config.reply_timeout(SHORT));
        let (controller, mut client) = arm.with_client();
        assert_eq!(code(client.joint_move(&joint_move(f64::NAN))), USAGE);
        let (option, of, value, expected) = ("step_count", "ServoConfig", "99".to_owned(), "1 to 12".to_owned());
        let invalid = ErrorKind::InvalidOption { option, of, value, expected };
        assert_eq!(code(Err::<(), _>(Error::from(invalid))), USAGE);
        assert_eq!(code(client.joint_move(&joint_move(20.0))), REFUSED, "without power");
        controller.inject(Fault::Drop);
        assert_eq!(code(client.get_version()), MAY_HAVE_RUN);
        controller.disconnect();
        // This request may or may not be sent; the next is not sent.
        client.get_version().unwrap_err();
        assert_eq!(code(client.get_version()), LOST);
    }

    #[test]
    fn codes_tell_what_the_network_does() {
        let nobody = ReservedPort::any();
        assert_eq!(code(Client::connect(nobody.address())), NO_CONNECTION);
        let controller = Arm::simulated().no_packets().start();
        let mut status = StatusStream::connect_with(&controller.config(), controller.status_addr()).unwrap();
        status.next_packet().unwrap();
        assert_eq!(code(status.next_packet()), LOST);
    }
}

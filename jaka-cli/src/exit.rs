//! Exit codes: what a script can do about a failure.

use jaka_sync::Error;

/// The controller refused the command, which did not run.
pub(crate) const REFUSED: u8 = 1;
/// The command line, the config file or an argument is wrong. clap's own code for its errors.
pub(crate) const USAGE: u8 = 2;
/// No connection could be made; nothing was sent.
pub(crate) const NO_CONNECTION: u8 = 3;
/// The command may have run.
pub(crate) const MAY_HAVE_RUN: u8 = 4;
/// The connection was lost or is unreadable, and nothing was left under way.
pub(crate) const LOST: u8 = 5;
/// Something on this machine.
pub(crate) const LOCAL: u8 = 6;

/// `jaka probe` found what is not as the spec has it.
pub(crate) const DEPARTS: u8 = 7;

/// The exit code that tells what a script can do about an error of the robot's.
pub(crate) fn exit_code(error: &Error) -> u8 {
    if error.may_have_run() {
        MAY_HAVE_RUN
    } else if error.is_refused() {
        REFUSED
    } else if error.is_invalid_argument() || error.is_not_in_firmware() {
        USAGE
    } else if error.is_connect() {
        NO_CONNECTION
    } else {
        LOST
    }
}

#[cfg(test)]
mod tests {
    use std::io::ErrorKind;
    use std::sync::Arc;
    use std::time::Duration;

    use jaka_sync::{Disconnect, ErrorCode, Refusal};

    use super::*;

    #[test]
    fn whether_the_command_may_have_run_comes_first() {
        let lost = |sent| Error::Disconnected {
            command: Some("joint_move".to_owned()),
            sent,
            cause: Arc::new(Disconnect::Closed { partial: 0 }),
        };
        let command = String::new();
        assert_eq!(exit_code(&lost(true)), MAY_HAVE_RUN);
        assert_eq!(exit_code(&lost(false)), LOST);
        assert_eq!(exit_code(&Error::Timeout { command, after: Duration::ZERO }), MAY_HAVE_RUN);
        assert_eq!(exit_code(&Error::StatusTimeout { after: Duration::ZERO }), LOST);
        assert_eq!(exit_code(&Error::Refused(Refusal::new("moveL", ErrorCode::CALL_FAILED, ""))), REFUSED);
        let source = ErrorKind::ConnectionRefused.into();
        assert_eq!(exit_code(&Error::Connect { address: String::new(), source }), NO_CONNECTION);
    }
}

//! The one seat of the command port: a client that takes it may displace a program that moves the arm.
//!
//! One rule holds for all commands. A command that changes a robot asks first, and the question names the consequence
//! for the seat ([`crate::arm::consent`]). `check`, `probe` and `jitter`, which only read, ask by [`obtain`]. Without a
//! terminal, both need `--yes`. Urgent requests are sent at once: stops, and requests of `jaka call` that only read or
//! concern the connection alone, with a warning by [`warn`].

use std::io::{IsTerminal, stderr, stdin};

use crate::failure::Failure;
use crate::target::RobotArgs;
use crate::terminal::{output, question};

/// Notice that another client of the command port may be disconnected.
pub(crate) const ONE_CLIENT: &str =
    "The command port serves one client: another program that is connected there may be disconnected.";

/// Warns a person before this program becomes the one client of the command port. For scripts, the manual has the
/// warning.
pub(crate) fn warn(robot: &RobotArgs) {
    if !robot.is_simulated() && stderr().is_terminal() {
        output::warning(
            "the command port serves one client: another program that is connected there may be disconnected",
        );
    }
}

/// Asks whether this program may become the one client of the command port. The error begins with `not_done`, the
/// action that was not done.
pub(crate) fn obtain(title: &str, not_done: &str) -> Result<(), Failure> {
    let refused = |why: &str| Failure::Usage(format!("{not_done}: {why}"));
    if !stdin().is_terminal() {
        return Err(refused(
            "another program that is connected to the command port may be disconnected, and there is no terminal to ask on; \
             use --yes to connect anyway",
        ));
    }
    let question = format!(
        "The command port of {title} serves one client. Another program that is connected there may be disconnected, and the \
         arm may stop or keep moving, depending on the setting of the controller (4.75).\nConnect? [y/N] "
    );
    if question::is_confirmed(&question)? { Ok(()) } else { Err(refused("the answer was not yes")) }
}

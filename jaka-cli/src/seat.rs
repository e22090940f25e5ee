//! The one seat of the command port.

use std::io::{IsTerminal, stdin};

use crate::failure::Failure;
use crate::question;

/// Makes sure that the user wants this program to be the one client of the command port. The error begins with what was not done.
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
         arm may stop or go on as the controller is set (4.75).\nConnect? [y/N] "
    );
    if question::is_confirmed(&question)? { Ok(()) } else { Err(refused("the answer was not yes")) }
}

//! Faults available in a script, for help and errors.

use std::fmt::Display;

use itertools::Itertools as _;
use jaka_sim::{Fault, Happening, LinkFault, StatusFault};

/// Returns an example of each kind, grouped by purpose.
pub(super) fn text() -> String {
    format!(
        "Faults, an example of each:\n  of replies:  {}\n  `status …`:  {}\n\n\
         A reply takes the next one of the list. `for joint_move: drop` is for the replies to a command, `always drop` for all, and \
         `random 7 1/20 drop, reset` for one in twenty, with a seed. The README of jaka-sim explains them.\n\n\
         Events for `--schedule` and `--stdin`, with inputs counted from 0:\n  {}\n\n\
         `link` has a port (`command`, `status` or `both`), a direction (`to-client`, `to-controller` or `both`), and a fault: {}",
        list(&Fault::one_of_each()),
        list(&StatusFault::one_of_each()),
        list(&Happening::one_of_each()),
        list(&LinkFault::one_of_each()),
    )
}

/// Returns the words of all faults of replies.
pub(super) fn words() -> String {
    let first = |fault: &Fault| fault.to_string().split(' ').next().map(str::to_owned);
    Fault::one_of_each().iter().filter_map(first).join(", ")
}

fn list(faults: &[impl Display]) -> String {
    faults.iter().join(", ")
}

//! Possible values of a setting that the controller holds, as far as the client can know.

use super::account::Fate;

/// Possible values of a setting of the controller. Each set value is new, so a read value identifies the command that
/// set it.
#[derive(Debug)]
pub(super) struct Held {
    possible: Vec<f64>,
    /// Nothing has been read yet, so the setting can still have its initial value.
    is_unknown: bool,
    set_here: bool,
}

impl Held {
    pub(super) fn unknown() -> Self {
        Self { possible: Vec::new(), is_unknown: true, set_here: false }
    }

    /// Starts a new connection. Settings of the old one without an answer may never have arrived.
    pub(super) fn new_connection(&mut self) {
        self.set_here = false;
    }

    pub(super) fn set(&mut self, value: f64, fate: Fate) {
        if fate != Fate::NotSent {
            self.possible.push(value);
            self.set_here = true;
        }
        if fate == Fate::Seen {
            self.answered();
        }
    }

    /// A command of this connection was answered: all that was sent before it has arrived.
    pub(super) fn answered(&mut self) {
        if self.set_here {
            self.possible.drain(..self.possible.len() - 1);
            self.is_unknown = false;
        }
    }

    /// Checks that a value in a reply to a query of this connection is possible.
    pub(super) fn read(&mut self, value: f64) -> Result<(), String> {
        self.answered();
        let is_possible = self.is_unknown || self.possible.iter().any(|possible| possible.to_bits() == value.to_bits());
        self.is_unknown = false;
        let result = if is_possible { Ok(()) } else { Err(format!("{value} was read instead of {:?}", self.possible)) };
        self.possible = vec![value];
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reply_to_another_query_is_found() {
        let mut held = Held::unknown();
        held.set(1.0, Fate::Seen);
        held.set(2.0, Fate::Sent);
        assert_eq!(held.read(2.0), Ok(()));
        held.set(3.0, Fate::Sent);
        assert!(held.read(2.0).is_err(), "it is the one before");
    }

    #[test]
    fn what_was_not_answered_may_not_have_arrived() {
        for value in [1.0, 2.0] {
            let mut held = Held::unknown();
            held.set(1.0, Fate::Seen);
            held.set(2.0, Fate::Sent);
            held.set(3.0, Fate::NotSent);
            held.new_connection();
            held.answered();
            assert_eq!(held.read(value), Ok(()));
            assert!(held.read(3.0 - value).is_err(), "it has been read as {value}");
        }
    }
}

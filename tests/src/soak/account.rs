//! Commands that a connection sent, compared with the commands that the simulator saw.

use std::collections::VecDeque;

use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Error, ErrorKind};

/// Fate of a command, as the result of its call tells it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fate {
    /// The controller has answered it, or a later one.
    Seen,
    /// It went out; the client cannot know if it has arrived.
    Sent,
    /// It went out, or did not.
    Perhaps,
    /// It did not go out.
    NotSent,
}

impl Fate {
    pub(super) fn of<T>(result: &Result<T, Error>) -> Self {
        let Err(error) = result else { return Self::Seen };
        match error.kind() {
            ErrorKind::Refused { .. } => Self::Seen,
            ErrorKind::Connection(error)
                if matches!(error.kind(), Failure::UnexpectedReply { .. } | Failure::ReplyLost { .. }) =>
            {
                Self::Seen
            }
            _ if error.may_have_run() => Self::Sent,
            _ => Self::NotSent,
        }
    }
}

/// Commands of one connection, in the order of sending.
#[derive(Debug, Default)]
pub(super) struct Connection {
    /// The text of its first command, which no other connection sends.
    pub(super) first: String,
    commands: Vec<Sent>,
    pub(super) stops: Stops,
    /// Commands in the recording of the connection, if it was recorded.
    pub(super) recorded: Option<Vec<String>>,
}

#[derive(Debug)]
struct Sent {
    text: String,
    fate: Fate,
    /// Maximum number of times that it may have been sent in a row.
    most: usize,
}

/// Stops of other threads. They carry no number, so they are counted.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Stops {
    pub(super) sent: usize,
    pub(super) seen: usize,
}

impl Connection {
    pub(super) fn new(first: String) -> Self {
        Self { first, ..Self::default() }
    }

    pub(super) fn note(&mut self, text: String, fate: Fate) {
        self.note_repeated(text, fate, 1);
    }

    /// A command that is sent at least once and at most so often in a row; where it is sent [perhaps](Fate::Perhaps),
    /// also not at all.
    pub(super) fn note_repeated(&mut self, text: String, fate: Fate, most: usize) {
        if fate != Fate::NotSent {
            self.commands.push(Sent { text, fate, most });
        }
    }

    /// Compares with what the simulator saw of this connection, stops included.
    fn check(&self, seen: &[String], stop: &str) -> Result<(), String> {
        let (stops, commands): (Vec<&String>, Vec<&String>) = seen.iter().partition(|text| *text == stop);
        self.check_commands(commands.into())?;
        if stops.len() < self.stops.seen || stops.len() > self.stops.sent {
            return Err(format!("{} stops came of {:?}", stops.len(), self.stops));
        }
        match &self.recorded {
            Some(recorded) if !recorded.starts_with(seen) => {
                let place = recorded.iter().zip(seen).position(|(recorded, seen)| recorded != seen);
                Err(format!("the recording differs at {place:?} from the {} requests that came", seen.len()))
            }
            _ => Ok(()),
        }
    }

    /// Checks that the received commands are the sent ones, in order, up to some command after the last answered one.
    fn check_commands(&self, mut seen: VecDeque<&String>) -> Result<(), String> {
        let answered = self.commands.iter().rposition(|sent| sent.fate == Fate::Seen);
        for (at, sent) in self.commands.iter().enumerate() {
            let came = (0..sent.most).take_while(|_| seen.pop_front_if_eq(&sent.text)).count();
            if came == 0 && sent.fate != Fate::Perhaps {
                if answered.is_some_and(|last| at <= last) {
                    return Err(format!("{} did not come, but {:?}", sent.text, seen.front()));
                }
                break;
            }
        }
        seen.front().map_or(Ok(()), |more| Err(format!("{more} came, and was not sent then")))
    }
}

/// Takes off the first element where it is this one.
trait PopFrontIfEq {
    fn pop_front_if_eq(&mut self, text: &str) -> bool;
}

impl PopFrontIfEq for VecDeque<&String> {
    fn pop_front_if_eq(&mut self, text: &str) -> bool {
        let is_equal = self.front().is_some_and(|front| *front == text);
        if is_equal {
            self.pop_front();
        }
        is_equal
    }
}

/// Compares all connections of an arm with the requests that its simulator saw, and returns the differences.
pub(super) fn check(connections: &[Connection], seen: &[String], stop: &str) -> Vec<String> {
    let is_first = |text: &String| connections.iter().any(|connection| connection.first == *text);
    let places: Vec<usize> = (0..seen.len()).filter(|at| is_first(&seen[*at])).collect();
    let ends = places.iter().skip(1).copied().chain([seen.len()]);
    let mut parts: VecDeque<&[String]> = places.iter().zip(ends).map(|(from, to)| &seen[*from..to]).collect();
    let mut findings = Vec::new();
    if places.first().copied().unwrap_or(seen.len()) > 0 {
        findings.push(format!("{} came before the first connection's first command", seen[0]));
    }
    for (number, connection) in connections.iter().enumerate() {
        let is_mine = parts.front().is_some_and(|part| part[0] == connection.first);
        let part = if is_mine { parts.pop_front().unwrap_or_default() } else { &[] };
        if let Err(finding) = connection.check(part, stop) {
            findings.push(format!("connection {number}: {finding}"));
        }
    }
    findings.extend(parts.iter().map(|part| format!("{} came once more, or out of order", part[0])));
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    const STOP: &str = "stop";

    /// Two connections: of the second, the last two commands are not known to have arrived.
    fn connections() -> Vec<Connection> {
        let sent = |texts: &[(&str, Fate)]| {
            let mut connection = Connection::new(texts[0].0.to_owned());
            for (text, fate) in texts {
                connection.note((*text).to_owned(), *fate);
            }
            connection
        };
        let mut second = sent(&[("b", Fate::Seen), ("b1", Fate::Perhaps), ("b2", Fate::Sent), ("b3", Fate::Sent)]);
        second.note_repeated("b4".to_owned(), Fate::Sent, 2);
        second.stops = Stops { sent: 2, seen: 1 };
        vec![sent(&[("a", Fate::Sent), ("x", Fate::NotSent), ("a1", Fate::Seen)]), second]
    }

    fn findings(seen: &str) -> usize {
        let seen: Vec<_> = seen.split(' ').map(str::to_owned).collect();
        check(&connections(), &seen, STOP).len()
    }

    #[test]
    fn what_may_have_come_may_be_missing_from_the_end_on() {
        for seen in
            ["a a1 b stop", "a a1 stop b", "a a1 b stop b2", "a a1 b b1 stop b2 stop b3", "a a1 b stop b2 b3 b4 b4"]
        {
            let is_first_with_stop = seen.starts_with("a a1 stop");
            assert_eq!(findings(seen) == 0, !is_first_with_stop, "{seen}");
        }
    }

    #[test]
    fn what_is_missing_doubled_swapped_or_was_not_sent_is_found() {
        for seen in [
            "a b stop",
            "a a1 a1 b stop",
            "a1 a b stop",
            "a x a1 b stop",
            "a a1 b stop b3 b2",
            "a a1 b stop b3",
            "a a1 b b b1 stop",
            "a a1 b stop b2 b2",
            "a a1 b",
            "a a1 b stop stop stop",
            "b stop a a1",
            "a a1 b stop b2 b3 b4 b5",
            "a a1 b stop b2 b3 b4 b4 b4",
        ] {
            assert!(findings(seen) > 0, "{seen}");
        }
    }

    #[test]
    fn recordings_have_the_order_of_the_wire() {
        let mut connection = Connection::new("a".to_owned());
        connection.note("a".to_owned(), Fate::Seen);
        connection.note("b".to_owned(), Fate::Seen);
        connection.stops = Stops { sent: 1, seen: 1 };
        connection.recorded = Some(["a", "stop", "b"].map(str::to_owned).to_vec());
        let found = |seen: [&str; 3]| check(std::slice::from_ref(&connection), &seen.map(str::to_owned), STOP).len();
        assert_eq!((found(["a", "stop", "b"]), found(["a", "b", "stop"])), (0, 1));
    }
}

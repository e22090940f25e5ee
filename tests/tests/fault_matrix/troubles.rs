//! Faults, which are the rows of the matrix.

use std::time::Duration;

use jaka_proto::messages::motion::Jog;
use jaka_proto::wire::Writer;
use jaka_proto::{Command, ErrorCode, write_refusal};
use jaka_sim::{Fault, StatusFault};
use proptest::prelude::RngCore;
use proptest::test_runner::TestRng;

use crate::link::LinkTrouble;

jaka_proto::worded! {
    /// Something that goes wrong on one of the ports.
    #[derive(Debug, Clone)]
    pub(crate) enum Trouble {
        Reply(fault: Fault) => "{fault}",
        /// The controller refuses the command.
        Refusal => "a refusal",
        /// The reply says that the command was accepted, and has none of its fields.
        Misfit => "a reply without its fields",
        Status(fault: StatusFault) => "status {fault}",
        /// Bytes on the links are held, late, slow or lost.
        Link(link: LinkTrouble) => "{link}",
    }
}

/// Later than any call waits that is to see a timeout.
pub(crate) const LATE: Duration = Duration::from_millis(1500);

/// One fault of each kind that the simulator has, and more of those that can come in several ways.
pub(crate) fn all() -> Vec<Trouble> {
    let replies = Fault::one_of_each().into_iter().chain(more_replies()).map(Trouble::Reply);
    let status = StatusFault::one_of_each().into_iter().chain(more_status()).map(Trouble::Status);
    let links = LinkTrouble::all().into_iter().map(Trouble::Link);
    replies.chain([Trouble::Refusal, Trouble::Misfit]).chain(status).chain(links).collect()
}

fn more_replies() -> Vec<Fault> {
    let stranger = envelope(Some(Jog::INFO.name), ErrorCode(0));
    vec![
        Fault::Delay(LATE),
        Fault::Oversized(10_000),
        Fault::CloseAfter(10_000),
        Fault::Before(b" \r\n".to_vec()),
        Fault::Before(stranger.clone()),
        Fault::After(stranger),
        Fault::Instead(b"{errorCode: 0}".to_vec()),
        Fault::Instead(b"{\"\xff\": 0}".to_vec()),
    ]
}

fn more_status() -> [StatusFault; 2] {
    [StatusFault::Slow(Duration::from_secs(20)), StatusFault::Instead(b"joint_actual_position:(0, 0)\n".to_vec())]
}

fn envelope(command: Option<&str>, code: ErrorCode) -> Vec<u8> {
    let mut out = Writer::new();
    write_refusal(command, code, "", &mut out);
    out.into_string().into_bytes()
}

impl Trouble {
    /// Fault of the reply to this command, if it has one.
    pub(crate) fn fault(&self, command: &str) -> Option<Fault> {
        let instead = |code| Fault::Instead(envelope(Some(command), code));
        match self {
            Self::Reply(fault) => Some(fault.clone()),
            Self::Refusal => Some(instead(ErrorCode(2))),
            Self::Misfit => Some(instead(ErrorCode(0))),
            Self::Status(_) | Self::Link(_) => None,
        }
    }

    /// True if replies themselves go wrong.
    pub(crate) fn is_of_replies(&self) -> bool {
        matches!(self, Self::Reply(_) | Self::Refusal | Self::Misfit)
    }

    /// Fault of status packets.
    pub(crate) fn status(&self) -> StatusFault {
        if let Self::Status(fault) = self { fault.clone() } else { StatusFault::None }
    }

    /// Returns the fault with random parameters where they do not change the expected outcome.
    pub(crate) fn at_random(&self, random: &mut TestRng) -> Self {
        let mut below = |limit: usize| below(random, limit);
        match self {
            Self::Reply(Fault::Pieces(_)) => {
                let sizes = (0..below(8)).map(|_| 1 + below(30)).collect();
                Self::Reply(Fault::Pieces(sizes))
            }
            Self::Reply(Fault::CloseAfter(10)) => Self::Reply(Fault::CloseAfter(below(40))),
            Self::Reply(Fault::Delay(time)) if *time < LATE => {
                Self::Reply(Fault::Delay(Duration::from_millis(below(50) as u64)))
            }
            Self::Status(StatusFault::Pieces(_)) => Self::Status(StatusFault::Pieces(1 + below(2000))),
            Self::Status(StatusFault::CloseAfter(_)) => Self::Status(StatusFault::CloseAfter(below(2000))),
            Self::Link(link) => Self::Link(link.at_random(below)),
            other => other.clone(),
        }
    }
}

/// A pause between two calls, so that they meet what is on the wire at different moments; mostly none.
pub(crate) fn pause(random: &mut TestRng) -> Duration {
    let micros = [0, 0, 50, 500, 5000][below(random, 5)];
    Duration::from_micros(micros)
}

fn below(random: &mut TestRng, limit: usize) -> usize {
    usize::try_from(random.next_u64() % limit as u64).expect("it is below a usize")
}

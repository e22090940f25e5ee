//! Faults of the links.

use std::fmt;
use std::time::Duration;

use jaka_sim::{Controller, Direction, Happening, LinkFault, Port};

/// A link on which nothing passes, or not as it should.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LinkTrouble {
    /// Both if none is given.
    pub(crate) port: Option<Port>,
    /// Both if none is given.
    pub(crate) direction: Option<Direction>,
    pub(crate) fault: LinkFault,
    /// Duration of a fault that ends while the call waits; none for a fault that stays.
    pub(crate) lasting: Option<Duration>,
}

/// Delay, and rate in bytes a second, with which bytes pass after all calls have given up, or when the link is
/// released.
const LATE: Duration = Duration::from_secs(10);
const SLOW: u64 = 10;

/// Delay, and rate in bytes a second, with which bytes pass in time.
const DELAY: Duration = Duration::from_millis(20);
const QUICK: u64 = 1_000_000;

/// Duration of a hold that ends while the call waits.
const HELD: Duration = Duration::from_millis(30);

impl LinkTrouble {
    /// Each kind of fault, on the links of each port and direction, and on all of them.
    pub(crate) fn all() -> Vec<Self> {
        let directions = [Some(Direction::ToController), Some(Direction::ToClient), None];
        let of_port = |port| directions.map(|direction| (Some(port), direction));
        let places = Port::ALL.into_iter().flat_map(of_port).chain([(None, None)]);
        let at = |(port, direction)| {
            let faults = LinkFault::one_of_each().into_iter().flat_map(in_each_way);
            faults.map(move |(fault, lasting)| Self { port, direction, fault, lasting })
        };
        places.flat_map(at).collect()
    }

    /// From now on it is wrong; a link that is held for a time is released by the caller.
    pub(crate) fn strike(&self, controller: &Controller) {
        let link = self.port.map_or(controller.links(), |port| controller.link(port));
        self.direction.map_or(link, |direction| link.direction(direction)).set(self.fault);
    }

    /// True if the fault concerns what passes on this port in this direction.
    pub(crate) fn is_on(&self, port: Port, direction: Direction) -> bool {
        self.port.is_none_or(|own| own == port) && self.direction.is_none_or(|own| own == direction)
    }

    /// True if all passes in time.
    pub(crate) fn is_in_time(&self) -> bool {
        match self.fault {
            LinkFault::None => true,
            LinkFault::Hold => self.lasting.is_some(),
            LinkFault::Delay(time) => time < LATE,
            LinkFault::Slow(per_second) => per_second > SLOW,
            LinkFault::Cut => false,
            other => panic!("the model knows nothing of {other}"),
        }
    }

    /// Returns the fault with random times where the time does not change the expected outcome.
    pub(crate) fn at_random(self, mut below: impl FnMut(usize) -> usize) -> Self {
        let mut millis = |limit| Duration::from_millis(below(limit) as u64);
        match self {
            Self { lasting: Some(_), .. } => Self { lasting: Some(millis(60)), ..self },
            Self { fault: LinkFault::Delay(time), .. } if time < LATE => {
                Self { fault: LinkFault::Delay(millis(40)), ..self }
            }
            other => other,
        }
    }
}

/// A fault in the ways in which it can meet a call.
fn in_each_way(fault: LinkFault) -> Vec<(LinkFault, Option<Duration>)> {
    match fault {
        LinkFault::None => vec![],
        LinkFault::Hold => vec![(fault, None), (fault, Some(HELD))],
        LinkFault::Delay(_) => vec![(LinkFault::Delay(DELAY), None), (LinkFault::Delay(LATE), None)],
        LinkFault::Slow(_) => vec![(LinkFault::Slow(QUICK), None), (LinkFault::Slow(SLOW), None)],
        LinkFault::Cut => vec![(fault, None)],
        other => panic!("the matrix knows nothing of {other}"),
    }
}

impl fmt::Display for LinkTrouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { port, direction, fault, lasting } = *self;
        write!(f, "{}", Happening::Link { port, direction, fault })?;
        lasting.map_or(Ok(()), |time| write!(f, " for {time:?}"))
    }
}

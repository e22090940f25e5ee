//! Faults as the tokens of a script.

use std::fmt;

use super::tokens::{Name, Quoted};
use super::{Fault, FaultPlan, LinkEvent, LinkFault, StatusFault};

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Drop => f.write_str("drop"),
            Self::Delay(time) => write!(f, "delay {time:?}"),
            Self::Hold => f.write_str("hold"),
            Self::Pieces(sizes) => {
                f.write_str("split")?;
                sizes.iter().try_for_each(|size| write!(f, " {size}"))
            }
            Self::WithNext => f.write_str("with-next"),
            Self::Twice => f.write_str("twice"),
            Self::Nameless => f.write_str("nameless"),
            Self::Renamed(name) => write!(f, "renamed {}", Name(name)),
            Self::Before(bytes) => write!(f, "before {}", Quoted(bytes)),
            Self::After(bytes) => write!(f, "after {}", Quoted(bytes)),
            Self::Instead(bytes) => write!(f, "instead {}", Quoted(bytes)),
            Self::Garbage { bytes, seed } => write!(f, "garbage {bytes} {seed}"),
            Self::Oversized(size) => write!(f, "oversized {size}"),
            Self::HalfOpen => f.write_str("half-open"),
            Self::Close => f.write_str("close"),
            Self::CloseAfter(count) => write!(f, "close-after {count}"),
            Self::Reset => f.write_str("reset"),
            Self::Takeover => f.write_str("takeover"),
        }
    }
}

impl fmt::Display for StatusFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Silent => f.write_str("silent"),
            Self::Slow(period) => write!(f, "slow {period:?}"),
            Self::Pieces(size) => write!(f, "split {size}"),
            Self::Garbage { bytes, seed } => write!(f, "garbage {bytes} {seed}"),
            Self::Cut(count) => write!(f, "cut {count}"),
            Self::Instead(bytes) => write!(f, "instead {}", Quoted(bytes)),
            Self::CloseAfter(count) => write!(f, "close-after {count}"),
        }
    }
}

impl fmt::Display for LinkFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Hold => f.write_str("hold"),
            Self::Delay(time) => write!(f, "delay {time:?}"),
            Self::Slow(per_second) => write!(f, "slow {per_second}"),
            Self::Cut => f.write_str("cut"),
        }
    }
}

/// A line of a script.
impl fmt::Display for LinkEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "link {} {}", self.selector, self.fault)?;
        if !self.after.is_zero() {
            write!(f, " after {:?}", self.after)?;
        }
        self.lasting.map_or(Ok(()), |time| write!(f, " for {time:?}"))
    }
}

impl fmt::Display for FaultPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Vec::new();
        if !self.script.is_empty() {
            lines.push(list(&self.script));
        }
        for (command, fault) in &self.commands {
            lines.push(format!("for {}: {fault}", Name(command)));
        }
        for chance in &self.chances {
            let seed = self.seed.unwrap_or(0);
            lines.push(format!("random {seed} 1/{} {}", chance.one_in, list(&chance.faults)));
        }
        lines.extend(self.always.iter().map(|fault| format!("always {fault}")));
        if self.status != StatusFault::None {
            lines.push(format!("status {}", self.status));
        }
        lines.extend(self.links.iter().map(LinkEvent::to_string));
        f.write_str(&lines.join("\n"))
    }
}

fn list<'f>(faults: impl IntoIterator<Item = &'f Fault>) -> String {
    let texts: Vec<_> = faults.into_iter().map(Fault::to_string).collect();
    texts.join(", ")
}

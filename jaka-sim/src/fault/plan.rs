//! Plan of the faults of replies.

use std::collections::VecDeque;

use super::{Fault, SplitMix64, StatusFault};

/// Plan of the faults of replies, as a script or by chance.
///
/// [`Builder::faults`](crate::Builder::faults) gives a plan to a controller. Each reply takes the first available of
/// these: the next fault for its command, the next fault of the script, a fault by chance, the fault of all replies.
///
/// ```
/// use jaka_sim::{Controller, Fault, FaultPlan};
///
/// let script = FaultPlan::script([Fault::None, Fault::Drop]).then_for("joint_move", Fault::Nameless);
/// let chance = FaultPlan::random(7).one_in(20, [Fault::Drop, Fault::Reset]);
/// let controller = Controller::builder().faults(chance.clone()).start()?;
/// // A failing test prints the plan, and with it the seed that repeats it.
/// assert_eq!(chance.to_string(), "random 7 1/20 drop, reset");
/// assert_eq!(script.to_string(), "none, drop\nfor joint_move: nameless");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # As a text
///
/// `Display` writes a plan as a text, and `FromStr` reads it. Each [`Fault`] documents its text; commas or ends of
/// lines separate the faults. A semicolon ends a line, too. A line can begin with the target of its faults:
///
/// ```
/// # use jaka_sim::FaultPlan;
/// # let text = r##"
/// drop, delay 200ms                # the first two replies
/// split 1 5                        # the third
/// for joint_move: hold, nameless   # the first two replies to joint_move
/// random 7 1/20 drop, reset        # one in twenty of all others, with the seed 7
/// always twice                     # all others
/// status slow 2s                   # the status port
/// # "##;
/// # assert!(text.parse::<FaultPlan>().is_ok_and(|plan| plan.to_string().parse() == Ok(plan)));
/// ```
///
/// Bytes are in quotes, with the escapes of Rust: `instead "(0, [])\r\n\x00"`. All `random` lines share one seed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FaultPlan {
    pub(crate) script: VecDeque<Fault>,
    pub(crate) commands: Vec<(String, Fault)>,
    /// Faults of one in so many replies.
    pub(super) chances: Vec<(u64, Vec<Fault>)>,
    pub(super) always: Option<Fault>,
    pub(crate) status: StatusFault,
    pub(super) generator: Option<SplitMix64>,
}

impl FaultPlan {
    /// Creates a plan without faults.
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a plan with these faults for the first replies, in order.
    pub fn script(faults: impl IntoIterator<Item = Fault>) -> Self {
        Self { script: faults.into_iter().collect(), ..Self::default() }
    }

    /// Creates a plan by chance; [`one_in`](Self::one_in) adds its faults.
    ///
    /// The same seed gives the same faults to the same number of replies.
    pub fn random(seed: u64) -> Self {
        Self { generator: Some(SplitMix64::new(seed)), ..Self::default() }
    }

    /// Adds a fault to the script.
    #[must_use]
    pub fn then(mut self, fault: Fault) -> Self {
        self.script.push_back(fault);
        self
    }

    /// Adds a fault to the script of this command, such as `joint_move`.
    #[must_use]
    pub fn then_for(mut self, command: impl Into<String>, fault: Fault) -> Self {
        self.commands.push((command.into(), fault));
        self
    }

    /// Assigns one of these faults, each with equal probability, to one in this many replies on average.
    ///
    /// One in 1 is every reply, one in 0 none. The seed is that of [`random`](Self::random), or 0.
    #[must_use]
    pub fn one_in(mut self, replies: u64, faults: impl IntoIterator<Item = Fault>) -> Self {
        self.generator.get_or_insert_with(|| SplitMix64::new(0));
        self.chances.push((replies, faults.into_iter().collect()));
        self
    }

    /// Applies this fault to all replies without another fault.
    #[must_use]
    pub fn always(mut self, fault: Fault) -> Self {
        self.inject_always(fault);
        self
    }

    /// Sets the first fault of the status port.
    #[must_use]
    pub fn status(mut self, fault: StatusFault) -> Self {
        self.status = fault;
        self
    }

    pub(crate) fn inject_always(&mut self, fault: Fault) {
        self.always = Some(fault).filter(|fault| *fault != Fault::None);
    }

    /// Removes all faults of replies.
    pub(crate) fn clear(&mut self) {
        *self = Self { status: self.status.clone(), ..Self::new() };
    }

    /// Takes the fault of the next reply; `command` is the command of the reply, if it has one.
    pub(crate) fn next(&mut self, command: Option<&str>) -> Fault {
        let due = self.next_for(command).or_else(|| self.script.pop_front()).or_else(|| self.draw());
        due.or_else(|| self.always.clone()).unwrap_or(Fault::None)
    }

    fn next_for(&mut self, command: Option<&str>) -> Option<Fault> {
        let at = self.commands.iter().position(|(name, _)| command == Some(name))?;
        Some(self.commands.remove(at).1)
    }

    fn draw(&mut self) -> Option<Fault> {
        let generator = self.generator.as_mut()?;
        let (_, faults) = self.chances.iter().find(|(replies, _)| generator.one_in(*replies))?;
        generator.pick(faults).cloned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_fault_is_taken() {
        let mut plan = FaultPlan::script([Fault::Hold]).then_for("jog", Fault::Drop).always(Fault::Twice);
        let order = [None, Some("jog"), Some("jog"), None].map(|command| plan.next(command));
        assert_eq!(order, [Fault::Hold, Fault::Drop, Fault::Twice, Fault::Twice]);
        plan.inject_always(Fault::None);
        assert_eq!(plan, FaultPlan::new());
    }

    #[test]
    fn chance_follows_from_the_seed() {
        let plan = |seed| FaultPlan::random(seed).one_in(3, [Fault::Drop, Fault::Close]).one_in(4, [Fault::Twice]);
        let draws = |mut plan: FaultPlan| (0..200).map(|_| plan.next(None)).collect::<Vec<_>>();
        assert_eq!(draws(plan(7)), draws(plan(7)));
        assert_ne!(draws(plan(7)), draws(plan(8)));
        for fault in [Fault::None, Fault::Drop, Fault::Close, Fault::Twice] {
            assert!(draws(plan(7)).contains(&fault));
        }
        assert!(format!("{:?}", plan(7)).contains("seed: 7"));
        assert_eq!(draws(FaultPlan::new().one_in(0, [Fault::Drop]).one_in(1, [])), vec![Fault::None; 200]);
    }
}

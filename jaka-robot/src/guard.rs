//! Guards: conditions that end a motion before its end.

mod armed;
mod condition;
mod force;
mod set_points;
mod watch;

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use jaka_proto::messages::status::RobotStatus;

pub(crate) use self::armed::Armed;
pub(crate) use self::condition::Condition;
pub use self::condition::TcpBox;
pub use self::force::{ForceComponent, ForceLimit};
pub(crate) use self::force::{longest_silence, packet_period};
pub(crate) use self::set_points::{MeasuredLag, SetPointGuard};
pub(crate) use self::watch::{Watched, watch};
use crate::Error;
#[cfg(doc)]
use crate::GuardTrip;
use crate::inputs::{AnalogCondition, InputCondition};

/// Conditions that end a motion before its end. Each is judged once for each status packet, and the first that holds
/// trips the guard.
///
/// An [`InputCondition`], an [`AnalogCondition`], a [`ForceLimit`] or a [`TcpBox`] is a guard by itself;
/// [`when`](Self::when) makes one of any question about a packet, and [`or`](Self::or) joins two.
/// [`MotionExt::guard`](crate::MotionExt::guard) puts a motion under a guard.
///
/// ```
/// use jaka_robot::{Guard, Numbering, TcpBox};
///
/// const IO: Numbering = Numbering::FromOne;
/// let guard = Guard::from(IO.tool(1).rises())
///     .or(TcpBox::from_corners([-500.0, -500.0, 50.0], [500.0, 500.0, 900.0]).is_left())
///     .or(Guard::when("the tool is faster than 200 mm/s", |status| {
///         status.tcp_speed.is_some_and(|speed| speed > 200.0)
///     }));
/// assert_eq!(guard.to_string().split(" or ").count(), 3);
/// ```
///
/// # Reach and limits
/// **A guard is not a safety function**, and no fence. It reacts to status packets, which come each 30 ms (firmware
/// 1.5.14) to 100 ms and do not show their age. From an event until the arm rests it takes
/// - up to a period of the packets, until one shows it, and however long the network holds that packet;
/// - the reaction: from the packet's arrival until the stop is written, usually well below 1 ms
///   ([`GuardTrip::reaction`] has it), then the network, and the controller until it acts on `stop_program`;
/// - the braking, which no source describes.
///
/// A state that packets show for less than a period can be missed. A packet that does not show a fact that the guard
/// needs trips it, too, and so does a question that panics: unknown is not good. If packets stay away for
/// [`Config::stale_after`](crate::Config::stale_after), the arm is stopped.
///
/// According to one client's remark, which is not in the document, newer firmware has a condition of its own that ends
/// a `movc` at a digital input. Such a condition reacts without packets and network. It is not in this SDK, because no
/// source shows its use.
#[derive(Debug, Clone)]
#[must_use = "a guard does nothing until a motion runs under it"]
pub struct Guard {
    pub(crate) conditions: Vec<Condition>,
}

impl Guard {
    /// A guard by any question about a packet. `text` says when it holds, for reports and errors.
    ///
    /// It runs on the monitor's thread, and packets wait meanwhile: it should be short. It decides on an absent key
    /// itself.
    pub fn when(text: impl Into<String>, holds: impl Fn(&RobotStatus) -> bool + Send + Sync + 'static) -> Self {
        Self::of(Condition::Question(Question { text: text.into(), holds: Arc::new(holds) }))
    }

    /// The guard that trips when either of both does.
    pub fn or(mut self, other: impl Into<Self>) -> Self {
        self.conditions.extend(other.into().conditions);
        self
    }

    fn of(condition: Condition) -> Self {
        Self { conditions: vec![condition] }
    }

    /// The limits of force in it.
    pub(crate) fn force_limits(&self) -> impl Iterator<Item = &ForceLimit> {
        self.force_limit_of_each().flatten()
    }

    /// Limit of force of each condition; none for one of another kind.
    fn force_limit_of_each(&self) -> impl Iterator<Item = Option<&ForceLimit>> {
        self.conditions.iter().map(|condition| match condition {
            Condition::Force(limit) => Some(limit),
            Condition::Input(_) | Condition::Inside(_) | Condition::Outside(_) | Condition::Question(_) => None,
        })
    }

    /// True if a condition is about the tool centre point, or may be.
    pub(crate) fn depends_on_frames(&self) -> bool {
        self.conditions.iter().any(|condition| match condition {
            Condition::Input(_) => false,
            // A question may ask for a pose.
            Condition::Force(_) | Condition::Inside(_) | Condition::Outside(_) | Condition::Question(_) => true,
        })
    }

    /// Fails if a condition has a value that it cannot have.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.conditions.iter().try_for_each(Condition::check)
    }
}

impl From<InputCondition> for Guard {
    fn from(condition: InputCondition) -> Self {
        Self::of(Condition::Input(condition.0))
    }
}

impl From<AnalogCondition> for Guard {
    fn from(condition: AnalogCondition) -> Self {
        Self::of(Condition::Input(condition.0))
    }
}

impl From<ForceLimit> for Guard {
    fn from(limit: ForceLimit) -> Self {
        Self::of(Condition::Force(limit))
    }
}

/// Conditions in words, joined by "or".
impl fmt::Display for Guard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, condition) in self.conditions.iter().enumerate() {
            let joint = if index == 0 { "" } else { " or " };
            write!(f, "{joint}{condition}")?;
        }
        Ok(())
    }
}

/// A question of the user's own.
#[derive(Clone)]
pub(crate) struct Question {
    text: String,
    holds: Arc<dyn Fn(&RobotStatus) -> bool + Send + Sync>,
}

impl Question {
    /// The answer; none if the question panics.
    fn holds(&self, status: &RobotStatus) -> Option<bool> {
        // State that a panic leaves half done is the question's own.
        catch_unwind(AssertUnwindSafe(|| (self.holds)(status))).ok()
    }
}

impl fmt::Debug for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Question").field(&self.text).finish()
    }
}

//! Set-points, one a period, towards a goal that may change at any time.

mod constraints;
mod dynamics;
mod plan;

use jaka_proto::messages::types::JointPosition;

use self::constraints::{Constraints, is_at_rest, positions};
pub use self::dynamics::Dynamics;
use self::plan::Plan;
use crate::beyond::{Beyond, Exceeded};
use crate::braking::{JointLimits, JointState, Stop, StopBound, longest_stop};
use crate::checker::Checker;
use crate::follower::PERIODS;
use crate::limits::{InvalidLimit, in_range};
use crate::speed::TcpVelocity;

/// Makes one set-point a period, towards a goal that may change with each of them.
///
/// ```
/// use jaka_motion::{Checker, Dynamics, Frames, Generator, Goal, Limits, Model};
///
/// let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
/// let dynamics = Dynamics::of(&limits);
/// let start = [10.0, 60.0, -80.0, 190.0, -90.0, 5.0];
/// let mut generator = Generator::new(&Checker::new(limits, Frames::new()), dynamics, start.into(), 0.008)?;
///
/// let goal = Goal::Joints([15.0, 60.0, -80.0, 190.0, -90.0, 5.0].into());
/// generator.check_goal(&goal)?;
/// for _ in 0..50 {
///     let _to_be_sent = generator.next(&goal).joints;
/// }
/// let landing = generator.landing();
/// while !generator.is_at_rest() {
///     generator.next(&Goal::Rest);
/// }
/// assert!(generator.joints().max_distance(&landing.joints) < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # What is promised
/// Whatever the goals are, and however often they change:
/// - The first differences of the set-points, divided by the period, are within the speeds of the [`Dynamics`]; the
///   second ones, divided by its square, within the accelerations; the third ones, divided by its cube, within the
///   jerks. Rounding may add a billionth of the limit, and the effect of some 1e-13 degrees on a difference. After
///   [`paused`](Self::paused) the differences start again, as if the arm had been at the last set-point for long.
/// - Stops are an exception: a joint that slows down may do so with the acceleration and the jerk of stops
///   ([`Limits::stop_accelerations`](crate::Limits::stop_accelerations)), if these are higher. This applies to
///   [`Goal::Rest`], and in front of a limit that the goal exceeds.
/// - From each set-point a stop can bring the arm to rest within joint ranges, regions, and the speed of the tool
///   centre point. It follows the velocity of the joints, apart from their present accelerations.
///   [`landing`](Self::landing) returns its position and time.
///
/// # Method
/// The set-points are samples of a motion whose jerk is within its limit at each moment, so their third differences are
/// means of it; likewise accelerations and speeds. rsruckig proposes the jerks. The generator clamps them to their
/// limits and integrates them from the state of the last set-point. It takes the new state only if speeds and
/// accelerations have stayed within their limits, and if the path to rest from there stays within all limits.
///
/// If only the tool centre point would be too fast, it tries in the same way states between the proposed state and the
/// state at constant speed. For any other limit it tries to slow down within the accelerations of the [`Dynamics`]. If
/// that fails, the set-point is the next one on the path to rest that was compared with the limits when the last state
/// was taken. The arm starts at rest, within the limits, so each state has a path to rest.
///
/// A joint may brake so hard that the dynamics do not let the deceleration end before the joint turns round. Then the
/// arm goes to rest.
///
/// # Limitations
/// - The path to a goal in joints is not straight for the tool, and not planned around regions: the arm stops in front
///   of a region.
/// - A goal that is a velocity of the tool has no path: deviations are not corrected. The arm slows to a stop in front
///   of a limit, a region or a singularity, all axes together, so it keeps its direction, apart from what the joints
///   still have of an earlier motion. It does not pass a singularity. Only a goal in joints moves the arm away from a
///   singularity whose distance is nearly zero.
/// - Distances from singularities count for velocities of the tool only.
/// - Between two computed places on its path, a point may be beyond a region by 0.1 mm, and by 0.6 mm at an edge of a
///   box to be kept outside of: within [`Checker::AMOUNT_MM`]. It does not come to rest there, unless the session
///   paused there; it then continues as a motion that starts beyond a limit.
///
/// Only `new` allocates, and rsruckig if it finds no path: it then makes an error text, which is dropped. No input
/// makes the generator panic.
#[derive(Debug, Clone)]
pub struct Generator {
    constraints: Constraints,
    led: Led,
    /// State at the previous set-point.
    before: Led,
    goal: Goal,
    plan: Plan,
    rejections: u64,
}

/// State of the joints at a set-point, and the path to rest from there, which is within all limits.
#[derive(Debug, Clone, Copy)]
struct Led {
    state: [JointState; 6],
    stops: [Stop; 6],
    bound: StopBound,
    /// Whether the state is on the path to rest.
    stops_already: bool,
}

/// Target of a [`Generator`]: joint positions, a velocity or standstill.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Joint positions, which all joints reach at the same time. From rest the path is straight in joint space; it is
    /// not straight for the tool.
    Joints(JointPosition),
    /// Speed of each joint in deg/s, which each joint reaches as soon as it can. A joint stops at the end of its range
    /// while the others continue.
    Velocity([f64; 6]),
    /// Velocity of the tool.
    TcpVelocity(TcpVelocity),
    /// Standstill by a stop. For a standstill within the [`Dynamics`], use a velocity of zero.
    Rest,
}

/// Set-point, and the bound that kept it from being nearer to the goal.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// Joint positions of the set-point.
    pub joints: JointPosition,
    /// Bound that slowed or held the motion, other than the speeds, accelerations and jerks of the joints.
    pub bound: Option<Bound>,
}

/// Bound that slows or holds a motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Bound {
    /// Nearby limit.
    Limit(Beyond),
    /// The generator's own check refused the states computed for the goal. [`Generator::rejections`] counts these
    /// refusals.
    Rejected,
}

/// Position and time of rest of an arm that stops now.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Landing {
    /// Joint positions at rest.
    pub joints: JointPosition,
    /// Time until the arm rests, in seconds; 0 for an arm at rest.
    pub time_s: f64,
    /// Bound of the deceleration.
    pub bound: StopBound,
}

jaka_proto::worded! {
    /// Error for a [`Generator`] or its [`Dynamics`] that cannot be made.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum GeneratorError {
        /// A speed, acceleration or jerk is too small or too large for a computation.
        OutOfRange {
            /// Name of the joint's quantity, for example `speed`.
            what: &'static str,
            /// Unit of the quantity.
            unit: &'static str,
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Number that was given.
            given: f64,
            /// Least permitted value.
            least: f64,
            /// Largest permitted value.
            most: f64,
        } => "{what} of joint {joint}: {given} {unit} is not from {least} to {most:e} {unit}",
        /// A speed or an acceleration is higher than the arm's limits allow.
        BeyondLimit {
            /// Name of the joint's quantity, for example `speed`.
            what: &'static str,
            /// Unit of the quantity.
            unit: &'static str,
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Number that was given.
            given: f64,
            /// Highest value that the limits allow.
            limit: f64,
        } => "{what} of joint {joint}: {given} {unit} is beyond the arm's limit of {limit} {unit}",
        /// The period is not from 1 ms to 1 s.
        Period {
            /// Number that was given, in seconds.
            given: f64,
        } => "period: {given} s is not from 0.001 s to 1 s",
        /// The arm starts beyond a limit.
        Start(beyond: Beyond) => "start: {beyond}",
    }
}

/// Distance to the goal, in degrees, below which joint positions count as reached.
const THERE: f64 = 1e-6;
/// Greatest velocity of the tool that is scaled down, in mm/s and deg/s; a higher one means rest.
const MOST: f64 = 1e6;

impl Generator {
    /// Creates a generator for an arm at rest at `start`, with a set-point each `period_s`.
    ///
    /// # Errors
    /// The start is beyond a joint's range or a region, the dynamics are beyond the limits or too small for a motion,
    /// or the period is not from 1 ms to 1 s.
    pub fn new(
        checker: &Checker,
        dynamics: Dynamics,
        start: JointPosition,
        period_s: f64,
    ) -> Result<Self, GeneratorError> {
        if !PERIODS.contains(&period_s) {
            return Err(GeneratorError::Period { given: period_s });
        }
        dynamics.check(checker.limits())?;
        checker.check_place(start).map_err(GeneratorError::Start)?;
        let constraints = Constraints::new(checker.clone(), dynamics.joint_limits(period_s), period_s);
        let led = constraints.at_rest(&start.0);
        Ok(Self { constraints, led, before: led, goal: Goal::Rest, plan: Plan::new(), rejections: 0 })
    }

    /// Sets the generator up for a tool that must be able to stop soon. The tool centre point moves with at most this
    /// speed, in mm/s as mean over a period. From each set-point on it comes to rest within this distance, in mm, which
    /// includes the last period before. The generator approaches goals more slowly for that. The path from rest to
    /// joint positions is still straight in joint space.
    ///
    /// # Errors
    /// The speed or the distance is not from 0.001 to 1e9.
    pub fn with_tool_stop(mut self, speed_mm_s: f64, within_mm: f64) -> Result<Self, InvalidLimit> {
        in_range("distance in which the tool centre point stops", &[within_mm])?;
        let limits = self.constraints.checker.limits().clone();
        let speed_mm_s = limits.tcp_speed().map_or(speed_mm_s, |limit| limit.min(speed_mm_s));
        self.constraints.checker = Checker::new(limits.with_tcp_speed(speed_mm_s)?, *self.constraints.checker.frames());
        self.constraints.stopping_mm = within_mm;
        Ok(self)
    }

    /// Checks a goal before it is given to [`next`](Self::next): joint positions as a place, speeds of joints and of
    /// the tool centre point by their limits.
    pub fn check_goal(&self, goal: &Goal) -> Result<(), Beyond> {
        let exceeded = match goal {
            Goal::Joints(joints) => return self.constraints.checker.check_place(*joints),
            Goal::Velocity(speeds) => self.constraints.speeds_beyond(speeds),
            Goal::TcpVelocity(velocity) => self.constraints.tcp_velocity_beyond(velocity),
            Goal::Rest => None,
        };
        exceeded.map_or(Ok(()), |exceeded| Err(self.constraints.beyond(exceeded)))
    }

    /// Returns the set-point a period after the last one, towards a goal.
    ///
    /// A goal that [`check_goal`](Self::check_goal) refuses is approached as far as the limits allow. A goal with a
    /// number that is not finite, or with a velocity of the tool above 1e6 mm/s or deg/s, means rest.
    pub fn next(&mut self, goal: &Goal) -> Step {
        if *goal != self.goal {
            self.goal = *goal;
            self.plan.drop_way();
        }
        let (proposed, mut bound) =
            if self.led.must_stop(&self.constraints.limits) { (None, None) } else { self.proposed() };
        if let Some(proposed) = proposed {
            let exceeded = match self.constraints.led(&self.led.state, proposed) {
                Ok(led) => {
                    self.plan.pass(self.constraints.period_s);
                    return self.take(&led, bound);
                }
                Err(exceeded) => exceeded,
            };
            self.plan.drop_way();
            let is_too_fast = matches!(exceeded, Exceeded::TcpSpeed { .. } | Exceeded::LandingWay { .. });
            bound = Some(Bound::Limit(self.constraints.beyond(exceeded)));
            let slower = if is_too_fast {
                self.constraints.slower(&self.led.state, &proposed)
            } else {
                self.constraints.slowed(&self.led.state)
            };
            if let Some(led) = slower {
                return self.take(&led, bound);
            }
        }
        let stopped = self.led.stopped(self.constraints.period_s);
        self.take(&stopped, bound)
    }

    /// Reports that a set-point was missed: the next one starts from standstill at the last one.
    pub fn paused(&mut self) {
        self.led = self.constraints.at_rest(&positions(&self.led.state));
        self.plan.drop_way();
    }

    /// Reports that the last set-point was not sent: the next one follows the one before. Valid once after each
    /// [`next`](Self::next).
    pub fn take_back(&mut self) {
        self.led = self.before;
        self.plan.drop_way();
    }

    /// Returns the last set-point.
    pub fn joints(&self) -> JointPosition {
        JointPosition(positions(&self.led.state))
    }

    /// Returns the speeds of the joints at the last set-point, in deg/s.
    pub fn velocity(&self) -> [f64; 6] {
        self.led.state.map(|state| state.speed)
    }

    /// Returns the accelerations of the joints at the last set-point, in deg/s².
    pub fn acceleration(&self) -> [f64; 6] {
        self.led.state.map(|state| state.acceleration)
    }

    /// Whether no joint moves.
    pub fn is_at_rest(&self) -> bool {
        is_at_rest(&self.led.state)
    }

    /// Returns the position at which the arm would come to rest with the goal [`Goal::Rest`], and the time until then.
    pub fn landing(&self) -> Landing {
        let Led { stops, bound, .. } = self.led;
        Landing { joints: JointPosition(stops.map(|stop| stop.end())), time_s: longest_stop(&stops), bound }
    }

    /// Returns the number of times that the states computed for a goal failed the check of speeds, accelerations and
    /// jerks, or that no states were found. The set-point was then one on the path to rest.
    pub fn rejections(&self) -> u64 {
        self.rejections
    }

    /// Returns the period in seconds.
    pub fn period_s(&self) -> f64 {
        self.constraints.period_s
    }

    /// Returns the checker that set-points are compared with.
    pub fn checker(&self) -> &Checker {
        &self.constraints.checker
    }

    /// Returns the next states towards the goal, unless the goal is rest, and the bound that slows them.
    fn proposed(&mut self) -> (Option<[JointState; 6]>, Option<Bound>) {
        let slowed = match self.goal {
            Goal::Joints(target) if finite(target.0) => {
                let target = self.constraints.in_range(target);
                if self.is_there(&target) {
                    return (None, None);
                }
                let pace = self.constraints.tool_pace_to(&self.led.state, &target);
                if let Some(pace) = &pace {
                    self.plan.lead_to_joints(&self.led.state, &pace.limits, &target);
                } else if self.plan.is_done() {
                    self.plan.lead_to_joints(&self.led.state, &self.constraints.limits, &target);
                }
                pace.and_then(|pace| pace.exceeded)
            }
            Goal::Velocity(speeds) if finite(speeds) => {
                let limits = self.constraints.checker.limits();
                let ranges = [limits.joint_min(), limits.joint_max()];
                let pace = self.constraints.tool_pace(&self.led.state, &speeds, 1.0);
                let share = pace.as_ref().map_or(1.0, |pace| pace.share);
                let speeds = speeds.map(|speed| share * speed);
                if let Some(pace) = &pace {
                    self.plan.lead_to_speeds(&self.led.state, &pace.limits, &speeds, ranges);
                } else if !self.plan.is_fresh() {
                    self.plan.lead_to_speeds(&self.led.state, &self.constraints.limits, &speeds, ranges);
                }
                self.constraints.held_in_range(&self.led.state, &speeds).or(pace.and_then(|pace| pace.exceeded))
            }
            Goal::TcpVelocity(velocity) if velocity.numbers().all(|number| number.abs() <= MOST) => {
                let (speeds, exceeded) = self.constraints.speeds_for(&self.led.state, &velocity);
                self.plan.lead_to_speeds_together(&self.led.state, &self.constraints.limits, &speeds);
                exceeded
            }
            _ => return (None, None),
        };
        let proposed = self.plan.next(&self.led.state, &self.constraints.limits, self.constraints.period_s);
        if proposed.is_none() {
            self.rejections += 1;
            self.plan.drop_way();
            return (None, Some(Bound::Rejected));
        }
        (proposed, slowed.map(|exceeded| Bound::Limit(self.constraints.beyond(exceeded))))
    }

    fn take(&mut self, next: &Led, bound: Option<Bound>) -> Step {
        self.before = std::mem::replace(&mut self.led, *next);
        Step { joints: self.joints(), bound }
    }

    /// Whether the planned path is at its end and the rest of the distance not worth a motion.
    fn is_there(&self, target: &[f64; 6]) -> bool {
        let is_near = |(stop, target): (&Stop, &f64)| (stop.end() - target).abs() < THERE;
        self.plan.is_done() && self.led.stops.iter().zip(target).all(is_near)
    }
}

impl Led {
    /// Returns the next state on the path to rest.
    fn stopped(&self, period_s: f64) -> Self {
        let stops = self.stops.map(|stop| stop.after(period_s));
        Self { state: stops.map(|stop| stop.at(0.0)), stops, stops_already: true, ..*self }
    }

    /// Whether, on a path to rest, a joint brakes by more than these limits allow, or by more than they can take back
    /// before the joint would turn round.
    fn must_stop(&self, limits: &[JointLimits; 6]) -> bool {
        let is_hard = |(state, limits): (&JointState, &JointLimits)| {
            !state.is_within(*limits) || state.coasting_speed(limits.jerk) * state.speed < 0.0
        };
        self.stops_already && self.state.iter().zip(limits).any(is_hard)
    }
}

impl std::error::Error for GeneratorError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Start(beyond) => Some(beyond),
            Self::OutOfRange { .. } | Self::BeyondLimit { .. } | Self::Period { .. } => None,
        }
    }
}

fn finite(numbers: impl IntoIterator<Item = f64>) -> bool {
    numbers.into_iter().all(f64::is_finite)
}

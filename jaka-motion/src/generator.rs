//! Set-points, one a period, on the way to a goal that may change at any time.

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
use crate::limits::InvalidLimit;
use crate::speed::TcpVelocity;

/// Makes one set-point a period, on the way to a goal that may change with each of them.
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
/// - The first differences of the set-points, divided by the period, are within the speeds of the [`Dynamics`], the
///   second ones, divided by its square, within the accelerations, and the third ones, divided by its cube, within the
///   jerks, but for rounding: a billionth of the limit, and what some 1e-13 degrees make of a difference. After
///   [`paused`](Self::paused) they start again, as if the arm had been at the last set-point for long.
/// - Stops are an exception: a joint that slows down may do so with the acceleration and the jerk of stops
///   ([`Limits::stop_accelerations`](crate::Limits::stop_accelerations)), where these are higher. That is so with
///   [`Goal::Rest`], and in front of a limit that the goal does not respect.
/// - From each set-point the arm can be brought to rest so, along the velocity of its joints but for what accelerations
///   they have, within joint ranges, regions, and the speed of the tool centre point. [`landing`](Self::landing) says
///   where and when.
///
/// # Why it holds
/// The set-points are samples of a motion whose jerk is within its limit at each moment, so that their third
/// differences are means of it; likewise accelerations and speeds. rsruckig proposes the jerks. They are cut to their
/// limits and integrated here, from the state of the last set-point; the new state is taken only if speeds and
/// accelerations have stayed within their limits, and if the way to rest from there stays within all limits. Where the
/// tool centre point alone would be too fast, states between the proposed one and going on as fast as before are tried
/// in the same way; elsewhere, slowing down within the accelerations of the [`Dynamics`]. Otherwise the set-point is
/// the next one on the way to rest that was compared with the limits when the last state was taken. The arm starts at
/// rest, within the limits. So each state has a way to rest. Once a joint brakes by more than the dynamics allow to
/// take back before it would turn round, the arm goes on to rest.
///
/// # What remains
/// - The way to a goal in joints is not straight for the tool, and not planned around regions: the arm stops in front
///   of one.
/// - A velocity of the tool is a velocity: what is off its way is not corrected. The arm slows to a stop in front of a
///   limit, a region or a singularity, all axes together, so that the direction is kept but for what joints still have
///   of an earlier motion. A singularity is not passed; to lead the arm away from one whose distance is nearly zero
///   takes a goal in joints.
/// - Distances from singularities count for velocities of the tool alone.
/// - On its way between two places that are computed, a point may be beyond a region by 0.1 mm, and by 0.6 mm at an
///   edge of a box to be kept outside of: within [`Checker::AMOUNT_MM`]. It does not come to rest there, unless that is
///   where the session paused; it then leads on as a motion that starts beyond a limit.
///
/// Nothing is allocated but in `new`, and where rsruckig finds no way, which then says so in a text that is dropped. No
/// input makes it panic.
#[derive(Debug, Clone)]
pub struct Generator {
    constraints: Constraints,
    led: Led,
    /// State at the set-point before.
    before: Led,
    goal: Goal,
    plan: Plan,
    rejections: u64,
}

/// State of the joints at a set-point, and the way to rest from there, which is within all limits.
#[derive(Debug, Clone, Copy)]
struct Led {
    state: [JointState; 6],
    stops: [Stop; 6],
    bound: StopBound,
    /// True on the way to rest.
    stops_already: bool,
}

/// Target of a [`Generator`]: joint positions, a velocity or standstill.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Joint positions, which all joints reach at the same time. From rest the way is straight in joint space; it is
    /// not straight for the tool.
    Joints(JointPosition),
    /// A speed of each joint in deg/s, which each reaches as soon as it can. A joint stops at the end of its range, the
    /// others go on.
    Velocity([f64; 6]),
    /// A velocity of the tool.
    TcpVelocity(TcpVelocity),
    /// Standstill by a stop. For one within the [`Dynamics`], there is a velocity of zero.
    Rest,
}

/// One set-point, and the bound that kept it from being nearer to the goal.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// The set-point.
    pub joints: JointPosition,
    /// Bound that slowed or held the motion, other than the speeds, accelerations and jerks of the joints.
    pub bound: Option<Bound>,
}

/// Bound that slows or holds a motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Bound {
    /// A limit that is near.
    Limit(Beyond),
    /// The generator's own check refused the states computed for the goal. [`Generator::rejections`] counts these
    /// refusals.
    Rejected,
}

/// Position and time of rest of an arm that stops now.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Landing {
    /// Its joint positions there.
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
        /// A speed, acceleration or jerk is too small, or not a number.
        TooLittle {
            /// Name of the joint's quantity, for example `speed`.
            what: &'static str,
            /// Its unit.
            unit: &'static str,
            /// The joint, 1 to 6.
            joint: usize,
            /// The number that was given.
            given: f64,
            /// The least that there may be.
            least: f64,
        } => "{what} of joint {joint}: {given} {unit} is not at least {least} {unit}",
        /// A speed or an acceleration is higher than the arm's limits allow.
        BeyondLimit {
            /// Name of the joint's quantity, for example `speed`.
            what: &'static str,
            /// Its unit.
            unit: &'static str,
            /// The joint, 1 to 6.
            joint: usize,
            /// The number that was given.
            given: f64,
            /// Highest value that the limits allow.
            limit: f64,
        } => "{what} of joint {joint}: {given} {unit} is beyond the arm's limit of {limit} {unit}",
        /// The period is not from 1 ms to 1 s.
        Period {
            /// The number that was given, in seconds.
            given: f64,
        } => "period: {given} s is not from 0.001 s to 1 s",
        /// The arm starts beyond a limit.
        Start(beyond: Beyond) => "start: {beyond}",
    }
}

/// The periods for which set-points can be generated, in seconds.
const PERIODS: std::ops::RangeInclusive<f64> = 0.001..=1.0;
/// Joint positions nearer to the goal than this, in degrees, are there.
const THERE: f64 = 1e-6;
/// The most of a velocity of the tool that is scaled down, in mm/s and deg/s.
const MOST: f64 = 1e6;

impl Generator {
    /// For an arm at rest at `start`, with a set-point each so many seconds.
    ///
    /// # Errors
    /// The start is beyond a joint's range or a region, the dynamics are beyond the limits or too small to move with,
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

    /// Returns the generator for a tool that must be able to stop soon. The tool centre point moves with at most this
    /// speed, in mm/s as mean over a period. From each set-point on it comes to rest within this distance, in mm, of
    /// which the last period before is a part. The generator approaches goals more slowly for that, but joint
    /// positions from rest still straight in joint space.
    ///
    /// # Errors
    /// The speed is not above 0.
    pub fn with_tool_stop(mut self, speed_mm_s: f64, within_mm: f64) -> Result<Self, InvalidLimit> {
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

    /// The set-point a period after the last one, on the way to a goal.
    ///
    /// A goal that [`check_goal`](Self::check_goal) refuses is approached as far as the limits allow; one with a number
    /// that is not finite, or with a velocity of the tool above 1e6 mm/s or deg/s, means rest.
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

    /// No set-point has come when one was due: what comes next starts from standstill at the last one.
    pub fn paused(&mut self) {
        self.led = self.constraints.at_rest(&positions(&self.led.state));
        self.plan.drop_way();
    }

    /// The last set-point was not sent: what comes next follows the one before. Once after each [`next`](Self::next).
    pub fn take_back(&mut self) {
        self.led = self.before;
        self.plan.drop_way();
    }

    /// The last set-point.
    pub fn joints(&self) -> JointPosition {
        JointPosition(positions(&self.led.state))
    }

    /// The speeds of the joints at the last set-point, in deg/s.
    pub fn velocity(&self) -> [f64; 6] {
        self.led.state.map(|state| state.speed)
    }

    /// The accelerations of the joints at the last set-point, in deg/s².
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

    /// Returns the number of times that the states computed for a goal did not pass the check of speeds, accelerations
    /// and jerks, or that none were found. The set-point was then one on the way to rest.
    pub fn rejections(&self) -> u64 {
        self.rejections
    }

    /// The period in seconds.
    pub fn period_s(&self) -> f64 {
        self.constraints.period_s
    }

    /// Returns the checker that set-points are compared with.
    pub fn checker(&self) -> &Checker {
        &self.constraints.checker
    }

    /// Returns the states that lead to the goal, unless that is rest; and the bound that slows them.
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

    /// Whether the way is at its end and the rest of it not worth a motion.
    fn is_there(&self, target: &[f64; 6]) -> bool {
        let is_near = |(stop, target): (&Stop, &f64)| (stop.end() - target).abs() < THERE;
        self.plan.is_done() && self.led.stops.iter().zip(target).all(is_near)
    }
}

impl Led {
    /// The next state on the way to rest.
    fn stopped(&self, period_s: f64) -> Self {
        let stops = self.stops.map(|stop| stop.after(period_s));
        Self { state: stops.map(|stop| stop.at(0.0)), stops, stops_already: true, ..*self }
    }

    /// True on a way to rest on which a joint brakes by more than these limits allow, or than they allow to take back
    /// before it would turn round.
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
            Self::TooLittle { .. } | Self::BeyondLimit { .. } | Self::Period { .. } => None,
        }
    }
}

fn finite(numbers: impl IntoIterator<Item = f64>) -> bool {
    numbers.into_iter().all(f64::is_finite)
}

//! Set-points, one a period, on the way to a goal that may change at any time.

mod dynamics;
mod error;
mod goal;
mod plan;
mod slower;
mod tcp_velocity;
mod tool_pace;

use jaka_proto::messages::types::JointPosition;

pub use self::dynamics::Dynamics;
pub use self::error::GeneratorError;
pub use self::goal::{Bound, Goal, Landing, Step};
use self::plan::Plan;
use crate::beyond::{Beyond, Exceeded, Way};
use crate::braking::{JointLimits, JointState, Stop, longest_stop};
use crate::checker::Checker;
use crate::limits::InvalidLimit;

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
/// - The first differences of the set-points, divided by the period, are within the speeds of the [`Dynamics`], the second ones, divided by its square,
///   within the accelerations, and the third ones, divided by its cube, within the jerks, but for rounding: a billionth of the limit, and what some 1e-13
///   degrees make of a difference. After [`paused`](Self::paused) they start again, as if the arm had been at the last set-point for long.
/// - From each set-point the arm can be brought to rest within speeds, accelerations, jerks, joint ranges, regions, and the speed of the tool centre point:
///   each joint as soon as it can. [`landing`](Self::landing) says where and when.
///
/// # Why it holds
/// The set-points are samples of a motion whose jerk is within its limit at each moment, so that their third
/// differences are means of it; likewise accelerations and speeds. rsruckig proposes the jerks. They are cut to their
/// limits and integrated here, from the state of the last set-point; the new state is taken only if speeds and
/// accelerations have stayed within their limits, and if the way to rest from there stays within all limits. Where the
/// tool centre point alone would be too fast, states between the proposed one and going on as fast as before are tried
/// in the same way. Otherwise the set-point is the next one on the way to rest from the last state, which was compared
/// with the limits when that state was taken. The arm starts at rest, within the limits. So each state has a way to
/// rest.
///
/// # What remains
/// - The way to a goal in joints is not straight for the tool, and not planned around regions: the arm stops in front of one.
/// - A velocity of the tool is a velocity: what is off its way is not corrected. The arm slows to a stop in front of a limit, a region or a
///   singularity, all axes together, so that the direction is kept but for what joints still have of an earlier motion. A singularity is not passed; to lead the arm away from one
///   whose distance is nearly zero takes a goal in joints.
/// - Distances from singularities count for velocities of the tool alone.
/// - On its way between two places that are computed, a point may be beyond a region by 0.1 mm, and by 0.6 mm at an edge of a box to be kept outside of: within
///   [`Checker::AMOUNT_MM`]. It does not come to rest there, unless that is where the session paused; it then leads on as a motion that starts beyond a
///   limit.
///
/// Nothing is allocated but in `new`, and where rsruckig finds no way, which then says so in a text that is dropped. No
/// input makes it panic.
#[derive(Debug, Clone)]
pub struct Generator {
    checker: Checker,
    limits: [JointLimits; 6],
    period_s: f64,
    /// How far the tool may go on until the arm stops, in mm.
    stopping_mm: f64,
    state: [JointState; 6],
    /// That of the set-point before.
    before: [JointState; 6],
    goal: Goal,
    plan: Plan,
    rejections: u64,
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
        Ok(Self {
            checker: checker.clone(),
            limits: dynamics.joint_limits(period_s),
            period_s,
            stopping_mm: f64::INFINITY,
            state: start.0.map(JointState::at_rest),
            before: start.0.map(JointState::at_rest),
            goal: Goal::Rest,
            plan: Plan::new(),
            rejections: 0,
        })
    }

    /// The same for a tool that must be able to stop soon: the tool centre point moves with at most this speed, in mm/s
    /// as mean over a period, and from each set-point on it comes to rest within this way, in mm, of which the last
    /// period before is a part. Goals are approached more slowly for that, joint positions from rest still straight in
    /// joint space.
    ///
    /// # Errors
    /// The speed is not above 0.
    pub fn with_tool_stop(self, speed_mm_s: f64, within_mm: f64) -> Result<Self, InvalidLimit> {
        let limits = self.checker.limits().clone();
        let speed_mm_s = limits.tcp_speed().map_or(speed_mm_s, |limit| limit.min(speed_mm_s));
        let checker = Checker::new(limits.with_tcp_speed(speed_mm_s)?, *self.checker.frames());
        Ok(Self { checker, stopping_mm: within_mm, ..self })
    }

    /// Checks a goal before it is given to [`next`](Self::next): joint positions as a place, speeds of joints and of
    /// the tool centre point by their limits.
    pub fn check_goal(&self, goal: &Goal) -> Result<(), Beyond> {
        let exceeded = match goal {
            Goal::Joints(joints) => return self.checker.check_place(*joints),
            Goal::Velocity(speeds) => self.speeds_beyond(speeds),
            Goal::TcpVelocity(velocity) => self.tcp_velocity_beyond(velocity),
            Goal::Rest => None,
        };
        exceeded.map_or(Ok(()), |exceeded| Err(self.beyond(exceeded)))
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
        let (proposed, mut bound) = self.proposed();
        if let Some(proposed) = proposed {
            let Err(exceeded) = self.check(&proposed) else {
                self.plan.pass(self.period_s);
                return self.take(proposed, bound);
            };
            self.plan.drop_way();
            let is_too_fast = matches!(exceeded, Exceeded::TcpSpeed { .. } | Exceeded::LandingWay { .. });
            bound = Some(Bound::Limit(self.beyond(exceeded)));
            if is_too_fast {
                return self.take(self.slower(&proposed), bound);
            }
        }
        let stops = self.stops();
        self.take(stops.map(|stop| stop.at(self.period_s)), bound)
    }

    /// No set-point has come when one was due: what comes next starts from standstill at the last one.
    pub fn paused(&mut self) {
        self.state = self.state.map(|state| JointState::at_rest(state.position));
        self.plan.drop_way();
    }

    /// The last set-point was not sent: what comes next follows the one before. Once after each [`next`](Self::next).
    pub fn take_back(&mut self) {
        self.state = self.before;
        self.plan.drop_way();
    }

    /// The last set-point.
    pub fn joints(&self) -> JointPosition {
        JointPosition(self.state.map(|state| state.position))
    }

    /// The speeds of the joints at the last set-point, in deg/s.
    pub fn velocity(&self) -> [f64; 6] {
        self.state.map(|state| state.speed)
    }

    /// The accelerations of the joints at the last set-point, in deg/s².
    pub fn acceleration(&self) -> [f64; 6] {
        self.state.map(|state| state.acceleration)
    }

    /// Whether no joint moves.
    pub fn is_at_rest(&self) -> bool {
        self.state.iter().all(|state| *state == JointState::at_rest(state.position))
    }

    /// Where the arm would come to rest with the goal [`Goal::Rest`], and when.
    pub fn landing(&self) -> Landing {
        let stops = self.stops();
        Landing { joints: JointPosition(stops.map(|stop| stop.end())), time_s: longest_stop(&stops) }
    }

    /// How often what was computed for a goal did not pass the check of speeds, accelerations and jerks, or nothing was
    /// found. The set-point was then one on the way to rest.
    pub fn rejections(&self) -> u64 {
        self.rejections
    }

    /// The period in seconds.
    pub fn period_s(&self) -> f64 {
        self.period_s
    }

    /// What a set-point is compared with.
    pub fn checker(&self) -> &Checker {
        &self.checker
    }

    /// The states that lead to the goal, unless that is rest; and what slows them.
    fn proposed(&mut self) -> (Option<[JointState; 6]>, Option<Bound>) {
        let slowed = match self.goal {
            Goal::Joints(target) if finite(target.0) => {
                let target = self.in_range(target);
                if self.is_there(&target) {
                    return (None, None);
                }
                let pace = self.tool_pace_to(&target);
                if let Some(pace) = &pace {
                    self.plan.lead_to_joints(&self.state, &pace.limits, &target);
                } else if self.plan.is_done() {
                    self.plan.lead_to_joints(&self.state, &self.limits, &target);
                }
                pace.and_then(|pace| pace.exceeded)
            }
            Goal::Velocity(speeds) if finite(speeds) => {
                let limits = self.checker.limits();
                let ranges = [limits.joint_min(), limits.joint_max()];
                let pace = self.tool_pace(&speeds, 1.0);
                let share = pace.as_ref().map_or(1.0, |pace| pace.share);
                let speeds = speeds.map(|speed| share * speed);
                if let Some(pace) = &pace {
                    self.plan.lead_to_speeds(&self.state, &pace.limits, &speeds, ranges);
                } else if !self.plan.is_fresh() {
                    self.plan.lead_to_speeds(&self.state, &self.limits, &speeds, ranges);
                }
                self.held_in_range(&speeds).or(pace.and_then(|pace| pace.exceeded))
            }
            Goal::TcpVelocity(velocity) if velocity.numbers().all(|number| number.abs() <= MOST) => {
                let (speeds, exceeded) = self.speeds_for(&velocity);
                self.plan.lead_to_speeds_together(&self.state, &self.limits, &speeds);
                exceeded
            }
            _ => return (None, None),
        };
        let proposed = self.plan.next(&self.state, &self.limits, self.period_s);
        if proposed.is_none() {
            self.rejections += 1;
            self.plan.drop_way();
            return (None, Some(Bound::Rejected));
        }
        (proposed, slowed.map(|exceeded| Bound::Limit(self.beyond(exceeded))))
    }

    fn take(&mut self, next: [JointState; 6], bound: Option<Bound>) -> Step {
        self.before = std::mem::replace(&mut self.state, next);
        Step { joints: self.joints(), bound }
    }

    /// Whether the arm may go to these states: what comes after them is the way to rest.
    fn check(&self, next: &[JointState; 6]) -> Result<(), Exceeded> {
        let stops = std::array::from_fn(|index| Stop::of(next[index], self.limits[index]));
        let last = self.joints().0;
        let rested = self.is_at_rest().then_some(&last);
        self.checker.check_stops(rested, &last, &stops, (self.period_s, self.stopping_mm))
    }

    fn stops(&self) -> [Stop; 6] {
        std::array::from_fn(|index| Stop::of(self.state[index], self.limits[index]))
    }

    /// Whether the way is at its end and the rest of it not worth a motion.
    fn is_there(&self, target: &[f64; 6]) -> bool {
        let is_near = |(stop, target): (&Stop, &f64)| (stop.end() - target).abs() < THERE;
        self.plan.is_done() && self.stops().iter().zip(target).all(is_near)
    }

    fn in_range(&self, target: JointPosition) -> [f64; 6] {
        let limits = self.checker.limits();
        std::array::from_fn(|index| target.0[index].clamp(limits.joint_min()[index], limits.joint_max()[index]))
    }

    /// The joint that rests at the end of its range, and is meant to go on.
    fn held_in_range(&self, speeds: &[f64; 6]) -> Option<Exceeded> {
        let limits = self.checker.limits();
        (0..6).find_map(|index| {
            let (speed, position_deg) = (speeds[index], self.state[index].position);
            let limit_deg = if speed > 0.0 { limits.joint_max()[index] } else { limits.joint_min()[index] };
            let is_slowed = self.state[index].speed.abs() < 0.99 * speed.abs();
            let is_held = is_slowed && (limit_deg - position_deg).abs() < self.stopping_room(index);
            is_held.then_some(Exceeded::LandingRange { joint: index + 1, end_deg: position_deg, limit_deg })
        })
    }

    /// What a joint takes to stop from its full speed, in degrees.
    fn stopping_room(&self, index: usize) -> f64 {
        let fast = JointState { speed: self.limits[index].speed, ..JointState::default() };
        Stop::of(fast, self.limits[index]).end()
    }

    fn speeds_beyond(&self, speeds: &[f64; 6]) -> Option<Exceeded> {
        if !finite(*speeds) {
            return Some(Exceeded::NotFinite);
        }
        let index = (0..6).find(|index| speeds[*index].abs() > self.limits[*index].speed)?;
        let (speed_deg_s, limit_deg_s) = (speeds[index].abs(), self.limits[index].speed);
        Some(Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near: None })
    }

    fn beyond(&self, exceeded: Exceeded) -> Beyond {
        self.checker.beyond_of(Way::SetPoint, exceeded)
    }
}

fn finite(numbers: impl IntoIterator<Item = f64>) -> bool {
    numbers.into_iter().all(f64::is_finite)
}

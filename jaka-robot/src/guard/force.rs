//! Forces at the tool, and the speeds of a tool that is to stop by them.

use std::fmt;
use std::time::Duration;

use jaka_motion::Overtravel;
use jaka_proto::wire::{DecodeError, Typed};

use crate::arm::Arm;
use crate::cause::Field;
use crate::error::OptionName;
use crate::{Error, NotGuarded, NotShown, Snapshot};

/// A change of the contact force since shortly before the start of a motion, in either direction, by which the motion
/// is stopped.
///
/// The force is [`TorqueSensorState::contact_force`](crate::status::TorqueSensorState::contact_force), compared with
/// the newest packet at the arming of the guard; the motion is sent a moment later, and packets may come meanwhile. The
/// sensor must report that it works and no error, before the motion and in each packet. The document states neither
/// units nor order nor axes of the six values: this SDK takes them to be fx, fy, fz, tx, ty, tz, N and Nm, as in
/// `set_compliance_condition` (4.71, vendor's texts). By the vendor's English page they are valid once the sensor is
/// initialised; packets do not show that. Push against the tool by hand and look at packets before anything relies on
/// it.
///
/// **The speed of the motion is bounded**, since a contact is known late. Until the arm rests, the tool moves on for a
/// period of the packets, for a reaction, and for its braking: `speed * (period + reaction) + speed² / (2 * braking)`.
/// This distance must not be longer than the overtravel, 1 mm by default. The period is the longest time between two of
/// the last 33 packets. A faster motion is not sent, nor one with an unknown tool speed or braking: it must be a
/// `move_l` or `move_c` with an acceleration, from rest. All of it applies to the tool centre point; other points of a
/// turning tool may be faster.
///
/// Trajectories, and streams (feature `stream`), are bounded by their set-points: the tool moves on for a period of the
/// packets, the reaction and two servo periods, and then along the path on which the set-points brake it, independent
/// of [`braking`](Self::braking). See `FollowConfig::guard` and `StreamConfig::guard` for the rules. The lag of such an
/// arm behind its set-points, and a servo filter, are parts of the reaction:
/// [`TrajectoryReport::lag`](crate::TrajectoryReport::lag) measures the lag.
///
/// | packets each | reaction | braking | permitted with 1 mm |
/// |---|---|---|---|
/// | 8 ms | 20 ms | 500 mm/s² | 20.6 mm/s |
/// | 30 ms | 20 ms | 500 mm/s² | 15.3 mm/s |
/// | 100 ms | 20 ms | 500 mm/s² | 7.8 mm/s |
///
/// The bound counts from the change of the force by the limit, which a soft object reaches later. It holds if packets
/// come as regularly as before, the link and the controller react in time, and the controller brakes as assumed. If
/// packets stay away for three such periods (and 100 ms), the arm is stopped.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::motion::MoveL;
/// use jaka_robot::{ForceComponent, ForceLimit, MotionExt as _, Robot};
///
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let down = MoveL::relative([0.0, 0.0, -50.0, 0.0, 0.0, 0.0], 5.0).acceleration(500.0);
/// let contact = ForceLimit::new(ForceComponent::Fz, 10.0).overtravel(0.5);
/// robot.run(&down.guard(contact), Duration::from_secs(20))?.guarded()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use = "a limit does nothing until a motion runs under it"]
pub struct ForceLimit {
    component: ForceComponent,
    change: f64,
    pub(super) overtravel_mm: f64,
    pub(super) reaction: Duration,
    braking: Option<f64>,
}

jaka_proto::worded! {
    /// Component of the contact force: one of its six values, or the force in any direction. Displayed as the condition
    /// of a [`ForceLimit`] names it.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum ForceComponent {
        /// The first value, taken to be the force along x.
        Fx => "component fx of the contact force",
        /// The second value, taken to be the force along y.
        Fy => "component fy of the contact force",
        /// The third value, taken to be the force along z.
        Fz => "component fz of the contact force",
        /// The fourth value, taken to be the torque about x.
        Tx => "component tx of the contact force",
        /// The fifth value, taken to be the torque about y.
        Ty => "component ty of the contact force",
        /// The sixth value, taken to be the torque about z.
        Tz => "component tz of the contact force",
        /// The length of the first three values together, taken to be the force in any direction.
        Force => "the contact force",
    }
}

/// The longest overtravel that a limit may state, in mm: the same.
const LONGEST_OVERTRAVEL_MM: f64 = 1000.0;

/// The largest change and the largest braking that a limit may state: ours, far beyond any sensor and any arm.
const MOST: f64 = 1e6;

/// The longest reaction that a limit may state: ours, far beyond any.
const LONGEST_REACTION: Duration = Duration::from_secs(60);

impl ForceLimit {
    /// A change of a component by more than this, in units of the sensor, taken to be N or Nm. Other values than a
    /// number above 0, of a million at most, are an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) at
    /// the use of the limit.
    pub fn new(component: ForceComponent, change: f64) -> Self {
        Self { component, change, overtravel_mm: 1.0, reaction: Duration::from_millis(20), braking: None }
    }

    /// Sets the overtravel: the longest path of the tool after the force has changed by the limit, in mm. The default
    /// of 1 is ours. Other values than a number above 0, of 1000 at most, are an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn overtravel(mut self, mm: f64) -> Self {
        self.overtravel_mm = mm;
        self
    }

    /// Sets the time from a packet's arrival to the beginning of the braking. The default of 20 ms is ours: well below
    /// 1 ms until the stop is written, a cycle of the controller of 8 ms, and the rest for the network. With
    /// set-points, the lag of the arm behind them is a part of it, which is longer with a filter. More than one minute
    /// is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn reaction(mut self, time: Duration) -> Self {
        self.reaction = time;
        self
    }

    /// Sets the deceleration of the tool in its braking, in mm/s²: by default the acceleration of the motion. No source
    /// states the braking of a controller on `stop_program`. Other values than a number above 0, of a million at most,
    /// are an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn braking(mut self, mm_s2: f64) -> Self {
        self.braking = Some(mm_s2);
        self
    }

    /// Name of one of its options.
    pub(crate) const fn option(name: &'static str) -> OptionName {
        OptionName::new("ForceLimit", name)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let numbers =
            [("change", self.change), ("overtravel", self.overtravel_mm), ("braking", self.braking.unwrap_or(1.0))];
        let odd = numbers.into_iter().find(|(_, value)| !value.is_finite() || *value <= 0.0);
        if let Some((name, value)) = odd {
            return Err(Self::option(name).refuse(value, "a number above 0"));
        }
        if let Some((name, value)) = numbers.into_iter().find(|(_, value)| *value > MOST) {
            return Err(Self::option(name).refuse(value, format!("at most {MOST}")));
        }
        if self.overtravel_mm > LONGEST_OVERTRAVEL_MM {
            return Err(Self::option("overtravel").refuse(self.overtravel_mm, "at most 1000 mm"));
        }
        if self.reaction > LONGEST_REACTION {
            return Err(Self::option("reaction").refuse(format_args!("{:?}", self.reaction), "at most one minute"));
        }
        Ok(())
    }

    /// Whether the force has changed by the limit since the start.
    pub(super) fn holds(&self, start: &[f64; 6], now: &[f64; 6]) -> bool {
        let change = |i: usize| now[i] - start[i];
        let found = match self.component {
            ForceComponent::Force => (0..3).map(|i| change(i).powi(2)).sum::<f64>().sqrt(),
            // They are declared in the order of the values.
            component => change(component as usize),
        };
        found.abs() > self.change
    }

    /// Compares the speed of a motion, in mm/s, and its acceleration with the permitted ones for packets each `period`.
    pub(crate) fn check_speed(
        &self,
        speed: f64,
        acceleration: Option<f64>,
        period: Duration,
    ) -> Result<(), NotGuarded> {
        let braking_mm_s2 = self.braking.or(acceleration).ok_or(NotGuarded::BrakingUnknown)?;
        let (overtravel_mm, reaction) = (self.overtravel_mm, self.reaction);
        let permitted_mm_s = self.permitted(period.saturating_add(reaction).as_secs_f64(), braking_mm_s2);
        if speed <= permitted_mm_s {
            return Ok(());
        }
        Err(NotGuarded::TooFast { speed_mm_s: speed, permitted_mm_s, overtravel_mm, period, reaction, braking_mm_s2 })
    }

    /// The speed in mm/s at which the overtravel is used up by a time in which the tool is not braked and the braking.
    fn permitted(&self, unbraked_s: f64, braking_mm_s2: f64) -> f64 {
        // The positive root of speed * time + speed² / (2 * braking) = overtravel, in the form in which nothing
        // cancels.
        let root = (unbraked_s * unbraked_s + 2.0 * self.overtravel_mm / braking_mm_s2).sqrt();
        2.0 * self.overtravel_mm / (unbraked_s + root)
    }
}

/// For set-points, which brake the tool themselves.
impl ForceLimit {
    /// Longest time after a contact without braking, in seconds, with packets each `period` and set-points each
    /// `cycle_s`: until a packet shows it, the next set-point goes out and the reaction is over; the arm is a set-point
    /// behind.
    pub(super) fn unbraked_s(&self, period: Duration, cycle_s: f64) -> f64 {
        period.saturating_add(self.reaction).as_secs_f64() + 2.0 * cycle_s
    }

    /// Reason for the refusal of a trajectory with such a long path after a contact.
    pub(super) fn too_fast_along(&self, after: usize, worst: &Overtravel, period: Duration) -> NotGuarded {
        let Overtravel { time_s, unbraked_s, speed_mm_s, braking_mm_s2, way_mm, .. } = *worst;
        if way_mm.is_infinite() {
            return NotGuarded::CannotBrake { after, time_s };
        }
        let (overtravel_mm, reaction) = (self.overtravel_mm, self.reaction);
        let permitted_mm_s = self.permitted_along(unbraked_s, [speed_mm_s, braking_mm_s2]);
        NotGuarded::TooFastAlong {
            after,
            time_s,
            speed_mm_s,
            permitted_mm_s,
            way_mm,
            overtravel_mm,
            period,
            reaction,
            braking_mm_s2,
        }
    }
}

impl ForceLimit {
    /// The speed in mm/s at which the overtravel is used up where braking from a higher speed takes this deceleration.
    ///
    /// The slower the tool, the less of a stop is at its full deceleration: the way from a speed is taken to be in
    /// proportion to the power 1.5 of it, as it is where the jerk alone bounds the stop.
    fn permitted_along(&self, unbraked_s: f64, [speed_mm_s, braking_mm_s2]: [f64; 2]) -> f64 {
        let braking_s = 0.5 * speed_mm_s / braking_mm_s2;
        let way_mm = |speed: f64| speed * (unbraked_s + braking_s * (speed / speed_mm_s).sqrt());
        let (mut low, mut high) = (0.0, speed_mm_s);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if way_mm(middle) > self.overtravel_mm { high = middle } else { low = middle }
        }
        low
    }
}

/// Number of times that a range of speeds is halved.
const HALVINGS: u32 = 40;

/// Contact force that the sensor reads, if it works.
pub(super) fn contact_force(packet: &Snapshot) -> Result<[f64; 6], NotShown> {
    let name = "torque_sensor";
    let state = match (Field { packet, name }).shown(packet.status.torque_sensor.as_ref())? {
        Typed::Known(report) => &report.state,
        Typed::Raw(value) => {
            let source = DecodeError::unfit("settings and state of the sensor", &value.to_string()).in_field(name);
            return Err(NotShown::Unfit { source });
        }
    };
    match &state.error_code {
        _ if !state.working => Err(NotShown::SensorOff),
        Typed::Known(0) => Ok(state.contact_force),
        Typed::Known(code) => Err(NotShown::SensorError { code: code.to_string() }),
        Typed::Raw(code) => Err(NotShown::SensorError { code: code.to_string() }),
    }
}

impl fmt::Display for ForceLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} has changed by more than {}", self.component, self.change)
    }
}

/// Longest wait for packets, to know their period.
const PERIOD_WITHIN: Duration = Duration::from_secs(2);

/// Lower bound of [`longest_silence`].
const SHORTEST_SILENCE: Duration = Duration::from_millis(100);

/// The longest time between two of the last packets; `None` if too few come.
pub(crate) fn packet_period(arm: &Arm, timeout: Duration) -> Option<Duration> {
    let period = || arm.statistics().recent_gap;
    arm.state.watch(timeout.min(PERIOD_WITHIN), |_| period()).ok().flatten()
}

/// Longest silence of packets that is allowed under a limit of force, where packets come each `period`.
pub(crate) fn longest_silence(period: Duration) -> Duration {
    (period * 3).max(SHORTEST_SILENCE)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn permitted(period_ms: u64, braking: f64) -> f64 {
        let limit = ForceLimit::new(ForceComponent::Fz, 1.0);
        match limit.check_speed(1e6, Some(braking), Duration::from_millis(period_ms)) {
            Err(NotGuarded::TooFast { permitted_mm_s, .. }) => permitted_mm_s,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn overtravel_and_reaction_have_a_greatest_value() {
        let limit = || ForceLimit::new(ForceComponent::Fz, 1.0);
        let minute = Duration::from_secs(60);
        assert!(limit().overtravel(1000.0).reaction(minute).check().is_ok());
        for beyond in [limit().overtravel(1000.1), limit().reaction(minute + Duration::from_nanos(1))] {
            let error = beyond.check().expect_err("it is beyond");
            assert!(error.to_string().contains("at most "), "{error}");
        }
    }

    #[test]
    fn the_permitted_speed_uses_up_the_overtravel() {
        for (period, braking, expected) in [(8, 500.0, 20.6), (30, 500.0, 15.3), (100, 500.0, 7.8)] {
            let speed = permitted(period, braking);
            let time = f64::from(u32::try_from(period).expect("it is short") + 20) / 1000.0;
            assert!((speed * time + speed * speed / (2.0 * braking) - 1.0).abs() < 1e-9, "{speed}");
            assert!((speed - expected).abs() < 0.05, "{period}: {speed}");
            let limit = ForceLimit::new(ForceComponent::Fz, 1.0);
            let period = Duration::from_millis(period);
            assert!(limit.check_speed(speed - 1e-6, Some(braking), period).is_ok());
            assert_eq!(limit.check_speed(1.0, None, period), Err(NotGuarded::BrakingUnknown));
            assert!(limit.braking(braking).check_speed(speed - 1e-6, None, period).is_ok());
        }
    }

    #[test]
    fn a_braking_beyond_all_measure_leaves_the_way_of_the_reaction() {
        for braking in [1e17, 5e18, 1e300] {
            let speed = permitted(30, braking);
            assert!((speed - 20.0).abs() < 1e-6, "{braking}: {speed}");
        }
    }

    #[test]
    fn a_reaction_beyond_all_measure_is_refused() {
        let limit = |reaction| ForceLimit::new(ForceComponent::Fz, 1.0).reaction(reaction);
        assert!(limit(LONGEST_REACTION).check().is_ok());
        for reaction in [LONGEST_REACTION + Duration::from_nanos(1), Duration::MAX] {
            let error = limit(reaction).check().expect_err("it is too long");
            assert!(error.to_string().contains("reaction"), "{error}");
            assert!(limit(reaction).check_speed(1.0, Some(500.0), Duration::from_millis(8)).is_err());
        }
    }

    #[test]
    fn a_change_counts_in_either_direction_and_from_the_start() {
        let start = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0];
        let fz = ForceLimit::new(ForceComponent::Fz, 5.0);
        assert!(!fz.holds(&start, &[9.0, 9.0, 8.0, 9.0, 9.0, 9.0]));
        assert!(
            fz.holds(&start, &[0.0, 0.0, 8.1, 0.0, 0.0, 0.0]) && fz.holds(&start, &[0.0, 0.0, -2.1, 0.0, 0.0, 0.0])
        );
        let force = ForceLimit::new(ForceComponent::Force, 5.0);
        assert!(
            !force.holds(&start, &[4.0, 6.0, 3.0, 9.0, 9.0, 9.0])
                && force.holds(&start, &[4.0, 6.1, 3.0, 0.0, 0.0, 0.0])
        );
    }
}

//! Into servo mode.

use std::time::Duration;

use jaka_motion::Checker;
use jaka_proto::Command;
use jaka_proto::messages::servo::{IsInServomove, ServoJ, SetServoMode, SetServoMoveFilter};
use jaka_proto::messages::types::Switch;
use jaka_sync::layer::ClientParts as _;

use super::course::Course;
use super::departure::Departure;
use super::pace::{CYCLE, Pace};
use super::rates::Rates;
use super::{LedArm, ServoConfig, ServoSession, SessionConfig};
use crate::arm::{Arm, Sending};
use crate::limits::LimitChecks;
use crate::{Cause, Error, Report, Rest, ServoModeState};

impl<'r> ServoSession<'r> {
    /// Enters servo mode for set-points that a program gives.
    pub(crate) fn enter(led: LedArm<'r>, config: &SessionConfig) -> Result<Self, Error> {
        Self::enter_if(led, (&config.servo, config.rates), |_, _| Ok(()))
    }

    /// Enters servo mode for set-points that are made within the limits of the robot.
    pub(crate) fn lead(
        led: LedArm<'r>,
        config: &ServoConfig,
        check: impl FnOnce(&mut Arm, &mut LimitChecks) -> Result<(), Error>,
    ) -> Result<Self, Error> {
        Self::enter_if(led, (config, Rates::default()), check)
    }

    /// Enters servo mode, unless what is asked of the arm at rest says otherwise. Nothing that changes something was
    /// sent by then.
    fn enter_if(
        led: LedArm<'r>,
        (config, rates): (&ServoConfig, Rates),
        check: impl FnOnce(&mut Arm, &mut LimitChecks) -> Result<(), Error>,
    ) -> Result<Self, Error> {
        let LedArm { arm, limits, has_motions, settling } = led;
        config.check_step_count()?;
        rates.check_themselves()?;
        let priority = config.take_priority()?;
        let not_sent = |error: Error| error.before(SetServoMode::INFO.name);
        rest(arm, (has_motions, settling), config.enter_timeout)?;
        let owner = arm.link().new_owner();
        let leading = Some(arm.lead(owner).map_err(not_sent)?);
        let (frame_changes, under_way, since_packet) =
            (arm.link().frame_changes(), arm.under_way(), arm.state.now_on());
        let servo_mode = arm.queries().call(&IsInServomove::new()).map_err(|error| not_sent(error.into()))?;
        if servo_mode.in_servo_mode {
            return Err(arm.not_ready(ServoModeState::OnAlready));
        }
        check(arm, limits).map_err(not_sent)?;
        limits.forget_plan();
        if let Some(filter) = &config.filter {
            let gate = arm.gate(Sending::SetPoint);
            let client = arm.client();
            let set = client.call_through(Some(&gate), filter, client.timeout_of(SetServoMoveFilter::INFO));
            set.map_err(|error| not_sent(error.into()))?;
        }
        let mut session = Self {
            pace: Pace::new(arm.clock(), config.period(), config.busy_wait),
            since: arm.clock().stopwatch(),
            report: Report::of_set_points(arm.absent()),
            under_way,
            arm,
            limits,
            owner,
            lead: leading,
            config: config.clone(),
            rates,
            course: Course::unknown(),
            departure: Departure::new(None, config.period().as_secs_f64()),
            rest: Rest::NotSeen,
            refusal: None,
            since_packet,
            news: None,
            is_led_by_hand: false,
            has_departed: false,
            begun: None,
            is_open: true,
            ended: None,
            priority,
        };
        match session.switch_on() {
            Ok(course) => {
                let start = course.last_joints().map(|[_, last]| last);
                session.departure = Departure::new(start, config.period().as_secs_f64());
                session.course = course;
                session.arm.moved_after(frame_changes);
                session.pace = Pace::new(session.arm.clock(), config.period(), config.busy_wait);
                Ok(session)
            }
            Err(error) => Err(session.end(error)),
        }
    }

    /// Switches servo mode on, and returns the place of the arm in it.
    fn switch_on(&mut self) -> Result<Course, Error> {
        let gate = self.arm.gate(Sending::SetPoint);
        let (client, timeout) = (self.arm.client(), self.config.enter_timeout);
        let on =
            client.call_through(Some(&gate), &SetServoMode::new(Switch::On), client.timeout_of(SetServoMode::INFO));
        if let Err(error) = on.map_err(Error::from) {
            // Servo mode need not be left if the command was not sent or was refused.
            self.is_open = error.may_have_run();
            return Err(error);
        }
        self.start(timeout).map_err(|error| error.before(ServoJ::INFO.name))
    }

    /// Place of the arm in servo mode, before the first set-point.
    fn start(&mut self, timeout: Duration) -> Result<Course, Error> {
        self.wait_until_entered(timeout)?;
        let start = self.arm.client().get_joint_pos()?.joint_position;
        let pose = self.arm.position.tcp_pose(timeout)?;
        self.limits.prepare_set_points(self.arm, (start, pose), ServoJ::INFO.name, timeout)?;
        if let Some(limits) = self.limits.checker().map(Checker::limits) {
            let (motions, stops) = (*limits.joint_accelerations(), limits.stop_accelerations());
            self.rates.joint_acceleration = motions;
            self.rates.joint_deceleration = std::array::from_fn(|joint| motions[joint].max(stops[joint]));
        }
        Ok(Course::at(start, pose))
    }

    /// The acknowledgement of `servo_move` comes before the mode has changed, and also if it does not change.
    fn wait_until_entered(&mut self, timeout: Duration) -> Result<(), Error> {
        let since = self.arm.clock().stopwatch();
        let mut pace = Pace::new(self.arm.clock(), CYCLE, Duration::ZERO);
        while !self.arm.client().call(&IsInServomove::new())?.in_servo_mode {
            if since.passed() > timeout {
                return Err(self.arm.not_ready(ServoModeState::NotEntered));
            }
            pace.wait();
        }
        Ok(())
    }
}

/// Waits until the arm is at rest, by the controller's answers, and checks that it rests for the time of `settling`.
/// While it moves, controllers acknowledge servo mode and do not enter it.
fn rest(arm: &mut Arm, (has_motions, settling): (bool, Duration), timeout: Duration) -> Result<(), Error> {
    arm.link().check_open(SetServoMode::INFO.name)?;
    arm.check_acknowledged()?;
    if has_motions {
        return Err(arm.not_ready(Cause::Moving));
    }
    arm.known_status(timeout)?;
    // Packets may be old: the controller says whether it moves.
    let not_sent = |error: Error| error.before(SetServoMode::INFO.name);
    arm.position.wait_for_rest(timeout).map_err(not_sent)?;
    let stays = settling.is_zero() || arm.position.place_still_for(settling, timeout).map_err(not_sent)?.is_some();
    if stays { Ok(()) } else { Err(arm.not_ready(Cause::Moving)) }
}

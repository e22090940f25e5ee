//! An arm as a user of this SDK has it: a robot with its monitor, and a servo session.

use std::sync::Barrier;
use std::time::{Duration, Instant};

use jaka_benches::system::child::Addresses;
use jaka_robot::{Client, Config, Monitor, Robot, ServoConfig};

use super::Tally;

/// Between two set-points.
pub(crate) const PERIOD: Duration = Duration::from_millis(8);

pub(crate) fn run(robot: Addresses, offset: Duration, time: Duration, stages: &[Barrier; 3]) -> Result<Tally, String> {
    let connected = connect(robot);
    stages[0].wait();
    std::thread::sleep(offset);
    let ran = connected.and_then(|mut robot| servo(&mut robot, time).map(|tally| (tally, robot)));
    stages[1].wait();
    stages[2].wait();
    let (mut tally, robot) = ran.map_err(|error| error.to_string())?;
    tally.packets = robot.monitor().statistics().packets;
    Ok(tally)
}

fn connect(robot: Addresses) -> Result<Robot, jaka_robot::Error> {
    let monitor: Monitor = Monitor::connect_with(&Config::new(), robot.status)?;
    Ok(Robot::new(Client::connect(robot.commands)?, monitor)?)
}

fn servo(robot: &mut Robot, time: Duration) -> Result<Tally, jaka_robot::Error> {
    let mut session = robot.enter_servo_mode(ServoConfig::new().max_unanswered(Duration::from_secs(30)))?;
    let since = Instant::now();
    while since.elapsed() < time {
        session.send_joint_offset([0.0; 6])?;
    }
    let due = since.elapsed().as_nanos() / PERIOD.as_nanos();
    let report = session.land()?.report;
    Ok(Tally {
        cycles: report.cycles,
        lost: u64::try_from(due).unwrap_or_default().saturating_sub(report.cycles),
        late: report.late_cycles,
        answered: report.accepted,
        packets: 0,
    })
}

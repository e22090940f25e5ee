//! Faults of a link while a motion runs under a guard.

use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::program::StopProgram;
use jaka_robot::{Cause, Command, MotionExt as _};
use jaka_sim::{Direction, LinkFault, Port};
use jaka_tests::simulated::{beside, until};

use super::{IO, count, names, simulated, wait_for_motion};

/// Maximum age of a fresh status packet, and timeout for replies.
const SHORT: Duration = Duration::from_millis(1500);

/// The deadline of the motion, which takes some eight seconds.
const DEADLINE: Duration = Duration::from_secs(6);

/// A fault of a link.
#[derive(Debug, Clone, Copy)]
struct Case {
    port: Port,
    direction: Direction,
    fault: LinkFault,
}

/// Each fault in each direction of each port.
fn cases() -> Vec<Case> {
    let faults = [
        LinkFault::Hold,
        LinkFault::Delay(Duration::from_millis(20)),
        LinkFault::Delay(Duration::from_secs(10)),
        LinkFault::Slow(1_000_000),
        LinkFault::Slow(10),
        LinkFault::Cut,
    ];
    let directions = [Direction::ToController, Direction::ToClient];
    let of =
        |port| directions.into_iter().flat_map(move |direction| faults.map(|fault| Case { port, direction, fault }));
    Port::ALL.into_iter().flat_map(of).collect()
}

impl Case {
    /// True if what goes this way comes, and in time.
    fn passes(self, port: Port, direction: Direction) -> bool {
        let is_in_time = match self.fault {
            LinkFault::Delay(time) => time < SHORT,
            LinkFault::Slow(rate) => rate > 1000,
            _ => false,
        };
        (self.port, self.direction) != (port, direction) || is_in_time
    }

    fn has_packets(self) -> bool {
        self.passes(Port::Status, Direction::ToClient)
    }

    fn has_requests(self) -> bool {
        self.passes(Port::Command, Direction::ToController)
    }

    fn has_replies(self) -> bool {
        self.passes(Port::Command, Direction::ToClient)
    }
}

/// Runs a motion, which something befalls on its way together with an input that trips the guard.
fn run(case: Case) {
    let (arm, mut robot) = simulated().config(|config| config.stale_after(SHORT).reply_timeout(SHORT)).with_robot();
    let clock = arm.clock();
    let motion = JointMove::absolute([100.0, 90.0, 90.0, 90.0, -90.0, 0.0], 12.0).acceleration(500.0);
    let strike = || {
        wait_for_motion(&arm);
        arm.link(case.port).direction(case.direction).set(case.fault);
        arm.set_state(|state| state.digital_inputs[0] = true);
    };
    let since = clock.elapsed();
    let end = beside(clock, strike, || robot.run(&motion.guard(IO.cabinet(1).rises()), DEADLINE));
    let took = clock.elapsed().saturating_sub(since);
    assert!(took < DEADLINE + 3 * SHORT, "{case:?}: {took:?}");
    let end = end.unwrap_or_else(|error| panic!("{case:?}: the reply came before: {error}"));
    assert!(!matches!(end.cause(), Cause::Reached | Cause::AtRest), "{case:?}: {end:?}");
    if case.has_requests() {
        assert_eq!(count(&arm, StopProgram::INFO.name), 1, "{case:?}: {:?}", names(&arm));
        until(clock, || arm.state().at_rest);
        assert!(arm.state().joint_position.0[0] < 99.0, "{case:?}: the arm went on to its target");
    } else {
        assert!(matches!(&end.stop, Some(Err(_))), "{case:?}: {:?}", end.cause());
    }
    match end.cause() {
        Cause::Guard => assert!(case.has_packets(), "{case:?}: no packet can have shown it: {end:?}"),
        Cause::StatusLost => assert!(!case.has_packets(), "{case:?}: {:?}", end.cause()),
        Cause::CommandsLost => assert!(!case.has_replies(), "{case:?}: {:?}", end.cause()),
        other => panic!("{case:?}: {other:?}"),
    }
    // Whether a stop was accepted is told as it was: what was not may not be taken for it.
    let is_accepted = matches!(&end.stop, Some(Ok(())));
    assert_eq!(is_accepted, case.has_requests() && case.has_replies(), "{case:?}: {:?}", end.cause());
    assert_eq!(end.guarded().is_ok(), is_accepted && case.has_packets(), "{case:?}");
}

#[test]
fn no_fault_of_a_link_leaves_an_arm_unstopped_that_can_be_reached() {
    cases().into_iter().for_each(run);
}

//! A check before a robot is used: what it sends, and what it says if it cannot read. `jaka-cli/src/tests/check.rs` has
//! what it finds.

use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model, Region};
use jaka_robot::preflight::{CheckItem, Finding, Preflight, Verdict};
use jaka_robot::{Robot, RobotConfig};
use jaka_sim::{Fault, Firmware, Port, StatusFault};
use jaka_spec::Effect;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, spec};
use serde_json::Value;

fn healthy(firmware: Firmware) -> Arm {
    let arm = Arm::simulated().controller(|controller| controller.firmware(firmware));
    arm.config(|config| config.reply_timeout(Duration::from_secs(1))).start()
}

/// A robot that has no packet yet.
fn connect(arm: &Arm) -> Robot {
    Robot::connect_at(&arm.config(), arm.command_addr(), arm.status_addr()).expect("the controller listens")
}

/// The items with this verdict.
fn with(preflight: &Preflight, verdict: Verdict) -> Vec<CheckItem> {
    let findings = preflight.findings().iter().filter(|finding| finding.verdict() == verdict);
    findings.map(Finding::item).collect()
}

#[test]
fn a_check_sends_queries_alone_and_changes_nothing() {
    let spec = spec();
    for firmware in Firmware::ALL {
        let controller = healthy(*firmware);
        controller.set_state(|state| (state.tool_frame_id, state.user_frame_id) = (2, 2));
        // Events of powering up leave the error code.
        controller.clock().sleep(Duration::from_secs(1));
        let before = controller.state();
        let preflight = connect(&controller).preflight();
        assert_eq!(with(&preflight, Verdict::Wrong), [], "{firmware:?}: {preflight}");
        assert_eq!(with(&preflight, Verdict::Look), [], "{firmware:?}: {preflight}");
        assert_eq!(controller.state(), before);
        for request in controller.requests() {
            let json: Value = serde_json::from_str(&request).expect("requests are JSON");
            let command = json["cmdName"].as_str().and_then(|name| spec.command(name)).expect("the spec has it");
            assert_eq!(command.effect, Effect::Query, "{request}");
        }
    }
}

#[test]
fn each_item_has_one_finding_and_what_is_found_has_advice() {
    let controller = healthy(Firmware::default());
    controller.cut_power();
    let preflight = connect(&controller).preflight();
    let items: Vec<_> = preflight.findings().iter().map(Finding::item).collect();
    assert!(items.is_sorted_by(|before, after| before < after), "{items:?}");
    assert_eq!(items.first().zip(items.last()), Some((&CheckItem::CommandPort, &CheckItem::Limits)));
    for finding in preflight.findings() {
        assert_eq!(finding.advice().is_some(), finding.verdict() >= Verdict::Look, "{finding}");
    }
    assert!(preflight.verdict() >= Verdict::Look);
    assert!(preflight.to_string().contains("\"Nothing found\" is not \"safe\""));
}

#[test]
fn after_two_queries_without_a_reply_the_rest_is_not_asked() {
    let controller = healthy(Firmware::default());
    controller.inject_for("is_in_servomove", Fault::Drop);
    controller.inject_for("drag_status", Fault::Drop);
    let preflight = connect(&controller).preflight();
    assert_eq!(with(&preflight, Verdict::Look), [CheckItem::ServoMode, CheckItem::DragMode], "{preflight}");
    let not_asked = [CheckItem::Program, CheckItem::Payload, CheckItem::CollisionLevel];
    assert_eq!(with(&preflight, Verdict::NotChecked), not_asked, "{preflight}");
    assert!(controller.requests().last().is_some_and(|last| last.contains("drag_status")));
}

#[test]
fn a_robot_with_limits_is_compared_with_these() {
    let controller = healthy(Firmware::default());
    let high = Region::half_space("gantry", [0.0, 0.0, 2500.0], [0.0, 0.0, 1.0]).expect("it has a direction");
    let limits =
        Limits::of(Model::named("Zu 5").expect("a published arm")).with_region(high).expect("it is the only one");
    let preflight =
        connect(&controller).configured(&RobotConfig::new().limits(limits)).expect("the model agrees").preflight();
    let limits = preflight.findings().iter().find(|finding| finding.item() == CheckItem::Limits).expect("it has one");
    assert_eq!(limits.verdict(), Verdict::Look);
    assert!(limits.seen().contains("beyond `gantry` (Zu 5)"), "{limits}");
    assert_eq!(with(&preflight, Verdict::Look), [CheckItem::Limits], "{preflight}");
    // Without the robot's limits, the published ones count.
    let preflight = connect(&controller).preflight();
    assert_eq!(with(&preflight, Verdict::Look), [], "{preflight}");
}

#[test]
fn a_robot_whose_connections_are_broken_is_checked_at_once() {
    let controller = healthy(Firmware::default());
    let mut robot = controller.robot();
    controller.disconnect();
    // The monitor has seen the end.
    controller.clock().sleep(Duration::from_millis(1));
    let preflight = robot.preflight();
    assert_eq!(with(&preflight, Verdict::Wrong), [CheckItem::CommandPort, CheckItem::StatusPort], "{preflight}");
    assert_eq!(with(&preflight, Verdict::NothingFound), [], "{preflight}");
}

/// The held packets pass the link in 80 ms, while the check ends.
#[test]
fn a_packet_that_a_link_may_have_held_back_is_not_told_as_the_present() {
    let controller = healthy(Firmware::default());
    let mut robot = controller.robot();
    let clock = controller.clock();
    let held = || {
        controller.link(Port::Status).to_client().hold();
        clock.sleep(Duration::from_millis(600));
        controller.press_emergency_stop();
        clock.sleep(Duration::from_millis(370));
        controller.link(Port::Status).to_client().slow(1_500_000);
    };
    let preflight = beside(clock, held, || robot.preflight());
    let stop = preflight.findings().iter().find(|finding| finding.item() == CheckItem::EmergencyStop);
    assert!(stop.is_some_and(|stop| stop.verdict() == Verdict::Wrong), "{preflight}");
}

#[test]
fn packets_that_stay_away_are_not_told_as_the_present() {
    let controller = healthy(Firmware::default());
    let mut robot = controller.robot();
    controller.status_fault(StatusFault::Silent);
    let preflight = robot.preflight();
    assert_eq!(with(&preflight, Verdict::Wrong), [CheckItem::StatusPort], "{preflight}");
    let not_checked = with(&preflight, Verdict::NotChecked);
    for item in [CheckItem::StatusPackets, CheckItem::StatusRate, CheckItem::EmergencyStop, CheckItem::Event] {
        assert!(not_checked.contains(&item), "{item:?}: {preflight}");
    }
}

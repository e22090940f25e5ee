//! `jaka follow`, as its users run it: `src/tests/follow.rs` has how it ends.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::{Child, Stdio};

use expect_test::expect;
use jaka_motion::Model;
use jaka_motion::proto::messages::types::Pose;
use jaka_sim::Controller;
use jaka_tests::Arm;
use serde_json::{Value, json};

#[cfg(unix)]
use crate::common::{interrupt, wait_until};
use crate::program::{address_of, command, jaka, result, scratch, without_late_answer};

const WAY: &str = "\
time_s,joint_1_deg,joint_2_deg,joint_3_deg,joint_4_deg,joint_5_deg,joint_6_deg
0,0,90,90,90,-90,0
1,4,90,90,90,-90,-6
2,0,90,90,90,-90,0
";

/// A file of this name with a trajectory, the same or this many times as slow.
fn way(name: &str, factor: f64) -> String {
    let path = scratch(name);
    let text = WAY.replace("\n1,", &format!("\n{factor},")).replace("\n2,", &format!("\n{},", 2.0 * factor));
    fs::write(&path, text).expect("it can be written");
    path.display().to_string()
}

/// The arm where the trajectory starts.
fn arm() -> Arm {
    Arm::real_time().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]).start()
}

fn started(controller: &Controller, file: &str, options: &str) -> Child {
    let words = ["follow", file, "--model", "zu5"].into_iter().chain(options.split_whitespace()).map(str::to_owned);
    let mut command = command(words.chain(address_of(controller)));
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// A file of this name with a quarter of a circle of the tool around the first pose's axis, each millimetre or so.
fn seam(name: &str) -> String {
    let path = scratch(name);
    let arm = Model::named("Zu 5").expect("a published arm");
    let first = Pose::from(arm.forward(SEAM_START));
    let mut text = "# a seam\nx_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
    for step in 0..=100 {
        let (sin, cos) = (f64::from(step) * 0.0157).sin_cos();
        let (x, y) = (first.x + 60.0 * (cos - 1.0), first.y + 60.0 * sin);
        let _ = writeln!(text, "{x},{y},{},{},{},{}", first.z, first.rx, first.ry, first.rz);
    }
    fs::write(&path, text).expect("it can be written");
    path.display().to_string()
}

const SEAM_START: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
const NEAR: &str = "0,60,-80,190,-90,0";

#[test]
fn points_without_times_are_planned() {
    let file = seam("seam.csv");
    let dry = |options: &str| {
        let words = ["follow", &*file, "--model", "zu5", "--dry-run"].map(str::to_owned);
        jaka(words.into_iter().chain(options.split_whitespace().map(str::to_owned)))
    };
    let known = dry(&format!("--within-mm 0.2 --tool-speed 50 --near {NEAR}"));
    assert!(known.out.starts_with("101 way-points, 2.") && known.code == Some(0), "{}", known.text());
    let slow = dry(&format!("--within-mm 0.2 --tool-speed 5000 --near {NEAR}"));
    assert!(slow.out.contains(" % of the tool's speed, limited by the "), "{}", slow.text());
    for (options, expected) in [
        ("--within-mm 0.2", "give joint positions near it, or a first way-point in joints (--near)"),
        ("", "its points have no times: --within-mm or --within-deg plans a smooth curve near them"),
    ] {
        let refused = dry(options);
        assert!(refused.err.contains(expected) && refused.code == Some(2), "{}", refused.text());
    }
    let json = PathBuf::from(seam("seam.json"));
    let points = r#"{"points": [{"joints_deg": [0, 60, -80, 190, -90, 0]}, {"joints_deg": [5, 60, -80, 190, -90, 0]},
        {"joints_deg": [5, 70, -80, 190, -90, 0], "corner_deg": 0}, {"joints_deg": [0, 70, -80, 190, -90, 0]}]}"#;
    fs::write(&json, points).expect("it can be written");
    let picture = json.with_extension("svg").display().to_string();
    let words = ["follow", &json.display().to_string(), "--model", "zu5", "--dry-run", "--corner-deg", "1"];
    let of_json = jaka(words.into_iter().chain(["--tool-speed", "500", "-o", &picture]).map(str::to_owned));
    assert!(of_json.out.starts_with("4 way-points, ") && of_json.code == Some(0), "{}", of_json.text());
    let drawn = fs::read_to_string(picture).expect("it was written");
    assert!(drawn.contains("slow") && drawn.contains(" %"), "slow places are marked");
    let timed = way("timed.csv", 1.0);
    let refused = jaka(["follow", &*timed, "--model", "zu5", "--dry-run", "--within-deg", "1"]);
    assert!(refused.err.contains("its points have times: ") && refused.code == Some(2), "{}", refused.text());
}

#[test]
fn a_dry_run_prints_what_was_checked_and_draws_it() {
    let (file, picture) = (way("way.csv", 1.0), scratch("way.svg"));
    let svg = picture.display().to_string();
    let run = jaka(["follow", &*file, "--model", "zu5", "--dry-run", "-o", &*svg]);
    expect![[r#"
        3 way-points, 2.000 s, within the limits of the Zu 5; nothing was sent

                               highest speed        largest acceleration
        joint 1             7.1 of 180 deg/s           48.0 of 72 deg/s²
        joint 2             0.0 of 180 deg/s            0.0 of 72 deg/s²
        joint 3             0.0 of 180 deg/s            0.0 of 72 deg/s²
        joint 4             0.0 of 180 deg/s            0.0 of 72 deg/s²
        joint 5             0.0 of 180 deg/s            0.0 of 72 deg/s²
        joint 6            10.7 of 180 deg/s           72.0 of 72 deg/s²
        flange                     61.5 mm/s
        exit code 0
    "#]]
    .assert_eq(&run.text());
    let drawn = fs::read_to_string(&picture).expect("it was written");
    assert!(drawn.starts_with("<svg ") && drawn.len() < 600_000, "{} bytes", drawn.len());
    for text in
        ["position in deg", "speed in deg/s", "acceleration in deg/s²", "joint 6", "y in mm", "z in mm", "start", "end"]
    {
        assert!(drawn.contains(text), "{text}");
    }
    let run = jaka(["follow", &*file, "--model", "zu5", "--dry-run", "--json"]);
    let said: Value = serde_json::from_str(&run.out).expect("it is JSON");
    assert_eq!((&said["duration_s"], &said["start_deg"][1]), (&2.0.into(), &90.0.into()));
    assert_eq!(
        (&said["way_points"][2], &said["way_points"][3]),
        (&json!({"time_s": 2.0, "passing": "stops"}), &Value::Null)
    );
    assert!(said["highest_speeds_deg_s"][5].as_f64() > Some(6.0), "{said}");
}

#[test]
fn what_is_wrong_with_a_file_is_told_at_its_place() {
    let file = scratch("wrong.csv");
    fs::write(&file, WAY.replace("4,90", "4,ninety")).expect("it can be written");
    let file = file.display().to_string();
    let run = jaka(["follow", &*file, "--model", "zu5", "--dry-run"]);
    assert_eq!((run.code, run.out.as_str()), (Some(2), ""));
    assert_eq!(run.err, format!("error: {file}:3:1: joint_2_deg: found `ninety`, expected a finite number\n"));
    let fast = way("fast.csv", 0.1);
    let run = jaka(["follow", &*fast, "--model", "zu5", "--dry-run"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("fast.csv: after way-point ") && run.err.contains(" would accelerate by "), "{}", run.err);
    for (words, said) in [
        (vec!["follow", &*fast, "--dry-run"], "give --model or --limits"),
        (vec!["follow", "way.txt", "--model", "zu5"], "cannot read way.txt"),
        (vec!["follow", &*fast, "--model", "zu5", "--scale", "1.5"], "not a number from 0.001 to 1"),
    ] {
        let run = jaka(words);
        assert!(run.code == Some(2) && run.err.contains(said), "{}", run.text());
    }
}

#[test]
fn it_asks_before_the_arm_moves() {
    let controller = arm();
    let run = result(started(&controller, &way("way.csv", 1.0), ""));
    expect![[r#"
        error: the arm was not moved: there is no terminal to ask on; use --yes to move it anyway
        exit code 2
    "#]]
    .assert_eq(&run.text());
    assert!(controller.requests().is_empty());
}

#[cfg(unix)]
#[test]
fn an_interrupt_stops_it_on_the_trajectory_and_says_so() {
    let controller = arm();
    let child = started(&controller, &way("slow.csv", 60.0), "--yes");
    wait_until("set-points come", || controller.requests().iter().any(|request| request.contains("servo_j")));
    interrupt(&child);
    let run = result(child);
    if run.code == Some(22) {
        let text = without_late_answer(&run);
        let lines: Vec<_> = text.lines().collect();
        // An interrupt right after the first set-point may come before `jaka` has the run's handle. The same test in
        // simulated time is certain of its moment.
        let has_stopped = match lines[0] {
            "note: interrupted: the arm stops on its trajectory; interrupt again to send `stop_program`, too" => false,
            "note: interrupted: the controller accepted the stop (`stop_program`)" => true,
            _ => panic!("{}", run.text()),
        };
        assert!(lines[1].starts_with("error: the motion was stopped before its target ("), "{}", run.text());
        assert!(lines[1].ends_with(" s of 120.000 s of the trajectory), and the arm is at rest"), "{}", run.text());
        assert!(!controller.state().servo_mode);
        assert_eq!(controller.requests().iter().any(|request| request.contains("stop_program")), has_stopped);
    } else {
        // A machine may hold up the program or the controller.
        assert!(matches!(run.code, Some(4 | 28 | 30)), "{}", run.text());
    }
}

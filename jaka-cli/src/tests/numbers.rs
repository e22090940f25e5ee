//! Numeric options of `jaka follow`, `move` and `jog`, with numbers that nobody would give.

use std::fs;

use super::{Run, scratch, without_robot};

const ODD: [&str; 13] =
    ["nan", "inf", "-inf", "1e999", "1e308", "-1e308", "1e154", "1e-154", "1e-300", "5e-324", "0", "-1", "1"];

/// Numbers among them that are a place or a distance.
const SMALL: [&str; 6] = ["1e-154", "1e-300", "5e-324", "0", "-1", "1"];

/// Writes points without times to a file: the arm turns, and then moves on.
fn points() -> String {
    let path = scratch("way.csv");
    let text = "joint_1_deg,joint_2_deg,joint_3_deg,joint_4_deg,joint_5_deg,joint_6_deg\n\
                0,90,90,90,-90,0\n4,90,90,90,-90,0\n4,94,90,90,-90,0\n";
    fs::write(&path, text).expect("it can be written");
    path.display().to_string()
}

/// Runs a line, which sends nothing, with each odd number, and returns the runs that have accepted theirs.
fn accepted(line: &str) -> Vec<&'static str> {
    let is_accepted = |odd: &&'static str| {
        let Run { code, out, err } = without_robot(line.replace("ODD", odd).split(' '));
        assert!(code == 0 || code == 2 || code == 20, "{line} {odd}: {code} {err}");
        assert_eq!(out.is_empty(), code != 0, "{line} {odd}: {out}");
        let named = line.split(' ').find(|word| word.contains("ODD")).unwrap_or_default();
        let field = named.trim_start_matches('-').split('=').next().unwrap_or_default();
        let has_name = [field, "joint", "DISTANCE", "limit"].iter().any(|name| err.contains(name));
        assert!(code == 0 || err.starts_with("error: ") && has_name, "{line} {odd}: {err}");
        code == 0
    };
    ODD.into_iter().filter(is_accepted).collect()
}

#[test]
fn follow_names_an_option_that_makes_no_sense() {
    let follow = |options: &str| accepted(&format!("follow {} --model zu5 --dry-run {options}", points()));
    assert_eq!(follow("--within-deg=ODD"), ["1"]);
    assert_eq!(follow("--within-deg=0.1 --within-mm=ODD"), ["1"]);
    assert_eq!(follow("--corner-deg=ODD"), ["0", "1"]);
    assert_eq!(follow("--corner-deg=1 --corner-mm=ODD"), ["0", "1"]);
    assert_eq!(follow("--corner-deg=1 --tool-speed=ODD"), ["1"]);
    assert_eq!(follow("--corner-deg=1 --approach=ODD"), ["1"]);
    assert_eq!(follow("--corner-deg=1 --scale=ODD"), ["1"]);
    assert_eq!(follow("--corner-deg=1 --near=ODD,90,90,90,-90,0"), SMALL);
    let wrong = without_robot(format!("follow {} --model zu5 --dry-run --within-mm nan", points()).split(' '));
    assert_eq!(
        wrong.err.lines().next(),
        Some("error: `--within-mm <MM>` cannot be `nan`: not a number from 0.001 to 1e9")
    );
}

#[test]
fn move_and_jog_name_an_option_that_makes_no_sense() {
    let moved = "move --joints=0,90,90,90,-90,0 --dry-run";
    assert_eq!(accepted(&format!("{moved} --speed=ODD")), ["1"]);
    assert_eq!(accepted(&format!("{moved} --speed=1 --acceleration=ODD")), ["1"]);
    assert_eq!(accepted("move --joints=0,ODD,90,90,-90,0 --dry-run --speed=1 --acceleration=1 --model zu5"), SMALL);
    assert_eq!(accepted("jog 1 --dry-run --speed=1 --acceleration=1 --model zu5 -- ODD"), SMALL);
    assert_eq!(accepted("jog z --dry-run --speed=1 --acceleration=1 --model zu5 -- ODD"), SMALL);
    assert_eq!(accepted("move --pose=0,ODD,90,90,-90,0 --dry-run --speed=1"), SMALL);
}

#[test]
fn a_limit_that_makes_no_sense_is_named_in_its_file() {
    let (points, limits) = (points(), scratch("cell.toml"));
    for jerk in ["1e308", "nan", "inf", "0", "-1", "5e-324"] {
        fs::write(&limits, format!("model = \"Zu 5\"\n[joints]\njerk_deg_s3 = {jerk}\n")).expect("it can be written");
        let line = format!("follow {points} --limits {} --dry-run --within-deg 1", limits.display());
        let run = without_robot(line.split(' '));
        assert!(run.code == 2 && run.err.contains("cell.toml:3:15: ") && run.err.contains("jerk"), "{jerk}: {run:?}");
    }
}

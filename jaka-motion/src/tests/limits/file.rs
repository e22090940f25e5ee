//! Limits from a file.

use crate::{Limits, Model, Point, RegionFrame};

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    let errors = Limits::from_toml(text, "cell.toml").expect_err("something is wrong").to_string();
    assert_eq!(errors.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn a_model_alone_has_the_defaults() {
    let limits = Limits::from_toml("model = \"jaka_zu18\"", "cell.toml").expect("nothing is wrong");
    assert_eq!(limits, Limits::of(Model::named("Zu 18").expect("published")));
}

#[test]
fn what_is_stated_counts() {
    let text = r#"
        model = "MiniCobo"
        joints = { min_deg = [-90, -100, -110.5, -90, -120, 0x10], speed_deg_s = [10, 20, 30, 40, 50, 60] }
        tcp.speed_mm_s = 1e2
        [[box]]
        name = "cell"
        of = "wrist"
        frame = "base"
        keep = "inside"
        min_mm = [-500, -500, 0]
        max_mm = [500, 500, 900.5]
    "#;
    let limits = Limits::from_toml(text, "cell.toml").unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(limits.joint_min().to_vec(), [-90.0, -100.0, -110.5, -90.0, -120.0, 16.0]);
    assert_eq!(limits.joint_max().to_vec(), Model::named("MiniCobo").expect("published").joint_max());
    assert_eq!((limits.joint_speeds()[3], limits.tcp_speed()), (40.0, Some(100.0)));
    let region = &limits.regions()[0];
    assert_eq!((region.point(), region.frame(), &**region.name()), (Point::Wrist, RegionFrame::ArmBase, "cell"));
}

#[test]
fn all_that_is_wrong_is_said_at_once() {
    let text = r#"model = "Zu 55"
colour = "red"
[joints]
min_deg = [1, 2, 3]
max_deg = [1, 2, 3, 4, 5, nan]
speed_deg_s = "fast"
[tcp]
speed_mm_s = 0
[singularity]
least_distance = 1.5
[[box]]
name = "a"
of = "hand"
frame = "user"
kep = "inside"
min_mm = [0, 0]
max_mm = [1, 1, inf]
"#;
    check(
        text,
        &[
            "cell.toml:1:9: there is no arm `Zu 55`; is it `Zu 5`?",
            "cell.toml:2:1: unknown key `colour`; the keys are box, half_space, joints, model, preset, singularity, stop, tcp",
            "cell.toml:4:11: joints: `min_deg` must be a finite number, or a list of six",
            "cell.toml:5:11: joints: `max_deg` must be a finite number, or a list of six",
            "cell.toml:6:15: joints: `speed_deg_s` must be a finite number, or a list of six",
            "cell.toml:8:14: speed of the tool centre point: 0 is not from 0.001 to 1e9",
            "cell.toml:10:18: distance from a singularity: 1.5 is not from 0 to below 1",
            "cell.toml:11:1: box `a`: `keep` is missing",
            "cell.toml:13:6: box `a`: `of` must be \"tcp\" or \"elbow\" or \"wrist\"",
            "cell.toml:15:1: box `a`: unknown key `kep`; is it `keep`?",
            "cell.toml:16:10: box `a`: `min_mm` must be a list of three finite numbers",
            "cell.toml:17:10: box `a`: `max_mm` must be a list of three finite numbers",
        ],
    );
}

#[test]
fn a_limit_that_is_wrong_is_named_at_its_number() {
    let text = r#"model = "Zu 5"
[joints]
min_deg = [-360, -90, -175, 20, 0, 0]
max_deg = [360, 265, 175, 10, 400, 0]
speed_deg_s = [180, 180, 181, 180, 180, 180]
acceleration_deg_s2 = -1
[[half_space]]
name = "table"
of = "tcp"
frame = "user"
point_mm = [0, 0, 0]
inward = [0, 0, 0]
[[half_space]]
name = "wall"
of = "tcp"
frame = "user"
point_mm = [0, 0, 0]
inward = [0, 0, 1]
[[box]]
name = "wall"
of = "tcp"
frame = "user"
keep = "outside"
min_mm = [0, 0, 0]
max_mm = [1, 1, 1]
"#;
    check(
        text,
        &[
            "cell.toml:3:18: joint 2: -90 deg is beyond the -85 deg of the Zu 5; a limit can only be tighter",
            "cell.toml:3:29: joint 4: the range from 20 to 10 deg is empty",
            "cell.toml:4:31: joint 5: 400 deg is beyond the 360 deg of the Zu 5; a limit can only be tighter",
            "cell.toml:5:26: joint 3: 181 deg/s is beyond the 180 deg/s of the Zu 5; a limit can only be tighter",
            "cell.toml:6:23: joint acceleration: -1 is not from 0.001 to 1e9",
            "cell.toml:7:1: half-space `table`: the inward direction has no length",
            "cell.toml:13:1: two regions are called `wall`",
        ],
    );
}

#[test]
fn what_is_not_toml_is_said_too() {
    for text in
        ["model = ", "= 5", "[joints", "model = \"Zu 5\"\nmodel = \"Zu 7\"", "\u{0}", "box = 5", "[[joints]]\nx=1"]
    {
        let errors = Limits::from_toml(text, "cell.toml").expect_err(text);
        assert!(errors.iter().all(|error| error.line >= 1 && error.path == "cell.toml"), "{errors}");
    }
    check("", &["cell.toml:1:1: `model` is missing"]);
}

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
fn a_key_or_type_that_is_wrong_is_said_at_its_place() {
    let region = "model = 'Zu 5'\n[[box]]\nname = 'a'\nof = 'tcp'\nframe = 'user'\n";
    for (text, expected) in [
        (
            "colour = 'red'",
            "cell.toml:1:1: unknown field `colour`, expected one of `model`, `dh`, `preset`, `joints`, `tcp`, `stop`, \
             `singularity`, `box`, `half_space`",
        ),
        ("", "cell.toml:1:1: missing field `model`"),
        (
            "[joints]\nmin_deg = [1, 2, 3, 4, 5, 6, 7]",
            "cell.toml:2:11: expected a number, or a list of six in `joints.min_deg`",
        ),
        (
            "stop.joint_jerk_deg_s3 = 'x'",
            "cell.toml:1:26: expected a number, or a list of six in `stop.joint_jerk_deg_s3`",
        ),
        ("[tcp]\nspeed_mm_s = '0'", "cell.toml:2:14: invalid type: string \"0\", expected f64 in `tcp.speed_mm_s`"),
        (
            &format!("{region}keep = 'inside'\nmin_mm = [0, 0]\nmax_mm = [1, 1, 1]"),
            "cell.toml:7:10: expected three numbers, found 2 in `box.min_mm`",
        ),
        (&format!("{region}min_mm = [0, 0, 0]\nmax_mm = [1, 1, 1]"), "cell.toml:2:1: missing field `keep` in `box`"),
        (
            &region.replace("'tcp'", "'hand'"),
            "cell.toml:4:6: unknown variant `hand`, expected one of `tcp`, `elbow`, `wrist` in `box.of`",
        ),
        (
            "model = 'Zu 55'",
            "cell.toml:1:9: there is no arm `Zu 55`; the arms are Zu 5, Zu 3, Zu 7, Zu 12, Zu 18, Zu 20, Zu 30, Pro 5, \
             Pro 7, Pro 12, Pro 16, Pro 18, S5, S7, S12, C5, C7, C12, A5, A12, MiniCobo",
        ),
    ] {
        check(text, &[expected]);
    }
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
            "cell.toml:3:11: joint 2: -90 deg is beyond the -85 deg of the Zu 5; a limit can only be tighter",
            "cell.toml:4:11: joint 4: the range from 20 to 10 deg is empty",
            "cell.toml:4:11: joint 5: 400 deg is beyond the 360 deg of the Zu 5; a limit can only be tighter",
            "cell.toml:5:15: joint 3: 181 deg/s is beyond the 180 deg/s of the Zu 5; a limit can only be tighter",
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
}

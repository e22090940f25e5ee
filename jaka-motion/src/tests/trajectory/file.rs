//! Way-points from files.

use super::{Random, some_points};
use crate::{TimedPoint, Via};

const CSV: &str = "time_s,joint_1_deg,joint_2_deg,joint_3_deg,joint_4_deg,joint_5_deg,joint_6_deg\n";

#[track_caller]
fn csv_errors(text: &str, expected: &[&str]) {
    let errors = TimedPoint::from_csv(text, "way.csv").unwrap_err().to_string();
    assert_eq!(errors.lines().collect::<Vec<_>>(), expected);
}

#[track_caller]
fn json_errors(text: &str, expected: &[&str]) {
    let errors = TimedPoint::from_json(text, "way.json").unwrap_err().to_string();
    assert_eq!(errors.lines().collect::<Vec<_>>(), expected);
}

/// Points in CSV and in JSON, with the digits that distinguish each number from all others.
fn written(points: &[TimedPoint]) -> [String; 2] {
    let lists = |point: &TimedPoint| {
        let of_motion = [("velocity", "deg_s", point.velocity), ("acceleration", "deg_s2", point.acceleration)];
        let of_motion = of_motion.into_iter().filter_map(|(name, unit, list)| Some((name, name, unit, list?)));
        std::iter::once(("joint", "joints", "deg", point.joints.0)).chain(of_motion).collect::<Vec<_>>()
    };
    let names = lists(&points[0]).into_iter();
    let columns = names.flat_map(|(name, _, unit, _)| (1..=6).map(move |joint| format!(",{name}_{joint}_{unit}")));
    let (mut rows, mut objects) = (vec![format!("time_s{}\n", columns.collect::<String>())], Vec::new());
    for point in points {
        let numbers = lists(point).into_iter().flat_map(|(.., list)| list).map(|number| format!(",{number}"));
        rows.push(format!("{}{}\n", point.time_s, numbers.collect::<String>()));
        let members = lists(point).into_iter().map(|(_, key, unit, list)| format!(", \"{key}_{unit}\": {list:?}"));
        objects.push(format!("{{\"time_s\": {}{}}}", point.time_s, members.collect::<String>()));
    }
    [rows.concat(), format!("{{\"points\": [\n{}\n]}}\n", objects.join(",\n"))]
}

#[test]
fn numbers_are_read_as_they_were_written() {
    let mut random = Random::new(10);
    for round in 0..60 {
        let mut points = some_points(&mut random, 2 + round % 5);
        for point in &mut points {
            point.joints.0[0] = [0.0, -0.0, 1e-300, 1e300, f64::MAX, f64::MIN_POSITIVE][round % 6];
            point.velocity = (round % 3 > 0).then(|| std::array::from_fn(|_| random.between(-1e3, 1e3)));
            point.acceleration = (round % 3 > 1).then(|| std::array::from_fn(|_| random.between(-1e-9, 1e-9)));
        }
        let [csv, json] = written(&points);
        assert_eq!(TimedPoint::from_csv(&csv, "way.csv").expect("it reads"), points);
        assert_eq!(TimedPoint::from_json(&json, "way.json").expect("it reads"), points);
    }
}

#[test]
fn columns_may_come_in_any_order_and_unit() {
    let text = "\u{feff}# from another program\r\n\r\n joint_2_deg, time_s ,\"joint_1_rad\",joint_3_deg,joint_4_deg,joint_5_deg,joint_6_deg\r\n\
                2,0,3.141592653589793,3,4,5,6\r\n# between\r\n \r\n2.5, 1e0 ,+0.5,3,4,5,6";
    let points = TimedPoint::from_csv(text, "way.csv").expect("it reads");
    let expected = [
        TimedPoint::new(0.0, [180.0, 2.0, 3.0, 4.0, 5.0, 6.0]),
        TimedPoint::new(1.0, [0.5_f64.to_degrees(), 2.5, 3.0, 4.0, 5.0, 6.0]),
    ];
    assert_eq!(points, expected);
}

#[test]
fn all_that_is_wrong_with_csv_is_said_with_its_place() {
    csv_errors("", &["way.csv:1:1: found no line, expected one that names the columns"]);
    csv_errors(CSV, &["way.csv:1:1: found 0 points, expected at least 2"]);
    csv_errors(
        "time,joint_1_deg,joint_1_rad,joint_2_deg,joint_3_deg,joint_4_deg,joint_5_deg,velocity_1_deg_s\n0,0,0\n1,x",
        &[
            "way.csv:1:1: column `joint_1_rad` appears twice",
            "way.csv:1:1: there is no column `joint_6_deg` or `joint_6_rad`",
            "way.csv:1:1: there is no column `time_s`",
            "way.csv:1:1: there is no column `velocity_2_deg_s` or `velocity_2_rad_s`",
            "way.csv:1:1: there is no column `velocity_3_deg_s` or `velocity_3_rad_s`",
            "way.csv:1:1: there is no column `velocity_4_deg_s` or `velocity_4_rad_s`",
            "way.csv:1:1: there is no column `velocity_5_deg_s` or `velocity_5_rad_s`",
            "way.csv:1:1: there is no column `velocity_6_deg_s` or `velocity_6_rad_s`",
            "way.csv:1:1: unknown column `time`; they are `time_s`, `joint_1_deg`, `joint_1_rad`, `velocity_1_deg_s`, `velocity_1_rad_s`, `acceleration_1_deg_s2`, `acceleration_1_rad_s2`",
            "way.csv:2:1: found 3 fields, expected 8, as many as columns",
            "way.csv:3:1: found 2 fields, expected 8, as many as columns",
        ],
    );
    let rows = format!("{CSV}0.5,0,0,0,0,0,0\n1,,é,\"1\",nan,1e999,0\n1,0,0,0,0,0,0\n0.9,0,0,0,0,0,1,2\n");
    csv_errors(
        &rows,
        &[
            "way.csv:2:1: time_s: found `0.5`, expected 0, at the first point",
            "way.csv:3:1: joint_1_deg: found ``, expected a finite number",
            "way.csv:3:1: joint_2_deg: found `é`, expected a finite number",
            "way.csv:3:1: joint_4_deg: found `nan`, expected a finite number",
            "way.csv:3:1: joint_5_deg: found `1e999`, expected a finite number",
            "way.csv:4:1: time_s: found `1`, expected more than the 1 before it",
            "way.csv:5:1: found 8 fields, expected 7, as many as columns",
        ],
    );
}

#[test]
fn all_that_is_wrong_with_json_is_said_with_its_place() {
    json_errors("", &["way.json:1:1: not valid JSON: EOF while parsing a value"]);
    json_errors("[1]", &["way.json:1:1: the file: found `[1]`, expected an object"]);
    json_errors(
        "{\n \"point\": 1}",
        &["way.json:1:1: `points` is missing", "way.json:2:11: unknown key `point`; the only key is `points`"],
    );
    json_errors("{\"points\": []}", &["way.json:1:1: found 0 points, expected at least 2"]);
    let text = r#"{"points": [
        {"time_s": 0.1, "joints_deg": [0, 0, 0, 0, 0, 0], "joints_rad": [0, 0, 0, 0, 0]},
        {"time": 1, "joints_deg": [0, 0, true, "0", 0, 1e999], "velocity_rad_s": []},
        {"time_s": 0.1, "time_s": 3, "acceleration_deg_s2": [0, 0, 0, 0, 0, 0]},
        7
    ]}"#;
    json_errors(
        text,
        &[
            "way.json:2:9: time_s: found `0.1`, expected 0, at the first point",
            "way.json:2:73: joints_rad: found 5 numbers, expected 6",
            "way.json:2:73: key `joints_rad` appears twice",
            "way.json:3:9: a point: `time_s` is missing",
            "way.json:3:9: a point: its keys differ from the keys of the first point",
            "way.json:3:18: unknown key `time`; they are `time_s`, `joints_deg`, `joints_rad`, `velocity_deg_s`, `velocity_rad_s`, `acceleration_deg_s2`, `acceleration_rad_s2`",
            "way.json:3:42: joints_deg: found `true`, expected a finite number",
            "way.json:3:48: joints_deg: found `\"0\"`, expected a finite number",
            "way.json:3:56: joints_deg: found `1e999`, expected a finite number",
            "way.json:3:82: velocity_rad_s: found 0 numbers, expected 6",
            "way.json:4:9: a point: `joints_deg` or `joints_rad` is missing",
            "way.json:4:9: a point: `velocity_deg_s` or `velocity_rad_s` is missing",
            "way.json:4:9: a point: its keys differ from the keys of the first point",
            "way.json:4:35: key `time_s` appears twice",
            "way.json:5:9: a point: found `7`, expected an object",
        ],
    );
}

#[test]
fn no_text_makes_a_reader_panic() {
    let mut random = Random::new(11);
    let points = some_points(&mut random, 3);
    for (text, csv) in written(&points).into_iter().zip([true, false]) {
        for _ in 0..2000 {
            let mut text: Vec<char> = text.chars().collect();
            for _ in 0..=random.below(3) {
                #[expect(
                    clippy::cast_precision_loss,
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "small"
                )]
                let at = random.between(0.0, text.len() as f64 - 1.0) as usize;
                text[at] = ['"', ',', '\n', '{', ']', 'é', '0', '\0', '\u{feff}', 'e'][random.below(10)];
            }
            let text: String = text.into_iter().collect();
            let _ = if csv { TimedPoint::from_csv(&text, "way") } else { TimedPoint::from_json(&text, "way") };
        }
    }
}

#[test]
fn of_many_errors_the_first_hundred_are_said_and_the_others_counted() {
    let text = format!("{CSV}{}", "0,x,y,z,0,0,0\n".repeat(100_000));
    let errors = TimedPoint::from_csv(&text, "way.csv").unwrap_err();
    assert_eq!((errors.iter().count(), errors.more()), (100, 399_899));
    let said = errors.to_string();
    assert!(said.starts_with("way.csv:2:1: ") && said.ends_with("\nand 399899 more errors"), "{said}");
}

#[test]
fn points_without_times_are_read_from_json_with_what_is_their_own() {
    let text = r#"{"points": [
        {"joints_rad": [0, 1, 0, 0, 0, 0.5]},
        {"rotation_deg": [180, 0, 1], "position_mm": [1, 2, 3], "tool_speed_mm_s": 50, "corner_mm": 0},
        {"joints_deg": [0, 60, 0, 0, 0, 30], "corner_deg": 2, "corner_turn_deg": 3}
    ]}"#;
    let points = Via::from_json(text, "way.json").expect("it reads");
    let expected = [
        Via::joints([0.0, 1.0_f64.to_degrees(), 0.0, 0.0, 0.0, 0.5_f64.to_degrees()]),
        Via::line([1.0, 2.0, 3.0, 180.0, 0.0, 1.0]).with_tcp_speed(50.0).with_corner_mm(0.0),
        Via::joints([0.0, 60.0, 0.0, 0.0, 0.0, 30.0]).with_corner_deg(2.0).with_corner_turn_deg(3.0),
    ];
    assert_eq!(points, expected);
}

#[test]
fn all_that_is_wrong_with_points_without_times_is_said_with_its_place() {
    let text = r#"{"points": [
        {"joints_deg": [0, 1, 0, 0, 0]},
        {"position_mm": [1, 2, 3]},
        {"position_mm": [1, 2, 3], "rotation_deg": [0, 0, 0], "joints_deg": [0, 0, 0, 0, 0, 0]},
        {"position_mm": [1, 2, "3"], "rotation_deg": [0, 0, 0], "tool_speed_mms": 5}
    ]}"#;
    let errors = Via::from_json(text, "way.json").unwrap_err().to_string();
    let expected = [
        "way.json:2:24: joints_deg: found 5 numbers, expected 6",
        "way.json:3:9: a point: `rotation_deg` or `rotation_rad` is missing",
        "way.json:4:9: expected joint positions or a pose, and not both",
        "way.json:5:32: position_mm: found `\"3\"`, expected a finite number",
        "way.json:5:83: unknown key `tool_speed_mms`; they are `joints_deg`, `joints_rad`, `position_mm`, `rotation_deg`, `rotation_rad`, `tool_speed_mm_s`, `corner_mm`, `corner_turn_deg`, `corner_deg`",
    ];
    assert_eq!(errors.lines().collect::<Vec<_>>(), expected);
    let errors = Via::from_json(r#"{"points": []}"#, "way.json").unwrap_err().to_string();
    assert_eq!(errors, "way.json:1:1: found 0 points, expected at least 2");
}

//! `jaka report`: a page made from a recording.

use std::fmt::Write as _;
use std::fs;
use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model, Trajectory, Via};
use jaka_robot::motion::JointMove;
use jaka_robot::proto::wire::Writer;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, FollowConfig, RobotConfig, ServoConfig, ServoSession};
use jaka_sim::Port;
use jaka_tests::{Arm, Configured as _, LONG, recorded};
use serde_json::{Value, json};

use crate::program::{Run, jaka, scratch};

/// The parts of each page.
const SECTIONS: [&str; 12] = [
    "summary", "problems", "joints", "speeds", "path", "state", "io", "calls", "events", "lateness", "commands", "list",
];

/// All elements of pages, none of which fetches or runs anything.
const ELEMENTS: [&str; 29] = [
    "!DOCTYPE", "html", "head", "meta", "title", "style", "body", "h1", "h2", "section", "p", "figure", "table", "tr",
    "th", "td", "pre", "svg", "line", "rect", "circle", "polygon", "polyline", "text", "/html", "/head", "/title",
    "/style", "/body",
];

const HEADER: &str = r#"{"jaka_recording":1,"started":1763726000.5,"software":"a test"}"#;

/// The page of a recording of this text, and how the program ended.
fn report(session: &[u8]) -> (String, Run) {
    let (path, page) = (scratch("session.jsonl"), scratch("report.html"));
    fs::write(&path, session).unwrap();
    fs::remove_file(&page).ok();
    let run = jaka([&"report".as_ref(), &path.as_os_str(), &"-o".as_ref(), &page.as_os_str()]);
    (fs::read_to_string(page).unwrap_or_default(), run)
}

/// A recording of entries: time, port, and what the event has.
fn session(entries: &[(f64, &str, Value)]) -> String {
    let mut session = format!("{HEADER}\n");
    for (time, port, event) in entries {
        let mut entry = json!({"time": time, "port": port, "connection": if *port == "status" { 2 } else { 1 }});
        entry.as_object_mut().unwrap().extend(event.as_object().unwrap().clone());
        writeln!(session, "{entry}").unwrap();
    }
    session
}

fn sent(request: &Value) -> Value {
    json!({"event": "sent", "text": request.to_string()})
}

fn received(message: &Value) -> Value {
    json!({"event": "received", "text": message.to_string()})
}

/// A session with something of everything: 10 minutes of status packets at the period of firmware 1.5.14.
fn everything() -> Vec<(f64, &'static str, Value)> {
    let mut entries = vec![
        (0.0, "command", json!({"event": "connected", "address": "10.5.5.100:10001"})),
        (1.0, "command", sent(&json!({"cmdName": "enable_robot"}))),
        (
            1.02,
            "command",
            received(&json!({"cmdName": "enable_robot", "errorCode": "2", "errorMsg": "no <b>power</b>"})),
        ),
        (2.0, "command", sent(&json!({"cmdName": "get_version"}))),
        (7.0, "command", json!({"event": "error", "text": "no reply to `get_version` within 5s"})),
    ];
    for at in 0..100_i32 {
        let time = 10.0 + f64::from(at) * 0.008 + if at == 50 { 0.03 } else { 0.0 };
        let set_point = json!({"cmdName": "servo_j", "relFlag": 0, "jointPosition": [at, 0, 0, 0, 0, 0], "stepNum": 1});
        entries.push((time, "command", sent(&set_point)));
        entries.push((
            time + 0.002,
            "command",
            received(&json!({"cmdName": "servo_j", "errorCode": "0", "errorMsg": ""})),
        ));
    }
    for at in 0..20_000_i32 {
        // Every number differs from those around it: nothing can be left out because it stays as it is.
        let [slow, fast] = [f64::from(at) / 3000.0, f64::from(at * 7919 % 1000) / 1000.0];
        let joints: Vec<_> = (0..6).map(|joint| 90.0 * (slow + f64::from(joint)).sin() + fast).collect();
        let packet = json!({
            "joint_actual_position": joints, "actual_position": [400.0 * slow.sin() + fast, 300.0 * slow.cos(), 100.0 * fast, 180.0, 0.0, 90.0],
            "din": [u8::from(at / 5 % 2 == 0), 1], "ain": [fast], "protective_stop": u8::from((9000..9100).contains(&at)), "enabled": true,
            "curr_tcp_trans_vel": 100.0 * fast, "errcode": if at < 5000 { "0x0" } else { "0x10f0005" },
        });
        entries.push((f64::from(at) * 0.03, "status", received(&packet)));
    }
    entries.push((600.0, "status", json!({"event": "closed", "by": "failure", "why": "the connection was reset"})));
    entries
}

/// Asserts that a page has each part and no other element than those that do nothing.
fn assert_page(page: &str) {
    for id in SECTIONS {
        assert!(page.contains(&format!("<section id=\"{id}\">")), "{id}");
    }
    for element in page.split('<').skip(1) {
        let (tag, rest) = element.split_once('>').expect("the element ends");
        let name = tag.split([' ', '/']).find(|name| !name.is_empty()).unwrap();
        assert!(ELEMENTS.contains(&name), "<{tag}>");
        let attributes = ["src", "href", "on", "style=", "http-equiv", "data"];
        assert!(
            !tag.split(' ').skip(1).any(|attribute| attributes.iter().any(|bad| attribute.starts_with(bad))),
            "<{tag}>"
        );
        assert!(name == "style" || !rest.contains('>'), "{rest}");
    }
    let style = page.split_once("<style>").unwrap().1.split_once("</style>").unwrap().0;
    assert!(!style.contains("url(") && !style.contains("@import"), "{style}");
    assert!(page.ends_with("</body>\n</html>\n"));
}

/// The HTML of a part.
fn part<'p>(page: &'p str, id: &str) -> &'p str {
    page.split_once(&format!("<section id=\"{id}\">")).unwrap().1.split_once("</section>").unwrap().0
}

#[test]
fn a_page_of_ten_minutes_has_all_parts_requests_nothing_and_is_small() {
    let (page, run) = report(session(&everything()).as_bytes());
    assert_eq!(run.text(), "exit code 0\n");
    assert_page(&page);
    for nothing in ["http", "src=", "script", "url("] {
        assert!(!page.contains(nothing), "{nothing}");
    }
    assert!(page.len() <= 1_000_000, "{} bytes", page.len());
    for id in ["joints", "speeds", "path", "state", "io", "calls", "events", "lateness"] {
        assert!(part(&page, id).contains("<svg"), "{id}");
    }
    assert_eq!(part(&page, "path").matches("<svg").count(), 2, "two sides");
    let problems = part(&page, "problems");
    for problem in [
        "`enable_robot` refused with code 2: no &lt;b&gt;power&lt;/b&gt;",
        "no reply to `get_version` is recorded",
        "no reply to `get_version` within 5s",
        "protective stop",
        "connection 2 lost: the connection was reset",
        "-&gt; {&quot;cmdName&quot;:&quot;enable_robot&quot;}",
    ] {
        assert!(problems.contains(problem), "{problem} in {problems}");
    }
    assert!(part(&page, "lateness").contains("99 intervals") && part(&page, "lateness").contains("latest 30.000"));
    assert!(part(&page, "list").contains("0x10f0005 (information: the robot is disabled)"));
    assert!(part(&page, "io").contains("On throughout: digital_inputs[1]"));
}

#[test]
fn hostile_recordings_give_a_page_without_their_text_as_html() {
    let evil = "</pre><script>alert(1)</script><img src=x onerror=alert(1)>\"'&\u{202e}\u{1b}[2J";
    let huge = json!({
        "joint_actual_position": [1e308, -1e308, 1e300, 0, 0, 0], "actual_position": [1e308, 0, 0, 0, 0, 0], "errcode": evil, "errmsg": evil,
        "din": vec![1; 5000], "ain": [1e308, -1e308], "curr_tcp_trans_vel": -1e308, "protective_stop": evil, "powered_on": {"a": []},
    });
    let mut entries = vec![
        (0.5, "command", json!({"event": "connected", "address": evil})),
        (0.6, "command", sent(&json!({"cmdName": evil}))),
        (0.1, "command", received(&json!({"cmdName": evil, "errorCode": evil, "errorMsg": evil}))),
        (0.7, "command", sent(&json!([evil]))),
        (0.7, "command", json!({"event": "received", "hex": "3c7363726970743eff00"})),
        (
            0.7,
            "command",
            sent(
                &json!({"cmdName": "servo_j", "relFlag": 0, "jointPosition": [0, 0, 0, 0, 0, 0], "stepNum": 1_i64 << 40}),
            ),
        ),
        (
            0.8,
            "command",
            sent(&json!({"cmdName": "servo_j", "relFlag": 0, "jointPosition": [0, 0, 0, 0, 0, 0], "stepNum": -1})),
        ),
        (0.9, "command", json!({"event": "error", "text": evil})),
        (0.9, "command", json!({"event": "closed", "by": "controller", "why": evil})),
        (0.3, "status", json!({"event": "received", "text": evil})),
        (0.4, "status", json!({"event": "dropped", "count": u64::MAX})),
        (0.5, "status", json!({"event": "dropped", "count": u64::MAX})),
        (1e12, "status", received(&json!({"joint_actual_position": [0, 0, 0, 0, 0, 0]}))),
    ];
    for at in 0..50_i32 {
        entries.push((
            f64::from(at % 7),
            "status",
            received(&if at % 2 == 0 { huge.clone() } else { json!({"enabled": at}) }),
        ));
    }
    let mut text = session(&entries).replacen("a test", &evil.replace('"', ""), 1).into_bytes();
    text.extend(b"{\"time\":1,\"port\":\"sta\xff");
    let (page, run) = report(&text);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert_page(&page);
    assert!(
        !page.contains("<script") && !page.contains("<img") && !page.contains('\u{202e}') && !page.contains('\u{1b}')
    );
    assert!(part(&page, "problems").contains("&lt;script&gt;"));
    assert!(part(&page, "summary").contains("cut off") && part(&page, "summary").contains("not drawn"));
}

#[test]
fn a_recording_of_nothing_is_a_page_that_says_so() {
    for text in [HEADER, &format!("{HEADER}\n")] {
        let (page, run) = report(text.as_bytes());
        assert_eq!(run.text(), "exit code 0\n");
        assert_page(&page);
        assert!(part(&page, "joints").contains("The recording has no status packets."));
        assert!(part(&page, "calls").contains("The recording has no requests."));
        assert!(part(&page, "problems").contains("The recording shows none."));
    }
}

#[test]
fn what_is_not_a_recording_is_an_error_and_no_page() {
    for text in ["", "\n", "<script>", "{\"jaka_recording\":2,\"started\":0}\n", &format!("{HEADER}\n{{}}\n")] {
        let (page, run) = report(text.as_bytes());
        assert_eq!((run.code, page.as_str(), run.out.as_str()), (Some(2), "", ""), "{text}: {}", run.err);
        assert!(run.err.starts_with("error: ") && run.err.contains("session.jsonl: line "), "{text}: {}", run.err);
    }
}

#[test]
fn late_set_points_ends_of_motions_and_stops_are_told() {
    let late = |session: &mut ServoSession<'_>, arm: &Arm| {
        let turn = |session: &mut ServoSession<'_>, by| session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, by]);
        turn(session, 0.04).expect("it is sent");
        turn(session, 0.08).expect("it is sent");
        arm.clock().sleep(Duration::from_millis(20));
        turn(session, 0.08).expect("it is late, and sent");
        arm.clock().sleep(Duration::from_millis(40));
        turn(session, 0.08).expect_err("it is too late");
    };
    let ((), recording) = recorded(Arm::simulated(), |arm| {
        let mut robot = arm.robot();
        robot.power_up(LONG).expect("it has power");
        late(&mut robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest"), arm);
        let to = |angle| JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], 20.0).acceleration(60.0);
        robot.run(&to(10.0), LONG).expect("it is accepted").reached().expect("nothing is in its way");
        robot.start(&to(40.0)).expect("it is accepted");
        robot.stop_handle().stop().expect("it is accepted");
        assert!(robot.wait(LONG).cause() == Cause::Stopped);
    });
    let mut text = Writer::new();
    recording.write(&mut text);
    let (page, run) = report(text.as_str().as_bytes());
    assert_eq!(run.text(), "exit code 0\n");
    let problems = part(&page, "problems");
    for problem in [
        "a set-point is 12.0ms late",
        "a set-point is 32.0ms late: the controller had none when several were due",
        "a set-point was too late, by 32.0ms: the machine was too busy to send it in time",
        "the program stops the arm (`stop_program`)",
        "the motion was stopped before its target",
    ] {
        assert!(problems.contains(problem), "{problem} in {problems}");
    }
    let reached = "the motion has reached its target";
    assert!(part(&page, "list").contains(reached) && !problems.contains(reached), "{}", part(&page, "list"));
}

#[test]
fn ends_of_trajectories_and_of_landings_are_told() {
    let (error, recording) = recorded(Arm::simulated(), |arm| {
        let mut robot = arm.robot();
        robot.power_up(LONG).expect("it has power");
        let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
        let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
        let start = arm.state().joint_position;
        let there = JointPosition([start[0] + 40.0, start[1], start[2], start[3], start[4], start[5]]);
        let way = Trajectory::through([Via::joints(start), Via::joints(there)]).joint_speeds([20.0; 6]);
        let trajectory = way.build(robot.limits().expect("it has some")).expect("within the limits");
        let run = robot.start_follow(&trajectory, &FollowConfig::new()).expect("the arm is at its start");
        arm.clock().sleep(Duration::from_millis(500));
        run.handle().stop().expect("it runs");
        assert_eq!(run.wait().cause(), Cause::Stopped);
        let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
        session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, 0.004]).expect("it is sent");
        arm.link(Port::Status).to_client().hold();
        session.land().expect_err("no packet shows rest").kind().to_string()
    });
    let mut text = Writer::new();
    recording.write(&mut text);
    let (page, _) = report(text.as_str().as_bytes());
    let problems = part(&page, "problems");
    for problem in ["the motion was stopped before its target (", &error] {
        assert!(problems.contains(problem), "{problem} in {problems}");
    }
}

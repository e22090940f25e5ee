//! `jaka export`: a recording's status packets as a table.

use std::fs;

use crate::program::{jaka, scratch};
use crate::transcripts::recording;

#[test]
fn the_usual_fields_are_those_of_status_and_all_are_all() {
    let recording = recording("packets.jsonl");
    let header =
        |options: &[&str]| jaka(["export", &recording].iter().chain(options)).out.lines().next().unwrap().to_owned();
    assert!(header(&[]).ends_with("current_tool_id,current_user_frame_id"), "{}", header(&[]));
    let all = header(&["--fields", "all"]);
    assert!(all.contains("joint_commanded_position[5] (deg)") && all.contains("monitor_data"), "{all}");
}

#[test]
fn a_file_is_written_and_never_the_recording() {
    let (session, table) = (scratch("session.jsonl"), scratch("session.csv"));
    let recorded = fs::read_to_string(recording("packets.jsonl")).unwrap();
    fs::write(&session, &recorded).unwrap();
    let to =
        |path: &std::path::Path| jaka([&"export".as_ref(), &session.as_os_str(), &"-o".as_ref(), &path.as_os_str()]);
    assert_eq!((to(&table).code, to(&table).out.as_str()), (Some(0), ""));
    assert_eq!(fs::read_to_string(&table).unwrap().lines().count(), 4);
    let refused = to(&session);
    assert_eq!(refused.code, Some(2));
    assert!(refused.err.ends_with("session.jsonl is the recording, which is not overwritten\n"), "{}", refused.err);
    assert_eq!(fs::read_to_string(&session).unwrap(), recorded);
    assert_eq!(to(&scratch("")).code, Some(6));
}

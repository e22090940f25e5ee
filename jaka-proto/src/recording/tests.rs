use proptest::prelude::*;

use super::*;
use crate::wire::Writer;

fn written(recording: &Recording) -> String {
    let mut out = Writer::new();
    recording.write(&mut out);
    out.into_string()
}

const HEADER: &str = "{\"jaka_recording\":1,\"started\":1763726000.123456,\"software\":\"a test\"}\n";

fn problem(file: &str) -> String {
    Recording::read(file.as_bytes()).expect_err("the file is damaged").to_string()
}

#[test]
fn lines_look_as_the_format_says() {
    let at = |micros, event| Entry::new(Duration::from_micros(micros), Port::Command, 1, event);
    let header = Header::new(Duration::from_micros(1_763_726_000_123_456), "a test");
    let entries = vec![
        at(412, Event::Connected { address: "10.5.5.100:10001".to_owned() }),
        at(593, Event::Sent(Message::new("{\"cmdName\":\"get_version\"}"))),
        at(1_002_190, Event::Received(Message::new(b"{\xff}".as_slice()))),
        at(2_000_000, Event::Error { text: "a\nb".to_owned() }),
        at(2_000_000, Event::Motion { step: MotionStep::Gap, text: "late".to_owned() }),
        at(2_000_001, Event::Dropped { count: 3 }),
        at(2_000_002, Event::Closed { by: Ending::Failure, why: "reset".to_owned() }),
    ];
    let expected = [
        HEADER.trim(),
        r#"{"time":0.000412,"port":"command","connection":1,"event":"connected","address":"10.5.5.100:10001"}"#,
        r#"{"time":0.000593,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"get_version\"}"}"#,
        r#"{"time":1.002190,"port":"command","connection":1,"event":"received","hex":"7bff7d"}"#,
        r#"{"time":2.000000,"port":"command","connection":1,"event":"error","text":"a\nb"}"#,
        r#"{"time":2.000000,"port":"command","connection":1,"event":"motion","step":"gap","text":"late"}"#,
        r#"{"time":2.000001,"port":"command","connection":1,"event":"dropped","count":3}"#,
        r#"{"time":2.000002,"port":"command","connection":1,"event":"closed","by":"failure","why":"reset"}"#,
    ];
    assert_eq!(written(&Recording::new(header, entries)).lines().collect::<Vec<_>>(), expected);
}

#[test]
fn unknown_keys_are_skipped_and_the_connection_may_be_absent() {
    let line = r#"{"new":[{}],"time":1,"port":"status","event":"dropped","count":2,"text":"not of this event"}"#;
    let entry = Entry::read(line).expect("it is an entry");
    assert_eq!(entry, Entry::new(Duration::from_secs(1), Port::Status, 1, Event::Dropped { count: 2 }));
}

#[test]
fn errors_name_the_line_and_what_is_wrong() {
    let line = |entry: &str| problem(&format!("{HEADER}{entry}\n"));
    let start = r#""time":0,"port":"command""#;
    assert_eq!(
        problem(""),
        "line 1 of the recording cannot be read: not JSON: expected a value at byte 0, where the text ends"
    );
    assert_eq!(
        problem("{\"jaka_recording\":2,\"started\":0}\n"),
        "line 1 of the recording cannot be read: field `jaka_recording`: expected version 1 of the format, found `2`"
    );
    assert_eq!(
        line(&format!("{{{start},\"event\":\"moved\"}}")),
        "line 2 of the recording cannot be read: field `event`: expected an event of the format, found `moved`"
    );
    assert_eq!(
        line(&format!("{{{start},\"event\":\"sent\"}}")),
        "line 2 of the recording cannot be read: field `text`: the key `text` is missing"
    );
    assert_eq!(
        line(&format!("{{{start},\"event\":\"sent\",\"hex\":\"7b7\"}}")),
        "line 2 of the recording cannot be read: field `hex`: expected two hexadecimal digits for each byte, found `7b7`"
    );
    assert_eq!(
        line(r#"{"time":-1,"port":"command","event":"dropped","count":1}"#),
        "line 2 of the recording cannot be read: field `time`: expected a time in seconds, found `-1`"
    );
    assert!(line("").contains("line 2"));
    assert!(Recording::read(&[HEADER.as_bytes(), b"\xff\n"].concat()).is_err());
}

#[test]
fn replies_are_paired_with_their_requests() {
    let at = |millis, connection, event| Entry::new(Duration::from_millis(millis), Port::Command, connection, event);
    let sent = |name: &str| Event::Sent(Message::new(format!("{{\"cmdName\":\"{name}\"}}")));
    let reply = |name: &str| Message::new(format!("{{\"errorCode\":\"0\",\"cmdName\":\"{name}\"}}"));
    let entries = vec![
        at(0, 1, sent("a")),
        at(10, 1, sent("b")),
        at(11, 2, sent("a")),
        // The reply to `a` on the first connection is lost, and this one is late.
        at(500, 1, Event::Received(reply("b"))),
        at(500, 1, Event::Received(reply("unasked"))),
        at(511, 2, Event::Closed { by: Ending::Controller, why: String::new() }),
        at(600, 1, sent("d")),
        at(601, 1, Event::Received(Message::new("{\"errorCode\":\"9\"}"))),
    ];
    let answers = Recording::new(Header::new(Duration::ZERO, ""), entries).answers();
    let answers: Vec<_> = answers.into_iter().map(|answered| answered.answer).collect();
    let millis = Duration::from_millis;
    assert_eq!(
        answers,
        [
            Answer::Nothing,
            Answer::Reply { reply: reply("b"), after: millis(490) },
            Answer::Closed { by: Ending::Controller },
            Answer::Reply { reply: Message::new("{\"errorCode\":\"9\"}"), after: millis(1) },
        ]
    );
}

fn any_event() -> impl Strategy<Value = Event> {
    let text = || proptest::string::string_regex("(?s).{0,20}").expect("the pattern is correct");
    let message = || {
        prop_oneof![text().prop_map(Message::new), proptest::collection::vec(any::<u8>(), 0..20).prop_map(Message::new)]
    };
    prop_oneof![
        text().prop_map(|address| Event::Connected { address }),
        message().prop_map(Event::Sent),
        message().prop_map(Event::Received),
        (proptest::sample::select(&Ending::ALL[..]), text()).prop_map(|(by, why)| Event::Closed { by, why }),
        text().prop_map(|text| Event::Error { text }),
        (proptest::sample::select(&MotionStep::ALL[..]), text()).prop_map(|(step, text)| Event::Motion { step, text }),
        any::<u64>().prop_map(|count| Event::Dropped { count }),
    ]
}

fn any_recording() -> impl Strategy<Value = Recording> {
    // Up to a century.
    let micros = || (0..3_200_000_000_000_000_u64).prop_map(Duration::from_micros);
    let port = proptest::sample::select(&Port::ALL[..]);
    let entry = (micros(), port, any::<u32>(), any_event())
        .prop_map(|(time, port, connection, event)| Entry::new(time, port, connection, event));
    let header = (micros(), ".{0,20}").prop_map(|(started, software)| Header::new(started, software));
    (header, proptest::collection::vec(entry, 0..6)).prop_map(|(header, entries)| Recording::new(header, entries))
}

proptest! {
    #[test]
    fn what_is_written_is_read(recording in any_recording()) {
        let text = written(&recording);
        prop_assert_eq!(text.lines().count(), recording.entries.len() + 1);
        prop_assert_eq!(Recording::read(text.as_bytes()).expect("it has just been written"), recording);
    }

    #[test]
    fn all_before_a_truncated_line_is_read(recording in any_recording(), cut in any::<proptest::sample::Index>()) {
        let text = written(&recording);
        let header = text.find('\n').map_or(0, |end| end + 1);
        let cut = header + cut.index(text.len() - header + 1);
        let whole = text.as_bytes()[header..cut].split(|byte| *byte == b'\n').count() - 1;
        let read = Recording::read(&text.as_bytes()[..cut]).expect("the header is there");
        prop_assert_eq!(&read.entries[..whole], &recording.entries[..whole]);
        // A line that lacks its line feed alone is whole, too.
        prop_assert!(read.entries.len() <= whole + 1);
        if let Some(error) = read.truncated {
            prop_assert_eq!(error.line, whole + 2);
        }
    }
}

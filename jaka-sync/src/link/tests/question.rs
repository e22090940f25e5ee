//! A command whose reply is polled for.

use std::io::Write as _;

use jaka_proto::Command;
use jaka_proto::exchange::TextOnly;
use jaka_proto::messages::kinematics::GetJointPos;
use jaka_proto::messages::program::StopProgram;

use super::*;

fn ask(link: &Link) -> Sent<'static> {
    link.ask((GetJointPos::INFO, None, Handle::FIRST), &mut |out| GetJointPos::new().write_request(out))
        .expect("it goes out")
}

/// Polls as a loop does that looks at other things between.
fn poll(link: &Link, question: &Sent<'_>) -> Result<String, Error> {
    let (mut text, mut failed) = (String::new(), None);
    until(|| match link.poll(question, Duration::from_millis(1), &mut text, &mut TextOnly) {
        Ok(is_answered) => is_answered,
        Err(error) => {
            failed = Some(error);
            true
        }
    });
    failed.map_or(Ok(text), Err)
}

#[test]
fn a_slice_that_ends_gives_nothing_up() {
    let (link, mut server) = connection(Mode::Blocking);
    let question = ask(&link);
    let mut text = String::new();
    for _ in 0..5 {
        let slice = Duration::from_millis(1);
        assert!(!link.poll(&question, slice, &mut text, &mut TextOnly).expect("it is not answered yet"));
    }
    let expected = reply(GetJointPos::INFO.name, 0, "late");
    server.write_all(expected.as_bytes()).expect("the link reads");
    assert_eq!(poll(&link, &question).expect("it is answered"), expected);
    // Without waiting at all.
    let question = ask(&link);
    assert!(!link.poll(&question, Duration::ZERO, &mut text, &mut TextOnly).expect("it is not answered yet"));
    server.write_all(expected.as_bytes()).expect("the link reads");
    until(|| link.poll(&question, Duration::ZERO, &mut text, &mut TextOnly).expect("it is answered"));
    // Its successor of the same name has its own reply, or none.
    let next = ask(&link);
    assert!(!link.poll(&next, Duration::from_millis(1), &mut text, &mut TextOnly).expect("it is not answered yet"));
    link.forget(&next);
    // Its reply is discarded, and breaks nothing.
    server.write_all(expected.as_bytes()).expect("the link reads");
    let last = ask(&link);
    server.write_all(expected.as_bytes()).expect("the link reads");
    assert_eq!(poll(&link, &last).expect("it is answered"), expected);
    assert!(link.broken().is_none());
}

#[test]
fn a_question_is_answered_by_any_thread_that_reads_and_stops_pass_it() {
    let (link, mut server) = connection(Mode::Blocking);
    let question = ask(&link);
    let stop = |link: &Link| {
        let write = &mut |out: &mut Writer| StopProgram::new().write_request(out);
        link.send(&Outgoing::of(&link.clock, StopProgram::INFO, LONG), write).expect("it goes out")
    };
    let sent = stop(&link);
    let replies = [reply(GetJointPos::INFO.name, 2, "busy"), reply(StopProgram::INFO.name, 0, "")].concat();
    server.write_all(replies.as_bytes()).expect("the link reads");
    link.wait(&sent, &mut String::new(), &mut TextOnly).expect("the stop is accepted");
    assert!(poll(&link, &question).expect_err("the query is refused").is_refused());
    // One that is never answered is detected by a later reply.
    let (question, sent) = (ask(&link), stop(&link));
    server.write_all(reply(StopProgram::INFO.name, 0, "").as_bytes()).expect("the link reads");
    link.wait(&sent, &mut String::new(), &mut TextOnly).expect("the stop is accepted");
    assert!(poll(&link, &question).is_err_and(|error| matches!(error.kind(), ErrorKind::ReplyLost { .. })));
    assert!(link.broken().is_none());
}

#[test]
fn the_oldest_posted_command_is_reported_by_its_age() {
    let (stream, mut server) = sockets(1 << 20);
    let link = Link::new(stream, Tap::default(), &Config::new().reply_timeout(LONG));
    assert_eq!(link.oldest_posted(OWNER), None);
    let before = Instant::now();
    for _ in 0..2 {
        post(&link, LONG, 1).expect("it goes out");
    }
    let age = link.oldest_posted(OWNER).expect("it is outstanding");
    assert!(age <= before.elapsed());
    server.write_all([reply("x", 0, ""), reply("x", 0, "")].concat().as_bytes()).expect("the link reads");
    let (answers, _, waited) = link.wait_for_posted(OWNER, 0, LONG);
    waited.expect("both are answered");
    assert_eq!((answers.accepted, link.oldest_posted(OWNER)), (2, None));
}

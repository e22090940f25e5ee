//! A reply that will not come any more.

use std::io::Write as _;

use jaka_proto::exchange::TextOnly;

use super::*;

#[test]
fn a_lost_reply_is_reported_before_anything_after_it_is_attributed() {
    let (link, mut server) = connection(Mode::Blocking);
    let send = |name| send_named(&link, name, LONG, &mut |out| write(0, out)).expect("it goes out");
    let (first, second) = (send("a"), send("b"));
    // The answer to the later command, and after it one that comes too late.
    server.write_all([reply("b", 0, ""), reply("a", 0, "")].concat().as_bytes()).expect("the link reads");
    let lost = link.wait(&first, &mut String::new(), &mut TextOnly);
    assert!(matches!(lost.as_ref().map_err(Error::kind), Err(ErrorKind::ReplyLost { .. })), "{lost:?}");
    assert!(link.broken().is_none(), "the next thread that waits finds it");
    link.wait(&second, &mut String::new(), &mut TextOnly).expect("it was answered");
}

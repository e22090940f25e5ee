//! The right of way of a stop.

use std::borrow::Cow;
use std::net::{TcpListener, TcpStream};
use std::time::Duration;

use super::*;
use crate::recorder::Tap;
use crate::{Config, ErrorKind};

#[test]
fn while_a_stop_is_on_its_way_out_no_other_command_begins_to_go_out() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
    let link = Link::new(stream, Tap::default(), &Config::new());
    let send = |right| {
        let outgoing = Outgoing::named(&link.clock, "x", Cow::Borrowed("x"), Duration::from_millis(1)).by(right);
        link.take_turn(&outgoing).map(|(turn, state)| {
            // The turn locks the state when it is dropped.
            drop(state);
            drop(turn);
        })
    };
    let stop = Passing::new(&link);
    let error = send(Right::Usual).expect_err("the stop goes first");
    assert!(matches!(error.kind(), ErrorKind::NotSentInTime { .. }), "{error:?}");
    send(Right::Stop).expect("nobody else sends");
    drop(stop);
    send(Right::Usual).expect("nobody else sends");
}

use std::io::Read;
use std::net::TcpListener;
use std::thread;

use socket2::SockRef;

use super::*;

/// More than any buffer between the two ends holds.
const COMMANDS: usize = 4000;

/// A command of 4 KB, each another.
fn write(index: usize, out: &mut Writer) {
    out.raw(&format!("{{\"cmdName\":\"x\",\"index\":{index},\"pad\":\"{}\"}}", "x".repeat(4000)));
}

#[test]
fn what_the_system_takes_piece_by_piece_arrives_whole() {
    for mode in [Mode::Blocking, Mode::Nonblocking] {
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        SockRef::from(&listener).set_recv_buffer_size(4096).expect("it can be small");
        let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
        SockRef::from(&stream).set_send_buffer_size(4096).expect("it can be small");
        let (mut server, _) = listener.accept().expect("the client waits");
        let reading = thread::spawn(move || {
            let mut bytes = String::new();
            server.read_to_string(&mut bytes).map(|_| bytes)
        });
        let link = Link::new(stream, Tap::default(), &Config::new());
        link.switch(&mut link.lock(), mode).expect("the socket is open");
        assert_eq!(link.post("x", None, COMMANDS, &mut write).expect("it is sent"), COMMANDS);
        drop(link);
        let mut expected = Writer::new();
        (0..COMMANDS).for_each(|index| write(index, &mut expected));
        let arrived = reading.join().expect("the thread does not panic").expect("it is text");
        assert!(arrived == expected.as_str(), "{} of {} bytes", arrived.len(), expected.as_str().len());
    }
}

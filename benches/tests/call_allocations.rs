//! Allocations and threads of calls.

use std::net::TcpListener;
use std::thread;

use allocation_counter::measure;
use jaka_benches::system::canned;
use jaka_sync::Client;

fn client() -> Client {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || canned::serve(&listener, 0));
    Client::connect(address).expect("the server listens")
}

#[test]
fn a_call_with_a_reply_of_fixed_shape_allocates_nothing() {
    let mut client = client();
    client.get_joint_pos().expect("it answers");
    let allocations = measure(|| {
        for _ in 0..100 {
            client.get_joint_pos().expect("it answers");
        }
    });
    assert_eq!(allocations.count_total, 0);
}

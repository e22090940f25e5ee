//! Counts that repeat exactly: allocations, and bytes visited.

use allocation_counter::measure;
use jaka_benches::{PACKET_OF_DOCUMENT, PACKET_OF_NEWER, reply, status};
use jaka_proto::Request;
use jaka_proto::framing::Framer;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::Writer;

/// How often `once` allocates when all buffers are there.
fn allocations<T>(mut once: impl FnMut() -> T) -> u64 {
    drop(once());
    measure(|| drop(once())).count_total
}

#[test]
fn no_request_allocates() {
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    let examples = spec.commands().flat_map(|command| &command.examples);
    let texts = examples.filter_map(|example| example.request.as_deref());
    let requests: Vec<_> = texts.map(|text| Request::read(text).expect("the spec's examples fit")).collect();
    for info in Request::COMMANDS {
        let mut own = requests.iter().filter(|request| request.info().name == info.name).peekable();
        assert!(own.peek().is_some(), "`{}` has no example", info.name);
        for request in own {
            let mut out = Writer::new();
            let count = allocations(|| {
                out.clear();
                request.write(&mut out);
            });
            assert_eq!(count, 0, "{}", out.as_str());
        }
    }
}

#[test]
fn a_reply_of_fixed_shape_allocates_nothing() {
    assert_eq!(allocations(|| reply::ours(reply::JOINT_POS)), 0);
}

#[test]
fn packets_over_packets_allocate_nothing() {
    for packet in [PACKET_OF_DOCUMENT, PACKET_OF_NEWER] {
        let mut status = RobotStatus::default();
        assert_eq!(allocations(|| status::ours(packet, &mut status)), 0);
    }
}

#[test]
fn a_choice_of_fields_allocates_nothing() {
    for packet in [PACKET_OF_DOCUMENT, PACKET_OF_NEWER] {
        let mut framer = Framer::default();
        assert_eq!(allocations(|| status::joints(packet, &mut framer)), 0);
    }
}

#[test]
fn framing_visits_each_byte_once() {
    for piece in [1, 7, 1460, 65536] {
        let mut framer = Framer::default();
        let stream = [PACKET_OF_DOCUMENT, PACKET_OF_NEWER].concat().repeat(5);
        assert_eq!(jaka_benches::framing::ours(&mut framer, stream.as_bytes(), piece), 10);
        assert_eq!(framer.visited(), stream.len() as u64);
    }
}

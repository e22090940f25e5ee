use proptest::prelude::*;
use serde_json::{Map, Value};

use super::*;

mod cut;

/// Documents with all that a scanner can trip over.
const DOCUMENTS: [&[u8]; 9] = [
    b"{}",
    br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [1.5, -2, 0, 0, 0, 0]}"#,
    br#"{"brace": "}{", "quote": "\"}", "backslash": "\\", "both": "\\\"}\\\\"}"#,
    br#"{"a": {"b": [{"c": {}}, {}]}, "tuple": "(1, [{'a': (0, 0)}])"}"#,
    b"(0, [], {'state': 0})",
    br#"('it\'s ) "', "it's ) \" \\", (1, (')',)), {'(': "'"})"#,
    b"{\"not utf-8\": \"\xff\xfe\xc3\", \"nul\": \"\0\"}",
    "{\"错误\": \"机器人}\"}".as_bytes(),
    b"()",
];

impl Framer {
    fn capacity(&self) -> usize {
        self.buffer.capacity()
    }
}

/// Pushes the pieces; all frames up to the first error, and the error.
fn run<'a>(framer: &mut Framer, pieces: impl IntoIterator<Item = &'a [u8]>) -> (Vec<Vec<u8>>, Result<(), FrameError>) {
    let mut found = Vec::new();
    for piece in pieces {
        framer.push(piece);
        loop {
            match framer.next_frame() {
                Ok(Some(frame)) => found.push(frame.to_vec()),
                Ok(None) => break,
                Err(error) => return (found, Err(error)),
            }
        }
    }
    (found, Ok(()))
}

fn split_at(stream: &[u8], at: usize) -> [&[u8]; 2] {
    [&stream[..at], &stream[at..]]
}

fn garbage(excerpt: &[u8]) -> FrameError {
    FrameError::Garbage { excerpt: Excerpt(excerpt.to_vec()) }
}

fn too_long(limit: usize, excerpt: &[u8]) -> FrameError {
    FrameError::TooLong { limit, excerpt: Excerpt(excerpt.to_vec()) }
}

#[test]
fn documents_are_found_at_every_split() {
    for gap in ["", " ", "\r\n\t "] {
        let stream = [DOCUMENTS.join(gap.as_bytes()), gap.into()].concat();
        for at in 0..=stream.len() {
            let mut framer = Framer::default();
            assert_eq!(run(&mut framer, split_at(&stream, at)), (DOCUMENTS.map(Vec::from).into(), Ok(())), "{at}");
            assert!(framer.is_idle());
        }
    }
}

#[test]
fn bytes_one_by_one_are_visited_once() {
    let stream = DOCUMENTS.join(b"\n".as_slice());
    let mut framer = Framer::default();
    assert_eq!(run(&mut framer, stream.chunks(1)), (DOCUMENTS.map(Vec::from).into(), Ok(())));
    assert_eq!(framer.visited(), stream.len() as u64);
}

#[test]
fn a_frame_in_the_making_is_partial() {
    let mut framer = Framer::default();
    assert!(framer.is_idle());
    framer.push(b"{} {\"a\"");
    assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
    assert!(!framer.is_idle());
    assert_eq!(framer.next_frame(), Ok(None));
    assert_eq!(framer.partial(), b"{\"a\"");
    framer.push(b": 1}\n");
    assert_eq!(framer.next_frame(), Ok(Some(b"{\"a\": 1}".as_slice())));
    assert_eq!(framer.partial(), b"\n");
    assert!(framer.is_idle());
}

#[test]
fn room_is_read_into_and_clamped() {
    let mut framer = Framer::default();
    assert!(framer.spare().len() >= ROOM);
    framer.spare()[..4].copy_from_slice(b"{}{}");
    framer.filled(2);
    assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
    framer.filled(2);
    assert_eq!(framer.next_frame(), Ok(Some(b"{}".as_slice())));
    framer.spare().fill(b' ');
    framer.filled(usize::MAX);
    assert_eq!(framer.next_frame(), Ok(None));
    assert!(framer.is_idle());
}

#[test]
fn garbage_is_an_error_that_stays() {
    let cases: [(&[u8], &[u8]); 7] = [
        (b"\0{}", b"\0"),
        (b"}", b"}"),
        (b"[1, 2]", b"[1, 2]"),
        (b"joint_actual_position:(1,2)\n", b"joint_actual_position:(1,2)\n"),
        (b"\xef\xbb\xbf{\"a\": 1}", b"\xef\xbb\xbf"),
        (b") {} x", b") "),
        (&[b'x'; 65], &[b'x'; 64]),
    ];
    for (bytes, excerpt) in cases {
        let mut framer = Framer::default();
        let outcome = run(&mut framer, [[b"{\"first\": 1} ", bytes].concat().as_slice()]);
        assert_eq!(outcome, (vec![b"{\"first\": 1}".to_vec()], Err(garbage(excerpt))));
        framer.push(b"{}");
        assert_eq!(framer.next_frame(), Err(garbage(excerpt)));
        assert!(!framer.is_idle());
    }
}

#[test]
fn errors_show_what_they_met() {
    assert_eq!(garbage(b"\0a`~\x7f\xff\n").to_string(), r"bytes that do not begin a frame: `\x00a`~\x7f\xff\x0a`");
    assert_eq!(too_long(9, b"{\"a\": [1,").to_string(), "frame longer than 9 bytes: `{\"a\": [1,`");
}

#[test]
fn the_limit_is_the_same_at_every_split() {
    for document in DOCUMENTS.into_iter().filter(|document| document.len() > 2) {
        let len = document.len();
        let stream = [b"{} ", document, b" {}"].concat();
        for (at, limit) in (0..=stream.len()).flat_map(|at| [len - 1, len, len + 1].map(|limit| (at, limit))) {
            let (found, end) = run(&mut Framer::new(limit), split_at(&stream, at));
            if limit < len {
                let error = too_long(limit, &document[..len.min(EXCERPT)]);
                assert_eq!((found.len(), end), (1, Err(error)), "{at}");
            } else {
                assert_eq!((found.len(), end), (3, Ok(())), "{at}");
            }
        }
    }
}

#[test]
fn a_frame_that_does_not_end_is_too_long() {
    for limit in 0..4 {
        let mut framer = Framer::new(limit);
        let (found, end) = run(&mut framer, b"{\"aaaaaa".chunks(1));
        assert_eq!((found.len(), end), (0, Err(too_long(limit, &b"{\"aa"[..=limit]))));
        assert!(framer.visited() <= framer.partial().len() as u64);
    }
}

#[test]
fn resync_goes_on_at_the_next_object() {
    let stream = b"{\"a\": 1} ?? (x) {\"b\": 2}";
    for at in 0..=stream.len() {
        let mut framer = Framer::default();
        let (mut found, mut dropped) = (Vec::new(), 0);
        for piece in split_at(stream, at) {
            let (more, end) = run(&mut framer, [piece]);
            found.extend(more);
            if end.is_err() {
                dropped += framer.resync();
                found.extend(run(&mut framer, [b"".as_slice()]).0);
            }
        }
        assert_eq!(found, [b"{\"a\": 1}", b"{\"b\": 2}"], "{at}");
        assert!((1..=7).contains(&dropped), "{at}");
        assert_eq!(framer.visited(), stream.len() as u64, "{at}");
        assert_eq!(framer.resync(), 0);
    }
}

#[test]
fn resync_skips_a_frame_too_long() {
    for limit in [0, 1, 9, 14] {
        let mut framer = Framer::new(limit);
        let stream = b"{\"a\": \"0123456\"}{}";
        framer.push(stream);
        assert_eq!(framer.next_frame(), Err(too_long(limit, &stream[..=limit])));
        assert_eq!(framer.resync(), 16);
        assert_eq!(framer.partial(), b"{}");
        assert_eq!(framer.next_frame().is_ok(), limit >= 2);
    }
}

#[test]
fn memory_is_bounded_and_time_linear() {
    const TOTAL: usize = 100_000_000;
    let max_frame = 16 << 10;
    let filler = "0, ".repeat(3_044);
    let packet = format!("{{\"len\": 9183, \"name\": \"a \\\"b\\\" {{\", \"din\": [{filler}0]}}");
    let stream = packet.repeat(2 * 1460);
    let mut framer = Framer::new(max_frame);
    let (mut sent, mut found) = (0, 0);
    for chunk in stream.as_bytes().chunks(1460).cycle().take(TOTAL / 1460) {
        framer.push(chunk);
        while framer.next_frame().expect("frames only").is_some() {
            found += 1;
        }
        sent += chunk.len();
        assert!(framer.capacity() <= 2 * max_frame + ROOM);
    }
    assert_eq!(found, sent / packet.len());
    assert_eq!(framer.visited(), sent as u64);
}

#[test]
fn memory_is_bounded_when_reads_fill_the_room() {
    for max_frame in [2_usize, 100, 5_000, 70_000] {
        let packet = [b"{".as_slice(), &vec![b' '; max_frame - 2], b"}"].concat();
        let mut bytes = packet.iter().cycle();
        let mut framer = Framer::new(max_frame);
        for _ in 0..200 {
            let room = framer.spare();
            assert!(room.len() >= ROOM);
            room.fill_with(|| *bytes.next().expect("endless"));
            framer.filled(usize::MAX);
            while framer.next_frame().expect("frames only").is_some() {}
            assert!(framer.capacity() <= 2 * max_frame + ROOM);
        }
    }
}

#[test]
fn bytes_are_moved_and_memory_grows_only_where_room_lacks() {
    let mut framer = Framer::default();
    assert_eq!(framer.spare().len(), ROOM);
    let frame = [b"{".as_slice(), &[b' '; ROOM - 64], b"}"].concat();
    framer.push(&frame);
    framer.push(b"{");
    assert_eq!(framer.next_frame(), Ok(Some(frame.as_slice())));
    framer.make_room(ROOM - framer.end);
    assert_eq!((framer.start, framer.buffer.len()), (frame.len(), ROOM), "there is just as much room");
    framer.push(&vec![b' '; ROOM - framer.end]);
    assert_eq!((framer.start, framer.buffer.len()), (frame.len(), ROOM), "what comes fits exactly");
    framer.push(b" ");
    assert_eq!((framer.start, framer.buffer.len()), (0, ROOM), "the rest is moved over what was taken");
    framer.push(&[b' '; ROOM]);
    assert_eq!(framer.buffer.len(), 2 * ROOM, "nothing was taken that could be overwritten");
}

#[test]
fn a_framer_is_shown_without_its_bytes() {
    let mut framer = Framer::default();
    framer.push(b"{\"secret\"");
    assert_eq!(framer.next_frame(), Ok(None));
    let shown = format!("{framer:?}");
    assert!(shown.contains("partial: 9") && shown.contains("visited: 9") && !shown.contains("secret"), "{shown}");
}

fn nasty_string() -> impl Strategy<Value = String> {
    let nasty = prop::sample::select(r#"{}()[]"'\/,: u0n"#.chars().chain(['\0', '\n', '机']).collect::<Vec<_>>());
    let any = prop_oneof![4 => nasty, 1 => any::<char>()];
    prop::collection::vec(any, 0..12).prop_map(String::from_iter)
}

fn object() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![any::<i64>().prop_map(Value::from), nasty_string().prop_map(Value::from)];
    let value = leaf.prop_recursive(4, 24, 6, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..6).prop_map(Value::from),
            prop::collection::vec((nasty_string(), inner), 0..6).prop_map(|entries| entries.into_iter().collect()),
        ]
    });
    prop::collection::vec((nasty_string(), value), 0..6).prop_map(|entries| Value::Object(Map::from_iter(entries)))
}

proptest! {
    #[test]
    fn any_objects_are_found_at_any_split(
        objects in prop::collection::vec((object(), prop::sample::select(vec!["", " ", "\r\n", "\t "])), 0..6),
        cuts in prop::collection::vec(1..40_usize, 1..20),
    ) {
        let wanted: Vec<_> = objects.iter().map(|(object, _)| object.to_string().into_bytes()).collect();
        let stream: String = objects.iter().flat_map(|(object, gap)| [gap.to_string(), object.to_string()]).collect();
        let mut rest = stream.as_bytes();
        let pieces = cuts.iter().cycle().map_while(|&cut| {
            let (piece, more) = rest.split_at(cut.min(rest.len()));
            rest = more;
            (!piece.is_empty()).then_some(piece)
        });
        let mut framer = Framer::default();
        prop_assert_eq!(run(&mut framer, pieces), (wanted, Ok(())));
        prop_assert_eq!(framer.visited(), stream.len() as u64);
    }

    #[test]
    fn any_bytes_are_visited_at_most_once(
        bytes in prop::collection::vec(prop::sample::select(b"{}()\"'\\ x\0".to_vec()), 0..200),
        cut in 1..9_usize,
    ) {
        let mut framer = Framer::new(20);
        for piece in bytes.chunks(cut) {
            framer.push(piece);
            while framer.next_frame() != Ok(None) {
                framer.resync();
            }
        }
        prop_assert_eq!(framer.visited(), bytes.len() as u64);
    }
}

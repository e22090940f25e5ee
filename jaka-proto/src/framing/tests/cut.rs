//! Status packets of which one is cut.

use super::*;

/// Packets with all that a cut can fall into. Each says in `"id"` which it is.
fn packets() -> Vec<Vec<u8>> {
    let packets = [
        r#"{"len": 61, "id": 0, "din": [0, 1, 0, 1], "errmsg": "text"}"#,
        r#"{"len": 1, "id": 1, "errmsg": "it sends {\"len\": 5, \"a\": {\"len\"", "brace": "{", "{": "}{", "x": "\\"}"#,
        r#"{"len": 1, "id": 2, "extio": {"len": 3, "setup": [{"len": 1}, {"len": 2} , {}], "end": [ {"len": 0}]}}"#,
        r#"{"len":1,"id":3,"extio":{"len":3,"setup":[{"len":1},{"len":2}]},"errmsg":"{","last":-1.5e3}"#,
        r#"{"len": 1, "id": 4, "enabled": true, "nothing": null, "deep": [[[{"a": [{"len": "len"}]}]]], "q": "\"{"}"#,
        "{\"len\": 1, \"id\": 5, \"errmsg\": \"机器人 \u{fffd} {\", \"position\": [1.5, -2, 0, 0, 0, 0]}",
        r#"{"len": 1, "id": 6, "enabled": false}"#,
        r#"{"len": 1, "id": 7, "enabled": false}"#,
    ];
    packets.map(|packet| packet.as_bytes().to_vec()).to_vec()
}

/// All frames, and how many bytes were dropped after errors, fed in one piece or in several.
fn frames(stream: &[u8], piece: usize) -> (Vec<Vec<u8>>, usize) {
    let mut framer = Framer::for_status(10_000);
    let (mut found, mut dropped) = (Vec::new(), 0);
    for piece in stream.chunks(piece) {
        framer.push(piece);
        loop {
            dropped += framer.lost().len();
            match framer.next_frame() {
                Ok(Some(frame)) => found.push(frame.to_vec()),
                Ok(None) => break,
                Err(_) => dropped += framer.resync(),
            }
        }
    }
    assert!(framer.visited() <= stream.len() as u64, "bytes are visited twice");
    // White space between packets is neither.
    assert!(found.iter().map(Vec::len).sum::<usize>() + dropped + framer.partial().len() <= stream.len());
    (found, dropped)
}

#[test]
fn whole_packets_are_found_whatever_their_text_says() {
    for gap in ["", " ", "\r\n"] {
        let stream = packets().join(gap.as_bytes());
        for piece in [1, 2, 3, 7, stream.len()] {
            assert_eq!(frames(&stream, piece), (packets(), 0), "{gap:?}");
        }
    }
}

#[test]
fn a_packet_that_is_cut_anywhere_costs_itself_and_at_most_the_next() {
    let packets = packets();
    for cut in 0..packets.len() - 2 {
        for end in 1..packets[cut].len() {
            let mut sent = packets.clone();
            sent[cut].truncate(end);
            let stream = sent.concat();
            let (found, _) = frames(&stream, stream.len());
            let without = |lost: usize| {
                let kept = packets.iter().enumerate().filter(|(at, _)| !(cut..cut + lost).contains(at));
                kept.map(|(_, packet)| packet.clone()).collect::<Vec<_>>()
            };
            let broken = String::from_utf8_lossy(&sent[cut]);
            assert!(found == without(1) || found == without(2), "after {broken}");
            // It is lost only where a value may follow what came.
            let may_follow = broken.trim_end().ends_with([':', ',', '[']) && found == without(2);
            assert!(found == without(1) || may_follow, "after {broken}");
            for piece in [1, 5] {
                assert_eq!(frames(&stream, piece).0, found, "in pieces of {piece}, after {broken}");
            }
        }
    }
}

#[test]
fn a_packet_whose_beginning_is_missing_costs_itself_alone() {
    let packets = packets();
    for cut in 0..packets.len() - 2 {
        for start in 1..packets[cut].len() {
            let mut sent = packets.clone();
            sent[cut].drain(..start);
            // The rest may look whole, where an object stands inside.
            let left = sent[cut].clone();
            let stream = sent.concat();
            let (found, _) = frames(&stream, stream.len());
            let real: Vec<_> = found.iter().filter(|frame| packets.contains(frame)).cloned().collect();
            let kept = packets.iter().enumerate().filter(|(at, _)| *at != cut).map(|(_, packet)| packet.clone());
            assert_eq!(real, kept.collect::<Vec<_>>(), "after {}", String::from_utf8_lossy(&left));
            for frame in found.iter().filter(|frame| !packets.contains(frame)) {
                assert!(left.windows(frame.len()).any(|inner| inner == *frame), "it was made up");
            }
        }
    }
}

#[test]
fn packets_that_are_all_cut_are_searched_in_linear_time() {
    let cut = &packets()[1][..40];
    let stream = [cut.repeat(10_000), packets()[7].clone()].concat();
    for piece in [1, 1000] {
        assert_eq!(frames(&stream, piece), (vec![packets()[7].clone()], cut.len() * 10_000));
    }
}

#[test]
fn a_cut_is_told_with_what_came_last() {
    let mut framer = Framer::for_status(1000);
    framer.push(br#"{"len": 5, "din": [0, 1{"len": 9}"#);
    let error = framer.next_frame().expect_err("it is cut");
    assert_eq!(error.to_string(), r#"packet that breaks off at `{"len": 5, "din": [0, 1`"#);
    assert_eq!(framer.next_frame(), Err(error));
    assert_eq!((framer.resync(), framer.resync()), (23, 0));
    assert_eq!(framer.next_frame(), Ok(Some(br#"{"len": 9}"#.as_slice())));
    framer.push(&[br#"{"len": 5, "errmsg": ""#.as_slice(), &[b'x'; 70], br#"{"len": 9}"#].concat());
    assert_eq!(framer.next_frame(), Err(FrameError::Cut { excerpt: Excerpt(vec![b'x'; 64]) }));
}

#[test]
fn a_tuple_is_not_a_packet() {
    let mut framer = Framer::for_status(1000);
    framer.push(b"(0, 1)");
    assert!(matches!(framer.next_frame(), Err(FrameError::Garbage { .. })));
}

#[test]
fn replies_are_left_in_peace() {
    let mut framer = Framer::default();
    framer.push(br#"{"a": 1 {"len": 9}"#);
    assert_eq!(framer.next_frame(), Ok(None));
}

proptest! {
    #[test]
    fn any_objects_are_found_after_a_cut(
        objects in prop::collection::vec(object(), 5),
        end in any::<prop::sample::Index>(),
        piece in 1..60_usize,
    ) {
        let packet = |(id, object): (usize, &Value)| {
            let text = object.to_string();
            let rest = text.strip_prefix("{}").map_or_else(|| format!(", {}", &text[1..]), |_| "}".to_owned());
            format!("{{\"len\": {id}{rest}").into_bytes()
        };
        let packets: Vec<_> = objects.iter().enumerate().map(packet).collect();
        let mut sent = packets.clone();
        sent[1].truncate(1 + end.index(packets[1].len() - 1));
        let (found, _) = frames(&sent.concat(), piece);
        let lost_one: Vec<_> = [&packets[..1], &packets[2..]].concat();
        let lost_two: Vec<_> = [&packets[..1], &packets[3..]].concat();
        prop_assert!(found == lost_one || found == lost_two, "{found:?}");
    }
}

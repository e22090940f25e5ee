use std::time::Duration;

use crate::{Fault, FaultPlan, LinkFault, StatusFault};

fn plan(text: &str) -> FaultPlan {
    text.parse().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn each_fault_has_a_text() {
    let faults = [
        ("none", Fault::None),
        ("drop", Fault::Drop),
        ("delay 200ms", Fault::Delay(Duration::from_millis(200))),
        ("delay 1.5s", Fault::Delay(Duration::from_millis(1500))),
        ("hold", Fault::Hold),
        ("split", Fault::Pieces(vec![])),
        ("split 1 5", Fault::Pieces(vec![1, 5])),
        ("with-next", Fault::WithNext),
        ("twice", Fault::Twice),
        ("nameless", Fault::Nameless),
        ("renamed jog", Fault::Renamed("jog".to_owned())),
        (r#"renamed "fly \"away\" \xc3\xa4, #""#, Fault::Renamed("fly \"away\" ä, #".to_owned())),
        (r#"before "\x00\xff""#, Fault::Before(vec![0, 255])),
        (r#"after "{};""#, Fault::After(b"{};".to_vec())),
        (r#"instead "(0, [])\r\n\t\\""#, Fault::Instead(b"(0, [])\r\n\t\\".to_vec())),
        ("garbage 40 7", Fault::Garbage { bytes: 40, seed: 7 }),
        ("oversized 100000", Fault::Oversized(100_000)),
        ("half-open", Fault::HalfOpen),
        ("close", Fault::Close),
        ("close-after 17", Fault::CloseAfter(17)),
        ("reset", Fault::Reset),
        ("takeover", Fault::Takeover),
    ];
    for (text, fault) in &faults {
        assert_eq!(text.parse().as_ref(), Ok(fault));
        assert_eq!(&fault.to_string(), text);
    }
    let all = FaultPlan::script(faults.map(|(_, fault)| fault));
    assert_eq!(plan(&all.to_string()), all);
    assert_eq!("garbage 3".parse(), Ok(Fault::Garbage { bytes: 3, seed: 0 }));
    assert_eq!("delay 3us".parse(), "delay 3000ns".parse::<Fault>());
}

#[test]
fn each_status_fault_has_a_text() {
    let faults = [
        ("none", StatusFault::None),
        ("silent", StatusFault::Silent),
        ("slow 2s", StatusFault::Slow(Duration::from_secs(2))),
        ("split 7", StatusFault::Pieces(7)),
        ("garbage 40 7", StatusFault::Garbage { bytes: 40, seed: 7 }),
        ("cut 100", StatusFault::Cut(100)),
        (r#"instead "a:(0, 1)\n""#, StatusFault::Instead(b"a:(0, 1)\n".to_vec())),
        ("close-after 5000", StatusFault::CloseAfter(5000)),
    ];
    for (text, fault) in faults {
        assert_eq!(text.parse().as_ref(), Ok(&fault));
        assert_eq!(fault.to_string(), text);
        assert_eq!(plan(&format!("status {text}")), FaultPlan::new().status(fault));
    }
}

#[test]
fn each_link_fault_has_a_text() {
    let faults = [
        ("none", LinkFault::None),
        ("hold", LinkFault::Hold),
        ("delay 800ms", LinkFault::Delay(Duration::from_millis(800))),
        ("slow 9600", LinkFault::Slow(9600)),
        ("cut", LinkFault::Cut),
    ];
    for (text, fault) in faults {
        assert_eq!(text.parse().as_ref(), Ok(&fault));
        assert_eq!(fault.to_string(), text);
    }
}

#[test]
fn a_plan_is_its_lines() {
    let expected = FaultPlan::random(7)
        .one_in(20, [Fault::Drop, Fault::Reset])
        .then(Fault::Drop)
        .then(Fault::Hold)
        .then(Fault::Twice)
        .then_for("joint_move", Fault::Drop)
        .then_for("joint_move", Fault::Pieces(vec![2]))
        .always(Fault::Close)
        .status(StatusFault::Cut(7));
    let lines = "\n# all of it\ndrop, hold # two\r\n  twice\nfor joint_move: drop, split 2\nrandom 7 1/20 drop,reset\nalways close\nstatus cut 7";
    assert_eq!(plan(lines), expected);
    assert_eq!(
        plan("drop,hold;twice;for joint_move:drop,split 2;random 7 1/20 drop , reset ; always close;status cut 7"),
        expected
    );
    assert_eq!(plan(&expected.to_string()), expected);
    assert_eq!(plan(" \n;;# nothing"), FaultPlan::new());
}

#[test]
fn errors_name_line_and_word() {
    let cases = [
        ("dely", "line 1: `dely`: unknown fault"),
        ("drop\n\nhold, delay", "line 3: `delay`: expected a time such as 200ms or 1.5s next"),
        ("delay 200", "line 1: `200`: expected a time such as 200ms or 1.5s"),
        ("delay -1s", "line 1: `-1s`: expected a time such as 200ms or 1.5s"),
        ("delay 1e99s", "line 1: `1e99s`: expected a time such as 200ms or 1.5s"),
        ("split 1 x", "line 1: `x`: expected a number of bytes"),
        ("drop hold", "line 1: `hold`: expected `,`"),
        ("drop,", "line 1: `,`: expected a fault next"),
        ("drop, always hold", "line 1: `always`: this can only begin a line"),
        ("always drop, hold", "line 1: `,`: expected the end of the line"),
        ("for jog drop", "line 1: `drop`: expected `:`"),
        ("for", "line 1: `for`: expected a command next"),
        ("random 7 1/20", "line 1: `1/20`: expected a fault next"),
        ("random 7 20 drop", "line 1: `20`: expected odds such as 1/20"),
        ("random 7 1/2 drop\nrandom 8 1/2 drop", "line 2: `8`: the seed is already 7, and a plan has only one"),
        ("status drop", "line 1: `drop`: unknown fault of the status port"),
        ("instead x", "line 1: `x`: expected bytes in quotes"),
        ("instead \"x", "line 1: `\"x`: the quote is not closed"),
        ("instead \"\\q\"", "line 1: `\"\\q\"`: an escape is not one of Rust's for bytes"),
        ("renamed \"\\xff\"", "line 1: `\"\\xff\"`: a name must be UTF-8"),
    ];
    for (text, message) in cases {
        assert_eq!(text.parse::<FaultPlan>().map_err(|error| error.to_string()), Err(message.to_owned()));
    }
    assert_eq!("".parse::<Fault>().map_err(|error| error.to_string()), Err("``: expected a fault next".to_owned()));
}

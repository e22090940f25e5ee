//! Code that a newcomer copies. It moves an arm that may be in any position, next to a person who has never seen it
//! move.

use std::fs;
use std::path::Path;

/// The first block of code that moves the arm, in a file of the project.
fn first_motion(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let text = text.replace("/// ", "");
    let blocks = text.split("```").skip(1).step_by(2).map(str::to_owned);
    blocks.into_iter().find(|block| block.contains("JointMove::")).expect("it shows a motion")
}

#[test]
fn the_first_motion_is_small_and_slow_and_can_be_stopped() {
    for path in
        ["README.md", "jaka-robot/docs/overview.md", "jaka-robot/src/robot.rs", "jaka-robot/examples/first_motion.rs"]
    {
        let code = if path.contains("examples") {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
            fs::read_to_string(path).expect("it is there")
        } else {
            first_motion(path)
        };
        for part in [
            // Joints in deg, speed in deg/s.
            "JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 5.0)",
            "stop_handle()",
            "ctrlc::set_handler",
        ] {
            assert!(code.contains(part), "{path}: {part}");
        }
        assert!(!code.contains("MoveMode::Absolute") && !code.contains("::absolute("), "{path}");
    }
}

#[test]
fn no_example_prints_its_error_as_debug() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../jaka-robot/examples");
    let mut texts = vec![("README.md".to_owned(), first_motion("README.md"))];
    for entry in fs::read_dir(folder).expect("it is there") {
        let path = entry.expect("it can be read").path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            texts.push((path.display().to_string(), fs::read_to_string(&path).expect("it is text")));
        }
    }
    assert!(texts.len() > 9);
    for (path, text) in texts {
        assert!(text.contains("fn main() -> ExitCode {"), "{path}");
        assert!(!text.contains("{error:?}") && !text.contains("{:?}\", error"), "{path}");
    }
}

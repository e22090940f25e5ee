//! `jaka man`: pages of the manual.

use std::collections::BTreeSet;
use std::fs;

use crate::program::{jaka, scratch};

/// The commands that a help lists.
fn commands(help: &str) -> Vec<String> {
    let (_, rest) = help.split_once("\nCommands:\n").expect("it has a list");
    let list = rest.split("\n\n").next().expect("the list ends");
    let rows = list.lines().filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')));
    let names = rows.filter_map(|line| line.split(' ').next()).filter(|name| *name != "help");
    names.map(str::to_owned).collect()
}

#[test]
fn each_command_has_a_page() {
    let folder = scratch("man1");
    fs::remove_dir_all(&folder).ok();
    let run = jaka(["man".as_ref(), folder.as_os_str()]);
    assert_eq!(run.text(), "exit code 0\n");
    let pages: BTreeSet<_> = fs::read_dir(&folder)
        .expect("it was made")
        .map(|entry| entry.expect("it can be read").file_name().into_string().expect("it is UTF-8"))
        .collect();
    let mut expected = BTreeSet::from(["jaka.1".to_owned()]);
    expected.extend(commands(&jaka(["--help"]).out).iter().map(|name| format!("jaka-{name}.1")));
    expected.extend(commands(&jaka(["spec", "--help"]).out).iter().map(|name| format!("jaka-spec-{name}.1")));
    assert_eq!(pages, expected);
    for page in &pages {
        let text = fs::read_to_string(folder.join(page)).expect("it is text");
        for part in [".TH jaka", ".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", "color"] {
            assert!(text.contains(part), "{page} has no {part}: {text}");
        }
    }
    let jog = fs::read_to_string(folder.join("jaka-jog.1")).expect("it is text");
    for part in [
        "jaka\\-jog \\- Move one joint",
        "\\fB\\-\\-acceleration\\fR",
        "jaka jog 6 5 \\-\\-speed 5 \\-r cell1",
        ".SH ROBOT",
    ] {
        assert!(jog.contains(part), "{part} in {jog}");
    }
    assert!(fs::read_to_string(folder.join("jaka-call.1")).expect("it is text").contains("\\-\\-params"));
}

#[test]
fn the_page_of_the_program_goes_to_standard_output() {
    let page = jaka(["man"]);
    assert_eq!((page.code, page.err.as_str()), (Some(0), ""));
    for part in [".TH jaka 1", "jaka\\-status(1)", ".SH NOTES\n.in 0", "Exit codes:", "the command may have run"] {
        assert!(page.out.contains(part), "{part} in {}", page.out);
    }
    assert!(!page.out.contains("complete\\-words"), "{}", page.out);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let file = scratch("file");
    fs::write(&file, "").expect("it can be written");
    let run = jaka(["man".as_ref(), file.as_os_str()]);
    assert_eq!(run.code, Some(6), "{run:?}");
    assert!(run.err.starts_with(&format!("error: cannot write pages to {}", file.display())), "{run:?}");
}

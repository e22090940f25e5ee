//! The READMEs of crates, as they are shown where no rustdoc makes links: made from `docs/overview.md`, the crate's
//! documentation.

use std::fs;

use expect_test::expect_file;

use super::{read, root};

/// The crates whose documentation has links of rustdoc, or lines that rustdoc hides.
const CRATES: [&str; 7] =
    ["jaka-clock", "jaka-dynamic", "jaka-motion", "jaka-proto", "jaka-robot", "jaka-sim", "jaka-sync"];

/// The page without lines that rustdoc hides, and without links that it alone follows.
fn hosted(overview: &str) -> String {
    let shown = |(at, part): (usize, &str)| if at % 2 == 1 { without_hidden_lines(part) } else { without_links(part) };
    overview.split("```").enumerate().map(shown).collect::<Vec<_>>().join("```")
}

fn without_hidden_lines(code: &str) -> String {
    // In other languages `#` begins a comment.
    let info = code.lines().next().unwrap_or_default();
    if !["", "rust", "no_run", "ignore", "should_panic"].iter().any(|word| info.split(',').next() == Some(word)) {
        return code.to_owned();
    }
    let is_hidden = |line: &&str| *line == "#" || line.starts_with("# ");
    code.split('\n').filter(|line| !is_hidden(line)).collect::<Vec<_>>().join("\n")
}

/// Links to items become their text; those to other sites and within the page stay.
fn without_links(prose: &str) -> String {
    let mut parts = prose.split('[');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let Some((text, after)) = part.split_once(']') else {
            out.extend(["[", part]);
            continue;
        };
        let target = after.strip_prefix('(').and_then(|rest| rest.split_once(')'));
        match target {
            Some((target, _)) if target.starts_with("https://") || target.starts_with('#') => out.extend(["[", part]),
            Some((_, after)) => out.extend([text, after]),
            None if text.starts_with('`') && text.ends_with('`') => out.extend([text, after]),
            None => out.extend(["[", part]),
        }
    }
    out
}

#[test]
fn the_readmes_of_crates_are_their_overviews() {
    for name in CRATES {
        let folder = root().join(name);
        let library = read(&folder.join("src/lib.rs"));
        assert!(library.starts_with("#![doc = include_str!(\"../docs/overview.md\")]"), "{name}");
        expect_file![folder.join("README.md")].assert_eq(&hosted(&read(&folder.join("docs/overview.md"))));
    }
}

/// Pages that rustdoc shows as modules, and that a forge shows in `docs/`.
const PAGES: [(&str, &str); 2] = [("jaka-robot", "cookbook.md"), ("jaka-sync", "newer-firmware.md")];

/// The page of a forge: as a README, and each block of code has its language.
fn of_forge(page: &str) -> String {
    let shown = hosted(page);
    let parts = shown.split("```").enumerate().map(|(at, part)| {
        let (info, code) = part.split_once('\n').unwrap_or((part, ""));
        match info {
            _ if at % 2 == 0 => part.to_owned(),
            "" | "no_run" | "ignore" | "should_panic" => format!("rust\n{code}"),
            _ => part.to_owned(),
        }
    });
    parts.collect::<Vec<_>>().join("```")
}

#[test]
fn pages_of_rustdoc_are_shown_by_a_forge_too() {
    for (name, page) in PAGES {
        let source = read(&root().join(name).join("docs").join(page));
        expect_file![root().join("docs").join(page)].assert_eq(&of_forge(&source));
    }
}

#[test]
fn no_readme_has_what_only_rustdoc_understands() {
    let folders = fs::read_dir(root()).expect("it is there").map(|entry| entry.expect("it can be read").path());
    let readmes: Vec<_> = folders.map(|folder| folder.join("README.md")).filter(|path| path.exists()).collect();
    assert!(readmes.len() >= 8, "{readmes:?}");
    for path in readmes {
        let text = read(&path);
        for (at, part) in text.split("```").enumerate() {
            let is_fine = if at % 2 == 1 {
                !part.starts_with("rust") || without_hidden_lines(part) == part
            } else {
                !part.contains("](crate::") && part.split("`]").skip(1).all(|after| after.starts_with('('))
            };
            assert!(is_fine, "{}: {part}", path.display());
        }
    }
}

#[test]
fn what_rustdoc_alone_understands_is_left_out() {
    let page = "A [`B`], [`c`](B::c), [d](#d), [\"e\"](crate::e), [f](https://f), g[0].\n```rust\nlet h = 1;\n# i()\n#\n```\n```toml\n# j\n```\n";
    let expected = "A `B`, `c`, [d](#d), \"e\", [f](https://f), g[0].\n```rust\nlet h = 1;\n```\n```toml\n# j\n```\n";
    assert_eq!(hosted(page), expected);
}

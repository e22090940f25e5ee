//! The Chinese edition: front matter, traps, and indexes that lead into the English one.

use super::markdown::{Table, code, link_into};
use super::{by_section, command_heading, pages};
use crate::words;
use crate::{Command, Spec};

/// The file of the English edition, to which the Chinese one links.
const ENGLISH: &str = "REFERENCE.md";

/// The Chinese edition of the [reference](super::reference), in Markdown: its front matter and its traps, and by section of the
/// document which commands have errata, and all commands.
///
/// It links to the English edition, which has the rest, as `REFERENCE.md` in the same folder.
pub fn reference_zh(spec: &Spec) -> String {
    let mut out = String::from("# JAKA TCP 协议\n\n");
    out += &pages::CHINESE.join("\n");
    errata(&mut out, spec);
    index(&mut out, spec);
    out.truncate(out.trim_end().len());
    out + "\n"
}

fn errata(out: &mut String, spec: &Spec) {
    *out += "\n";
    *out += pages::CHINESE_ERRATA;
    *out += "\n";
    let mut table = Table::new(&["章节", "命令", "勘误条数"]);
    for (_, command) in by_section(spec).into_iter().filter(|(_, command)| !command.errata.is_empty()) {
        table.row([section(command), command_link(command), command.errata.len().to_string()]);
    }
    table.render(out);
}

fn index(out: &mut String, spec: &Spec) {
    *out += pages::CHINESE_INDEX;
    *out += "\n";
    let mut table = Table::new(&["章节", "命令", "作用"]);
    for (_, command) in by_section(spec) {
        table.row([section(command), command_link(command), words::effect(command.effect).to_owned()]);
    }
    table.render(out);
}

fn section(command: &Command) -> String {
    command.section.clone().unwrap_or_default()
}

fn command_link(command: &Command) -> String {
    link_into(ENGLISH, &code(&command.wire), &command_heading(command))
}

//! The Chinese edition: front matter, traps, errata, and an index that leads into the English one.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use toml::Spanned;
use toml::de::DeTable;

use super::markdown::{Table, code, escape, link_into};
use super::{by_section, command_heading};
use crate::{Command, Spec};

/// The file of the English edition, to which the Chinese one links.
const ENGLISH: &str = "REFERENCE.md";
/// The front matter and the traps of the Chinese edition.
const PAGES: [&str; 2] =
    [include_str!("../../../reference/zh/about.md"), include_str!("../../../reference/zh/traps.md")];

/// The heading of the Chinese edition's errata.
const ERRATA: &str = include_str!("../../../reference/zh/errata.md");
/// The heading of the Chinese edition's index.
const INDEX: &str = include_str!("../../../reference/zh/index.md");
/// The texts of the Chinese edition's errata: TOML, the Chinese ones by the English ones.
const ERRATA_TEXTS: &str = include_str!("../../../reference/zh/errata.toml");

/// The Chinese edition of the [reference](super::reference), in Markdown: its front matter and its traps, and by
/// section of the document the errata and all commands. An erratum without a Chinese text is in English.
///
/// It links to the English edition, which has the rest, as `REFERENCE.md` in the same folder.
pub fn reference_zh(spec: &Spec) -> String {
    let mut out = String::from("# JAKA TCP 协议\n\n");
    out += &PAGES.join("\n");
    errata(&mut out, spec);
    index(&mut out, spec);
    out.truncate(out.trim_end().len());
    out + "\n"
}

fn errata(out: &mut String, spec: &Spec) {
    *out += "\n";
    *out += ERRATA;
    let chinese = chinese_errata();
    for (_, command) in by_section(spec).into_iter().filter(|(_, command)| !command.errata.is_empty()) {
        let heading = format!("{} {}", section(command), command.title_zh.as_deref().unwrap_or_default());
        let heading = match heading.trim() {
            "" => String::new(),
            heading => format!("**{heading}** "),
        };
        let _ = writeln!(out, "\n{heading}{}\n", command_link(command));
        for erratum in &command.errata {
            let _ = writeln!(out, "- {}", escape(chinese.get(erratum).unwrap_or(erratum)));
        }
    }
    *out += "\n";
}

/// The Chinese texts of errata, by the English ones.
fn chinese_errata() -> BTreeMap<String, String> {
    let table = DeTable::parse(ERRATA_TEXTS).map(Spanned::into_inner).unwrap_or_default();
    let texts = table.iter().filter_map(|(english, chinese)| Some((english.get_ref(), chinese.get_ref().as_str()?)));
    texts.map(|(english, chinese)| (english.to_string(), chinese.to_owned())).collect()
}

fn index(out: &mut String, spec: &Spec) {
    *out += INDEX;
    *out += "\n";
    let mut table = Table::new(&["章节", "标题", "命令", "主题", "作用"]);
    for (topic, command) in by_section(spec) {
        let [title, topic] = [&command.title_zh, &topic.title_zh].map(|text| text.clone().unwrap_or_default());
        let effect = command.effect.word().to_owned();
        table.row([section(command), title, command_link(command), topic, effect]);
    }
    table.render(out);
}

fn section(command: &Command) -> String {
    command.section.clone().unwrap_or_default()
}

fn command_link(command: &Command) -> String {
    link_into(ENGLISH, &code(&command.wire), &command_heading(command))
}

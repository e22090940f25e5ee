//! `jaka spec doc` and `jaka spec schema`: documents generated from the spec.

use std::borrow::Cow;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use jaka_spec::{Spec, tools};
use jaka_sync::proto::text::visible_lines;

use crate::choice::{Choice, one_of};
use crate::failure::Failure;
use crate::target::Lookup;
use crate::target::packs::SpecArgs;
use crate::terminal::output;

/// Write the protocol's reference, in Markdown.
#[derive(Debug, Args)]
pub(super) struct Reference {
    /// Language; the Chinese edition has the front matter, the traps, the errata and the index, and links to
    /// `REFERENCE.md`
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = one_of(&LANGUAGES))]
    lang: Make,
    #[command(flatten)]
    document: Document,
}

/// Generator of a document from a spec.
type Make = fn(&Spec) -> String;

const LANGUAGES: [Choice<Make>; 2] =
    [("en", "English", tools::reference as Make), ("zh", "Chinese", tools::reference_zh)];

impl Reference {
    pub(super) fn run(&self) -> Result<(), Failure> {
        self.document.run(self.lang, visible_lines)
    }
}

#[derive(Debug, Args)]
pub(super) struct Document {
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    spec: SpecArgs,
}

impl Document {
    /// Writes the document that `make` returns for the built-in spec with its packs, with invisible characters made
    /// `visible`.
    pub(super) fn run(&self, make: Make, visible: impl Fn(&str) -> Cow<'_, str>) -> Result<(), Failure> {
        let text = make(&self.spec.load(Lookup::default())?.spec);
        let text = visible(&text);
        let Some(path) = &self.output else { return output::write(text.as_bytes()) };
        fs::write(path, &*text).map_err(|error| Failure::unwritten(path, error))
    }
}

/// Returns the JSON Schema as text.
pub(super) fn schema(spec: &Spec) -> String {
    format!("{:#}\n", tools::schema(spec))
}

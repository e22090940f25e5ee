//! Evidence for facts beyond the vendor's document: one scale of marks.

use std::fmt;

use crate::item::Item;

/// Source of a fact that the vendor's document does not have, or explains otherwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Evidence {
    /// Kind of the source.
    pub mark: Mark,
    /// Name of the source, or its content.
    pub detail: Option<String>,
}

toml_words! {
    /// Kinds of sources, in the order of the reference's scale, which is not an order of trust: a capture shows one
    /// controller.
    pub enum Mark {
        /// The TCP document 2.0.4, in a text of it that is not the command's own section.
        Document: "document",
        /// Another text of the vendor: a page, a manual, a header, the table of events, release notes.
        Page: "page",
        /// Bytes of the vendor's own client libraries: their requests, and the keys that they read.
        Bytes: "bytes",
        /// Capture or transcript of a real controller.
        Capture: "capture",
        /// Several independent programs.
        Clients: "clients",
        /// One program.
        Client: "client",
        /// Collected evidence without a record of its source.
        Notes: "notes",
    }
}

impl Mark {
    /// Kind of the source in words, such as `a capture of a controller`.
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Document => "the document",
            Self::Page => "another text of the vendor",
            Self::Bytes => "bytes of the vendor's client library",
            Self::Capture => "a capture of a controller",
            Self::Clients => "several independent clients",
            Self::Client => "one client",
            Self::Notes => "notes without a record of their source",
        }
    }
}

/// Kind of the source, and its name in parentheses: `one client (on version 1.7.2)`.
impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.mark.phrase())?;
        self.detail.as_ref().map_or(Ok(()), |detail| write!(f, " ({detail})"))
    }
}

/// Sources in a sentence: `Evidence: bytes of the vendor's client library (SDK 2.1.14); one client.`
pub fn evidence_sentence(evidence: &[Evidence]) -> Option<String> {
    let sources: Vec<_> = evidence.iter().map(ToString::to_string).collect();
    (!sources.is_empty()).then(|| format!("Evidence: {}.", sources.join("; ")))
}

/// Reads `evidence`, a list of marks, each with an optional detail after a colon.
pub(crate) fn read(item: &Item<'_, '_>) -> Vec<Evidence> {
    let texts = item.texts("evidence");
    let read = texts.into_iter().filter_map(|text| {
        let (mark, detail) = match text.value.split_once(": ") {
            Some((mark, detail)) => (mark, Some(detail.to_owned())),
            None => (&*text.value, None),
        };
        let found = Mark::WORDS.iter().find(|(word, _)| *word == mark).map(|(_, mark)| *mark);
        let Some(mark) = found else {
            let known: Vec<_> = Mark::WORDS.iter().map(|(word, _)| *word).collect();
            let message = format!("`evidence` begins with one of {}, and `: ` before a detail", known.join(", "));
            item.error(text.at, &message);
            return None;
        };
        if detail.as_deref().is_some_and(|detail| detail.trim() != detail || detail.is_empty() || detail.ends_with('.'))
        {
            item.error(text.at, "the detail of `evidence` is a phrase without full stop");
        }
        Some(Evidence { mark, detail })
    });
    read.collect()
}

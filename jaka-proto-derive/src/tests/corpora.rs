//! Whatever loads can be rendered: the specs and packs that fuzzing has made up.

use std::fs;

use jaka_spec::{Source, Spec};
use proc_macro2::TokenStream;
use quote::quote;

use crate::{client, error_codes, events, pack, topic};

/// The inputs of a fuzz target that are text.
fn texts(target: &str) -> Vec<String> {
    let folder = format!("{}/../tests/corpora/{target}", env!("CARGO_MANIFEST_DIR"));
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let text = |entry: std::io::Result<fs::DirEntry>| {
        let bytes = fs::read(entry.expect("the folder can be read").path()).expect("the file can be read");
        String::from_utf8(bytes).ok()
    };
    entries.filter_map(text).collect()
}

fn assert_rust(tokens: TokenStream, text: &str) {
    if let Err(error) = syn::parse2::<syn::File>(tokens) {
        panic!("{error}, from:\n{text}");
    }
}

#[test]
fn specs() {
    for text in texts("spec_file") {
        let Ok(spec) = jaka_spec::load(&[Source { path: "spec/fuzz.toml", text: &text }]) else { continue };
        assert_rust(all(&spec), &text);
    }
}

fn all(spec: &Spec) -> TokenStream {
    let topics: TokenStream = {
        let sent = spec.sent_types();
        spec.topics.iter().map(|topic| topic::module(spec, topic, &sent)).collect()
    };
    let (request, error_codes, methods) = (topic::requests(spec), error_codes::render(spec), client::methods(spec));
    let events = events::render(spec);
    quote!(#topics #request #error_codes #events #methods)
}

#[test]
fn packs() {
    let base = jaka_spec::builtin().expect("the built-in spec is correct");
    for text in texts("pack") {
        let Ok(pack) = jaka_spec::load_pack(&base, Source { path: "fuzz.toml", text: &text }) else { continue };
        assert_rust(pack::render(&pack.module(), &base, &quote!(::jaka_sync)), &text);
    }
}

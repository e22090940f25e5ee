//! Settings of the documentation's host, in manifests and at the roots of crates.

use super::{read, root};

/// The published libraries.
const LIBRARIES: [&str; 9] = [
    "jaka-clock",
    "jaka-dynamic",
    "jaka-motion",
    "jaka-proto",
    "jaka-proto-derive",
    "jaka-robot",
    "jaka-sim",
    "jaka-sync",
    "spec",
];

#[test]
fn each_library_has_the_logo() {
    let logo = read(&root().join("docs/logo.svg")).trim_end().replace('"', "'").replace('#', "%23");
    assert!(logo.len() < 1024, "{}", logo.len());
    let attribute = format!("#![doc(\n    html_logo_url = \"data:image/svg+xml,{logo}\"\n)]\n");
    for library in LIBRARIES {
        assert!(read(&root().join(library).join("src/lib.rs")).contains(&attribute), "{library} needs {attribute}");
    }
}

#[test]
fn pages_show_the_examples_of_their_package() {
    for library in LIBRARIES {
        let folder = root().join(library);
        let manifest = read(&folder.join("Cargo.toml"));
        assert!(manifest.contains("[package.metadata.docs.rs]\nall-features = true\n"), "{library}");
        // Cargo takes both: the argument, and its consent to examples that need dev-dependencies.
        for setting in ["-Zrustdoc-scrape-examples", "doc-scrape-examples = true"] {
            assert_eq!(manifest.contains(setting), folder.join("examples").exists(), "{library}: {setting}");
        }
    }
}

//! The expansion, as committed for review.

use expect_test::expect_file;
use proc_macro2::TokenStream;

use crate::codec::Scope;
use crate::{client, error_codes, request, topic};

fn pretty(tokens: TokenStream) -> String {
    let file = syn::parse2(tokens).expect("the expansion is valid Rust");
    prettyplease::unparse(&file)
}

#[test]
fn messages() {
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    for topic in &spec.topics {
        if let Some(module) = topic::module(Scope { spec: &spec, topic }) {
            expect_file![format!("../golden/{}.rs", topic.name)].assert_eq(&pretty(module));
        }
    }
    expect_file!["../golden/request.rs"].assert_eq(&pretty(request::render(&spec)));
    expect_file!["../golden/error_codes.rs"].assert_eq(&pretty(error_codes::render(&spec)));
}

#[test]
fn client_methods() {
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    expect_file!["../golden/client.rs"].assert_eq(&pretty(client::methods(&spec)));
}

//! The expansion, as committed for review.

use expect_test::{expect, expect_file};
use jaka_spec::Source;
use proc_macro2::TokenStream;

use crate::codec::Scope;
use crate::{client, compile_errors, error_codes, request, topic};

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

#[test]
fn each_error_of_the_spec_is_a_compiler_error() {
    let text = "title = \"Motion\"\n\n[[command]]\nwire = \"go\"\neffect = \"fly\"\n";
    let errors = jaka_spec::load(&[Source { path: "spec/motion.toml", text }]).expect_err("the spec is wrong");
    expect![[r#"
        ::core::compile_error!("spec/motion.toml:3:1: command `go`: `doc` is missing");
        ::core::compile_error!(
            "spec/motion.toml:5:10: command `go`: `effect` is one of query, setting, motion, power, session, not `fly`"
        );
    "#]]
    .assert_eq(&pretty(compile_errors(&errors)));
}

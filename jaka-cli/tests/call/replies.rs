//! Replies and refusals, as they are shown.

use expect_test::expect;
use jaka_sim::{Controller, Fault};
use jaka_tests::Arm;
use serde_json::json;

use crate::program::{Run, address_of, jaka, scratch};

fn call(controller: &Controller, line: &str) -> Run {
    jaka(["call"].into_iter().chain(line.split(' ')).map(str::to_owned).chain(address_of(controller)))
}

#[test]
fn a_code_that_the_spec_lacks_is_said() {
    let controller = Arm::real_time().without_power().start();
    let reply = br#"{"errorCode": "77", "errorMsg": "hot", "cmdName": "get_version"}"#;
    controller.inject(Fault::Instead(reply.to_vec()));
    expect![[r"
        error: the controller refused `get_version` with code 77: hot
        The code is not in the spec.
        exit code 1
    "]]
    .assert_eq(&call(&controller, "get_version").text());
}

#[test]
fn what_the_spec_does_not_have_is_shown_too() {
    let controller = Arm::real_time().without_power().start();
    controller.set_reply("get_payload", [("inertia".to_owned(), json!([1, 2]))]);
    expect![[r"
        centroid.x  0 mm
        centroid.y  0 mm
        centroid.z  1 mm
        mass        1 kg
        inertia     [1,2] (not in the spec)
        exit code 0
    "]]
    .assert_eq(&call(&controller, "get_payload").text());
}

#[test]
fn a_reply_that_cannot_be_read_says_where() {
    let controller = Arm::real_time().without_power().start();
    controller.set_reply("get_joint_pos", [("joint_pos".to_owned(), json!("none"))]);
    let run = call(&controller, "get_joint_pos");
    expect![[r#"
        joint_position  none
        error: `get_joint_pos` was not refused, but its reply does not fit the spec: field `joint_pos`: expected an array of 6, each a number (in deg), found `"none"`
        exit code 4
    "#]].assert_eq(&run.text());
}

#[test]
fn a_bare_tuple_is_read_as_the_field_that_it_stands_for() {
    let controller = Arm::real_time().without_power().start();
    controller.inject(Fault::Instead(b"(0, [], {'state': 0})".to_vec()));
    expect![[r"
        extio_status.count          0
        extio_status.modules        none
        extio_status.state.running  false
        exit code 0
    "]]
    .assert_eq(&call(&controller, "get_extio_status").text());
}

#[test]
fn a_silent_controller_may_have_carried_out_the_command() {
    let controller = Arm::real_time().without_power().start();
    controller.inject(Fault::Drop);
    expect![[r"
        error: no reply to `get_version` within 200ms; it may have run
        exit code 4
    "]]
    .assert_eq(&call(&controller, "get_version --timeout 0.2").text());
    controller.inject(Fault::Close);
    expect![[r"
        error: the connection to ADDRESS broke during `get_version`, which may have run; the controller may have shut down, or another client, such as the vendor's app, may have taken the command port: the controller closed the connection
        exit code 4
    "]]
    .assert_eq(&call(&controller, "get_version").text().replace(&controller.command_addr().to_string(), "ADDRESS"));
}

#[test]
fn a_controller_that_goes_down_need_not_reply() {
    let controller = Arm::real_time().without_power().start();
    controller.inject(Fault::Close);
    expect![[r"
        sent; the controller closed the connection instead of replying
        exit code 0
    "]]
    .assert_eq(&call(&controller, "shutdown --yes").text());
}

#[test]
fn the_firmware_is_asked_first() {
    let file = scratch("gate.toml");
    let text = "title = \"Gate\"\n[[extend]]\ntarget = \"joint_move\"\n[[extend.request]]\nwire = \"zone\"\ntype = \
                \"float\"\noptional = true\nsince = \"1.7.1\"\ndoc = \"Zone.\"\n[[command]]\nwire = \"new_query\"\neffect = \
                \"query\"\nuntil = \"1.4\"\ndoc = \"Reads.\"\n";
    std::fs::write(&file, text).expect("the folder is there");
    let motion = format!(
        "joint_move --mode relative --joint-position 0,0,0,0,0,0 --speed 1 --zone 1 --check-firmware --yes --pack {}",
        file.display()
    );
    let controller = Arm::real_time().without_power().start();
    expect![[r"
        error: `joint_move` was not sent: the controller's firmware 1.5.14 does not have its field `zone`; firmware 1.7.1 and later has
        exit code 2
    "]].assert_eq(&call(&controller, &motion).text());
    expect![[r"
        error: `new_query` was not sent: the controller's firmware 1.5.14 does not have it; firmware up to 1.4 has
        exit code 2
    "]]
    .assert_eq(&call(&controller, &format!("new_query --check-firmware --pack {}", file.display())).text());
    assert_eq!(controller.requests(), [r#"{"cmdName":"get_version"}"#; 2]);
    controller.set_reply("get_version", [("version".to_owned(), json!("V1.7.2"))]);
    call(&controller, &motion);
    assert_eq!(controller.requests().len(), 4);
}

#[test]
fn a_reply_says_what_it_lacks() {
    let controller = Arm::real_time().without_power().start();
    let answer = |text: &str| controller.inject(Fault::Instead(text.as_bytes().to_vec()));
    answer(r#"{"errorCode":"0","errorMsg":"","cmdName":"get_joint_pos"}"#);
    expect![[r"
        accepted
        error: `get_joint_pos` was not refused, but its reply does not fit the spec: field `joint_pos`: the key `joint_pos` is missing
        exit code 4
    "]].assert_eq(&call(&controller, "get_joint_pos").text());
    answer(r#"{"errorMsg":"","cmdName":"power_on"}"#);
    expect![[r"
        error: `power_on` was not refused, but its reply does not fit the spec: field `error_code`: the key `errorCode` is missing
        exit code 4
    "]].assert_eq(&call(&controller, "power_on --yes").text());
    answer(r#"{"errorMsg":"","cmdName":"power_on"}"#);
    expect![[r"
        error: `power_on` was not refused, but its reply does not fit the spec: field `error_code`: the key `errorCode` is missing
        exit code 4
    "]].assert_eq(&call(&controller, "power_on --yes --raw").text());
}

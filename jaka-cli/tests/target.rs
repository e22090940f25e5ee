//! Search of a command for its robot, and its message if it finds none.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::fs;
use std::net::TcpListener;
use std::path::PathBuf;

use expect_test::expect;
use jaka_tests::{Arm, ReservedPort};

use crate::common::{failure, jaka, output};
use crate::program::scratch;

/// A config file of this text, for one test.
fn config(name: &str, text: &str) -> PathBuf {
    let path = scratch(name);
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn the_config_file_has_robots_by_name() {
    let controller = Arm::real_time().without_power().start();
    let port = controller.status_addr().port();
    let text = format!("robot = 'cell1'\n[robots.cell1]\naddress = '127.0.0.1'\nstatus_port = {port}\n");
    let path = config("names.toml", &text);
    let reads = |command: &mut std::process::Command| {
        assert_eq!(output(command), ("enabled  false\n".to_owned(), String::new(), Some(0)));
    };
    reads(jaka(&["status", "-f", "enabled", "-r", "cell1"]).arg("--config").arg(&path));
    // The one that is meant if none is named.
    reads(jaka(&["status", "-f", "enabled"]).env("JAKA_CONFIG", &path));
    // The environment counts more than the config file, the command line more than both.
    let wrong = jaka(&["status"]).env("JAKA_CONFIG", &path).env("JAKA_ROBOT", "cell 2").output().unwrap();
    assert_eq!(wrong.status.code(), Some(2));
    reads(jaka(&["status", "-f", "enabled", "-r", "cell1"]).env("JAKA_CONFIG", &path).env("JAKA_ROBOT", "cell 2"));
}

#[test]
fn the_usual_config_file_is_in_the_users_folder() {
    let folder = scratch("usual");
    fs::create_dir_all(folder.join("jaka")).unwrap();
    fs::write(folder.join("jaka/config.toml"), "robot = 'cell 2'\n").unwrap();
    expect![[r#"
        error: `cell 2` is not an address, and the config file has no robot of that name
        exit code Some(2)"#]]
    .assert_eq(&failure(jaka(&["status"]).env_remove("JAKA_CONFIG").env("XDG_CONFIG_HOME", &folder)));
}

#[test]
fn a_config_file_that_is_wrong_is_named_with_the_line() {
    let path = config("wrong.toml", "[robots.cell1]\naddress = '127.0.0.1'\nport = 10000\n");
    let folder = path.display().to_string().replace("wrong.toml", "");
    let failed = failure(jaka(&["status", "-r", "cell1"]).arg("--config").arg(&path));
    expect![[r#"
        error: wrong.toml:3: unknown field `port`, expected one of `address`, `pack`, `command_port`, `status_port`, `timeout`, `connect_timeout`, `stale_after`
        exit code Some(2)"#]].assert_eq(&failed.replace(&folder, ""));
}

#[test]
fn nothing_listens_at_the_address() {
    let nobody = ReservedPort::any();
    let port = nobody.address().port().to_string();
    let (_, stderr, code) = output(&mut jaka(&["status", "-r", "127.0.0.1", "--status-port", &port]));
    assert_eq!(code, Some(3));
    assert!(stderr.starts_with(&format!("error: cannot connect to 127.0.0.1:{port}: ")), "{stderr}");
}

#[test]
fn nothing_comes_from_the_address() {
    let silent = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = silent.local_addr().unwrap().port().to_string();
    let args = ["status", "-r", "127.0.0.1", "--status-port", &port, "--timeout", "0.2"];
    expect![[r#"
        error: no status packet from 127.0.0.1:PORT within 200ms
        hint: check that this is the status port, 10000, and that the controller has started
        exit code Some(5)"#]]
    .assert_eq(&failure(&mut jaka(&args)).replace(&port, "PORT"));
}

#[test]
fn a_simulated_robot_has_no_address() {
    let (_, stderr, code) = output(&mut jaka(&["status", "--sim", "--robot", "127.0.0.1"]));
    assert_eq!(code, Some(2));
    assert!(stderr.contains("cannot be used with"), "{stderr}");
    // The environment does not contradict the command line.
    assert_eq!(output(jaka(&["status", "--sim"]).env("JAKA_ROBOT", "127.0.0.1")).2, Some(0));
}

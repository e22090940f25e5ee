//! Requests and packs that do not stand on the line.

use crate::program::{command, jaka, pack, run, scratch};

#[test]
fn whole_requests_come_from_files_and_standard_input() {
    let request = r#"{"cmdName": "rapid_rate", "rate_value": 0.5}"#;
    let file = scratch("rapid_rate.json");
    std::fs::write(&file, request).expect("the folder is there");
    let expected = "{\"cmdName\":\"rapid_rate\",\"rate_value\":0.5}\n";
    assert_eq!(jaka(["call", "--dry-run", "--params", &format!("@{}", file.display())]).out, expected);
    assert_eq!(run(command(["call", "rapid_rate", "--dry-run", "--params", "-"]), request).out, expected);
}

#[test]
fn packs_come_from_the_environment_and_the_config_file() {
    let line = ["call", "set_demo_period", "--period", "8", "--dry-run"];
    let expected = "{\"cmdName\":\"demo_set_period\",\"demo_period\":8}\n";
    let mut by_environment = command(line);
    by_environment.env("JAKA_PACK", pack("newer.toml"));
    assert_eq!(run(by_environment, "").out, expected);
    let config = scratch("packs.toml");
    std::fs::write(&config, format!("packs = ['{}']", pack("newer.toml"))).expect("the folder is there");
    let mut by_config = command(line);
    by_config.env("JAKA_CONFIG", &config);
    assert_eq!(run(by_config, "").out, expected);
    assert_eq!(jaka(line).code, Some(2));
}

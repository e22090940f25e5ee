//! Commands found by name.

#[test]
fn commands_have_two_names_and_near_ones() {
    let spec = jaka_spec::builtin().expect("the spec is correct");
    let called = |name| spec.command_called(name).map(|command| command.wire.as_str());
    assert_eq!((called("moveL"), called("move_l"), called("MoveL")), (Some("moveL"), Some("moveL"), None));
    let like = |name| spec.command_like(name).map(|command| command.wire.as_str());
    assert_eq!((like("joint_mov"), like("move_ll"), like("x")), (Some("joint_move"), Some("moveL"), None));
}

//! Trajectory recording.

use jaka_sync::trajectory::{RenameTrajFileName, SetTrajSampleMode};
use jaka_sync::types::Switch;

use super::arm::{Arm, assert_close, refused, turn, turned};

effects! {
    set_traj_sample_mode => a_recording_becomes_a_file,
    get_traj_sample_status => recording_is_told,
    get_exist_traj_file_name => files_are_listed,
    rename_traj_file_name => a_file_gets_another_name,
    remove_traj_file => a_file_is_removed,
    generate_traj_exe_file => a_recording_is_played,
}

fn files(arm: &mut Arm) -> Vec<String> {
    arm.client.get_exist_traj_file_name().expect("it answers").file_names
}

fn put_files(arm: &Arm, names: [&str; 2]) {
    arm.controller.set_state(|state| state.trajectory.file_names = names.map(str::to_owned).into());
}

/// Records a turn of joint 1, and gives where it ends.
fn record(arm: &mut Arm, file_name: &str) -> [f64; 6] {
    let end = turned(arm.joints(), 8.0);
    let sample = |mode| SetTrajSampleMode::new(mode, file_name);
    arm.client.set_traj_sample_mode(&sample(Switch::On)).expect("it answers");
    arm.client.joint_move(&turn(8.0)).expect("the arm is enabled");
    arm.wait(5);
    arm.client.set_traj_sample_mode(&sample(Switch::Off)).expect("it answers");
    end
}

fn a_recording_becomes_a_file(arm: &mut Arm) {
    assert!(!files(arm).contains(&"arch".to_owned()));
    let request = SetTrajSampleMode::new(Switch::On, "arch");
    arm.client.set_traj_sample_mode(&request).expect("it answers");
    assert!(arm.client.get_traj_sample_status().expect("it answers").sampling);
    let mut request = request;
    request.mode = Switch::Off;
    arm.client.set_traj_sample_mode(&request).expect("it answers");
    assert!(!arm.client.get_traj_sample_status().expect("it answers").sampling);
    assert!(files(arm).contains(&"arch".to_owned()));
}

fn recording_is_told(arm: &mut Arm) {
    for sampling in [true, false] {
        arm.controller.set_state(|state| state.trajectory.sampling = sampling);
        assert_eq!(arm.client.get_traj_sample_status().expect("it answers").sampling, sampling);
    }
}

fn files_are_listed(arm: &mut Arm) {
    put_files(arm, ["a", "b"]);
    assert_eq!(files(arm), ["a", "b"]);
}

fn a_file_gets_another_name(arm: &mut Arm) {
    put_files(arm, ["a", "b"]);
    let rename = |source: &str, destination: &str| RenameTrajFileName::new(source, destination);
    arm.client.rename_traj_file_name(&rename("a", "c")).expect("there is such a file");
    refused(arm.client.rename_traj_file_name(&rename("a", "d")));
    refused(arm.client.rename_traj_file_name(&rename("c", "b")));
    assert_eq!(files(arm), ["c", "b"]);
}

fn a_file_is_removed(arm: &mut Arm) {
    put_files(arm, ["a", "b"]);
    arm.client.remove_traj_file("a").expect("there is such a file");
    refused(arm.client.remove_traj_file("a"));
    assert_eq!(files(arm), ["b"]);
}

fn a_recording_is_played(arm: &mut Arm) {
    refused(arm.client.generate_traj_exe_file("arch"));
    let start = arm.joints();
    let end = record(arm, "arch");
    refused(arm.client.load_program("track/arch.jks"));
    arm.client.generate_traj_exe_file("arch").expect("it was recorded");
    arm.controller.set_state(|state| state.joint_position = start.into());
    arm.client.load_program("track/arch.jks").expect("it was written");
    arm.client.play_program().expect("the arm is enabled");
    arm.wait(120);
    assert_close(arm.joints(), end, 1e-6);
}

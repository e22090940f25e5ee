//! Counts that repeat exactly: allocations, and bytes visited.

use allocation_counter::measure;
use jaka_benches::planning::{self, JOINTS, PERIOD};
use jaka_benches::{PACKET_OF_DOCUMENT, PACKET_OF_NEWER, reply, status};
use jaka_motion::{Checker, Follower, Frames, JointSpeed, Limits, Model, Point, Region, TcpSpeed, Transform};
use jaka_proto::Request;
use jaka_proto::framing::Framer;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::Pose;
use jaka_proto::wire::Writer;

/// Number of allocations of `once` after a first call has allocated all buffers.
fn allocations<T>(mut once: impl FnMut() -> T) -> u64 {
    drop(once());
    measure(|| drop(once())).count_total
}

#[test]
fn no_request_allocates() {
    let spec = jaka_spec::builtin().expect("the built-in spec is correct");
    let examples = spec.commands().flat_map(|command| &command.examples);
    let texts = examples.filter_map(|example| example.request.as_deref());
    let requests: Vec<_> = texts.map(|text| Request::read(text).expect("the spec's examples fit")).collect();
    for info in Request::COMMANDS {
        let mut own = requests.iter().filter(|request| request.info().name == info.name).peekable();
        assert!(own.peek().is_some(), "`{}` has no example", info.name);
        for request in own {
            let mut out = Writer::new();
            let count = allocations(|| {
                out.clear();
                request.write(&mut out);
            });
            assert_eq!(count, 0, "{}", out.as_str());
        }
    }
}

#[test]
fn a_reply_of_fixed_shape_allocates_nothing() {
    assert_eq!(allocations(|| reply::ours(reply::JOINT_POS)), 0);
}

#[test]
fn packets_over_packets_allocate_nothing() {
    for packet in [PACKET_OF_DOCUMENT, PACKET_OF_NEWER] {
        let mut status = RobotStatus::default();
        assert_eq!(allocations(|| status::ours(packet, &mut status)), 0);
    }
}

#[test]
fn a_choice_of_fields_allocates_nothing() {
    for packet in [PACKET_OF_DOCUMENT, PACKET_OF_NEWER] {
        let mut framer = Framer::default();
        assert_eq!(allocations(|| status::joints(packet, &mut framer)), 0);
    }
}

#[test]
fn kinematics_allocate_nothing() {
    for name in ["Zu 5", "A12", "MiniCobo"] {
        let arm = Model::named(name).expect("published");
        let (joints, frames) = (JOINTS, Frames::new());
        let pose = frames.pose(arm.forward(joints));
        assert!(arm.inverse(pose, joints).is_ok(), "it is found");
        assert_eq!(allocations(|| frames.pose(arm.forward(joints))), 0);
        assert_eq!(allocations(|| arm.inverse(frames.flange(pose), [0.0; 6])), 0);
        assert_eq!(allocations(|| arm.inverse_all(frames.flange(pose), [0.0; 6])), 0);
        assert_eq!(allocations(|| arm.jacobian(joints, &Transform::identity())), 0);
        assert_eq!(allocations(|| arm.singularity_distance(joints)), 0);
    }
}

/// Limits of every kind, with a region of each shape for each point.
fn checker() -> Checker {
    let mut limits = Limits::of(Model::named("Zu 5").expect("a published arm")).with_tcp_speed(500.0).expect("a speed");
    for point in [Point::Tcp, Point::Elbow, Point::Wrist] {
        for region in [
            Region::inside_box(format!("cell, {point}"), [-1500.0; 3], [1500.0; 3]),
            Region::outside_box(format!("post, {point}"), [900.0; 3], [1000.0; 3]),
            Region::half_space(format!("table, {point}"), [0.0, 0.0, -100.0], [0.0, 0.0, 1.0]),
        ] {
            limits = limits.with_region(region.expect("a region").of(point)).expect("another name");
        }
    }
    Checker::new(limits, Frames::new())
}

#[test]
fn checks_against_limits_allocate_nothing() {
    let arm = Model::named("Zu 5").expect("a published arm");
    let checker = checker();
    let [before, last, next] = [0.0, 0.1, 0.2].map(|by| JOINTS.map(|joint| joint + by));
    let beside = [-55.0, 40.0, -70.0, 200.0, -90.0, 5.0];
    let (pose, start) = (Pose::from(Model::default().forward(next)), Pose::from(arm.forward(beside)));
    let aside = Pose { y: start.y + 1000.0, ..start };
    let (beside, across) = (beside.into(), [35.0, 60.0, -90.0, 160.0, -70.0, 40.0].into());
    let (recent, next) = ([before.into(), last.into()], next.into());
    let pace = TcpSpeed { speed_mm_s: 100.0, tolerance_mm: 0.0 };
    let joint_pace = JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2: Some(60.0) };
    assert_eq!(checker.check_joint_way(beside, across, joint_pace), Ok(()));
    assert!(checker.check_line(beside, aside, pace).is_ok() && checker.check_place(next).is_ok());
    assert!(checker.check_pose_set_point(recent, pose, PERIOD).is_ok());
    assert_eq!(allocations(|| checker.check_place(next)), 0);
    assert_eq!(allocations(|| checker.check_set_point(recent, next, PERIOD)), 0);
    assert_eq!(allocations(|| checker.check_pose_set_point(recent, pose, PERIOD)), 0);
    assert_eq!(allocations(|| checker.check_joint_way(beside, across, joint_pace)), 0);
    assert_eq!(allocations(|| checker.check_end_move(beside, aside, joint_pace)), 0);
    assert_eq!(allocations(|| checker.check_line(beside, aside, pace)), 0);
    assert_eq!(allocations(|| checker.check_arc(beside, pose, aside, pace)), 0);
    // What is refused, too.
    let far = Pose { x: 5e3, ..pose };
    assert_eq!(allocations(|| checker.check_line(beside, far, pace)), 0);
    assert_eq!(allocations(|| checker.check_set_point(recent, [400.0; 6].into(), PERIOD)), 0);
}

#[test]
fn generated_set_points_allocate_nothing() {
    for regions in [0, 3] {
        let mut arm = planning::generator(regions);
        let _ = arm.next(&planning::goal(0));
        let count = measure(|| {
            for number in 0..600 {
                let _ = arm.next(&planning::goal(number / 6));
                let _ = arm.landing();
            }
            arm.paused();
        });
        assert_eq!((count.count_total, arm.rejections()), (0, 0));
    }
}

#[test]
fn following_a_trajectory_allocates_nothing_and_takes_no_memory_of_its_own() {
    // Without regions, of which a follower keeps a copy.
    let checker = Checker::new(Limits::of(Model::named("Zu 5").expect("a published arm")), Frames::new());
    let trajectory = (planning::KINDS[0].plan)(planning::WAY_POINTS)(&checker).expect("within the limits");
    let count = measure(|| {
        let mut follower = Follower::new(trajectory.clone(), &checker, PERIOD).expect("a period of servo mode");
        for number in 0..2000 {
            follower.set_scale([1.0, 0.4, 0.0, 0.7, 1.0, 0.9][number / 50 % 6]);
            follower.advance();
        }
        assert!(follower.stopping().look_ahead(1000).is_some());
        follower.paused();
        follower.take_back();
    });
    assert_eq!(count.count_total, 0);
}

/// Memory grows with the number of pieces: one between two points with times, some 50 for each second of a plan.
/// The follower keeps none of the memory of the planning.
#[test]
fn trajectories_hold_no_more_than_their_pieces() {
    let checker = planning::checker();
    let (timed, planned): (&[_], &[_]) = (&[201, 1001, planning::WAY_POINTS], &[201, 1001]);
    for (kind, (most, counts)) in planning::KINDS.iter().zip([(320, timed), (2200, planned), (1500, planned)]) {
        // At each 200th the joints turn round, and can end.
        for count in counts.iter().copied() {
            let plan = (kind.plan)(count);
            let mut follower = None;
            let held = measure(|| {
                let trajectory = plan(&checker).expect("within the limits");
                follower = Some(Follower::new(trajectory, &checker, PERIOD).expect("a period of servo mode"));
            });
            // The limits take some kilobytes, with their regions.
            let (name, each) = (kind.name, (held.bytes_current - 4096) / i64::from(count));
            println!("{name}: {count} way-points, {} bytes, {each} each", held.bytes_current);
            assert!(each <= most, "{name}: {each} bytes for each of {count} way-points");
            assert!(held.count_current <= 16, "{name}: {} allocations are left", held.count_current);
        }
    }
}

#[test]
fn framing_visits_each_byte_once() {
    for piece in [1, 7, 1460, 65536] {
        let mut framer = Framer::default();
        let stream = [PACKET_OF_DOCUMENT, PACKET_OF_NEWER].concat().repeat(5);
        assert_eq!(jaka_benches::framing::ours(&mut framer, stream.as_bytes(), piece), 10);
        assert_eq!(framer.visited(), stream.len() as u64);
    }
}

//! Valid and invalid limits.

#[cfg(feature = "toml")]
mod file;

use crate::{InvalidLimit, Limits, Model, Region};

#[test]
fn the_defaults_are_the_published_figures() {
    for model in Model::published() {
        let limits = Limits::of(model);
        assert_eq!(limits.joint_speeds().to_vec(), model.joint_speed());
        assert_eq!(limits.joint_accelerations().to_vec(), model.joint_speed().map(|speed| 0.4 * speed));
        assert_eq!((limits.joint_min(), limits.joint_max()), (model.joint_min(), model.joint_max()));
        assert_eq!((limits.tcp_speed(), limits.regions().len()), (None, 0));
    }
}

#[test]
fn where_two_sources_differ_the_tighter_ranges_count() {
    for (name, min, max) in [
        ("Zu 12", [-270.0, -85.0, -175.0], [270.0, 265.0, 175.0]),
        ("Zu 18", [-270.0, -50.0, -155.0], [270.0, 230.0, 155.0]),
    ] {
        let model = Model::named(name).expect("published");
        let limits = Limits::of(model);
        assert_eq!((&limits.joint_min()[..3], &limits.joint_max()[..3]), (&min[..], &max[..]));
        assert_eq!((limits.joint_min()[5], limits.joint_max()[5]), (-270.0, 270.0));
        assert!(limits.clone().with_joint_range(1, -270.0, 270.0).is_ok());
        assert_eq!(
            limits.with_joint_range(1, -270.0, 360.0).unwrap_err().to_string(),
            format!("joint 1: 360 deg is beyond the 270 deg of the {name}; a limit can only be tighter")
        );
    }
}

#[test]
fn a_limit_is_never_wider_than_the_arm() {
    let limits = || Limits::of(&Model::default());
    assert!(limits().with_joint_range(3, -175.0, 175.0).is_ok());
    for (min, max) in [(-175.1, 0.0), (0.0, 175.1), (180.0, 190.0), (-1e300, 1e300)] {
        assert!(
            matches!(limits().with_joint_range(3, min, max), Err(InvalidLimit::Wider { joint: 3, .. })),
            "{min} {max}"
        );
    }
    assert!(limits().with_joint_speeds([180.0; 6]).is_ok());
    let faster = limits().with_joint_speeds([180.0, 180.0, 180.0, 180.0, 180.5, 180.0]).unwrap_err();
    assert_eq!(
        faster.to_string(),
        "joint 5: 180.5 deg/s is beyond the 180 deg/s of the Zu 5; a limit can only be tighter"
    );
}

#[test]
fn limits_that_make_no_sense_are_refused() {
    let limits = || Limits::of(&Model::default());
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0] {
        assert!(limits().with_joint_speeds([90.0, 90.0, odd, 90.0, 90.0, 90.0]).is_err(), "{odd}");
        assert!(limits().with_joint_accelerations([odd; 6]).is_err(), "{odd}");
        assert!(limits().with_tcp_speed(odd).is_err(), "{odd}");
        assert!(odd == 0.0 || limits().with_singularity_distance(odd).is_err(), "{odd}");
        if !odd.is_finite() {
            assert!(
                limits().with_joint_range(1, odd, 90.0).is_err() && limits().with_joint_range(1, 0.0, odd).is_err()
            );
            assert!(Region::inside_box("box", [odd, 0.0, 0.0], [1.0; 3]).is_err());
            assert!(Region::half_space("wall", [odd, 0.0, 0.0], [1.0; 3]).is_err());
            assert!(Region::half_space("wall", [0.0; 3], [0.0, odd, 1.0]).is_err());
        }
    }
    assert!(limits().with_singularity_distance(1.0).is_err());
    for joint in [0, 7, usize::MAX] {
        assert_eq!(limits().with_joint_range(joint, 0.0, 1.0), Err(InvalidLimit::NoSuchJoint { joint }));
    }
    assert!(matches!(limits().with_joint_range(1, 10.0, 9.0), Err(InvalidLimit::EmptyRange { joint: 1, .. })));
}

#[test]
fn regions_that_make_no_sense_are_refused() {
    assert!(Region::inside_box("flat", [0.0; 3], [100.0, 100.0, 0.0]).is_ok());
    assert!(matches!(Region::inside_box("turned", [0.0; 3], [100.0, -1.0, 5.0]), Err(InvalidLimit::ThinBox { .. })));
    assert!(matches!(Region::outside_box("foil", [0.0; 3], [100.0, 100.0, 0.9]), Err(InvalidLimit::ThinBox { .. })));
    assert!(matches!(Region::half_space("wall", [0.0; 3], [0.0; 3]), Err(InvalidLimit::NoDirection { .. })));
    assert!(Region::half_space("wall", [0.0; 3], [0.0, 0.0, 1e-300]).is_ok());
    assert!(Region::half_space("wall", [0.0; 3], [1e300, 1e300, 1e300]).is_ok());
    assert_eq!(Region::half_space(" ", [0.0; 3], [0.0, 0.0, 1.0]), Err(InvalidLimit::NoName));
    let table = || Region::half_space("table", [0.0; 3], [0.0, 0.0, 1.0]).expect("a region");
    let twice = Limits::of(&Model::default()).with_region(table()).and_then(|limits| limits.with_region(table()));
    assert_eq!(twice.unwrap_err().to_string(), "two regions are called `table`");
}

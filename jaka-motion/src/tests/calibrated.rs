//! Parameters of a controller in place of the published ones.

use jaka_proto::messages::kinematics::GetDhParamReply;
use jaka_proto::wire::{Fields, Reader};

use super::{Random, assert_close};
use crate::Model;

pub(super) fn reply(model: &Model) -> GetDhParamReply {
    let (alpha, a, d, home) = (model.alpha(), model.a(), model.d(), model.joint_home_offset());
    let json = format!(r#"{{"alpha":{alpha:?},"a":{a:?},"d":{d:?},"joint_homeoff":{home:?}}}"#);
    GetDhParamReply::read_fields(&mut Reader::new(&json)).expect("it is a reply")
}

fn shifted(numbers: [f64; 6], random: &mut Random, most: f64) -> [f64; 6] {
    numbers.map(|number| number + random.between(-most, most))
}

#[test]
fn its_own_parameters_change_nothing() {
    for model in Model::published() {
        assert_eq!(model.with_dh(&reply(model)).as_ref(), Ok(model));
    }
}

/// Lengths alone keep the closed form: at the edge of reach it is exact.
#[test]
fn other_lengths_keep_the_closed_form() {
    let published = Model::default();
    let mut reply = reply(&published);
    (reply.a[2], reply.a[3], reply.d[3]) = (430.3, 368.1, -114.350_006_103_515_62);
    let model = published.with_dh(&reply).expect("it is near");
    let stretched = [20.0, 45.0, 0.0, 45.0, 90.0, 0.0];
    let found = model.inverse(model.forward(stretched), stretched).expect("it is there");
    assert!(found.max_distance(&stretched.into()) < 0.01, "{found}");
}

#[test]
fn calibrated_arms_are_solved_step_by_step() {
    let mut solved = 0;
    for (seed, published) in (801..).zip(Model::published()) {
        let mut random = Random::new(seed);
        for _ in 0..5 {
            let mut reply = reply(published);
            reply.alpha = shifted(reply.alpha, &mut random, 0.1);
            (reply.a, reply.d) = (shifted(reply.a, &mut random, 0.5), shifted(reply.d, &mut random, 0.5));
            reply.joint_home_offset = shifted(reply.joint_home_offset, &mut random, 0.1);
            let model = published.with_dh(&reply).expect("it is near");
            for _ in 0..40 {
                let joints = random.joints(published);
                let distance = model.singularity_distance(joints);
                if distance.elbow < 0.1 || distance.wrist < 0.1 || distance.shoulder < 0.05 {
                    continue;
                }
                solved += 1;
                let target = model.forward(joints);
                let branches = model.inverse_all(target, joints).expect("it is reachable");
                assert!(branches[0].max_distance(&joints.into()) < 1e-4, "{} {joints:?} {branches:?}", model.name());
                for found in branches.iter() {
                    assert_close(&model.forward(*found), &target, (0.001, 0.0001), model.name());
                    assert!(model.is_within_range(*found));
                }
            }
        }
    }
    assert!(solved > 2_000, "{solved}");
}

#[test]
fn another_arm_is_refused_with_the_difference() {
    let zu_7 = Model::named("Zu 7").expect("published");
    let refused = Model::default().with_dh(&reply(zu_7)).expect_err("it is a Zu 7");
    assert_eq!(refused.to_string(), "DH parameter a of joint 3 is 360 mm; that of the Zu 5 is 430 mm");
    for odd in [f64::NAN, f64::INFINITY, 0.0] {
        let mut reply = reply(zu_7);
        reply.d[4] = odd;
        assert!(zu_7.with_dh(&reply).is_err_and(|refused| (refused.parameter, refused.joint) == ("d", 5)), "{odd}");
    }
}

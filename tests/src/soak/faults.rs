//! Faults of a soak, as a function of the seed.

use std::collections::BTreeMap;
use std::time::Duration;

use jaka_robot::Command;
use jaka_robot::io::GetFuncdiStatus;
use jaka_robot::kinematics::{GetDhParam, GetJointPos, KineForward};
use jaka_robot::motion::JointMove;
use jaka_robot::payload::{GetPayload, SetPayload};
use jaka_robot::power::{GetRobotState, GetVersion};
use jaka_robot::program::{LoadProgram, SetRapidRate, StopProgram};
use jaka_robot::servo::{IsInServomove, ServoJ, SetServoMode};
use jaka_robot::variables::{ModifyUserDefinedVariable, QueryUserDefinedVariable};
use jaka_sim::{Direction, Fault, FaultPlan, Happening, LinkFault, Port, Scheduled, StatusFault};
use serde_json::json;

use super::random::Random;

/// Faults of the replies to each command, in the order of the replies.
pub(super) type Script = BTreeMap<&'static str, Vec<Fault>>;

/// Commands of which a connection sees one at most. Theirs alone are answered twice: names cannot tell a surplus reply
/// from the one to the next command of its name (`docs/reliability.md`).
const ONCE: [&str; 4] =
    [GetRobotState::INFO.name, GetVersion::INFO.name, GetDhParam::INFO.name, GetFuncdiStatus::INFO.name];

const USUAL: [&str; 12] = [
    KineForward::INFO.name,
    GetJointPos::INFO.name,
    JointMove::INFO.name,
    GetPayload::INFO.name,
    SetPayload::INFO.name,
    LoadProgram::INFO.name,
    SetRapidRate::INFO.name,
    StopProgram::INFO.name,
    IsInServomove::INFO.name,
    SetServoMode::INFO.name,
    ModifyUserDefinedVariable::INFO.name,
    QueryUserDefinedVariable::INFO.name,
];

/// Number of replies to a command for which faults are drawn in a round; later replies have none.
const REPLIES: u32 = 200;
const SET_POINTS: u32 = 2000;

/// A fault strikes one in this many replies, by arm: also none, so that some connections last.
const RARITY: [u32; 4] = [25, 10, 60, 0];

/// Set-points are many.
const SET_POINT_RARITY: u32 = 5;

/// Time between the starts of two link faults; each lasts less than that.
const LINK_PERIOD: Duration = Duration::from_secs(1);

/// Number of link faults in a round; after them the links work.
const LINK_FAULTS: u32 = 60;

/// Links that faults are drawn from; none stands for both.
const PORTS: [Option<Port>; 3] = [None, Some(Port::Status), Some(Port::Command)];
const DIRECTIONS: [Option<Direction>; 3] = [None, Some(Direction::ToClient), Some(Direction::ToController)];

/// Faults of the links of an arm in a round, one after the other by the clock.
pub(super) fn links(seed: u64, round: u32, arm: u32) -> Vec<Scheduled> {
    let mut random = Random::new(seed, [round, arm, 2]);
    if RARITY[arm as usize % RARITY.len()] == 0 {
        return Vec::new();
    }
    let links = (0..LINK_FAULTS).flat_map(|number| {
        let begin = LINK_PERIOD * number + millis(&mut random, 0, 200);
        let late = LinkFault::Delay(millis(&mut random, 5, 200));
        let fault = *random.pick(&[LinkFault::Hold, LinkFault::Hold, late, LinkFault::Slow(100_000)]);
        let end = begin + millis(&mut random, 20, 700);
        let (port, direction) = (*random.pick(&PORTS), *random.pick(&DIRECTIONS));
        [(begin, fault), (end, LinkFault::None)]
            .map(|(at, fault)| Scheduled { happening: Happening::Link { port, direction, fault }, at })
    });
    links.collect()
}

fn millis(random: &mut Random, least: u32, more: u32) -> Duration {
    Duration::from_millis(u64::from(least + random.below(more)))
}

/// The faults of an arm in a round.
pub(super) fn script(seed: u64, round: u32, arm: u32) -> Script {
    let mut random = Random::new(seed, [round, arm, 1]);
    let rarity = RARITY[arm as usize % RARITY.len()];
    let mut draw = |faults: &[Fault], rarity| {
        if random.one_in(rarity) { random.pick(faults).clone() } else { Fault::None }
    };
    let usual = faults(&[]);
    let mut script: Script =
        USUAL.iter().map(|name| (*name, (0..REPLIES).map(|_| draw(&usual, rarity)).collect())).collect();
    for name in ONCE {
        let refusal = json!({"errorCode": "2", "errorMsg": "as the soak wants", "cmdName": name}).to_string();
        let empty = json!({"errorCode": "0", "errorMsg": "", "cmdName": name}).to_string();
        let faults = faults(&[Fault::Twice, Fault::Instead(refusal.into_bytes()), Fault::Instead(empty.into_bytes())]);
        script.insert(name, (0..REPLIES).map(|_| draw(&faults, rarity / 3)).collect());
    }
    let set_points = (0..SET_POINTS).map(|_| draw(&usual, rarity * SET_POINT_RARITY)).collect();
    script.insert(ServoJ::INFO.name, set_points);
    script
}

/// All kinds of faults but those that no client can tell from a true reply, and more of those that come in several
/// ways.
fn faults(more: &[Fault]) -> Vec<Fault> {
    let names_another = |fault: &Fault| matches!(fault, Fault::None | Fault::Twice | Fault::Renamed(_));
    let mut faults = Fault::one_of_each();
    faults.retain(|fault| !names_another(fault));
    // This command is never sent.
    let unasked = json!({"errorCode": "0", "errorMsg": "", "cmdName": "jog"}).to_string().into_bytes();
    faults.extend([
        Fault::Renamed("jog".to_owned()),
        Fault::Delay(Duration::from_millis(10)),
        Fault::Delay(Duration::from_millis(300)),
        Fault::Before(b" \r\n".to_vec()),
        Fault::Before(unasked.clone()),
        Fault::After(unasked),
        Fault::Oversized(10_000),
        Fault::Pieces(vec![40, 1]),
        Fault::Instead(b"{errorCode: 0}".to_vec()),
        Fault::Instead(b"{\"\xff\": 0}".to_vec()),
    ]);
    faults.extend_from_slice(more);
    faults
}

/// The script as a controller takes it.
pub(super) fn plan(script: &Script) -> FaultPlan {
    let longest = script.values().map(Vec::len).max().unwrap_or_default();
    // Those that come first stand first.
    let in_order =
        (0..longest).flat_map(|at| script.iter().filter_map(move |(name, faults)| Some((*name, faults.get(at)?))));
    in_order.fold(FaultPlan::new(), |plan, (name, fault)| plan.then_for(name, fault.clone()))
}

/// The kind of a fault: the first word of its text.
pub(super) fn kind(fault: &impl ToString) -> String {
    fault.to_string().split(' ').next().unwrap_or_default().to_owned()
}

/// Faults of status packets, from [`StatusFault::None`] on.
pub(super) fn of_status() -> Vec<StatusFault> {
    let mut faults = StatusFault::one_of_each();
    faults.extend([StatusFault::CloseAfter(20_000), StatusFault::Garbage { bytes: 2000, seed: 9 }]);
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_fault_strikes_and_the_seed_says_where() {
        assert_eq!(script(7, 1, 0), script(7, 1, 0));
        assert_ne!(script(7, 1, 0), script(8, 1, 0));
        assert!(script(7, 1, 3).values().flatten().all(|fault| *fault == Fault::None));
        let drawn: Vec<_> =
            (0..20).flat_map(|round| script(7, round, 1).into_values().flatten()).map(|fault| kind(&fault)).collect();
        for fault in Fault::one_of_each() {
            assert!(drawn.contains(&kind(&fault)), "{fault}");
        }
    }
}

//! Set-points that a controller has received, read as JSON.

use jaka_sim::Controller;
use serde_json::Value;

/// All requests.
pub(crate) fn requests(controller: &Controller) -> Vec<Value> {
    controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect()
}

/// Names of all requests.
pub(crate) fn names(controller: &Controller) -> Vec<String> {
    requests(controller).iter().map(name).collect()
}

/// Joint positions of all set-points, which are absolute and of this many cycles, and names of the requests after the
/// last of them.
pub(crate) fn positions(controller: &Controller, cycles: u32) -> (Vec<[f64; 6]>, Vec<String>) {
    set_points(controller, 0, cycles)
}

/// Offsets of all set-points, which are relative and of this many cycles, and names of the requests after the last of
/// them.
pub(crate) fn offsets(controller: &Controller, cycles: u32) -> (Vec<[f64; 6]>, Vec<String>) {
    set_points(controller, 1, cycles)
}

fn set_points(controller: &Controller, flag: u32, cycles: u32) -> (Vec<[f64; 6]>, Vec<String>) {
    let requests = requests(controller);
    let is_set_point = |request: &&Value| request["cmdName"] == "servo_j";
    let last = requests.iter().rposition(|request| is_set_point(&request)).expect("set-points came");
    let joints = |request: &Value| {
        assert_eq!((&request["relFlag"], &request["stepNum"]), (&flag.into(), &cycles.into()));
        std::array::from_fn(|joint| request["jointPosition"][joint].as_f64().expect("a number"))
    };
    (requests.iter().filter(is_set_point).map(joints).collect(), requests[last + 1..].iter().map(name).collect())
}

fn name(request: &Value) -> String {
    request["cmdName"].as_str().expect("a name").to_owned()
}

//! Fault plans as text.

use jaka_sim::FaultPlan;

/// A plan that was read comes back when it is written and read again.
///
/// # Panics
/// It does not.
pub fn fault_plan(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(plan) = text.parse::<FaultPlan>().inspect_err(|error| drop(error.to_string())) else { return };
    assert_eq!(plan.to_string().parse(), Ok(plan));
}

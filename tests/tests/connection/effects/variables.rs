//! User-defined system variables.

use jaka_sync::variables::ModifyUserDefinedVariable;

use super::arm::{Arm, refused};

effects! {
    query_user_defined_variable => variables_are_read,
    modify_user_defined_variable => a_variable_is_given_back,
}

fn variables_are_read(arm: &mut Arm) {
    let mut speed = arm.controller.state().variables[0].clone();
    (speed.alias, speed.id, speed.value) = ("speed".to_owned(), 5501, 2.5);
    arm.controller.set_state(|state| state.variables.push(speed.clone()));
    let variables = arm.client.query_user_defined_variable().expect("it answers").variables;
    assert_eq!((variables.len(), variables.last()), (2, Some(&speed)));
}

fn a_variable_is_given_back(arm: &mut Arm) {
    let modify = |id| ModifyUserDefinedVariable::new(id, "count", 14.0);
    arm.client.modify_user_defined_variable(&modify(5500)).expect("there is such a variable");
    refused(arm.client.modify_user_defined_variable(&modify(5999)));
    let variables = arm.client.query_user_defined_variable().expect("it answers").variables;
    let variables: Vec<_> = variables.iter().map(|one| (&*one.alias, one.id, one.value)).collect();
    assert_eq!(variables, [("count", 5500, 14.0)]);
}

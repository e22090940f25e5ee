pub mod variables {
    //! User-defined system variables.
    //!
    //! System variables that the user has defined on the controller, each with an id, a name and a number as its value.
    //!
    //! Their ids are 5500 to 5599 (field notes).
    /// Reads all user-defined system variables.
    ///
    /// Sends `query_user_defined_variable` (4.38). Changes nothing on the robot. The reply is [`QueryUserDefinedVariableReply`].
    ///
    /// # Errata
    ///
    /// - The text explains a variable named `system_var1` with the value 12.0. The sample has `test` with the value 1.0.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    pub struct QueryUserDefinedVariable {}
    impl QueryUserDefinedVariable {
        /// Without any optional field.
        pub const fn new() -> Self {}
    }
    /// What the controller answers to [`type@QueryUserDefinedVariable`].
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct QueryUserDefinedVariableReply {
        /// One entry for each variable. `var_list` on the wire.
        pub variables: Vec<UserVariable>,
    }
    /// Sets the name and the value of a user-defined system variable.
    ///
    /// The request carries both: to change the value alone, send the present name along.
    ///
    /// Sends `modify_user_defined_variable` (4.39).
    ///
    /// # Errata
    ///
    /// - The key `id_new` is not a new id. It names the variable to change.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct ModifyUserDefinedVariable {
        /// Id of the variable to change, as [`query_user_defined_variable`](type@QueryUserDefinedVariable) answers it. `id_new` on the wire.
        pub id: i64,
        /// Name to set. `alias_new` on the wire.
        pub alias: String,
        /// Value to set. `value_new` on the wire.
        pub value: f64,
    }
    impl ModifyUserDefinedVariable {
        /// With the required fields alone.
        pub fn new(id: i64, alias: impl Into<String>, value: f64) -> Self {}
    }
    /// A user-defined system variable.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct UserVariable {
        /// Name of the variable.
        pub alias: String,
        /// Id of the variable, by which [`modify_user_defined_variable`](type@ModifyUserDefinedVariable) addresses it.
        pub id: i64,
        /// Value of the variable.
        pub value: f64,
    }
}

pub mod variables {
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    #[non_exhaustive]
    // Query
    pub struct QueryUserDefinedVariable {}
    impl QueryUserDefinedVariable {
        pub const fn new() -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct QueryUserDefinedVariableReply {
        pub variables: Vec<UserVariable>,
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    // Setting
    pub struct ModifyUserDefinedVariable {
        pub id: i64,
        pub alias: String,
        pub value: f64,
    }
    impl ModifyUserDefinedVariable {
        pub fn new(id: i64, alias: impl Into<String>, value: f64) -> Self {}
    }
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub struct UserVariable {
        pub alias: String,
        pub id: i64,
        pub value: f64,
    }
}

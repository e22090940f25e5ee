/// User-defined system variables.
///
/// System variables that the user has defined on the controller, each with an id, a name and a number as its value.
pub mod variables {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Reads all user-defined system variables.
    ///
    /// Sends `query_user_defined_variable` (4.38). Changes nothing on the robot.
    ///
    /// # Errata
    ///
    /// - The text explains a variable named `system_var1` with the value 12.0. The sample has `test` with the value 1.0.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct QueryUserDefinedVariable;
    impl wire::Fields for QueryUserDefinedVariable {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(QueryUserDefinedVariable);
    impl check::Validate for QueryUserDefinedVariable {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for QueryUserDefinedVariable {
        type Reply = QueryUserDefinedVariableReply;
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "query_user_defined_variable",
            "{\"cmdName\":\"query_user_defined_variable\"",
            "4.38",
            proto::Effect::Query,
        );
    }
    /// What the controller answers to [`QueryUserDefinedVariable`].
    #[derive(Debug, Clone, PartialEq)]
    pub struct QueryUserDefinedVariableReply {
        /// One entry for each variable.
        ///
        /// `var_list` on the wire.
        #[doc(alias = "var_list")]
        pub variables: Vec<UserVariable>,
    }
    impl wire::Fields for QueryUserDefinedVariableReply {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"var_list\":");
            wire::Encode::encode(&self.variables, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut variables = None;
            let mut keys = reader.begin_fields(&["\"var_list\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("variables", &mut variables)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                variables: variables
                    .ok_or_else(|| wire::DecodeError::missing("variables", "var_list"))?,
            })
        }
    }
    proto::__object_impls!(QueryUserDefinedVariableReply);
    /// Sets the name and the value of a user-defined system variable.
    ///
    /// The request carries both: to change the value alone, send the present name along.
    ///
    /// Sends `modify_user_defined_variable` (4.39).
    ///
    /// # Errata
    ///
    /// - The key `id_new` is no new id. It names the variable to change.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ModifyUserDefinedVariable {
        /// Id of the variable to change, as `query_user_defined_variable` answers it.
        ///
        /// `id_new` on the wire.
        #[doc(alias = "id_new")]
        pub id: i64,
        /// Name to set.
        ///
        /// `alias_new` on the wire.
        #[doc(alias = "alias_new")]
        pub alias: String,
        /// Value to set.
        ///
        /// `value_new` on the wire.
        #[doc(alias = "value_new")]
        pub value: f64,
    }
    impl wire::Fields for ModifyUserDefinedVariable {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"id_new\":");
            wire::Encode::encode(&self.id, out);
            out.raw(",\"alias_new\":");
            wire::Encode::encode(&self.alias, out);
            out.raw(",\"value_new\":");
            wire::Encode::encode(&self.value, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut id = None;
            let mut alias = None;
            let mut value = None;
            let mut keys = reader
                .begin_fields(&["\"id_new\":", "\"alias_new\":", "\"value_new\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("id", &mut id)?,
                    1 => reader.field("alias", &mut alias)?,
                    2 => reader.field("value", &mut value)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                id: id.ok_or_else(|| wire::DecodeError::missing("id", "id_new"))?,
                alias: alias
                    .ok_or_else(|| wire::DecodeError::missing("alias", "alias_new"))?,
                value: value
                    .ok_or_else(|| wire::DecodeError::missing("value", "value_new"))?,
            })
        }
    }
    proto::__object_impls!(ModifyUserDefinedVariable);
    impl check::Validate for ModifyUserDefinedVariable {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("id", &self.id, &check::Limits::NONE)?;
            place.check("alias", &self.alias, &check::Limits::NONE)?;
            place.check("value", &self.value, &check::Limits::NONE)?;
            Ok(())
        }
    }
    impl proto::Command for ModifyUserDefinedVariable {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
            "modify_user_defined_variable",
            "{\"cmdName\":\"modify_user_defined_variable\"",
            "4.39",
            proto::Effect::Setting,
        );
    }
    /// A user-defined system variable.
    #[derive(Debug, Clone, PartialEq)]
    pub struct UserVariable {
        /// Name of the variable.
        pub alias: String,
        /// Id of the variable, by which `modify_user_defined_variable` addresses it.
        pub id: i64,
        /// Value of the variable.
        pub value: f64,
    }
    impl wire::Fields for UserVariable {
        fn write_fields(&self, out: &mut wire::Writer) {
            out.key("\"alias\":");
            wire::Encode::encode(&self.alias, out);
            out.raw(",\"id\":");
            wire::Encode::encode(&self.id, out);
            out.raw(",\"value\":");
            wire::Encode::encode(&self.value, out);
        }
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            let mut alias = None;
            let mut id = None;
            let mut value = None;
            let mut keys = reader
                .begin_fields(&["\"alias\":", "\"id\":", "\"value\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.field("alias", &mut alias)?,
                    1 => reader.field("id", &mut id)?,
                    2 => reader.field("value", &mut value)?,
                    _ => reader.skip()?,
                }
            }
            Ok(Self {
                alias: alias
                    .ok_or_else(|| wire::DecodeError::missing("alias", "alias"))?,
                id: id.ok_or_else(|| wire::DecodeError::missing("id", "id"))?,
                value: value.ok_or_else(|| wire::DecodeError::missing("value", "value"))?,
            })
        }
        fn read_fields_into(
            &mut self,
            reader: &mut wire::Reader<'_>,
        ) -> Result<(), wire::DecodeError> {
            let mut keys = reader
                .begin_fields(&["\"alias\":", "\"id\":", "\"value\":"])?;
            while let Some(key) = reader.next_field(&mut keys)? {
                match key {
                    0 => reader.required_into("alias", &mut self.alias, &mut keys)?,
                    1 => reader.required_into("id", &mut self.id, &mut keys)?,
                    2 => reader.required_into("value", &mut self.value, &mut keys)?,
                    _ => reader.skip()?,
                }
            }
            keys.required(0, "alias", "alias")?;
            keys.required(1, "id", "id")?;
            keys.required(2, "value", "value")?;
            Ok(())
        }
    }
    proto::__object_impls!(UserVariable, in_place);
    impl check::Validate for UserVariable {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            place.check("alias", &self.alias, &check::Limits::NONE)?;
            place.check("id", &self.id, &check::Limits::NONE)?;
            place.check("value", &self.value, &check::Limits::NONE)?;
            Ok(())
        }
    }
}

/// The connection.
///
/// Port 10001 serves one client. A second client is refused or takes the first one's place, depending on the firmware. The
/// replies come in the order of the requests.
///
/// Closing the connection leaves power and enabling as they are.
pub mod session {
    #[allow(unused_imports)]
    use ::jaka_proto::{self as proto, check, wire};
    /// Ends the connection.
    ///
    /// The controller answers as usual, and the client closes the connection then. Closing it without this command leaves power
    /// and enabling as they are.
    ///
    /// Sends `quit` (4.11).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct Quit;
    impl wire::Fields for Quit {
        fn write_fields(&self, _out: &mut wire::Writer) {}
        fn read_fields(
            reader: &mut wire::Reader<'_>,
        ) -> Result<Self, wire::DecodeError> {
            reader.skip().map(|()| Self)
        }
    }
    proto::__object_impls!(Quit);
    impl check::Validate for Quit {
        #[allow(unused_variables)]
        fn validate(
            &self,
            place: &check::Place<'_>,
            limits: &check::Limits,
        ) -> Result<(), check::NotSent> {
            Ok(())
        }
    }
    impl proto::Command for Quit {
        type Reply = ();
        const INFO: &'static proto::CommandInfo = &proto::CommandInfo::new(
                "quit",
                "{\"cmdName\":\"quit\"",
                "4.11",
                proto::Effect::Session,
            )
            .ends_session();
    }
}

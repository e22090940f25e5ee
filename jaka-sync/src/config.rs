//! How a connection behaves.

use std::fmt::Display;
use std::time::Duration;

use jaka_proto::check::AdvisoryRanges;
use jaka_proto::framing::DEFAULT_MAX_FRAME;
use jaka_proto::wire::Decode;

use crate::{Client, Error, ErrorKind, Monitor, Reconnect, Recorder, Robot, StatusSampling, StatusStream, address};

/// How a connection behaves: timeouts, keepalive, frame size and checks.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_sync::Config;
///
/// let mut robot = Config::new().reply_timeout(Duration::from_secs(2)).connect("10.5.5.100")?;
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Config {
    pub(crate) connect_timeout: Duration,
    pub(crate) reply_timeout: Duration,
    pub(crate) keepalive: Option<Duration>,
    pub(crate) max_frame: usize,
    pub(crate) advisory_ranges: AdvisoryRanges,
    pub(crate) stale_after: Duration,
    pub(crate) reconnect: Reconnect,
    pub(crate) recorder: Option<Recorder>,
    pub(crate) status_sampling: StatusSampling,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            connect_timeout: Duration::from_secs(5),
            reply_timeout: Duration::from_secs(5),
            keepalive: Some(Duration::from_secs(9)),
            max_frame: DEFAULT_MAX_FRAME,
            advisory_ranges: AdvisoryRanges::Enforced,
            stale_after: Duration::from_millis(500),
            reconnect: Reconnect::Never,
            recorder: None,
            status_sampling: StatusSampling::All,
        }
    }
}

/// Durations shorter than this are taken as this: sockets take no timeout of zero.
const SHORTEST: Duration = Duration::from_millis(1);

impl Config {
    /// The defaults, named at each setting.
    pub fn new() -> Self {
        Self::default()
    }

    /// How long connecting may take, over all addresses of a name, which share the time. 5 s by default.
    #[must_use]
    pub fn connect_timeout(mut self, timeout: Duration) -> Self {
        self.connect_timeout = timeout.max(SHORTEST);
        self
    }

    /// How long a reply, or a status packet, may take from the moment of the call. 5 s by default.
    ///
    /// A call's time has in it the wait for other threads that send, and the sending: a controller that reads nothing lets it run out.
    /// Commands for which the spec names a longer time, such as `power_on` and the motions, get that longer time.
    #[must_use]
    pub fn reply_timeout(mut self, timeout: Duration) -> Self {
        self.reply_timeout = timeout.max(SHORTEST);
        self
    }

    /// After how long a silence TCP probes the controller, so that a pulled cable is noticed; `None` for never.
    /// 9 s by default, and a third of it between probes.
    ///
    /// Systems take whole seconds from 1 to 32767: other times are rounded up to the next second, or taken as the nearest of these. Between
    /// probes there is a second at least.
    #[must_use]
    pub fn keepalive(mut self, idle: Option<Duration>) -> Self {
        self.keepalive = idle;
        self
    }

    /// The longest message taken from the controller, in bytes. 1 MiB by default.
    #[must_use]
    pub fn max_frame(mut self, bytes: usize) -> Self {
        self.max_frame = bytes;
        self
    }

    /// Whether ranges are enforced that newer firmware has widened. Enforced by default.
    #[must_use]
    pub fn advisory_ranges(mut self, ranges: AdvisoryRanges) -> Self {
        self.advisory_ranges = ranges;
        self
    }

    /// After how long without a packet a [`Monitor`]'s news is stale. 0.5 s by default, several periods of any firmware.
    #[must_use]
    pub fn stale_after(mut self, age: Duration) -> Self {
        self.stale_after = age;
        self
    }

    /// When a [`Monitor`] connects anew after its connection has ended. Never, by default.
    #[must_use]
    pub fn reconnect(mut self, policy: Reconnect) -> Self {
        self.reconnect = policy;
        self
    }

    /// Records all connections that are made with this configuration. Nothing is recorded by default, which costs nothing.
    #[must_use]
    pub fn recorder(mut self, recorder: Recorder) -> Self {
        self.recorder = Some(recorder);
        self
    }

    /// Which status packets are recorded. All by default, which can be some 0.5 MB each second.
    #[must_use]
    pub fn status_sampling(mut self, sampling: StatusSampling) -> Self {
        self.status_sampling = sampling;
        self
    }

    /// Connects to a controller's command port.
    ///
    /// # Errors
    /// As [`Client::connect`].
    pub fn connect(&self, address: impl Display) -> Result<Client, Error> {
        Client::with_config(&address.to_string(), self)
    }

    /// Connects a [`Robot`] to a controller at the protocol's ports, 10001 and 10000.
    ///
    /// # Errors
    /// As [`Robot::connect`].
    pub fn robot(&self, address: impl Display) -> Result<Robot, Error> {
        let address = address.to_string();
        if address::names_a_port(&address) {
            return Err(ErrorKind::PortInAddress { address }.into());
        }
        self.connect_robot(&address, &address)
    }

    /// Connects a [`Robot`] to a controller whose two ports have addresses of their own: a simulated one, or one behind a proxy.
    ///
    /// ```
    /// use jaka_sim::Controller;
    /// use jaka_sync::Config;
    ///
    /// let controller = Controller::start()?;
    /// let robot = Config::new().connect_robot(controller.command_addr(), controller.status_addr())?;
    /// # drop(robot);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`connect`](Self::connect) and [`monitor`](Self::monitor).
    pub fn connect_robot(&self, commands: impl Display, status: impl Display) -> Result<Robot, Error> {
        let monitor: Monitor = self.monitor(status)?;
        Ok(Robot::new(self.connect(commands)?, monitor))
    }

    /// Connects to a controller's status port.
    ///
    /// # Errors
    /// As [`StatusStream::connect`].
    pub fn connect_status(&self, address: impl Display) -> Result<StatusStream, Error> {
        StatusStream::with_config(&address.to_string(), self)
    }

    /// Connects a monitor to a controller's status port.
    ///
    /// # Errors
    /// As [`Monitor::connect`].
    pub fn monitor<S: Decode + Send + Sync + 'static>(&self, address: impl Display) -> Result<Monitor<S>, Error> {
        Monitor::with_config(&address.to_string(), self)
    }
}

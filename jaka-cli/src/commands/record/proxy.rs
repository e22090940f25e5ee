//! Proxy between clients and a robot, which records their traffic.

mod frames;
mod pipe;
mod recording_queue;

use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener, TcpStream, ToSocketAddrs};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use jaka_sync::Recorder;
use jaka_sync::proto::text::visible;
use jaka_sync::recording::{Event, Port};
use socket2::{SockRef, TcpKeepalive};

use crate::terminal::output;

use self::pipe::Pipe;
use self::recording_queue::{Passed, ProxiedConnection};

pub(crate) use self::recording_queue::RecordingQueue;

/// Delay after a failed `accept`, for example without a free descriptor.
const REST: Duration = Duration::from_millis(20);

/// Time without bytes after which keepalive checks the other side, as on the SDK's own connections.
const IDLE: Duration = Duration::from_secs(5);

/// Greatest number of simultaneous status readers. Each needs two descriptors and a thread, and the command port must
/// keep some for a stop. The controller itself limits the clients of the command port, of which it serves one.
const MOST_READERS: usize = 64;

/// Port of a proxy, for one port of the robot.
#[derive(Debug)]
pub(crate) struct ProxyPort {
    /// Port of the robot.
    pub(crate) port: Port,
    /// Address of the port, such as `10.5.5.100:10001`.
    pub(crate) robot: String,
    /// Timeout for connecting to it.
    pub(crate) timeout: Duration,
    /// Recording of the traffic.
    pub(crate) recorder: Recorder,
    /// Queue of the recording thread.
    pub(crate) queue: RecordingQueue,
    /// Least time between two recorded status packets.
    pub(crate) status_interval: Duration,
}

impl ProxyPort {
    /// Listens at an address and port, 0 for a free one, for as long as the program runs.
    ///
    /// Each client gets its own connection to the robot.
    pub(crate) fn open(self, address: IpAddr, port: u16) -> io::Result<SocketAddr> {
        let listener = TcpListener::bind((address, port))?;
        let address = listener.local_addr()?;
        thread::Builder::new().spawn(move || Arc::new(self).serve(&listener))?;
        Ok(address)
    }

    fn serve(self: Arc<Self>, listener: &TcpListener) {
        loop {
            let accepted = listener.accept().and_then(|(accepted, _)| {
                // The thread of each reader has one reference.
                if self.port == Port::Status && Arc::strong_count(&self) > MOST_READERS {
                    pipe::reset(&accepted);
                    return Err(io::Error::other(format!("{MOST_READERS} clients are connected to it already")));
                }
                let port_proxy = Arc::clone(&self);
                thread::Builder::new().spawn(move || port_proxy.attend(&accepted)).map(drop)
            });
            if let Err(error) = accepted {
                warn(&format!("cannot serve a client of the {} port: {error}", self.port.word()));
                thread::sleep(REST);
            }
        }
    }

    /// Serves a client to the end of its connection.
    fn attend(&self, client: &TcpStream) {
        let connection = ProxiedConnection::new(self.recorder.track(self.port, self.status_interval), self.port);
        let record = |event| self.queue.take(&connection, Passed::Event(event));
        let robot = set_options(client).and_then(|()| self.connect());
        match robot {
            Ok(robot) => {
                let address = robot.peer_addr().map_or_else(|_| self.robot.clone(), |address| address.to_string());
                record(Event::Connected { address });
                Pipe { client, robot: &robot, connection: &connection, queue: &self.queue }.run();
            }
            Err(error) => {
                let text = format!("cannot connect to {}: {error}", self.robot);
                warn(&text);
                record(Event::Error { text });
                pipe::reset(client);
            }
        }
    }

    fn connect(&self) -> io::Result<TcpStream> {
        let mut result = Err(io::Error::new(io::ErrorKind::NotFound, "the name resolves to no address"));
        for address in self.robot.to_socket_addrs()? {
            result = TcpStream::connect_timeout(&address, self.timeout);
            if result.is_ok() {
                break;
            }
        }
        let stream = result?;
        set_options(&stream)?;
        Ok(stream)
    }
}

/// Disables Nagle's algorithm, and enables keepalive.
fn set_options(stream: &TcpStream) -> io::Result<()> {
    stream.set_nodelay(true)?;
    SockRef::from(stream).set_tcp_keepalive(&TcpKeepalive::new().with_time(IDLE).with_interval(IDLE / 3))
}

fn warn(text: &str) {
    output::warning(&visible(text));
}

//! The serial port of a board.

use std::io;
use std::time::Duration;

use anyhow::{Result, anyhow};
use photoncube_driver::SerialTransport;
use photoncube_hdl::emit_core;
use photoncube_spec::Core;
use serial2::{SerialPort, Settings};

use crate::machines;

/// A core on a board.
pub type OnBoard = SerialTransport<SerialPort>;

/// The time in which a read returns where nothing comes.
const READ: Duration = Duration::from_millis(10);

/// The time in which a port takes bytes; it sends some thousand in a tenth of a second.
const WRITE: Duration = Duration::from_secs(10);

/// Opens a port, and checks that the core at its other end is this one.
pub fn open(core: &Core, path: &str, baud: u32) -> Result<OnBoard> {
    let port = plain(path, baud).map_err(|error| {
        anyhow!(
            "cannot open the port {path} at {baud} bits a second: {error}; expected the serial port of a board, such as \
             /dev/ttyUSB0, that this user may open (on Debian: in the group dialout)"
        )
    })?;
    machines::prepare(core.machine)?;
    let digest = emit_core(core)?.digest;
    let on_board = SerialTransport::open(port, core, digest, OnBoard::SILENCE);
    on_board.map_err(|error| anyhow!("{path}: {error}"))
}

/// A port that passes every byte as it is.
fn plain(path: &str, baud: u32) -> io::Result<SerialPort> {
    let mut port = SerialPort::open(path, |mut settings: Settings| {
        settings.set_raw();
        settings.set_baud_rate(baud)?;
        Ok(settings)
    })?;
    port.set_read_timeout(READ)?;
    port.set_write_timeout(WRITE)?;
    // What the board said to a program before.
    port.discard_buffers()?;
    Ok(port)
}

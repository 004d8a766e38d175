//! `board simulate`: a board's Verilog in Verilator, with its serial line at a pseudo-terminal.

use anyhow::Result;

use crate::args::SimulateArgs;

#[cfg(not(unix))]
pub fn execute(_: &SimulateArgs, _: bool) -> Result<()> {
    anyhow::bail!("found a system without pseudo-terminals, expected Linux or another Unix")
}

#[cfg(unix)]
pub fn execute(args: &SimulateArgs, json: bool) -> Result<()> {
    use serde::Serialize;

    use crate::output;

    #[derive(Serialize)]
    struct Report {
        core: String,
        port: String,
        clock_mhz: u32,
        baud: u32,
        clocks_per_bit: u32,
    }

    let board = args.on_board.board(args.mhz, args.baud)?;
    let simulation = photoncube_testbench::BoardSimulation::new(&board)?;
    let terminal = on_unix::Terminal::open()?;
    let report = Report {
        core: board.core().name(),
        port: terminal.path.clone(),
        clock_mhz: args.mhz,
        baud: args.baud,
        clocks_per_bit: board.clocks_of_bit(),
    };
    output::print(json, &report, || {
        format!(
            "{}\nThe serial line of {} in simulation is at this path; Ctrl-C ends it. In another terminal:\n\
             photoncube render cornell -o core.png --engine core --machine {} --chains {} --port {0}\n",
            report.port,
            report.core,
            board.core().machine.name,
            board.core().chains,
        )
    })?;
    on_unix::run(simulation, &terminal)
}

#[cfg(unix)]
mod on_unix {
    use std::fs::File;
    use std::io::{self, ErrorKind, Read, Write};
    use std::sync::mpsc::{self, Receiver};
    use std::thread;

    use anyhow::{Context, Result, bail};
    use photoncube_testbench::BoardSimulation;
    use rustix::fs::{Mode, OFlags};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

    /// Reads without a byte after which the board has nothing to say until it hears something. The core answers a batch in far less.
    const SILENT_READS: u32 = 100;

    /// A pseudo-terminal.
    pub struct Terminal {
        /// Its path.
        pub path: String,
        /// The end of the board.
        board: File,
        #[expect(
            dead_code,
            reason = "where nobody has the other end open, a read of this one fails"
        )]
        host: File,
    }

    impl Terminal {
        /// Opens one that passes every byte as it is.
        pub fn open() -> Result<Self> {
            Self::raw().context("cannot open a pseudo-terminal")
        }

        fn raw() -> io::Result<Self> {
            let board = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
            grantpt(&board)?;
            unlockpt(&board)?;
            let path = ptsname(&board, Vec::new())?;
            let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
            let host = rustix::fs::open(&path, flags, Mode::empty())?;
            let mut settings = tcgetattr(&host)?;
            settings.make_raw();
            tcsetattr(&host, OptionalActions::Now, &settings)?;
            Ok(Self {
                path: path.to_string_lossy().into_owned(),
                board: board.into(),
                host: host.into(),
            })
        }

        /// What the host writes, as it comes.
        fn heard(&self) -> Result<Receiver<Vec<u8>>> {
            let mut board = self.board.try_clone()?;
            let (give, heard) = mpsc::channel();
            thread::spawn(move || {
                let mut bytes = [0; 4096];
                while let Ok(count) = board.read(&mut bytes) {
                    if give.send(bytes[..count].to_vec()).is_err() {
                        break;
                    }
                }
            });
            Ok(heard)
        }
    }

    /// Passes bytes between the terminal and the board, for ever.
    pub fn run(mut simulation: BoardSimulation, terminal: &Terminal) -> Result<()> {
        let heard = terminal.heard()?;
        let mut to_host = terminal.board.try_clone()?;
        let mut bytes = [0; 4096];
        let mut silent = SILENT_READS;
        loop {
            if silent == SILENT_READS {
                match heard.recv() {
                    Ok(bytes) => simulation.write_all(&bytes)?,
                    Err(_) => bail!("the pseudo-terminal {} was closed", terminal.path),
                }
                silent = 0;
            }
            for bytes in heard.try_iter() {
                simulation.write_all(&bytes)?;
            }
            silent = match simulation.read(&mut bytes) {
                Ok(count) => {
                    to_host.write_all(&bytes[..count])?;
                    0
                }
                Err(error) if error.kind() == ErrorKind::TimedOut => silent + 1,
                Err(error) => return Err(error.into()),
            };
        }
    }
}

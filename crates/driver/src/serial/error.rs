//! The errors of a serial line.

use std::time::Duration;

use thiserror::Error;

/// The reason why a core at the end of a serial line does not do its work.
#[derive(Debug, Error)]
pub enum SerialError {
    /// The port fails.
    #[error("the port of the serial line failed: {0}")]
    Port(#[from] std::io::Error),
    /// Nothing comes from the other end.
    #[error(
        "the board has not answered {asked} times in {} s; check that its bitstream is loaded, that the port is that of the board and no \
         other program has it open, that both ends have the same bits a second (--baud), and the cable",
        waited.as_secs_f64()
    )]
    NoAnswer {
        /// How often it was asked.
        asked: u32,
        /// The time in all.
        waited: Duration,
    },
    /// What answers is no core, or one with another map of registers.
    #[error(
        "the register {register} of the board is {found:#010x}, expected {expected:#010x}; load a bitstream of this version of photoncube"
    )]
    NoCore {
        /// The name of the register.
        register: &'static str,
        /// Its word.
        found: u32,
        /// The word that it has in a core.
        expected: u32,
    },
    /// The board has another core.
    #[error(
        "the board has a core of {chains} chains of {engines} engines with the digest {found:016x}, expected `{core}` with the digest \
         {expected:016x}; load the bitstream of that core, or give --machine and --chains of the one that is loaded"
    )]
    OtherCore {
        /// The chains of the board's core.
        chains: u32,
        /// The engines of each.
        engines: u32,
        /// The digest of its configuration.
        found: u64,
        /// The name of the core that was expected.
        core: String,
        /// Its digest.
        expected: u64,
    },
    /// Frames to the board are damaged again and again.
    #[error(
        "the board refused the same frame {times} times, last because of `{cause}`: the line to the board damages what \
         it carries; check the cable, or make the line slower (--baud, of the bitstream too)"
    )]
    ToBoard {
        /// How often.
        times: u32,
        /// The name of the last cause.
        cause: String,
    },
    /// Frames from the board are damaged again and again.
    #[error(
        "the same work was begun {times} times, and each time a frame of the board was damaged or lost; check the cable, that no \
         other program reads the port, or make the line slower (--baud, of the bitstream too)"
    )]
    FromBoard {
        /// How often.
        times: u32,
    },
    /// The board takes all frames, but the core does not answer.
    #[error(
        "the board works but its core has given {found} of {expected} results and no other for {} s; load the bitstream again, \
         and check that its clock is no faster than nextpnr said",
        waited.as_secs_f64()
    )]
    Stalled {
        /// Results that came.
        found: usize,
        /// Results that are owed.
        expected: usize,
        /// The time without any.
        waited: Duration,
    },
    /// The core refused an access.
    #[error("the core refused an access to its registers with the AXI response {0}, expected 0")]
    Refused(u8),
}

//! The serial line of a core: how its words pass through a UART.
//!
//! The core is at the end of a line of bytes: 8 bits a byte, no parity, one stop bit, no flow control by wires. The computer at the other
//! end is the *host*. The logic between the line and the core's ports is the *bridge*.
//!
//! # Frames
//! Everything on the line is a *frame*. Its bytes are, in this order: [`Serial::FLAG`]; the kind, a code of [`SerialRow`]; the number;
//! the payload, whose length [`SerialSizes::payload`] says for each kind; the CRC, high byte first. Behind the flag, a byte that equals
//! [`Serial::FLAG`] or [`Serial::ESCAPE`] is sent as two: the escape, and the byte xor [`Serial::ESCAPED`]. So a flag on the line always
//! begins a frame. A frame has no end mark: its length follows from its kind.
//!
//! The CRC is over kind, number and payload, without escapes. Its polynomial is [`Serial::CRC_POLYNOMIAL`] below x^16, its first value
//! [`Serial::CRC_START`]; bits enter with the highest of each byte first, and nothing is inverted. (It is known as CRC-16/IBM-3740.) The
//! CRC over a whole frame, its own two bytes included, is 0.
//!
//! # Payloads
//! Numbers of several bytes have their lowest byte first.
//! - [`SerialKind::Photons`], [`SerialKind::Query`]: a mark, whose bits 0 to 3 are `tdest` and bit 4 `tlast`; then the bytes of `tdata`
//!   up to the end of the last field.
//! - [`SerialKind::Result`]: a mark, whose bits 0 to 3 are `tid`, bit 4 `tlast` and bit 5 `tuser`; then the bytes of `tdata` up to the
//!   end of the last field.
//! - [`SerialKind::Read`]: the address, 2 bytes, whose bits from [`Core::ADDRESS_BITS`] on are not looked at. [`SerialKind::Write`]: such
//!   an address, and the word, 4 bytes.
//! - [`SerialKind::WriteAnswer`]: the AXI response, 1 byte. [`SerialKind::ReadAnswer`]: the AXI response and the word, 4 bytes.
//! - [`SerialKind::Sync`]: a token, 1 byte, and whether a session begins: 1 or 0, 1 byte.
//! - [`SerialKind::Synced`]: the token, 1 byte; the number of the frame that the bridge expects, 1 byte; the bytes taken, 2 bytes.
//! - [`SerialKind::Error`]: the cause, a code of [`SerialFaultRow`], 1 byte; the number of the frame that the bridge expects, 1 byte.
//! - [`SerialKind::Credit`]: the bytes taken, 2 bytes.
//!
//! # Rules of the bridge
//! - *Order.* The bridge gives the frames of the host to the core one after the other, in the order of the line. A word that the core
//!   does not take yet holds back those behind it. A photon word must therefore not be in front of a query for whose answer it waits. An
//!   access to a register is answered before the next frame is looked at.
//! - *Numbers.* The bridge expects the numbers 0, 1, ... 255, 0, ... from the host; a [`SerialKind::Sync`] has no part in them, and its
//!   number is not looked at. The bridge's own frames, of all kinds, are numbered in the same way from power-up on.
//! - *Buffer.* A frame whose CRC and number are right is put into a buffer of [`Serial::BUFFER_BYTES`], in which it has 1 byte for its
//!   kind and those of its payload. A frame that is wrong leaves nothing there.
//! - *Credit.* The bridge counts the bytes that it takes out of the buffer, modulo 2^16, and tells their sum whenever
//!   [`Serial::CREDIT_STEP`] more were taken than it has told. The host may send a frame where the bytes of all frames since the begin of
//!   the session, without those taken, are then at most [`Serial::BUFFER_BYTES`].
//! - *Errors.* Each row of [`SerialFaultRow`] makes the bridge send an [`SerialKind::Error`] and become *deaf*. It is also deaf at
//!   power-up. While it is deaf it drops all frames but a [`SerialKind::Sync`], without a further error. What it took before is not lost:
//!   the core works on.
//! - *Resynchronisation.* A right [`SerialKind::Sync`] ends the deafness, however full the buffer is. The host then goes on with the
//!   frame of the number that [`SerialKind::Synced`] says. Where a session begins, the core is reset, the buffer is emptied, the number
//!   expected and the bytes taken are 0, and answers that were not sent yet are forgotten.
//! - *Reset.* A reset of the bridge, such as a button of a board, does what the begin of a session does, and makes the bridge deaf.
//!
//! # Rules of the host
//! - At most 255 frames may be on the way that the host does not know to be taken: their numbers tell them apart.
//! - A byte outside of a frame, a wrong CRC or a number that is not the next says that a frame of the bridge is lost, perhaps a result.
//!   The host then begins a session, and sends all words again for which it has not all results.
//! - Where nothing comes for some time, the host sends a [`SerialKind::Sync`] with a token of its own. Up to the [`SerialKind::Synced`]
//!   with this token it looks at no frame of the bridge where it begins a session.

use super::{Core, CoreStreams, StreamWord};

/// The numbers of the serial line.
#[derive(Copy, Clone, Debug)]
pub struct Serial;

impl Serial {
    /// The byte that begins a frame.
    pub const FLAG: u8 = 0x7e;
    /// The byte in front of a changed byte.
    pub const ESCAPE: u8 = 0x7d;
    /// What a byte behind [`Self::ESCAPE`] is xored with.
    pub const ESCAPED: u8 = 0x20;
    /// The polynomial of the CRC below x^16: x^12 + x^5 + 1.
    pub const CRC_POLYNOMIAL: u16 = 0x1021;
    /// The first value of the CRC.
    pub const CRC_START: u16 = 0xffff;
    /// The bytes of the CRC.
    pub const CRC_BYTES: usize = 2;
    /// The bytes of the bridge's buffer: a power of two.
    pub const BUFFER_BYTES: usize = 4096;
    /// The bytes taken after which the bridge tells their sum.
    pub const CREDIT_STEP: usize = Self::BUFFER_BYTES / 8;
    /// The bit of a mark that is `tlast`; those below are the number of a chain.
    pub const MARK_LAST: u32 = 4;
    /// The bit of a mark that is `tuser`.
    pub const MARK_OUTSIDE: u32 = 5;
    /// The second byte of a [`SerialKind::Sync`] that begins a session.
    pub const BEGINS: u8 = 1;
    /// Bits that a byte takes on the line: a start bit, 8 of the byte, a stop bit.
    pub const BITS_OF_BYTE: u32 = 10;
}

/// A row of the table of kinds.
#[derive(Copy, Clone, Debug)]
pub struct SerialRow {
    /// The kind.
    pub kind: SerialKind,
    /// Its code: a letter in ASCII; of an answer the small letter.
    pub code: u8,
    /// Whether the host sends it; else the bridge does.
    pub from_host: bool,
    /// A description.
    pub about: &'static str,
}

macro_rules! kinds {
    ($($kind:ident $code:literal $from_host:literal $about:literal;)+) => {
        /// A kind of frame.
        #[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum SerialKind {
            $(#[doc = $about] $kind,)+
        }

        impl SerialRow {
            /// All kinds, those of the host first.
            pub const ALL: &[Self] = &[$(Self {
                kind: SerialKind::$kind,
                code: $code,
                from_host: $from_host,
                about: $about,
            },)+];
        }
    };
}

kinds! {
    Sync b'S' true "Ends the deafness of the bridge, or begins a session.";
    Photons b'P' true "A word for s_axis_photons.";
    Query b'Q' true "A word for s_axis_queries.";
    Read b'R' true "Reads a register.";
    Write b'W' true "Writes a register.";
    Synced b's' false "Answers a sync.";
    Error b'e' false "A frame of the host was wrong, and the bridge is deaf.";
    Credit b'c' false "The bytes that were taken out of the buffer.";
    Result b'q' false "A word of m_axis_results.";
    ReadAnswer b'r' false "Answers a read.";
    WriteAnswer b'w' false "Answers a write.";
}

/// A row of the table of causes of an error.
#[derive(Copy, Clone, Debug)]
pub struct SerialFaultRow {
    /// The cause.
    pub fault: SerialFault,
    /// Its name.
    pub name: &'static str,
    /// A description.
    pub about: &'static str,
}

macro_rules! faults {
    ($($fault:ident $name:literal $about:literal;)+) => {
        /// A cause of an error, whose code is its place in this list.
        #[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum SerialFault {
            $(#[doc = $about] $fault,)+
        }

        impl SerialFaultRow {
            /// All causes, in the order of their codes.
            pub const ALL: &[Self] = &[$(Self {
                fault: SerialFault::$fault,
                name: $name,
                about: $about,
            },)+];
        }
    };
}

faults! {
    Crc "crc" "The CRC of a frame is wrong.";
    Kind "kind" "No frame of the host has this kind.";
    Number "number" "The number of a frame is not the one that is expected: a frame before it is lost.";
    Cut "cut" "A flag came before the end of a frame.";
    Outside "outside" "A byte came that belongs to no frame.";
    StopBit "stop_bit" "A byte had no stop bit.";
    Full "full" "The buffer has no room for the frame: the host has sent more than its credit.";
}

impl SerialFault {
    /// Its code in an error.
    pub const fn code(self) -> u8 {
        self as u8
    }
}

impl SerialKind {
    /// Its row.
    pub fn row(self) -> &'static SerialRow {
        &SerialRow::ALL[self as usize]
    }

    /// Its code.
    pub fn code(self) -> u8 {
        self.row().code
    }
}

/// The lengths of the payloads of a core's frames, in bytes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SerialSizes {
    photons: usize,
    query: usize,
    result: usize,
}

/// The bytes of a word up to the end of its last field.
fn data_bytes(word: &StreamWord) -> usize {
    word.end().div_ceil(u8::BITS) as usize
}

impl SerialSizes {
    /// Those of a core.
    pub fn of(core: &Core) -> Self {
        let streams = CoreStreams::of(core);
        let with_mark = |word| 1 + data_bytes(word);
        Self {
            photons: with_mark(&streams.photons),
            query: with_mark(&streams.queries),
            result: with_mark(&streams.results),
        }
    }

    /// The bytes of the payload of a kind.
    pub fn payload(&self, kind: SerialKind) -> usize {
        const ADDRESS: usize = 2;
        const WORD: usize = Core::REGISTER_BITS as usize / 8;
        match kind {
            SerialKind::Photons => self.photons,
            SerialKind::Query => self.query,
            SerialKind::Result => self.result,
            SerialKind::Sync | SerialKind::Error | SerialKind::Credit => 2,
            SerialKind::Synced => 4,
            SerialKind::Read => ADDRESS,
            SerialKind::Write => ADDRESS + WORD,
            SerialKind::ReadAnswer => 1 + WORD,
            SerialKind::WriteAnswer => 1,
        }
    }

    /// The bytes that a frame has in the buffer of the bridge.
    pub fn in_buffer(&self, kind: SerialKind) -> usize {
        1 + self.payload(kind)
    }

    /// The longest payload of the host, or of the bridge.
    pub fn longest(&self, from_host: bool) -> usize {
        let rows = SerialRow::ALL
            .iter()
            .filter(|row| row.from_host == from_host);
        let longest = rows.map(|row| self.payload(row.kind)).max();
        longest.expect("both sides have frames")
    }
}

/// An address of the buffer has no value without a byte, and the bytes taken have 16 bits.
const _: () = assert!(Serial::BUFFER_BYTES.is_power_of_two() && Serial::BUFFER_BYTES < 1 << 16);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    #[test]
    fn each_kind_has_a_code_of_its_own_that_needs_no_escape() {
        for row in SerialRow::ALL {
            let same = SerialRow::ALL.iter().filter(|other| other.code == row.code);
            assert_eq!(same.count(), 1, "{row:?}");
            assert_eq!(row.kind.row().code, row.code);
            assert!(row.code.is_ascii_alphabetic(), "{row:?}");
            assert_eq!(row.code.is_ascii_uppercase(), row.from_host, "{row:?}");
        }
    }

    #[test]
    fn the_code_of_a_fault_is_its_place() {
        for (place, row) in SerialFaultRow::ALL.iter().enumerate() {
            assert_eq!(usize::from(row.fault.code()), place);
        }
    }

    /// With less room the host would wait for a credit that the bridge has no reason to send.
    #[test]
    fn the_longest_frame_has_room_beside_bytes_that_are_not_told() {
        for (machine, chains) in [
            ("leaf-5-local7-rgb6d-n64", 3),
            ("leaf-7-local8-rgb8e5-n4096", 16),
        ] {
            let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
            let sizes = SerialSizes::of(&core);
            let longest = 1 + sizes.longest(true);
            assert!(longest + Serial::CREDIT_STEP <= Serial::BUFFER_BYTES);
            assert!(longest <= usize::from(u8::MAX), "a counter has 8 bits");
            // As many of the shortest frames as are taken and not told must be fewer than the host may have on the way.
            let hosts = SerialRow::ALL.iter().filter(|row| row.from_host);
            let shortest = hosts.map(|row| sizes.in_buffer(row.kind)).min().unwrap();
            assert!(Serial::CREDIT_STEP / shortest < usize::from(u8::MAX));
            assert_eq!(sizes.payload(SerialKind::Query), 1 + 13);
        }
    }
}

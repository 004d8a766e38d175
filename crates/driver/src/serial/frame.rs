//! Frames of the serial line, written and read.

use photoncube_spec::{Serial, SerialKind, SerialRow, SerialSizes};

/// The CRC behind a byte.
fn crc_step(crc: u16, byte: u8) -> u16 {
    let mut crc = crc ^ u16::from(byte) << 8;
    for _ in 0..u8::BITS {
        let leaves = crc >> 15 == 1;
        crc <<= 1;
        if leaves {
            crc ^= Serial::CRC_POLYNOMIAL;
        }
    }
    crc
}

/// The CRC over bytes.
fn crc(bytes: &[u8]) -> u16 {
    bytes
        .iter()
        .fold(Serial::CRC_START, |crc, &byte| crc_step(crc, byte))
}

/// Appends a frame to what goes on the line.
pub(super) fn write(kind: SerialKind, number: u8, payload: &[u8], line: &mut Vec<u8>) {
    let mut bytes = vec![kind.code(), number];
    bytes.extend(payload);
    let crc = crc(&bytes);
    bytes.extend(crc.to_be_bytes());
    line.push(Serial::FLAG);
    for byte in bytes {
        match byte {
            Serial::FLAG | Serial::ESCAPE => line.extend([Serial::ESCAPE, byte ^ Serial::ESCAPED]),
            plain => line.push(plain),
        }
    }
}

/// A frame of the bridge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    pub(super) kind: SerialKind,
    pub(super) payload: Vec<u8>,
}

/// What a byte of the line ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Heard {
    /// A right frame.
    Frame(Frame),
    /// Something that is no right frame behind the one before.
    Damage,
}

/// Reads the frames of the bridge.
#[derive(Debug)]
pub(super) struct Reader {
    sizes: SerialSizes,
    /// The bytes behind the flag, without escapes; none outside of a frame.
    bytes: Option<Vec<u8>>,
    escaped: bool,
    /// The number of the next frame; none before the first.
    next: Option<u8>,
    /// Whether a frame must have the next number.
    counts: bool,
}

impl Reader {
    pub(super) fn new(sizes: SerialSizes) -> Self {
        Self {
            sizes,
            bytes: None,
            escaped: false,
            next: None,
            counts: true,
        }
    }

    /// From now on, looks whether a frame has the number of the next, or takes any.
    pub(super) fn count(&mut self, counts: bool) {
        self.counts = counts;
    }

    /// Takes a byte of the line.
    pub(super) fn take(&mut self, byte: u8) -> Option<Heard> {
        if byte == Serial::FLAG {
            self.escaped = false;
            return self.bytes.replace(Vec::new()).map(|_| Heard::Damage);
        }
        let Some(bytes) = &mut self.bytes else {
            return Some(Heard::Damage);
        };
        if byte == Serial::ESCAPE {
            self.escaped = true;
            return None;
        }
        let changed = std::mem::take(&mut self.escaped);
        bytes.push(byte ^ if changed { Serial::ESCAPED } else { 0 });
        let row = SerialRow::ALL
            .iter()
            .find(|row| !row.from_host && row.code == bytes[0]);
        let Some(row) = row else {
            self.bytes = None;
            return Some(Heard::Damage);
        };
        const HEAD: usize = 2;
        let length = HEAD + self.sizes.payload(row.kind) + Serial::CRC_BYTES;
        if bytes.len() < length {
            return None;
        }
        let bytes = self.bytes.take().unwrap_or_default();
        Some(self.checked(row.kind, &bytes, HEAD))
    }

    /// A frame of the right length.
    fn checked(&mut self, kind: SerialKind, bytes: &[u8], head: usize) -> Heard {
        let number = bytes[1];
        let is_next = self.next.is_none_or(|next| next == number);
        if crc(bytes) != 0 || self.counts && !is_next {
            return Heard::Damage;
        }
        self.next = Some(number.wrapping_add(1));
        Heard::Frame(Frame {
            kind,
            payload: bytes[head..bytes.len() - Serial::CRC_BYTES].to_vec(),
        })
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Core, find_machine};

    use super::*;

    fn reader() -> Reader {
        let machine = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
        Reader::new(SerialSizes::of(&Core::new(machine, 3).unwrap()))
    }

    fn heard(reader: &mut Reader, line: &[u8]) -> Vec<Heard> {
        line.iter().filter_map(|&byte| reader.take(byte)).collect()
    }

    /// The catalogue of CRCs has this value of CRC-16/IBM-3740 over the digits 1 to 9.
    #[test]
    fn the_crc_has_the_known_check_value() {
        assert_eq!(crc(b"123456789"), 0x29b1);
    }

    #[test]
    fn frames_are_read_back_and_flags_in_them_are_escaped() {
        let mut line = Vec::new();
        write(SerialKind::Credit, 7, &[0x7e, 0x7d], &mut line);
        write(SerialKind::WriteAnswer, 8, &[0], &mut line);
        assert_eq!(line[..7], [0x7e, b'c', 7, 0x7d, 0x5e, 0x7d, 0x5d]);
        let frame = |kind, payload: &[u8]| {
            Heard::Frame(Frame {
                kind,
                payload: payload.to_vec(),
            })
        };
        let expected = [
            frame(SerialKind::Credit, &[0x7e, 0x7d]),
            frame(SerialKind::WriteAnswer, &[0]),
        ];
        assert_eq!(heard(&mut reader(), &line), expected);
    }

    #[test]
    fn each_bit_that_is_wrong_is_found() {
        let mut line = Vec::new();
        for number in 0..3 {
            write(SerialKind::Credit, number, &[1, 2], &mut line);
        }
        let frame = line.len() / 3;
        for bit in 8 * frame..16 * frame {
            let mut wrong = line.clone();
            wrong[bit / 8] ^= 1 << (bit % 8);
            let heard = heard(&mut reader(), &wrong);
            assert!(heard.contains(&Heard::Damage), "bit {bit}: {heard:?}");
        }
    }

    #[test]
    fn each_byte_that_is_lost_is_found() {
        let mut line = Vec::new();
        for number in 0..3 {
            write(SerialKind::Credit, number, &[1, 2], &mut line);
        }
        let frame = line.len() / 3;
        for byte in frame..2 * frame {
            let mut short = line.clone();
            short.remove(byte);
            let heard = heard(&mut reader(), &short);
            assert!(heard.contains(&Heard::Damage), "byte {byte}: {heard:?}");
        }
    }
}

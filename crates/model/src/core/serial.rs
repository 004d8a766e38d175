//! The model of a core at the end of a serial line: bytes in, bytes out, by the rules of [`photoncube_spec::Serial`].
//!
//! It has no clocks of the line. A byte that comes is followed at once by all that it makes happen; the core runs while it has work.

use std::collections::VecDeque;

use photoncube_spec::{
    Beat, Core, CoreInputs, CoreOutputs, CoreStreams, Leaf, LiteAnswer, LiteIn, Serial,
    SerialFault, SerialKind, SerialRow, SerialSizes, StreamIn, StreamWord,
};

use super::CoreModel;

/// A frame: its kind, its number and its payload.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SerialFrame {
    /// The kind.
    pub kind: SerialKind,
    /// The number.
    pub number: u8,
    /// The payload.
    pub payload: Vec<u8>,
}

/// The remainder of a division of polynomials over bits: bytes, highest bits first, with the start value in front, by x^16 + the CRC's
/// polynomial.
fn remainder(bytes: &[u8]) -> u32 {
    let mut bits: Vec<bool> = bytes
        .iter()
        .flat_map(|byte| (0..u8::BITS).rev().map(move |bit| byte >> bit & 1 == 1))
        .collect();
    let crc_bits = 8 * Serial::CRC_BYTES;
    // The start value is added to the first bits.
    for (place, bit) in bits.iter_mut().take(crc_bits).enumerate() {
        *bit ^= Serial::CRC_START >> (crc_bits - 1 - place) & 1 == 1;
    }
    let divisor = 1_u32 << crc_bits | u32::from(Serial::CRC_POLYNOMIAL);
    for place in 0..bits.len() - crc_bits {
        if bits[place] {
            for term in 0..=crc_bits {
                bits[place + term] ^= divisor >> (crc_bits - term) & 1 == 1;
            }
        }
    }
    let last = bits[bits.len() - crc_bits..].iter();
    last.fold(0, |sum, &bit| sum << 1 | u32::from(bit))
}

impl SerialFrame {
    /// The bytes of the frame on the line.
    pub fn line(&self) -> Vec<u8> {
        let mut plain = vec![self.kind.code(), self.number];
        plain.extend(&self.payload);
        let with_room = [&plain[..], &[0; Serial::CRC_BYTES]].concat();
        let crc = remainder(&with_room);
        plain.extend([(crc >> 8) as u8, crc as u8]);
        let escaped = plain.iter().flat_map(|&byte| {
            let special = byte == Serial::FLAG || byte == Serial::ESCAPE;
            let escape = special.then_some(Serial::ESCAPE);
            escape.into_iter().chain([if special {
                byte ^ Serial::ESCAPED
            } else {
                byte
            }])
        });
        std::iter::once(Serial::FLAG).chain(escaped).collect()
    }

    /// The frames of the bridge on a line, up to the first byte that belongs to no right frame.
    ///
    /// # Errors
    /// Says what is wrong, with the frames in front of it.
    pub fn of_bridge(sizes: &SerialSizes, line: &[u8]) -> Result<Vec<Self>, String> {
        let mut frames = Vec::new();
        let mut parts = line.split(|&byte| byte == Serial::FLAG);
        if parts.next().is_some_and(|before| !before.is_empty()) {
            return Err(format!("found bytes before the first flag: {line:02x?}"));
        }
        for part in parts {
            let plain = unescaped(part);
            let row = SerialRow::ALL
                .iter()
                .find(|row| !row.from_host && Some(&row.code) == plain.first());
            let Some(row) = row else {
                return Err(format!("found {plain:02x?}, which is of no kind"));
            };
            let length = 2 + sizes.payload(row.kind) + Serial::CRC_BYTES;
            if plain.len() != length || remainder(&plain) != 0 {
                return Err(format!("found {plain:02x?}, no right frame {:?}", row.kind));
            }
            frames.push(Self {
                kind: row.kind,
                number: plain[1],
                payload: plain[2..length - Serial::CRC_BYTES].to_vec(),
            });
        }
        Ok(frames)
    }
}

fn unescaped(part: &[u8]) -> Vec<u8> {
    let mut plain = Vec::new();
    let mut escaped = false;
    for &byte in part {
        match byte {
            Serial::ESCAPE => escaped = true,
            byte => {
                plain.push(byte ^ if escaped { Serial::ESCAPED } else { 0 });
                escaped = false;
            }
        }
    }
    plain
}

/// A core at the end of a serial line, with its state.
#[derive(Clone, Debug)]
pub struct SerialModel {
    core: CoreModel,
    kind_of_core: Core,
    digest: u64,
    sizes: SerialSizes,
    streams: CoreStreams,
    /// What came behind a flag; none outside of a frame.
    part: Option<Vec<u8>>,
    deaf: bool,
    expected: u8,
    buffer: VecDeque<(SerialKind, Vec<u8>)>,
    /// The frame that the core is given.
    given: Option<(SerialKind, Vec<u8>)>,
    taken: u16,
    told: u16,
    number: u8,
    said: VecDeque<u8>,
    /// Whether the core may have work.
    awake: bool,
}

impl SerialModel {
    /// A core in its power-up state. `digest` is that of its configuration.
    pub fn new(core: &Core, digest: u64) -> Self {
        Self {
            core: CoreModel::new(core, digest),
            kind_of_core: *core,
            digest,
            sizes: SerialSizes::of(core),
            streams: CoreStreams::of(core),
            part: None,
            deaf: true,
            expected: 0,
            buffer: VecDeque::new(),
            given: None,
            taken: 0,
            told: 0,
            number: 0,
            said: VecDeque::new(),
            awake: false,
        }
    }

    /// Takes a byte of the host, and does what follows.
    pub fn hear(&mut self, byte: u8) {
        if byte == Serial::FLAG {
            if self.part.replace(Vec::new()).is_some() {
                self.fault(SerialFault::Cut);
            }
        } else if let Some(part) = &mut self.part {
            part.push(byte);
            let ends_escaped = part.last() == Some(&Serial::ESCAPE);
            let plain = unescaped(part);
            if !ends_escaped {
                self.bytes(&plain);
            }
        } else {
            self.fault(SerialFault::Outside);
        }
        self.run();
    }

    /// Takes a byte that has no stop bit.
    pub fn hear_broken(&mut self) {
        self.part = None;
        self.fault(SerialFault::StopBit);
        self.run();
    }

    /// A reset of the bridge.
    pub fn reset(&mut self) {
        self.clear();
        self.part = None;
        self.deaf = true;
    }

    /// The bytes taken out of the buffer, modulo 2^16.
    pub fn taken(&self) -> u16 {
        self.taken
    }

    /// Returns what the bridge has said since the last call.
    pub fn said(&mut self) -> Vec<u8> {
        self.said.drain(..).collect()
    }

    /// The bytes of the frame so far.
    fn bytes(&mut self, plain: &[u8]) {
        let row = SerialRow::ALL
            .iter()
            .find(|row| row.from_host && row.code == plain[0]);
        let Some(row) = row else {
            self.part = None;
            return self.fault(SerialFault::Kind);
        };
        let length = 2 + self.sizes.payload(row.kind) + Serial::CRC_BYTES;
        if plain.len() < length {
            return;
        }
        self.part = None;
        if remainder(plain) != 0 {
            return self.fault(SerialFault::Crc);
        }
        let payload = plain[2..length - Serial::CRC_BYTES].to_vec();
        match row.kind {
            SerialKind::Sync => self.sync(payload[0], payload[1] == Serial::BEGINS),
            _ if self.deaf => {}
            _ if plain[1] != self.expected => self.fault(SerialFault::Number),
            kind if self.held() + self.sizes.in_buffer(kind) > Serial::BUFFER_BYTES => {
                self.fault(SerialFault::Full);
            }
            kind => {
                self.expected = self.expected.wrapping_add(1);
                self.buffer.push_back((kind, payload));
                // A frame behind one that waits does not help it.
                self.awake |= self.given.is_none();
            }
        }
    }

    /// The bytes in the buffer.
    fn held(&self) -> usize {
        let frames = self.buffer.iter();
        frames.map(|(kind, _)| self.sizes.in_buffer(*kind)).sum()
    }

    fn fault(&mut self, fault: SerialFault) {
        if !std::mem::replace(&mut self.deaf, true) {
            let payload = vec![fault.code(), self.expected];
            self.say(SerialKind::Error, payload);
        }
    }

    /// Resets the core, and forgets what is on the way to it.
    fn clear(&mut self) {
        self.core = CoreModel::new(&self.kind_of_core, self.digest);
        self.buffer.clear();
        self.given = None;
        (self.expected, self.taken, self.told) = (0, 0, 0);
    }

    fn sync(&mut self, token: u8, begins: bool) {
        self.deaf = false;
        if begins {
            self.clear();
        }
        let [low, high] = self.taken.to_le_bytes();
        self.told = self.taken;
        self.say(SerialKind::Synced, vec![token, self.expected, low, high]);
    }

    fn say(&mut self, kind: SerialKind, payload: Vec<u8>) {
        let frame = SerialFrame {
            kind,
            number: self.number,
            payload,
        };
        self.number = self.number.wrapping_add(1);
        self.said.extend(frame.line());
    }

    /// Runs the core until nothing has moved for long.
    fn run(&mut self) {
        let mut still = 0;
        while self.awake {
            still = if self.step() { 0 } else { still + 1 };
            let works = self.given.is_some() || !self.buffer.is_empty() || self.busy();
            self.awake = still < if works { QUIET } else { SETTLED };
        }
    }

    /// Whether queries are under way in the core.
    fn busy(&self) -> bool {
        self.core.registers.is_busy()
    }

    /// One clock of the core; says whether something moved at the bridge.
    fn step(&mut self) -> bool {
        if self.given.is_none()
            && let Some((kind, payload)) = self.buffer.pop_front()
        {
            self.taken = self.taken.wrapping_add(self.sizes.in_buffer(kind) as u16);
            if usize::from(self.taken.wrapping_sub(self.told)) >= Serial::CREDIT_STEP {
                self.told = self.taken;
                self.say(SerialKind::Credit, self.taken.to_le_bytes().into());
            }
            self.given = Some((kind, payload));
        }
        let inputs = self.inputs();
        let outputs = self.core.outputs(&inputs);
        self.core.clock(&inputs);
        let moved = self.moved(&outputs);
        if moved && let Some((kind @ (SerialKind::Read | SerialKind::Write), _)) = self.given {
            self.access(kind);
        } else if moved {
            self.given = None;
        }
        if let Some(result) = &outputs.result {
            let mark = result.id
                | u32::from(result.last) << Serial::MARK_LAST
                | u32::from(result.outside) << Serial::MARK_OUTSIDE;
            let mut payload = vec![mark as u8];
            payload.extend(&result.data[..self.sizes.payload(SerialKind::Result) - 1]);
            self.say(SerialKind::Result, payload);
        }
        moved || outputs.result.is_some()
    }

    /// The core's inputs while it is given a frame.
    fn inputs(&self) -> CoreInputs {
        let mut inputs = CoreInputs {
            result_ready: true,
            ..CoreInputs::default()
        };
        let Some((kind, payload)) = &self.given else {
            return inputs;
        };
        let number = |bytes: &[u8]| {
            let bytes = bytes.iter().rev();
            bytes.fold(0, |sum, &byte| sum << 8 | u32::from(byte))
        };
        let address = |bytes: &[u8]| number(bytes) % (1 << Core::ADDRESS_BITS);
        match kind {
            SerialKind::Photons => inputs.photons = word(payload, &self.streams.photons),
            SerialKind::Query => inputs.queries = word(payload, &self.streams.queries),
            SerialKind::Read => {
                inputs.lite.read_address = address(payload);
                inputs.lite.read_address_valid = true;
            }
            _ => {
                let (place, word) = payload.split_at(2);
                inputs.lite = LiteIn {
                    write_address: address(place),
                    write_address_valid: true,
                    write_data: number(word),
                    write_strobe: 0b1111,
                    write_data_valid: true,
                    ..LiteIn::default()
                };
            }
        }
        inputs
    }

    /// Whether the core takes the frame that it is given.
    fn moved(&self, outputs: &CoreOutputs) -> bool {
        match self.given {
            Some((SerialKind::Photons, _)) => outputs.photon_ready,
            Some((SerialKind::Query, _)) => outputs.query_ready,
            Some((SerialKind::Read, _)) => outputs.read_ready,
            Some(_) => outputs.write_ready,
            None => false,
        }
    }

    /// The clocks behind an access, up to that in which its answer comes.
    fn access(&mut self, kind: SerialKind) {
        self.given = None;
        let inputs = CoreInputs {
            lite: LiteIn {
                read_answer_ready: true,
                write_answer_ready: true,
                ..LiteIn::default()
            },
            ..CoreInputs::default()
        };
        let mut answer = || {
            let outputs = self.core.outputs(&inputs);
            self.core.clock(&inputs);
            match kind {
                SerialKind::Read => outputs.read_answer,
                _ => outputs.write_answer,
            }
        };
        // A read is answered two clocks after a write.
        let answer = (0..3).find_map(|_| answer());
        let LiteAnswer { refused, word } = answer.expect("the core answers within three clocks");
        let mut payload = vec![if refused { SLVERR } else { 0 }];
        match kind {
            SerialKind::Read => {
                payload.extend(word.to_le_bytes());
                self.say(SerialKind::ReadAnswer, payload);
            }
            _ => self.say(SerialKind::WriteAnswer, payload),
        }
    }
}

/// The AXI response of a refused access.
const SLVERR: u8 = 2;

/// Clocks in which a word passes the slice of its stream, at most.
const SETTLED: u64 = 8;

/// Clocks without a move at the bridge after which the core waits for the host.
const QUIET: u64 = Leaf::SILENT_CLOCKS / 16;

/// A word of a stream, from its mark and its first bytes.
fn word(payload: &[u8], word: &StreamWord) -> StreamIn {
    let mut data = payload[1..].to_vec();
    data.resize(word.bits as usize / 8, 0);
    StreamIn {
        valid: true,
        beat: Beat {
            data,
            last: payload[0] >> Serial::MARK_LAST & 1 == 1,
            dest: u32::from(payload[0]) & ((1 << Serial::MARK_LAST) - 1),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The catalogue of CRCs has this value of CRC-16/IBM-3740 over the digits 1 to 9.
    #[test]
    fn the_division_has_the_known_check_value() {
        assert_eq!(remainder(b"123456789\0\0"), 0x29b1);
        assert_eq!(remainder(b"123456789\x29\xb1"), 0);
    }
}

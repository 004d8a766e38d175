//! The module that joins the modules of the line with a core.

use photoncube_spec::{Core, CoreStreams, Serial, SerialKind, SerialSizes, StreamWord};

use crate::core::EmittedCore;

/// A core at the end of a serial line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OnLine {
    /// The name of the top module. Its parameter `CLOCKS` has the clocks of a bit.
    pub top: String,
    /// The text of all modules, without that of the core.
    pub text: String,
}

/// The modules that put a core at the end of a serial line.
pub fn core_on_line(core: &Core, emitted: &EmittedCore) -> OnLine {
    let top = format!("{}_on_line", emitted.top);
    OnLine {
        text: format!("{}\n{}", joined(core, &top), super::modules(core)),
        top,
    }
}

/// The payload of the frame that starts, as wide as the longest of the bridge.
pub(super) fn payloads(sizes: &SerialSizes) -> String {
    let bits = 8 * sizes.longest(false);
    let padded = |kind: SerialKind, bytes: &str| {
        let gap = bits - 8 * sizes.payload(kind);
        match gap {
            0 => bytes.to_owned(),
            _ => format!("{{{gap}'d0, {bytes}}}"),
        }
    };
    let answer = format!("{{{}'d0, answer}}", bits - 40);
    let answer = if bits == 40 {
        "answer".to_owned()
    } else {
        answer
    };
    format!(
        "sends_synced ? {} : sends_error ? {}\n                : sends_answer ? {answer} : sends_credit ? {} : {}",
        padded(SerialKind::Synced, "taken, expected, token"),
        padded(SerialKind::Error, "expected, cause"),
        padded(SerialKind::Credit, "taken"),
        padded(SerialKind::Result, "result"),
    )
}

/// The bits of a host's payload from a byte on, in the register that has the last byte at its top.
struct Payload {
    low: usize,
    high: usize,
}

impl Payload {
    fn of(sizes: &SerialSizes, kind: SerialKind) -> Self {
        let bits = 8 * sizes.longest(true);
        Self {
            low: bits - 8 * sizes.payload(kind),
            high: bits - 1,
        }
    }

    /// So many bits from a bit of the payload on.
    fn bits(&self, from: usize, width: usize) -> String {
        let low = self.low + from;
        match width {
            1 => format!("payload[{low}]"),
            _ => format!("payload[{}:{low}]", low + width - 1),
        }
    }

    /// The mark and the word of a stream, as connections.
    fn stream(&self, port: &str, word: &StreamWord, chain_bits: u32) -> String {
        let data = self.high + 1 - self.low - 8;
        let gap = word.bits as usize - data;
        let data = self.bits(8, data);
        let data = match gap {
            0 => data,
            _ => format!("{{{gap}'d0, {data}}}"),
        };
        format!(
            "        .{port}_tdata({data}), .{port}_tlast({}), .{port}_tdest({}),\n",
            self.bits(Serial::MARK_LAST as usize, 1),
            self.bits(0, chain_bits as usize),
        )
    }
}

/// The top module.
fn joined(core: &Core, top: &str) -> String {
    let sizes = SerialSizes::of(core);
    let streams = CoreStreams::of(core);
    let of = |kind| Payload::of(&sizes, kind);
    let (write, read) = (of(SerialKind::Write), of(SerialKind::Read));
    let (address, word) = (Core::ADDRESS_BITS as usize, Core::REGISTER_BITS as usize);
    let result_bytes = sizes.payload(SerialKind::Result);
    let chain = core.chain_bits();
    let mark_gap = Serial::MARK_LAST - chain;
    let gap = |bits: u32| match bits {
        0 => String::new(),
        _ => format!("{bits}'d0, "),
    };
    let parts = [
        ("ON_LINE", top.to_owned()),
        ("TOP", core.top()),
        (
            "PHOTONS",
            of(SerialKind::Photons).stream("s_axis_photons", &streams.photons, chain),
        ),
        (
            "QUERIES",
            of(SerialKind::Query).stream("s_axis_queries", &streams.queries, chain),
        ),
        ("WRITE_ADDRESS", write.bits(0, address)),
        ("WRITE_WORD", write.bits(16, word)),
        ("READ_ADDRESS", read.bits(0, address)),
        ("IN_HIGH", of(SerialKind::Read).high.to_string()),
        ("RESULT_HIGH", (8 * result_bytes - 1).to_string()),
        ("RESULT_DATA", (8 * (result_bytes - 1) - 1).to_string()),
        ("RESULT_TOP", (streams.results.bits - 1).to_string()),
        ("CHAIN_HIGH", (chain - 1).to_string()),
        (
            "RESULT_MARK",
            format!(
                "{}result_outside, result_last, {}result_chain",
                gap(7 - Serial::MARK_OUTSIDE),
                gap(mark_gap)
            ),
        ),
    ];
    parts
        .iter()
        .fold(TEMPLATE.to_owned(), |text, (name, part)| {
            text.replace(&format!("@{name}@"), part)
        })
}

const TEMPLATE: &str = include_str!("on_line.v");

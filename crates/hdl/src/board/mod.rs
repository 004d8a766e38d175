//! The Verilog that puts a core at the end of a serial line, and on a board.
//!
//! The modules of the line are written in Verilog, for the reason that those of a core are. They follow the rules of
//! [`photoncube_spec::Serial`]; the numbers in them come from its tables.

mod bridge;
mod crc;
mod ulx3s;

use photoncube_spec::{Core, Serial, SerialFaultRow, SerialRow, SerialSizes};

pub use bridge::{OnLine, core_on_line};
pub use ulx3s::{Ulx3s, Ulx3sError, Ulx3sFiles};

/// The modules of the line, in which numbers are put.
const MODULES: [&str; 6] = [
    include_str!("uart_receiver.v"),
    include_str!("uart_transmitter.v"),
    include_str!("frames_in.v"),
    include_str!("buffer.v"),
    include_str!("dispatch.v"),
    include_str!("frames_out.v"),
];

/// The lengths of the payloads of one side's kinds, chosen by `value`; 0 for other kinds.
fn lengths(sizes: &SerialSizes, from_host: bool) -> String {
    let rows = SerialRow::ALL.iter();
    let rows = rows.filter(|row| row.from_host == from_host);
    let choices = rows.map(|row| {
        let length = sizes.payload(row.kind);
        format!("(value == 8'd{}) ? 8'd{length} : ", row.code)
    });
    choices.collect::<String>() + "8'd0"
}

/// `READ_ANSWER` of `ReadAnswer`.
fn upper(name: &str) -> String {
    let mut upper = String::new();
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && !upper.is_empty() {
            upper.push('_');
        }
        upper.push(letter.to_ascii_uppercase());
    }
    upper
}

/// The names in the modules and what stands in their place.
fn parts(core: &Core) -> Vec<(String, String)> {
    let sizes = SerialSizes::of(core);
    let address_bits = Serial::BUFFER_BYTES.ilog2();
    let high = |bytes: usize| (8 * bytes - 1).to_string();
    let numbers = [
        ("TOP", core.top()),
        ("ESCAPED", Serial::ESCAPED.to_string()),
        ("ESCAPE", Serial::ESCAPE.to_string()),
        ("FLAG", Serial::FLAG.to_string()),
        ("CRC_START", Serial::CRC_START.to_string()),
        ("BEGINS", Serial::BEGINS.to_string()),
        ("CREDIT_STEP", Serial::CREDIT_STEP.to_string()),
        ("BUFFER_LAST", (Serial::BUFFER_BYTES - 1).to_string()),
        ("ADDRESS_HIGH", (address_bits - 1).to_string()),
        ("ADDRESS_BITS", address_bits.to_string()),
        ("COUNT_BITS", (address_bits + 1).to_string()),
        ("IN_HIGH", high(sizes.longest(true))),
        ("OUT_HIGH", high(sizes.longest(false))),
        (
            "RESULT_HIGH",
            high(sizes.payload(photoncube_spec::SerialKind::Result)),
        ),
        ("PAYLOADS", bridge::payloads(&sizes)),
    ];
    let numbers = numbers.map(|(name, text)| (name.to_owned(), text));
    let kinds = SerialRow::ALL
        .iter()
        .map(|row| (upper(&format!("{:?}", row.kind)), row.code.to_string()));
    let faults = SerialFaultRow::ALL
        .iter()
        .map(|row| (row.name.to_uppercase(), row.fault.code().to_string()));
    numbers.into_iter().chain(faults).chain(kinds).collect()
}

/// The modules of the line of a core.
fn modules(core: &Core) -> String {
    let (parts, sizes) = (parts(core), SerialSizes::of(core));
    let mut all = crc::crc(&core.top());
    for module in MODULES {
        let from_host = !module.contains("_frames_out(");
        let with_lengths = module.replace("@LENGTHS@", &lengths(&sizes, from_host));
        let text = parts.iter().fold(with_lengths, |text, (name, part)| {
            text.replace(&format!("@{name}@"), part)
        });
        all += "\n";
        all += &text;
    }
    all
}

//! The map of registers of a core.

use super::counters::CounterRow;
use super::events::EventRow;
use super::fields::CoreField;
use super::{Core, CoreCounter, Rounds};
use crate::formats::Widths;
use crate::leaf::Leaf;

/// A register with an address of its own. A counter has two: of its low word, and of its high word.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum CoreRegister {
    /// Says that this is a core: [`CoreRegister::IDENTITY`].
    Identity,
    /// The version of this map.
    Version,
    /// The low 32 bits of the digest of the configuration.
    DigestLow,
    /// The high 32 bits of the digest.
    DigestHigh,
    /// The numbers of chains, engines and leaves.
    Shape,
    /// Does something where a 1 is written; reads as 0.
    Control,
    /// The present state.
    Status,
    /// A bit for each event that occurred. Writing a 1 clears the bit; an event in that clock stays.
    Events,
    /// The events that raise `irq`, which is 1 while such a bit of `Events` is.
    InterruptEnable,
    /// The silent clocks after which the core is stalled; 0 for never.
    StallLimit,
    /// The queries under way.
    UnderWay,
    /// The low word of a counter. A read copies its other bits to the register that `CounterHigh` reads.
    CounterLow(CoreCounter),
    /// The copy of the high word of the counter whose low word was read last.
    CounterHigh(CoreCounter),
    /// The number k of the photon that the k nearest end at; 0 for none. This register and the next two are there where queries have
    /// radii, see [`Rounds`].
    Nearest,
    /// The rungs of the ladder; 0 for none.
    Rungs,
    /// The radius of a rung.
    Rung(u32),
}

/// How a register is accessed.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// It is read; a write is refused.
    Read,
    /// It is read and written, byte by byte where the strobe is set.
    ReadWrite,
    /// A written 1 clears its bit.
    WriteOneToClear,
    /// A written 1 has an effect in that clock; it reads as 0.
    WriteOneToDo,
}

/// A row of the map of registers.
#[derive(Clone, Debug)]
pub struct CoreRegisterRow {
    /// The register.
    pub register: CoreRegister,
    /// Its name.
    pub name: String,
    /// Its address, in bytes.
    pub address: u32,
    /// How it is accessed.
    pub access: Access,
    /// A description.
    pub about: String,
    /// Its value after `aresetn`, where it is written or constant.
    pub reset: u32,
    /// Its fields, the lowest bit first.
    pub fields: Vec<CoreField>,
}

impl CoreRegisterRow {
    /// Whether its value after `aresetn` is that of the moment, not `reset`.
    pub fn is_live(&self) -> bool {
        use CoreRegister as R;
        matches!(
            self.register,
            R::Status | R::UnderWay | R::CounterLow(_) | R::CounterHigh(_)
        )
    }
}

impl CoreRegister {
    /// `PCUB` in ASCII, the first letter in the highest byte.
    pub const IDENTITY: u32 = u32::from_be_bytes(*b"PCUB");
    /// The version of this map. It changes where a register or a stream changes its meaning.
    pub const VERSION: u32 = 1;
    /// The address of the first counter.
    pub const COUNTERS: u32 = 0x40;
    /// The address of the first register of the rounds.
    pub const ROUNDS: u32 = 0x100;
    /// `Control`: the chains and streams restart.
    pub const RESTART: u32 = 1 << 0;
    /// `Control`: all counters := 0.
    pub const CLEAR_COUNTERS: u32 = 1 << 1;

    /// All registers of a core, by address. `digest` is that of the configuration.
    pub fn all(core: &Core, digest: u64) -> Vec<CoreRegisterRow> {
        let leaf = core.leaf();
        let [low, high] = [digest as u32, (digest >> 32) as u32];
        let shape = [
            (core.chains, "chains", 8, "Chains."),
            (
                leaf.chain.engines() as u32,
                "engines",
                8,
                "Engines of each chain.",
            ),
            (
                core.set_leaves(),
                "set_leaves",
                16,
                "Leaves that each of the two banks of a chain holds.",
            ),
        ];
        let (shape, shape_fields) = packed(&shape);
        let events: Vec<_> = EventRow::ALL
            .iter()
            .map(|row| CoreField::bit(row.event as u32, row.name, row.about))
            .collect();
        let fixed = [
            (
                Self::Identity,
                "identity",
                Access::Read,
                Self::IDENTITY,
                "`PCUB` in ASCII.",
                vec![],
            ),
            (
                Self::Version,
                "version",
                Access::Read,
                Self::VERSION,
                "Version of this map of registers and of the words of the streams.",
                vec![],
            ),
            (
                Self::DigestLow,
                "digest_low",
                Access::Read,
                low,
                "The low 32 bits of the digest of the configuration: of the SHA-256 of the chains' Verilog and their number.",
                vec![],
            ),
            (
                Self::DigestHigh,
                "digest_high",
                Access::Read,
                high,
                "The high 32 bits of the digest.",
                vec![],
            ),
            (
                Self::Shape,
                "shape",
                Access::Read,
                shape,
                "The shape of the core.",
                shape_fields,
            ),
            (
                Self::Control,
                "control",
                Access::WriteOneToDo,
                0,
                "Commands; reads as 0.",
                vec![
                    CoreField::bit(
                        Self::RESTART.ilog2(),
                        "restart",
                        "Empties the chains and the streams; registers and counters stay.",
                    ),
                    CoreField::bit(
                        Self::CLEAR_COUNTERS.ilog2(),
                        "clear_counters",
                        "Sets all counters to 0.",
                    ),
                ],
            ),
            (
                Self::Status,
                "status",
                Access::Read,
                0,
                "The present state.",
                vec![
                    CoreField::bit(0, "busy", "A query is under way."),
                    CoreField::bit(1, "photon_waits", "A leaf waits on s_axis_photons."),
                    CoreField::bit(2, "query_waits", "A query waits on s_axis_queries."),
                    CoreField::bit(3, "result_waits", "A result waits on m_axis_results."),
                ],
            ),
            (
                Self::Events,
                "events",
                Access::WriteOneToClear,
                0,
                "A bit for each event that occurred. Writing a 1 clears the bit.",
                events.clone(),
            ),
            (
                Self::InterruptEnable,
                "interrupt_enable",
                Access::ReadWrite,
                0,
                "The pin irq is 1 while a bit of both events and this register is.",
                events,
            ),
            (
                Self::StallLimit,
                "stall_limit",
                Access::ReadWrite,
                Leaf::SILENT_CLOCKS as u32,
                "Silent clocks after which the event stalled occurs; 0 for never.",
                vec![],
            ),
            (
                Self::UnderWay,
                "under_way",
                Access::Read,
                0,
                "Queries under way.",
                vec![],
            ),
        ];
        let fixed = fixed.into_iter().zip(0..);
        let fixed =
            fixed.map(
                |((register, name, access, reset, about, fields), place)| CoreRegisterRow {
                    register,
                    name: name.to_owned(),
                    address: 4 * place,
                    access,
                    about: about.to_owned(),
                    reset,
                    fields,
                },
            );
        let rounds = Rounds::of(core).map(|_| rounds(core));
        let rounds = rounds.into_iter().flatten();
        fixed.chain(counters()).chain(rounds).collect()
    }

    /// The bits of `InterruptEnable` and `Events`.
    pub fn all_events() -> u32 {
        EventRow::ALL.iter().map(|row| row.event.bit()).sum()
    }
}

/// Values side by side from bit 0 on, with the field of each.
fn packed(values: &[(u32, &'static str, u32, &'static str)]) -> (u32, Vec<CoreField>) {
    let (mut word, mut low, mut fields) = (0, 0, Vec::new());
    for &(value, name, width, about) in values {
        word |= value << low;
        fields.push(CoreField {
            name,
            low,
            width,
            about,
        });
        low += width;
    }
    (word, fields)
}

fn counters() -> impl Iterator<Item = CoreRegisterRow> {
    let low_bits = Core::REGISTER_BITS;
    CounterRow::ALL
        .iter()
        .zip(0..)
        .flat_map(move |(row, place)| {
            let address = CoreRegister::COUNTERS + 8 * place;
            let word = |register, half: &str, address, about| CoreRegisterRow {
                register,
                name: format!("{}_{half}", row.name),
                address,
                access: Access::Read,
                about,
                reset: 0,
                fields: Vec::new(),
            };
            [
                word(
                    CoreRegister::CounterLow(row.counter),
                    "low",
                    address,
                    format!(
                        "{} The low {low_bits} bits; a read holds the others for {}_high.",
                        row.about, row.name
                    ),
                ),
                word(
                    CoreRegister::CounterHigh(row.counter),
                    "high",
                    address + 4,
                    format!(
                        "The bits from {low_bits} on of the counter whose low word was read last."
                    ),
                ),
            ]
        })
}

/// The registers of the rounds.
fn rounds(core: &Core) -> impl Iterator<Item = CoreRegisterRow> {
    let widths = Widths::of(core.machine);
    let row = |(register, name, width, about): (CoreRegister, String, u32, &'static str)| {
        (
            register,
            name,
            about,
            CoreField {
                name: "value",
                low: 0,
                width,
                about,
            },
        )
    };
    let modes = [
        (
            CoreRegister::Nearest,
            "nearest".to_owned(),
            widths.count,
            "The number k of the photon whose distance is the radius of each query; 0 for none.",
        ),
        (
            CoreRegister::Rungs,
            "rungs".to_owned(),
            Rounds::RUNGS_BITS,
            "The rungs of the ladder that each query has a result for, where nearest is 0; 0 for none.",
        ),
    ];
    let rungs = (0..Rounds::RUNGS).map(move |rung| {
        (
            CoreRegister::Rung(rung),
            format!("rung_{rung}"),
            widths.radius_sq,
            "The squared radius of a rung, as radius_sq of a query; one above the largest of the format means the largest.",
        )
    });
    let rows = modes.into_iter().chain(rungs).map(row).zip(0..);
    rows.map(|((register, name, about, field), place)| CoreRegisterRow {
        register,
        name,
        address: CoreRegister::ROUNDS + 4 * place,
        access: Access::ReadWrite,
        about: about.to_owned(),
        reset: 0,
        fields: vec![field],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    #[test]
    fn each_register_has_an_address_of_its_own_within_the_map() {
        let machine = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
        let rows = CoreRegister::all(&Core::new(machine, 4).unwrap(), 5 << 32 | 6);
        for pair in rows.windows(2) {
            assert!(pair[0].address < pair[1].address, "{pair:?}");
        }
        let last = rows.last().unwrap();
        assert!(last.address < 1 << Core::ADDRESS_BITS, "{last:?}");
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        assert_eq!(of("digest_low").reset, 6);
        assert_eq!(of("digest_high").reset, 5);
        // Four chains of two engines and, in each bank, eight leaves of eight photons.
        assert_eq!(of("shape").reset, 4 | 2 << 8 | 8 << 16);
        assert_eq!(of("clocks_low").address, CoreRegister::COUNTERS);
    }

    #[test]
    fn a_core_whose_queries_have_radii_has_registers_for_its_rounds() {
        let machine = find_machine("leaf-5-radii-local7-rgb6d-n64").unwrap();
        let rows = CoreRegister::all(&Core::new(machine, 4).unwrap(), 0);
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        assert_eq!(of("nearest").address, CoreRegister::ROUNDS);
        assert_eq!(of("nearest").fields[0].width, 7, "64 photons");
        assert_eq!(of("rung_7").address, CoreRegister::ROUNDS + 4 * 9);
        assert_eq!(of("rung_7").fields[0].width, 14);
        for pair in rows.windows(2) {
            assert!(pair[0].address < pair[1].address, "{pair:?}");
        }
        assert!(rows.last().unwrap().address < 1 << Core::ADDRESS_BITS);
    }
}

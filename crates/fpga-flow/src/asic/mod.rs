//! Standard cells: the area, the clock and the energy of a design in the cells of a Liberty library.
//!
//! Yosys maps the registers, a pass divides the nets that have many readers among buffers, ABC maps and sizes the logic, and OpenSTA
//! computes delays and powers. There are no wires and there is no clock tree: a cell drives the pins of its readers alone. A
//! chip is larger, slower and takes more power than these figures say.
//!
//! A large memory stays outside of the cells, as a RAM: its bits are counted, and its area, its delays and its energy are not. Its ports are
//! ports of the netlist.

mod activity;
mod clock_parts;
mod fanout;
mod gating;
mod library;
mod ram;
mod timing;
mod wrong_cell;

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::area::Stat;
use crate::design::Design;
use crate::error::{Result, ensure, read, unexpected, write};
use crate::netlist::Netlist;
use crate::yosys::Yosys;

use self::ram::Rams;

pub use activity::{Activities, Toggles};
pub use library::Library;
pub use timing::Sta;
pub use wrong_cell::WrongCell;

/// The name of the clock of a design.
const CLOCK: &str = "clock";
/// The library in the folder of a design.
const LIBERTY: &str = "library.lib";
/// The mapped netlist, which [`measure`] leaves in the folder of a design. Its ports are single bits, since OpenSTA reads no
/// concatenations.
pub const NETLIST: &str = "mapped.v";
/// The mapped netlist with the ports of the design, as JSON. Cells and nets have the names that they have in the others.
const MAPPED: &str = "mapped.json";
/// The mapped netlist with an instance of the RAMs in place of their ports, as JSON.
const WITH_RAMS: &str = "mapped_with_rams.json";
/// The Verilog of the RAMs, where there are any.
const RAMS: &str = "rams.v";
/// The netlist with a register behind each input, and what OpenSTA is told of its pins.
const POWERED: &str = "powered.v";
const ACTIVITIES: &str = "activities.tcl";
/// The options with which Yosys writes cells alone.
const PLAIN: &str = "-noattr -noexpr -nohex -nodec";
/// What ABC takes from the library for the ends of a design.
const CONSTRAINTS: &str = "ends.constr";
/// The ABC script.
const SCRIPT: &str = "map.abc";

/// Yosys's own script for a library and a clock, but with ABC's newer mapper, which found 1 to 6 % shorter periods on two machines.
/// ABC divides the nets within the logic; [`fanout`] has divided those that come from registers and ports, which ABC leaves alone.
const MAPPING: &str = "strash; ifraig; scorr; dc2; dretime; strash; &get -n; &dch -f; &nf {D}; &put; buffer -c; topo; \
                       upsize {D}; dnsize {D}";
/// The clock period that ABC sizes for, in ps: shorter than any library reaches.
const TARGET_PS: u32 = 100;

/// The figures of a design in standard cells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CellFigures {
    /// The area of all cells, in the unit of the library: square micrometres.
    pub area: f64,
    /// The area of the registers.
    pub register_area: f64,
    /// The area, in NANDs with two inputs of the library.
    pub gate_equivalents: f64,
    /// The number of cells.
    pub cells: u64,
    /// The number of buffers that divide nets from registers and ports.
    pub fanout_buffers: u64,
    /// The number of clock gates.
    pub clock_gates: u64,
    /// The bits of the memories that stay outside of the cells, as RAMs.
    pub ram_bits: u64,
    /// The shortest clock period, in nanoseconds.
    pub period_ns: f64,
    /// The energy of a clock cycle in the registers, in picojoules.
    pub register_energy_pj: f64,
    /// The energy of a clock cycle in the other cells, in picojoules.
    pub logic_energy_pj: f64,
    /// The power of all cells at rest, in watts.
    pub leakage_w: f64,
}

impl CellFigures {
    /// The highest clock frequency, in MHz.
    #[must_use]
    pub fn fmax_mhz(&self) -> f64 {
        1e3 / self.period_ns
    }

    /// The energy of a clock cycle at the highest frequency, in picojoules: what switches, and what leaks meanwhile.
    #[must_use]
    pub fn cycle_energy_pj(&self) -> f64 {
        let leaked_pj = 1e3 * self.leakage_w * self.period_ns;
        self.register_energy_pj + self.logic_energy_pj + leaked_pj
    }

    /// The power at the highest frequency, in watts.
    #[must_use]
    pub fn power_w(&self) -> f64 {
        1e-3 * self.cycle_energy_pj() / self.period_ns
    }
}

/// How a design is mapped and measured.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Options {
    /// The transitions of each net in a clock cycle.
    pub activity: f64,
    /// Whether the registers of an enable get a clock gate, so that an edge of the clock reaches them only where it is 1. The energies of
    /// [`measure`] do not know of this: they take every register for enabled.
    pub clock_gating: bool,
}

/// Maps a design, whose files are in the folder (see [`Design::write`]), to the library's cells, and measures it.
///
/// # Errors
/// Yosys or OpenSTA fails, or the library lacks a kind of cell.
pub fn measure(
    yosys: &Yosys,
    sta: &Sta,
    folder: &Path,
    design: &Design,
    library: &Library,
    options: &Options,
) -> Result<CellFigures> {
    ensure(
        !options.clock_gating || library.clock_gate().is_some(),
        || {
            let library = library.name();
            format!(
                "found no clock gate in the library {library}, expected a cell with `clock_gating_integrated_cell`"
            )
        },
    )?;
    write(&folder.join(LIBERTY), &library.text())?;
    let (rams, fanout_buffers) = map(yosys, folder, design, library, options.clock_gating)?;
    let stat = Stat::parse(&read(&folder.join("stat.json"))?)?;
    let [area, register_area] = stat.areas()?;
    let times = sta.measure(folder, &design.top, library, options.activity)?;
    let gates = library
        .clock_gate_name()
        .and_then(|gate| stat.cells.get(gate));
    Ok(CellFigures {
        area,
        register_area,
        gate_equivalents: area / library.nand2_area(),
        cells: stat.cells.values().sum(),
        fanout_buffers,
        clock_gates: gates.copied().unwrap_or(0),
        ram_bits: rams.bits(),
        period_ns: times.period_ns,
        register_energy_pj: times.registers.cycle_energy_pj(),
        logic_energy_pj: times.logic.cycle_energy_pj(),
        leakage_w: times.registers.leakage_w + times.logic.leakage_w,
    })
}

/// The figures of a design that [`measure`] has measured in the folder, but with the energies at the activities of a simulation of
/// [`simulatable`]; and the mean transitions of a net, without the clock, in a clock cycle.
///
/// # Errors
/// Nothing was measured in the folder, the simulation lacks a net, or Yosys or OpenSTA fails.
pub fn measure_simulated(
    yosys: &Yosys,
    sta: &Sta,
    folder: &Path,
    measured: (&Design, &CellFigures),
    library: &Library,
    activities: &Activities,
) -> Result<(CellFigures, f64)> {
    let (design, figures) = measured;
    let mapped = Netlist::parse(&read(&folder.join(MAPPED))?)?;
    let told = activity::told(mapped, &design.top, library, activities)?;
    write(&folder.join("powered.json"), &told.netlist.to_string())?;
    write(&folder.join(ACTIVITIES), &told.script)?;
    let script = format!(
        "read_json powered.json; hierarchy -top {}; splitnets -ports; \
         opt_clean -purge; write_verilog {PLAIN} {POWERED}",
        design.top
    );
    yosys.run(folder, &script)?;
    let [registers, logic] = sta.powers(folder, &design.top, told.gated.as_deref())?;
    let figures = CellFigures {
        register_energy_pj: registers.cycle_energy_pj(),
        logic_energy_pj: logic.cycle_energy_pj(),
        ..figures.clone()
    };
    Ok((figures, told.mean))
}

/// A mapped netlist, to be simulated.
#[derive(Clone, Debug)]
pub struct Simulatable {
    /// The Verilog of the netlist and of its RAMs, with a buffer before each part of the clock and with models of the library's cells by
    /// Yosys. Registers are 0 at power-up, as the registers of the design are at their initial values; real cells are so only after a
    /// reset.
    pub text: String,
    /// The netlist with a planted fault, which a comparison must find.
    pub control: WrongCell,
    /// [`Netlist::sha256`] of the netlist.
    pub netlist_sha256: String,
}

/// The netlist that [`measure`] left in the folder.
///
/// # Errors
/// Nothing was measured in the folder, Yosys fails, or the netlist has no place for a fault.
pub fn simulatable(
    yosys: &Yosys,
    folder: &Path,
    design: &Design,
    library: &Library,
) -> Result<Simulatable> {
    let mut netlist = Netlist::parse(&read(&folder.join(WITH_RAMS))?)?;
    clock_parts::divide(&mut netlist, &design.top)?;
    write(&folder.join("simulated.json"), &netlist.to_string())?;
    let script = format!(
        "read_json simulated.json; write_verilog {PLAIN} simulated.v; design -reset; \
         read_liberty -ignore_miss_func {LIBERTY}; select */t:$_DFF_* %co:+[Q] */w:* %i; setattr -set init 1'0 %; \
         select -clear; write_verilog -noattr models.v"
    );
    yosys.run(folder, &script)?;
    let [netlist, models] = ["simulated.v", "models.v"].map(|file| read(&folder.join(file)));
    let mut text = netlist? + &models? + clock_parts::MODULE;
    let rams = folder.join(RAMS);
    if rams.exists() {
        text += &read(&rams)?;
    }
    let mapped = Netlist::parse(&read(&folder.join(MAPPED))?)?;
    if let Some(gate) = library.clock_gate() {
        text += &gate.model(&mapped.json()["modules"][&gate.cell]);
    }
    Ok(Simulatable {
        control: wrong_cell::plant(&mapped, &design.top, library, &text)?,
        netlist_sha256: mapped.sha256()?,
        text,
    })
}

/// Maps the design and writes its netlist. Returns the RAMs, and the number of buffers behind registers and ports.
fn map(
    yosys: &Yosys,
    folder: &Path,
    design: &Design,
    library: &Library,
    clock_gating: bool,
) -> Result<(Rams, u64)> {
    let top = &design.top;
    write(&folder.join(SCRIPT), &format!("{MAPPING}\n"))?;
    let ends = format!("set_driving_cell {}\n", library.register().cell.cell);
    write(&folder.join(CONSTRAINTS), &ends)?;
    let words = format!(
        "read_liberty -lib -ignore_miss_func {LIBERTY}; {}; synth -flatten -top {top} -run begin:fine",
        design.read_commands("any")
    );
    yosys.run(folder, &format!("{words}; write_json words.json"))?;
    let rams = Rams::of(&Netlist::parse(&read(&folder.join("words.json"))?)?, top)?;
    let gates = match clock_gating {
        true => gating::script(LIBERTY) + "; ",
        false => String::new(),
    };
    // The words are made again: where Yosys reads them from a file instead, ABC makes other logic of them.
    let registers = format!(
        "{words}; {}synth -run fine:; delete t:$scopeinfo; \
         {gates}dfflegalize -cell $_DFF_P_ 0 ; opt_clean; dfflibmap -liberty {LIBERTY}; \
         abc -g AND,NAND,OR,NOR,XOR,XNOR,MUX; opt_clean -purge; write_json gates.json",
        rams.cut_out(top, RAMS)
    );
    yosys.run(folder, &registers)?;
    let mut netlist = Netlist::parse(&read(&folder.join("gates.json"))?)?;
    let buffers = fanout::divide(&mut netlist, top, library)?;
    write(&folder.join("divided.json"), &netlist.to_string())?;
    let logic = format!(
        "read_json divided.json; hierarchy -top {top}; \
         abc -liberty {LIBERTY} -constr {CONSTRAINTS} -D {TARGET_PS} -script {SCRIPT}; setundef -zero; splitnets; \
         opt_clean -purge; rename -hide w:*; rename -enumerate; write_json {WITH_RAMS}; \
         {}write_json {MAPPED}; splitnets -ports; opt_clean -purge; \
         tee -q -o stat.json stat -liberty {LIBERTY} -json; write_verilog {PLAIN} {NETLIST}",
        rams.expose(top)
    );
    yosys.run(folder, &logic)?;
    Ok((rams, buffers))
}

impl Stat {
    /// The area of the design and of its registers.
    fn areas(&self) -> Result<[f64; 2]> {
        let found = self.area.zip(self.register_area);
        let found = found.map(|(area, registers)| [area, registers]);
        found.ok_or_else(|| unexpected("found no area in what Yosys's `stat -liberty` wrote"))
    }
}

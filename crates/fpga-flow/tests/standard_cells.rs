//! A design in the cells of a small library, whose figures can be computed by hand. Yosys is that of `scripts/setup.sh --where`, or
//! one on the PATH; OpenSTA is on the PATH.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use fpga_flow::asic::{
    Activities, CellFigures, Library, NETLIST, Options, Sta, Toggles, measure, measure_simulated,
    simulatable,
};
use fpga_flow::{Design, Netlist};

mod tools;

/// The delay of each cell in ns, and of a register from its clock.
const DELAY_NS: f64 = 0.1;
/// The setup time of a register in ns.
const SETUP_NS: f64 = 0.05;
/// The energy of a cell at each transition of its output.
const ENERGY_PJ: f64 = 2.0;
/// The energy of a register at each transition of the clock.
const CLOCK_ENERGY_PJ: f64 = 0.5;
/// The energy of a register at each transition of its output.
const OUTPUT_ENERGY_PJ: f64 = 0.25;
/// The energy of a clock gate at each transition of the clock.
const GATE_ENERGY_PJ: f64 = 0.75;
/// The energy of a transition in each pin that reads it: half the capacitance of 0.001 pF, at 1 V.
const PIN_ENERGY_PJ: f64 = 0.0005;
/// The power at rest of each cell in W.
const LEAKAGE_W: f64 = 3e-9;

/// A table of one constant, by a template of the library.
fn table((template, value): (&str, f64)) -> String {
    format!("({template}) {{ values(\"{value}, {value}\", \"{value}, {value}\"); }}")
}

/// A cell of one output. The tables are of constants: neither slope nor load counts.
fn cell(name: &str, area: u32, inputs: &[&str], function: &str) -> String {
    let arcs = inputs.iter().map(|input| {
        let [delay, slope, energy] = [("delay", DELAY_NS), ("delay", 0.01), ("energy", ENERGY_PJ)].map(table);
        format!(
            "timing() {{ related_pin : \"{input}\"; timing_sense : {sense}; \
             cell_rise{delay} cell_fall{delay} rise_transition{slope} fall_transition{slope} }}
             internal_power() {{ related_pin : \"{input}\"; rise_power{energy} fall_power{energy} }}",
            sense = if function.starts_with('!') { "negative_unate" } else { "positive_unate" },
        )
    });
    let pins = inputs
        .iter()
        .map(|input| format!("pin({input}) {{ direction : input; capacitance : 0.001; }}"));
    format!(
        "cell({name}) {{ area : {area}; cell_leakage_power : 3; {} pin(Y) {{ direction : output; function : \"{function}\"; {} }} }}\n",
        pins.collect::<String>(),
        arcs.collect::<String>()
    )
}

fn register() -> String {
    let [delay, slope, setup, hold, energy, output] = [
        ("delay", DELAY_NS),
        ("delay", 0.01),
        ("limit", SETUP_NS),
        ("limit", 0.0),
        ("energy", CLOCK_ENERGY_PJ),
        ("energy", OUTPUT_ENERGY_PJ),
    ]
    .map(table);
    format!(
        "cell(REG) {{ area : 20; cell_leakage_power : 3; ff(IQ, IQN) {{ clocked_on : \"CK\"; next_state : \"D\"; }}
           pin(CK) {{ direction : input; clock : true; capacitance : 0.001;
             internal_power() {{ rise_power{energy} fall_power{energy} }} }}
           pin(D) {{ direction : input; capacitance : 0.001;
             timing() {{ related_pin : \"CK\"; timing_type : setup_rising; rise_constraint{setup} fall_constraint{setup} }}
             timing() {{ related_pin : \"CK\"; timing_type : hold_rising; rise_constraint{hold} fall_constraint{hold} }} }}
           pin(Q) {{ direction : output; function : \"IQ\";
             internal_power() {{ related_pin : \"CK\"; rise_power{output} fall_power{output} }}
             timing() {{ related_pin : \"CK\"; timing_type : rising_edge;
               cell_rise{delay} cell_fall{delay} rise_transition{slope} fall_transition{slope} }} }} }}\n"
    )
}

fn liberty() -> String {
    let cells = [
        cell("INV", 3, &["A"], "!A"),
        cell("NAND", 4, &["A", "B"], "!(A&B)"),
        cell("BUF", 6, &["A"], "A"),
        cell("LARGE", 60, &["A"], "A"),
        register(),
    ];
    format!(
        "library (small) {{ delay_model : table_lookup; time_unit : \"1ns\"; voltage_unit : \"1V\"; current_unit : \"1mA\";
           leakage_power_unit : \"1nW\"; capacitive_load_unit(1, pf); pulling_resistance_unit : \"1kohm\";
           nom_process : 1; nom_voltage : 1.0; nom_temperature : 25;
           operating_conditions(typical) {{ process : 1; voltage : 1.0; temperature : 25; }}
           default_operating_conditions : typical;
           input_threshold_pct_rise : 50; input_threshold_pct_fall : 50; output_threshold_pct_rise : 50;
           output_threshold_pct_fall : 50; slew_lower_threshold_pct_rise : 20; slew_lower_threshold_pct_fall : 20;
           slew_upper_threshold_pct_rise : 80; slew_upper_threshold_pct_fall : 80;
           lu_table_template(delay) {{ variable_1 : input_net_transition; variable_2 : total_output_net_capacitance; {index} }}
           power_lut_template(energy) {{ variable_1 : input_transition_time; variable_2 : total_output_net_capacitance; {index} }}
           lu_table_template(limit) {{ variable_1 : related_pin_transition; variable_2 : constrained_pin_transition; {index} }}
           {} }}\n",
        cells.concat(),
        index = "index_1(\"0.01, 1.0\"); index_2(\"0.001, 1.0\");",
    )
}

/// One register that 30 others read, each through a NAND.
const DESIGN: &str = "
module toy(input clock, input d, input [29:0] mask, output reg [29:0] q);
  reg common;
  always @(posedge clock) begin
    common <= d;
    q <= ~({30{common}} & mask);
  end
endmodule
";

fn measured(activity: f64) -> CellFigures {
    in_folder(activity, |_, _| None).0
}

/// The figures of the design, and those at the activities of the mapped netlist in the folder, with the mean transitions of a net.
fn in_folder(
    activity: f64,
    activities: impl FnOnce(&Path, &Design) -> Option<Activities>,
) -> (CellFigures, Option<(CellFigures, f64)>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("small.lib");
    fs::write(&path, liberty()).unwrap();
    let yosys = tools::yosys();
    let library = Library::read(&yosys, folder.path(), &path).unwrap();
    assert_eq!((library.name(), library.nand2_area()), ("small", 4.0));
    let design = Design {
        top: "toy".to_owned(),
        verilog: DESIGN.to_owned(),
        ..Design::default()
    };
    design.write(folder.path()).unwrap();
    let sta = Sta::find(folder.path()).unwrap();
    let options = Options {
        activity,
        clock_gating: false,
    };
    let figures = measure(&yosys, &sta, folder.path(), &design, &library, &options).unwrap();
    let simulated = activities(folder.path(), &design).map(|activities| {
        let measured = (&design, &figures);
        measure_simulated(&yosys, &sta, folder.path(), measured, &library, &activities).unwrap()
    });
    (figures, simulated)
}

/// What a simulation of 1000 cycles counts on the toy where `d` changes in 400 of them, and the lowest `open` bits of `mask` are 1.
fn toggled(folder: &Path, design: &Design, open: usize) -> Activities {
    let netlist = Netlist::parse(&fs::read_to_string(folder.join("mapped.json")).unwrap()).unwrap();
    let module = &netlist.json()["modules"][&design.top];
    let toggles = |transitions, ones| Toggles { transitions, ones };
    let (changes, zero, one) = (toggles(400, 500), toggles(0, 0), toggles(0, 1000));
    let bit_of = |name: &str, index: usize| module["ports"][name]["bits"][index].as_u64().unwrap();
    let mut bits = BTreeMap::from([(bit_of("clock", 0), zero), (bit_of("d", 0), changes)]);
    bits.extend(
        (0..30).map(|index| (bit_of("mask", index), if index < open { one } else { zero })),
    );
    let cells = netlist.cells().unwrap();
    // Cells follow each other: a register, a buffer, a NAND, a register.
    for _ in 0..4 {
        for cell in cells.values() {
            let of = |pin: &str| cell["connections"][pin][0].as_u64();
            let is = |pin: &str| of(pin).and_then(|bit| bits.get(&bit).copied());
            let (output, found) = match cell["type"].as_str().unwrap() {
                "REG" => (of("Q"), is("D")),
                "BUF" => (of("Y"), is("A")),
                "NAND" => match (is("A"), is("B")) {
                    (Some(a), Some(b)) if a == zero || b == zero => (of("Y"), Some(one)),
                    (Some(a), Some(_)) if a == changes => (of("Y"), is("A")),
                    (Some(_), b) => (of("Y"), b),
                    _ => continue,
                },
                other => panic!("{other}"),
            };
            bits.extend(output.zip(found));
        }
    }
    let nets = module["netnames"]
        .as_object()
        .unwrap()
        .iter()
        .map(|(name, net)| {
            let of = net["bits"].as_array().unwrap().iter();
            let of = of.map(|bit| bits[&bit.as_u64().unwrap()]);
            (name.clone(), of.collect())
        });
    Activities {
        clocks: 1000,
        nets: nets.collect(),
    }
}

/// Pins that do not change take no energy, and those that do take it at each transition.
#[test]
#[ignore = "needs Yosys and OpenSTA: scripts/setup.sh --asic installs them"]
fn the_energy_of_each_cell_is_that_of_its_own_transitions() {
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-5;
    for open in [0, 15, 30] {
        let (assumed, simulated) =
            in_folder(0.2, |folder, design| Some(toggled(folder, design, open)));
        let (figures, mean) = simulated.unwrap();
        // The three buffers change, and so do the NANDs with an open mask. The buffers have 30 readers, such a NAND has one.
        let open = open as f64;
        let logic = (3.0 + open) * ENERGY_PJ + (30.0 + open) * PIN_ENERGY_PJ;
        assert!(
            near(figures.logic_energy_pj, 0.4 * logic),
            "{open}: {figures:?}"
        );
        // The clock's energy, and that of the three pins on the common register; not that of the registers behind the 31 inputs.
        let registers = 31.0 * 2.0 * CLOCK_ENERGY_PJ
            + 0.4 * (3.0 * PIN_ENERGY_PJ + (1.0 + open) * OUTPUT_ENERGY_PJ);
        assert!(
            near(figures.register_energy_pj, registers),
            "{open}: {figures:?}"
        );
        assert_eq!(figures.area, assumed.area);
        // Of 95 nets change: d, the common register, its buffers, and of each open bit the NAND and the register.
        assert!(
            near(mean, 0.4 * (5.0 + 2.0 * open) / 95.0),
            "{open}: {mean}"
        );
    }
}

#[test]
#[ignore = "needs Yosys and OpenSTA: scripts/setup.sh --asic installs them"]
fn the_figures_are_those_computed_by_hand() {
    let figures = measured(0.2);
    // 31 registers, 30 NANDs, and 3 buffers, as a net has at most 12 readers. The large buffer is too large to divide nets.
    assert_eq!((figures.cells, figures.fanout_buffers), (64, 3));
    assert_eq!(figures.area, 31.0 * 20.0 + 30.0 * 4.0 + 3.0 * 6.0);
    assert_eq!(figures.register_area, 31.0 * 20.0);
    assert_eq!(figures.gate_equivalents, figures.area / 4.0);
    // From the common register through a buffer and a NAND.
    let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-5;
    assert!(
        close(figures.period_ns, 3.0 * DELAY_NS + SETUP_NS),
        "{figures:?}"
    );
    assert!(close(figures.leakage_w, 64.0 * LEAKAGE_W), "{figures:?}");
    // What the nets take is PIN_ENERGY_PJ, less than a thousandth of the cells' energies.
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-3;
    assert!(
        near(figures.logic_energy_pj, 33.0 * 0.2 * ENERGY_PJ),
        "{figures:?}"
    );
    assert!(
        near(
            figures.register_energy_pj,
            31.0 * (2.0 * CLOCK_ENERGY_PJ + 0.2 * OUTPUT_ENERGY_PJ)
        ),
        "{figures:?}"
    );
}

#[test]
#[ignore = "needs Yosys and OpenSTA: scripts/setup.sh --asic installs them"]
fn the_energy_is_in_proportion_to_the_activity() {
    let [one, two] = [0.1, 0.2].map(measured);
    assert!(
        (two.logic_energy_pj / one.logic_energy_pj - 2.0).abs() < 1e-5,
        "{one:?} {two:?}"
    );
}

/// A clock gate of a latch and an AND.
fn gate() -> String {
    let [limit, energy, delay, slope] = [
        ("limit", SETUP_NS),
        ("energy", GATE_ENERGY_PJ),
        ("delay", DELAY_NS),
        ("delay", 0.01),
    ]
    .map(table);
    format!(
        "cell(GATE) {{ area : 30; cell_leakage_power : 3; clock_gating_integrated_cell : \"latch_posedge\";
           statetable(\"CK E\", \"ENL\") {{ table : \"L L : - : L, L H : - : H, H - : - : N\"; }}
           pin(ENL) {{ direction : internal; internal_node : \"ENL\"; }}
           pin(CK) {{ direction : input; clock : true; clock_gate_clock_pin : true; capacitance : 0.001;
             internal_power() {{ rise_power{energy} fall_power{energy} }} }}
           pin(E) {{ direction : input; clock_gate_enable_pin : true; capacitance : 0.001;
             timing() {{ related_pin : \"CK\"; timing_type : setup_rising; rise_constraint{limit} fall_constraint{limit} }} }}
           pin(GCK) {{ direction : output; clock_gate_out_pin : true; state_function : \"CK & ENL\";
             timing() {{ related_pin : \"CK\"; timing_sense : positive_unate;
               cell_rise{delay} cell_fall{delay} rise_transition{slope} fall_transition{slope} }} }} }}\n"
    )
}

/// Eight registers with an enable from a register.
const WITH_ENABLE: &str = "
module toy(input clock, input e, input [7:0] d, output reg [7:0] q);
  reg enable;
  always @(posedge clock) begin
    enable <= e;
    if (enable) q <= d;
  end
endmodule
";

/// The registers behind a clock gate take the energy of the clock edges that it passes, and that of their outputs.
#[test]
#[ignore = "needs Yosys and OpenSTA: scripts/setup.sh --asic installs them"]
fn registers_behind_a_clock_gate_take_the_energy_of_the_edges_that_pass() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("small.lib");
    let (yosys, sta) = (tools::yosys(), Sta::find(folder.path()).unwrap());
    let options = Options {
        activity: 0.2,
        clock_gating: true,
    };
    let design = Design {
        top: "toy".to_owned(),
        verilog: WITH_ENABLE.to_owned(),
        ..Design::default()
    };
    design.write(folder.path()).unwrap();
    let library = |text: String| {
        fs::write(&path, text).unwrap();
        Library::read(&yosys, folder.path(), &path).unwrap()
    };
    let without = library(liberty());
    let error = measure(&yosys, &sta, folder.path(), &design, &without, &options).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("no clock gate in the library small"),
        "{error}"
    );

    let with = library(liberty().replace("cell(REG)", &(gate() + "cell(REG)")));
    assert_eq!(with.clock_gate_name(), Some("GATE"));
    let figures = measure(&yosys, &sta, folder.path(), &design, &with, &options).unwrap();
    assert_eq!((figures.clock_gates, figures.cells), (1, 10));
    assert_eq!(figures.area, 9.0 * 20.0 + 30.0);
    let model = simulatable(&yosys, folder.path(), &design, &with);
    // The design has no gate that the control could make wrong.
    assert!(
        model
            .unwrap_err()
            .to_string()
            .contains("no gate before the register")
    );

    // Every bit changes in 0.4 of the cycles; the enable is 1 in `enabled` of 1000.
    for enabled in [1000, 500, 100] {
        let netlist =
            Netlist::parse(&fs::read_to_string(folder.path().join("mapped.json")).unwrap())
                .unwrap();
        let module = &netlist.json()["modules"]["toy"];
        let toggles = Toggles {
            transitions: 400,
            ones: enabled,
        };
        let nets = module["netnames"].as_object().unwrap().iter();
        let nets = nets.map(|(name, net)| {
            (
                name.clone(),
                vec![toggles; net["bits"].as_array().unwrap().len()],
            )
        });
        let activities = Activities {
            clocks: 1000,
            nets: nets.collect(),
        };
        let measured = (&design, &figures);
        let simulated =
            measure_simulated(&yosys, &sta, folder.path(), measured, &with, &activities);
        let (simulated, _) = simulated.unwrap();
        // One register has every edge, and drives the gate's pin.
        let edges = 2.0 + 8.0 * 2.0 * enabled as f64 / 1000.0;
        let registers = edges * CLOCK_ENERGY_PJ + 0.4 * (9.0 * OUTPUT_ENERGY_PJ + PIN_ENERGY_PJ);
        assert!(
            (simulated.register_energy_pj / registers - 1.0).abs() < 1e-5,
            "{registers}: {simulated:?}"
        );
        // The gate has every edge, the eight pins that it drives those that pass.
        let logic = 2.0 * GATE_ENERGY_PJ + (edges - 2.0) * PIN_ENERGY_PJ;
        assert!(
            (simulated.logic_energy_pj / logic - 1.0).abs() < 1e-5,
            "{simulated:?}"
        );
    }
}

/// A memory of words of 64 bits, and the inverse of what is read from it.
fn with_memory(words: u32) -> Design {
    let verilog = format!(
        "module toy(input clock, input write, input [{place}:0] place, input [63:0] d, output reg [63:0] q);
           reg [63:0] words [0:{last}];
           reg [63:0] word;
           always @(posedge clock) begin
             if (write) words[place] <= d;
             word <= words[place];
             q <= ~word;
           end
         endmodule",
        place = words.ilog2() - 1,
        last = words - 1,
    );
    Design {
        top: "toy".to_owned(),
        verilog,
        ..Design::default()
    }
}

/// The bits of a large memory are counted, a small one becomes registers.
#[test]
#[ignore = "needs Yosys and OpenSTA: scripts/setup.sh --asic installs them"]
fn a_large_memory_stays_outside_of_the_cells() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("small.lib"), liberty()).unwrap();
    let (yosys, sta) = (tools::yosys(), Sta::find(path).unwrap());
    let library = Library::read(&yosys, path, &path.join("small.lib")).unwrap();
    let measured = |words| {
        let design = with_memory(words);
        design.write(path).unwrap();
        let options = Options {
            activity: 0.2,
            clock_gating: false,
        };
        measure(&yosys, &sta, path, &design, &library, &options).unwrap()
    };
    let small = measured(2);
    // The two words, `word` and `q`.
    assert_eq!(
        (small.ram_bits, small.register_area),
        (0, 4.0 * 64.0 * 20.0)
    );

    let large = measured(64);
    assert_eq!(large.ram_bits, 4096);
    // `word` is the output register of the RAM, whose delay is not counted. From it an inverter leads to `q`.
    assert_eq!(large.register_area, 64.0 * 20.0);
    assert_eq!(large.area, 64.0 * 20.0 + 64.0 * 3.0);
    let period = DELAY_NS + SETUP_NS;
    assert!((large.period_ns / period - 1.0).abs() < 1e-5, "{large:?}");

    // The netlist that is measured has the RAM's pins, that which is simulated has the RAM.
    let netlist = fs::read_to_string(path.join(NETLIST)).unwrap();
    assert!(!netlist.contains("toy_rams toy_rams"), "{netlist}");
    let pins = netlist.matches("\n  input \\toy_rams.").count();
    assert_eq!(pins, 64, "the word that is read");
    let simulated = simulatable(&yosys, path, &with_memory(64), &library).unwrap();
    for text in [&simulated.text, &simulated.control.text] {
        assert!(text.contains("toy_rams toy_rams"), "{text}");
        assert!(text.contains("module toy_rams(") && text.contains("[63:0] words [63:0]"));
    }
}

/// A file that is no library, or lacks a cell, is named with what is missing.
#[test]
#[ignore = "needs Yosys: scripts/setup.sh installs it"]
fn what_a_library_lacks_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("small.lib");
    let read = |text: &str| {
        fs::write(&path, text).unwrap();
        let error = Library::read(&tools::yosys(), folder.path(), Path::new(&path));
        error.unwrap_err().to_string()
    };
    let error = read("module top(); endmodule");
    assert!(
        error.contains("no `library (NAME)`") && error.contains("small.lib"),
        "{error}"
    );
    let error = read(&liberty().replace("cell(BUF) { area : 6", "cell(BUF) { area : 9"));
    assert!(error.contains("no buffer"), "{error}");
}

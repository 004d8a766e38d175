use super::*;
use crate::devices::ecp5::PATH;

/// nextpnr 0.11's report of a machine, without redundant steps and keys.
const REPORT: &str = r#"{
"critical_paths": [
{"from": "<async>", "to": "posedge $glbnet$clock$TRELLIS_IO_IN", "path": []},
{"from": "posedge $glbnet$clock$TRELLIS_IO_IN", "to": "posedge $glbnet$clock$TRELLIS_IO_IN", "path": [
  {"type": "clk-to-q", "delay": 0.395, "from": {"cell": "machine.cell_5.square_unit_a_TRELLIS_FF_Q", "loc": [5, 13], "port": "Q"},
   "to": {"cell": "machine.cell_5.square_unit_a_TRELLIS_FF_Q", "loc": [5, 13], "port": "Q"}},
  {"type": "routing", "delay": 1.065, "net": "machine.cell_5.square_unit_a[0]", "sources": [],
   "from": {"cell": "machine.cell_5.square_unit_a_TRELLIS_FF_Q", "port": "Q"},
   "to": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB0", "port": "A"}},
  {"type": "logic", "delay": 0.355,
   "from": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB0", "port": "A"},
   "to": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB0", "port": "FCO"}},
  {"type": "routing", "delay": 0, "net": "between",
   "from": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB0", "port": "FCO"},
   "to": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB1", "port": "FCI"}},
  {"type": "logic", "delay": 0,
   "from": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB1", "port": "FCI"},
   "to": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_S1$CCU2_COMB1", "port": "FCO"}},
  {"type": "logic", "delay": 0.328,
   "from": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_COUT_S0$CCU2_COMB0", "port": "FCI"},
   "to": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_COUT_S0$CCU2_COMB0", "port": "F"}},
  {"type": "routing", "delay": 0.847, "net": "n",
   "from": {"cell": "machine.sum_7_TRELLIS_FF_Q_DI_LUT4_Z_C_CCU2C_COUT_S0$CCU2_COMB0", "port": "F"},
   "to": {"cell": "machine.sum_7_CCU2C_S1$CCU2_COMB1", "port": "A"}},
  {"type": "logic", "delay": 0.355,
   "from": {"cell": "machine.sum_7_CCU2C_S1$CCU2_COMB1", "port": "A"},
   "to": {"cell": "machine.sum_7_CCU2C_S1$CCU2_COMB1", "port": "F"}},
  {"type": "routing", "delay": 0.557, "net": "n",
   "from": {"cell": "machine.sum_7_CCU2C_S1$CCU2_COMB1", "port": "F"},
   "to": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_ALUT_LUT4_Z", "port": "D"}},
  {"type": "logic", "delay": 0.18,
   "from": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_ALUT_LUT4_Z", "port": "D"},
   "to": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_ALUT_LUT4_Z", "port": "F"}},
  {"type": "logic", "delay": 0.1,
   "from": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_BLUT_LUT4_Z", "port": "F1"},
   "to": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_BLUT_LUT4_Z", "port": "OFX"}},
  {"type": "routing", "delay": 0.118, "net": "n",
   "from": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16_DI_PFUMX_Z_BLUT_LUT4_Z", "port": "OFX"},
   "to": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16", "port": "DI"}},
  {"type": "setup", "delay": 0,
   "from": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16", "port": "DI"},
   "to": {"cell": "machine.cell_7.add_unit.a_TRELLIS_FF_Q_16", "port": "DI"}}
]}],
"fmax": {"$glbnet$clock$TRELLIS_IO_IN": {"achieved": 95.38343811035156, "constraint": 400}},
"utilization": {"ALU54B": {"available": 78, "used": 0}}
}"#;

#[test]
fn the_path_is_told_in_a_few_facts() {
    let (fmax_mhz, path) = parse(REPORT, &PATH).unwrap();
    assert_eq!(fmax_mhz, 95.38);
    let expected = CriticalPath {
        from: "cell_5.square_unit_a".to_owned(),
        to: "cell_7.add_unit.a".to_owned(),
        logic_ns: 1.71,
        routing_ns: 2.59,
        longest_net_ns: 1.06,
        carry_chains: 2,
        carry_cells: 3,
        lut_levels: 1,
        dsp_levels: 0,
        binds: Binding::CarryChains,
    };
    // The sum of 1.7130 and 2.5870 ns is not near a rounding limit; the net's time is.
    assert!((path.longest_net_ns - 1.065).abs() < 0.006);
    let longest_net_ns = expected.longest_net_ns;
    assert_eq!(
        CriticalPath {
            longest_net_ns,
            ..path
        },
        expected
    );
}

#[test]
fn one_net_binds_where_it_takes_more_than_all_else() {
    let (_, path) = parse(&REPORT.replace("0.118", "5.0"), &PATH).unwrap();
    assert_eq!(path.binds, Binding::OneNet);
    assert_eq!(path.longest_net_ns, 5.0);
}

#[test]
fn blocks_are_told_by_the_last_kind_in_a_name() {
    let step = |cell: &str, kind: &str| {
        let pin = |port: &str| Pin {
            cell: cell.to_owned(),
            port: port.to_owned(),
        };
        let (kind, delay) = (kind.to_owned(), 1.0);
        let (from, to) = (pin("A0"), pin("P0"));
        Step {
            kind,
            delay,
            from,
            to,
        }
        .part(&PATH)
    };
    for (cell, kind, part) in [
        (
            "machine.cell_3.product_MULT18X18D_P0",
            "logic",
            Binding::DspBlocks,
        ),
        (
            "machine.cell_3.product_MULT18X18D_A0_LUT4_Z",
            "logic",
            Binding::Luts,
        ),
        ("machine.store_DP16KD_DOA0", "clk-to-q", Binding::Memories),
        (
            "machine.store_TRELLIS_DPR16X4_DO",
            "logic",
            Binding::Memories,
        ),
        ("machine.sum_TRELLIS_FF_Q", "setup", Binding::Registers),
        ("$nextpnr_something", "logic", Binding::Luts),
    ] {
        assert_eq!(step(cell, kind), part, "{cell}");
    }
    assert_eq!(register("machine.store_DP16KD_DOA0", &PATH), "store");
    assert_eq!(register("driven_TRELLIS_FF_Q_12", &PATH), "driven");
    assert_eq!(register("serial_out", &PATH), "serial_out");
}

#[test]
fn a_report_without_its_path_or_with_two_clocks_is_refused() {
    let error = |report: &str| format!("{:#}", parse(report, &PATH).unwrap_err());
    let other = REPORT.replace(r#""to": "posedge $glb"#, r#""to": "posedge other$glb"#);
    assert!(error(&other).contains("no critical path"));
    let clocks = REPORT.replace(r#""fmax": {"#, r#""fmax": {"second": {"achieved": 1.0}, "#);
    assert!(error(&clocks).contains("expected one"));
    assert!(error("{}").contains("nextpnr"));
}

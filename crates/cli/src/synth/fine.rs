//! The table of docs/machines.md that has tiles with a fine pipeline, placed and routed.

use fpga_flow::Figure;
use photoncube_spec::{Spatial, find_machine};

use super::Subject;
use super::clock::clocks;
use super::measurements::Measurements;
use crate::chains::DEVICE;
use crate::table::{self, grouped};

/// What `photoncube synth --json` printed; `scripts/measure.sh --place-chains` writes the files.
const MEASURED: [&str; 1] = [include_str!(
    "../../../../docs/measured/tile-10-fine-local7-mono1-n8192.json"
)];

fn row(measured: &Measurements) -> Vec<String> {
    let machine = find_machine(&measured.machines[0].machine).unwrap();
    let engines = machine.spatial().unwrap().engines();
    let figures = &measured.areas[0].figures;
    let part = |figure, of: u64| {
        let percent = 100.0 * figures[&figure] as f64 / of as f64;
        format!("{} ({percent:.0} %)", grouped(figures[&figure]))
    };
    let clock = &clocks(&measured.placements)[0];
    let of_seeds = [clock.fmax_mhz, clock.fmax_mhz_low, clock.fmax_mhz_high];
    let tests = of_seeds.map(|mhz| (Spatial::LANES * engines) as f64 * mhz / 1e3);
    let text = |[median, low, high]: [f64; 3]| format!("{median:.1} ({low:.1} to {high:.1})");
    vec![
        machine.name.to_owned(),
        part(Figure::Lut4Equivalents, DEVICE.lut4_equivalents),
        part(Figure::Ff, DEVICE.ff),
        clock.seeds.to_string(),
        text(of_seeds),
        text(tests),
    ]
}

#[test]
fn the_page_of_machines_has_the_fine_tiles() {
    let page = include_str!("../../../../docs/machines.md");
    let header = [
        "machine",
        "LUT equivalents",
        "flip-flops",
        "seeds",
        "MHz",
        "G tests/s",
    ];
    let measured = MEASURED.map(|text| serde_json::from_str::<Measurements>(text).unwrap());
    let table = table::markdown(&header, &measured.each_ref().map(row));
    assert!(
        page.contains(&table),
        "docs/machines.md should have this table:\n{table}"
    );
    // A clock of another text would be that of another machine.
    for measured in measured {
        let text = &measured.machines[0];
        let subject = Subject::of(find_machine(&text.machine).unwrap()).unwrap();
        assert_eq!(
            subject.verilog_sha256, text.verilog_sha256,
            "{}",
            text.machine
        );
    }
}

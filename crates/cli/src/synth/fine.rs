//! The table of docs/machines.md that has tiles with a fine pipeline, placed and routed.

use fpga_flow::Figure;
use photoncube_spec::{Spatial, find_machine};

use super::Subject;
use super::clock::clocks;
use super::measurements::{Measurements, part};
use crate::chains::DEVICE;
use crate::table;

/// What `photoncube synth --json` printed; `scripts/measure.sh --place-chains` writes the files.
const MEASURED: [&str; 1] = [include_str!(
    "../../../../docs/measured/tile-10-fine-local7-mono1-n8192.json"
)];

/// Photon tests per second, in billions: the median of the seeds, the lowest and the highest.
fn tests_per_second(measured: &Measurements) -> [f64; 3] {
    let machine = find_machine(&measured.machines[0].machine).unwrap();
    let lanes = Spatial::LANES * machine.spatial().unwrap().engines();
    let clock = &clocks(&measured.placements)[0];
    let of_seeds = [clock.fmax_mhz, clock.fmax_mhz_low, clock.fmax_mhz_high];
    of_seeds.map(|mhz| lanes as f64 * mhz / 1e3)
}

fn row(measured: &Measurements) -> Vec<String> {
    let figures = &measured.areas[0].figures;
    let clock = &clocks(&measured.placements)[0];
    let text = |[median, low, high]: [f64; 3]| format!("{median:.1} ({low:.1} to {high:.1})");
    vec![
        measured.machines[0].machine.clone(),
        part(figures[&Figure::Lut4Equivalents], DEVICE.lut4_equivalents),
        part(figures[&Figure::Ff], DEVICE.ff),
        text([clock.fmax_mhz, clock.fmax_mhz_low, clock.fmax_mhz_high]),
        text(tests_per_second(measured)),
    ]
}

#[test]
fn the_page_of_machines_has_the_fine_tiles() {
    let page = include_str!("../../../../docs/machines.md");
    let header = [
        "machine",
        "LUT equivalents",
        "flip-flops",
        "MHz",
        "G tests/s",
    ];
    let measured = MEASURED.map(|text| serde_json::from_str::<Measurements>(text).unwrap());
    let table = table::markdown(&header, &measured.each_ref().map(row));
    assert!(
        page.contains(&table),
        "docs/machines.md should have this table:\n{table}"
    );
    let readme = include_str!("../../../../README.md");
    let peak = format!("reaches {:.1} G tests/s", tests_per_second(&measured[0])[0]);
    assert!(readme.contains(&peak), "README.md should say: {peak}");
    // The spec chooses the squarers by the blocks of the device: no further engine has blocks left.
    let figures = &measured[0].areas[0].figures;
    let left = |figure, of: u64| of.checked_sub(figures[&figure]).unwrap();
    let squares_of_an_engine = 3 * Spatial::LANES as u64;
    assert!(left(Figure::Dsp, DEVICE.dsp) < squares_of_an_engine);
    assert!(left(Figure::BlockRam, DEVICE.block_ram) < squares_of_an_engine / 2);
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

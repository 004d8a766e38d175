//! How few bits a photon needs: the study behind the default photon format.
//!
//! `cargo run --release -p photoncube-render --example format_study` prints its tables in some
//! minutes; `-- --json` prints them as JSON. Every scene is traced with fixed seeds, so every
//! figure comes out the same anywhere.
//!
//! The measure is that of `photoncube report`: the rms error against f64 on the same photons over
//! the scene's own Monte-Carlo noise (`ErrorStudy`), with 95 % intervals over independent maps. A
//! format suffices where the ratio is at most 0.1 on every scene, the interval's upper end too.

mod anchors;
mod finals;
mod measure;
mod positions;
mod powers;
mod rounding;
mod sharing;
mod storage;
mod table;

use measure::Case;
use table::Table;

fn main() {
    let tables = tables();
    if std::env::args().any(|argument| argument == "--json") {
        let rows: Vec<_> = tables.iter().map(Table::json).collect();
        println!("{}", serde_json::json!(rows));
    } else {
        tables.iter().for_each(|table| println!("{table}"));
    }
}

fn tables() -> Vec<Table> {
    let mut tables = vec![anchors::noise(), anchors::formats()];
    let cases = Case::coarse();
    tables.push(powers::mantissas(&cases));
    tables.push(powers::hash(&cases));
    tables.push(sharing::exponents(&cases));
    tables.push(storage::positions(&cases));
    tables.push(finals::channels(cases));
    let cases = Case::fine();
    tables.push(positions::half_steps(&cases));
    tables.push(finals::finals(&cases));
    tables
}

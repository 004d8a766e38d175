//! Measures the bits and the rounding of mantissas.

use photoncube_render::QuantisedMap;

use crate::measure::{Case, Figures, bits, power_alone, stored_powers};
use crate::rounding::{self, Sharing};
use crate::table::{Cell, Table};

const EXPONENTS: [(&str, &[u32]); 3] = [
    ("e5", &[2, 3, 4, 5, 6, 7, 8]),
    ("b5", &[3, 4, 5, 8]),
    ("", &[4, 8, 16]),
];

/// Every mantissa and exponent, to nearest and dithered.
pub fn mantissas(cases: &[Case]) -> Table {
    let mut header = vec!["format".to_owned(), "bits".to_owned()];
    for case in cases {
        header.push(format!("{} ratio", case.name));
        header.push(format!("{} power alone", case.name));
        header.push(format!("{} power bias %", case.name));
    }
    let mut table = Table::new(
        "Mantissa bits, rounding and exponent, at positions local8",
        "ratio: rms error / noise of the format. power alone: the same with exact positions, and \
         its bias in per cent.",
        header,
    );
    for (exponent, mantissas) in EXPONENTS {
        for mantissa in mantissas {
            for rounding in ["", "d"] {
                let name = format!("local8-rgb{mantissa}{exponent}{rounding}");
                table.push(row(cases, &name));
            }
        }
    }
    table
}

fn row(cases: &[Case], name: &str) -> Vec<Cell> {
    let mut row = vec![Cell::text(name), Cell::Number(bits(name).into(), 0)];
    for Case { bench, .. } in cases {
        let whole = Figures::of_format(bench, name);
        let power = Figures::of(&power_alone(bench, name, stored_powers));
        row.push(Cell::Number(whole.ratio.mean, 3));
        row.push(Cell::Number(power.ratio.mean, 3));
        row.push(Cell::percent(power.bias, 3));
    }
    row
}

/// Compares dithering by the hash of the stored position with dithering by random numbers.
pub fn hash(cases: &[Case]) -> Table {
    let mut header = vec!["dither".to_owned()];
    for case in cases {
        header.push(format!("{} power alone", case.name));
        header.push(format!("{} power bias %", case.name));
    }
    let mut table = Table::new(
        "Dither by the hash of the stored position, and by random numbers",
        "Photons of one cell share the hash, in one block and in different ones: the coarser the \
         positions, the more. Were that too many, the hash's error would exceed the random one's.",
        header,
    );
    for name in [
        "local8-rgb3e5d",
        "local8-rgb5e5d",
        "local6-rgb3e5d",
        "local5-rgb3e5d",
        "local4-rgb3e5d",
    ] {
        let random = |map: &QuantisedMap<'_>| rounding::powers(map, Sharing::Photon, true);
        let mut rows = [("hash", Vec::new()), ("random", Vec::new())];
        for Case { bench, .. } in cases {
            let studies = [
                power_alone(bench, name, stored_powers),
                power_alone(bench, name, random),
            ];
            for ((_, row), study) in rows.iter_mut().zip(&studies) {
                let found = Figures::of(study);
                row.push(Cell::Interval(found.ratio, 4));
                row.push(Cell::percent(found.bias, 3));
            }
        }
        for (dither, mut row) in rows {
            row.insert(0, Cell::text(format!("{name}, {dither}")));
            table.push(row);
        }
    }
    table
}

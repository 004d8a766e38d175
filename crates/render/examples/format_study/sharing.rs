//! Measures exponents that a block, or a part of a block, shares.

use photoncube_render::QuantisedMap;

use crate::measure::{Case, Figures, power_alone, quantised};
use crate::rounding::{self, Sharing, place};
use crate::table::{Cell, Table};

/// Bits of an exponent.
const EXPONENT: f64 = 5.0;

const SHARINGS: [(&str, Sharing); 5] = [
    ("photon", Sharing::Photon),
    ("block", Sharing::SubBlock(0)),
    ("block / 8", Sharing::SubBlock(1)),
    ("block / 64", Sharing::SubBlock(2)),
    ("block / 512", Sharing::SubBlock(3)),
];

/// A table of the ways to share exponents, with their cost.
pub fn exponents(cases: &[Case]) -> Table {
    let mut header = vec!["exponent of".to_owned(), "mantissa".to_owned()];
    for case in cases {
        header.push(format!("{} power alone", case.name));
        header.push(format!("{} exponent bits/photon", case.name));
    }
    let mut table = Table::new(
        "Exponents shared by parts of a block",
        "Ratio of dithered powers alone (exact positions). A part is known by the top bits of the \
         stored position. Exponent bits: 5 for every part that holds a photon, and a bit for every \
         part of the block that says whether it does.",
        header,
    );
    for mantissa in [3, 5, 8] {
        for (name, sharing) in SHARINGS {
            let mut row = vec![Cell::text(name), Cell::Number(mantissa.into(), 0)];
            let format = format!("local8-rgb{mantissa}e5d");
            for Case { bench, .. } in cases {
                let powers = |map: &QuantisedMap<'_>| rounding::powers(map, sharing, true);
                let found = Figures::of(&power_alone(bench, &format, powers));
                let bits = cost(&quantised(&bench.maps()[0], &format), sharing);
                row.push(Cell::Number(found.ratio.mean, 3));
                row.push(Cell::Number(bits, 2));
            }
            table.push(row);
        }
    }
    table
}

/// Exponent bits per photon.
fn cost(quantised: &QuantisedMap<'_>, sharing: Sharing) -> f64 {
    let Sharing::SubBlock(s) = sharing else {
        return EXPONENT;
    };
    let parts = 1 << (3 * s);
    let shift = quantised.numbers().position_bits() - s;
    let mut total = 0.0;
    for block in quantised.map().block_slices() {
        let mut held = vec![false; parts];
        for record in &quantised.records()[block] {
            held[place(record.position, shift, s)] = true;
        }
        let held = held.iter().filter(|held| **held).count();
        // The only part of a whole block needs no bit.
        let mask = if s == 0 { 0 } else { parts };
        total += EXPONENT * held as f64 + mask as f64;
    }
    total / quantised.records().len() as f64
}

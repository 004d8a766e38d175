//! The formats that could replace the default, measured on more maps and more queries.

use glam::DVec3;

use crate::measure::{Case, Figures, bits, quantised};
use crate::storage::shared_record;
use crate::table::{Cell, Table};

/// The formats, sorted by bits per photon.
const FINALS: [&str; 18] = [
    "local8-rgb8e8",
    "local8-rgb8e5",
    "local7x1-rgb8e5",
    "local8x1-rgb6e5d",
    "local8x1-rgb5e5d",
    "local8-rgb5e5d",
    "local7x1-rgb6e5d",
    "local9x1-rgb3e5d",
    "local8x1-rgb4e5d",
    "local8-rgb4e5d",
    "local7x1-rgb5e5d",
    "local8x1-rgb3e5d",
    "local8-rgb3e5d",
    "local7x2-rgb4e5d",
    "local7x1-rgb4e5d",
    "local8x1-rgb3e4d",
    "local8x1-rgb2e5d",
    "local7x2-rgb3e5d",
];

/// A table of ratio, bias and storage of each format, on every scene.
pub fn finals(cases: &[Case]) -> Table {
    let mut header = vec!["format".to_owned(), "bits".to_owned()];
    let mut rows: Vec<Vec<Cell>> = FINALS
        .iter()
        .map(|name| vec![Cell::text(*name), Cell::Number(bits(name).into(), 0)])
        .collect();
    let mut highest = [0.0; FINALS.len()];
    for Case { name, bench } in cases {
        header.push(format!("{name} ratio"));
        header.push(format!("{name} bias %"));
        header.push(format!("{name} shared"));
        for ((format, row), highest) in FINALS.iter().zip(&mut rows).zip(&mut highest) {
            let found = Figures::of_format(bench, format);
            let stored = shared_record(&quantised(&bench.maps()[0], format));
            row.push(Cell::Interval(found.ratio, 3));
            row.push(Cell::percent(found.bias, 3));
            row.push(Cell::Number(stored, 1));
            *highest = found.ratio.high.max(*highest);
        }
    }
    header.push("<= 0.1".to_owned());
    let mut table = Table::new(
        "The fewest bits at a tenth of the noise",
        "Error / noise and bias with 95 % intervals. shared: bits per photon where runs share the \
         top bits of positions and exponents, without loss. The last column: the interval's \
         upper end on every scene.",
        header,
    );
    for (mut row, highest) in rows.into_iter().zip(highest) {
        let verdict = if highest <= 0.1 { "yes" } else { "no" };
        row.push(Cell::text(verdict));
        table.push(row);
    }
    table
}

/// A table of errors by channel. Luminance may hide them: weak channels have the fewest steps.
pub fn channels(cases: Vec<Case>) -> Table {
    let mut header = vec!["format".to_owned(), "bits".to_owned()];
    let mut rows: Vec<Vec<Cell>> = FINALS
        .iter()
        .map(|name| vec![Cell::text(*name), Cell::Number(bits(name).into(), 0)])
        .collect();
    for Case { name, mut bench } in cases {
        for (channel, weights) in ["red", "green", "blue"].into_iter().zip(DVec3::AXES) {
            header.push(format!("{name} {channel}"));
            bench = bench.weighted(weights);
            for (format, row) in FINALS.iter().zip(&mut rows) {
                let found = Figures::of_format(&bench, format);
                row.push(Cell::Number(found.ratio.mean, 3));
            }
        }
    }
    let mut table = Table::new(
        "Each channel's own error over its own noise",
        "The 0.1 is of luminance; a channel that is weak in a photon has fewer steps there.",
        header,
    );
    rows.into_iter().for_each(|row| table.push(row));
    table
}

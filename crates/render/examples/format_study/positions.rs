//! Measures the bits of positions, and queries on finer steps.

use crate::measure::{Case, Figures, bits};
use crate::table::{Cell, Table};

/// A table for p = 5 to 8 and x = 0 to 2, with exact powers.
pub fn half_steps(cases: &[Case]) -> Table {
    let mut header = vec!["format".to_owned(), "position bits".to_owned()];
    for case in cases {
        header.push(format!("{} misclassified %", case.name));
        header.push(format!("{} ratio", case.name));
    }
    let mut table = Table::new(
        "Position bits and queries on finer steps",
        "Powers of 8 bits, dithered. A query's further bits cost a photon nothing.",
        header,
    );
    for position_bits in 5..=8 {
        for extra in ["", "x1", "x2"] {
            let name = format!("local{position_bits}{extra}-rgb8e5d");
            let position = f64::from(3 * position_bits);
            assert_eq!(bits(&name), 3 * position_bits + 29);
            let mut row = vec![Cell::text(&name), Cell::Number(position, 0)];
            for Case { bench, .. } in cases {
                let found = Figures::of_format(bench, &name);
                row.push(Cell::Number(found.report.misclassified_percent, 3));
                row.push(Cell::Interval(found.ratio, 3));
            }
            table.push(row);
        }
    }
    table
}

//! The listing of an overlapped program, for people.
//!
//! A line shows what one cell of a quad does in one clock of the kernel, unit by unit. `b3` means the second
//! group of the iteration that began three passes ago.

use std::fmt;

use super::program::{KernelOp, Program};
use crate::cell::Op;
use crate::hypercube::Role;

/// A column of the listing.
struct Column {
    title: &'static str,
    /// The characters of its longest entry, or of its title; 0 for the last column.
    width: usize,
    shows: fn(Op) -> bool,
}

const COLUMNS: &[Column] = &[
    Column {
        title: "photon",
        width: 6,
        shows: |op| op == Op::LoadPhoton,
    },
    Column {
        title: "square",
        width: 6,
        shows: |op| op == Op::SquareDifference,
    },
    Column {
        title: "gate",
        width: 6,
        shows: |op| op == Op::Compare,
    },
    Column {
        title: "operand",
        width: 8,
        shows: |op| matches!(op, Op::Receive | Op::Gate),
    },
    Column {
        title: "adder",
        width: 6,
        shows: |op| matches!(op, Op::Add | Op::Accumulate),
    },
    Column {
        title: "distance",
        width: 9,
        shows: |op| matches!(op, Op::Keep | Op::Relay),
    },
    Column {
        title: "power: word of the queue, and whose",
        width: 0,
        shows: |op| matches!(op, Op::LoadPower | Op::MovePower(_)),
    },
];

impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "kernel, {} clocks for {} groups:",
            self.interval, self.groups
        )?;
        let titles = COLUMNS.iter().map(|column| column.title.to_owned());
        line(f, "clock", "cell", titles)?;
        for clock in 0..self.interval {
            for role in Role::ALL {
                let cells = COLUMNS.iter().map(|column| self.entry(clock, role, column));
                let clock = match role {
                    Role::X => clock.to_string(),
                    _ => String::new(),
                };
                line(f, &clock, role.name(), cells)?;
            }
        }
        writeln!(f, "epilogue, {} clocks:", self.epilogue_clocks())?;
        for op in &self.epilogue {
            writeln!(f, "{:>5}  all   {}", op.clock, op.step)?;
        }
        Ok(())
    }
}

impl Program {
    /// The ops that a cell of the role begins in a clock of the kernel, as the listing writes them; `-` where there
    /// is none.
    pub fn listed(&self, clock: u32, role: Role) -> String {
        let entries = COLUMNS.iter().map(|column| self.entry(clock, role, column));
        let entries: Vec<_> = entries.filter(|entry| !entry.is_empty()).collect();
        match entries.is_empty() {
            true => "-".to_owned(),
            false => entries.join(", "),
        }
    }

    fn entry(&self, clock: u32, role: Role, column: &Column) -> String {
        let here =
            |op: &&KernelOp| op.clock == clock && op.role == role && (column.shows)(op.step.op);
        let entries: Vec<_> = self.kernel.iter().filter(here).map(entry).collect();
        entries.join(" ")
    }
}

/// The listing's entry of an op. A word of the power queue is written as its number, every other op as its
/// mnemonic.
fn entry(op: &KernelOp) -> String {
    let letter = char::from(b'a' + op.group as u8);
    let of = format!("{letter}{}", op.stage);
    match op.step.op {
        Op::LoadPower => format!("0:{of}"),
        Op::MovePower(place) => format!("{place}:{of}"),
        _ => format!("{} {of}", op.step),
    }
}

fn line(
    f: &mut fmt::Formatter<'_>,
    clock: &str,
    role: &str,
    cells: impl Iterator<Item = String>,
) -> fmt::Result {
    let cells = COLUMNS.iter().zip(cells);
    let cell = |(column, cell): (&Column, String)| format!("{cell:<0$} ", column.width);
    let cells: String = cells.map(cell).collect();
    let text = format!("{clock:>5}  {role:<5} {cells}");
    writeln!(f, "{}", text.trim_end())
}

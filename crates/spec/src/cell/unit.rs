//! The units of a cell, and how much of the time they work.

use std::fmt;

/// A unit of the cell; each starts at most one op a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// `(A-B)^2`.
    Square,
    /// `if A>B, output 0`.
    Gate,
    /// `A+B`.
    Add,
    /// The data port: loads from the query and group streams.
    Port,
    /// Reads a photon's coordinate from the group stream.
    PhotonPort,
    /// Reads a photon's power from the group stream.
    PowerPort,
}

impl Unit {
    /// The name of the unit's module in the emitted Verilog; a port, which is no module, has its name alone.
    pub fn module(self) -> &'static str {
        match self {
            Self::Square => "square_unit",
            Self::Gate => "gate_unit",
            Self::Add => "add_unit",
            Self::Port => "port",
            Self::PhotonPort => "photon port",
            Self::PowerPort => "power port",
        }
    }

    /// The unit's name in listings and reports.
    pub fn name(self) -> &'static str {
        let module = self.module();
        module.strip_suffix("_unit").unwrap_or(module)
    }

    /// What the unit computes, in the paper's words; empty for a port.
    pub fn formula(self) -> &'static str {
        match self {
            Self::Square => "(A-B)^2",
            Self::Gate => "if A>B, output 0",
            Self::Add => "A+B",
            Self::Port | Self::PhotonPort | Self::PowerPort => "",
        }
    }

    /// Whether the unit only loads words of a stream.
    pub fn is_port(self) -> bool {
        matches!(self, Self::Port | Self::PhotonPort | Self::PowerPort)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The use of a unit in an iteration, or in a pass of a kernel.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct UnitUse {
    /// The unit that is counted.
    pub unit: Unit,
    /// The ops that the unit starts. In a sequential machine all cells share one instruction, so they are those
    /// of one cell; in an overlapped machine they are those of the four cells of a quad together.
    pub busy_clocks: u32,
    /// The clocks in which the unit could start an op, summed over the same cells.
    pub clocks: u32,
    /// The fewest clocks that this unit allows: the ops that it starts in the cell that has most of them.
    pub bound: u32,
}

impl UnitUse {
    /// Busy clocks over all clocks.
    pub fn utilisation(&self) -> f64 {
        unit_utilisation(&[*self])
    }
}

/// The busy clocks of some units over all their clocks.
pub fn unit_utilisation(units: &[UnitUse]) -> f64 {
    let sum = |count: fn(&UnitUse) -> u32| units.iter().map(count).sum::<u32>();
    f64::from(sum(|unit| unit.busy_clocks)) / f64::from(sum(|unit| unit.clocks))
}

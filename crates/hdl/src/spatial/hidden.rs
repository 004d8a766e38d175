//! Registers inside a block whose Verilog is written by hand.

/// The value of such a register in the simulation. Its field starts with `_`, so that rust-hdl
/// prints nothing of it; the text declares it without.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Hidden(pub u64);

impl Hidden {
    /// Its value, called like that of a signal.
    pub fn val(self) -> u64 {
        self.0
    }
}

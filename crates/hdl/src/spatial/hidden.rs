//! Registers inside a block whose Verilog is written by hand.

/// The value of such a register in the simulation. The field's name starts with `_`, so that rust-hdl does
/// not print it; the hand-written text declares the register without the `_`.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Hidden(pub u64);

impl Hidden {
    /// The register's value, under the method name that a signal has.
    pub fn val(self) -> u64 {
        self.0
    }
}

//! A design: its Verilog, and the files that the tools read.

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::{Result, write};

/// A design that is measured.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Design {
    /// The name of its top module.
    pub top: String,
    /// The Verilog text of all modules.
    pub verilog: String,
    /// By the name of a family of FPGAs, Verilog that overrides some modules where the design is mapped to
    /// that family, such as modules made of its own carry cells.
    pub overrides: BTreeMap<&'static str, String>,
}

impl Design {
    /// The Yosys commands that read the design for a family, from the folder of its files.
    pub fn read_commands(&self, family: &str) -> String {
        let top = &self.top;
        let read = format!("read_verilog {top}.v");
        match self.overrides.contains_key(family) {
            true => format!("{read}; read_verilog -overwrite {top}_{family}.v"),
            false => read,
        }
    }

    /// Writes the texts into a folder: `{top}.v`, and `{top}_{family}.v` for each override.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let top = &self.top;
        write(&folder.join(format!("{top}.v")), &self.verilog)?;
        let mut overrides = self.overrides.iter();
        overrides
            .try_for_each(|(family, text)| write(&folder.join(format!("{top}_{family}.v")), text))
    }
}

//! A core on the board ULX3S, with an ECP5 of 85,000 LUTs.

use std::fmt::Write as _;

use photoncube_spec::Core;
use thiserror::Error;

use super::bridge::core_on_line;
use crate::core::{EmittedCore, emit_core};
use crate::emit::EmitError;

/// A core on a ULX3S.
#[derive(Copy, Clone, Debug)]
pub struct Ulx3s {
    core: Core,
    pll: Pll,
    baud: u32,
}

/// The files of a core on a ULX3S.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ulx3sFiles {
    /// The name of the top module.
    pub top: String,
    /// The core.
    pub core: EmittedCore,
    /// The top module, and those of the line.
    pub board: String,
    /// The module of the clock, with a PLL of the ECP5.
    pub pll: String,
    /// The module of the clock for simulations.
    pub pll_model: String,
    /// The constraints for nextpnr: pins and clocks.
    pub lpf: String,
}

/// A board cannot be made so.
#[derive(Debug, Error)]
pub enum Ulx3sError {
    /// The PLL does not make the clock.
    #[error("found a clock of {found} MHz, expected one of {expected:?}")]
    Clock {
        /// The clock.
        found: u32,
        /// Those that the PLL makes here.
        expected: Vec<u32>,
    },
    /// The clock is too slow or too fast for the line.
    #[error("found {baud} bits a second at a clock of {mhz} MHz, expected {least} to {most}")]
    Baud {
        /// Bits a second.
        baud: u32,
        /// The clock.
        mhz: u32,
        /// The slowest line.
        least: u32,
        /// The fastest line.
        most: u32,
    },
    /// The core is not emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
}

/// The dividers of the PLL.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Pll {
    mhz: u32,
    /// Of the board's clock.
    reference: u32,
    /// Of the clock that is fed back.
    feedback: u32,
    /// From the oscillator to the clock.
    output: u32,
}

impl Pll {
    /// The frequency of the PLL's oscillator in MHz, between the 400 and the 800 that it may have.
    const OSCILLATOR_MHZ: u32 = 600;

    /// The clocks that the oscillator gives, up to 150 MHz: the board's times a fraction with a denominator of at most 5.
    fn all() -> impl Iterator<Item = Self> {
        (1..=30).rev().filter_map(|fifths: u32| {
            let mhz = fifths * Ulx3s::BOARD_MHZ / 5;
            let (reference, feedback) = match fifths % 5 {
                0 => (1, fifths / 5),
                _ => (5, fifths),
            };
            let exact = Self::OSCILLATOR_MHZ.is_multiple_of(mhz);
            exact.then_some(Self {
                mhz,
                reference,
                feedback,
                output: Self::OSCILLATOR_MHZ / mhz,
            })
        })
    }
}

impl Ulx3s {
    /// The frequency of the board's oscillator in MHz.
    pub const BOARD_MHZ: u32 = 25;
    /// Bits a second on the line that need no special cable or setting.
    pub const BAUD: u32 = 1_000_000;
    /// The fastest line in bits a second that the board's USB chip is specified for.
    pub const MOST_BAUD: u32 = 3_000_000;
    /// The fewest clocks of a bit.
    const LEAST_CLOCKS: u32 = 4;

    /// A core at this clock, behind a line of so many bits a second.
    ///
    /// # Errors
    /// The PLL does not make the clock, or the line is too fast or too slow for it.
    pub fn new(core: &Core, mhz: u32, baud: u32) -> Result<Self, Ulx3sError> {
        let pll = Pll::all().find(|pll| pll.mhz == mhz);
        let pll = pll.ok_or_else(|| Ulx3sError::Clock {
            found: mhz,
            expected: Self::clocks(),
        })?;
        let hertz = mhz * 1_000_000;
        let most = (hertz / Self::LEAST_CLOCKS).min(Self::MOST_BAUD);
        let least = hertz / u32::from(u16::MAX) + 1;
        match (least..=most).contains(&baud) {
            true => Ok(Self {
                core: *core,
                pll,
                baud,
            }),
            false => Err(Ulx3sError::Baud {
                baud,
                mhz,
                least,
                most,
            }),
        }
    }

    /// The clocks in MHz that the PLL makes.
    pub fn clocks() -> Vec<u32> {
        Pll::all().map(|pll| pll.mhz).collect()
    }

    /// The core.
    pub fn core(&self) -> &Core {
        &self.core
    }

    /// The clocks of a bit on the line, to the nearest.
    pub fn clocks_of_bit(&self) -> u32 {
        (self.pll.mhz * 1_000_000 + self.baud / 2) / self.baud
    }

    /// The files.
    ///
    /// # Errors
    /// The core is not emitted.
    pub fn files(&self) -> Result<Ulx3sFiles, Ulx3sError> {
        let core = emit_core(&self.core)?;
        let on_line = core_on_line(&self.core, &core);
        let top = "photoncube_ulx3s".to_owned();
        let numbers = [
            ("BOARD", top.clone()),
            ("ON_LINE", on_line.top),
            ("CLOCKS", self.clocks_of_bit().to_string()),
            ("BOARD_MHZ", Self::BOARD_MHZ.to_string()),
            ("MHZ", self.pll.mhz.to_string()),
            ("CLKI_DIV", self.pll.reference.to_string()),
            ("CLKFB_DIV", self.pll.feedback.to_string()),
            ("CLKOP_DIV", self.pll.output.to_string()),
            // The edges of the clock are those of the board's.
            ("CLKOP_CPHASE", ((self.pll.output - 1) / 2).to_string()),
        ];
        let filled = |template: &str| {
            numbers
                .iter()
                .fold(template.to_owned(), |text, (name, part)| {
                    text.replace(&format!("@{name}@"), part)
                })
        };
        Ok(Ulx3sFiles {
            board: format!(
                "{}{}\n{}",
                self.head(&top),
                filled(include_str!("ulx3s.v")),
                on_line.text
            ),
            pll: filled(include_str!("pll.v")),
            pll_model: filled(include_str!("pll_model.v")),
            lpf: self.lpf(),
            top,
            core,
        })
    }

    /// The first lines of the Verilog.
    fn head(&self, top: &str) -> String {
        format!(
            "// SPDX-License-Identifier: {}\n\
             // {top}: the core {} on a ULX3S, at {} MHz, behind a serial line of {} bits a second.\n\
             // Written by photoncube {}, `photoncube board ulx3s --machine {} --chains {} --mhz {} --baud {}`; do not edit.\n\n",
            env!("CARGO_PKG_LICENSE"),
            self.core.name(),
            self.pll.mhz,
            self.baud,
            env!("CARGO_PKG_VERSION"),
            self.core.machine.name,
            self.core.chains,
            self.pll.mhz,
            self.baud,
        )
    }

    /// The constraints.
    fn lpf(&self) -> String {
        let mut text = format!(
            "BLOCK RESETPATHS;\nBLOCK ASYNCPATHS;\nFREQUENCY PORT \"clk_25mhz\" {} MHZ;\nFREQUENCY NET \"clock\" {} MHZ;\n",
            Self::BOARD_MHZ,
            self.pll.mhz
        );
        for pin in PINS {
            let _ = write!(
                text,
                "LOCATE COMP \"{0}\" SITE \"{1}\";\nIOBUF PORT \"{0}\" IO_TYPE=LVCMOS33 {2};\n",
                pin.port, pin.site, pin.options
            );
        }
        text
    }
}

/// A pin of the FPGA.
struct BoardPin {
    port: &'static str,
    site: &'static str,
    options: &'static str,
}

const fn pin(port: &'static str, site: &'static str, options: &'static str) -> BoardPin {
    BoardPin {
        port,
        site,
        options,
    }
}

const OUTPUT: &str = "PULLMODE=NONE DRIVE=4";

/// The pins that the top has, as in the board's public file of constraints, `doc/constraints/ulx3s_v20.lpf` of github.com/emard/ulx3s.
const PINS: [BoardPin; 13] = [
    pin("clk_25mhz", "G2", "PULLMODE=NONE"),
    pin("ftdi_rxd", "L4", "PULLMODE=UP DRIVE=4"),
    pin("ftdi_txd", "M1", "PULLMODE=UP"),
    pin("btn[1]", "R1", "PULLMODE=DOWN"),
    pin("wifi_gpio0", "L2", OUTPUT),
    pin("led[0]", "B2", OUTPUT),
    pin("led[1]", "C2", OUTPUT),
    pin("led[2]", "C1", OUTPUT),
    pin("led[3]", "D2", OUTPUT),
    pin("led[4]", "D1", OUTPUT),
    pin("led[5]", "E2", OUTPUT),
    pin("led[6]", "E1", OUTPUT),
    pin("led[7]", "H3", OUTPUT),
];

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    fn core() -> Core {
        Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), 3).unwrap()
    }

    #[test]
    fn the_dividers_give_the_clock() {
        assert!(Ulx3s::clocks().contains(&50));
        for pll in Pll::all() {
            let clock = Ulx3s::BOARD_MHZ * pll.feedback;
            assert_eq!(clock, pll.mhz * pll.reference, "{pll:?}");
            assert_eq!(pll.mhz * pll.output, Pll::OSCILLATOR_MHZ, "{pll:?}");
        }
    }

    #[test]
    fn what_the_board_cannot_do_is_refused() {
        let error = Ulx3s::new(&core(), 47, 1_000_000).unwrap_err().to_string();
        assert!(error.contains("47 MHz, expected one of ["), "{error}");
        let error = Ulx3s::new(&core(), 50, 300).unwrap_err().to_string();
        assert!(error.contains("expected 763 to 3000000"), "{error}");
        let board = Ulx3s::new(&core(), 50, 3_000_000).unwrap();
        assert_eq!(board.clocks_of_bit(), 17);
    }
}

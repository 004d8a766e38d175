//! The options that record a waveform, and its files.

use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::Args;
use photoncube_testbench::Waves;
use serde::Serialize;

use crate::args::count;
use crate::files;
use crate::outputs::{self, Output};

/// The waveform of a run.
#[derive(Args, Clone, Debug)]
pub struct WavesArgs {
    /// Write the waveform of the last clocks to FILE.vcd, and beside it files that set up Surfer (.sucl) and GTKWave (.gtkw)
    #[arg(long, value_name = "FILE.vcd")]
    waves: Option<PathBuf>,
    /// The most clocks of the waveform; where the device differs, a quarter of them follow the first difference
    #[arg(long, value_name = "N", default_value_t = 1_000, requires = "waves", value_parser = count(5..=1_000_000_u32))]
    waves_clocks: u32,
}

/// The written files of a waveform.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Written {
    vcd: String,
    surfer: String,
    gtkwave: String,
    /// The first recorded clock, counted from power-up, and the one after the last.
    recorded_clocks: [u64; 2],
    /// The clock in which the device differed first.
    first_difference: Option<u64>,
}

impl WavesArgs {
    /// Refuses a file that cannot be written, or one of those that are read, before the work.
    pub fn check(&self, inputs: &[PathBuf]) -> Result<()> {
        let files = self.waves.iter().flat_map(|vcd| {
            let beside = ENDINGS[1..].iter();
            let beside = beside.map(|ending| Output::within("--waves", vcd.with_extension(ending)));
            [Output::waves("--waves", vcd)].into_iter().chain(beside)
        });
        outputs::check(&files.collect::<Vec<_>>(), inputs)
    }

    /// The number of clocks to record; `None` for no waveform.
    pub fn clocks(&self) -> Option<usize> {
        self.waves.is_some().then_some(self.waves_clocks as usize)
    }

    /// Writes the files of what was recorded, all or none.
    pub fn write(&self, recorded: Option<&Waves>) -> Result<Option<Written>> {
        let (Some(vcd), Some(recorded)) = (&self.waves, recorded) else {
            return Ok(None);
        };
        let contents = recorded.files();
        let paths = ENDINGS.map(|ending| vcd.with_extension(ending));
        let contents: [&[u8]; 3] = [
            &contents.vcd,
            contents.surfer.as_bytes(),
            contents.gtkwave.as_bytes(),
        ];
        files::write_all(paths.iter().cloned().zip(contents))?;
        let [vcd, surfer, gtkwave] = paths.each_ref().map(|path| named(path));
        let clocks = recorded.clocks();
        Ok(Some(Written {
            vcd,
            surfer,
            gtkwave,
            recorded_clocks: [clocks.start, clocks.end],
            first_difference: recorded.difference(),
        }))
    }
}

/// The endings of the files: the waveform, Surfer's commands, GTKWave's save file.
const ENDINGS: [&str; 3] = ["vcd", "sucl", "gtkw"];

fn named(path: &Path) -> String {
    path.display().to_string()
}

impl Written {
    /// What was written and how to look at it.
    pub fn text(&self) -> String {
        let [first, end] = self.recorded_clocks;
        let mut text = format!(
            "waveform: clocks {first} to {} from {} ns on in {}\n",
            end.saturating_sub(1),
            Waves::time(first),
            self.vcd
        );
        if let Some(clock) = self.first_difference {
            text += &format!(
                "  the first difference is at {} ns, clock {clock}\n",
                Waves::time(clock)
            );
        }
        text + &format!(
            "  surfer --command-file {} {}\n  gtkwave {} {}",
            self.surfer, self.vcd, self.vcd, self.gtkwave
        )
    }
}

//! Cores whose clock is measured after place and route, and the time that they take for a picture.

use anyhow::{Context, Result, ensure};
use photoncube_driver::Forecast;
use photoncube_render::{Fit, PhotonMap, QuantisedMap, QueryPoint};
use photoncube_spec::{Core, Numbers, PhotonFormat, Spatial, find_machine};
use serde::Serialize;

use crate::hardware::PictureTime;
use crate::synth::clock::{Clock, clocks};
use crate::synth::figures::AreaRow;
use crate::synth::measurements::Measurements;

/// The machine of each chain of the measured cores.
const CHAIN: &str = "leaf-7-local7-rgb6d-n4096";
/// The tool that placed and routed them.
const PLACED_BY: &str = "nextpnr-ecp5";
/// By the number of chains, what `photoncube synth --json` printed; `scripts/measure.sh --place-cores` writes the files.
const MEASURED: [(u32, &str); 2] = [
    (
        1,
        include_str!("../../../docs/measured/core-1-leaf-7-local7-rgb6d-n4096.json"),
    ),
    (
        6,
        include_str!("../../../docs/measured/core-6-leaf-7-local7-rgb6d-n4096.json"),
    ),
];

/// A core that was placed and routed.
pub struct MeasuredCore {
    pub core: Core,
    /// The median over the seeds of placement, in the fastest speed grade that was measured.
    pub clock: Clock,
    /// Its area on ECP5, with DSP blocks.
    pub area: AreaRow,
    /// The digest of the Verilog that was placed.
    pub verilog_sha256: String,
    /// How the clock was measured, in a sentence.
    pub source: String,
}

/// All cores whose clock is measured.
pub fn measured() -> Result<Vec<MeasuredCore>> {
    let read = |(chains, text): (u32, &str)| {
        let core = Core::new(find_machine(CHAIN)?, chains)?;
        MeasuredCore::read(core, text)
            .with_context(|| format!("docs/measured/{}.json", core.name()))
    };
    MEASURED.into_iter().map(read).collect()
}

impl MeasuredCore {
    fn read(core: Core, text: &str) -> Result<Self> {
        let measured: Measurements = serde_json::from_str(text)?;
        let fastest = clocks(&measured.placements).into_iter();
        let clock = fastest.max_by_key(|clock| clock.speed_grade);
        let text = measured.machines.into_iter().next();
        let text = text.context("it names no core")?;
        ensure!(
            text.machine == core.name(),
            "it is about {}, not about {}",
            text.machine,
            core.name()
        );
        let version = measured.tool_versions.get(PLACED_BY);
        let version = version.with_context(|| format!("no version of {PLACED_BY}"))?;
        Ok(Self {
            core,
            source: format!(
                "The clock is that of {PLACED_BY} {version} in an {}, post-route, the median of the seeds.",
                measured.device
            ),
            clock: clock.context("it has no placement")?,
            area: measured.areas.into_iter().next().context("no area")?,
            verilog_sha256: text.verilog_sha256,
        })
    }

    /// The numbers of a picture that the core makes. A query may meet more photons than a bank holds: they come in several sets,
    /// whose sums the host adds.
    pub fn numbers_of_picture(&self) -> PhotonFormat {
        PhotonFormat {
            max_photons: PhotonFormat::DEFAULT_MAX_PHOTONS,
            ..self.format()
        }
    }

    fn format(&self) -> PhotonFormat {
        let format = self.core.machine.format();
        *format.expect("a leaf machine has a photon format")
    }

    /// The photon tests of a clock in which each engine has a group.
    pub fn photon_tests_per_clock(&self) -> f64 {
        (Spatial::LANES * self.core.engines()) as f64 * f64::from(self.core.chains)
    }

    /// The time of the queries on the photons of `map`, by the forecast of the driver, loads of photons included.
    pub fn time(&self, map: &PhotonMap, queries: &[QueryPoint]) -> Result<PictureTime> {
        let map = QuantisedMap::new(map, &Numbers::Local(self.format()))?;
        let forecast = Forecast::of(&self.core, &map, queries);
        Ok(PictureTime::at(
            forecast.clocks,
            self.clock.fmax_mhz,
            self.clock.speed_grade,
        ))
    }
}

/// The time of a picture on a core whose format is within the bound.
#[derive(Clone, Debug, Serialize)]
pub struct CoreTime {
    pub core: String,
    pub error_over_noise: f64,
    #[serde(flatten)]
    pub time: PictureTime,
}

/// The measured core that makes the picture of the queries fastest, of those whose error in the fit is at most `noise_ratio`.
pub fn fastest_within(
    fit: &Fit,
    noise_ratio: f64,
    map: &PhotonMap,
    queries: &[QueryPoint],
) -> Result<Option<CoreTime>> {
    let mut fastest: Option<CoreTime> = None;
    for measured in measured()? {
        // A scene that the format cannot hold has no error in it.
        let Ok(measurement) = fit.measure(&measured.numbers_of_picture()) else {
            continue;
        };
        if measurement.error_over_noise > noise_ratio {
            continue;
        }
        let found = CoreTime {
            core: measured.core.name(),
            error_over_noise: measurement.error_over_noise,
            time: measured.time(map, queries)?,
        };
        let seconds = |core: &CoreTime| core.time.seconds_per_picture;
        if fastest
            .as_ref()
            .is_none_or(|best| seconds(&found) < seconds(best))
        {
            fastest = Some(found);
        }
    }
    Ok(fastest)
}

#[cfg(test)]
mod tests {
    use fpga_flow::Figure;

    use super::*;
    use crate::chains::DEVICE;
    use crate::synth::Subject;
    use crate::synth::measurements::part;

    /// "| 6 | 61,962 (74 %) | 57,558 (69 %) | 150 | 108 | 122.6 (121.1 to 124.1, 2 seeds) |".
    fn row_of_page(measured: &MeasuredCore) -> String {
        let area = |figure| measured.area.figures[&figure];
        let clock = &measured.clock;
        let seeds = match clock.seeds {
            1 => "1 seed".to_owned(),
            seeds => format!(
                "{:.1} to {:.1}, {seeds} seeds",
                clock.fmax_mhz_low, clock.fmax_mhz_high
            ),
        };
        format!(
            "| {} | {} | {} | {} | {} | {:.1} ({seeds}) |\n",
            measured.core.chains,
            part(area(Figure::Lut4Equivalents), DEVICE.lut4_equivalents),
            part(area(Figure::Ff), DEVICE.ff),
            area(Figure::BlockRam),
            area(Figure::Dsp),
            clock.fmax_mhz,
        )
    }

    #[test]
    fn the_page_of_cores_has_the_measured_area_and_clock() {
        let page = include_str!("../../../docs/cores.md");
        for core in measured().unwrap() {
            let row = row_of_page(&core);
            assert!(page.contains(&row), "docs/cores.md lacks the row\n{row}");
        }
    }

    /// A clock of another text would be that of another core. One chain tells for all, as all chains are of one machine.
    #[test]
    fn the_measured_cores_are_those_that_are_emitted() {
        let measured = measured().unwrap();
        assert_eq!(measured.len(), MEASURED.len());
        for core in measured {
            let subject = Subject::of_core(&core.core).unwrap();
            assert_eq!(
                core.verilog_sha256,
                subject.verilog_sha256,
                "docs/measured/{}.json is about another text",
                core.core.name()
            );
            assert!(core.clock.fmax_mhz > 0.0 && core.photon_tests_per_clock() >= 32.0);
        }
    }
}

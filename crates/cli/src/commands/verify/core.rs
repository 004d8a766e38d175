//! The method `core`: a core's Verilog against its golden model, every pin in every clock.

use anyhow::{Result, bail};
use clap::Args;
use photoncube_hdl::emit_core;
use photoncube_spec::{CORES, Core};
use photoncube_testbench::{
    Controls, CoreError, CoreOptions, CoreVerdict, DeviceKind, Tool, core_controls, verify_core,
    verify_core_recorded,
};
use serde_json::json;

use super::method::Method;
use super::options::{AGAINST, Devices, SeedArgs, devices, tools};
use super::outcome::Outcome;
use super::waves::WavesArgs;
use crate::args::count;
use crate::failure::CheckFailed;
use crate::machines::{self, CoreArgs};
use crate::progress;
use crate::verified::Line;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct CoreMethod {
    /// The leaf machine of each chain
    #[arg(long, value_name = "M", default_value = CORES[0].1)]
    machine: String,
    #[command(flatten)]
    core: CoreArgs,
    /// Clocks to compare in each device
    #[arg(long, default_value_t = CoreOptions::CLOCKS, value_name = "N", value_parser = count(1..=u64::MAX))]
    clocks: u64,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "text", help = AGAINST)]
    against: Vec<Devices>,
    #[command(flatten)]
    seed: SeedArgs,
    #[command(flatten)]
    waves: WavesArgs,
}

/// The columns of the table.
const COLUMNS: &str =
    "device vectors_compared results_compared leaf_beats query_beats accesses resets restarts";

impl CoreMethod {
    fn line(&self, core: &Core, verdict: &CoreVerdict, about: &Line) -> Line {
        let events: Vec<_> = verdict
            .events
            .iter()
            .map(|(name, times)| format!("{name} {times}"))
            .collect();
        Line {
            by: format!("{}: {}", verdict.device, verdict.tool_version),
            volume: verdict.vectors_compared,
            unit: "clocks".to_owned(),
            result: format!(
                "0 mismatches in {} signals; {} results; events: {}",
                verdict.signals_per_vector,
                verdict.results_compared,
                events.join(", ")
            ),
            command: format!(
                "photoncube verify core --machine {} --chains {} --clocks {} --against {} --seed {}",
                core.machine.name, core.chains, self.clocks, verdict.device, self.seed.seed
            ),
            ..about.clone()
        }
    }
}

impl Method for CoreMethod {
    const NAME: &'static str = "core";
    const ABOUT: &'static str = "Compare a core, which is several leaf machines behind AXI ports, with its golden model: every \
        pin in every clock, under waits, wrong words, accesses to registers, resets and restarts";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify core --machine leaf-5-local7-rgb6d-n64 --chains 3",
        "photoncube verify core --machine leaf-4-local7-rgb6d-n64 --clocks 20000 --waves core.vcd",
    ];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        let core = self.core.find(&self.machine)?;
        machines::prepare(core.machine)?;
        let options = CoreOptions::new(self.clocks, self.seed.seed);
        self.waves.check(&[])?;
        let mut written = None;
        let mut verdicts = Vec::new();
        for kind in devices(&self.against) {
            if kind == DeviceKind::RustHdl {
                bail!(
                    "--against rust-hdl: a core is Verilog around its chains; expected text, icarus, verilator or netlist"
                );
            }
            let bar = progress::bar("core", self.clocks);
            let tick = |done| bar.set_position(done);
            let (verdict, recorded) = match self.waves.clocks() {
                None => (verify_core(&core, kind, &options, &tick), None),
                Some(clocks) => verify_core_recorded(&core, kind, &options, clocks, &tick),
            };
            bar.finish_and_clear();
            written = self.waves.write(recorded.as_ref())?;
            verdicts.push(verdict.map_err(|error| match error {
                CoreError::Device(error) => error.into(),
                wrong => {
                    let waves = written
                        .as_ref()
                        .map_or_else(String::new, |written| format!("\n{}", written.text()));
                    anyhow::Error::from(CheckFailed(format!("{wrong}{waves}")))
                }
            })?);
        }
        let controls = core_controls(&core, DeviceKind::Text, self.seed.seed)?;
        let digest = emit_core(&core)?.verilog_sha256();
        let about = Line::about(core.name(), Some(digest));
        let details = json!({
            "core": core.name(),
            "machine": core.machine.name,
            "chains": core.chains,
            "seed": self.seed.seed,
            "verdicts": verdicts,
            "waves": written,
        });
        let lines = verdicts
            .iter()
            .map(|verdict| self.line(&core, verdict, &about));
        let lines: Vec<_> = lines.collect();
        let outcome = Outcome::new::<Self>(Controls::gathered(controls)?, &details)?;
        let outcome = outcome.rows("verdicts", COLUMNS).waves(written.as_ref());
        let events = verdicts.first().map(|verdict| {
            let events = verdict.events.iter();
            let events: Vec<_> = events
                .map(|(name, times)| format!("{name} {times}"))
                .collect();
            format!("events that were set: {}", events.join(", "))
        });
        let outcome = events.iter().fold(outcome, Outcome::note);
        Ok(outcome.lines(lines))
    }
}

//! Runs Verilog in Verilator, a fast 2-state simulator, the device for millions of iterations.
//!
//! Verilator's output is compiled with a small harness that reads frames of packed rows and answers with
//! packed rows, so that a clock takes some hundred bytes of a pipe. Registers without an initial value start
//! with random values.

use std::fmt::Write as _;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{Error, Read, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use photoncube_hdl::Emitted;
use photoncube_hdl::cache::user_cache;
use tempfile::TempDir;

use super::packing::Packing;
use super::process::Process;
use super::{Device, DeviceError, Observed, scratch_folder, write_file};
use crate::tools::{Tool, on_path, run};
use crate::trace::{TRACE, trace_module, trace_module_with};

/// Clocks in a frame. The number is large enough to make a frame's overhead small, and small enough for both
/// sides to work at once.
const FRAME_CLOCKS: usize = 512;

/// The name of the file that a simulation with coverage writes into its folder at its end.
const COVERAGE: &str = "coverage.dat";

/// A design in a running Verilator simulation.
pub struct Verilator {
    version: String,
    inputs: Packing,
    observed: Packing,
    process: Process,
    /// The folder with the standard error of the simulation and its coverage.
    folder: TempDir,
}

impl Verilator {
    /// Compiles the design, unless the cache has it, and starts it.
    ///
    /// # Errors
    /// Verilator or a C++ compiler is missing or refuses the text.
    pub fn new(design: &Emitted) -> Result<Self, DeviceError> {
        Self::start(design, trace_module(design), false)
    }

    /// Compiles the design with counters of the uses of each line, branch and bit, and of each cover point,
    /// and starts it. `covers` is Verilog for the trace module.
    pub(crate) fn with_coverage(design: &Emitted, covers: &str) -> Result<Self, DeviceError> {
        Self::start(design, trace_module_with(design, covers), true)
    }

    fn start(design: &Emitted, trace: String, coverage: bool) -> Result<Self, DeviceError> {
        let version = Tool::Verilator.version()?;
        let folder = scratch_folder()?;
        let sources = Sources {
            design: format!("{}\n{trace}", design.text),
            harness: harness(design, coverage),
            coverage,
        };
        let program = build_or_reuse(&sources, &version, folder.path())?;
        let process = Process::start(
            "verilator",
            Command::new(program).current_dir(folder.path()),
            folder.path(),
        )?;
        Ok(Self {
            version,
            inputs: Packing::of(&design.pins.inputs),
            observed: Packing::of(&design.pins.observed),
            process,
            folder,
        })
    }

    /// Ends the simulation and reads the coverage file that it wrote.
    pub(crate) fn coverage(mut self) -> Result<String, DeviceError> {
        self.process.finish()?;
        let path = self.folder.path().join(COVERAGE);
        fs::read_to_string(&path).map_err(|source| DeviceError::File {
            action: "read",
            path: path.display().to_string(),
            source,
        })
    }
}

impl Device for Verilator {
    fn name(&self) -> &str {
        "verilator"
    }

    fn tool_version(&self) -> &str {
        &self.version
    }

    fn visible(&self) -> usize {
        self.observed.columns()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let (packing, unpacking) = (&self.inputs, &self.observed);
        let clocks = inputs.len() / packing.columns();
        observed.values.reserve(clocks * unpacking.columns());
        self.process.converse(
            |stdin| {
                let mut frame = Vec::new();
                for rows in inputs.chunks(FRAME_CLOCKS * packing.columns()) {
                    let clocks = u32::try_from(rows.len() / packing.columns());
                    let clocks = clocks.expect("a frame is short");
                    frame.clear();
                    frame.extend(clocks.to_ne_bytes());
                    packing.pack(rows, &mut frame);
                    stdin.write_all(&frame)?;
                }
                Ok(())
            },
            |stdout| {
                let mut bytes = vec![0; FRAME_CLOCKS * unpacking.bytes];
                let mut left = clocks;
                while left > 0 {
                    let now = left.min(FRAME_CLOCKS);
                    let bytes = &mut bytes[..now * unpacking.bytes];
                    stdout.read_exact(bytes)?;
                    unpacking.unpack(bytes, &mut observed.values);
                    left -= now;
                }
                Ok(())
            },
        )
    }
}

/// The sources of a simulation.
pub(super) struct Sources {
    pub design: String,
    pub harness: String,
    /// Whether the uses of lines, branches and bits are counted.
    pub coverage: bool,
}

impl Sources {
    fn options(&self) -> impl Iterator<Item = &'static str> {
        OPTIONS
            .into_iter()
            .chain(self.coverage.then_some("--coverage"))
    }
}

/// Returns the compiled simulation of these sources from the cache, or builds it and stores it there.
pub(super) fn build_or_reuse(
    sources: &Sources,
    version: &str,
    scratch: &Path,
) -> Result<PathBuf, DeviceError> {
    let Some(cache) = user_cache() else {
        return build(sources, scratch);
    };
    let cache = cache.join("photoncube/verilator");
    let text = [
        version,
        &sources.options().collect::<Vec<_>>().join(" "),
        &sources.design,
        &sources.harness,
    ]
    .join("\n");
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    let entry = cache.join(format!("{:016x}", hasher.finish()));
    let program = entry.join("simulation");
    // The hash finds the cache entry; only an equal text makes it the right one.
    let is_built = || {
        let known = fs::read_to_string(entry.join("sources"));
        known.is_ok_and(|known| known == text) && program.is_file()
    };
    if is_built() {
        return Ok(program);
    }
    // Others that need this simulation wait until it is built.
    let _lock = locked(&cache, &entry);
    if is_built() {
        return Ok(program);
    }
    let built = build(sources, scratch)?;
    match store(&built, &text, &cache, &entry) {
        Ok(()) => Ok(program),
        // A cache that cannot be written costs time, but does not affect the result.
        Err(_) => Ok(built),
    }
}

/// Locks a cache entry against other threads and processes until the file is dropped. Without a lock, a simulation may be
/// built twice; the result is right all the same.
fn locked(cache: &Path, entry: &Path) -> Option<fs::File> {
    fs::create_dir_all(cache).ok()?;
    let file = fs::File::create(entry.with_extension("lock")).ok()?;
    file.lock().ok()?;
    Some(file)
}

/// Stores a built simulation in the cache atomically.
fn store(built: &Path, text: &str, cache: &Path, entry: &Path) -> Result<(), Error> {
    fs::create_dir_all(cache)?;
    let fresh = tempfile::tempdir_in(cache)?;
    fs::copy(built, fresh.path().join("simulation"))?;
    fs::write(fresh.path().join("sources"), text)?;
    if entry.exists() {
        fs::remove_dir_all(entry)?;
    }
    fs::rename(fresh.keep(), entry)
}

/// Verilator's options. `unique`: values without initialisation start with random bits.
const OPTIONS: [&str; 9] = [
    "--cc",
    "--exe",
    "--build",
    "-O3",
    "-Wno-fatal",
    "--x-assign",
    "unique",
    "--x-initial",
    "unique",
];
/// A simulation compiled with `-O3` is no faster than with `-O1` (measured on `paper`, `stream`, and cores of two and six
/// chains) and takes 1.2 to 2.1 times as long to compile.
const MAKE_VARIABLES: &str = "OPT_FAST=-O1 OPT_GLOBAL=-O1 OPT_SLOW=-O0";

fn build(sources: &Sources, folder: &Path) -> Result<PathBuf, DeviceError> {
    write_file(&folder.join("design.v"), &sources.design)?;
    write_file(&folder.join("harness.cpp"), &sources.harness)?;
    let mut command = Command::new(Tool::Verilator.find()?);
    command
        .current_dir(folder)
        .args(sources.options())
        .args(["-MAKEFLAGS", MAKE_VARIABLES])
        .args(["--top-module", TRACE, "--prefix", "Vtrace"])
        .args(["--Mdir", "built", "-o", "simulation"])
        .args(["design.v", "harness.cpp"]);
    if on_path("ccache").is_some() {
        command.env("OBJCACHE", "ccache");
    }
    run(&mut command)?;
    Ok(folder.join("built/simulation"))
}

/// The C++ harness around the simulation. A frame is the number of clocks, in 4 bytes, and their rows of
/// inputs; its answer is their rows of outputs. Both are in the native byte order, because both ends run on
/// one machine.
fn harness(design: &Emitted, coverage: bool) -> String {
    let at_end = match coverage {
        true => format!(
            "context.coveragep()->forcePerInstance(true);\n  context.coveragep()->write(\"{COVERAGE}\");"
        ),
        false => String::new(),
    };
    // With a random start, the first change of every bit would be counted.
    let start = if coverage { 0 } else { 2 };
    let clock = |level| match design.clocked {
        true => format!("top.clock = {level}; "),
        false => String::new(),
    };
    let pins = &design.pins;
    let [inputs, observed] = [&pins.inputs, &pins.observed].map(|pins| Packing::of(pins));
    let mut gets = String::new();
    for column in inputs.order() {
        let _ = writeln!(gets, "      get(from, top.{});", pins.inputs[column].name);
    }
    let mut puts = String::new();
    for column in observed.order() {
        let _ = writeln!(puts, "      put(to, top.{});", pins.observed[column].name);
    }
    format!(
        r#"#include "Vtrace.h"
#include "verilated.h"
#include "verilated_cov.h"
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

template <class T> static inline void get(const char*& from, T& value) {{
  std::memcpy(&value, from, sizeof value);
  from += sizeof value;
}}

template <class T> static inline void put(char*& to, const T& value) {{
  std::memcpy(to, &value, sizeof value);
  to += sizeof value;
}}

double sc_time_stamp() {{ return 0; }}

int main() {{
  VerilatedContext context;
  context.randReset({start});
  context.randSeed(1);
  Vtrace top{{&context}};
  std::vector<char> in, out;
  std::uint32_t clocks;
  while (std::fread(&clocks, sizeof clocks, 1, stdin) == 1) {{
    in.resize(std::size_t{{clocks}} * {in_bytes});
    out.resize(std::size_t{{clocks}} * {out_bytes});
    if (std::fread(in.data(), 1, in.size(), stdin) != in.size()) return 1;
    const char* from = in.data();
    char* to = out.data();
    for (std::uint32_t clock = 0; clock < clocks; ++clock) {{
{gets}      {low}top.eval();
{puts}      {high}top.eval();
    }}
    if (std::fwrite(out.data(), 1, out.size(), stdout) != out.size()) return 1;
    std::fflush(stdout);
  }}
  top.final();
  {at_end}
  return 0;
}}
"#,
        in_bytes = inputs.bytes,
        out_bytes = observed.bytes,
        low = clock(0),
        high = clock(1),
    )
}

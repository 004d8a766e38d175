//! Runs a leaf machine's Verilog in Verilator over its streams: the harness offers words as fast as the machine takes them, and
//! takes every result at once. Nothing is compared here and no register is observed, so a picture takes minutes.

use std::fmt::Write as _;
use std::io::{Read, Write};
use std::process::Command;

use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{
    Group, Inputs, Leaf, LeafAnswer, LeafRegister, LeafWords, Machine, Pin, Pins, QueryWord,
    SignalPlace, TaggedSums,
};
use tempfile::TempDir;

use super::packing::Packing;
use super::process::Process;
use super::simulation::hdl_error;
use super::verilator::{Build, Sources, build_or_reuse};
use super::{DeviceError, scratch_folder};
use crate::tools::Tool;
use crate::trace::trace_module;

/// A leaf machine in a running Verilator simulation, driven over its streams.
pub struct StreamSimulation {
    machine: &'static Machine,
    query: Part,
    group: Part,
    results: Packing,
    process: Process,
    #[expect(dead_code, reason = "the folder lives as long as the process")]
    folder: TempDir,
}

/// The pins of one stream: their places in a row of all inputs, and how a row of them is packed.
struct Part {
    columns: Vec<usize>,
    packing: Packing,
}

impl Part {
    /// The input pins with this prefix, except the valid pin.
    fn of(pins: &Pins, prefixes: &[&str]) -> (Self, Vec<Pin>) {
        let of_stream = |pin: &Pin| {
            let named = prefixes.iter().any(|prefix| pin.name.starts_with(prefix));
            named && !pin.name.ends_with("_valid")
        };
        let columns = (0..pins.inputs.len()).filter(|&column| of_stream(&pins.inputs[column]));
        let columns: Vec<_> = columns.collect();
        let pins: Vec<_> = columns
            .iter()
            .map(|&column| pins.inputs[column].clone())
            .collect();
        let packing = Packing::of(&pins);
        (Self { columns, packing }, pins)
    }

    /// Packs the pins of the stream.
    fn pack(&self, row: &[u64], bytes: &mut Vec<u8>) {
        let part: Vec<_> = self.columns.iter().map(|&column| row[column]).collect();
        self.packing.pack(&part, bytes);
    }
}

impl StreamSimulation {
    /// Emits the machine's Verilog, compiles it unless the cache has it, and starts it in a reset.
    ///
    /// # Errors
    /// The machine is not emitted, or Verilator or a C++ compiler is missing or refuses the text.
    ///
    /// # Panics
    /// For a machine that is not a leaf machine.
    pub fn new(machine: &'static Machine) -> Result<Self, DeviceError> {
        assert!(
            machine.leaf().is_some(),
            "the harness knows the streams of a leaf machine"
        );
        let version = Tool::Verilator.version()?;
        let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
        let (design, played) = with_played_alone(design);
        let (query, query_pins) = Part::of(&design.pins, &["query_"]);
        let (group, group_pins) = Part::of(&design.pins, &["group_", "photon_"]);
        let result_pins = result_pins(&design.pins);
        let folder = scratch_folder()?;
        let sources = Sources {
            design: format!("{}\n{}", design.text, trace_module(&design)),
            harness: harness(&query_pins, &group_pins, &result_pins, &played),
            build: Build::Fast,
        };
        let program = build_or_reuse(&sources, &version, folder.path())?;
        let mut command = Command::new(program);
        let process = Process::start(
            "verilator",
            command.current_dir(folder.path()),
            folder.path(),
        )?;
        Ok(Self {
            machine,
            query,
            group,
            results: Packing::of(&result_pins),
            process,
            folder,
        })
    }

    /// Gives the machine words, and waits until it has answered every query among them.
    ///
    /// # Errors
    /// The machine hangs, or the simulation ends before its answer.
    pub fn exchange(&mut self, words: &LeafWords) -> Result<LeafAnswer, DeviceError> {
        let frame = self.frame(words);
        let machine = self.machine;
        let (results, count) = (&self.results, words.queries.len());
        let mut answer = LeafAnswer::default();
        self.process.converse(
            |stdin| stdin.write_all(&frame),
            |stdout| {
                let mut head = [0; 24];
                stdout.read_exact(&mut head)?;
                let number = |place: usize| {
                    let bytes = head[8 * place..8 * place + 8].try_into();
                    u64::from_ne_bytes(bytes.expect("eight bytes"))
                };
                answer.clocks = number(1);
                answer.groups_played = number(2);
                let found = number(0);
                let mut bytes = vec![0; found as usize * results.bytes];
                stdout.read_exact(&mut bytes)?;
                if found != count as u64 {
                    return Err(std::io::Error::other(format!(
                        "the machine moved no word for {} clocks, with {found} of {count} results",
                        Leaf::SILENT_CLOCKS
                    )));
                }
                let mut values = Vec::new();
                results.unpack(&bytes, &mut values);
                let rows = values.chunks_exact(results.columns());
                answer.results = rows.map(|row| result_of(machine, row)).collect();
                Ok(())
            },
        )?;
        Ok(answer)
    }

    /// The words in bytes: the numbers of queries and groups, then the pins of each.
    fn frame(&self, words: &LeafWords) -> Vec<u8> {
        let mut frame = Vec::new();
        frame.extend((words.queries.len() as u64).to_ne_bytes());
        frame.extend((words.groups.len() as u64).to_ne_bytes());
        let nothing = Inputs::default();
        for &QueryWord {
            query,
            release,
            batch,
        } in &words.queries
        {
            let inputs = Inputs {
                query,
                query_release: release,
                batch,
                group: no_group(self.machine),
                ..nothing.clone()
            };
            self.query
                .pack(&Pins::input_row(self.machine, &inputs), &mut frame);
        }
        for group in &words.groups {
            let inputs = Inputs {
                group: group.clone(),
                ..nothing.clone()
            };
            self.group
                .pack(&Pins::input_row(self.machine, &inputs), &mut frame);
        }
        frame
    }
}

/// The design with one register to be observed, which says that the chain is given a group, and the name of that register.
fn with_played_alone(mut design: Emitted) -> (Emitted, String) {
    let is_played = |pin: &Pin| matches!(pin.place, SignalPlace::Leaf { register, .. } if register == LeafRegister::WordValid);
    let (outputs, registers) = design.pins.observed.split_at(design.pins.outputs);
    let place = registers.iter().position(is_played);
    let place = place.expect("a leaf machine has the register");
    let played = registers[place].clone();
    let path = design.register_paths.swap_remove(place);
    design.pins.observed = [outputs, std::slice::from_ref(&played)].concat();
    design.register_paths = vec![path];
    (design, played.name)
}

fn no_group(machine: &Machine) -> Group {
    Group {
        lanes: vec![Default::default(); machine.photons_per_iteration()],
        ..Group::default()
    }
}

/// The output pins of a result.
fn result_pins(pins: &Pins) -> Vec<Pin> {
    let outputs = pins.observed[..pins.outputs].iter();
    let of_result =
        outputs.filter(|pin| pin.name.starts_with("result_") && pin.name != "result_valid");
    of_result.cloned().collect()
}

/// A result from its pins, in the order of [`result_pins`].
fn result_of(machine: &Machine, row: &[u64]) -> TaggedSums {
    // The pins before those of the result are two readies and a valid.
    let outputs = Pins::outputs_of(machine, &[&[0; 3], row].concat());
    TaggedSums {
        sums: outputs.result,
        tag: outputs.result_tag,
    }
}

/// The C++ harness. A frame is the number of queries and of groups, 8 bytes each, then their pins; its answer is the number of results, of
/// clocks and of groups that the chain was given, then the results. The first clock of the simulation is a reset.
fn harness(query: &[Pin], group: &[Pin], result: &[Pin], played: &str) -> String {
    let lines = |pins: &[Pin], line: &dyn Fn(&str) -> String| {
        let mut text = String::new();
        for column in Packing::of(pins).order() {
            let _ = writeln!(text, "{}", line(&pins[column].name));
        }
        text
    };
    format!(
        r#"#include "Vtrace.h"
#include "verilated.h"
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
  context.randReset(2);
  context.randSeed(1);
  Vtrace top{{&context}};
  top.query_valid = 0;
  top.group_valid = 0;
  top.result_ready = 1;
  top.reset = 1;
  top.clock = 0; top.eval();
  top.clock = 1; top.eval();
  top.reset = 0;
  std::vector<char> in, out;
  std::uint64_t counts[2];
  while (std::fread(counts, sizeof counts, 1, stdin) == 1) {{
    const std::uint64_t queries = counts[0], groups = counts[1];
    in.resize(queries * {query_bytes} + groups * {group_bytes});
    out.resize(queries * {result_bytes});
    if (std::fread(in.data(), 1, in.size(), stdin) != in.size()) return 1;
    const char* query = in.data();
    const char* group = query + queries * {query_bytes};
    char* to = out.data();
    std::uint64_t answer[3] = {{0, 0, 0}};
    std::uint64_t query_at = 0, group_at = 0, still = 0;
    bool new_query = true, new_group = true;
    while (answer[0] < queries && still < {silent}) {{
      if (new_query && query_at < queries) {{
{gets_query}      }}
      if (new_group && group_at < groups) {{
{gets_group}      }}
      top.query_valid = query_at < queries;
      top.group_valid = group_at < groups;
      top.clock = 0; top.eval();
      new_query = top.query_valid && top.query_ready;
      new_group = top.group_valid && top.group_ready;
      ++still;
      if (new_query) {{ ++query_at; still = 0; }}
      if (new_group) {{ ++group_at; still = 0; }}
      if (top.result_valid) {{
        ++answer[0];
        still = 0;
{puts}      }}
      answer[2] += top.{played};
      top.clock = 1; top.eval();
      ++answer[1];
    }}
    if (std::fwrite(answer, sizeof answer, 1, stdout) != 1) return 1;
    const std::size_t size = answer[0] * {result_bytes};
    if (std::fwrite(out.data(), 1, size, stdout) != size) return 1;
    std::fflush(stdout);
    if (answer[0] < queries) return 1;
  }}
  top.final();
  return 0;
}}
"#,
        query_bytes = Packing::of(query).bytes,
        group_bytes = Packing::of(group).bytes,
        result_bytes = Packing::of(result).bytes,
        gets_query = lines(query, &|name| format!("        get(query, top.{name});")),
        gets_group = lines(group, &|name| format!("        get(group, top.{name});")),
        silent = Leaf::SILENT_CLOCKS,
        puts = lines(result, &|name| format!("        put(to, top.{name});")),
    )
}

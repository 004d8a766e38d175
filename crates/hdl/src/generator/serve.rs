//! The program of a generator.

use std::io::{self, BufReader, BufWriter, Read, Write};
use std::process::ExitCode;

use photoncube_spec::{Machine, find_machine};

use super::protocol::{Design, EMIT, LINT, SIMULATE};
use super::{Build, MachineBlock};
use crate::emit::{emit_block, lint_block};
use crate::level::Level;
use crate::pinned::{Pinned, pins};
use crate::simulator::Simulator;

/// Answers one question about the machine of that name, whose blocks `build` builds. The arguments of the program are
/// `emit LEVEL`, `lint` or `simulate LEVEL`.
pub fn serve(machine: &str, build: Build) -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    match answer(machine, build, &arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

type Answer<T> = Result<T, Box<dyn std::error::Error>>;

fn answer(machine: &str, build: Build, arguments: &[&str]) -> Answer<()> {
    let machine = find_machine(machine)?;
    let mut stdout = BufWriter::new(io::stdout().lock());
    match *arguments {
        [EMIT, level] => {
            let (level, block) = block(machine, level, build)?;
            serde_json::to_writer(&mut stdout, &design(machine, level, block.as_ref())?)?;
        }
        [LINT] => {
            let (_, block) = block(machine, Level::Machine.name(), build)?;
            serde_json::to_writer(&mut stdout, &lint_block(block.as_ref()))?;
        }
        [SIMULATE, level] => {
            let (level, block) = block(machine, level, build)?;
            let inputs = pins(block.as_ref(), machine, level).inputs.len();
            simulate(&mut Simulator::of_block(block), inputs, &mut stdout)?;
        }
        _ => return Err("expected `emit LEVEL`, `lint` or `simulate LEVEL`".into()),
    }
    Ok(stdout.flush()?)
}

fn block(machine: &Machine, level: &str, build: Build) -> Answer<(Level, Box<dyn Pinned>)> {
    let levels = Level::of(machine);
    let found = levels.into_iter().find(|of| of.name() == level);
    let level = found.ok_or_else(|| format!("machine `{}` has no {level}", machine.name))?;
    let Some(MachineBlock(mut block)) = build(machine, level) else {
        return Err(format!("there is no {} of `{}`", level.name(), machine.name).into());
    };
    block.connect_all();
    Ok((level, block))
}

fn design(machine: &Machine, level: Level, block: &dyn Pinned) -> Answer<Design> {
    let emitted = emit_block(machine, level, block)?;
    let named = |pins: &[photoncube_spec::Pin]| {
        pins.iter()
            .map(|pin| (pin.name.clone(), pin.width))
            .collect()
    };
    Ok(Design {
        inputs: named(&emitted.pins.inputs),
        outputs: named(&emitted.pins.observed[..emitted.pins.outputs]),
        text: emitted.text,
        top: emitted.top,
        ecp5_text: emitted.ecp5_text,
        register_paths: emitted.register_paths,
        block_rams: emitted.block_rams,
    })
}

/// Answers frames of rows until the input ends.
fn simulate(simulator: &mut Simulator, inputs: usize, stdout: &mut impl Write) -> Answer<()> {
    let mut stdin = BufReader::new(io::stdin().lock());
    let mut observed = Vec::new();
    let mut clocks = [0; 4];
    loop {
        match stdin.read_exact(&mut clocks) {
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => return Ok(()),
            read => read?,
        }
        let mut row = vec![0; 8 * inputs];
        for _ in 0..u32::from_le_bytes(clocks) {
            stdin.read_exact(&mut row)?;
            let (values, _) = row.as_chunks::<8>();
            let values: Vec<_> = values
                .iter()
                .map(|bytes| u64::from_le_bytes(*bytes))
                .collect();
            observed.clear();
            simulator.clock(&values, &mut observed)?;
            for value in &observed {
                stdout.write_all(&value.to_le_bytes())?;
            }
        }
        stdout.flush()?;
    }
}

//! Reads waveforms back with the crate `wellen`, which waveform viewers use, and compares them with the stimulus and
//! with the golden model's signals.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::ops::ControlFlow;

use photoncube_spec::{Core, Machine, Pins, find_machine};
use photoncube_testbench::{
    CoreOptions, Device, DeviceError, DeviceKind, Mutant, NS_PER_CLOCK, Observed, Recorder, Source,
    Unknown, VerifyError, VerifyOptions, Waves, generate, verify_core_recorded, verify_device,
    verify_recorded,
};

/// The clocks that are kept; fewer than a run has, so that the first are forgotten.
const CLOCKS: usize = 200;

const OPTIONS: VerifyOptions<'_> = VerifyOptions {
    iterations: 60,
    seed: 3,
    source: Source::Random,
};

/// A waveform as a viewer reads it: the changes of each signal, by its path.
struct Read(BTreeMap<String, Vec<(u64, String)>>);

impl Read {
    fn of(waves: &Waves) -> Self {
        let vcd = Cursor::new(waves.files().vcd);
        let mut read = wellen::simple::read_from_reader(vcd).expect("the waveform can be read");
        let variables: Vec<_> = read
            .hierarchy()
            .all_vars()
            .map(|var| {
                let var = &read.hierarchy()[var];
                (var.full_name(read.hierarchy()), var.signal_ref())
            })
            .collect();
        let signals: Vec<_> = variables.iter().map(|(_, signal)| *signal).collect();
        read.load_signals(&signals);
        let changes = |(name, signal): (String, wellen::SignalRef)| {
            let signal = read.get_signal(signal).expect("it is loaded");
            let changes = signal.iter_changes();
            let changes = changes
                .map(|(index, value)| (read.time_table()[index as usize], value.to_string()));
            (name, changes.collect())
        };
        let all: BTreeMap<_, _> = variables.into_iter().map(changes).collect();
        assert_eq!(all.len(), signals.len(), "two signals have one name");
        Self(all)
    }

    /// The value of a signal in a clock: the one before the rising edge that ends it.
    fn at(&self, path: &str, clock: u64) -> &str {
        let end = (clock + 1) * NS_PER_CLOCK;
        let changes = self.0.get(path).unwrap_or_else(|| panic!("no {path}"));
        let before = changes.partition_point(|(time, _)| *time < end);
        assert!(before > 0, "{path} has no value in clock {clock}");
        &changes[before - 1].1
    }

    /// The signals below a scope, by their names in [`Pins`].
    fn below(&self, scope: &str) -> BTreeMap<String, &str> {
        let scope = format!("{scope}.");
        let paths = self.0.keys().map(String::as_str);
        let below = paths.filter(|path| path.starts_with(&scope));
        below
            .map(|path| (path[scope.len()..].replace('.', "_"), path))
            .collect()
    }
}

fn bits(value: u64, width: u32) -> String {
    format!("{value:0width$b}", width = width as usize)
}

/// The rows of a run of [`OPTIONS`]: inputs, and the golden model's signals.
fn rows(machine: &Machine) -> (Vec<u64>, Vec<u64>) {
    let (mut inputs, mut expected) = (Vec::new(), Vec::new());
    let VerifyOptions {
        iterations,
        seed,
        source,
    } = OPTIONS;
    let mut sink = |block: photoncube_testbench::Block| {
        inputs.extend(block.inputs);
        expected.extend(block.expected);
        ControlFlow::Continue(())
    };
    generate(machine, source, seed, iterations, &mut sink).unwrap();
    (inputs, expected)
}

fn recorded(machine: &Machine) -> Waves {
    recorded_clocks(machine, CLOCKS)
}

fn recorded_clocks(machine: &Machine, clocks: usize) -> Waves {
    let (verdict, waves) = verify_recorded(machine, DeviceKind::Text, &OPTIONS, clocks, &|_| ());
    assert!(verdict.unwrap().vectors_compared > CLOCKS as u64);
    waves.unwrap()
}

/// All pins and registers of a machine of each organisation, in each of the last clocks.
#[test]
fn every_signal_has_its_value_in_every_clock() {
    for name in [
        "paper",
        "overlap",
        "stream",
        "tile-6-mixed",
        "leaf-4-local7-rgb6d-n64",
    ] {
        let machine = find_machine(name).unwrap();
        let waves = recorded(machine);
        let read = Read::of(&waves);
        let (inputs, expected) = rows(machine);
        let pins = Pins::of(machine);
        let clocks = waves.clocks();
        assert_eq!(
            clocks.end as usize,
            inputs.len() / pins.inputs.len(),
            "{name}"
        );
        assert_eq!(clocks.clone().count(), CLOCKS, "{name}");
        for (scope, pins, rows) in [
            ("inputs", &pins.inputs, &inputs),
            ("text", &pins.observed, &expected),
            ("model", &pins.observed, &expected),
        ] {
            let paths = read.below(scope);
            assert_eq!(paths.len(), pins.len(), "{name}: {scope}");
            for clock in clocks.clone() {
                let row = &rows[clock as usize * pins.len()..][..pins.len()];
                for (pin, value) in pins.iter().zip(row) {
                    let path = paths[&pin.name];
                    assert_eq!(
                        read.at(path, clock),
                        bits(*value, pin.width),
                        "{name}: {path}, {clock}"
                    );
                }
            }
        }
        assert!(
            clocks
                .clone()
                .all(|clock| read.at("run.differs", clock) == "0")
        );
        assert_eq!(waves.difference(), None);
    }
}

#[test]
fn the_clock_rises_where_the_values_of_a_clock_begin() {
    let waves = recorded(find_machine("paper").unwrap());
    let read = Read::of(&waves);
    let edges = &read.0["run.clock"];
    assert_eq!(edges.len(), 2 * CLOCKS);
    for (clock, edges) in waves.clocks().zip(edges.chunks(2)) {
        let begin = clock * NS_PER_CLOCK;
        let expected = [(begin, "1"), (begin + NS_PER_CLOCK / 2, "0")];
        assert_eq!(
            edges,
            expected.map(|(time, value)| (time, value.to_owned()))
        );
    }
}

/// The steps of a group follow each other as in the paper's program, whose listing is
/// `photoncube microprogram --machine paper`.
#[test]
fn the_steps_are_those_of_the_program() {
    let waves = recorded_clocks(find_machine("paper").unwrap(), usize::MAX);
    let read = Read::of(&waves);
    assert_eq!(waves.clocks().start, 0);
    let steps: Vec<_> = waves
        .clocks()
        .map(|clock| read.at("run.step", clock))
        .collect();
    let group = [
        "ldp", "ldw", "sqd", "add_z", "add_w", "gate", "add_x", "add_y", "acc",
    ];
    assert!(
        steps.windows(group.len()).any(|window| window == group),
        "{steps:?}"
    );
    // The first clock has no query.
    assert_eq!(steps[0], "waits_for_ldq");
    assert!(steps.contains(&"has_result"), "{steps:?}");
}

#[test]
fn the_steps_of_an_overlapped_machine_are_those_of_each_role() {
    let machine = find_machine("overlap").unwrap();
    let program = machine.overlap_program().unwrap();
    let waves = recorded(machine);
    let read = Read::of(&waves);
    let steps: Vec<_> = waves
        .clocks()
        .map(|clock| read.at("run.step", clock))
        .collect();
    // Three clocks of the kernel, over and over; four of the epilogue, once for each query.
    assert!(
        steps
            .windows(4)
            .any(|window| window == ["kernel_0", "kernel_1", "kernel_2", "kernel_0"])
    );
    let epilogue = [
        "epilogue_0",
        "epilogue_1",
        "epilogue_2",
        "epilogue_3",
        "has_result",
    ];
    assert!(
        steps.windows(5).any(|window| window == epilogue),
        "{steps:?}"
    );
    let first = steps.iter().position(|step| *step == "kernel_0").unwrap();
    let first = waves.clocks().start + first as u64;
    // The listing of clock 0 for the role X begins with the photon's load.
    assert!(read.at("run.step_x", first).starts_with("ldp_a0,"));
    assert!(program.to_string().contains("0  X     ldp a0"));
}

/// The waveform of a device that differs from the golden model from a clock on.
#[test]
fn a_difference_is_named_and_most_clocks_lead_to_it() {
    let machine = find_machine("paper").unwrap();
    let wrong = |clock, row: &mut [u64]| {
        if clock >= 500 {
            row[20] ^= 4;
        }
    };
    let mutant = Mutant::sound(machine).with_row_fault(wrong);
    let mut recorder = Recorder::new(machine, mutant, 100);
    let ended = verify_device(machine, &mut recorder, &OPTIONS, &|_| ());
    let Err(VerifyError::Diverged(divergence)) = ended else {
        panic!("the fault was not found: {ended:?}");
    };
    let waves = recorder.into_waves();
    assert_eq!(divergence.vectors_compared, 500);
    assert_eq!(waves.difference(), Some(500));
    assert_eq!(waves.clocks(), 426..526);
    let read = Read::of(&waves);
    assert_eq!(
        [499, 500].map(|clock| read.at("run.differs", clock)),
        ["0", "1"]
    );
    assert_eq!(read.at("run.differing", 500), divergence.signal);
    assert_eq!(read.at("run.differing", 499), "-");
    let [device, model] = ["mutant", "model"].map(|scope| {
        let path = read.below(scope)[&divergence.signal];
        u64::from_str_radix(read.at(path, 500), 2).unwrap()
    });
    assert_eq!(device ^ model, 4);
    assert_eq!(model, divergence.expected);
    // Viewers show the part that differs before the others, and the clock of the difference.
    let files = waves.files();
    let groups: Vec<_> = files.surfer.lines().collect();
    let part = divergence
        .signal
        .split('_')
        .take(2)
        .collect::<Vec<_>>()
        .join("_");
    assert_eq!(groups[1], format!("scope_add_as_group mutant.{part}"));
    assert_eq!(groups[2], format!("scope_add_as_group model.{part}"));
    assert!(groups.contains(&"cursor_set 5000ns"));
    assert!(files.gtkwave.contains("\n*-5.0 5000 -1"));
}

/// The files for viewers name signals that the waveform has.
#[test]
fn viewers_are_told_names_that_exist() {
    for name in ["paper", "overlap", "tile-6-mixed"] {
        let waves = recorded(find_machine(name).unwrap());
        let read = Read::of(&waves);
        let files = waves.files();
        let groups = files.surfer.lines();
        let groups: Vec<_> = groups
            .filter_map(|line| line.strip_prefix("scope_add_as_group "))
            .collect();
        assert!(groups.len() > 3, "{name}");
        for group in &groups {
            assert!(!read.below(group).is_empty(), "{name}: {group}");
        }
        // GTKWave's lines that are no flags, titles or settings are paths, with the range of several bits.
        let paths = files.gtkwave.lines();
        let paths: Vec<_> = paths
            .filter(|line| !line.starts_with(['[', '*', '@', '-']))
            .collect();
        assert!(paths.len() > 50, "{name}");
        for path in paths {
            let path = path.split('[').next().unwrap();
            assert!(read.0.contains_key(path), "{name}: {path}");
        }
    }
}

/// A core has the pins of its ports. Each result that was compared is a clock of the waveform in which the port of
/// the results has both valid and ready.
#[test]
fn the_handshakes_of_a_core_are_those_that_were_counted() {
    let core = Core::new(find_machine("leaf-4-local7-rgb6d-n64").unwrap(), 1).unwrap();
    let options = CoreOptions::new(20_000, 1);
    let (verdict, waves) =
        verify_core_recorded(&core, DeviceKind::Text, &options, usize::MAX, &|_| ());
    let (verdict, waves) = (verdict.unwrap(), waves.unwrap());
    assert_eq!(waves.clocks(), 0..20_000);
    assert_eq!(waves.difference(), None);
    let read = Read::of(&waves);
    let moves = |valid: &str, ready: &str| {
        let both = |clock: &u64| read.at(valid, *clock) == "1" && read.at(ready, *clock) == "1";
        waves.clocks().filter(both).count() as u64
    };
    let results = moves("text.m_axis_results.tvalid", "inputs.m_axis_results.tready");
    assert_eq!(results, verdict.results_compared);
    let leaves = moves("inputs.s_axis_photons.tvalid", "text.s_axis_photons.tready");
    assert_eq!(leaves, verdict.leaf_beats);
    assert_eq!(read.below("text").len(), verdict.signals_per_vector);
}

/// The golden model, with a register that has unknown bits.
struct HalfKnown(Mutant);

impl Device for HalfKnown {
    fn name(&self) -> &str {
        "half-known"
    }

    fn tool_version(&self) -> &str {
        self.0.tool_version()
    }

    fn visible(&self) -> usize {
        self.0.visible()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let first = observed.values.len();
        self.0.replay(inputs, observed)?;
        observed.unknown.push(Unknown {
            index: first + COLUMN,
            text: "0x3z".to_owned(),
        });
        Ok(())
    }
}

/// The column of a register of 16 bits of `paper`.
const COLUMN: usize = 13;

#[test]
fn unknown_bits_are_shown_as_such() {
    let machine = find_machine("paper").unwrap();
    let pin = &Pins::of(machine).observed[COLUMN];
    assert_eq!((pin.name.as_str(), pin.width), ("cell_0_power", 16));
    let mut recorder = Recorder::new(machine, HalfKnown(Mutant::sound(machine)), 10);
    let idle = vec![0; Pins::of(machine).inputs.len()];
    recorder.replay(&idle, &mut Observed::default()).unwrap();
    let waves = recorder.into_waves();
    assert_eq!(waves.difference(), Some(0));
    let read = Read::of(&waves);
    assert_eq!(read.at("half_known.cell_0.power", 0), "0000xxxx0011zzzz");
}

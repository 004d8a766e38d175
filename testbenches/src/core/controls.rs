//! Faults in the Verilog of a core that its verification must find.

use photoncube_hdl::emit_core;
use photoncube_spec::{CORES, Core, find_machine};

use super::{CoreError, CoreOptions, drive, verify_core_text};
use crate::controls::{Control, plant};
use crate::device::{DeviceKind, hdl_error};

/// A fault in a module of a core: what it is, the module, a text in it and the text in its place.
type CoreFault = (&'static str, &'static str, &'static str, &'static str);

/// The module of a fault in the top module. Any other is named as in the text, without the top's name in front.
const TOP: &str = "";

/// Faults that a verification of a core must find.
const FAULTS: [CoreFault; 11] = [
    (
        "a leaf within a set has one group where its last four photons are absent",
        "photon_queue",
        "has_two = leaf_has_second | ~leaf_last;",
        "has_two = leaf_has_second;",
    ),
    (
        "a set that is too long is read in",
        "photon_port",
        "drops_next = set_too_long | (drops",
        "drops_next = (drops",
    ),
    (
        "a word is lost where both places of a slice are full",
        "slice",
        "assign in_ready = ~second_full;",
        "assign in_ready = 1'b1;",
    ),
    (
        "a word in a place is overwritten",
        "place",
        "if (~full) word <= in_word;",
        "word <= in_word;",
    ),
    (
        "a word goes to a queue that is full",
        "link",
        "assign in_ready = ~left[BITS - 1];",
        "assign in_ready = 1'b1;",
    ),
    (
        "a leaf is given to a chain while the second group of the one before is on its way",
        "photon_port",
        "(has_place & ~leaf_given);",
        "has_place;",
    ),
    (
        "a reset does not empty a queue",
        "queue",
        "if (reset) begin",
        "if (1'b0) begin",
    ),
    (
        "a queue forgets a word that comes as the one before it moves to the front",
        "queue",
        "has_word <= in_valid | (has_word",
        "has_word <= (in_valid & ~reads) | (has_word",
    ),
    (
        "an event that comes while it is cleared is lost",
        "registers",
        "events <= (events & ~cleared) | occurred;",
        "events <= (events | occurred) & ~cleared;",
    ),
    (
        "a reset does not forget a read that was refused",
        "registers",
        "seen_read <= found & aresetn;",
        "seen_read <= found;",
    ),
    (
        "a restart does not forget the queries under way",
        "registers",
        "if (reset | ~aresetn) begin\n            under_way <= 16'd0;",
        "if (1'b0) begin\n            under_way <= 16'd0;",
    ),
];

/// Faults in what leads past a chain, which changes nothing where there is one chain.
const FAULTS_OF_SEVERAL: [CoreFault; 2] = [
    (
        "a reset does not stop the words on their way to the chains",
        "stage",
        "out_valid <= in_valid & ~reset;",
        "out_valid <= in_valid;",
    ),
    (
        "the results of a chain do not take turns with those that pass it",
        "merge",
        "own_valid & ~(passing_valid & was_own);",
        "own_valid;",
    ),
];

/// Faults in the store of batches, which a core has whose queries have radii.
const FAULTS_OF_ROUNDS: [CoreFault; 9] = [
    (
        "a batch on the next set is taken before the last round of the batch that releases the set",
        "rounds",
        "held <= releases_now;",
        "held <= 1'b0;",
    ),
    (
        "a batch releases its set in its first round",
        "rounds",
        "word[RELEASE] & is_last_round",
        "word[RELEASE]",
    ),
    (
        "a query's own radius above the largest is gathered",
        "rounds",
        "(radius_taken > LARGEST) ? LARGEST : radius_taken",
        "radius_taken",
    ),
    (
        "a rung above the largest radius is gathered",
        TOP,
        "LARGEST_RADIUS = ",
        "LARGEST_RADIUS = ~0 | ",
    ),
    (
        "the bisection goes on from the radius itself",
        "rounds",
        "back_radius + 1'b1;",
        "back_radius;",
    ),
    (
        "the k nearest have the sums of the last round",
        "rounds",
        "(back_is_nearest & enough & (|back_number)) ? back_kept : sums",
        "sums",
    ),
    (
        "the bisection begins with the number of the batch before",
        "rounds",
        "(rounds_given[back] == 1) ? {RADIUS{1'b0}} : numbers[{back, back_position}]",
        "numbers[{back, back_position}]",
    ),
    (
        "only a batch that was not given fewer rounds than the one before it follows that",
        "rounds",
        "~is_last_round & is_behind[turn]",
        "~is_last_round & ~is_behind[turn]",
    ),
    (
        "a ladder has more rungs than there are registers",
        "rounds",
        "(rungs_asked > MOST_RUNGS) ? MOST_RUNGS : rungs_asked",
        "rungs_asked",
    ),
];

/// A core of banks so small, and so few chains, that all that the faults need comes within the clocks of a control.
fn of_small_banks(core: &Core) -> Core {
    let (chains, small) = CORES[0];
    let machine = match core.has_radii() {
        _ if drive::seldom(core) == 1 => return *core,
        true => "leaf-5-radii-local7-rgb6d-n64",
        false => small,
    };
    let machine = find_machine(machine).expect("a legal name is a machine");
    Core::new(machine, core.chains.min(chains)).expect("a core has so many chains")
}

/// Plants each fault in the text of the core, or of one like it of small banks, in a device.
///
/// # Errors
/// The device does not run.
pub fn core_controls(core: &Core, kind: DeviceKind, seed: u64) -> Result<Vec<Control>, CoreError> {
    let core = &of_small_banks(core);
    let emitted = emit_core(core).map_err(hdl_error(core.machine))?;
    let control = |(what, module, from, to): &CoreFault| {
        let mut faulty = emitted.clone();
        let module = match *module {
            TOP => emitted.top.clone(),
            below => format!("{}_{below}", emitted.top),
        };
        faulty.text = plant(&emitted.text, &module, from, to)?;
        let options = CoreOptions::new(CoreOptions::CLOCKS, seed);
        let found = match verify_core_text(core, &faulty, kind, &options, &|_| ()) {
            Err(CoreError::Diverged { .. }) => true,
            Ok(_) | Err(CoreError::Never(_)) => false,
            Err(other) => return Err(other),
        };
        Ok(Control {
            planted: format!("{}: {what}", core.name()),
            found,
        })
    };
    let of_several = FAULTS_OF_SEVERAL.iter().filter(|_| core.chains > 1);
    let of_rounds = FAULTS_OF_ROUNDS.iter().filter(|_| core.has_radii());
    let faults = FAULTS.iter().chain(of_several).chain(of_rounds);
    faults.map(control).collect()
}

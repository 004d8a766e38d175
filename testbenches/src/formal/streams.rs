//! The properties of the head of spatial machines: its queue of results, where it is short enough, and its admission of
//! queries and groups.

use photoncube_spec::{HeadSizes, Spatial, Widths};

use super::property::{Fault, Method, Open, Property, at, of_logic};

/// The most places of a queue of results in a proof. With 64 places a search has no answer in 120 seconds and
/// 18 GB.
const MOST_PLACES: usize = 32;

/// The most engines of a chain whose queue a search fills. With 64 engines that takes 390 clocks and seven minutes.
const MOST_ENGINES_FILLED: u32 = 8;

/// Whether the words of the queue of results can be registers of a netlist that a search compares. Those of a
/// photon memory cannot.
pub(super) fn has_short_memories(spatial: &Spatial) -> bool {
    HeadSizes::of(spatial).queue <= MOST_PLACES
}

/// All properties.
pub(super) fn properties(spatial: &Spatial, widths: &Widths) -> Vec<Property> {
    let sizes = HeadSizes::of(spatial);
    let engines = spatial.engines();
    let mut properties = Vec::new();
    if sizes.queue <= MOST_PLACES {
        properties.push(queue(widths, &sizes, engines));
    }
    properties.push(match (spatial.paced, sizes.has_waits()) {
        (true, _) => paced_admission(engines as u32),
        (false, true) => chain_admission(&sizes, engines as u32),
        (false, false) => admission(&sizes),
    });
    properties
}

fn queue(widths: &Widths, sizes: &HeadSizes, engines: usize) -> Property {
    let sum = widths.sum;
    let bits = 3 * sum + widths.count;
    let slice = |channel: u32| format!("[{}*{sum}+:{sum}]", channel);
    let count = format!("[{}+:{}]", 3 * sum, widths.count);
    let channels =
        [0, 1, 2].map(|channel| format!(".result_in_{channel}(data{}), ", slice(channel)));
    let names = ["red", "green", "blue"];
    let results = [0, 1, 2].map(|channel| {
        let name = names[channel as usize];
        format!(".result_{name}(result{}), ", slice(channel))
    });
    let place = |place| format!(", .\\results[{place}] (results[{place}*{bits}+:{bits}])");
    Property {
        macros: vec![
            ("BITS", bits.to_string()),
            ("PLACES", sizes.queue.to_string()),
            ("ENGINES", engines.to_string()),
            (
                "DATA_IN",
                channels.concat() + &format!(".result_count_in(data{count}), "),
            ),
            (
                "DATA_OUT",
                results.concat() + &format!(".result_count(result{count}), "),
            ),
            ("MEMORY", (0..sizes.queue).map(place).collect()),
        ],
        open: Open::Memory(
            &[
                "write_place",
                "newest_place",
                "read_place",
                "has_waiting",
                "has_result",
                "word",
            ],
            "results",
            sizes.queue,
        ),
        method: Method::Induction(1),
        faults: vec![
            Fault::new(
                "queue",
                "has_result & ~result_ready",
                "has_result & result_ready",
            ),
            Fault::new(
                "queue",
                "read_place <= read_place + ",
                "read_place <= read_place + 1'b1 + ",
            ),
            Fault::new(
                "queue",
                "has_waiting & ~reads_newest",
                "has_waiting & ~reads",
            ),
        ],
        fault_clocks: 7,
        covers: at([("cover_watched", 6), ("cover_full", sizes.queue as u32 + 3)]),
        ..of_logic(
            "streams::queue",
            "queue",
            "each result written is given once, in order, as it was, and stays while it is not taken; assumed: none is \
             written where the memory is full, as streams::admission shows",
            include_str!("harness/fifo.sv"),
            &[],
        )
    }
}

/// The admission of a chain that takes every group.
fn paced_admission(engines: u32) -> Property {
    Property {
        macros: vec![("ENGINES", engines.to_string())],
        open: Open::Signals(&["loaded", "open"]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new("admission", "~full | takes_first", "1'b1"),
            Fault::new("admission", "group_valid & ~open", "group_valid"),
            Fault::new("admission", "open <= ~group_last", "open <= 1'd1"),
        ],
        fault_clocks: 2 * engines + 6,
        covers: at([
            ("cover_full", engines + 4),
            ("cover_second", 3 * engines + 6),
        ]),
        ..of_logic(
            "streams::admission",
            "admission",
            "every group is taken, and a query where its batch has room or the batch before begins; assumed: a batch \
             begins only when all its queries were taken",
            include_str!("harness/admission_paced.sv"),
            &[],
        )
    }
}

/// The admission of one engine.
fn admission(sizes: &HeadSizes) -> Property {
    Property {
        macros: vec![("PLACES", sizes.queue.to_string())],
        open: Open::Signals(&["loaded", "open", "has_batch", "promised"]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new("admission", "wire room = ", "wire room = 1'b1 | "),
            Fault::new(
                "admission",
                "(~group_last | fits);\n    wire takes_group",
                "1'b1;\n    wire takes_group",
            ),
            Fault::new("admission", "~full | takes_first", "1'b1"),
        ],
        fault_clocks: sizes.queue as u32 + 4,
        covers: at([("cover_full", sizes.queue as u32 + 2), ("cover_second", 4)]),
        ..of_logic(
            "streams::admission",
            "admission",
            "a query is taken where there is room for it, a group only of a query that was, a last group only where \
             the queue has room for its result; assumed: no more results are read than were promised",
            include_str!("harness/admission.sv"),
            &[],
        )
    }
}

/// The admission of a chain of engines.
fn chain_admission(sizes: &HeadSizes, engines: u32) -> Property {
    // The fewest clocks from one batch to the next.
    let batch = sizes.spacing.max(engines);
    let mut faults = vec![
        Fault::new("admission", "fits = ~waits & room", "fits = room"),
        Fault::new("admission", "~full | takes_first", "1'b1"),
    ];
    let mut fault_clocks = 2 * engines + 6;
    let mut covers = at([("cover_second", 2 * batch + engines + 4)]);
    if engines <= MOST_ENGINES_FILLED {
        faults.push(Fault::new(
            "admission",
            "wire room = ",
            "wire room = 1'b1 | ",
        ));
        fault_clocks = batch * (sizes.promised_bits + 1) + 4;
        covers.extend(at([("cover_full", batch * sizes.promised_bits + 4)]));
    }
    Property {
        macros: vec![
            ("ENGINES", engines.to_string()),
            ("SPACING", sizes.spacing.to_string()),
            ("SPACING_BITS", sizes.spacing_bits.to_string()),
            ("MOST", sizes.promised_bits.to_string()),
        ],
        open: Open::Signals(&[
            "loaded",
            "open",
            "has_batch",
            "spacing",
            "waits",
            "gives_back",
            "promised",
        ]),
        method: Method::Induction(1),
        faults,
        fault_clocks,
        covers,
        ..of_logic(
            "streams::admission",
            "admission",
            "a query is taken where its batch has room, a group only of a batch whose queries were all taken, a last group \
             only where the queue has room for the results of its batch, and long enough after the one before; assumed: no \
             more batches are read than were promised",
            include_str!("harness/admission_chain.sv"),
            &[],
        )
    }
}

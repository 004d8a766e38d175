//! The rules of a machine's stream handshakes, one rule a line.

use super::ports::has_limits;
use crate::machine::Machine;
use crate::organisation::Organisation;

pub(super) fn protocol(machine: &Machine) -> Vec<String> {
    let mut rules = vec![
        "A word is taken at a rising edge with valid and ready. A query may change until it is taken; a group, once \
         valid, must stay as it is until it is taken."
            .to_owned(),
        order(machine),
        ready(machine).to_owned(),
        "Reset needs one clock. No ready pin looks at it, so what is taken in that clock is lost; what was under way \
         is forgotten."
            .to_owned(),
        limits(machine),
    ];
    if machine.keeps_sets() {
        rules.insert(2, sets(machine));
    }
    if machine.leaf().is_some() {
        rules.insert(3, leaves());
    }
    rules
}

fn order(machine: &Machine) -> String {
    if let Some(leaf) = machine.leaf() {
        return format!(
            "A batch is the queries up to one with query_last, at most {}; those after query_last begin the next. Each query gives \
             one result, with its query_tag, in the order of the queries: the sums over the photons of the set in range \
             whose facing the batch gathers.",
            leaf.chain.engines()
        );
    }
    match (machine.queries_at_once(), machine.has_memory()) {
        (1, _) => "A query, then its groups, of which the last has group_last, give one result; results come in the \
                   order of the queries. A query has at least one group, which may be empty of photons."
            .to_owned(),
        (engines, false) => format!(
            "A batch is {engines} queries and then groups that all of them meet, of which the last has group_last. It \
             gives {engines} results in the order of its queries. A batch of fewer queries waits for ever: fill it with \
             queries whose results are thrown away."
        ),
        (engines, true) => format!(
            "A batch is {engines} queries, which meet all groups of the set that is played; it gives {engines} results in \
             the order of its queries. A batch of fewer queries waits for ever: fill it with queries whose results are \
             thrown away."
        ),
    }
}

/// The rules that only machines have that keep sets.
fn sets(machine: &Machine) -> String {
    let groups = machine.bank_groups().unwrap_or(0);
    format!(
        "A set of groups, up to group_last, is read in once and played to batch after batch, until a batch with \
         query_release. Two sets fit: one is read in while the other is played. A set holds at most {groups} groups; group \
         {groups} ends it with or without group_last, and what follows begins the next set."
    )
}

/// The rules that only leaf machines have.
fn leaves() -> String {
    "A leaf is two groups of a set that follow each other, the first two and so on. All its photons have one facing, and their \
     order means nothing. A group is skipped where the box around its photons is out of range of the box around the batch's \
     queries, so photons of a group should be close together, and so should queries of a batch. A facing is any number: a leaf of \
     facing i is gathered by the batches with bit i of query_facings, and the machine does nothing else with it."
        .to_owned()
}

fn ready(machine: &Machine) -> &'static str {
    match (&machine.organisation, machine.has_memory()) {
        (Organisation::Spatial(_), false) => {
            "Ready pins: group_ready depends on group_last, and query_ready on group_valid and group_last, in the same clock \
             (a path through the machine from pin to pin); where group_valid is 0, group_ready means nothing."
        }
        (Organisation::Spatial(_), true) | (Organisation::Leaf(_), _) => {
            "Ready and valid pins are registers, or depend on registers alone."
        }
        _ => {
            "Ready pins depend on registers alone. A group is taken a clock after the machine began to read it, so \
             group_ready may rise only after group_valid."
        }
    }
}

fn limits(machine: &Machine) -> String {
    let beyond = match has_limits(machine) {
        true => ", or a word beyond its limit above",
        false => "",
    };
    format!(
        "No input is checked: with more than {} photons for a query{beyond}, results are undefined.",
        machine.max_photons()
    )
}

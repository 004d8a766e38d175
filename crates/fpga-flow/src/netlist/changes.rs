//! Lists the changes of a pass over a netlist, as questions whether each preserves the function.
//!
//! Two netlists are compared cell by cell. A cell that differs forms, together with the removed cells that
//! read it, a module that is compared with the changed cell. The inputs of both modules are the nets from
//! other cells, their outputs the nets that other cells read. If all such modules are equal and everything
//! else is unchanged, the netlists are equal. A pin that is no longer connected is an input named `open`, so
//! that the proof covers any value there.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use serde_json::Value;

use super::verilog::{instance, list};
use super::{Cells, Netlist, Readers, cells, connections, readers};
use crate::error::{Result, ensure, unexpected};

/// A change, with the number of places where it occurs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The type of the changed cell.
    pub kind: String,
    /// The number of places of the change.
    pub places: usize,
    /// One of these places: the name of a cell.
    pub place: String,
    /// The ports of the modules, as Verilog.
    ports: String,
    /// The cells before and after the change, and a wrong version.
    before: String,
    after: String,
    wrong: String,
}

impl Change {
    /// Three Verilog modules with this name prefix: `_before`, `_after`, and `_wrong`, which is not
    /// equivalent.
    pub fn modules(&self, name: &str) -> String {
        let all = [
            ("before", &self.before),
            ("after", &self.after),
            ("wrong", &self.wrong),
        ];
        let module = |(side, body): (&str, &String)| {
            format!(
                "module {name}_{side}({}endmodule\n",
                self.ports.clone() + body
            )
        };
        all.map(module).concat()
    }
}

/// The differences between the netlists, each once.
///
/// # Errors
/// The netlists differ in more than changed or removed cells: a cell is new, or other cells read a removed
/// one.
pub fn changes(before: &Netlist, after: &Netlist) -> Result<Vec<Change>> {
    let (before, after) = (before.top()?, after.top()?);
    ensure(before["ports"] == after["ports"], || {
        "the pass has changed the ports".to_owned()
    })?;
    let (old, new) = (cells(before)?, cells(after)?);
    if let Some(name) = new.keys().find(|name| !old.contains_key(*name)) {
        return Err(unexpected(format!("the pass has made a cell, {name}")));
    }
    let mut gone: BTreeSet<&str> = old.keys().map(String::as_str).collect();
    gone.retain(|name| !new.contains_key(*name));
    let readers = readers(before);
    let mut found: BTreeMap<(String, String, String, String), Change> = BTreeMap::new();
    for (name, cell) in new.iter().filter(|(name, cell)| old[*name] != **cell) {
        let taken = taken(&old[name], &readers, &mut gone);
        let read = |net: &u64| {
            let of_net = readers.get(net).into_iter().flatten();
            let mut others = of_net.filter(|(reader, _)| reader != name && !taken.contains(reader));
            others.next().is_some()
        };
        let change = change(old, name, &taken, cell, read)?;
        let key = (
            change.ports.clone(),
            change.before.clone(),
            change.after.clone(),
            change.wrong.clone(),
        );
        found
            .entry(key)
            .and_modify(|known| known.places += 1)
            .or_insert(change);
    }
    if let Some(name) = gone.first() {
        return Err(unexpected(format!(
            "the pass has removed {name}, which reads no cell that it has changed"
        )));
    }
    Ok(found.into_values().collect())
}

/// The removed cells that read this cell, by the port that they read.
fn taken(cell: &Value, readers: &Readers, gone: &mut BTreeSet<&str>) -> Vec<String> {
    let mut taken = Vec::new();
    for (_, _, bits) in connections(cell).filter(|(_, is_output, _)| *is_output) {
        let nets = bits.iter().filter_map(Value::as_u64);
        for (reader, _) in nets.filter_map(|net| readers.get(&net)).flatten() {
            if gone.remove(reader.as_str()) {
                taken.push(reader.clone());
            }
        }
    }
    taken
}

/// Numbers of nets in the order in which they are met, so that a change has equal numbers in all places.
#[derive(Default)]
struct Numbers {
    of_net: BTreeMap<u64, usize>,
}

impl Numbers {
    fn add(&mut self, nets: impl Iterator<Item = u64>) {
        for net in nets {
            let next = self.of_net.len();
            self.of_net.entry(net).or_insert(next);
        }
    }

    fn name(&self, net: u64) -> String {
        match self.of_net.get(&net) {
            Some(number) => format!("n{number}"),
            None => "open".to_owned(),
        }
    }
}

fn change(
    old: &Cells,
    name: &str,
    taken: &[String],
    new: &Value,
    is_read: impl Fn(&u64) -> bool,
) -> Result<Change> {
    let before: Vec<_> = std::iter::once(&old[name])
        .chain(taken.iter().map(|name| &old[name]))
        .collect();
    let mut numbers = Numbers::default();
    for cell in &before {
        numbers.add(nets(cell, None));
    }
    let driven: BTreeSet<_> = before
        .iter()
        .flat_map(|cell| nets(cell, Some(true)))
        .collect();
    let outputs: BTreeSet<_> = driven.iter().copied().filter(|net| is_read(net)).collect();
    let drives: BTreeSet<_> = nets(new, Some(true)).collect();
    let is_known = |net| numbers.of_net.contains_key(&net);
    let has_old_ends = drives.is_subset(&driven) && nets(new, Some(false)).all(is_known);
    ensure(has_old_ends, || {
        format!("the pass has connected {name} to what it was not connected to")
    })?;
    let inputs = numbers.of_net.keys().filter(|net| !driven.contains(net));
    let side = |nets: Vec<u64>| {
        let mut names: Vec<_> = nets.into_iter().map(|net| numbers.of_net[&net]).collect();
        names.sort_unstable();
        names
            .into_iter()
            .map(|number| format!("n{number}"))
            .collect::<Vec<_>>()
    };
    let (inputs, shown) = (
        side(inputs.copied().collect()),
        side(outputs.iter().copied().collect()),
    );
    let mut ports = vec!["input open".to_owned()];
    ports.extend(inputs.iter().map(|name| format!("input {name}")));
    ports.extend(shown.iter().map(|name| format!("output {name}_out")));
    let body = |cells: &[&Value], drives: &BTreeSet<u64>| -> Result<String> {
        let mut text = String::new();
        for net in &driven {
            let _ = writeln!(text, "  wire {};", numbers.name(*net));
        }
        for net in &outputs {
            let name = numbers.name(*net);
            let value = if drives.contains(net) {
                name.as_str()
            } else {
                "open"
            };
            let _ = writeln!(text, "  assign {name}_out = {value};");
        }
        for (index, cell) in cells.iter().enumerate() {
            let text_of = instance(&format!("cell_{index}"), cell, |net| numbers.name(net))?;
            text += &text_of.replace("(1'bx)", "(open)");
        }
        Ok(text)
    };
    Ok(Change {
        kind: new["type"].as_str().unwrap_or_default().to_owned(),
        places: 1,
        place: name.to_owned(),
        ports: list(&ports) + ");\n",
        before: body(&before, &driven)?,
        after: body(&[new], &drives)?,
        wrong: body(&[&wrong(&old[name], new)], &drives)?,
    })
}

/// The nets on a cell's pins: on all, on its outputs, or on its inputs.
fn nets(cell: &Value, outputs: Option<bool>) -> impl Iterator<Item = u64> {
    let wanted = connections(cell)
        .filter(move |(_, is_output, _)| outputs.is_none_or(|wanted| wanted == *is_output));
    wanted
        .flat_map(|(_, _, bits)| bits)
        .filter_map(Value::as_u64)
}

/// A wrong version of the changed cell: with its LUTs inverted, or with its former parameters where these
/// differ.
fn wrong(old: &Value, new: &Value) -> Value {
    let mut wrong = new.clone();
    if old["parameters"] != new["parameters"] {
        wrong["parameters"] = old["parameters"].clone();
        return wrong;
    }
    for (name, value) in wrong["parameters"].as_object_mut().into_iter().flatten() {
        if let (true, Some(bits)) = (name.starts_with("INIT"), value.as_str()) {
            let inverted = bits.chars().map(|bit| if bit == '0' { '1' } else { '0' });
            *value = inverted.collect::<String>().into();
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn carry(cin: Value, cout: Value) -> Value {
        json!({
            "type": "CCU2C",
            "parameters": { "INIT0": "0000000000000010", "INIT1": "0110000000000110", "INJECT1_0": "NO" },
            "port_directions": { "A0": "input", "CIN": "input", "COUT": "output", "S1": "output" },
            "connections": { "A0": [2], "CIN": [cin], "COUT": [cout], "S1": [9] },
        })
    }

    fn netlist(cells: &[(&str, Value)]) -> Netlist {
        let cells: serde_json::Map<_, _> = cells
            .iter()
            .map(|(name, cell)| ((*name).to_owned(), cell.clone()))
            .collect();
        Netlist::from(json!({ "modules": { "serial": {
            "attributes": { "top": "1" },
            "ports": { "out": { "direction": "output", "bits": [9] } },
            "cells": cells,
        } } }))
    }

    #[test]
    fn equal_changes_are_one_and_an_open_end_is_an_input() {
        let old = netlist(&[
            ("a", carry(json!("0"), json!(5))),
            ("b", carry(json!("0"), json!(6))),
        ]);
        let new = netlist(&[
            ("a", carry(json!("x"), json!("x"))),
            ("b", carry(json!("x"), json!("x"))),
        ]);
        let found = changes(&old, &new).unwrap();
        assert_eq!(found.len(), 1, "{found:#?}");
        assert_eq!((found[0].places, found[0].kind.as_str()), (2, "CCU2C"));
        let text = found[0].modules("change_0");
        for expected in [
            "module change_0_after(",
            ".CIN(open)",
            ".CIN(1'b0)",
            "input n0",
            "output n2_out",
        ] {
            assert!(text.contains(expected), "{expected}: {text}");
        }
        assert!(text.contains(".INIT0(16'b1111111111111101)"), "{text}");
        assert_eq!(changes(&old, &old).unwrap(), []);
    }

    #[test]
    fn an_end_that_is_read_is_still_asked_for() {
        let reader = json!({
            "type": "LUT4",
            "port_directions": { "A": "input", "Z": "output" },
            "connections": { "A": [5], "Z": [7] },
        });
        let cells = |cout| netlist(&[("a", carry(json!("0"), cout)), ("reader", reader.clone())]);
        let found = changes(&cells(json!(5)), &cells(json!("x"))).unwrap();
        let text = found[0].modules("change_0");
        assert!(text.contains("assign n1_out = open;"), "{text}");
    }

    #[test]
    fn what_is_more_than_a_changed_cell_is_refused() {
        let cell = |cin: u64| carry(json!(cin), json!(5));
        let one = netlist(&[("a", cell(3))]);
        let two = netlist(&[("a", cell(3)), ("b", cell(4))]);
        let error = |old: &Netlist, new: &Netlist| changes(old, new).unwrap_err().to_string();
        assert!(error(&one, &two).contains("has made a cell, b"));
        assert!(error(&two, &one).contains("has removed b"));
        assert!(error(&one, &netlist(&[("a", cell(8))])).contains("connected a to"));
    }
}

//! Counts the transitions of nets in a value change dump.

use std::collections::BTreeMap;
use std::io::{BufRead, Error, ErrorKind, Result};

use fpga_flow::asic::{Activities, Toggles};
use vcd::{Command, Header, IdCode, Parser, ScopeItem, Value};

/// A bit of a net.
#[derive(Clone, Debug)]
struct Bit {
    now: Value,
    /// The value at the end of the last clock cycle, and the cycle at whose end it first had it.
    settled: Value,
    since: u64,
    toggles: Toggles,
}

impl Bit {
    const NEW: Self = Self {
        now: Value::X,
        settled: Value::X,
        since: 0,
        toggles: Toggles {
            transitions: 0,
            ones: 0,
        },
    };

    /// Ends a time in which the value was the same at the end of each clock cycle.
    fn settle(&mut self, clock: u64) {
        if self.settled == Value::V1 {
            self.toggles.ones += clock - self.since;
        }
        self.since = clock;
        self.settled = self.now;
    }
}

/// The nets of a scope.
struct Nets {
    /// By the code of a net, its bits from the lowest. Nets of one code are one net.
    bits: Vec<Vec<Bit>>,
    index: BTreeMap<IdCode, usize>,
    names: Vec<(String, usize)>,
    clock: usize,
    clocks: u64,
    /// The nets that have changed in this cycle.
    changed: Vec<usize>,
}

/// Counts what the nets of the scope named `scope` did in the first `clocks` clock cycles of a dump. The end of a clock cycle is the time
/// before a rising edge of the net `clock`: all logic has settled then. A change that is undone before is not counted.
///
/// # Errors
/// The dump is no dump, lacks the scope or the clock, or has fewer cycles; or a net is neither 0 nor 1 at the end of a cycle.
pub(crate) fn activities(dump: impl BufRead, scope: &str, clocks: u64) -> Result<Activities> {
    let mut parser = Parser::new(dump);
    let header = parser.parse_header()?;
    let mut nets = Nets::of(&header, scope)?;
    let mut at_this_time = Vec::new();
    for command in parser {
        match command? {
            Command::Timestamp(_) => nets.pass(&mut at_this_time)?,
            Command::ChangeScalar(code, value) => at_this_time.push((code, vec![value])),
            Command::ChangeVector(code, values) => at_this_time.push((code, values.to_vec())),
            _ => {}
        }
        if nets.clocks == clocks {
            break;
        }
    }
    nets.pass(&mut at_this_time)?;
    match nets.clocks == clocks {
        true => Ok(nets.end()),
        false => Err(wrong(format!(
            "found {} clock cycles in the dump of nets, expected {clocks}",
            nets.clocks
        ))),
    }
}

fn wrong(message: String) -> Error {
    Error::new(ErrorKind::InvalidData, message)
}

impl Nets {
    fn of(header: &Header, scope: &str) -> Result<Self> {
        let items = items_of(&header.items, scope);
        let items =
            items.ok_or_else(|| wrong(format!("found no scope `{scope}` in the dump of nets")))?;
        let mut nets = Self {
            bits: Vec::new(),
            index: BTreeMap::new(),
            names: Vec::new(),
            clock: 0,
            clocks: 0,
            changed: Vec::new(),
        };
        for item in items {
            let ScopeItem::Var(var) = item else { continue };
            let index = *nets.index.entry(var.code).or_insert(nets.bits.len());
            if index == nets.bits.len() {
                nets.bits.push(vec![Bit::NEW; var.size as usize]);
            }
            nets.names.push((var.reference.clone(), index));
        }
        let clock = nets.names.iter().find(|(name, _)| name == "clock");
        let clock =
            clock.ok_or_else(|| wrong("found no net `clock` in the dump of nets".to_owned()))?;
        nets.clock = clock.1;
        Ok(nets)
    }

    /// Ends a time of the dump with these changes, each of a value's bits from the highest.
    fn pass(&mut self, changes: &mut Vec<(IdCode, Vec<Value>)>) -> Result<()> {
        let clock = self.bits[self.clock][0].now;
        let rises = |(code, values): &(IdCode, Vec<Value>)| {
            clock == Value::V0
                && self.index.get(code) == Some(&self.clock)
                && values[..] == [Value::V1]
        };
        if changes.iter().any(rises) {
            self.settle()?;
        }
        for (code, values) in changes.drain(..) {
            let Some(&index) = self.index.get(&code) else {
                continue;
            };
            // Leading zeros are left out, and so are repetitions of a leading x or z.
            let leading = match values.first() {
                Some(&unknown @ (Value::X | Value::Z)) => unknown,
                _ => Value::V0,
            };
            let values = values.into_iter().rev().chain(std::iter::repeat(leading));
            for (bit, value) in self.bits[index].iter_mut().zip(values) {
                bit.now = value;
            }
            self.changed.push(index);
        }
        Ok(())
    }

    fn settle(&mut self) -> Result<()> {
        for index in self.changed.drain(..) {
            for bit in &mut self.bits[index] {
                if !matches!(bit.now, Value::V0 | Value::V1) {
                    let name = self.names.iter().find(|(_, of)| *of == index);
                    let name = name.map_or("", |(name, _)| name);
                    return Err(wrong(format!(
                        "net {name} of the netlist is {} in clock {}, expected 0 or 1",
                        bit.now, self.clocks
                    )));
                }
                if bit.now != bit.settled {
                    bit.toggles.transitions += u64::from(self.clocks > 0);
                    bit.settle(self.clocks);
                }
            }
        }
        self.clocks += 1;
        Ok(())
    }

    fn end(mut self) -> Activities {
        for bit in self.bits.iter_mut().flatten() {
            bit.settle(self.clocks);
        }
        let toggles = |index: usize| self.bits[index].iter().map(|bit| bit.toggles).collect();
        let nets = self.names.iter();
        Activities {
            clocks: self.clocks,
            nets: nets
                .map(|(name, index)| (name.clone(), toggles(*index)))
                .collect(),
        }
    }
}

/// The items of the first scope of that name.
fn items_of<'a>(items: &'a [ScopeItem], name: &str) -> Option<&'a [ScopeItem]> {
    items.iter().find_map(|item| match item {
        ScopeItem::Scope(scope) if scope.identifier == name => Some(&scope.children[..]),
        ScopeItem::Scope(scope) => items_of(&scope.children, name),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four clock cycles. At their ends `a` is 0, 1, 1, 0 and `b` is 01, 01, 10, 10; `a` changes to and fro in the third.
    const DUMP: &str = "\
$scope module bench $end
$scope module dut $end
$var wire 1 ! clock $end
$var wire 1 \" a $end
$var wire 1 \" same $end
$var wire 2 # b [1:0] $end
$upscope $end
$var wire 1 % other $end
$upscope $end
$enddefinitions $end
#0
$dumpvars
x!
x\"
bx #
x%
$end
0\"
b1 #
0!
#1
1!
#2
0!
1\"
#3
1!
0\"
#4
0!
1\"
b10 #
#5
1!
#6
0!
0\"
#7
1!
1\"
";

    #[test]
    fn what_lasts_to_the_end_of_a_cycle_is_counted() {
        let half = activities(DUMP.as_bytes(), "dut", 2).unwrap();
        assert_eq!(half.nets["b"][0].ones, 2);
        let counted = activities(DUMP.as_bytes(), "dut", 4).unwrap();
        assert_eq!(counted.clocks, 4);
        let toggles = |transitions, ones| Toggles { transitions, ones };
        let expected = [
            ("clock", vec![toggles(0, 0)]),
            ("a", vec![toggles(2, 2)]),
            ("same", vec![toggles(2, 2)]),
            ("b", vec![toggles(1, 2), toggles(1, 2)]),
        ];
        assert_eq!(
            counted.nets,
            expected.map(|(name, bits)| (name.to_owned(), bits)).into()
        );
    }

    #[test]
    fn an_unknown_value_and_a_missing_scope_or_clock_are_told() {
        let error = |dump: &str| {
            activities(dump.as_bytes(), "dut", 4)
                .unwrap_err()
                .to_string()
        };
        let unknown = error(&DUMP.replace("0!\n1\"\n#3", "0!\nx\"\n#3"));
        assert!(
            unknown.contains("net a") && unknown.contains("in clock 1"),
            "{unknown}"
        );
        assert!(error(&DUMP.replace("dut", "top")).contains("no scope `dut`"));
        assert!(error(&DUMP.replace("clock", "clk")).contains("no net `clock`"));
        assert!(error(&DUMP[..DUMP.len() - 12]).contains("3 clock cycles"));
        assert!(activities("#x".as_bytes(), "dut", 4).is_err());
    }
}
